"""Dry friction alone: what is decided exactly about its turning points, in any unit of length.

With the reach c of the friction, a half-swing towards smaller s x (s = +-1) is s x = c + R cos theta, so that it leads
from r to -(r - 2 c); the mass sticks at the first turning point with r_n = r_0 - 2 n c <= h, where h >= c is the reach
of the friction that holds it (Lelas 2024, section 2, has h = c).
"""

from asymptotics.errors import InputError
from asymptotics.numbers.exact import ExactReal, square_root


def half_swings_until(first: ExactReal, reach: ExactReal, hold: ExactReal) -> int:
    """The smallest n >= 0 with first - 2 n reach <= hold; InputError unless reach > 0.

    InputError also where first - hold needs two roots.

    >>> third = ExactReal(1) / 3
    >>> half_swings_until(ExactReal(1), third, third), half_swings_until(ExactReal(1), third, third / 2)
    (1, 2)
    """
    if not reach > 0:
        raise InputError("epsilon", f"{reach} never brings the mass to rest", "a positive number")
    excess = first - hold
    # Doubling and bisection over whole numbers, with exact comparisons: the count may be 10^30.
    low, high = -1, 0
    while excess > 2 * high * reach:
        low, high = high, 2 * high + 1
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if excess > 2 * middle * reach else (low, middle)
    return high


def amplitude_in_motion(place: ExactReal, reach: ExactReal, square: ExactReal) -> ExactReal | None:
    """R - c with R^2 = (s x0 - c)^2 + (v0/omega_0)^2, where the first half-swing ends; None unless R/c is rational.

    ``place`` is s x0 and ``square`` is (v0/omega_0)^2.  In units of c all is rational, whatever root the unit of length
    has, where x0/c and (v0/(omega_0 c))^2 are; None elsewhere.

    >>> amplitude_in_motion(ExactReal(1), ExactReal(1) / 5, ExactReal(9) / 25)
    ExactReal('4/5')
    >>> root = square_root(ExactReal(305).rational)                                # x0 = 7/5, v0 = 16/5 and c = 1
    >>> amplitude_in_motion(-7 / root, 5 / root, ExactReal(256) / 305)
    ExactReal('3/61*sqrt(305)')
    """
    try:
        p, q = place / reach, square / (reach * reach)
    except InputError:  # two roots, or c = 0
        return None
    if not (p.is_rational and q.is_rational):
        return None
    R = square_root((p.rational - 1) ** 2 + q.rational)
    return (R - 1) * reach if R.is_rational else None
