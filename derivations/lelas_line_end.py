"""The averaged line (48) at the end of Lelas's line (32), and the stop times with the paper's numbers.

>>> print(derivation.steps[1].text())
Subs(f_48(t), t, sqrt(2)*omega_0*x_0/(g*mu)) = -2*sqrt(2)/pi + 1
"""

import sympy
from sympy import Derivative, Integral, Rational, pi, sin, sqrt

from derivations.steps import At, Derivation, Solution, defined

mu, g, m, k, x_0, omega, t = sympy.symbols("mu g m k x_0 omega_0 t", positive=True)
theta = sympy.Symbol("theta", real=True)

derivation = Derivation(
    "lelas-line-end",
    "The averaged line at the end of the other, and the stop times",
    source="Lelas 2024, (47), (48), and the numbers of section V; lelas-friction has (32)",
)
step, asserts = derivation.step, derivation.asserts

end = sqrt(2) * omega * x_0 / (mu * g)
averaged = defined("f_48", lambda t: 1 - 2 * mu * g * t / (pi * omega * x_0))
step(
    "(48), the averaged line, has the mean 2/pi of |sin| in its slope",
    -Derivative(averaged(t), t),
    mu * g / (omega * x_0) * Integral(sin(theta), (theta, 0, pi)) / pi,
)
step(
    "so at the end of (32) it is still 0.0997, for every mu; the exact turning points lie on (48)",
    At(averaged(t), {t: end}),
    1 - 2 * sqrt(2) / pi,
    corrects=("lelas2024:claim.describes-well",),
)
last = pi * omega * x_0 / (2 * mu * g)
step("(48) ends at pi omega_0 x_0/(2 mu g)", Solution(averaged(t), 0, t), last)

# The numbers: m = 3/2, k = 30, x_0 = 1/5, g = 981/100, mu = 0.01 and 0.03, in SI units; omega_0 = sqrt(20).
panels = [
    {mu: Rational(n, 100), m: Rational(3, 2), k: 30, x_0: Rational(1, 5), g: Rational(981, 100), omega: sqrt(20)}
    for n in (1, 3)
]
digit = Rational(1, 200)


def near(value: sympy.Expr, printed: Rational) -> sympy.Lt:
    """Rounded to two decimals it is the printed number."""
    return sympy.Lt(sympy.Abs(value - printed, evaluate=False), digit, evaluate=False)


asserts(
    "With mu = 0.01 that is 14.32 s, with 0.03 4.77 s, to two decimals",
    near(At(last, panels[0]), Rational(1432, 100)),
    near(At(last, panels[1]), Rational(477, 100)),
    corrects=("lelas2024:value.tau-tilde-a", "lelas2024:value.tau-tilde-b"),
)
asserts(
    "and not 14.33 s and 4.78 s: these are pi/(2 sqrt 2) times 12.9 s and 4.3 s, which are rounded",
    near(At(pi * t / (2 * sqrt(2)), {t: Rational(129, 10)}), Rational(1433, 100)),
    near(At(pi * t / (2 * sqrt(2)), {t: Rational(43, 10)}), Rational(478, 100)),
    sympy.Gt(abs(At(last, panels[0]) - Rational(1433, 100)), digit, evaluate=False),
    sympy.Gt(abs(At(last, panels[1]) - Rational(478, 100)), digit, evaluate=False),
)
swings = (k * x_0 / (mu * m * g) - 1) / 2
asserts(
    "The exact motion stops after N = ceil((k x_0/(mu m g) - 1)/2) half-swings (lelas-friction-exact), for mu = 0.03"
    " seven: 7 pi/omega_0 is 4.92 s",
    sympy.Gt(At(swings, panels[1]), 6, evaluate=False),
    sympy.Le(At(swings, panels[1]), 7, evaluate=False),
    near(At(7 * pi / omega, panels[1]), Rational(492, 100)),
    corrects=("lelas2024:value.tau-exact-b",),
)
