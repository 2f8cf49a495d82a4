"""Turning points, passages through 0 and the stop of a motion that can be sampled: sign changes, refined.

Doubles, heuristic: a grid of 16 points a half-swing, and Newton's method with the acceleration of the equation.

>>> from asymptotics.curves.motions import motion
>>> motion({2: "1/10"}).events(7)
2 turning points, 2 zeros up to tau = 7
it does not stop
estimates, in doubles
"""

from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike

from asymptotics.errors import InputError, LimitError
from asymptotics.frames import BARE, Frame
from asymptotics.law import Oscillator
from asymptotics.motions.result import MotionSamples
from asymptotics.numbers.alike import Alike
from asymptotics.numbers.policy import Number, exact_number
from asymptotics.present.shown import Page, Rows

Array = Any
MAX_EVENTS = 10_000  # half-swings, which bound the work of a curve; it refuses, it decides no digit
# Two zeros are about half a turn apart unless damping is strong: a pair in one cell of a sixteenth would be missed.
_PER_HALF_SWING = 16


@dataclass(frozen=True, eq=False, repr=False)
class Events(Alike, Rows):
    """Times up to ``until``: turning points with their x, passages through 0 with their v, and the stop if any.

    Doubles, heuristic: found on a grid of 16 points a half-swing and refined by Newton's method.
    """

    turning: Array
    turning_x: Array
    zeros: Array
    zeros_v: Array
    stop: float | None
    until: float
    frame: Frame = BARE

    def _page(self) -> Page:
        time = self.frame.time
        stop, until = (self.frame.with_unit("t", f"{t:.10g}") if t is not None else "" for t in (self.stop, self.until))
        stop = f"it stops at {time} = {stop}" if stop else "it does not stop"
        counted = [
            f"{n} {name}{'s' * (n != 1)}"
            for n, name in ((len(self.turning), "turning point"), (len(self.zeros), "zero"))
        ]
        title = f"{', '.join(counted)} up to {time} = {until}"
        rows = tuple(zip(*self._table().values()))
        shown = tuple((event, f"{t:.10g}", f"{x:.10g}", f"{v:.10g}") for event, t, x, v in rows)
        return Page(title, (stop, "estimates, in doubles"), self._head(), shown)

    def _table(self) -> dict[str, list[Any]]:
        at_turning = [("turning point", t, x, 0.0) for t, x in zip(self.turning, self.turning_x)]
        rows = sorted(at_turning + [("zero", t, 0.0, v) for t, v in zip(self.zeros, self.zeros_v)], key=lambda r: r[1])
        return {name: [row[i] for row in rows] for i, name in enumerate(self._head())}

    def _head(self) -> tuple[str, ...]:
        return "event", *(self.frame.named(name) for name in ("t", "x", "v"))


def _counted(times: Array, name: str) -> str:
    return f"{len(times)} {name}{'s' * (len(times) != 1)}"


class _Sampled(Protocol):
    @property
    def oscillator(self) -> Oscillator: ...

    @property
    def frame(self) -> Frame: ...

    def sample(self, t: ArrayLike) -> MotionSamples: ...


def events_of(moving: _Sampled, until: Number, stop: float | None) -> Events:
    """Sign changes of v and x on a grid, refined by Newton's method with the acceleration of the equation."""
    oscillator = moving.oscillator
    end = exact_number(until, "until")
    if not end > 0:
        raise InputError("until", f"{end} is not positive", "a time > 0, in s, of a law alone in 1/omega_0")
    last, omega = float(end.ball().mid()), float(oscillator.omega_0().mid())
    swings = last * omega / np.pi
    if swings > MAX_EVENTS:
        raise LimitError("until", f"{swings:.3g} half-swings are too many", f"at most {MAX_EVENTS}")
    if stop is not None:
        # Beyond the stop x is constant and v = 0: no sign changes there.
        last = min(last, stop)
    grid = np.linspace(0.0, last, int(_PER_HALF_SWING * (swings + 1)) + 2)
    found = moving.sample(grid)
    # What is 0 at the start is no event (0 < t); the sample may be -1e-16 there, or what an expansion leaves.
    at_rest, at_zero = (
        np.append(0.0 if x.is_zero else 1.0, np.ones(grid.size - 1)) for x in (oscillator.v0, oscillator.x0)
    )
    turning = _crossings(moving, grid, found.v * at_rest, of_velocity=True)
    zeros = _crossings(moving, grid, found.x * at_zero, of_velocity=False)
    at_turning, at_zeros = moving.sample(turning), moving.sample(zeros)
    ended = stop if stop is not None and stop <= float(end.ball().mid()) else None
    return Events(turning, at_turning.x, zeros, at_zeros.v, ended, float(end.ball().mid()), moving.frame)


def _crossings(moving: _Sampled, grid: Array, values: Array, *, of_velocity: bool) -> Array:
    """Where ``values`` changes sign: the secant, then Newton steps kept inside the interval."""
    # Signs, since products of neighbours are 0 below 1e-162.  What is exactly 0 has no sign and is passed over: so is
    # the first grid point of a start at rest, which is no event, since events are in 0 < t.
    signed = np.nonzero(values)[0]
    grid, values = grid[signed], values[signed]
    i = np.nonzero(np.sign(values[:-1]) * np.sign(values[1:]) < 0)[0]
    low, high = grid[i], grid[i + 1]
    t = low - values[i] * (high - low) / (values[i + 1] - values[i])
    # The secant over a sixteenth of a half-swing is right to some hundredths of the cell, and each Newton step doubles
    # the digits: three would do, a fourth costs little.  clip keeps a step that divides by nearly 0 in its cell.
    for _ in range(4 if t.size else 0):
        now = moving.sample(t)
        # Newton for v = 0 needs v' = x'', from the equation of motion at the sampled state: differences of v would be
        # rougher, and an expansion's v is differentiated nowhere.
        step = now.v / _acceleration(moving.oscillator, now) if of_velocity else now.x / now.v
        t = np.clip(t - np.where(np.isfinite(step), step, 0.0), low, high)
    return t


def _acceleration(oscillator: Oscillator, now: MotionSamples) -> Array:
    """x'' = -(k x + sum of the forces)/m."""
    force = float(oscillator.stiffness.ball().mid()) * now.x
    for t in oscillator.law.terms:
        b, velocity = float(t.b.ball().mid()), float(t.velocity.ball().mid())
        if t.family:
            # The pendulum's term is what sin x has beyond x, times the stiffness.
            force = force + float(oscillator.stiffness.ball().mid()) * (np.sin(now.x) - now.x)
        elif t.sign < 0:
            force = force + b * np.abs(now.x) ** t.position * np.sign(now.v) * np.abs(now.v) ** velocity
        else:
            force = force + b * np.sign(now.x) * np.abs(now.x) ** t.position * np.abs(now.v) ** velocity
    return -force / float(oscillator.mass.ball().mid())
