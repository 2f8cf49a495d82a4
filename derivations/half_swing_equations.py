"""From the equation of motion to the half-swing equations, for a sum of laws, in polar coordinates of the phase plane.

>>> print(derivation.steps[4].text())
Subs(-X'_tau*s + X_tau*c, (X_tau, X'_tau), (-r*s, -c*r + drag)) = -drag*s
"""

import sympy

from derivations.steps import At, Derivation, Solution

r, s, e, delta = sympy.symbols("r s epsilon delta", positive=True)
c, drag, X, velocity = sympy.symbols("c drag X X'", real=True)
epsilons = sympy.symbols("epsilon_1 epsilon_2", positive=True)
alphas = sympy.symbols("alpha_1 alpha_2", positive=True)
laws = tuple(zip(epsilons, alphas, strict=True))
tau, theta = sympy.symbols("tau theta", real=True)
diff, sin, cos = sympy.diff, sympy.sin, sympy.cos

derivation = Derivation(
    "half-swing-equations",
    "The half-swing without a small parameter",
    source="X'' + X + sum_i epsilon_i X'|X'|^(alpha_i - 1) = 0; theory page half_swing",
)
step = derivation.step


def on_circle(expression: sympy.Expr) -> sympy.Expr:
    """Replace c^2 by 1 - s^2, where c = cos(theta) and s = sin(theta)."""
    return sympy.expand(sympy.expand(expression).subs(c**2, 1 - s**2))


acceleration = -X - sum(b * velocity * sympy.Abs(velocity) ** (a - 1) for b, a in laws)
step(
    "The mirror image of a motion is a motion: X'' changes sign with (X, X'), so one half-swing tells all",
    At(acceleration, {X: -X, velocity: -velocity}),
    -acceleration,
)
friction = sum(b * (r * s) ** a for b, a in laws)
step(
    "X = r cos(theta), X' = -r sin(theta), 0 <= theta <= pi: X' <= 0, |X'| = r s, and X'' = drag - X with the drag",
    At(acceleration + X, {X: r * c, velocity: -r * s}),
    friction,
)
radius, angle = sympy.Function("r")(tau), sympy.Function("theta")(tau)
x_of, v_of = radius * cos(angle), -radius * sin(angle)
step(
    "Rotating (dX, dX') by theta: c dX/d tau - s dX'/d tau is the radial rate",
    cos(angle) * sympy.Derivative(x_of, tau) - sin(angle) * sympy.Derivative(v_of, tau),
    diff(radius, tau),
)
step(
    "and -s dX/d tau - c dX'/d tau is r d theta/d tau",
    -sin(angle) * sympy.Derivative(x_of, tau) - cos(angle) * sympy.Derivative(v_of, tau),
    radius * diff(angle, tau),
)
angle_rate = (-s * (-r * s) - c * (drag - r * c)) / r
x_rate, v_rate = sympy.symbols("X_tau X'_tau", real=True)
step(
    "With dX/d tau = -r s and dX'/d tau = drag - r c, the radius falls at the rate",
    At(c * x_rate - s * v_rate, {x_rate: -r * s, v_rate: drag - r * c}),
    -s * drag,
)
step(
    "and the angle, with c^2 + s^2 = 1",
    At(sympy.expand(angle_rate), {c**2: 1 - s**2}),
    1 - c * drag / r,
)

rho = [b * r ** (a - 1) for b, a in laws]
N, rhos = sympy.Symbol("N", real=True), sympy.symbols("rho_1 rho_2", positive=True)
step(
    "With the local strengths rho_i = epsilon_i r^(alpha_i-1): drag/r = N = sum_i rho_i s^alpha_i",
    At(friction / r, {b: p * r ** (1 - a) for (b, a), p in zip(laws, rhos, strict=True)}),
    sum(p * s**a for (_, a), p in zip(laws, rhos, strict=True)),
)
log_rate = -N * s / (1 - N * c)
step(
    "Hence, one rate over the other, d ln r/d theta = -N s/D with D = 1 - N c",
    At((-s * drag / r) / (1 - c * drag / r), {drag: r * N}),
    log_rate,
)
grown = sympy.Symbol("R_theta", real=True)
step(
    "d tau/d theta = 1/D = 1 + c N/D is 1 - cot(theta) R_theta with that rate R_theta of ln r",
    At(1 - c / s * grown, {grown: log_rate}),
    1 / (1 - N * c),
)
for p, (_, a) in zip(rho, laws, strict=True):
    step(
        "and d ln rho_i/d ln r = alpha_i - 1: no parameter is left but the starting values rho_i(0) = delta_i",
        sympy.Derivative(p, r) * r / p,
        a - 1,
    )

# The two exactly solvable laws.
primitive = sympy.atan((2 * sympy.tan(theta) - e) / sympy.sqrt(4 - e**2)) * 2 / sympy.sqrt(4 - e**2)
step(
    "alpha = 1, epsilon < 2: 1/D = 1/(1 - epsilon s c) is the derivative of (2/sqrt(4 - e^2)) atan((2 tan(theta) - e)/"
    "sqrt(4 - e^2))",
    sympy.Derivative(primitive, theta) * (1 - e * sin(theta) * cos(theta)),
    sympy.Integer(1),
)
step(
    "whose argument runs once through all reals between two turning points: T = pi/sqrt(1 - epsilon^2/4)",
    2 / sympy.sqrt(4 - e**2) * (sympy.Limit(sympy.atan(X), X, sympy.oo) - sympy.Limit(sympy.atan(X), X, -sympy.oo)),
    sympy.pi / sympy.sqrt(1 - e**2 / 4),
)
x_0, v_0 = delta + (1 - delta) * cos(tau), -(1 - delta) * sin(tau)
circle = sympy.Derivative(x_0, (tau, 2)) + x_0, delta
step("alpha = 0: X'' + X = delta, a circle about X = delta of radius 1 - delta", *circle)
step(
    "on it r dr/d tau = X X' + X' X'' = delta X', the work of the drag",
    sympy.Derivative((x_0**2 + v_0**2) / 2, tau),
    delta * v_0,
)
step(
    "at the passage X = 0 the speed squared, (1 - delta)^2 (1 - c^2), is 1 - 2 delta: R = ln(1 - 2 delta)/2",
    At((1 - delta) ** 2 * (1 - c**2), {c: Solution(delta + (1 - delta) * c, 0, c)}),
    1 - 2 * delta,
)
