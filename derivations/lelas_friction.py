"""Lelas' squaring trick for sliding friction (22)-(33), and for any exponent alpha <= 1: too fast a decay.

>>> derivation.steps[17].reason
'and Lelas stops earlier than at 1/(M_1 epsilon), by the factor M_1 sqrt(2) = 2 sqrt(2)/pi < 1, for every strength'
"""

import sympy

from asymptotics.expansions.moments.symbolic import moment
from derivations.steps import At, Derivation, Solution, defined

mu, g, m, k, x_0, omega_0, t = sympy.symbols("mu g m k x_0 omega_0 t", positive=True)
epsilon, theta, tau = sympy.symbols("epsilon theta tau", positive=True)
v = sympy.Symbol("v", real=True)
sqrt = sympy.sqrt

derivation = Derivation(
    "lelas-friction",
    "The squaring trick for sliding friction",
    source="Lelas 2024, (22)-(33), (47)-(50); lelas2024:24, 26, 30, 31, 32, 33, 50",
)
step = derivation.step

step("sgn(v) v = |v|, for v > 0 and v < 0 alike", sympy.sign(v) * v, sympy.Abs(v))
amplitude, change = sympy.Function("f", positive=True)(t), sympy.Symbol("f'", real=True)
energy = m * omega_0**2 * x_0**2 * amplitude**2 / 2  # (14)
wave = {"24": sympy.sin(omega_0 * t), "25": sympy.cos(omega_0 * t)}
powers = {n: -mu * m * g * omega_0 * x_0 * amplitude * sympy.Abs(u) for n, u in wave.items()}
rates = {n: -mu * g / (omega_0 * x_0) * sympy.Abs(u) for n, u in wave.items()}
for (number, power), speed in zip(powers.items(), (-wave["24"], wave["25"]), strict=True):
    step(
        f"({number}): -mu m g |v| at the velocity ({int(number) - 12})",
        At(-mu * m * g * sympy.Abs(v), {v: omega_0 * x_0 * amplitude * speed}),
        power,
        proves=(f"lelas2024:{number}",),
    )
for number, power in powers.items():
    step(
        f"({int(number) + 2}): dE/dt of (15) is the power ({number}); solved for df/dt, f cancels",
        Solution(sympy.Derivative(energy, t), power, sympy.Derivative(amplitude, t)),
        rates[number],
        proves=(f"lelas2024:{int(number) + 2}",),
    )
right = sympy.Add(*(rate**2 for rate in rates.values()), evaluate=False)
step(
    "(30): the squares (28) and (29) added, with one f' for both",
    Solution(2 * sympy.Symbol("R", real=True), right, sympy.Symbol("R", real=True)),
    (mu * g / (omega_0 * x_0)) ** 2 / 2,
    proves=("lelas2024:30",),
)
slope = -mu * g / (sqrt(2) * omega_0 * x_0)
step(
    "(31): its negative root, since f falls",
    Solution(change**2, (mu * g / (omega_0 * x_0)) ** 2 / 2, change, sign=-1),
    slope,
    proves=("lelas2024:31",),
)
solution = 1 + slope * t
step(
    "(32) solves it",
    sympy.Derivative(solution, t),
    slope,
    corrects=("lelas2024:claim.integrated-rate", "lelas2024:claim.slope-of-line", "lelas2024:claim.force-of-47"),
)
step("and f(0) = 1", At(solution, {t: 0}), sympy.Integer(1))
end = sqrt(2) * omega_0 * x_0 / (mu * g)
step(
    "It ends at sqrt(2) omega_0 x_0/(mu g), with the root over the 2 alone",
    At(solution, {t: end}),
    sympy.Integer(0),
    corrects=("lelas2024:claim.stop-time-section-3", "lelas2024:claim.stop-time-section-5"),
)
inside = sqrt(2 * omega_0 * x_0 / (mu * g))
step(
    "not at sqrt(2 omega_0 x_0/(mu g)), with the root over all: for x_0 = g = 1 and omega_0 = 2 mu f is still",
    At(At(solution, {t: inside}), {x_0: 1, g: 1, omega_0: 2 * mu}),
    1 - 1 / sqrt(2),
)
step(
    "(33): |df/dt|/omega_0 in k and m",
    At(-slope / omega_0, {omega_0: sqrt(k / m)}),
    mu * m * g / (sqrt(2) * k * x_0),
)
values = {mu: 1, m: sympy.Rational(3, 2), g: sympy.Rational(981, 100), k: 30, x_0: sympy.Rational(1, 5)}
bound = (sqrt(2) * k * x_0 / (m * g)).subs(values)
derivation.asserts(
    "(50): 0.58 to two digits, for m = 3/2, k = 30, x_0 = 1/5, g = 981/100 in SI units",
    sympy.Lt(sympy.Abs(bound - sympy.Rational(58, 100), evaluate=False), sympy.Rational(1, 200), evaluate=False),
)
local = At(solution, {t: tau / omega_0, mu: epsilon * omega_0**2 * x_0 / g})
step(
    "In tau = omega_0 t and epsilon = mu m g/(k x_0), k = m omega_0^2: df/dtau",
    sympy.Derivative(local, tau),
    -epsilon / sqrt(2),
)
M = defined("M", moment, index=True)
mean = sympy.Integral(sympy.sin(theta), (theta, 0, sympy.pi)) / sympy.pi
step("while the mean over a swing is", M(1), mean)
step(
    "the ratio pi sqrt(2)/4 > 1: the trick overestimates the damping",
    -sympy.Derivative(local, tau) / (mean * epsilon),
    sympy.pi * sqrt(2) / 4,
)
derivation.asserts("It is larger than 1", sympy.Gt(sympy.pi * sqrt(2) / 4, 1, evaluate=False))
step(
    "and Lelas stops earlier than at 1/(M_1 epsilon), by the factor M_1 sqrt(2) = 2 sqrt(2)/pi < 1, for every strength",
    Solution(local, sympy.Integer(0), tau) * mean * epsilon,
    2 * sqrt(2) / sympy.pi,
)

# Near the end of the line, and after it.
line = defined("f", lambda t: 1 + slope * t)
ratio = -sympy.Derivative(line(t), t) / (omega_0 * line(t))
derivation.asserts(
    "|f'|/omega_0 is constant, but what is dropped from (10) is to what is kept as f' to omega_0 f: however small mu,"
    " at the end of (32)",
    sympy.Eq(sympy.Limit(ratio, t, end, "-"), sympy.oo, evaluate=False),
    corrects=("lelas2024:claim.dropping-the-slope",),
)
b = sympy.Symbol("b", positive=True)
decay = defined("f_20", lambda t: sympy.exp(-b * t / (2 * m)))
step(
    "Near miss: with (20) the ratio does not grow, and small at the start is small for ever",
    -sympy.Derivative(decay(t), t) / (omega_0 * decay(t)),
    b / (2 * m * omega_0),
)
later = sympy.Symbol("s", positive=True)
derivation.asserts(
    "(32) starts from 1 and falls, and yet it is negative after its end, here by the time s",
    sympy.Lt(At(line(t), {t: end + later}), 0, evaluate=False),
    corrects=("lelas2024:claim.amplitude-not-negative",),
)
