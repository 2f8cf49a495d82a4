"""Multiple scales for a loss X'|X'|^(alpha-1), alpha >= 0, beside a spring X|X|^(p-1), to second order, in closed form.

The spring turns the phase at first order and changes the decrement at second: the cross term is a sum over products of
harmonics, and it telescopes.

>>> p_11.subs({alpha: 1, p: 3})                       # Duffing with linear loss
-3/16
"""

import sympy
from sympy import cos, gamma, pi, sin, sqrt

from derivations.steps import At, Derivation, Solution

alpha, p, r = sympy.symbols("alpha p r", positive=True)
n = sympy.Symbol("n", positive=True)
a = sympy.Symbol("a", positive=True)
psi, eps, c = sympy.symbols("psi epsilon c", real=True)
B, D, C, P, Q, N, M, S, X = sympy.symbols("b_n d_n c_n P Q N M S X", real=True)
f_2, g_2 = sympy.symbols("f_2 g_2", real=True)
R = sympy.Rational

derivation = Derivation(
    "multiple-scales-springs",
    "Multiple scales for any exponent beside a spring, to second order",
    source="asymptotics.expansions.multiple_scales.powers; not in the papers",
)
step, asserts = derivation.step, derivation.asserts


def moment(x: sympy.Expr) -> sympy.Expr:
    """M_x = <|sin|^x>."""
    return gamma((x + 1) / 2) / (sqrt(pi) * gamma(x / 2 + 1))


def mean(x: sympy.Expr, y: sympy.Expr) -> sympy.Expr:
    """<|cos|^x |sin|^y>."""
    return gamma((x + 1) / 2) * gamma((y + 1) / 2) / (pi * gamma((x + y) / 2 + 1))


# |sin|^alpha sgn sin = sum b_n sin n psi, |cos|^p sgn cos = sum d_n cos n psi: d_n = (-1)^((n-1)/2) b_n of p.
j = sympy.Symbol("j", integer=True)
fall, turn = (n - alpha) / (n + alpha + 2), -(n - p) / (n + p + 2)
step(
    "A quarter turn, sin n(psi + pi/2) = (-1)^j cos n psi for n = 2 j + 1: d_n is b_n of p with alternating sign",
    At(sin(B + j * pi + pi / 2), {B: (2 * j + 1) * psi}),
    (-1) ** j * cos((2 * j + 1) * psi),
)

# Order 1.
f_1, g_1 = -eps * P * a**alpha, c * Q * a ** (p - 1)
step(
    "Order 1, sin psi: 2 D_1 a + 2 eps P a^alpha = 0, P = M_(alpha+1)",
    Solution(2 * f_2 + 2 * eps * P * a**alpha, 0, f_2),
    f_1,
)
step(
    "cos psi: 2 a D_1 psi = c a^p d_1, d_1 = 2 Q, Q = M_(p+1): the phase turns at first order",
    Solution(2 * a * g_2, c * a**p * 2 * Q, g_2),
    g_1,
)
wave = c * a**p * D / (n**2 - 1) * cos(n * psi)
step("Each harmonic n >= 3 of X_1 from the spring", sympy.Derivative(wave, psi, 2) + wave, -c * a**p * D * cos(n * psi))

# Order 2, the projections.
step(
    "D_1 D_1 X_0, D_1 = f_1 d/da + g_1 d/dpsi: the coefficient of sin psi is -f_1 (a g_1)' - g_1 f_1",
    f_1 * sympy.Derivative(-a * g_1 * sin(psi), a) + g_1 * sympy.Derivative(f_1 * cos(psi), psi),
    sympy.powsimp(eps * P * c * Q * a ** (alpha + p - 1) * (p + 1) * sin(psi)),
)
V = sympy.Symbol("V", positive=True)
step(
    "S(V) = V|V|^(alpha-1) is homogeneous, V S' = alpha S: with V_0 = -a sin psi, 2 <S'(V_0) sin psi sin n psi> ="
    " alpha b_n a^(alpha-1), at alpha = 0 too",
    V * sympy.Derivative(V**alpha, V),
    alpha * V**alpha,
)
F = sympy.Function("R")
step(
    "The spring R(X) = X|X|^(p-1) at X_0 = a cos psi: a sin psi R'(X_0) = -dR(X_0)/dpsi, so"
    " 2 <R'(X_0) sin psi sin n psi> = n d_n a^(p-1)",
    -sympy.Derivative(F(a * cos(psi)), psi),
    a * sin(psi) * sympy.Subs(sympy.diff(F(X), X), X, a * cos(psi)),
)
S_n, R_n = sympy.symbols("S_n R_n", real=True)
v_n, x_n = -c * a**p * n * D / (n**2 - 1), -eps * a**alpha * B / (n**2 - 1)
step(
    "sin psi in -S'(V_0) V_1 - R'(X_0) X_1, harmonic n >= 3: V_1 has -c a^p n d_n/(n^2-1) sin n psi, X_1 of the loss"
    " -eps a^alpha b_n/(n^2-1) sin n psi; S_n, R_n: the two projections above, with their strengths",
    At(-S_n * v_n - R_n * x_n, {S_n: eps * alpha * B * a ** (alpha - 1), R_n: c * n * D * a ** (p - 1)}),
    (alpha + 1) * eps * c * a ** (alpha + p - 1) * n * B * D / (n**2 - 1),
)
unit = eps * c * a ** (alpha + p - 1)
condition = 2 * f_2 - (p + 1) * P * Q * unit + 2 * alpha * P * Q * unit + (alpha + 1) * S * unit
p_open = sympy.expand(sympy.solve(condition, f_2)[0] / -unit)
step(
    "With V_1 = ... - a g_1 sin psi, b_1 = 2 P and S = sum_(n>=3) n b_n d_n/(n^2-1): D_2 a = -eps c a^(alpha+p-1) p_11,"
    " p_11 =",
    Solution(condition, 0, f_2) / -unit,
    P * Q * (alpha - (p + 1) / 2) + (alpha + 1) * S / 2,
)

# The sum.
certificate = -(n + alpha) * (n + p) / (2 * (alpha + 1) * (p + 1) * (n - 1))
step(
    "n b_n d_n [1/(n^2-1) + 1/((alpha+1)(p+1))] = F(n+2) - F(n), F = certificate b_n d_n: divided by b_n d_n",
    n / (n**2 - 1) + n / ((alpha + 1) * (p + 1)),
    fall * turn * At(certificate, {n: n + 2}) - certificate,
)
lower = At(certificate, {n: 3}) * At(fall, {n: 1}) * At(turn, {n: 1}) * 4 * P * Q
step(
    "F vanishes at infinity; at the lower end, from b_1 d_1 = 4 P Q, F(3) is",
    lower,
    (1 - alpha) * (1 - p) * P * Q / ((alpha + 1) * (p + 1)),
)
step(
    "sum_(n>=1) n b_n d_n = -2 <|sin|^alpha sgn(sin) d(|cos|^p sgn(cos))/dpsi> by Parseval is 2 p N,"
    " N = <|cos|^(p-1) |sin|^(alpha+1)>: on the first quarter",
    -2 * sin(psi) ** alpha * sympy.Derivative(cos(psi) ** p, psi),
    2 * p * cos(psi) ** (p - 1) * sin(psi) ** (alpha + 1),
)
lowest = (1 - alpha) * (1 - p) * P * Q / ((alpha + 1) * (p + 1))
total = -lowest - (2 * p * N - 4 * P * Q) / ((alpha + 1) * (p + 1))
whole, first = sympy.symbols("Sigma F_3", real=True)
summed = At(-first - (whole - 4 * P * Q) / ((alpha + 1) * (p + 1)), {first: lowest, whole: 2 * p * N})
step(
    "so, with that F(3) and that sum Sigma, S =",
    summed,
    ((4 - (1 - alpha) * (1 - p)) * P * Q - 2 * p * N) / ((alpha + 1) * (p + 1)),
)
closed = (alpha * (p + 3) - (p - 1) * (p + 2)) / (2 * (p + 1)) * P * Q - p * N / (p + 1)
step("and p_11 =", At(p_open, {S: total}), closed)
p_11 = closed.subs({P: moment(alpha + 1), Q: moment(p + 1), N: mean(p - 1, alpha + 1)})

# Two springs.
step(
    "cos psi: -D_1 D_1 X_0 gives a g_1^2 and 2 <R'(X_0) cos psi cos n psi> = p d_n a^(p-1) (X R' = p R): Duffing,"
    " Q = 3/8, d_3 = 1/4, -Q^2/2 + (p/2) d_3^2/(3^2-1)",
    At(-(Q**2) / 2 + p * D**2 / (2 * (n**2 - 1)), {Q: R(3, 8), p: 3, n: 3, D: R(1, 4)}),
    -R(15, 256),
)
weight = (p + r + 1) / ((p + 1) * (r + 1))
other = -(n + p) * (n + r) / (2 * (p + 1) * (r + 1) * (n - 1))
step(
    "For two powers p, r: d_n c_n/(n^2-1) telescopes as b_n c_n does (signs cancel); divided by it",
    1 / (n**2 - 1) + weight,
    (n - p) * (n - r) / ((n + p + 2) * (n + r + 2)) * At(other, {n: n + 2}) - other,
)

# The turning points.
single = (n + p) / (-2 * (p + 1) * (n - 1))
step(
    "X_1 of the spring at psi = 0: d_n [1/(n^2-1) + 1/(p+1)] telescopes with -(n+p)/(2 (p+1)(1-n)) d_n",
    1 / (n**2 - 1) + 1 / (p + 1),
    turn * At(single, {n: n + 2}) - single,
)
lam = (p - 1) * Q / (2 * (p + 1)) - (1 - 2 * Q) / (p + 1)
step(
    "with Sigma = sum_(n>=3) d_n = 1 - 2 Q, the value at psi = 0: a turning amplitude is A = a (1 + lambda gamma),"
    " lambda =",
    At((p - 1) * Q / (2 * (p + 1)) - whole / (p + 1), {whole: 1 - 2 * Q}),
    ((p + 3) * Q - 2) / (2 * (p + 1)),
)
gauged = sympy.Symbol("p_11", real=True)
observed = closed + P * (p - alpha) * lam
step(
    "d ln A = d ln a + (p-1) lambda gamma d ln a, and rho = eps a^(alpha-1) at A: p_11 in the turning-point gauge gains"
    " P (p - alpha) lambda; there -U/W = p, so U_11 = P Q - p_11 =",
    At(P * Q - gauged, {gauged: observed}),
    (p - alpha) / (p + 1) * P + p / (p + 1) * N,
)
U_11 = ((p - alpha) * moment(alpha + 1) + p * mean(p - 1, alpha + 1)) / (p + 1)
step("alpha = 2, p = 3", At(U_11, {alpha: 2, p: 3}), 8 / (15 * pi))
wrong = ((p - 1) * moment(alpha + 1) + p * mean(p - 1, alpha + 1)) / (p + 1)
asserts(
    "Near miss: (p - 1) for (p - alpha) is right at alpha = 1 alone",
    sympy.Ne(At(U_11, {alpha: 2, p: 3}), At(wrong, {alpha: 2, p: 3}), evaluate=False),
    sympy.Eq(At(U_11, {alpha: 1, p: 3}), At(wrong, {alpha: 1, p: 3}), evaluate=False),
)
