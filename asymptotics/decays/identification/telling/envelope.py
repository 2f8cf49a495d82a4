"""Period, Q(A), T(A) and half-life of a record before any law: from the envelope, a smooth curve through amplitudes.

In a half-swing ln A falls by a sum of powers of A (from 1/A to A^3; which of them, by AICc), and Q = pi/2 over this
fall, at the first amplitude, the last and the geometric mean of both, with 95 % intervals of the regression.  No law of
motion enters, and no spring: it is told for every record that swings, whatever the verdict is.  The intervals are
averages over the choices of powers (``averaged``).  Of four turning points and fewer the samples tell more: a
damped cosine is fitted to them (``damped_cosine``); where there are none, one power at a time.  Of two or three turning
points every power is believed; two have an interval where their errors are known.

>>> n = np.arange(30)
>>> found = envelope(Observations.of(n, (-1.0) ** n * np.exp(-0.05 * n), 0.5 * n))
>>> [(f"{q['amplitude']:.3g}", f"{q['estimate']:.4g}") for q in found.quality]
[('1', '31.42'), ('0.484', '31.42'), ('0.235', '31.42')]
>>> f"{found.period['estimate']:.4g}", f"{found.half_life['estimate']:.4g}"
('1', '6.931')
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import inf, log, pi
from typing import Any

import numpy as np
from numpy.typing import NDArray

from asymptotics.decays.identification.fitting.starting import rest_position
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.criteria import memory_factor
from asymptotics.decays.identification.measuring.damped_cosine import FEWEST_SAMPLES, DampedCosine, damped_cosine
from asymptotics.decays.identification.measuring.few_swings import swings
from asymptotics.decays.identification.measuring.late_extremes import LINE_LATENESS
from asymptotics.decays.identification.measuring.line_errors import LineTurns, line_turns
from asymptotics.decays.identification.measuring.observations import Indices, Observations, Samples
from asymptotics.decays.identification.telling.averaged import NORMAL, Ends
from asymptotics.decays.identification.telling.backbone import TurningTimes, backbone, mean_period, period_at
from asymptotics.decays.identification.telling.decline import (
    LEAST,
    Decline,
    decline_of,
    decline_of_few,
)
from asymptotics.decays.records.units import SECONDS, UNITS
from asymptotics.numbers.quantities import ANGLES

_INVERTED = {"low": "high", "estimate": "estimate", "high": "low"}
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(12)
"""Of Gauss's rule between an amplitude and half of it, for a sum of a few powers: far below three digits."""
_FEWEST, _ENDED, _REST = 4, 1e-3, 1.5
"""Turning points that leave one more than a loss and the rest position have numbers; the share of the first amplitude
at which a decay of few swings ends; and how many times longer than the others the half-swing is in which it comes to
rest."""


_SPARSE, _ROUGH = 10.0, 0.01
"""Samples a period below which, and noise beside the first amplitude above which the samples tell more than turning
points: a choice, tried with 5.5 to 9.5 a period and noises of 0.01 to 0.04."""


@dataclass(frozen=True)
class MeasuredEnvelope:
    """``period`` and ``half_life`` (from the first amplitude) in the file's unit of ``time``, None without times;
    ``quality``: Q at three amplitudes, in the ``unit`` of x; ``decay_rate``: that of the amplitude there, in a unit of
    time; ``backbone``: the period there, of turning times; ``untold``: why there is no Q; ``unsure``: why there are no
    intervals."""

    period: Ends | None
    quality: tuple[Ends, ...]
    half_life: Ends | None
    unit: str = ""
    time: str = "s"
    backbone: tuple[Ends, ...] = ()
    decay_rate: tuple[Ends, ...] = ()
    untold: str = ""
    unsure: str = ""

    def to_dict(self, law_known: bool) -> dict[str, Any]:
        """JSON-ready: numbers are strings, an end without a limit is null."""
        return {
            "period": _texts(self.period), "quality": [_texts(q) for q in self.quality],
            "half_life": _texts(self.half_life), "time_unit": self.time, "law_known": law_known,
            "decay_rate": [_texts(rate) for rate in self.decay_rate], "quality_untold": self.untold or None,
            "intervals_untold": self.unsure or None,
            "backbone": [self._at(row) for row in self.backbone],
        }  # fmt: skip

    def _at(self, row: Ends) -> dict[str, Any]:
        """The period in the file's unit of time, and omega in rad/s, at an amplitude."""
        period = {name: row[name] for name in _INVERTED}
        omega = _inverse(row, 2 * pi / SECONDS[self.time])
        return {"amplitude": f"{row['amplitude']:.6g}", "period": _texts(period), "omega": _texts(omega)}

    @property
    def chirps(self) -> bool:
        """Whether the period at the first amplitude is another than at the last."""
        first, last = (self.backbone[0], self.backbone[-1]) if self.backbone else ({}, {})
        return bool(first) and (first["high"] < last["low"] or last["high"] < first["low"])

    def in_words(self) -> str:
        """One line: period, Q(A) and half-life with their intervals."""
        each = self._each(self.quality)
        times = {"period": self.period, "half-life": self.half_life}
        period, life = (f"{k} {_span(v)} {self.time}" if v else "" for k, v in times.items())
        shown = self.backbone[:: len(self.backbone) - 1] if self.chirps else ()
        ends = [f"{_span(row, 5)} at {row['amplitude']:.3g} {self.unit}".rstrip() for row in shown]
        chirp = f"T = {', '.join(ends)}" if ends else ""
        # Where the period depends on the amplitude, as of a pendulum, the two differ, and a law says the other one.
        apart = self.chirps or self.unit in ANGLES
        meant = " (pi over the decrement; of a law it is 2 pi of the energy over its loss)" if apart else ""
        quality = f"Q = {', '.join(each)}{meant}"
        if self.untold:
            quality = f"rate of decay {', '.join(self._each(self.decay_rate))} 1/{self.time}; no Q: {self.untold}"
        parts = (period, chirp, quality, life, self.unsure)
        return "envelope, before any law: " + "; ".join(part for part in parts if part)

    def rows(self) -> list[tuple[str, Ends]]:
        """What is told, one number with its interval for each name."""
        found = [(f"Q at {self._place(row)}", row) for row in self.quality]
        found += [(f"zeta at {self._place(row)}", _inverse(row, 0.5)) for row in self.quality]
        found += [(f"period at {self._place(row)} [{self.time}]", row) for row in self.backbone]
        turn = 2 * pi / SECONDS[self.time]
        found += [(f"omega at {self._place(row)} [rad/s]", _inverse(row, turn)) for row in self.backbone]
        found += [(f"rate of decay at {self._place(row)} [1/{self.time}]", row) for row in self.decay_rate]
        whole = {"period": self.period if not self.backbone else None, "half-life": self.half_life}
        return found + [(f"{name} [{self.time}]", ends) for name, ends in whole.items() if ends is not None]

    def _place(self, row: Ends) -> str:
        return f"{row['amplitude']:.6g} {self.unit}".rstrip()

    def _each(self, rows: tuple[Ends, ...]) -> list[str]:
        return [f"{_span(row)} at {row['amplitude']:.3g} {self.unit}".rstrip() for row in rows]


def envelope(seen: Observations) -> MeasuredEnvelope | None:
    """From the turning points of a run before one is 0, and from its samples where they are few; None without both."""
    # Of two or three points no rest position is known: that they do not stand about 0 would show in their scatter.
    few = len(seen.n) < _FEWEST
    size = np.abs(seen.x - (rest_position(seen) if seen.samples is None and not few else 0.0))
    inside = seen.inside & (np.cumsum(size <= 0) == 0)
    n, size = seen.n[inside], size[inside]
    found = _by_samples(seen) if len(n) < LEAST or _is_rough(seen, size) else None
    if found is not None or len(n) < (_FEWEST if seen.samples is not None else 2):
        return found
    scatter = float(np.mean(seen.sigma_x[inside])) if len(seen.sigma_x) else 0.0
    # The errors of a level are proportional to it; those of a place are alike.
    alike = 1.0 if seen.spacing is None or not len(seen.sigma_x) else seen.sigma_x[inside] / seen.sigma_x[0]
    known = scatter if seen.spacing is None else 0.0
    turns = None
    if seen.samples is not None and _is_one_line(seen.samples):
        turns = line_turns(seen.samples, seen.t[inside], n)
        size = turns.size
    root = None if turns is None else turns.size_root
    angle = _first_angle(seen, size)
    decline = decline_of_few(n, size, known) if len(n) < _FEWEST else decline_of(n, size, known, alike, root, angle)
    if decline is None:
        return None
    times = _turning_times(seen, inside, size, turns, decline) if seen.has_times else None
    ends = np.array([size[0], np.sqrt(size[0] * size[-1]), size[-1]])
    # One loss between two amplitudes is one number, that of the middle, whatever the law is.
    ends = ends[1:2] if len(n) == 2 and not known else ends
    unknown = seen.without_frequency
    quality = () if unknown else tuple(_quality(float(a), decline(float(a)), seen.stride) for a in ends)
    period = None if times is None else _period(times)
    step = None if period is None else period["estimate"]
    if seen.spacing is not None:  # an envelope: n is an artificial clock, and the true period is known
        step = 2 * seen.spacing
        period = None if unknown else dict.fromkeys(("low", "estimate", "high"), step / seen.stride)
    time = seen.time_unit or "s"
    rows, lasts = _backbone(times, time), _lasts(None if seen.spacing is not None else times, step)
    life = None if lasts is None else _half_life(decline, size, lasts)
    period, life = (v and {k: e / SECONDS[time] for k, e in v.items()} for v in (period, life))
    by = () if lasts is None else [lasts(float(a)) / SECONDS[time] for a in ends]
    rates = tuple(_rate(float(a), decline(float(a)), half) for a, half in zip(ends, by))
    untold = "nobody says how fast it swings (--omega0)" if unknown else ""
    unsure = "" if len(n) > 2 or known else "two amplitudes have an interval only with their errors (a column of them)"
    return MeasuredEnvelope(period, quality, life, seen.shown_unit, time, rows, rates, untold, unsure)


def _first_angle(seen: Observations, size: Array) -> float:
    """The first amplitude in rad, where it is an angle; else 0."""
    return float(size[0]) * UNITS[seen.unit] if seen.unit in ANGLES else 0.0


def _is_one_line(samples: Samples) -> bool:
    """Whether a smooth line of more degrees is the motion alone: no second mode, and no base line that wanders."""
    return len(samples.t) >= FEWEST_SAMPLES and not samples.mode and samples.slow is None


def _is_rough(seen: Observations, size: Array) -> bool:
    """Whether so few and so noisy samples a period leave a smooth line too free: its turning points are not known."""
    if seen.samples is None or seen.samples.derivative:
        return False
    t, half = seen.samples.t, float(np.median(np.diff(seen.t) / np.diff(seen.n)))
    return 2 * half / float(np.median(np.diff(t))) < _SPARSE and seen.samples.noise > _ROUGH * float(size[0])


def why_none(seen: Observations) -> str:
    """Why a run has no envelope, in words."""
    sampled = _sampled(seen) is not None
    what = "no damped cosine fits its samples" if sampled else "it has no samples"
    return f"fewer than {_FEWEST if sampled else 2} turning points other than 0, and {what}"


def _sampled(seen: Observations) -> tuple[Array, Array, int] | None:
    """Times and values of the samples of a run, and which derivative of the motion they are."""
    if seen.samples is not None:
        return seen.samples.t, seen.samples.x, seen.samples.derivative
    return None if seen.record is None else (*seen.record, 0)


def _by_samples(seen: Observations) -> MeasuredEnvelope | None:
    """From a damped cosine through the samples; None where there are none, or it does not fit."""
    found = _of_few_swings(seen) or (None if seen.no_law else _of_all_swings(seen))
    if found is None:
        return None
    line, at = found
    size = line.size(at)
    size = size[size > _ENDED * size[0]]
    time = seen.time_unit or "s"
    period = {k: v / SECONDS[time] if v > 0 else inf for k, v in _inverse(line.omega, 2 * pi).items()}
    ends = [float(a) for a in (size[0], np.sqrt(size[0] * size[-1]), size[-1])]
    quality = tuple(_quality(a, line.fall(a), 1.0) for a in ends)
    half = period["estimate"] / 2
    rates = tuple(_rate(a, line.fall(a), half) for a in ends)
    life = _half_life(line.fall, size, lambda _: half)
    return MeasuredEnvelope(period, quality, life, seen.shown_unit, time, (), rates)


def _of_few_swings(seen: Observations) -> tuple[DampedCosine, Array] | None:
    """The damped cosine of a record of a swing or two, and the times of its first and last sample: where no turning
    points are known, or where it leaves nothing but noise, for then they may lie anywhere."""
    if seen.samples is None or (len(seen.n[seen.inside]) >= LEAST and not seen.no_law):
        return None
    t, x = seen.samples.t, seen.samples.x
    found = swings(t, x, seen.samples.derivative)
    if found is None or not (seen.no_law or memory_factor(found[0].residual) == 1):
        return None
    return found[0], t[[0, -1]]


def _of_all_swings(seen: Observations) -> tuple[DampedCosine, Array] | None:
    """A damped cosine as far as the record swings, and the times of its turning points."""
    sampled = _sampled(seen)
    if sampled is None or len(seen.t) < 2:
        return None
    (t, x, derivative), last = sampled, _last_swing(seen.n, seen.t)
    if last < len(seen.t) - 1:
        t, x = t[t <= seen.t[last]], x[t <= seen.t[last]]
    if len(t) < FEWEST_SAMPLES:
        return None
    at = seen.t[: last + 1][seen.inside[: last + 1]]
    rate = -float(np.polyfit(seen.t[: last + 1], np.log(np.maximum(np.abs(seen.x[: last + 1]), 1e-300)), 1)[0])
    omega = np.pi * float((seen.n[last] - seen.n[0]) / (seen.t[last] - seen.t[0]))
    line = damped_cosine(t, x, omega, rate, derivative)
    return None if line is None else (line, at if len(at) > 1 else t[[0, -1]])


def _last_swing(n: Indices, t: Array) -> int:
    """The last turning point before the first half-swing that lasts half as long again as the shorter ones do: what
    follows is no swing, but rest."""
    half = np.diff(t) / np.diff(n)
    usual = float(np.median(np.sort(half)[: (len(half) + 1) // 2]))
    long = np.flatnonzero(half > _REST * usual)
    return int(long[0]) if len(long) and long[0] > 0 else len(t) - 1


def _turning_times(
    seen: Observations, inside: NDArray[np.bool_], size: Array, turns: LineTurns | None, decline: Decline
) -> TurningTimes:
    """The turning times with their errors, and how dry friction delays them where they were measured in samples."""
    n, t, weight = seen.n[inside], seen.t[inside], size / size[0]
    error = seen.sigma_t[inside] if len(seen.sigma_t) else np.zeros(1)
    sampled = seen.samples is not None or seen.window is not None
    if not sampled or len(n) < LEAST:
        return TurningTimes(n, size, t, float(np.mean(error)))
    late = 1 / (np.pi * float(n[-1] - n[0]) / float(t[-1] - t[0]) * size)
    if turns is not None:
        late = late * LINE_LATENESS[turns.harmonics]
        found = TurningTimes(n, size, turns.t, root=turns.time_root, late=late, friction=decline.friction())
        return replace(found, angle=_first_angle(seen, size))
    # An extreme is found by its curvature, the worse the smaller it is.
    late = late * (LINE_LATENESS[1, 3] if seen.window is None else seen.window.lateness(0.0))
    stated = float(np.mean(error * weight))
    found = TurningTimes(n, size, t, stated, weight, late=late, friction=decline.friction())
    return replace(found, angle=_first_angle(seen, size))


def _backbone(times: TurningTimes | None, time: str) -> tuple[Ends, ...]:
    """T(A) in the file's unit of time, where there are turning times."""
    rows = [] if times is None else backbone(times)
    return tuple({k: v if k == "amplitude" else v / SECONDS[time] for k, v in row.items()} for row in rows)


def _lasts(times: TurningTimes | None, step: float | None) -> Callable[[float], float] | None:
    """The time of a half-swing, in which the fall of ln A is told, at an amplitude: of a pendulum it is none for all.

    ``step``: the mean period, or that of an artificial clock.
    """
    if step is None:
        return None
    found = None if times is None else period_at(times, ("estimate",))
    return (lambda _: step / 2) if found is None else (lambda amplitude: found(amplitude)["estimate"] / 2)


def _quality(amplitude: float, fall: Ends, stride: float) -> Ends:
    """Q = pi/2 over the fall in a half-swing; without a limit where that may be 0."""
    ends = {name: pi / 2 * stride / fall[by] if fall[by] > 0 else _endless(fall[by]) for name, by in _INVERTED.items()}
    return {"amplitude": amplitude, **ends}


def _endless(fall: float) -> float:
    """What has no limit where the fall may be 0, and is unknown (nan) where that is."""
    return fall if np.isnan(fall) else inf


def _inverse(row: Ends, of: float) -> Ends:
    """``of`` over the ends of an interval, whose order turns round."""
    return {name: of / row[by] for name, by in _INVERTED.items()}


def _rate(amplitude: float, fall: Ends, half_swing: float) -> Ends:
    return {"amplitude": amplitude, **{name: value / half_swing for name, value in fall.items()}}


def _period(times: TurningTimes) -> Ends:
    """Twice the slope of the turning times; its chirp widens the interval.  Of two it is that of their errors."""
    n, t = times.n, times.t
    if len(n) > 2:
        return mean_period(times)
    middle = 2 * float(np.diff(t)[0] / np.diff(n)[0])
    reach = NORMAL * 2**1.5 * times.stated / float(n[1] - n[0]) if times.stated else np.nan
    return {"low": middle - reach, "estimate": middle, "high": middle + reach}


def _half_life(decline: Callable[[float], Ends], size: Array, lasts: Callable[[float], float]) -> Ends:
    """The time in which ln A falls by ln 2; below the last amplitude as there."""
    top, low = log(size[0]), log(max(float(size.min()), float(size[0]) / 2))
    logs = np.append((top + low + (top - low) * _NODES) / 2, low)
    weight = np.append((top - low) / 2 * _WEIGHTS, low - log(size[0] / 2))
    found, half = [decline(float(a)) for a in np.exp(logs)], np.array([lasts(float(a)) for a in np.exp(logs)])
    ends = {}
    for name, by in _INVERTED.items():
        fall = np.array([each[by] for each in found])
        ends[name] = float(weight @ (half / fall)) if (fall > 0).all() else _endless(float(fall.min()))
    return ends


def _span(ends: Ends, digits: int = 3) -> str:
    low, high = ("-" if not np.isfinite(ends[k]) else f"{ends[k]:.{digits}g}" for k in ("low", "high"))
    middle = f"{ends['estimate']:.{digits}g}" if np.isfinite(ends["estimate"]) else "without limit"
    unknown = np.isnan(ends["low"]) and np.isnan(ends["high"])  # not without a limit: there is no interval
    return middle if unknown or low == middle == high else f"{middle} [{low}, {high}]"


def _texts(ends: Ends | None) -> dict[str, str | None] | None:
    return None if ends is None else {k: f"{v:.6g}" if np.isfinite(v) else None for k, v in ends.items()}
