"""By how much given amplitudes fall faster, and given half-swings last longer, than the law wants from where they are.

The field's word is the defect (or residual) of an approximate solution: which equation do the values solve?

With lambda = ln A of the truth and lambda + a that of the values, R(lambda) the rate at which ln A falls and Q(lambda)
that at which times are late, from one point to the next

    r = (rate at which lambda + a falls) - R(lambda + a),      q = (rate at which given times are late) - Q(lambda + a),

R and Q next to the truth by their slopes.  Doubles: this judges errors, it certifies nothing.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from asymptotics.decays.comparison.errors import Errors

_TELLING = 0.1  # a fall of ln A in which a power of A is seen


@dataclass(frozen=True)
class Defects:
    """``damping`` and ``frequency``: shares of the damping and of T - pi (None without times); ``rate``: the mean of r.

    ``one_sign``: |sum r|/sum |r|; ``rough``: scatter of ln |r| about a parabola in ln A; ``quickness``: |sum q/sum r|;
    ``power`` and ``own_power``: of A in r and in R, worth something only if ``telling``; ``strength``: (T - pi)/D.
    """

    damping: float
    frequency: float | None
    rate: float
    one_sign: float
    rough: float
    quickness: float | None
    power: float
    own_power: float
    telling: bool
    strength: float = 0.0


def defects_of(errors: Errors, shift: Any | None) -> Defects:
    """From three points on; ``shift`` is the sum of T - pi at each."""
    size, steps = np.log(errors.size), np.diff(errors.tau)
    # From here on size is ln A, and R its rate of fall between two points, at the middle of both.
    middle, R = (size[1:] + size[:-1]) / 2, -np.diff(size) / steps
    a = (errors.amplitude[1:] + errors.amplitude[:-1]) / 2
    # Beyond a fall of a tenth a power of A shows in R; before it, or where an amplitude grows, slopes count as 0.
    telling = bool(np.ptp(middle) > _TELLING and np.all(R > 0))
    slope = _slope(middle, np.log(R), 2) if telling else np.zeros_like(R)
    # dR/d lambda = R d ln R/d lambda: a law that is followed from a wrong amplitude has no defect.
    r = -np.diff(errors.amplitude) / steps - R * slope * a
    total, whole = float(np.sum(r * steps)), float(size[0] - size[-1])
    frequency = quickness = None
    added = 0.0
    if errors.advance is not None and shift is not None:
        Q = np.diff(shift) / steps
        q = -np.diff(errors.advance) / steps - (_slope(middle, Q, 2) if telling else 0.0) * a
        late, added = float(np.sum(q * steps)), float(shift[-1] - shift[0])
        # Dry friction adds nothing to the periods: then there is no share of it.
        frequency = late / added if abs(added) > 1e-12 else None
        quickness = abs(late / total) if total else None
    logs = np.log(np.maximum(abs(r), 1e-300))
    # One datum to spare, or the parabola would go through everything and nothing were rough.
    degree = min(2, len(r) - 2) if telling else 0
    rough = float(np.std(logs - np.polyval(np.polyfit(middle, logs, degree), middle)))
    power = float(np.polyfit(middle, logs, 1)[0]) if telling else 0.0
    share = total / whole if abs(whole) > 1e-12 else 0.0
    one_sign = abs(total) / max(float(np.sum(abs(r) * steps)), 1e-300)
    rate, own = float(np.mean(r)), float(np.mean(slope))
    strength = added / whole if whole > 1e-12 else 0.0
    return Defects(share, frequency, rate, one_sign, rough, quickness, power, own, telling, strength)


def _slope(x: Any, y: Any, degree: int) -> Any:
    """dy/dx of a fitted polynomial, at every x."""
    return np.polyval(np.polyder(np.polyfit(x, y, max(1, min(degree, len(x) - 2)))), x)
