"""From amplitudes under known forces to damping ratios at amplitudes: a resonance as a table of the judge of decays.

To first order (``driven.first_order``) the loss takes R(A)^2 = F^2 - (A (k - m Omega^2))^2, and the viscous damping
that takes the same is c_eq = R/(A Omega).  It depends on the speed A Omega alone: a decay has it at A Omega/omega_0,
where

    zeta = c_eq/(2 sqrt(k m)).

The error of an amplitude moves zeta and where it is: with p the slope of ln zeta in ln A, relative to zeta by
(1 + p + (A (k - m Omega^2)/R)^2) times that of A.

Where the phase phi by which x lags behind the force was measured too, R = F sin(phi) needs no difference of the spring
and the mass: the errors are (1 + p) times that of A, and that of phi times cot(phi), beside each other.

>>> forces = np.array([0.1, 0.2, 0.4])
>>> places, zeta, spread, _ = as_losses({"amplitude": 10 * forces, "force": forces}, np.full(3, 0.01), None, None)
>>> zeta.round(12).tolist(), (spread * places).round(12).tolist()
([0.05, 0.05, 0.05], [0.0005, 0.0005, 0.0005])
"""

from typing import Any

import numpy as np

from asymptotics.driven.balance import estimated_error
from asymptotics.driven.drive import Drive
from asymptotics.errors import InputError
from asymptotics.law import Oscillator
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import double_of, exact_number
from asymptotics.running.budget import tick


def as_losses(
    columns: dict[str, Any], spread: Any, mass: ExactReal | None, stiffness: ExactReal | None
) -> tuple[Any, Any, Any, tuple[str, ...]]:
    """Amplitudes of a decay with zeta there, its error, and what is told; InputError for a force that is too small."""
    A, F = columns["amplitude"], columns["force"]
    m, k = (1.0 if n is None else double_of(n) for n in (mass, stiffness))
    omega_0 = (k / m) ** 0.5
    omega = columns.get("omega", np.full(len(A), omega_0))
    places = A * omega / omega_0
    if "phase" in columns:
        return _by_phase(columns, places, F / (A * omega) / (2 * (k * m) ** 0.5), spread)
    detuning = A * (k - m * omega**2) if "omega" in columns else np.zeros(len(A))
    square = F**2 - detuning**2
    if not np.all(square > 0):
        row = int(np.flatnonzero(~(square > 0))[0]) + 1
        reason = f"{F[row - 1]:g} in row {row} is less than the spring and the mass take of it"
        raise InputError("force", reason, "forces, amplitudes, mass and stiffness of one experiment")
    R = np.sqrt(square)
    zeta = R / (A * omega) / (2 * (k * m) ** 0.5)
    told = ("amplitudes under a force: first order",)
    if spread is None:
        return places, zeta, None, told
    return places, zeta, zeta * (1 + _slope(places, zeta) + (detuning / R) ** 2) * spread / A, told


def _by_phase(columns: dict[str, Any], places: Any, whole: Any, spread: Any) -> tuple[Any, Any, Any, tuple[str, ...]]:
    """The same by the phases; ``whole``: zeta of a force that is all in phase with the velocity."""
    A, phase = columns["amplitude"], columns["phase"]
    if not np.all((phase > 0) & (phase < np.pi)):
        row = int(np.flatnonzero(~((phase > 0) & (phase < np.pi)))[0])
        reason = (
            f"{phase[row]:g} rad in row {row + 1}: by a loss x lags behind the force, by more than 0 and less than pi"
        )
        raise InputError("phase", reason, "the lag of x behind the force, in rad, or in a column phase [deg]")
    zeta, told = whole * np.sin(phase), ("amplitudes and phases under a force: first order",)
    if spread is None:
        return places, zeta, None, told
    of_phase = columns["phase_resolution"] / np.tan(phase)
    return places, zeta, zeta * np.hypot((1 + _slope(places, zeta)) * spread / A, of_phase), told


def _slope(places: Any, zeta: Any) -> Any:
    """d ln zeta/d ln A at each place, of a parabola through the table (a line, a constant for few rows)."""
    x, y = np.log(places), np.log(zeta)
    # R grows with A, so that the slope is above -1: noise may say otherwise.
    degree = min(2, len({*x.round(6)}) - 1)
    return np.maximum(-0.95, np.polyval(np.polyder(np.polyfit(x, y, degree)), x)) if degree else np.zeros(len(x))


def beyond_first_order(
    columns: dict[str, Any], strengths: dict[str, float], mass: ExactReal | None, stiffness: ExactReal | None
) -> dict[str, Any]:
    """What amplitude and phase of each row are beyond first order for a law, by the next harmonics; 0 where they say
    nothing."""
    law = {exact_number(a, "laws"): b for a, b in strengths.items() if b > 0}
    oscillator = Oscillator(law, mass=mass or 1, stiffness=stiffness or 1)
    m, k = (1.0 if n is None else double_of(n) for n in (mass, stiffness))
    omega = columns.get("omega", np.full(len(columns["force"]), (k / m) ** 0.5))
    off: dict[str, list[float]] = {"amplitude": [], "phase": []}
    for n, (F, w) in enumerate(zip(columns["force"], omega)):
        tick(f"the next harmonics at row {n + 1} of {len(omega)}")
        try:
            found = estimated_error(Drive.read(oscillator, float(F), float(w)))
        except InputError:  # a force that the friction of this law withstands
            found = None
        for name, column in off.items():
            column.append(float((found or {}).get(name, 0.0)))
    return {name: np.array(column) for name, column in off.items()}
