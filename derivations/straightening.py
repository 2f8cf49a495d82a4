"""Straightening: any even well is a linear spring in xi = sgn(x) sqrt(2 V(x)), with losses that depend on the place.

>>> print(derivation.steps[1].text())
sqrt(2)*Derivative(V(x), x)/(2*sqrt(V(x))) = Derivative(sqrt(2)*sqrt(V(x)), x)
"""

import sympy

from asymptotics.expansions.half_swings.exact import exact_half_swing
from asymptotics.expansions.half_swings.forces import Forces, Given, Member
from asymptotics.series import Series
from asymptotics.terms import Term
from derivations.steps import At, Derivation, defined

x, h, xi, c, A = sympy.symbols("x h xi c A", positive=True)
V = sympy.Function("V", positive=True)(x)
root = sympy.sqrt(2 * V)

derivation = Derivation(
    "straightening",
    "Every even potential is a linear spring in its own coordinate",
    source="asymptotics.expansions.straightening",
)
step, asserts = derivation.step, derivation.asserts

step("For x > 0 put xi = sqrt(2 V): xi xi' = V'", root * sympy.Derivative(root, x), sympy.Derivative(V, x))
step("so that xi'(x) is", sympy.Derivative(V, x) / root, sympy.Derivative(root, x))
slope = sympy.Derivative(root, x)
step(
    "With d sigma = xi' dt: d xi/d sigma = v, and d v/d sigma = (-V' - h)/xi' is linear but for the loss",
    (-sympy.Derivative(V, x) - h) / slope,
    -root - h / slope,
)
step(
    "Pendulum, V = 1 - cos x, the integral of the force: xi^2 = 2 V is (2 sin(x/2))^2",
    2 * sympy.Integral(sympy.sin(h), (h, 0, x)),
    4 * sympy.sin(x / 2) ** 2,
)
step(
    "x = 2 arcsin(xi/2) has the slope (1 - xi^2/4)^(-1/2)",
    sympy.Derivative(2 * sympy.asin(xi / 2), xi),
    1 / sympy.sqrt(1 - xi**2 / 4),
)
step(
    "Duffing, V = x^2/2 + c x^4/4, at the turning point: xi_A^2",
    At(2 * (x**2 / 2 + c * x**4 / 4), {x: A}),
    A**2 * (1 + c * A**2 / 2),
)

# The theorem on the engine: the same turning amplitudes, after the relabelling A -> xi_A.
ORDER = 4


def coordinate(given: Given, order: int) -> Series:
    """X = x/xi as a series in the strengths of the springs at the amplitude xi."""
    forces = Forces.read(given, order)
    v, grading = forces.potential(order), forces.exact_grading()
    log = Series({}, forces.variables, order)
    for _ in range(order):
        log = v.compose(grading.strengths(log)).log() / -2
    return log.exp()


def slope(given: Given, order: int) -> Series:
    """x'(xi) as a series in the strengths of the springs at the amplitude xi: the clock dt = x'(xi) dsigma."""
    forces = Forces.read(given, order)
    X = coordinate(forces, order)
    return X + forces.exact_grading().weighted(X)


def straighten(given: Given, order: int) -> Forces:
    """The losses x'(xi) |x(xi)|^m v|v|^(alpha-1) through ``order``, without springs: the same turning amplitudes in xi.

    The strengths are those of the original forces at the amplitude xi.  Raises InputError for a spring that depends on
    the velocity.
    """
    forces = Forces.read(given, order)
    X, clock = coordinate(forces, order), slope(forces, order)
    members = []
    for m in forces.through(order):
        if m.sign > 0:
            continue
        factor = (clock * X**m.position).truncate(order - m.order)
        for key, c in factor.coefficients.items():
            place = m.position + int(sum(n * w.rational for n, w in zip(key, forces.weights) if n))
            joint = tuple(a + b for a, b in zip(key, m.key))
            members.append(Member(joint, c * m.ratio, m.velocity, place, m.sign))
    return Forces(forces.weights, forces.signs, forces.velocities, tuple(members))


def defect(forces: Forces, straight: Forces) -> sympy.Expr:
    """The first coefficient in which L in xi differs from the L of the straightened loss, or 0."""
    log = forces.potential(ORDER).log() / 2
    swing = exact_half_swing(forces, ORDER)
    there = exact_half_swing(straight, ORDER).L.compose(forces.exact_grading().strengths(log))
    off = (swing.L + log.compose(swing.F) - log - there).coefficients.values()
    return next((y.to_sympy() for y in off if y != 0), sympy.Integer(0))


pendulum = Forces.read([Term(1, 2), Term(1, 0, 3, "position", "pendulum")], ORDER)
duffing = Forces.read([Term(1, 1), Term(1, 0, 3, "position")], ORDER)
for name, forces in (("a pendulum with quadratic loss", pendulum), ("a Duffing oscillator with linear loss", duffing)):
    off = defined("d", lambda order, forces=forces: defect(forces, straighten(forces, int(order))))
    step(f"{name}: d(n), the first coefficient in which the two half-swings differ through order n", off(ORDER), 0)
bare = Forces(pendulum.weights, pendulum.signs, pendulum.velocities, pendulum.members[:1])
off = defined("d", lambda order: defect(pendulum, bare))
asserts("Without the factor x'(xi) they do", sympy.Ne(off(ORDER), 0, evaluate=False))
