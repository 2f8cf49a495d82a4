"""For alpha > 1 the oscillator is never overdamped: from any turning point the mass passes X = 0, at any strength.

On a half-swing y' = -w, w' = y - N(w), N = sum_i epsilon_i w^alpha_i, all alpha_i > 1.  For a given c > 0 the slope of
N at small w is below c, and then a mass that stayed at y > 0 for ever would end in a linear focus, which turns.

>>> print(derivation.steps[0].text())
Subs(e*w**beta, w, (c/e)**(1/beta)) = c
"""

import sympy

from derivations.steps import At, Derivation

w, y, e, c = sympy.symbols("w y e c", positive=True)
beta = sympy.Symbol("beta", positive=True)
R = sympy.Symbol("R", positive=True)
theta = sympy.Symbol("theta", real=True)

derivation = Derivation(
    "no-overdamping",
    "No overdamping for alpha > 1",
    source="theory page finite_strength; regular point of the flow in the quarter y > 0, w > 0",
)
step, asserts = derivation.step, derivation.asserts

step(
    "Below the speed w_c = (c/e)^(1/(alpha-1)) a term e w^alpha, alpha = 1 + beta, is at most c w: e w_c^beta = c",
    At(e * w**beta, {w: (c / e) ** (1 / beta)}),
    c,
)
step(
    "and e w^beta increases with w: its slope is",
    sympy.Derivative(e * w**beta, w),
    beta * e * w ** (beta - 1),
)
energy = (y**2 + w**2) / 2
rate = sympy.Derivative(energy, y) * (-w) + sympy.Derivative(energy, w) * (y - e * w ** (1 + beta))
step("The energy falls: its rate is -w N(w)", rate, -e * w ** (2 + beta))
step(
    "While y > 0 the orbit cannot turn: at w = 0 the speed grows at the rate y",
    At(y - e * w ** (1 + beta), {w: 0}),
    y,
)
s, T, w_c, q, r = sympy.symbols("s T w_c q r", positive=True)
path = sympy.Function("y")
step(
    "So if y > 0 for ever: y falls from y_0, so it has a limit; the integral of w = -y' up to any T is y_0 - y(T),",
    sympy.Integral(-sympy.Derivative(path(s), s), (s, 0, T)),
    path(0) - path(T),
)
step(
    "bounded by y_0, and w' is bounded: hence w -> 0; and then w' tends to lim y, which must be 0,",
    sympy.Limit(y - e * w ** (1 + beta), w, 0),
    y,
)
step(
    "or w would grow.  From some time on w = s w_c, s < 1, where with c = 1 e = w_c^(-beta): e w^beta is",
    At(e * w**beta, {e: w_c**-beta, w: s * w_c}),
    s**beta,
)
asserts(
    "which is below 1: q = 1/(1 + r), r > 0.  So w' = y - w q exceeds y - w there",
    sympy.Gt(At(y - w * q, {q: 1 / (1 + r)}), y - w, evaluate=False),
)
y_rate, w_rate = sympy.symbols("y' w'", real=True)
polar = {y: R * sympy.cos(theta), w: R * sympy.sin(theta)}
polar |= {w_rate: polar[y] - c * polar[w], y_rate: -polar[w]}
step(
    "In polar coordinates y = R cos theta, w = R sin theta: theta' = (y w' - w y')/R^2, and w' >= y - c w there",
    At((y * w_rate - w * y_rate) / R**2, polar),
    1 - c * sympy.sin(2 * theta) / 2,
)
step(
    "With c = 1 theta' >= 1/2: 1 - sin(2 theta)/2 exceeds 1/2 by half a square, (1 - sin(2 theta))/2, that is",
    At(1 - c * sympy.sin(2 * theta) / 2, {c: 1}) - sympy.Rational(1, 2),
    (sympy.cos(theta) - sympy.sin(theta)) ** 2 / 2,
)
step(
    "so theta reaches pi/2, where y = 0, after a time of at most pi: a contradiction.  The mass passes y = 0",
    sympy.Integral(1 / (1 - sympy.Rational(1, 2)), (theta, 0, sympy.pi / 2)),
    sympy.pi,
)
step(
    "After that, y < 0: w' <= y < 0 and y falls, so w reaches 0, the next turning point",
    At(-y - e * w ** (1 + beta), {w: 0}),
    -y,
)
asserts(
    "The argument needs only N(w)/w -> 0, so it holds for sums with all alpha_i > 1, and fails for alpha = 1 with"
    " epsilon >= 2: there theta' = 1 - (epsilon/2) sin 2 theta has a zero",
    sympy.Eq(At(1 - e * sympy.sin(2 * theta) / 2, {theta: sympy.asin(2 / e) / 2}), 0, evaluate=False),
)
