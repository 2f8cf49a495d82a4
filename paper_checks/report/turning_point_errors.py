"""Where an order can be trusted: its error in amplitude and in phase over the (epsilon, tau) plane, measured.

At the n-th turning point of the reference motion the turning-point gauge predicts |X_n| = A and psi = n pi, so the two
errors are read off there and nowhere else:

    amplitude error |A(tau_n)/|X_n| - 1|,      phase error |psi(tau_n) - n pi| in radians.

Everything is measured in doubles against the reference; nothing is proved.

>>> errors = turning_point_errors("2", "1/10", order=1, tau_max=20)   # phase: (w_2/p_1) (0.1 - delta) = 0.0046, ...
>>> [round(float(e), 3) for e in errors.phase[:3]], bool(errors.amplitude[0] < 0.1)
([0.005, 0.008, 0.011], True)
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from asymptotics.law import Law, Oscillator
from asymptotics.motions.asymptotic import AsymptoticMotion
from asymptotics.numbers.context import cache
from asymptotics.numbers.exact import parse_real
from asymptotics.turning.choose import turning_points
from asymptotics.turning.result import TurningPoints

Array = Any
_DIGITS = 10


@dataclass(frozen=True, eq=False)
class TurningPointErrors:
    """Errors at the turning points tau_1, tau_2, ... of one motion; ``ended`` says if and why the sequence ended."""

    tau: Array
    amplitude: Array
    phase: Array
    ended: dict[str, Any] | None


def turning_point_errors(alpha: str, epsilon: str, order: int, tau_max: float) -> TurningPointErrors:
    """The errors of ``order`` at all turning points with tau <= ``tau_max`` (at most about tau_max/pi of them)."""
    law = Law({alpha: epsilon})
    table = _reference(law, int(tau_max / np.pi) + 2)
    rows = [(p.n, _number(p.x), _number(p.tau or "0")) for p in table.points[1:]]
    n, x, tau = (np.array(column) for column in zip(*rows)) if rows else (np.array([]),) * 3
    kept = (tau <= tau_max) & (x != 0)
    n, x, tau = n[kept], x[kept], tau[kept]
    motion = AsymptoticMotion.of(Oscillator(law, mass=1, stiffness=1, x0=1), order).sample(tau)
    with np.errstate(invalid="ignore"):
        amplitude = np.abs(motion.amplitude / np.abs(x) - 1)
    return TurningPointErrors(tau, amplitude, np.abs(motion.phase + tau - n * np.pi), table.ended)


@cache
def _reference(law: Law, count: int) -> TurningPoints:
    """The reference is the same for all orders."""
    return turning_points(law, count, _DIGITS, times=True)


def _number(text: str) -> float:
    return float(parse_real(text, "value").rational)
