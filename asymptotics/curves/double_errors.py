"""What the exported doubles of envelopes, motions and solutions are good to, column by column: estimates.

>>> import numpy as np
>>> from asymptotics.curves.slow import envelope
>>> of_envelope(envelope({2: "1/10"}), np.linspace(0.0, 3.0, 4))
{'amplitude': relative 2.3e-15, 'phase': absolute 2.0e-15}
"""

from typing import Any

import numpy as np

from asymptotics.curves.implicit import ImplicitSolution
from asymptotics.curves.large import SpringEnvelope
from asymptotics.curves.motions import Motion, Reference
from asymptotics.curves.slow import Envelope
from asymptotics.curves.solution import Solution
from asymptotics.law import Oscillator
from asymptotics.motions.result import MotionSamples
from asymptotics.numbers.double_error import EPS, STEP, DoubleError, of_column, of_rounding

Errors = dict[str, DoubleError | None]
_FEW, _POWER, _WAVES, _DECIMAL, _BALL = 16, 4, 3e-13, 5.1e-14, 1.1e-14
"""Roundings of a formula, and of the number that it raises to a power; what a table of waveforms is good to; half a
unit of the last of the 14 digits of an exported reference, and the radius of its states, in units of the start."""


def of_envelope(found: Envelope | SpringEnvelope, times: Any, order: int | None = None) -> Errors:
    """Of A and phi at an array of times in s."""
    _, A, phi = found.columns(times, order=order)
    if isinstance(found, SpringEnvelope):
        errors = found._double_errors(times)
    elif order is not None:
        errors = _of_formulas(found.columns(times * (1 - STEP), order=order)[1:], A, phi, found.oscillator)
    else:
        errors = (
            _amplitude_errors(A, found.amplitudes(times * (1 - STEP)), found._roundings(A)),
            found._phase_errors(times),
        )
    return {"amplitude": of_column(A, errors[0], relative=True), "phase": of_column(phi, errors[1])}


def of_motion(moving: Motion | Reference, found: MotionSamples) -> Errors:
    """Of the columns of samples of a motion."""
    columns = {name: np.ravel(column) for name, column in found.columns().items() if name != "t"}
    if isinstance(moving, Motion):
        errors = moving._motion.double_errors(np.ravel(found.t))
    else:
        omega, length = (float(b.mid()) for b in (moving.oscillator.omega_0(), moving.oscillator.length()))
        size = {"x": length, "v": length * omega}
        # Dry friction alone has decimals, everything else balls.
        error = _DECIMAL if moving.is_dry else _BALL
        errors = {name: error * size[name] + EPS * np.abs(column) for name, column in columns.items()}
    return {name: of_column(column, errors[name], relative=name == "amplitude") for name, column in columns.items()}


def of_solution(found: Solution | ImplicitSolution, times: Any) -> Errors:
    """Of A, phi and x at an array of times in s."""
    _, A, phi, x = found.columns(times)
    oscillator = found._given()
    omega, length = float(oscillator.omega_0().mid()), float(oscillator.length().mid())
    if isinstance(found, ImplicitSolution):
        of_A, of_phi, of_x = (e * u for e, u in zip(found._double_errors(times * omega), (length, 1.0, length)))
    else:
        _, before, lag, _ = found.columns(times * (1 - STEP))
        of_A, of_phi = _of_formulas((before, lag), A, phi, oscillator)
        wave = 0.0 if found.has_formulas else _WAVES
        of_x = np.full_like(
            A, np.nanmax(np.abs(A) * (wave + _FEW * EPS * (1 + times * omega) + of_phi) + of_A, initial=0.0)
        )
    return {"amplitude": of_column(A, of_A, relative=True), "phase": of_column(phi, of_phi), "x": of_column(x, of_x)}


def _of_formulas(earlier: Any, A: Any, phi: Any, acting: Oscillator) -> tuple[Any, Any]:
    """Of A and phi by formulas: phi is a difference of terms that may be larger than it, of a radian or so; next to
    alpha = 1 both hold (1 + (alpha-1) kappa tau)^(1/(alpha-1)), a large power of a rounded number."""
    weight = next(abs(t.velocity - 1) for t in acting.law.losses)
    power = 0.0 if weight.is_zero else _POWER * EPS * max(0.0, 1 / float(weight.ball().mid()) - 1)
    of_A = _amplitude_errors(A, earlier[0], _FEW) + power * np.abs(A)
    return of_A, of_rounding(phi, earlier[1], _FEW) + _FEW * EPS + power


def _amplitude_errors(A: Any, earlier: Any, steps: Any) -> Any:
    """A = A(0) e^(-s), where s has been rounded too."""
    with np.errstate(divide="ignore", invalid="ignore"):
        s = np.nan_to_num(np.abs(np.log(A / np.max(A, initial=0.0))), posinf=0.0)
    return of_rounding(A, earlier, steps) + steps * EPS * A * s
