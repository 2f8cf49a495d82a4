"""Turning points beside the linear spring, by interpolation (``panels``) where it pays and by pieces elsewhere.

>>> from itertools import islice
>>> from flint import ctx
>>> from asymptotics.flow.sequence import sequence
>>> from asymptotics.flow.turning import at_rest
>>> from asymptotics.law import Law
>>> from asymptotics.return_map.panels import panels_of
>>> cubic = Law({3: "1/2"})
>>> with ctx.workprec(100):
...     flow = Interpolated(Damping.of_law(cubic), panels_of(cubic, 100), 3)
...     points = list(islice(sequence(flow, at_rest(arb(1))), 4))
>>> [point.x.str(12) for point in points][1:]
['[-0.673493180351 +/- ...]', '[0.543067542755 +/- ...]', '[-0.467642206192 +/- ...]']
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from flint import arb

from asymptotics.flow.balls import upper
from asymptotics.flow.damping import Damping
from asymptotics.flow.dense import KnownPiece
from asymptotics.flow.error_propagation import CarriedErrors, contraction_by_ratio
from asymptotics.flow.linear_spring.expansion import TurningExpansion
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.trajectory import Piece
from asymptotics.flow.turning import TurningState
from asymptotics.return_map.course import Course
from asymptotics.return_map.half_swing_map import HalfSwingBalls
from asymptotics.return_map.panels import Panels

_FASTER = 1 + arb(2) ** -10  # than at the hand-over of a quarter: the speed up to which the expansion before it serves


@dataclass(frozen=True)
class Interpolated(LinearSpring):
    """A linear spring whose half-swings up to the turning point ``last`` may be read off ``panels``.

    ``within``: in about how many half-swings states are asked for, which may repay their courses.  ``ahead``: about
    where this half-swing turns.
    """

    panels: Panels
    last: int = 0
    within: int = 0
    ahead: arb | None = None

    def leap(self, here: TurningState, before: arb | None = None) -> TurningState | None:
        """By a panel, where as many half-swings as may follow repay it."""
        # How many half-swings a panel would serve: those up to the last turning point wanted, or up to the next time.
        remaining = self.last - here.n if before is None else _whole_swings(before - here.time)
        if before is not None and remaining <= 0:
            return None
        found = self.panels.half_swing(here.amplitude, here.amplitude_error, remaining)
        if found is None:
            return None
        there = following(self.force, here, found)
        # A turning point after the time asked for is of no use: the state in between has to be followed by pieces.
        return there if before is None or there.time < before else None

    def read_off(self, u: arb, given: arb) -> tuple[TurningExpansion, Piece] | None:
        """The half-swing between the hand-overs of its quarters, where states in many half-swings are asked for."""
        course = self.panels.course(u, self.within)
        if course is None:
            return None
        ((_, w),) = course.states([course.begin])
        expansion = TurningExpansion.at(self.force, u, upper(w * _FASTER))
        if not expansion.state(expansion.reach)[1] >= course.begin:
            return None
        flow = replace(self, ahead=-course.q.mid())
        return expansion, OnCourse(flow, arb(1), course.begin, course.end, CarriedErrors(arb(0), given), None, course)

    def arrive(self, place: arb, w: arb) -> TurningExpansion:
        """The expansion at ``ahead``: any guess will do (``turning_point``); what it misses the state by is added."""
        return super().arrive(place, w) if self.ahead is None else TurningExpansion.at(self.force, self.ahead, w)


@dataclass(frozen=True)
class OnCourse(KnownPiece):
    """The orbit from the exact start of the half-swing: two motions never part, so that ``errors`` are those given."""

    course: Course

    def own(self, t: arb) -> tuple[arb, arb]:
        """(place, w) off the interpolated quarters."""
        return self.course.states([t])[0]

    def all_at(self, times: Sequence[arb]) -> list[tuple[arb, arb]]:
        """The same within the errors; the unit is 1, and places are u itself, as there is no dry friction."""
        error = arb(0, self.error)
        return [(place + error, w + error) for place, w in self.course.states(times)]


def _whole_swings(time: arb) -> int:
    """About how many half-swings end before that time; it only decides how they are made."""
    # A half-swing lasts pi or a little longer.
    return int(min(float(time) / 3.2, 1e9))


def swings_within(times: Sequence[arb]) -> int:
    """About how many half-swings hold one of the ascending times; it only decides how they are made."""
    return min(len(times), _whole_swings(times[-1]) + 1) if times else 0


def following(damping: Damping, here: TurningState, found: HalfSwingBalls) -> TurningState:
    """The next turning point: exact midpoints, and the errors of this one led on with what the balls found add.

    The error of the amplitude is led on by contraction; the duration that was found holds that of every amplitude
    within the error of this one.
    """
    assert found.amplitude is not None and found.duration is not None
    q, time = here.amplitude * found.amplitude, here.time + found.duration
    amplitude, clock = q.mid(), time.mid()
    # q is that of the exact amplitude; for all alpha_i >= 1 relative errors only add (L1b), otherwise ``ratio_growth``
    # bounds them.
    carried = contraction_by_ratio(damping, here.amplitude, here.amplitude_error, q)
    error = upper(carried + q.rad()), upper(here.time_error + time.rad())
    return TurningState(here.n + 1, -here.side, amplitude, clock, *error)
