"""When no turning point follows, decided in balls: dry friction holds the mass, or the motion creeps home.

While y > 0 the orbit cannot turn, and it never reaches y = 0 once it is inside a trap, a trapping region w <= c(y) that
it cannot leave: a positively invariant region, on whose boundary the vector field points inwards (Nagumo 1942;
derivation ``creep``):

    one alpha < 1:   (w/c)^alpha <= y/epsilon with c^alpha = 2/(2 - alpha), while c^2 y^(2/alpha-2) < alpha^2/(2-alpha)
                     epsilon^(2/alpha);          alpha = 1, epsilon >= 2:  w <= y (epsilon + sqrt(epsilon^2 - 4))/2.

For small alpha this w is tiny beyond all bounds; but an orbit falls into the trap from any w up to
alpha y/(8(2-alpha))^(1/2), before y has lost alpha/4 of itself; and from any w at all down to a w_1 where N(w_1) > y,
while y loses at most w^2/(N(w_1) - y).  More terms only slow the motion down, so a trap of one
term is a trap of the sum; and while w <= V, as it is for V^2 = y^2 + w^2 by the energy, terms of exponents alpha_i <=
alpha together are at least (sum epsilon_i V^(alpha_i - alpha)) w^alpha.  ``None`` means: not proved here.

>>> from fractions import Fraction
>>> law = Damping.of([(arb(1), ExactReal(Fraction(1, 2)))])
>>> trap(law, arb("0.1"), arb("0.001")), trap(law, arb("0.1"), arb("0.5")), trap(law, arb(0, 0.1), arb(0))
('creeps', None, None)
>>> pair = Damping.of([(arb("0.2"), ExactReal(Fraction(k, 1000))) for k in (1, 2)])
>>> trap(pair, arb("0.35"), arb(0)), trap(pair, arb("0.41"), arb(0))
('creeps', None)
"""

from flint import arb

from asymptotics.flow.damping import Damping
from asymptotics.numbers.exact import ExactReal

CREEPS, OVERDAMPED = "creeps", "overdamped"


def may_trap(damping: Damping) -> bool:
    """Whether some term can hold the mass on one side at all: an exponent below 1, or a linear term of 2 or more."""
    # Never for exponents above 1 (derivation ``no-overdamping``).  A ball about 2 counts as possible: asking costs
    # little, and only ``trap`` proves.
    return any(a < 1 or (not a > 1 and not e < 2) for a, e in zip(damping.alphas, damping.strengths))


def trap(damping: Damping, y: arb, w: arb) -> str | None:
    """Why y = 0 is never reached from any (y, w) in the two balls, or None if nothing proves it."""
    if not y > 0:
        return None
    w = abs(w).upper()
    # The energy falls, so no later speed of this half-swing exceeds it.
    fastest = (y**2 + w**2).sqrt().upper()
    for epsilon, alpha, a in zip(damping.strengths, damping.alphas, damping.exponents):
        # Each term alone first: its trap does not depend on how fast the motion is, and adding terms keeps it.
        if alpha < 1 and (_creeps(damping, epsilon, a, y, w)):
            return CREEPS
        if alpha < 1 and _creeps(damping, _together(damping, alpha, a, fastest), a, y, w):
            return CREEPS
        linear = not alpha < 1 and not alpha > 1
        # The wedge below the fast eigenvector: on its edge w = c y, c^2 - epsilon c + 1 = 0 with the larger root, the
        # motion slides along.  At epsilon = 2, an exact number, c = 1, and what is below 0 under the root is rounding.
        if linear and epsilon >= 2 and w <= y * (epsilon + (epsilon**2 - 4).nonnegative_part().sqrt()) / 2:
            return OVERDAMPED
    return None


def _together(damping: Damping, alpha: ExactReal, a: arb, fastest: arb) -> arb:
    """The strength of w^alpha that the terms of exponents up to alpha have at least, at speeds up to ``fastest``."""
    laws = zip(damping.strengths, damping.alphas, damping.exponents)
    # b <= a, so that V^(b-a) w^a <= w^b while w <= V; a term of the same exponent keeps its strength without the
    # rounding of V^0.
    return sum((e if other == alpha else e * fastest ** (b - a) for e, other, b in laws if not other > alpha), arb(0))


def _creeps(damping: Damping, epsilon: arb, a: arb, y: arb, w: arb) -> bool:
    """Whether (y, w) is in the trap of one term, or falls into it; powers by their logarithms, for any alpha."""
    # power = ln C^alpha = -ln(1 - alpha/2), in the notation of the module's docstring; ``low`` is the speed from which
    # the motion falls in while y loses no more than alpha/4 of itself.
    power, ratio, low = -(-a / 2).log1p(), (y / epsilon).log(), a * y / (8 * (2 - a)).sqrt()
    # alpha times the logarithm of the condition on y; it goes on holding as y falls.
    if not 2 * (power + ratio - a * y.log()) < a * (a**2 / (2 - a)).log():
        return False
    if w <= low or a * w.log() <= power + ratio:
        return True
    # From further up: down to the speed low/2, from which the motion falls in at any place >= y/2, it loses
    # w^2/(N(low/2) - y) of its place, no more than y/2 if the last line holds.
    lower = (low / 2).lower()
    return bool(w**2 <= y / 2 * (damping.resistance(lower) - y))
