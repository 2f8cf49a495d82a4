"""The straightened losses x'(xi) |x(xi)|^m v|v|^(alpha-1), xi = sgn(x) sqrt(2 V(x)), as series in the strengths."""

from asymptotics.expansions.half_swings.forces import Forces, Given, Member
from asymptotics.series import Series


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
