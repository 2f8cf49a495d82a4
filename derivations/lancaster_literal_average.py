"""What Lancaster's (8) gives with the constant phase of (4)-(6), averaged literally: (alpha+1)/(2 alpha) of the rate.

>>> print(derivation.steps[-1].text())
Limit(alpha*(q(alpha) - 1/2), alpha, oo, dir='-') = 1/2
"""

import sympy
from sympy import Derivative, Limit, Rational, cos, oo, sin

from asymptotics.expansions.moments.symbolic import moment
from derivations.steps import At, Coefficient, Derivation, Solution, defined

k, b, omega, theta, s = sympy.symbols("k b omega_0 theta s", positive=True)
alpha = sympy.Symbol("alpha", positive=True)
A, r = sympy.symbols("A A'", real=True)
a = sympy.Symbol("A", positive=True)
small = sympy.Symbol("lambda", positive=True)

derivation = Derivation(
    "lancaster-literal-average",
    "Why the amplitude of (8) has to be that of the energy",
    source="Lancaster 2020, (4)-(8); lancaster-energy has the exact way",
)
step = derivation.step

# x = A cos(theta), theta' = omega_0: v = A' cos(theta) - A omega_0 sin(theta); k = m omega_0^2.
speed = small * r * cos(theta) - a * omega * sin(theta)
energy = k * speed**2 / (2 * omega**2) + k * (a * cos(theta)) ** 2 / 2
step(
    "x = A cos(theta), theta' = omega_0, A slow: v = A' cos - A omega_0 sin, m = k/omega_0^2.  The energy with"
    " lambda A' for A': without A', and the part of the first order in it",
    sympy.Tuple(At(energy, {small: 0}), Coefficient(energy, small, 1)),
    sympy.Tuple(k * a**2 / 2, -k * a * r / omega * sin(theta) * cos(theta)),
)
slope = omega * Derivative(-k * a * r / omega * sin(theta) * cos(theta), theta) + Derivative(k * a**2 / 2, a) * r
step(
    "Its derivative, without A'' and A'^2: the phase of the second part turns, so both are of the order of k A A'",
    slope,
    k * a * r * (1 - cos(2 * theta)),
    corrects=("lancaster2020:8",),
)
step(
    "that is, with s = |sin(theta)|, 2 s^2 k A A', not k A A' as (8) has it",
    At(k * a * r * (1 - cos(2 * theta)), {cos(2 * theta): 1 - 2 * s**2}),
    2 * s**2 * k * a * r,
)
rate = Solution(2 * s**2 * k * a * r, -b * (a * omega * s) ** (alpha + 1), r)
step(
    "It equals the power -b (A omega_0 s)^(alpha+1): A' at one time is",
    rate,
    -b * omega ** (alpha + 1) * a**alpha * s ** (alpha - 1) / (2 * k),
)
step(
    "so its mean, with <s^(alpha-1)> = M_(alpha-1), is to the right one, with M_(alpha+1), as",
    At(s / 2, {s: moment(alpha - 1)}) / moment(alpha + 1),
    (alpha + 1) / (2 * alpha),
)
step(
    "Averaged before it is divided by s^2, the left side is k A A' again, as <2 sin^2> is",
    sympy.Integral(2 * sin(theta) ** 2, (theta, 0, sympy.pi)) / sympy.pi,
    1,
)
part = defined("q", lambda alpha: (alpha + 1) / (2 * alpha))
step("The literal mean is right for alpha = 1,", part(1), 1)
step("three quarters for alpha = 2,", part(2), Rational(3, 4))
step(
    "and tends to one half for large alpha, as 1/2 + 1/(2 alpha); for alpha = 0 there is none, as 1/s has no mean",
    Limit(alpha * (part(alpha) - Rational(1, 2)), alpha, oo),
    Rational(1, 2),
)
