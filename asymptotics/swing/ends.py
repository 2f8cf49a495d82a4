"""When no turning point follows, decided in balls: dry friction holds the mass, or the motion creeps home.

While y > 0 the orbit cannot turn, and it never reaches y = 0 once it is inside a trap, a region w <= c(y) that it
cannot leave (derivation ``creep``):

    one alpha < 1:   (w/c)^alpha <= y/epsilon with c^alpha = 2/(2 - alpha), while c^2 y^(2/alpha-2) < alpha^2/(2-alpha)
                     epsilon^(2/alpha);          alpha = 1, epsilon >= 2:  w <= y (epsilon + sqrt(epsilon^2 - 4))/2.

For small alpha this w is tiny beyond all bounds; but an orbit falls into the trap from any w up to
alpha y/(8(2-alpha))^(1/2), before y has lost alpha/4 of itself.  More terms only slow the motion down, so a trap of one
term is a trap of the sum.  ``None`` means: not proved here.

>>> from fractions import Fraction
>>> from asymptotics.numbers.exact import ExactReal
>>> law = Damping.of([(arb(1), ExactReal(Fraction(1, 2)))])
>>> trap(law, arb("0.1"), arb("0.001")), trap(law, arb("0.1"), arb("0.5")), trap(law, arb(0, 0.1), arb(0))
('creeps', None, None)
"""

from flint import arb

from asymptotics.swing.damping import Damping

STICKS, CREEPS, OVERDAMPED = "sticks", "creeps", "overdamped"


def may_trap(damping: Damping) -> bool:
    """Whether some term can hold the mass on one side at all: an exponent below 1, or a linear term of 2 or more."""
    return any(a < 1 or (not a > 1 and not e < 2) for a, e in zip(damping.alphas, damping.strengths))


def trap(damping: Damping, y: arb, w: arb) -> str | None:
    """Why y = 0 is never reached from any (y, w) in the two balls, or None if nothing proves it."""
    if not y > 0:
        return None
    w = abs(w).upper()
    for epsilon, alpha, a in zip(damping.strengths, damping.alphas, damping.exponents):
        if alpha < 1 and _slow(epsilon, a, y, w):
            return CREEPS
        linear = not alpha < 1 and not alpha > 1
        if linear and epsilon >= 2 and w <= y * (epsilon + (epsilon**2 - 4).nonnegative_part().sqrt()) / 2:
            return OVERDAMPED
    return None


def _slow(epsilon: arb, a: arb, y: arb, w: arb) -> bool:
    c = (2 / (2 - a)) ** (1 / a)
    inside = w <= a * y / (8 * (2 - a)).sqrt() or w**a <= c**a * y / epsilon
    return bool(inside) and bool(c**2 * y ** (2 / a - 2) < a**2 / (2 - a) * epsilon ** (2 / a))
