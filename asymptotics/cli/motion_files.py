"""The files of the command ``motion``: a table of the motion, and a picture of it with its envelope and its error.

>>> from asymptotics.law import Law
>>> from fractions import Fraction
>>> drag = Given(Oscillator(Law({"3/2": "1/10"})), si=True)
>>> csv_of(drag, ExactReal(Fraction(1)), 3, "turning-point").splitlines()[:2]
['t [s],x [m],v [m/s],amplitude [m],phase [rad]', '0.0,1.0,-0.0,1.0,0.0']
"""

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
from flint import ctx

from asymptotics.cli.quantities import Given
from asymptotics.costs import require_affordable
from asymptotics.law import Oscillator
from asymptotics.motions.asymptotic import AsymptoticMotion
from asymptotics.motions.reference import estimated_seconds, reference_motion, reference_states
from asymptotics.motions.result import MotionSamples
from asymptotics.numbers.exact import ExactReal
from asymptotics.present.figures import render

_ROWS, _REFERENCE_ROWS, _REFERENCE_DIGITS = 1000, 240, 14
_MAX_SECONDS = 60.0


def csv_of(
    given: Given,
    time: ExactReal,
    order: int | None,
    gauge: str,
    static: str | None = None,
    points: int = _ROWS,
) -> str:
    """t, x, v, amplitude, phase at points + 1 times from 0 to ``time``; without ``order`` t, x, v of the reference."""
    if order is None:
        t, x, v = _reference(given.oscillator, time, points, static)
        return MotionSamples(t, x, v, None, None, None, None, 0, 0, None, (), given.si).to_csv()
    found = AsymptoticMotion.of(given.oscillator, order, gauge).sample(np.linspace(0.0, _float(time), points + 1))
    return replace(found, si=given.si).to_csv()


def picture_of(given: Given, time: ExactReal, order: int, gauge: str, kind: str) -> bytes:
    """x(t) with +-A(t) above, |x_N - x_reference| below (left out without a reference in reach)."""
    oscillator = given.oscillator
    motion = AsymptoticMotion.of(oscillator, order, gauge)
    dense = motion.sample(np.linspace(0.0, _float(time), 4 * _ROWS + 1))
    error = None
    known = oscillator.law.is_pure and estimated_seconds(oscillator, time, _REFERENCE_DIGITS) < _MAX_SECONDS
    if known and time > 0:
        t, x, _ = _reference(oscillator, time, _REFERENCE_ROWS)
        error = t, np.abs(motion.sample(t).x - x)

    def draw(axes: Any) -> None:
        figure = axes.figure
        axes.remove()
        panels = figure.subplots(1 if error is None else 2, 1, sharex=True, squeeze=False)[:, 0]
        upper, bottom = panels[0], panels[-1]
        upper.plot(dense.t, dense.x, label=f"x, order {order}")
        for sign in (1, -1):
            label = "envelope" if sign > 0 else None
            upper.plot(dense.t, sign * dense.amplitude, color="#c2410c", linewidth=1.0, label=label)
        upper.set_ylabel(f"x{given.label('m')}")
        upper.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=2)
        if error is not None:
            bottom.semilogy(error[0][1:], np.maximum(error[1][1:], 1e-17), color="#15803d")
            bottom.set_ylabel(f"|x - reference|{given.label('m')}")
        bottom.set_xlabel(given.time_label)

    return render(draw, size=(6.4, 5.2), kind=kind)


def picture_of_reference(given: Given, time: ExactReal, kind: str, static: str | None) -> bytes:
    """x(t) and v(t) of the reference motion."""
    t, x, v = _reference(given.oscillator, time, _ROWS, static)

    def draw(axes: Any) -> None:
        figure = axes.figure
        axes.remove()
        upper, lower = figure.subplots(2, 1, sharex=True)
        upper.plot(t, x)
        upper.set_ylabel(f"x{given.label('m')}")
        lower.plot(t, v, color="#15803d")
        lower.set_ylabel(f"v{given.label('m/s')}")
        lower.set_xlabel(given.time_label)

    return render(draw, size=(6.4, 5.2), kind=kind)


def _reference(oscillator: Oscillator, time: ExactReal, rows: int, static: str | None = None) -> tuple[Any, Any, Any]:
    """(t, x, v) of the reference motion at rows + 1 equally spaced times, in doubles."""
    seconds = estimated_seconds(oscillator, time, _REFERENCE_DIGITS)
    require_affordable(seconds, _MAX_SECONDS, "--time", f"a reference motion through {time} s", " for files")
    times = [time * Fraction(i, rows) for i in range(rows + 1)]
    if oscillator.law.is_pure and oscillator.law.integer_alphas == (0,):  # exact, with sticking
        points = [reference_motion(oscillator, t, _REFERENCE_DIGITS, static=static) for t in times]
        x, v = (np.array([float(Fraction(text)) for text in column]) for column in zip(*((p.x, p.v) for p in points)))
        return np.array([_float(t) for t in times]), x, v
    states = reference_states(oscillator, times, _REFERENCE_DIGITS)
    x, v = (np.array([float(c) for c in column]) for column in (states.x, states.v))
    return np.array([_float(t) for t in times]), x, v


def _float(x: ExactReal) -> float:
    with ctx.workprec(64):
        return float(x.ball().mid())
