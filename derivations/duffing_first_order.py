"""The Duffing oscillator with any loss, to first order in the loss and exactly in the amplitude; the exact motions.

>>> derivation.steps[0].right
A**2*c*(cos(theta)**2 + 1)/2 + 1
"""

import sympy
from sympy import cos, sin

from asymptotics.expansions.moments.symbolic import mean, moment
from derivations.steps import At, Derivation, defined

A, B, mu, theta, xi, y, k = sympy.symbols("A B mu theta xi y k", positive=True)
alpha, m, epsilon = sympy.symbols("alpha m epsilon", positive=True)
c = sympy.Symbol("c", real=True)
x = sympy.Symbol("x", real=True)
half = sympy.Rational(1, 2)

derivation = Derivation(
    "duffing-first-order",
    "A Duffing oscillator in any loss, to first order in the loss",
    source="asymptotics.expansions.straightening.wells",
)
step, asserts = derivation.step, derivation.asserts


def potential(z: sympy.Expr) -> sympy.Expr:
    """V of the spring x + c x^3."""
    return z**2 / 2 + c * z**4 / 4


V = defined("V", potential)
step(
    "V = x^2/2 + c x^4/4: v^2 = 2 (V(A) - V(x)) with x = A cos(theta), over A^2 sin^2(theta)",
    At(2 * (V(A) - V(x)), {x: A * cos(theta)}) / (A**2 * sin(theta) ** 2),
    1 + c * A**2 * (1 + cos(theta) ** 2) / 2,
)
step(
    "B = 1 + c A^2: that is B (1 - mu sin^2(theta)) with mu = (B - 1)/(2 B) = c A^2/(2 B)",
    At(1 + c * A**2 * (1 + cos(theta) ** 2) / 2, {c: (B - 1) / A**2}),
    B * (1 - (B - 1) / (2 * B) * sin(theta) ** 2),
)
step(
    "xi^2 = 2 V(A): B^2 = 1 + 2 c xi^2", (1 + c * A**2) ** 2, At(1 + 2 * c * xi**2, {xi: sympy.sqrt(2 * potential(A))})
)
step(
    "and A^2 = 2 xi^2/(1 + B)",
    At(2 * xi**2 / (1 + B), {xi: sympy.sqrt(2 * potential(A)), B: 1 + c * A**2}),
    sympy.expand(A**2),
)
step(
    "A half-swing takes eps int |x|^m |v|^alpha |dx| of the energy E = xi^2/2; d ln xi = dE/xi^2, as (dE/dxi)/xi^2 is",
    sympy.Derivative(xi**2 / 2, xi) / xi**2,
    1 / xi,
)
mean_of = defined("M", mean, index=True)
n = sympy.Symbol("n", integer=True, nonnegative=True)
power = alpha + 1 + 2 * n
for order in range(1, 4):
    step(
        f"It is A^(m+alpha+1) B^(alpha/2) int |cos|^m sin^(alpha+1) (1 - mu sin^2)^(alpha/2); at mu^{order}, with"
        " M_(m,n) for the mean of |cos|^m sin^n, the mean over the first one is the coefficient of"
        " 2F1(-alpha/2, (alpha+2)/2; (alpha+m+3)/2; mu)",
        sympy.rf(-alpha / 2, order)
        / sympy.factorial(order)
        * mean_of(m, alpha + 1 + 2 * order)
        / mean_of(m, alpha + 1),
        sympy.rf(-alpha / 2, order)
        * sympy.rf(alpha / 2 + 1, order)
        / sympy.rf((alpha + m + 3) / 2, order)
        / sympy.factorial(order),
    )
step(
    "and so on: from mu^n to mu^(n+1) the mean gains the factor of 2F1 (what stands before it is common)",
    mean_of(m, power + 2) / mean_of(m, power),
    (alpha / 2 + 1 + n) / ((alpha + m + 3) / 2 + n),
)
series = 1 - mu * sympy.Rational(4, 5)
step(
    "alpha = 2, m = 0: 2F1(-1, 2; 5/2; mu) ends, and the integral is that of 2 (V(A) - V(x))",
    sympy.Integral(2 * (potential(A) - potential(x)), (x, -A, A)),
    At(sympy.pi * moment(3) * A**3 * B * series, {mu: c * A**2 / (2 * (1 + c * A**2)), B: 1 + c * A**2}).doit(),
)
step(
    "The half period int dx/v is the same with alpha = -1, m = 0: M_0 = 1, and at mu^1 the 2F1(1/2, 1/2; 1; mu)",
    At(sympy.rf(-alpha / 2, 1) * (alpha / 2 + 1) / ((alpha + 3) / 2), {alpha: -1}),
    sympy.Rational(1, 4),
)

# The exact motions without loss.
step(
    "cn(u, mu) obeys y'^2 = (1 - y^2)(1 - mu + mu y^2): y'' is half its slope",
    sympy.Derivative((1 - y**2) * (1 - mu + mu * y**2), y) / 2,
    (2 * mu - 1) * y - 2 * mu * y**3,
)
step(
    "x = A cn(sqrt(B) t, mu): x'' = A B y'' is -x - c x^3",
    At(A * B * ((2 * mu - 1) * y - 2 * mu * y**3), {mu: c * A**2 / (2 * (1 + c * A**2)), B: 1 + c * A**2}),
    -A * y - c * (A * y) ** 3,
)
step(
    "Pendulum, sin(x/2) = k y with y = cd(t, k), y'^2 = (1 - y^2)(1 - k^2 y^2): x'^2 = (dx/dy)^2 y'^2 is"
    " 2 (cos x - cos a) = 4 (k^2 - sin^2(x/2))",
    sympy.Derivative(2 * sympy.asin(k * y), y) ** 2 * ((1 - y**2) * (1 - k**2 * y**2)),
    4 * (k**2 - (k * y) ** 2),
)
asserts(
    "Near miss: with (alpha+3)/2 for (alpha+2)/2 in the numerator the quadratic loss, 4/5 at m = 0, is lost",
    sympy.Ne(At(((alpha + 3) / 2) / ((alpha + m + 3) / 2), {alpha: 2, m: 0}), sympy.Rational(4, 5), evaluate=False),
)
