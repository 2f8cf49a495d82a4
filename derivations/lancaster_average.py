"""The average (12): <|sin|^(alpha+1)> = 2^(alpha+1) B(alpha/2+1, alpha/2+1)/pi = M_(alpha+1).

>>> print(derivation.steps[5].text())
Integral(w**(alpha/2)*(w + 1)**(-alpha - 2), (w, 0, oo)) = gamma(alpha/2 + 1)**2/gamma(alpha + 2)
"""

import sympy

from asymptotics.expansions.moments.symbolic import moment
from derivations.steps import At, Derivation

alpha = sympy.Symbol("alpha", positive=True)
z = sympy.Symbol("z", positive=True)
y, theta = sympy.symbols("y theta", positive=True)
gamma, pi, sqrt, sin, cos = sympy.gamma, sympy.pi, sympy.sqrt, sympy.sin, sympy.cos

derivation = Derivation(
    "lancaster-average",
    "The mean of a power of the sine",
    source="Lancaster 2020, (11), (12); lancaster2020:12",
)
step = derivation.step

u = (1 - cos(theta)) / 2
step(
    "With u = sin^2(theta/2) = (1 - cos theta)/2 the sine is 2 sqrt(u(1-u))",
    At(4 * y * (1 - y), {y: u}),
    sin(theta) ** 2,
)
step(
    "u runs from 0 to 1 as theta runs from 0 to pi",
    sympy.Tuple(At(u, {theta: 0}), At(u, {theta: pi})),
    sympy.Tuple(0, 1),
)
step("and du = (sin theta/2) dtheta", sympy.Derivative(u, theta), sin(theta) / 2)
shape = sympy.Symbol("s", positive=True)  # sin(theta); du = (s/2) dtheta
step(
    "so sin^(alpha+1) dtheta = 2^(alpha+1) [u(1-u)]^(alpha/2) du on 0 <= theta <= pi, 0 <= u <= 1",
    At(shape ** (alpha + 1) / (shape / 2), {shape: 2 * sqrt(y * (1 - y))}),
    sympy.powsimp(sympy.expand_power_base(2 ** (alpha + 1) * (y * (1 - y)) ** (alpha / 2), force=True)),
)
beta = gamma(alpha / 2 + 1) ** 2 / gamma(alpha + 2)
w = sympy.Symbol("w", positive=True)
step(
    "With u = w/(1+w), w from 0 to infinity: u(1-u) and du/dw are",
    sympy.Tuple(At(y * (1 - y), {y: w / (1 + w)}), sympy.Derivative(w / (1 + w), w)),
    sympy.Tuple(w / (1 + w) ** 2, 1 / (1 + w) ** 2),
)
step(
    "so int [u(1-u)]^(alpha/2) du is the beta integral B(alpha/2+1, alpha/2+1), for every alpha >= 0",
    sympy.Integral(w ** (alpha / 2) / (1 + w) ** (alpha + 2), (w, 0, sympy.oo)),
    beta,
)
for n in (0, 2, 4):
    step(
        f"alpha = {n}: the beta integral",
        sympy.Integral((y * (1 - y)) ** (n // 2), (y, 0, 1)),
        beta.subs(alpha, n),
    )
printed = 2 ** (alpha + 1) * beta / pi
double = 2 ** (2 * z - 1) * gamma(z) * gamma(z + sympy.Rational(1, 2)) / sqrt(pi)
step("Legendre's duplication", gamma(2 * z), double)
step(
    "with z = alpha/2 + 1 in the denominator: M_(alpha+1)",
    At(printed, {gamma(alpha + 2): At(double, {z: alpha / 2 + 1})}),
    moment(alpha + 1),
    proves=("lancaster2020:11", "lancaster2020:12", "lancaster2020:claim.c", "lancaster2020:claim.kappa-scaling"),
)
for n in range(4):
    step(
        f"(12) at alpha = {n} is the mean of sin^{n + 1} over a half period",
        At(printed, {alpha: n}),
        sympy.Integral(sin(theta) ** (n + 1), (theta, 0, pi)) / pi,
    )
