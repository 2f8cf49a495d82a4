"""What errors look like: rounding, truncation, phase drift, a wrong law; or undecided.

From each value to the next, the *defect* r is how much more the given amplitude falls, per unit of time, than the law
makes it fall from where it is; q is how much longer the given half-swings last.  Both are shares of what damping does:
D, the fall of ln A, and T - pi.  (Defects, not errors: an orbit of the right law from a wrong amplitude has none.)

* A law with another strength, exponent or term has an r of one sign, smooth in ln A, and next to it a q that is smaller
  by about delta.  An integrator has q at least as large as r, or an r that jumps about.
* Only integrators of first order look like a law: with step h they take h/2 off the rate, at all amplitudes.  So does a
  linear term: where r is like that, the times decide if they can, else it is *undecided*.
* Amplitudes right and times wrong by a noticeable share of T - pi is phase drift: formulas of first order, large steps.
* Errors that jump from sample to sample are noise: undecided, unless they are small.

How often each answer is right is measured on integrators, formulas and laws that the thresholds were not chosen on
(``docs/tables.md``, "How far the look is to be trusted"; ``tests/decays/comparison/battery.py`` names the twelve laws
they were chosen on).

>>> import numpy as np
>>> from asymptotics.decays.comparison.errors import Errors
>>> tau, size = np.pi * np.arange(8), 0.9 ** np.arange(8)
>>> look_of(Errors(tau, size, -0.02 * np.arange(8), None), None, 5.0).kind
'wrong law'
>>> look_of(Errors(tau, size, 1e-6 * np.arange(8), 1e-2 * np.arange(8)), 1e-2 * np.arange(8), 5.0).kind
'phase drift'
>>> look_of(Errors(tau, size, 1e-6 * np.arange(8), 1e-6 * np.arange(8)), 1e-2 * np.arange(8), 5.0).kind
'truncation'
"""

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from asymptotics.decays.comparison.defects import Defects, defects_of
from asymptotics.decays.comparison.errors import Errors
from asymptotics.present.counts import many

# All thresholds were chosen on those laws, and none is derived. They decide what the errors are called, never how many
# digits are right.
WRONG_DAMPING, WRONG_FREQUENCY = 5e-3, 5e-2  # shares of what damping does that are noticeable: of D, and of T - pi
_SMALL, _SMALLEST = 3e-4, 3e-5  # shares of the damping: below the second it is an integrator's, between them undecided
_QUICK = 0.12  # q/r of a law, or thrice (T - pi)/D where damping is strong; integrators have more
_ONE_SIGN, _SMOOTH, _NOISE = 0.95, 0.2, 0.7  # |sum r|/sum |r|, scatter of ln |r|: a law's; and shares that are noise's
_CONSTANT = 0.3  # the power of A in r, below which it is that of a linear term
_FAR = -0.5  # so far off that shapes are not to be trusted
_LINEAR = 3.0  # f/d: 2 for a linear law of another strength, 4 for a linear law stepped by Euler
_FEWEST = 3  # half-swings: two defects, of which a sign can be told


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
    # Less than a digit lost is what rounding does, and what the errors look like says nothing.
    if lost < 1:
        return Look("rounding", "every value is right to the digits written, or nearly")
    if len(errors) < _FEWEST:
        return Look("undecided", f"{many(len(errors), 'half-swing')} with values are too few to tell")
    found = defects_of(errors, shift)
    drift = _drift(errors, shift)
    kind, reason = _judged(errors, found, drift)
    return Look(kind, reason, f"{found.damping:.2e}", None if drift is None else f"{drift.share:.2e}")


@dataclass(frozen=True)
class _Drift:
    """The largest error of a time as a ``share``: of what damping ``adds`` to all periods, or else of the time."""

    share: float
    adds: bool

    @property
    def late(self) -> bool:
        return abs(self.share) > (WRONG_FREQUENCY if self.adds else _SMALL)

    def __str__(self) -> str:
        return f"{abs(self.share):.0%} of what damping adds to the periods" if self.adds else f"{abs(self.share):.2%}"


def _judged(errors: Errors, found: Defects, drift: _Drift | None) -> tuple[str, str]:
    d, late = found.damping, drift is not None and drift.late
    # In this order: noise first, for it has defects of any kind; then what no loss can do; then laws; what is left is
    # an integrator's.
    if errors.jumps > _NOISE or (errors.advance is None and found.one_sign < _NOISE):
        if late or abs(d) > WRONG_DAMPING or float(np.max(abs(errors.amplitude))) > WRONG_DAMPING:
            return "undecided", "the errors jump from value to value, like noise"
        return "truncation", "the errors are small and jump from value to value"
    # More than the whole damping is missing.
    if d < -1:
        return "truncation", "the amplitudes grow, as no loss lets them: steps too large for the method"
    ordered = found.one_sign > _ONE_SIGN and found.rough < _SMOOTH
    if (
        abs(d) > _SMALLEST
        and ordered
        and (found.quickness is None or found.quickness < max(_QUICK, 3 * found.strength))
    ):
        return _like_a_law(errors, found)
    # Damping that is noticeably wrong, yet rough or too quick for a law, unless the times are off by as much.
    if abs(d) > WRONG_DAMPING and not (late and (found.quickness or 0.0) > 0.5):
        return "undecided", f"the damping given is {_more(d)} than that of the law, but not as in another law"
    if late:
        return "phase drift", f"amplitudes are right, but times are off by {drift}"
    return "truncation", "damping and frequency are right; the errors are those of steps or orders"


def _like_a_law(errors: Errors, found: Defects) -> tuple[str, str]:
    d = found.damping
    reason = f"the damping given is {_more(d)} than that of the law"
    if abs(d) < _SMALL:
        return "undecided", f"{reason}, throughout: a strength that was rounded, or steps"
    # r at all amplitudes alike, or not to be told: so far Euler's method and a linear term less are the same.
    steady = abs(found.power) < _CONSTANT or not found.telling or d < _FAR
    linear = found.telling and abs(found.own_power) < _CONSTANT
    # Damping and periods of a linear law of another strength are wrong by shares of 1 and 2, of Euler's method by 1 and
    # 4.
    timely = linear and d > _FAR and found.frequency is not None and 1 < found.frequency / d < _LINEAR
    if d < 0 and steady and not timely:
        reason += f", by {abs(found.rate):.2g} at all amplitudes"
        return "undecided", f"{reason}: a linear term less, or Euler's method with steps of {2 * abs(found.rate):.2g}"
    return "wrong law", reason + (_exponent(errors) or ", throughout")


def _drift(errors: Errors, shift: Any | None) -> _Drift | None:
    if errors.advance is None or shift is None:
        return None
    # Dry friction adds nothing to the periods: then there is no share of it.
    adds = abs(shift[-1]) > 1e-12
    whole = shift[-1] if adds else errors.tau[-1]
    return _Drift(float(-errors.advance[np.argmax(abs(errors.advance))] / whole), adds)


def _more(share: float) -> str:
    size = f"{abs(share):.3g}".rstrip("0").rstrip(".") if abs(share) >= 1 else f"{abs(share):.2%}"
    size = f"{size} times" if abs(share) >= 1 else size
    return f"{size} {'more' if share > 0 else 'less'}"


def _exponent(errors: Errors) -> str:
    """The exponent that the given amplitudes themselves suggest: the drop of ln A goes like A^(alpha - 1)."""
    given = errors.size * np.exp(errors.amplitude)
    if np.any(given <= 0) or len(given) < _FEWEST + 1:
        return ""
    drops = -np.diff(np.log(given)) / np.diff(errors.tau)
    middle = np.log(given[:-1] * given[1:]) / 2
    # Over a fifth of ln A at least, or the slope would be that of the errors.
    if np.any(drops <= 0) or np.ptp(middle) < 0.2:
        return ""
    slope = np.polyfit(middle, np.log(drops), 1)[0]
    return f"; its amplitudes fall as if alpha were {1 + slope:.2f}"
