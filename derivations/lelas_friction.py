"""Lelas' squaring trick for sliding friction (22)-(33), and for any exponent alpha <= 1: too fast a decay.

>>> derivation.steps[-1].reason
'and Lelas stops earlier, by the factor M_1 sqrt(2) = 2 sqrt(2)/pi < 1, for every strength'
"""

import sympy

from asymptotics.moments.symbolic import moment, squaring_moment, squaring_ratio
from derivations.steps import At, Derivation, defined, named

mu, g, m, k, x_0, omega_0, t, sine, cosine = sympy.symbols("mu g m k x_0 omega_0 t s c", positive=True)
epsilon, theta = sympy.symbols("epsilon theta", positive=True)
f, v = sympy.Symbol("f", positive=True), sympy.Symbol("v", real=True)
sqrt = sympy.sqrt

derivation = Derivation(
    "lelas-friction",
    "The squaring trick for sliding friction",
    source="Lelas 2024, (22)-(33), (47)-(50); lelas2024:24, 26, 30, 31, 32, 33, 50",
)
step, holds = derivation.step, derivation.holds

step("sgn(v) v = |v|, for v > 0 and v < 0 alike", sympy.sign(v) * v, sympy.Abs(v))
unit = m * omega_0**2 * x_0**2 * f  # (15): dE/dt = unit df/dt
first = -mu * m * g * omega_0 * x_0 * f * sine / unit  # sine = |sin(omega_0 t)|
second = -mu * m * g * omega_0 * x_0 * f * cosine / unit
step("(26)", named("f'", first), -mu * g / (omega_0 * x_0) * sine)
step("(27)", named("f'", second), -mu * g / (omega_0 * x_0) * cosine)
squares = (first**2 + second**2).subs(cosine, sqrt(1 - sine**2))
step("(28) + (29): s^2 + c^2 = 1", squares, (mu * g / (omega_0 * x_0)) ** 2)
slope = -mu * g / (sqrt(2) * omega_0 * x_0)
step("(30), (31): both rates replaced by one, 2 (df/dt)^2, negative root", 2 * slope**2, squares)
solution = 1 + slope * t
step("(32) solves it", sympy.Derivative(solution, t), slope)
step("and f(0) = 1", At(solution, {t: 0}), sympy.Integer(1))
end = sqrt(2) * omega_0 * x_0 / (mu * g)
step("It ends at sqrt(2) omega_0 x_0/(mu g), with the root over the 2 alone", At(solution, {t: end}), sympy.Integer(0))
inside = sqrt(2 * omega_0 * x_0 / (mu * g))
holds(
    "not at sqrt(2 omega_0 x_0/(mu g)): the units differ", bool(sympy.simplify(solution.subs(t, inside)) != 0), inside
)
step(
    "(33): |df/dt|/omega_0 in k and m",
    At(-slope / omega_0, {omega_0: sqrt(k / m)}),
    mu * m * g / (sqrt(2) * k * x_0),
)
values = {mu: 1, m: sympy.Rational(3, 2), g: sympy.Rational(981, 100), k: 30, x_0: sympy.Rational(1, 5)}
bound = (sqrt(2) * k * x_0 / (m * g)).subs(values)
holds("(50): 0.58 to two digits", bool(abs(bound - sympy.Rational(58, 100)) < sympy.Rational(1, 200)), bound)
M = defined("M", moment, index=True)
Lelas = defined("L", lambda alpha: squaring_moment(alpha))
step("In epsilon = mu m g/(k x_0): df/dtau = -2^{-1/2} epsilon", Lelas(0), 1 / sqrt(2))
step("while the mean over a swing is", M(1), sympy.Integral(sympy.sin(theta), (theta, 0, sympy.pi)) / sympy.pi)
step(
    "the ratio pi sqrt(2)/4 > 1: the trick overestimates the damping",
    Lelas(0) / M(1),
    sympy.pi * sqrt(2) / 4,
)
holds("It is larger than 1", bool(squaring_ratio(sympy.Integer(0)) > 1), sympy.pi * sqrt(2) / 4 > 1)
step(
    "and Lelas stops earlier, by the factor M_1 sqrt(2) = 2 sqrt(2)/pi < 1, for every strength",
    (1 / (Lelas(0) * epsilon)) / (1 / (M(1) * epsilon)),
    2 * sqrt(2) / sympy.pi,
)
