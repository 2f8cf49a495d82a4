"""The picture and the columns of a solution, explicit or implicit, in the units of its oscillator."""

from typing import Any

import numpy as np

from asymptotics.curves.motions import POINTS, axes_of_motion, envelope_lines, time_of_curve, times_of
from asymptotics.errors import InputError
from asymptotics.frames import Frame
from asymptotics.law import Oscillator
from asymptotics.numbers.policy import Number
from asymptotics.present.drawn import Drawn
from asymptotics.running.public import public

Array = Any


class SolutionCurve(Drawn):
    """What has ``oscillator``, ``order``, ``frame`` and ``sample`` (of tau) as a curve."""

    oscillator: Oscillator | None
    order: int
    frame: Frame

    @public
    def sample(self, times: Any, *, max_seconds: Number = 60) -> tuple[Array, Array, Array]:
        """(A, phi, x) at an array of tau."""
        raise NotImplementedError

    @public
    def columns(self, t: Any, *, max_seconds: Number = 60) -> tuple[Array, Array, Array, Array]:
        """Arrays t, A, phi, x at times in s (tau for a law alone), in doubles and the units of the oscillator."""
        oscillator = self._given()
        omega, length = float(oscillator.omega_0().mid()), float(oscillator.length().mid())
        times = times_of(t)
        # ``sample`` knows tau and the unit of the start.
        A, phi, x = self.sample(times * omega)
        return times, A * length, phi, x * length

    @property
    def mirrored(self) -> bool:
        """Whether it starts at rest from x0 < 0: the mirror image of a start at +1, half a turn later, phi(0) = pi."""
        given = self.oscillator
        return given is not None and given.v0.is_zero and bool(given.x0 < 0)

    def _given(self) -> Oscillator:
        if self.oscillator is None:
            raise InputError("epsilon", "no strength is given", "a law with its strength, such as {2: '1/10'}")
        return self.oscillator

    def _heading(self) -> str:
        return f"{self._given()}: solution, order {self.order}, turning-point gauge"

    def _curve(self, axes: Any, **style: Any) -> None:
        # Options of our own are taken out first: what is left in ``style`` goes to Matplotlib's line.
        until = time_of_curve(self._given(), style.pop("until", None))
        t, A, _, x = self.columns(np.linspace(0.0, until, POINTS))
        axes_of_motion(axes, self.frame)
        axes.plot(t, x, **{"label": "x", **style})
        envelope_lines(axes, t, A)
