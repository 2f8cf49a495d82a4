"""The pendulum with any loss: first order in the loss, exact in the amplitude.

>>> print(derivation.steps[0].text())
Integral(sin(x), (x, 0, a)) = 2*sin(a/2)**2
"""

import sympy

from asymptotics.expansions.moments.symbolic import moment
from derivations.steps import At, Derivation, defined

a, k, theta, epsilon = sympy.symbols("a k theta epsilon", positive=True)
alpha = sympy.Symbol("alpha", positive=True)
n = sympy.Symbol("n", integer=True, nonnegative=True)

derivation = Derivation(
    "pendulum-first-order",
    "A pendulum in any loss, to first order in the loss",
    source="asymptotics.expansions.straightening.wells",
)
step, asserts = derivation.step, derivation.asserts

angle, place = sympy.symbols("x y", real=True)
step(
    "The energy at the turning angle, the integral of the force, is 1 - cos a = 2 k^2, k = sin(a/2)",
    sympy.Integral(sympy.sin(angle), (angle, 0, a)),
    2 * sympy.sin(a / 2) ** 2,
)
x = 2 * sympy.asin(k * sympy.sin(theta))
step(
    "With y = sin(x/2) = k sin(theta), v^2 = 2 (cos x - cos a) = 4 (k^2 - y^2)",
    At(4 * (k**2 - place**2), {place: k * sympy.sin(theta)}),
    4 * k**2 * sympy.cos(theta) ** 2,
)
step(
    "and dx/dtheta",
    sympy.Derivative(x, theta),
    2 * k * sympy.cos(theta) / sympy.sqrt(1 - k**2 * sympy.sin(theta) ** 2),
)

# int_{-pi/2}^{pi/2} cos^(alpha+1) (1 - k^2 sin^2)^(-1/2), term by term in k^2.
coefficient = sympy.rf(sympy.Rational(1, 2), n) / sympy.factorial(n)
beta = sympy.gamma((alpha + 2) / 2) * sympy.gamma(n + sympy.Rational(1, 2)) / sympy.gamma((alpha + 3) / 2 + n)
series = sympy.pi * moment(alpha + 1) * coefficient * sympy.rf(sympy.Rational(1, 2), n) / sympy.rf((alpha + 3) / 2, n)
turned = sympy.Symbol("theta", real=True)
step(
    "int cos^(alpha+1) over |theta| <= pi/2 is pi M_(alpha+1), that of sin^(alpha+1) over [0, pi], a quarter turn on",
    At(sympy.cos(turned), {turned: turned - sympy.pi / 2}),
    sympy.sin(turned),
)
term = defined("J", lambda place: (coefficient * beta).subs(n, place), index=True)
derivation.defines("J_n = (1/2)_n/n! int cos^(alpha+1) sin^(2n), a Beta integral", term(n), coefficient * beta)
step(
    "It is pi M_(alpha+1) times the coefficient of k^(2n) in 2F1(1/2, 1/2; (alpha+3)/2; k^2): at n = 0",
    term(0),
    series.subs(n, 0),
)
step(
    "and from n to n + 1 both gain the same factor",
    term(n + 1) / term(n),
    sympy.gammasimp((series.subs(n, n + 1) / series).rewrite(sympy.gamma)),
)
for order in range(1, 4):
    step(
        f"for instance pi M_(alpha+1) times the coefficient of k^{2 * order}",
        term(order),
        sympy.gammasimp(series.subs(n, order)),
    )
step(
    "From d(2 k^2) = -epsilon (2 k)^(alpha+1) times that: d ln k",
    -epsilon * (2 * k) ** (alpha + 1) / sympy.Derivative(2 * k**2, k) / k,
    -epsilon * (2 * k) ** (alpha - 1),
)
closed = (sympy.sin(a) - a * sympy.cos(a)) / (1 - sympy.cos(a))
work = sympy.Integral((sympy.cos(theta) - sympy.cos(a)) * 2, (theta, -a, a))
step(
    "alpha = 2 is elementary: int v^2 dx over twice the energy 1 - cos a",
    work / (2 * (1 - sympy.cos(a))),
    2 * closed,
)
asserts(
    "A factor 2^alpha too much would be seen at alpha = 2",
    sympy.Ne(work / (2 * (1 - sympy.cos(a))), 4 * (2 * closed), evaluate=False),
)
