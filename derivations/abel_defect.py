"""The defect of a truncated Abel function, summed along an orbit that is never computed.

>>> print(derivation.steps[3].text())
Derivative((g*x + 1/delta)**(-m), (x, 2)) = g**2*m*(m + 1)*(g*x + 1/delta)**(-m - 2)
"""

import sympy

from derivations.steps import At, Coefficient, Derivation, Taylor

theta, alpha, delta, rho, D, gain, m, x = sympy.symbols("theta alpha delta rho D g m x", positive=True)
k, u1, u2 = sympy.symbols("k u_1 u_2", positive=True)
u = sympy.Function("u")(theta)
s, c = sympy.sin(theta), sympy.cos(theta)

derivation = Derivation(
    "abel-defect",
    "The n-th turning point without iterating: the defect of a truncated Abel function",
    source="turning.abel; alpha > 1, delta = epsilon A^(alpha-1); the majorant is that of quarter-swing-tail",
)
step, asserts = derivation.step, derivation.asserts

slope = -(alpha - 1) * u**2 * s ** (alpha + 1) / (1 - u * s**alpha * c)
step(
    "Along a half-swing u = epsilon r^(alpha-1) obeys u' = -(alpha-1) u^2 s^(alpha+1)/(1 - u s^alpha c): 1/u grows, and"
    " 1/F - 1/delta is the integral of this over 0 <= theta <= pi",
    At(sympy.Derivative(1 / u, theta), {sympy.Derivative(u, theta): slope}),
    (alpha - 1) * s ** (alpha + 1) / (1 - u * s**alpha * c),
)
falling = sympy.Symbol("u", positive=True)
step(
    "Pair theta with pi - theta, k = s^alpha cos(theta) >= 0: u falls, u_2 <= u_1, and",
    At(1 / (1 - k * falling), {falling: u1}) + At(1 / (1 - k * falling), {falling: u2, k: -k}) - 2,
    (k * (u1 - u2) + 2 * k**2 * u1 * u2) / ((1 - k * u1) * (1 + k * u2)),
)
gap = sympy.Symbol("d", nonnegative=True)
asserts(
    "the numerator, with u_1 = u_2 + d, is not negative, so each pair gives 2 at least: 1/F >= 1/delta + g, g ="
    " (alpha-1) int_0^pi s^(alpha+1) = (alpha-1) pi M_(alpha+1)",
    sympy.Ge(k * gap + 2 * k**2 * (u2 + gap) * u2, 0, evaluate=False),
)
n, r = sympy.Symbol("n", positive=True, integer=True), sympy.Symbol("r", positive=True)
j = sympy.Symbol("j", nonnegative=True, integer=True)
step(
    "By induction 1/delta_j >= 1/delta_0 + g j. The function (1/delta_0 + g x)^(-m) is convex,",
    sympy.Derivative((1 / delta + gain * x) ** (-m), x, 2),
    m * (m + 1) * gain**2 * (1 / delta + gain * x) ** (-m - 2),
)
primitive = -((1 / delta + gain * x) ** (1 - m)) / ((m - 1) * gain)
step(
    "so its value at j is at most its mean over [j - 1/2, j + 1/2] (Hermite-Hadamard); with the primitive P",
    sympy.Derivative(primitive, x),
    (1 / delta + gain * x) ** (-m),
)
step(
    "the sum over all j >= 0 is at most minus P at x = -1/2 (m > 1, 1/delta_0 > g/2)",
    -At(primitive, {x: -sympy.Rational(1, 2)}),
    (1 / delta - gain / 2) ** (1 - m) / ((m - 1) * gain),
)
step(
    "Cauchy on |delta| = rho, where |d| <= D: the powers from delta^n on, x = delta/rho = 1/(1 + r) < 1, are at most",
    sympy.Sum(At(D * x ** (n + j), {x: 1 / (1 + r)}), (j, 0, sympy.oo)),
    At(D * x**n / (1 - x), {x: 1 / (1 + r)}),
)
f2, f3, c0, c1 = sympy.symbols("f_2 f_3 c_0 c_1", real=True)
F = delta + f2 * delta**2 + f2**2 * delta**3 + f3 * delta**4
truncated = c0 / delta + c1 * delta
grown = truncated.subs(delta, F) - truncated
step(
    "The coefficients: Psi = c_0/delta + c_1 delta + … with Psi(F) - Psi = 1 needs -c_0 f_2 = 1",
    Coefficient(sympy.together(grown), delta, 0),
    -c0 * f2,
)
step(
    "and the next power, delta, cancels by itself because F is reversible (f_3 = f_2^2, no-logarithms)",
    Coefficient(sympy.together(grown), delta, 1),
    sympy.Integer(0),
)
y = sympy.Symbol("Y", positive=True)
c_k, K = sympy.symbols("c_k K", positive=True)
step(
    "Its derivative, times delta^2, is -c_0 and for each k >= 1",
    sympy.Derivative(c_k * delta ** (2 * K - 1), delta) * delta**2,
    (2 * K - 1) * c_k * delta ** (2 * K),
)
rest = sympy.Function("S")(delta)  # the terms k >= 1
step(
    "Psi = c_0/delta + S decreases on (0, delta] if sum (2k-1) |c_k| delta^(2k) < c_0: delta^2 Psi' is",
    delta**2 * sympy.Derivative(c0 / delta + rest, delta),
    -c0 + delta**2 * sympy.Derivative(rest, delta),
)
step(
    "An error e of Psi changes 1/delta_n = n g + … by e/c_0 only: far out the relative error of delta_n falls like 1/n",
    Taylor(1 / (y + x), x, 1),
    1 / y - x / y**2,
)
