"""A motion as a table from 0 to T; and whether the reference is near enough to be drawn beside it.

>>> from fractions import Fraction
>>> from asymptotics.curves.motions import motion
>>> from asymptotics.law import Oscillator
>>> drag = motion(Oscillator({"3/2": "1/10"}))
>>> motion_table(drag, ExactReal(Fraction(1)), 2).to_csv().splitlines()[:2]
['t [s],x [m],v [m/s],amplitude [m],phase [rad],code [--order=3 ...]', '0.0,1.0,-0.0,1.0,0.0,sha256:...']
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from itertools import takewhile
from typing import Any

import numpy as np

from asymptotics.costs import require_affordable
from asymptotics.curves.motions import Motion, Reference
from asymptotics.law import Oscillator
from asymptotics.motions.reference import estimated_seconds, reference_motion, reference_states
from asymptotics.motions.result import MotionSamples
from asymptotics.motions.state_route import alone
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal
from asymptotics.running.budget import Unasked
from asymptotics.running.cut_short import changed, keeping

# 14 digits of the reference are right in a double to all but its last place or two; more would not be seen.
_REFERENCE_DIGITS = 14
# Of the estimate, which is good to a factor of three: beyond, a table is refused and an error curve left out.
_MAX_SECONDS = Unasked(60)


def motion_table(moving: Motion | Reference, until: ExactReal, points: int) -> MotionSamples:
    """The motion at ``points`` + 1 times from 0 to ``until``; an error that cuts a reference short carries its rows.

    LimitError for a reference that would take more than a minute.
    """
    if isinstance(moving, Motion):
        return moving.sample(np.linspace(0.0, _float(until), points + 1))
    # Each row is at the time that it prints: at another one, half a last place away, x would be another.
    times = [ExactReal(Fraction(repr(_float(until * Fraction(i, points))))) for i in range(points + 1)]

    def samples(found: Sequence[tuple[float, float]]) -> MotionSamples:
        t = np.array([_float(t) for t in times[: len(found)]])
        x, v = (np.array(column) for column in zip(*found))
        return MotionSamples(t, x, v, None, None, None, None, 0, 0, None, (), moving.frame)

    with changed(samples):
        return samples(_states(moving, times))


def reference_is_near(oscillator: Oscillator, time: ExactReal) -> bool:
    """Whether the reference, and so the error of an expansion, can be drawn in reasonable time."""
    # No error curve beside springs: a state costs more there, and nothing but the picture would depend on it.
    return oscillator.law.is_pure and estimated_seconds(oscillator, time, _REFERENCE_DIGITS) < _MAX_SECONDS


def _states(moving: Reference, times: Sequence[ExactReal]) -> list[tuple[float, float]]:
    """(x, v) of the reference motion at ascending times, in doubles; those found before an error are handed over."""
    oscillator, last = moving.oscillator, times[-1]
    seconds = estimated_seconds(oscillator, last, _REFERENCE_DIGITS)
    require_affordable(seconds, _MAX_SECONDS, "time", f"a reference motion through the time {last}", " for files")
    # Each time by its closed form, so that what is done so far is a list of rows.
    if alone(oscillator, 0) is not None:  # exact, with sticking
        made: list[tuple[float, float]] = []
        with keeping(lambda: made or None):
            for t in times:
                point = reference_motion(oscillator, t, _REFERENCE_DIGITS, static=moving.static)
                made.append((float(Fraction(point.x)), float(Fraction(point.v))))
        return made
    with changed(_unbroken):
        states = reference_states(oscillator, times, _REFERENCE_DIGITS)
    return [(float(x), float(v)) for x, v in zip(states.x, states.v)]


def _unbroken(found: Mapping[int, tuple[Any, Any]]) -> list[tuple[float, float]]:
    """The states from the first on, up to one that is not there."""
    # States are found in the order of their half-swings; a table ends at the first gap, since its rows ascend.
    places = takewhile(lambda i: i in found, range(len(found)))
    return [(float(x), float(v)) for x, v in (found[i] for i in places)]


def _float(x: ExactReal) -> float:
    # Eleven bits more than a double: the middle of the ball rounds as the number does, but for ties.
    with ctx.workprec(64):
        return float(x.ball().mid())
