"""Linear damping next to its critical strength, beside other laws: a half-swing lingers, and its far end is tiny.

With epsilon the sum of the linear strengths, epsilon < 2, and every other alpha_i > 1 (or dry friction), a motion that
has become small obeys the linear equation about its place of rest: it needs the time T = pi/sqrt(1 - epsilon^2/4), and
its amplitude falls by the factor exp(-T epsilon/2).  So the next turning point is known only if T epsilon/(2 ln 2) bits
more are carried, from the start on.

With exponents next to 1 that are not all 1, a creep fades like e^(-rate tau) while its errors only add: it loses
rate/ln 2 bits per unit of time (``fading``).  A motion that turns keeps its relative errors but for the factors g of
``error_propagation.ratio_growth`` (``faded_bits``).  All these are estimates: they choose a precision, or refuse the
work; they claim nothing.

>>> from asymptotics.law import Law
>>> near = Law({1: "1.99", 2: "1/10"})
>>> round(longest_half_swing(near), 1), lost_bits(near)
(31.5, 46)
>>> lost_bits(Law({1: "1/2", 2: "1/10"})), lost_bits(Law({1: 2, 2: 1}))
(0, 0)
"""

from fractions import Fraction
from math import ceil, exp, expm1, inf, log, log1p, pi, sqrt

from flint import arb

from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.linear import is_linear
from asymptotics.law import Law
from asymptotics.numbers.context import ctx, lru_cache
from asymptotics.running.budget import require_seconds

# 2.5 times pi: shorter half-swings lose at most 12 bits.
_LONG = 8.0  # times below it need no care
# Rough, and for the refusal of hopeless work alone: a wrong one refuses too early or too late.  Five half-swings that
# linger took 1.7 s where these say 1.5 (``benchmarks/constants.json``).
_SECONDS, _PER_TIME, _BITS = 0.003, 6.0, 200  # of a Taylor step at so many bits; steps per unit of time
# It decides whether bits are carried from the start, and claims nothing: 1e-4 costs a fifth more at 1 + 1/2000, 1e-2
# two thirds more at 1 + 1/200 (``benchmarks/constants.json``).
_NEAR_LINEAR = 1e-3  # alpha - 1
_NEXT_TO_1, _TRAPPED = 1 / 64, 2.0  # |alpha - 1|, and the local strength above which a motion creeps
_LOST = 1.45  # bits per unit of time, a little above 1/ln 2
_PARTS = 64  # of the time in which relative errors grow
_TINY, _LARGE = 1e-15, 700.0  # what doubles tell from 0, and whose exponential they hold


@lru_cache(maxsize=64)
def longest_half_swing(law: Law) -> float:
    """About the longest half-swing under such a law, 0 where it is short, in closed form, or there is none."""
    # epsilon may be an exact number as near to 2 as 2 - 10^-500, and the time is pi over the root of what is left.
    with ctx.workprec(2000):
        damping = Damping.of_law(law)
        total = sum((e for e, a in zip(damping.strengths, damping.alphas) if not a < 1 and not a > 1), arb(0))
        if len(damping.alphas) == 1 and damping.alphas[0] > 1 and not damping.friction > 0:
            time = _nearly_linear(damping)
            return time if time > _LONG else 0.0
        gap = 1 - total**2 / 4
        if is_linear(damping) or any(a < 1 for a in damping.alphas) or not gap > 0:
            return 0.0
        time = float(arb.pi() / gap.sqrt())
    return time if time > _LONG else 0.0


def _nearly_linear(damping: Damping) -> float:
    """With alpha just above 1 the motion turns only when the local strength epsilon w^(alpha-1) is below 2.

    From epsilon >= 2 it takes int (e + sqrt(e^2 - 4))/(2 e) de/(alpha - 1) from 2 to epsilon to get there: w falls at
    the slow rate of each strength e.  From then on the strength is about
    2 - 2 (alpha - 1) t, and the angle int sqrt(2 (alpha - 1) t) dt is pi after (9 pi^2/(8 (alpha - 1)))^(1/3); below 2
    a half-swing lasts at most that, and at most pi/sqrt(1 - epsilon^2/4).
    """
    above, epsilon = (damping.alphas[0] - 1).ball(), damping.strengths[0]
    if not above < _NEAR_LINEAR:
        return 0.0
    # The time for the angle pi at the strength 2 - 2 (alpha-1) t, and omega^2 at the initial strength.
    slow, gap = (9 * arb.pi() ** 2 / (8 * above)).root(3), 1 - epsilon**2 / 4
    if gap > 0:
        return float(slow.min(arb.pi() / gap.sqrt()))
    root = (epsilon**2 - 4).nonnegative_part().sqrt()
    return float((epsilon - 2 + root - 2 * (root / 2).atan()) / (2 * above) + slow)


def lost_bits(law: Law) -> int:
    """How many bits a half-swing loses."""
    return ceil(_LOST * longest_half_swing(law))


def lost_until(law: Law, tau: float) -> int:
    """How many bits the motion loses up to the time tau, 0 where half-swings are short and errors fade with it.

    While it certainly creeps no more than at the rate of the local strength at the end.

    >>> lost_until(Law({"1.0000000001": 4}), 300), lost_until(Law({"1.001": 4}), 1000)
    (116, 1450)
    """
    if not longest_half_swing(law) > 0:
        return faded_bits(law, tau)
    total, above, _ = _next_to_1(law)
    # The local strength epsilon w^(alpha-1) after the time tau, at the least.
    end = total * exp(-above * tau)  # w falls like e^-tau at the most
    rate = _rate(end) if end > _TRAPPED else inf
    return ceil(min(_LOST * tau, rate / log(2) * tau))


def fading(law: Law) -> tuple[float, float]:
    """(rate, longest): how fast and how long a motion creeps away from its errors; (0, 0) where it does not.

    ``rate``: (epsilon - sqrt(epsilon^2 - 4))/2 for the local strength epsilon >= 2 of the exponents next to 1;
    ``longest``: until a strength that falls reaches 2.

    >>> fading(Law({"1.001": 3})), fading(Law({1: 2, "0.999": 1})), fading(Law({"0.999": 1}))
    ((0.38..., 1061.5...), (0.38..., inf), (0.0, 0.0))
    """
    total, above, below = _next_to_1(law)
    if above <= 0 >= below or total < _TRAPPED:
        return 0.0, 0.0
    rate = _rate(total)
    return rate, inf if below > 0 else log(total / _TRAPPED) / (above * rate)


def _rate(strength: float) -> float:
    """(epsilon - sqrt(epsilon^2 - 4))/2."""
    # (epsilon - sqrt(epsilon^2 - 4))/2 without cancellation: the slow eigenvalue of the overdamped linear equation.
    return 2 / (strength + sqrt(strength**2 - 4))


def _next_to_1(law: Law) -> tuple[float, float, float]:
    """(strength, how far above 1, how far below 1) of the exponents next to 1.

    Zeros if an exponent is lower: then one below 1 rules what is small.
    """
    damping = Damping.of_law(law)
    if damping.friction > 0 or any(a < 1 - Fraction(_NEXT_TO_1) for a in damping.alphas):
        return 0.0, 0.0, 0.0
    near = [(a, float(e)) for a, e in zip(damping.alphas, damping.strengths) if a < 1 + Fraction(_NEXT_TO_1)]
    offs = [float(a.ball() - 1) for a, _ in near]
    return sum(e for _, e in near), max(offs, default=0.0), -min(offs, default=0.0)


def faded_bits(law: Law, tau: float) -> int:
    """How many bits a motion with exponents next to 1 has lost at the time tau.

    While it turns, half-swings of the time T and the decrement s = epsilon T/2 take log2 g each, g = 1 + h (e^s - 1) <=
    e^s with h = 1 - min alpha_i, and the last one, by pieces, s/ln 2; epsilon obeys d epsilon/dtau = h epsilon^2/2.

    >>> faded_bits(Law({"0.999": 1}), 60), faded_bits(Law({"0.999": 1}), 1e9), faded_bits(Law({1: 3, "0.999": 1}), 60)
    (3, 92, 24)
    """
    rate, longest = fading(law)
    if rate:
        return ceil(rate * min(tau, longest) / log(2))
    total, _, below = _next_to_1(law)
    if below <= 0 or not 0 < total < _TRAPPED:
        return 0
    part = min(tau, turning(law)) / _PARTS
    slowest, lost, s = (9 * pi**2 / (8 * below)) ** (1 / 3), 0.0, 0.0
    for i in range(_PARTS):
        # The solution of d epsilon/dtau = h epsilon^2/2, at the middle of each of the 64 parts; ``turning`` ends where
        # it reaches 2.
        epsilon = 1 / (1 / total - below * (i + 0.5) * part / 2)
        swing = min(pi / sqrt(max(1 - epsilon**2 / 4, _TINY)), slowest)
        s = epsilon * swing / 2
        lost += part / swing * min(s, log1p(below * expm1(min(s, _LARGE))))
    return ceil((lost + min(s, tau)) / log(2))


def turning(law: Law) -> float:
    """How long a motion with exponents next to 1 turns: until the local strength reaches 2, inf where it never does.

    >>> round(turning(Law({"0.999": 1})), 9), turning(Law({"0.999": 3})), turning(Law({1: 1, "1.001": 1}))
    (1000.0, 0.0, inf)
    """
    total, _, below = _next_to_1(law)
    return max(0.0, 2 * (1 / total - 1 / _TRAPPED) / below) if total > 0 and below > 0 else inf


def creeping(law: Law) -> float:
    """How long a motion with exponents next to 1 creeps from the start on, 0 where it turns."""
    return fading(law)[1]


def creeping_seconds(law: Law, tau: float, bits: int) -> float:
    """What such a creep costs until tau, at ``bits`` bits: Taylor steps, half as many as where a half-swing lingers."""
    return _PER_TIME / 2 * min(tau, creeping(law)) * _SECONDS * (bits / _BITS) ** 2


def longest_half_swing_seconds(law: Law, swings: int, bits: int, within: float = inf) -> float:
    """What ``swings`` half-swings that linger cost in addition, at ``bits`` and more, up to the time ``within``."""
    time = min(longest_half_swing(law), within)
    if time == 0:
        return 0.0
    step = _SECONDS * ((bits + _LOST * time) / _BITS) ** 2
    return min(swings, _most(law)) * _PER_TIME * max(time - pi, 0.0) * step


def require_brief(law: Law, swings: int, digits: int, bits: int) -> None:
    """LimitError at once where the budget does not allow ``swings`` half-swings that linger, at ``bits`` and more."""
    time = longest_half_swing(law)
    if time == 0:
        return
    work = (
        f"next to critical damping, where one half-swing lasts about {time:.3g}, {swings} of them with {digits} digits"
    )
    require_seconds(longest_half_swing_seconds(law, swings, bits), work)


def _most(law: Law) -> float:
    """How many half-swings dry friction leaves at most, about."""
    friction = sum((float(t.strength.ball()) for t in law.terms if t.velocity.is_zero), 0.0)
    # Each half-swing loses twice the friction, from an amplitude of 1.
    return 1 + 0.5 / friction if friction > 0 else inf


def most_swings(law: Law) -> float:
    """About how many half-swings a term with alpha < 1 leaves: then the motion sticks, or creeps for all times.

    >>> most_swings(Law({"1/2": "1/5"})), most_swings(Law({"3/2": "1/5"}))
    (13.0, inf)
    """
    # A' = -M epsilon A^alpha ends at the time 1/((1 - alpha) M epsilon), M pi > 1 a half-swing; three more for what the
    # average leaves out.
    slow = [(float(t.velocity.ball()), float(t.strength.ball())) for t in law.terms if t.velocity < 1]
    return min((3 + 1 / ((1 - a) * e) if (1 - a) * e > 0 else inf for a, e in slow), default=inf)
