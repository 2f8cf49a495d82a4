"""Which coefficients of the half-swing vanish whatever the exponents: reversal of time, and dry friction.

delta_i = d_i e^(w_i x): a monomial delta^n is d^n e^(a x), a = sum n_i w_i, and x -> G(x) = x + L is the half-swing.
l counts the losses of a monomial, S changes their signs.  The weights may be irrational: monomials are told apart by d.

>>> derivation.steps[8].text()
'Subs(gamma/a, a, -gamma) = -1'
"""

import sympy

from derivations.steps import At, Coefficient, Derivation, Solution, Taylor, defined

x, y, eta = sympy.symbols("x y eta")
gamma, a, A = sympy.symbols("gamma a A", nonzero=True)
e0, d0, k, l_1, D = sympy.symbols("epsilon_0 delta_0 k l_1 D", positive=True)
c, f, t, delta = sympy.symbols("c f t delta")
loss = sympy.Symbol("l", integer=True)
L = sympy.Function("L")

derivation = Derivation(
    "zeros-by-theorem",
    "Coefficients of the half-swing that vanish for all exponents",
    source="asymptotics.expansions.half_swings.certified_zeros",
)
step = derivation.step

# Lagrange's inversion, and the constant term under a substitution.
n = sympy.Symbol("n", integer=True, positive=True)
size, slope = sympy.Symbol("eta"), sympy.Symbol("L'", real=True)
step(
    "Lagrange, L of size eta: y = G^(-1)(x), y + eta L(y) = x, has dy/dx = 1/(1 + eta L'(y)) and dy/d eta = -L(y)"
    " dy/dx, so that x does not change with eta:",
    At(f + size * slope * f + c, {f: -c / (1 + size * slope)}),
    sympy.Integer(0),
)
ell, u_x = sympy.Function("l")(x), sympy.Function("u")(x)  # L(y) and any function of y, at given eta
step(
    "Every function u of y has u_eta = -l u_x, l = L(y). So (d/d eta)(l^n u_x) = -(d/dx)(l^(n+1) u_x): by induction the"
    " n-th derivative of u by eta is (-d/dx)^n of l^n u_x, but for one d/dx. At eta = 0, for u = y:"
    " G^(-1)(x) = x + sum_k (-1)^k/k! (d/dx)^(k-1) L^k",
    -ell * sympy.diff(ell**n, x) * sympy.diff(u_x, x) + ell**n * sympy.diff(-ell * sympy.diff(u_x, x), x),
    -sympy.Derivative(ell ** (n + 1) * sympy.diff(u_x, x), x),
)
H, G_y, h_0 = sympy.Function("H"), sympy.Function("G")(y), sympy.Symbol("h_0")
inner = sympy.Symbol("x_1")
step(
    "The constant term of h(G(y)) G'(y) is that of h: h = h_0 + H' with a sum H of exponentials, and besides h_0 G',"
    " G' = 1 + L', only a derivative is left, which has no constant term:",
    sympy.Derivative(H(G_y), y),
    sympy.Subs(sympy.Derivative(H(inner), inner), inner, G_y) * sympy.Derivative(G_y, y),
)

# Reversal: G^(-1)(x) = x + L(S delta).
step(
    "Reversal (derivation reversal-identity): G^(-1)(x) = x + L(S delta).  Without losses S = 1 and G(G(x)) = x; at"
    " the lowest order of L that is 2 L = 0: L has no monomial with l = 0",
    Coefficient(eta * c + eta * c, eta, 1),
    2 * c,
)
step(
    "At a = 0 only k = 1 is left of Lagrange's sum, as e^(a x) has no derivative: (-1)^l c = -c",
    sympy.Derivative(At(sympy.exp(a * x), {a: 0}), x),
    sympy.Integer(0),
)
j = sympy.Symbol("j", integer=True, nonnegative=True)
step("so c = 0 for even l: then (-1)^l c + c is", At((-1) ** loss * c + c, {loss: 2 * j}), 2 * c)
step("and for odd l nothing follows", At((-1) ** loss * c + c, {loss: 2 * j + 1}), sympy.Integer(0))
G = sympy.Function("G")(y)
step(
    "The coefficient of weight a in e^(gamma G^(-1)) is the constant term of e^(gamma y - a G(y)) G'(y), x = G(y);"
    " by parts, up to the derivative of e^(gamma y - a G),",
    sympy.exp(gamma * y - a * G) * sympy.Derivative(G, y),
    gamma / a * sympy.exp(gamma * y - a * G) - sympy.Derivative(sympy.exp(gamma * y - a * G), y) / a,
)
step(
    "that is gamma/a times the coefficient of weight -gamma in e^(-a G); at a = -gamma: minus that of e^(gamma G)",
    At(gamma / a, {a: -gamma}),
    sympy.Integer(-1),
)
step(
    "F_i(delta) = d_i e^(w_i G), s_i F_i(S delta) = d_i e^(w_i G^(-1)): with gamma = w_i the monomial at a = -w_i has"
    " (-1)^(l - l_i) f = -f, so f = 0 when l - l_i is even",
    At((-1) ** loss * f + f, {loss: 2 * j}),
    2 * f,
)

# Durations.
T_q = defined("T_q", lambda z: t * z)
step("T = T_q(delta) + T_q(S F), F = delta + ...: a single loss has", T_q(delta) + T_q(-delta), sympy.Integer(0))
step("a single spring, which S leaves alone, has", 2 * T_q(delta), 2 * t * delta)
step(
    "Where all weights are 0, F = delta and the coefficient of T is (1 + (-1)^l) times that of T_q; odd l",
    At(1 + (-1) ** loss, {loss: 2 * j + 1}),
    sympy.Integer(0),
)

# Dry friction beside losses v|v|^(alpha-1).
X = sympy.Function("X")(x)
step(
    "Dry friction is the constant -eps_0 while X' < 0: X'' + X - eps_0 is Y'' + Y for Y = X - eps_0",
    sympy.Derivative(X - e0, x, x) + X - e0,
    sympy.Derivative(X, x, x) + X - e0,
)
turn = (A - e0) * c - e0
step(
    "Y turns at -(A - eps_0) c, c = e^(L*), so X turns at -A e^L with A e^L = (A - eps_0) c - eps_0; over A",
    At(turn / A, {e0: d0 * A}),
    (1 - d0) * c - d0,
)
step(
    "the others have eps_i (A - eps_0)^w_i = delta_i (1 - delta_0)^w_i, the ratio of the amplitudes being",
    At((A - e0) / A, {e0: d0 * A}),
    1 - d0,
)
step(
    "For integer powers the binomial ends: (1 - delta_0)^2 has no delta_0^3",
    Coefficient((1 - d0) ** 2, d0, 3),
    sympy.Integer(0),
)
step(
    "For -1 it does not",
    Coefficient(Taylor(1 / (1 - d0), d0, 3), d0, 3),
    sympy.Integer(1),
)
u = sympy.Symbol("u")
step(
    "Along the straight orbit a - (2/pi) eps_0 psi, D = eps_0 d/da: the mean of e^(-2 D psi/pi)",
    sympy.Integral(sympy.exp(-2 * D * u), (u, 0, 1)),
    (1 - sympy.exp(-2 * D)) / (2 * D),
)
step(
    "and T_2 = e^(-D) a^w T_2(0): so W_2 = (T_2/pi) (D/sinh D) a^w",
    sympy.exp(-D) / sympy.Integral(sympy.exp(-2 * D * u), (u, 0, 1)),
    (D / sympy.sinh(D)).rewrite(sympy.exp),
)
step(
    "D/sinh D is even in D: of a^3 it leaves a^3 and a, of a^w with an integer w >= 0 no power below 0; D^2 has",
    Coefficient(Taylor(D / sympy.sinh(D), D, 3), D, 2),
    -sympy.Rational(1, 6),
)
first = sympy.Function("a_1")(y)
step(
    "Dry and cubic friction, W_2' = k g_1 (2 alpha - 3 = alpha): k int a_1 a_1' over the half-swing is (k/2) a_1(pi)^2",
    k * first * sympy.Derivative(first, y),
    sympy.Derivative(k * first**2 / 2, y),
)
end = sympy.Symbol("a_1(pi)")
step(
    "a_1(pi) = l_1 (a - eps_0)^3, and T_3 is proportional to (a - eps_0)^6; at eps_0 = 0, where W_3 = 0, both agree:"
    " the mean of W_3 over each straight orbit vanishes, and with it W_3",
    At(k * end**2 / 2, {end: l_1 * (A - e0) ** 3}),
    k * l_1**2 * (A - e0) ** 6 / 2,
)

# Half-swings known in closed form; the engine's, with springs and pendulums, and near misses are in a test.
TEST = "tests/derivations/test_zeros_by_theorem.py"
g, d, z = sympy.symbols("g d z", positive=True)
size, epsilon = sympy.Symbol("L", real=True), sympy.Symbol("epsilon", positive=True)
ratio = sympy.Symbol("r", positive=True)
energy = (1 - ratio**2) / 2 + g * (1 - ratio**3) / 3 - d * (1 + ratio)
growth = 1 - 2 * d + 2 * d * g - 2 * d**2 * g - 2 * d * g**2
growth += sympy.Rational(2, 3) * d**3 * g + 6 * d**2 * g**2 + 2 * d * g**3
step(
    "Dry friction and x|x|, of weights -1 and 1, d and g at the amplitude A: the energy over A^2, from A to -A r,"
    " vanishes through the fourth order for r = e^L as here",
    Taylor(At(At(energy, {ratio: growth}), {g: z * g, d: z * d}), z, 4),
    sympy.Integer(0),
)
rest = At(growth - 1, {g: z * g, d: z * d})
third = sympy.Rational(1, 3)
step(
    "and L = ln r, the series of the logarithm, has no d^0 g^n and no d^2 g^2, a = 0 and l = 2; a near miss of the"
    " theorem with the parity of the degree in the place of l is d g, which is there",
    At(Taylor(rest - rest**2 / 2 + third * rest**3 - rest**4 / 4, z, 4), {z: 1}),
    -2 * d
    - 2 * d**2
    + 2 * d * g
    - 8 * third * d**3
    + 2 * d**2 * g
    - 2 * d * g**2
    - 4 * d**4
    + 14 * third * d**3 * g
    + 2 * d * g**3,
)
nu = sympy.sqrt(1 - epsilon**2 / 4)
linear = sympy.exp(-epsilon * t / 2) * (sympy.cos(nu * t) + epsilon / (2 * nu) * sympy.sin(nu * t))
step(
    "x'' + epsilon x' + x = 0 from x = 1, x' = 0: with nu^2 = 1 - epsilon^2/4",
    sympy.Derivative(linear, t, t) + epsilon * sympy.Derivative(linear, t) + linear,
    sympy.Integer(0),
)
step(
    "Linear loss, of weight 0: the motion turns after pi/nu, as x' has the factor sin(nu t), and L ="
    " ln(-x) is odd in epsilon, l = 1, 3, ...",
    Taylor(sympy.log(-At(linear, {t: sympy.pi / nu})), epsilon, 4),
    -sympy.pi * epsilon / 2 - sympy.pi * epsilon**3 / 16,
)
step(
    "|x| sgn x', of weight 0: the square of the speed at the passage is (1 - epsilon) A^2 and (1 + epsilon)"
    " A^2 e^(2 L); L is odd",
    Taylor(Solution((1 + epsilon) * sympy.exp(2 * size), 1 - epsilon, size), epsilon, 4),
    -epsilon - epsilon**3 / 3,
)
step(
    "and T, two quarter periods, is even.  The engine's exact half-swings with two and three laws are compared with the"
    f" theorem in {TEST}",
    Taylor((1 / sympy.sqrt(1 - epsilon) + 1 / sympy.sqrt(1 + epsilon)) * sympy.pi / 2, epsilon, 3),
    sympy.pi + 3 * sympy.pi * epsilon**2 / 8,
)
