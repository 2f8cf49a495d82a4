"""The driven oscillator to first order: one amplitude for every law, where it is largest, and Q in two ways.

>>> derivation.steps[4].right
f**2
"""

import sympy

from asymptotics.expansions.moments.symbolic import moment
from derivations.steps import At, Derivation

A, f, k, m, d, r, Omega, w, q, s = sympy.symbols("A f k m d r Omega w q s", positive=True)
alpha = sympy.Symbol("alpha", positive=True)
theta, phi, u = sympy.symbols("theta phi u", real=True)
R, p, g = sympy.symbols("R p g", positive=True)
sin, cos, pi = sympy.sin, sympy.cos, sympy.pi

derivation = Derivation(
    "driven-first-order",
    "The driven oscillator to first order",
    source="asymptotics.driven.first_order: m x'' + k x + b x'|x'|^(alpha-1) = f cos(Omega t)",
)
step, asserts = derivation.step, derivation.asserts

for power in range(4):
    step(
        "x = A cos(u), u = theta - phi: the part of sin(u)|sin(u)|^(alpha-1) that goes with sin(u) is 2 M_(alpha+1), by"
        f" four quarters over pi; alpha = {power}",
        4 * sympy.Integral(sin(u) ** (power + 1), (u, 0, pi / 2)) / pi,
        2 * moment(power + 1),
    )
step(
    "So A (k - m Omega^2) cos(u) - R sin(u) = f cos(u + phi), with R = 2 b M_(alpha+1) (A Omega)^alpha:"
    " p = A (k - m Omega^2) = f cos(phi) and R = f sin(phi), and the squares add up",
    At(p**2 + R**2, {p: f * cos(phi), R: f * sin(phi)}),
    f**2,
)
step(
    "The left side grows with A, from 0 without dry friction: one root.  With d = |k - m Omega^2|, R = r A^alpha",
    sympy.Derivative((A * d) ** 2 + (r * A**alpha) ** 2, A),
    2 * A * d**2 + 2 * alpha * r**2 * A ** (2 * alpha - 1),
)
step(
    "alpha = 1 is exact: A e^(-i phi) = f/(k - m Omega^2 + i b Omega), and R = b A Omega as 2 M_2 is",
    At(p**2 + R**2, {p: A * (k - m * Omega**2), R: 2 * moment(2) * r * A * Omega}),
    A**2 * ((k - m * Omega**2) ** 2 + (r * Omega) ** 2),
)
step(
    "The force does the work",
    sympy.Integral(f * cos(theta) * sympy.Derivative(A * cos(theta - phi), theta), (theta, 0, 2 * pi)),
    pi * f * A * sin(phi),
)
step(
    "in a cycle, pi A R, and a viscous c_eq takes pi c_eq Omega A^2: c_eq is",
    At(pi * A * R / (pi * Omega * A**2), {R: 2 * w * r * (A * Omega) ** alpha}),
    2 * w * r * (A * Omega) ** (alpha - 1),
)
step(
    "The amplitude is stationary where the left side is in Omega: half its slope",
    sympy.Derivative((A * (k - m * Omega**2)) ** 2 / 2 + (r * (A * Omega) ** alpha) ** 2 / 2, Omega),
    (alpha * r**2 * (A * Omega) ** (2 * alpha) - 2 * m * (k - m * Omega**2) * (A * Omega) ** 2) / Omega,
)
step(
    "so k - m Omega^2 = q = alpha R^2/(2 m s^2) with s = A Omega, and (A q)^2 + R^2 = f^2 with A^2 = s^2/Omega^2 is",
    At(A**2 * q**2 + R**2, {A: s / sympy.sqrt((k - q) / m)}),
    m * s**2 * q**2 / (k - q) + R**2,
)
step(
    "Half the power: at A/sqrt(2) R = r A^alpha is f 2^(-alpha/2), f = r A^alpha, and 2 (k - m Omega^2)^2/A^2 is the"
    " square of",
    At(sympy.sqrt(2 * (f**2 - R**2)) / A, {R: f * 2 ** (-alpha / 2)}),
    f * sympy.sqrt(2 - 2 * 2 ** (-alpha)) / A,
)
step(
    "on both sides of omega_0: k - m Omega^2 is about 2 m omega_0 (omega_0 - Omega), so Q = omega_0/width is",
    At(w / (2 * g / (2 * m * w)), {g: f * sympy.sqrt(2 - 2 * 2 ** (-alpha)) / A}),
    m * w**2 * A / f / sympy.sqrt(2 - 2 * 2 ** (-alpha)),
)
step(
    "and the decay at that amplitude has Q = m omega_0/c_eq = k A/f: they agree for alpha = 1",
    At(sympy.sqrt(2 - 2 * 2 ** (-alpha)), {alpha: 1}),
    sympy.Integer(1),
)
asserts(
    "alone: 2^(-alpha) falls; at alpha = 2 their ratio is",
    sympy.Lt(1 / At(sympy.sqrt(2 - 2 * 2 ** (-alpha)), {alpha: 2}), sympy.Rational(9, 10), evaluate=False),
)
asserts(
    "Near miss: with M_(alpha+1) for 2 M_(alpha+1) the linear resistance, b A Omega, is lost",
    sympy.Ne(At(w, {w: moment(2)}), 1, evaluate=False),
)
