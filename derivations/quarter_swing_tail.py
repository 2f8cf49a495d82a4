"""The half-swing from the truncated series of the quarter-swing: a majorant, a monotone equation, errors that add.

>>> print(derivation.steps[4].text())
Derivative(x/(-k*x + 1), x) = (-k*x + 1)**(-2)
"""

import sympy

from derivations.steps import At, Derivation, defined

x, k = sympy.symbols("x k", real=True)
n = sympy.Symbol("n", integer=True, nonnegative=True)
X, K = sympy.symbols("X K", positive=True)
theta, alpha, lam, y, z, w = sympy.symbols("theta alpha lambda y z w", positive=True)
g = sympy.Function("g")(theta)
L = sympy.Symbol("L", real=True)

derivation = Derivation(
    "quarter-swing-tail",
    "A half-swing at finite strength from the truncated series of the quarter-swing, with proved errors",
    source="expansions.half_swings.finite_majorant; the equations are those of half-swing-equations",
)
step, asserts = derivation.step, derivation.asserts

# 1. The majorant.
j, lack = sympy.Symbol("j", integer=True), sympy.Symbol("d", complex=True, zero=False)
delta = sympy.Symbol("delta")
step(
    "One law: u = delta e^((alpha-1) g), g = ln r; with g' = -u s^(alpha+1)/(1 - u s^alpha c) (half-swing-equations)",
    sympy.Derivative(delta * sympy.exp((alpha - 1) * g), theta),
    (alpha - 1) * delta * sympy.exp((alpha - 1) * g) * sympy.Derivative(g, theta),
)
step(
    "For |k| < 1, k = 1 - d, the quotient x/(1-k) is the sum of x k^n: n terms lack x k^n/(1-k), which tends to 0, and",
    At(sympy.Sum(x * k**j, (j, 0, n - 1)), {k: 1 - lack}),
    At(x / (1 - k) - x * k**n / (1 - k), {k: 1 - lack}),
)
step(
    "so is X/(1-K) of X K^n, all terms >= 0. A term of the first is at most this one in modulus, for complex |x| <= X,"
    " |k| <= K < 1: its share of it is, with |x| = X y, |k| = K z, y, z in [0, 1],",
    At(sympy.Abs(x) * sympy.Abs(k) ** n / (X * K**n), {sympy.Abs(x): X * y, sympy.Abs(k): K * z}),
    y * z**n,
)
asserts(
    "Hence |x/(1-k)| <= X/(1-K): |g|' <= N*/(1-C*), and |g| <= G as long as C* < 1: the right-hand side grows with G"
    " and is smooth there (comparison of scalar equations)",
    sympy.Gt(At(sympy.Derivative(X / (1 - K), K), {K: 1 - y}), 0, evaluate=False),
)

# 2. The root equation.
step(
    "R falls in each delta_i: g' depends on N = sum u_i s^alpha_i through -s N/(1-cN), and",
    sympy.Derivative(x / (1 - k * x), x),
    1 / (1 - k * x) ** 2,
)
R = sympy.Function("R")
weight, slope = sympy.symbols("a R'", real=True)
F = delta * sympy.exp(weight * L)
step(
    "G(L) = L - R(delta) + R(-F(L)), F = delta e^(a L), a = alpha - 1, has the derivative (R' taken at -F)",
    1 + sympy.Derivative(-F, L) * slope,
    1 - weight * F * slope,
)
a_plus, F_plus, fall = sympy.symbols("a_+ F_+ D", nonnegative=True)
asserts(
    "a >= 0, F >= 0 and R' = -D <= 0: G' = 1 + a F D >= 1. So |L - L_hat| <= |G(L_hat)| for every number L_hat",
    sympy.Ge(1 + a_plus * F_plus * fall, 1, evaluate=False),
)
rate, place = sympy.Function("f_g"), sympy.Symbol("t", real=True)  # d(g')/dg along the orbit
growth = sympy.exp(sympy.Integral(rate(place), (place, 0, theta)))
step(
    "Any alpha: L + R(-F(L)) is ln r at the passage of the orbit of -epsilon that starts at ln r = L. Its derivative D"
    " by L obeys D' = f_g D, f_g being dg'/dg along the orbit, and D = 1 at the start:",
    sympy.Derivative(growth, theta) / growth,
    rate(theta),
)
exponent = sympy.Symbol("I", real=True)
asserts(
    "D is the exponential of a real number, so G increases: it has one root, enclosed by a change of sign",
    sympy.Gt(sympy.exp(exponent), 0, evaluate=False),
)

# 3. Errors along the orbit.
energy = sympy.Symbol("E", positive=True)
asserts(
    "Energy E = w^2/2 against -y: dE/d(-y) = y - N(w). N grows with w, so the right-hand side falls with E:"
    " one motion forwards, and a larger N gives a smaller E",
    sympy.Lt(sympy.Derivative(y - sympy.sqrt(2 * energy) ** alpha, energy), 0, evaluate=False),
)
step(
    "L1b. Scale a motion that starts at lambda p, lambda >= 1, by 1/lambda: it obeys the same equation with N~(w) =",
    defined("N", lambda w: w**alpha)(lam * w) / lam,
    lam ** (alpha - 1) * w**alpha,
)
excess = sympy.Symbol("m", nonnegative=True)
asserts(
    "For alpha = 1 + m >= 1, lambda = 1 + y, this is N(w) times e^(m ln(1 + y)), at least N(w): E~ <= E, the scaled"
    " motion ends no later: q~/lambda <= q."
    " With q~ >= q (orbits do not meet) 0 <= d ln q/d ln p <= 1: relative errors only add",
    sympy.Ge(excess * sympy.log(1 + y), 0, evaluate=False),
)
v1, v2, x1, x2 = sympy.symbols("v_1 v_2 x_1 x_2", real=True)
force, elapsed = sympy.Function("N"), sympy.Symbol("tau", real=True)
apart, faster = sympy.Function("Delta_x")(elapsed), sympy.Function("Delta_v")(elapsed)
change = {sympy.Derivative(apart, elapsed): v1 - v2, apart: x1 - x2, faster: v1 - v2}
change |= {sympy.Derivative(faster, elapsed): -(x1 - x2) - (force(v1) - force(v2))}
step(
    "L0. Any alpha >= 0: d/dt of (Delta x^2 + Delta v^2)/2 is <= 0, N being nondecreasing; so |Delta q| <= |Delta p|",
    At(sympy.Derivative((apart**2 + faster**2) / 2, elapsed), change),
    -(v1 - v2) * (force(v1) - force(v2)),
)
top, odds = sympy.symbols("M y", positive=True)
ratio = odds / (1 + odds)  # |delta|/rho < 1
order = sympy.Symbol("J", positive=True, integer=True)
step(
    "Cauchy beyond the last order J, at x = |delta|/rho < 1: the sum of M x^n over n > J",
    sympy.Sum(top * ratio ** (order + n), (n, 1, sympy.oo)),
    top * ratio ** (order + 1) / (1 - ratio),
)
