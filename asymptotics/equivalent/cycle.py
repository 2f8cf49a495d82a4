"""Equivalent damping of the motion itself: one full swing from rest at the amplitude, and its expansion with a bound.

From the turning points A_0, A_1, A_2 (``turning``, certified at any strength)

    decrement = ln(A_0/A_2),   Delta E = V(A_0) - V(A_2),   Q = 2 pi E/Delta E,
    zeta_log = decrement/sqrt(4 pi^2 + decrement^2)      (for viscous damping b/(2 sqrt(k m)) exactly),

and from their times the period T = t_2 - t_0 of the swing, and with it the backbone omega(A) = 2 pi/T.

*Order N.*  L = ln(A'/A) of a half-swing is cut after delta^N, with the bound of what it lacks
(``bounds.half_swing``).  Two half-swings are taken one after the other with these errors inside, so the ball holds the
decrement of the motion.

>>> law = Law({2: "1/10"})
>>> exact, cut = full_swing(law, 15), expanded_swing(law.terms, [arb("0.1")], 3)
>>> exact.decrement.str(8), cut.decrement.str(4)
('[0.23668442 +/- ...]', '[0.237 +/- ...]')
>>> exact.period.str(8)
'[6.2914675 +/- ...]'
>>> full_swing(Law({0: "2/5"}), 15)
'no full swing: it sticks after 1 half-swings'
"""

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb

from asymptotics.bounds.half_swing import disc, half_swing_series
from asymptotics.bounds.local import BITS
from asymptotics.equivalent.conservative_cycle import Spring
from asymptotics.errors import LimitError, UndecidedError
from asymptotics.law import Law
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import BITS_PER_DIGIT
from asymptotics.numbers.digits import ball_of
from asymptotics.running.budget import seconds_left
from asymptotics.terms import Term
from asymptotics.turning.choose import turning_points
from asymptotics.turning.result import TurningPoints


@dataclass(frozen=True)
class FullSwing:
    """One full swing from the amplitude 1: decrement, the share of the energy that it loses, and how long it takes in
    1/omega_0 (None of a series), as balls."""

    decrement: arb
    share: arb
    period: arb | None = None

    @property
    def zeta_log(self) -> arb:
        """The damping ratio decrement/sqrt(4 pi^2 + decrement^2)."""
        return self.decrement / ((2 * arb.pi()) ** 2 + self.decrement**2).sqrt()

    @property
    def quality(self) -> arb:
        """The quality factor 2 pi E/Delta E."""
        return 2 * arb.pi() / self.share


def full_swing(law: Law, digits: int) -> FullSwing | str:
    """The swing from rest at 1 by turning points of ``digits`` digits, or why there is none, in words."""
    try:
        found = turning_points(law, 3, digits, times=True)
    except (LimitError, UndecidedError):
        if seconds_left() <= 0:
            raise
        # Times cost more than places: without them there is no period, and all else stands.
        found = turning_points(law, 3, digits)
    if len(found.points) < 3:
        return _ended(found)
    text = found.points[2].x
    if text == "0":
        return "it stops at the centre"
    # Correctly rounded digits: the turning point is within half a unit of the last, which the ball holds.
    last = abs(ball_of(text))
    delta = [t.strength.ball() for t in law.terms]
    spring = Spring.of(law.terms, delta)
    share = 1 - spring.potential(last) / spring.potential(arb(1))
    time = found.points[2].tau
    return FullSwing(-last.log(), share, None if time is None else ball_of(time))


def swing_bits(bits: int) -> int:
    """The digits of the turning points for ``bits`` bits."""
    return int(bits / BITS_PER_DIGIT)


def _ended(found: TurningPoints) -> str:
    ended = found.ended or {"n": len(found.points) - 1, "reason": "ends"}
    return f"no full swing: it {ended['reason']} after {ended['n']} half-swings"


def expanded_swing(terms: Sequence[Term], delta: Sequence[arb], order: int) -> FullSwing | str:
    """The swing of order N with its bound inside the ball, or why none is proved, in words."""
    if not all(t.is_power_of_velocity for t in terms):
        return "a bound is proved for powers of the velocity beside the linear spring"
    try:
        return _expanded(terms, delta, order)
    # Order N is one column of a table: where no bound is proved it says why, and the others stand.
    except (UndecidedError, LimitError) as error:
        return str(error) if isinstance(error, UndecidedError) else error.reason


def _expanded(terms: Sequence[Term], delta: Sequence[arb], order: int) -> FullSwing:
    alphas = tuple(t.velocity for t in terms)
    _, radius = disc(alphas)
    # Upper ends, for the bound of ``half_swing_series`` is one on the polydisc.
    if not sum((arb(d.abs_upper()) for d in delta), arb(0)) < radius:
        raise UndecidedError(f"sum delta is not below {float(radius):.2g}, up to which the expansion is bounded")
    series = half_swing_series(alphas, order)
    with ctx.workprec(BITS):
        first = series.at(delta)
        # first holds L of the motion, tail included, so that this holds the strengths of the second half-swing.
        after = [d * (t.weight.ball() * first).exp() for d, t in zip(delta, terms)]
        decrement = -(first + series.at(after))
        if not decrement > 0:
            raise UndecidedError("the bound is larger than the decrement itself")
        # Powers of the velocity alone: V = A^2/2, and the share is 1 - (A_2/A_0)^2.
        return FullSwing(decrement, -(-2 * decrement).expm1())
