"""Lelas' two initial conditions and the trick of adding dissipation rates, for viscous damping: (14)-(21).

>>> print(derivation.steps[9].text())
Derivative(exp(-b*t/(2*m)), t) = -b*exp(-b*t/(2*m))/(2*m)
"""

import sympy

from derivations.steps import At, Derivation, Solution

b, k, m, x_0, omega_0, t = sympy.symbols("b k m x_0 omega_0 t", positive=True)
f = sympy.Function("f", positive=True)(t)
diff, sin, cos, sqrt = sympy.diff, sympy.sin, sympy.cos, sympy.sqrt

derivation = Derivation(
    "lelas-viscous",
    "Adding the dissipation rates: viscous damping",
    source="Lelas 2024, (8)-(21); lelas2024:10, 11, 14, 15, 18, 19, 20, 21",
)
step, asserts = derivation.step, derivation.asserts

D = sympy.Derivative
x1, x2 = x_0 * f * cos(omega_0 * t), x_0 * f * sin(omega_0 * t)
step(
    "(10)",
    sympy.Derivative(x1, t),
    -omega_0 * (x_0 * f * sin(omega_0 * t) - x_0 * diff(f, t) / omega_0 * cos(omega_0 * t)),
    corrects=("lelas2024:10",),
)
step(
    "(11)",
    sympy.Derivative(x2, t),
    omega_0 * (x_0 * f * cos(omega_0 * t) + x_0 * diff(f, t) / omega_0 * sin(omega_0 * t)),
    corrects=("lelas2024:claim.slope-small",),
)
v1, v2 = -omega_0 * x_0 * f * sin(omega_0 * t), omega_0 * x_0 * f * cos(omega_0 * t)
printed = -omega_0 * (x_0 * f * sin(omega_0 * t) + x_0 * diff(f, t) / omega_0 * cos(omega_0 * t))
asserts(
    "(10) as printed, with + before the second term, is refuted (the term is dropped in (12), nothing else changes)",
    sympy.Ne(sympy.Derivative(x1, t), printed, evaluate=False),
)
energy = m * omega_0**2 * x_0**2 * f**2 / 2
X, V = sympy.symbols("x v", real=True)
total = k * X**2 / 2 + m * V**2 / 2
step("(14), first pair, with k = m omega_0^2", At(total, {k: m * omega_0**2, X: x1, V: v1}), energy)
step("second pair", At(total, {k: m * omega_0**2, X: x2, V: v2}), energy)
step("(15)", sympy.Derivative(energy, t), m * omega_0**2 * x_0**2 * f * diff(f, t))
rates = [Solution(D(energy, t), -b * speed**2, D(f, t)) for speed in (v1, v2)]
first, second = -b / m * f * sin(omega_0 * t) ** 2, -b / m * f * cos(omega_0 * t) ** 2
step("(18): (15) = -b v_1^2, solved for df/dt", rates[0], first)
step("(19): (15) = -b v_2^2, solved for df/dt", rates[1], second)
step("(20): half the sum", (rates[0] + rates[1]) / 2, -b / (2 * m) * f)
solution = sympy.exp(-b * t / (2 * m))
step("solved by f = e^{-bt/(2m)}, f(0) = 1", sympy.Derivative(solution, t), -b / (2 * m) * solution)
alone = sympy.exp(-b / m * (t / 2 - sin(2 * omega_0 * t) / (4 * omega_0)))
step(
    "the first rate alone has f = e^{-(b/m)(t/2 - sin(2 omega_0 t)/(4 omega_0))}: the same decay with a ripple",
    At(sympy.Derivative(alone, t), {cos(2 * omega_0 * t): 1 - 2 * sin(omega_0 * t) ** 2}),
    -b / m * sin(omega_0 * t) ** 2 * alone,
)
step(
    "(21): |df/dt| at the start, over omega_0, in k and m: small means b << 2 sqrt(k m)",
    At(-At(sympy.Derivative(solution, t), {t: 0}) / omega_0, {omega_0: sqrt(k / m)}),
    b / (2 * sqrt(k * m)),
)
theta = sympy.Symbol("theta", real=True)
quarter = (theta, 0, sympy.pi / 2)
step(
    "(18) and (19) at once would say sin^2 = cos^2; their means over a quarter period, or several, are the same",
    sympy.Tuple(*(sympy.Integral(wave(theta) ** 2, quarter) / (sympy.pi / 2) for wave in (sin, cos))),
    sympy.Tuple(sympy.Rational(1, 2), sympy.Rational(1, 2)),
    corrects=("lelas2024:claim.two-rates-contradict",),
)
step(
    "Near miss: at an instant they are not, at a turning point the two rates differ by all of b f/m",
    At(second - first, {t: 0}),
    -b / m * f.subs(t, 0),
)
