"""Linear damping next to its critical strength, beside other laws: a half-swing lingers, and its far end is tiny.

With epsilon the sum of the linear strengths, epsilon < 2, and every other alpha_i > 1 (or dry friction), a motion that
has become small obeys the linear equation about its place of rest: it needs the time T = pi/sqrt(1 - epsilon^2/4), and
its amplitude falls by the factor exp(-T epsilon/2).  So the next turning point is known only if T epsilon/(2 ln 2) bits
more are carried, from the start on.

With exponents next to 1 that are not all 1, a motion fades like e^(-rate tau) while its errors only add: the known
contractions ask for exponents >= 1 and a turning point ahead.  So it loses rate/ln 2 bits per unit of time (``fading``,
``faded_bits``).  All these are estimates: they choose a precision, or refuse the work; they claim nothing.

>>> from asymptotics.law import Law
>>> near = Law({1: "1.99", 2: "1/10"})
>>> round(lingering(near), 1), lost_bits(near), lost_bits(Law({1: "1/2", 2: "1/10"})), lost_bits(Law({1: 2, 2: 1}))
(31.5, 46, 0, 0)
"""

from fractions import Fraction
from math import ceil, inf, log, pi, sqrt

from flint import arb

from asymptotics.budget import require_seconds
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.linear import is_linear
from asymptotics.law import Law
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal

_LONG = 8.0  # times below it need no care
_SECONDS, _PER_TIME, _BITS = 0.003, 6.0, 200  # of a Taylor step at so many bits; steps per unit of time
_NEAR_LINEAR = 1e-3  # alpha - 1
_NEXT_TO_1, _TRAPPED = 1 / 64, 2.0  # |alpha - 1|, and the local strength above which a motion creeps
_LOST = 1.45  # bits per unit of time, a little above 1/ln 2


def lingering(law: Law) -> float:
    """About the longest half-swing under such a law, 0 where it is short, in closed form, or there is none."""
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
    slow, gap = (9 * arb.pi() ** 2 / (8 * above)).root(3), 1 - epsilon**2 / 4
    if gap > 0:
        return float(slow.min(arb.pi() / gap.sqrt()))
    root = (epsilon**2 - 4).nonnegative_part().sqrt()
    return float((epsilon - 2 + root - 2 * (root / 2).atan()) / (2 * above) + slow)


def lost_bits(law: Law) -> int:
    """How many bits a half-swing loses."""
    return ceil(_LOST * lingering(law))


def lost_until(law: Law, tau: float) -> int:
    """How many bits the motion loses up to the time tau, 0 where half-swings are short and errors fade with it."""
    return ceil(_LOST * tau) if lingering(law) > 0 else faded_bits(law, tau)


def fading(law: Law) -> tuple[float, float]:
    """(rate, longest): how fast and how long a motion fades away from its errors; (0, 0) where it does not.

    ``rate``: epsilon/2 for the local strength epsilon < 2 of the exponents next to 1, and (epsilon -
    sqrt(epsilon^2 - 4))/2 for a creep; ``longest``: until a strength that grows reaches 2, or one that falls.

    >>> fading(Law({"0.999": 1})), fading(Law({1: 1, 2: 1})), fading(Law({"1/2": 1}))
    ((0.5, 1386.2...), (0.0, 0.0), (0.0, 0.0))
    """
    near = [(float(a.ball() - 1), float(e)) for a, e in _next_to_1(law)]
    total = sum(e for _, e in near)
    above, below = max((d for d, _ in near), default=0.0), -min((d for d, _ in near), default=0.0)
    if above <= 0 >= below or total == 0 or (total < _TRAPPED and below <= 0):
        return 0.0, 0.0
    rate = total / 2 if total < _TRAPPED else 2 / (total + sqrt(total**2 - 4))
    if total < _TRAPPED:
        return rate, log(_TRAPPED / total) / (below * rate)
    return rate, inf if below > 0 else log(total / _TRAPPED) / (above * rate)


def _next_to_1(law: Law) -> list[tuple[ExactReal, arb]]:
    """(alpha, epsilon) of the exponents next to 1, if no exponent is lower: then one below 1 rules what is small."""
    damping = Damping.of_law(law)
    if damping.friction > 0 or any(a < 1 - Fraction(_NEXT_TO_1) for a in damping.alphas):
        return []
    return [(a, e) for a, e in zip(damping.alphas, damping.strengths) if a < 1 + Fraction(_NEXT_TO_1)]


def faded_bits(law: Law, tau: float) -> int:
    """How many bits a motion with exponents next to 1 has lost at the time tau."""
    rate, longest = fading(law)
    return ceil(rate * min(tau, longest) / log(2)) if rate else 0


def creeping(law: Law) -> float:
    """How long a motion with exponents next to 1 creeps from the start on, 0 where it turns."""
    return fading(law)[1] if sum(float(e) for _, e in _next_to_1(law)) >= _TRAPPED else 0.0


def creeping_seconds(law: Law, tau: float, bits: int) -> float:
    """What such a creep costs until tau, at ``bits`` bits: Taylor steps, half as many as where a half-swing lingers."""
    return _PER_TIME / 2 * min(tau, creeping(law)) * _SECONDS * (bits / _BITS) ** 2


def lingering_seconds(law: Law, swings: int, bits: int, within: float = inf) -> float:
    """What ``swings`` half-swings that linger cost in addition, at ``bits`` and more, up to the time ``within``."""
    time = min(lingering(law), within)
    if time == 0:
        return 0.0
    step = _SECONDS * ((bits + _LOST * time) / _BITS) ** 2
    return min(swings, _most(law)) * _PER_TIME * max(time - pi, 0.0) * step


def require_brief(law: Law, swings: int, digits: int, bits: int) -> None:
    """LimitError at once where the budget does not allow ``swings`` half-swings that linger, at ``bits`` and more."""
    time = lingering(law)
    if time == 0:
        return
    work = (
        f"next to critical damping, where one half-swing lasts about {time:.3g}, {swings} of them with {digits} digits"
    )
    require_seconds(lingering_seconds(law, swings, bits), work)


def _most(law: Law) -> float:
    """How many half-swings dry friction leaves at most, about."""
    friction = sum((float(t.strength.ball()) for t in law.terms if t.velocity.is_zero), 0.0)
    return 1 + 0.5 / friction if friction > 0 else inf


def most_swings(law: Law) -> float:
    """About how many half-swings a term with alpha < 1 leaves: then the motion sticks, or creeps for all times.

    >>> most_swings(Law({"1/2": "1/5"})), most_swings(Law({"3/2": "1/5"}))
    (13.0, inf)
    """
    slow = [(float(t.velocity.ball()), float(t.strength.ball())) for t in law.terms if t.velocity < 1]
    return min((3 + 1 / ((1 - a) * e) if (1 - a) * e > 0 else inf for a, e in slow), default=inf)
