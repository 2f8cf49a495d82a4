"""What errors look like: rounding, truncation, phase drift, or a wrong law.

Two numbers decide.  The damping takes ln A down, by D per half-swing; the errors of the amplitudes say by what share of
itself the given D is wrong.  Damping adds T - pi to the time of a half-swing; the errors of the times are measured by
the sum of that.  An integrator that does its work gets both right and loses digits all the same (truncation).  What
lacks the frequency correction is wrong in all of T - pi (phase drift).  A wrong law, strength or exponent is wrong in D
at once, and in much the same share from the first half-swing on.

>>> import numpy as np
>>> from asymptotics.comparison.errors import Errors
>>> tau, size = np.pi * np.arange(8), 0.9 ** np.arange(8)
>>> look_of(Errors(tau, size, 0.02 * np.arange(8), None), None, 5.0).kind
'wrong law'
>>> look_of(Errors(tau, size, 1e-6 * np.arange(8), 1e-2 * np.arange(8)), 1e-2 * np.arange(8), 5.0).kind
'phase drift'
>>> look_of(Errors(tau, size, 1e-6 * np.arange(8), 1e-6 * np.arange(8)), 1e-2 * np.arange(8), 5.0).kind
'truncation'
"""

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from asymptotics.comparison.errors import Errors

WRONG_DAMPING, WRONG_FREQUENCY = 5e-3, 5e-2
_SMALL = 3e-4  # a share of the damping below this is an integrator's, however constant
_CONSTANT = 0.6
_FEWEST = 3


@dataclass(frozen=True)
class Look:
    """``kind`` of the errors, and why; ``damping`` and ``frequency`` are the shares in which they are wrong."""

    kind: str
    reason: str
    damping: str | None = None
    frequency: str | None = None

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready."""
        return asdict(self)


def look_of(errors: Errors, shift: Any | None, lost: float) -> Look:
    """The look of errors; ``shift`` is the sum of T - pi at each point, ``lost`` the digits lost at most."""
    if lost < 1:
        return Look("rounding", "every value is right to the digits written, or nearly")
    if len(errors) < _FEWEST:
        return Look("undecided", f"{len(errors)} half-swings with values are too few to tell")
    drop = np.log(errors.size[0] / errors.size[-1])
    damping = _share(errors.amplitude[-1] - errors.amplitude[0], -drop)
    frequency = None
    if errors.advance is not None and shift is not None:
        frequency = _share(-errors.advance[np.argmax(abs(errors.advance))], shift[-1])
    texts = {"damping": _text(damping), "frequency": _text(frequency)}
    if damping is not None and abs(damping) > WRONG_DAMPING:
        reason = f"the damping given is {_more(damping)} than that of the law{_exponent(errors)}"
        return Look("wrong law", reason, **texts)
    if frequency is not None and abs(frequency) > WRONG_FREQUENCY:
        reason = f"amplitudes are right, but times are off by {abs(frequency):.0%} of what damping adds to the periods"
        return Look("phase drift", reason, **texts)
    if frequency is None and errors.advance is not None and np.max(abs(errors.advance)) > _SMALL * errors.tau[-1]:
        return Look("phase drift", "amplitudes are right, but times are not", **texts)
    if damping is not None and abs(damping) > _SMALL and _is_constant(errors):
        return Look("wrong law", f"the damping given is {_more(damping)} than that of the law, throughout", **texts)
    return Look("truncation", "damping and frequency are right; the errors are those of steps or orders", **texts)


def _share(error: float, whole: float) -> float | None:
    return float(error / whole) if abs(whole) > 1e-12 and np.isfinite(error) else None


def _text(share: float | None) -> str | None:
    return None if share is None else f"{share:.2e}"


def _more(share: float) -> str:
    size = f"{abs(share):.3g}".rstrip("0").rstrip(".") if abs(share) >= 1 else f"{abs(share):.2%}"
    size = f"{size} times" if abs(share) >= 1 else size
    return f"{size} {'more' if share > 0 else 'less'}"


def _is_constant(errors: Errors) -> bool:
    """Whether each half-swing has the same share of its damping wrong, while the amplitude falls noticeably."""
    drops = -np.diff(np.log(errors.size))
    shares = -np.diff(errors.amplitude) / drops
    return bool(errors.size[0] > 1.3 * errors.size[-1] and shares.std() < _CONSTANT * abs(shares.mean()))


def _exponent(errors: Errors) -> str:
    """The exponent that the given amplitudes themselves suggest: the drop of ln A goes like A^(alpha - 1)."""
    given = errors.size * np.exp(errors.amplitude)
    if np.any(given <= 0) or len(given) < _FEWEST + 1:
        return ""
    drops = -np.diff(np.log(given))
    middle = np.log(given[:-1] * given[1:]) / 2
    if np.any(drops <= 0) or np.ptp(middle) < 0.2:
        return ""
    slope = np.polyfit(middle, np.log(drops), 1)[0]
    return f"; its amplitudes fall as if alpha were {1 + slope:.2f}"
