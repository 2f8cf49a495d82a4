"""One half-swing at any strength as a result object: by the series of the quarter-swing where delta is small, else by
local expansions and Taylor steps; both are enclosures.

>>> from asymptotics.numbers.exact import parse_real
>>> strong = half_swing_result([parse_real("3", "--alpha")], [parse_real("5", "--delta")], 12)
>>> strong.amplitude, strong.route
('0.258718608103', 'local expansions and Taylor steps')
>>> half_swing_result([parse_real("3", "--alpha")], [parse_real("1/1000", "--delta")], 12).route
'series of the quarter-swing'
"""

from collections.abc import Sequence

from flint import arb

from asymptotics.errors import InputError, LimitError
from asymptotics.half_swings.finite import SwingValue, finite_quarter, series_reach
from asymptotics.half_swings.finite_result import HalfSwingAt, certified_swing, require_strengths
from asymptotics.numbers.exact import ExactReal
from asymptotics.swing.damping import Damping
from asymptotics.swing.ends import CREEPS, OVERDAMPED, STICKS
from asymptotics.swing.passage import integrated

MAX_DELTA = 1000
CHEAP_ORDER = 24
"""The order up to which the coefficients cost less than a second."""
_ENDS = {STICKS: "sticks there", CREEPS: "creeps from there on", OVERDAMPED: "is overdamped"}


def half_swing_result(alphas: Sequence[ExactReal], delta: Sequence[ExactReal], digits: int = 30) -> HalfSwingAt:
    """The half-swing from the local strengths delta_i >= 0, to ``digits`` digits, by the cheaper route.

    InputError for a negative strength, a wrong number of them, or where no turning point follows (it sticks or creeps).
    """
    require_strengths(alphas, delta)
    for d in delta:
        if d > MAX_DELTA:
            raise LimitError("delta", f"{d} is out of range: the motion is too stiff", f"strengths up to {MAX_DELTA}")

    def evaluate(bits: int) -> SwingValue:
        balls = [d.ball() for d in delta]
        if len(alphas) == 1 and balls[0] < series_reach(alphas[0], bits, CHEAP_ORDER):
            return finite_quarter(alphas, balls, bits).half_swing(balls)
        found = integrated(Damping.of(list(zip(balls, alphas, strict=True))), arb(1))
        if found.amplitude is None or found.duration is None:
            how = _ENDS[str(found.ended)]
            raise InputError("delta", f"no turning point follows: the motion {how}", "a smaller delta")
        return SwingValue(found.amplitude.log(), found.amplitude, found.duration, found.route, found.terms, found.tail)

    return certified_swing(alphas, delta, digits, evaluate)
