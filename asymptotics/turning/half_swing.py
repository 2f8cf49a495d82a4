"""One half-swing at any strength as a result object, by local expansions and Taylor steps in balls.

>>> from asymptotics.numbers.exact import parse_real
>>> strong = half_swing_result([parse_real("3", "--alpha")], [parse_real("5", "--delta")], 12)
>>> strong.amplitude, strong.route
('0.258718608103', 'local expansions and Taylor steps')
>>> half_swing_result([parse_real("1", "--alpha")], [parse_real("1/1000", "--delta")], 12).route
'closed form about the shifted centre'
"""

from collections.abc import Sequence
from dataclasses import replace

from flint import arb

from asymptotics.errors import InputError, LimitError
from asymptotics.expansions.half_swings.half_swing_value import (
    HalfSwingAt,
    HalfSwingValue,
    certified_swing,
    require_strengths,
)
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.linear import ROUTE as CLOSED
from asymptotics.flow.linear_spring.trapping_regions import CREEPS, OVERDAMPED
from asymptotics.flow.sequence import STICKS, turning_by_pieces
from asymptotics.flow.taylor import GUARD
from asymptotics.flow.turning import at_rest
from asymptotics.flow.wells.even_well import EvenWell
from asymptotics.flow.wells.force import WellForce
from asymptotics.flow.wells.trapping_regions import inside
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal
from asymptotics.return_map.half_swing_map import INTEGRATED, integrated
from asymptotics.terms import Term

# A limit of work: stronger motions are stiff.
MAX_DELTA = 1000
_ENDS = {STICKS: "sticks there", CREEPS: "creeps from there on", OVERDAMPED: "is overdamped"}


def half_swing_result(alphas: Sequence[ExactReal], delta: Sequence[ExactReal], digits: int = 30) -> HalfSwingAt:
    """The half-swing from the local strengths delta_i >= 0, to ``digits`` digits.

    InputError for a negative strength, a wrong number of them, or where no turning point follows (it sticks or creeps).
    """
    require_strengths(alphas, delta)
    for d in delta:
        if d > MAX_DELTA:
            raise LimitError("delta", f"{d} is out of range: the motion is too stiff", f"strengths up to {MAX_DELTA}")

    if all(a.is_zero for a in alphas):
        _require_passing(delta)

    def evaluate(bits: int) -> HalfSwingValue:
        # The linear spring alone: exact, and without a law to follow.
        if all(d.is_zero for d in delta):
            return HalfSwingValue(arb(0), arb(1), arb.pi(), CLOSED, 0, arb(0))
        balls = [d.ball() for d in delta]
        found = integrated(Damping.of(list(zip(balls, alphas, strict=True))), arb(1))
        if found.amplitude is None or found.duration is None:
            how = _ENDS[str(found.ended)]
            raise InputError("delta", f"no turning point follows: the motion {how}", "a smaller delta")
        return HalfSwingValue(
            found.amplitude.log(), found.amplitude, found.duration, found.route, found.terms, found.tail
        )

    return certified_swing(alphas, delta, digits, evaluate)


def half_swing_of_terms(terms: Sequence[Term], delta: Sequence[ExactReal], digits: int = 30) -> HalfSwingAt:
    """The half-swing under any terms, springs and losses that depend on the place included, at the strengths delta_i.

    delta_i = epsilon_i A^(degree - 1), and A^2 for a pendulum; that of a spring may be negative.  InputError as
    ``half_swing_result``, and for an amplitude outside the well or a spring that depends on the velocity.

    >>> from asymptotics.law import Law
    >>> numbers = [ExactReal(1) / 10, ExactReal(4)]
    >>> half_swing_of_terms(Law({"3/2": 1}, spring="pendulum").terms, numbers, 12).amplitude
    '0.821261485993'
    """
    if all(t.is_power_of_velocity for t in terms):
        return half_swing_result([t.velocity for t in terms], delta, digits)
    _require_in_range(terms, delta)

    def evaluate(bits: int) -> HalfSwingValue:
        # The Taylor coefficients are computed with so many bits more: the force should carry them.
        with ctx.workprec(bits + GUARD):
            force = WellForce.of(terms, [d.ball() for d in delta])
        # An amplitude at the very edge, which balls cannot tell, is refused as well.
        if inside(force, arb(1)) is not True:
            raise InputError("delta", "the amplitude lies outside the well, where V' > 0 fails", "a smaller amplitude")
        found, pieces = turning_by_pieces(EvenWell(force), at_rest(arb(1)))
        # A stop before the centre has an amplitude <= 0: ln(A'/A) does not exist there.
        if isinstance(found, str) or not found.amplitude > found.amplitude_error:
            how = _ENDS[found] if isinstance(found, str) else "stops before the centre"
            raise InputError("delta", f"no turning point follows: the motion {how}", "a smaller delta")
        q, T = arb(found.amplitude, found.amplitude_error), arb(found.time, found.time_error)
        return HalfSwingValue(q.log(), q, T, INTEGRATED, pieces, found.amplitude_error)

    losses = [t.velocity for t in terms if t.sign < 0]
    made = certified_swing(losses, delta, digits, evaluate)
    return replace(made, forces=tuple(t.shape() for t in terms))


def _require_passing(delta: Sequence[ExactReal]) -> None:
    """Dry friction alone: A'/A = 1 - 2 delta, and from 1/2 on the mass stops at the centre or before it."""
    total = sum(delta, ExactReal(0))
    # Exact numbers, because no ball tells delta = 1/2 from its neighbours.
    if total == ExactReal(1) / 2:
        reason = "A'/A = 0, T = pi: the mass stops at the centre, and ln(A'/A) does not exist"
        raise InputError("delta", reason, "below 1/2")
    if total > ExactReal(1) / 2:
        where = "where it is" if total >= 1 else "before the centre"
        raise InputError("delta", f"no turning point follows: the mass sticks {where}", "below 1/2")


def _require_in_range(terms: Sequence[Term], delta: Sequence[ExactReal]) -> None:
    if len(delta) != len(terms):
        raise InputError("delta", f"{len(delta)} strengths for {len(terms)} forces", "one strength for each force")
    for t, d in zip(terms, delta, strict=True):
        if (t.sign < 0 or t.family) and d < 0:
            raise InputError("delta", f"{d} is negative for {t.shape()}", "strengths >= 0 of losses and pendulums")
        if abs(d) > MAX_DELTA:
            raise LimitError("delta", f"{d} is out of range: the motion is too stiff", f"strengths up to {MAX_DELTA}")
