"""Period, Q(A), T(A) and half-life of a record before any law: from the envelope, a smooth curve through amplitudes.

In a half-swing ln A falls by a sum of powers of A (from 1/A to A^3; which of them, by AICc), and Q = pi/2 over this
fall, at the first amplitude, the last and the geometric mean of both, with 95 % intervals of the regression.  No law of
motion enters, and no spring: it is told for every record that swings, whatever the verdict is.  The intervals are those
of all choices of powers whose AICc is near that of the best.  Of four turning points and fewer the samples tell more: a
damped cosine is fitted to them (``damped_cosine``); where there are none, one power at a time.

>>> n = np.arange(30)
>>> found = envelope(Observations.of(n, (-1.0) ** n * np.exp(-0.05 * n), 0.5 * n))
>>> [(f"{q['amplitude']:.3g}", f"{q['estimate']:.4g}") for q in found.quality]
[('1', '31.42'), ('0.484', '31.42'), ('0.235', '31.42')]
>>> f"{found.period['estimate']:.4g}", f"{found.half_life['estimate']:.4g}"
('1', '6.931')
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations
from math import inf, log, pi
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.special import stdtrit

from asymptotics.decays.identification.fitting.starting import rest_position
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.criteria import aicc, memory_factor
from asymptotics.decays.identification.measuring.damped_cosine import damped_cosine
from asymptotics.decays.identification.measuring.observations import Indices, Observations
from asymptotics.decays.identification.telling.backbone import backbone, period_at
from asymptotics.decays.records.units import SECONDS
from asymptotics.numbers.quantities import ANGLES

Ends = dict[str, float]
Decline = Callable[[float], Ends]
_INVERTED = {"low": "high", "estimate": "estimate", "high": "low"}
_POWERS, _TERMS, _LEAST, _GRID, _NEAR = (-1, 0, 1, 2, 3), 3, 5, 101, 4.0
"""Of A, in the fall of ln A: those by the losses of exponents 0 to 3, and of a loss in v^2 beside a pendulum; how many
together; turning points below which there is one power alone; places between an amplitude and half of it; and the AICc
above the best up to which a choice of powers is believed too."""
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
    time; ``backbone``: the period there, of turning times; ``untold``: why there is no Q."""

    period: Ends | None
    quality: tuple[Ends, ...]
    half_life: Ends | None
    unit: str = ""
    time: str = "s"
    backbone: tuple[Ends, ...] = ()
    decay_rate: tuple[Ends, ...] = ()
    untold: str = ""

    def to_dict(self, law_known: bool) -> dict[str, Any]:
        """JSON-ready: numbers are strings, an end without a limit is null."""
        return {
            "period": _texts(self.period), "quality": [_texts(q) for q in self.quality],
            "half_life": _texts(self.half_life), "time_unit": self.time, "law_known": law_known,
            "decay_rate": [_texts(rate) for rate in self.decay_rate], "quality_untold": self.untold or None,
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
        parts = (period, chirp, quality, life)
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
    size = np.abs(seen.x - (rest_position(seen) if seen.samples is None else 0.0))
    inside = seen.inside & (np.cumsum(size <= 0) == 0)
    n, size = seen.n[inside], size[inside]
    found = _by_samples(seen) if len(n) < _LEAST or _is_rough(seen, size) else None
    if found is not None or len(n) < _FEWEST:
        return found
    scatter = float(np.mean(seen.sigma_x[inside])) if len(seen.sigma_x) else 0.0
    # The errors of a level are proportional to it; those of a place are alike.
    alike = 1.0 if seen.spacing is None or not len(seen.sigma_x) else seen.sigma_x[inside] / seen.sigma_x[0]
    decline = _decline(n, size, scatter if seen.spacing is None else 0.0, alike)
    if decline is None:
        return None
    ends = np.array([size[0], np.sqrt(size[0] * size[-1]), size[-1]])
    unknown = seen.without_frequency
    quality = () if unknown else tuple(_quality(float(a), decline(float(a)), seen.stride) for a in ends)
    period = _period(n, seen.t[inside]) if seen.has_times else None
    step = None if period is None else period["estimate"]
    if seen.spacing is not None:  # an envelope: n is an artificial clock, and the true period is known
        step = 2 * seen.spacing
        period = None if unknown else dict.fromkeys(("low", "estimate", "high"), step / seen.stride)
    time = seen.time_unit or "s"
    rows, lasts = _backbone(seen, inside, size, time), _lasts(seen, inside, size, step)
    life = None if lasts is None else _half_life(decline, size, lasts)
    period, life = (v and {k: e / SECONDS[time] for k, e in v.items()} for v in (period, life))
    by = () if lasts is None else [lasts(float(a)) / SECONDS[time] for a in ends]
    rates = tuple(_rate(float(a), decline(float(a)), half) for a, half in zip(ends, by))
    untold = "nobody says how fast it swings (--omega0)" if unknown else ""
    return MeasuredEnvelope(period, quality, life, seen.shown_unit, time, rows, rates, untold)


def _is_rough(seen: Observations, size: Array) -> bool:
    """Whether so few and so noisy samples a period leave a smooth line too free: its turning points are not known."""
    if seen.samples is None or seen.samples.derivative:
        return False
    t, half = seen.samples.t, float(np.median(np.diff(seen.t) / np.diff(seen.n)))
    return 2 * half / float(np.median(np.diff(t))) < _SPARSE and seen.samples.noise > _ROUGH * float(size[0])


def why_none(seen: Observations) -> str:
    """Why a run has no envelope, in words."""
    what = "no damped cosine fits its samples" if _sampled(seen) is not None else "it has no samples"
    return f"no envelope: fewer than {_FEWEST} turning points other than 0, and {what}"


def _sampled(seen: Observations) -> tuple[Array, Array, int] | None:
    """Times and values of the samples of a run, and which derivative of the motion they are."""
    if seen.samples is not None:
        return seen.samples.t, seen.samples.x, seen.samples.derivative
    return None if seen.record is None else (*seen.record, 0)


def _by_samples(seen: Observations) -> MeasuredEnvelope | None:
    """From a damped cosine through the samples; None where there are none, or it does not fit."""
    sampled = _sampled(seen)
    if sampled is None or len(seen.t) < 2:
        return None
    (t, x, derivative), last = sampled, _last_swing(seen.n, seen.t)
    t, x = t[t <= seen.t[last]], x[t <= seen.t[last]]
    at = seen.t[: last + 1][seen.inside[: last + 1]]
    rate = -float(np.polyfit(seen.t[: last + 1], np.log(np.maximum(np.abs(seen.x[: last + 1]), 1e-300)), 1)[0])
    omega = np.pi * float((seen.n[last] - seen.n[0]) / (seen.t[last] - seen.t[0]))
    line = damped_cosine(t, x, omega, rate, derivative)
    if line is None:
        return None
    size = line.size(at if len(at) > 1 else t[[0, -1]])
    size = size[size > _ENDED * size[0]]
    time = seen.time_unit or "s"
    period = {k: v / SECONDS[time] if v > 0 else inf for k, v in _inverse(line.omega, 2 * pi).items()}
    ends = [float(a) for a in (size[0], np.sqrt(size[0] * size[-1]), size[-1])]
    quality = tuple(_quality(a, line.fall(a), 1.0) for a in ends)
    half = period["estimate"] / 2
    rates = tuple(_rate(a, line.fall(a), half) for a in ends)
    life = _half_life(line.fall, size, lambda _: half)
    return MeasuredEnvelope(period, quality, life, seen.shown_unit, time, (), rates)


def _last_swing(n: Indices, t: Array) -> int:
    """The last turning point before the first half-swing that lasts half as long again as the shorter ones do: what
    follows is no swing, but rest."""
    half = np.diff(t) / np.diff(n)
    usual = float(np.median(np.sort(half)[: (len(half) + 1) // 2]))
    long = np.flatnonzero(half > _REST * usual)
    return int(long[0]) if len(long) and long[0] > 0 else len(t) - 1


def _backbone(seen: Observations, inside: NDArray[np.bool_], size: Array, time: str) -> tuple[Ends, ...]:
    """T(A) in the file's unit of time, where there are turning times."""
    if not seen.has_times:
        return ()
    error = float(np.mean(seen.sigma_t[inside])) if len(seen.sigma_t) else 0.0
    rows = backbone(seen.n[inside], size, seen.t[inside], error)
    return tuple({k: v if k == "amplitude" else v / SECONDS[time] for k, v in row.items()} for row in rows)


def _lasts(
    seen: Observations, inside: NDArray[np.bool_], size: Array, step: float | None
) -> Callable[[float], float] | None:
    """The time of a half-swing, in which the fall of ln A is told, at an amplitude: of a pendulum it is none for all.

    ``step``: the mean period, or that of an artificial clock.
    """
    if step is None:
        return None
    found = period_at(seen.n[inside], size, seen.t[inside], 0.0) if seen.has_times and seen.spacing is None else None
    return (lambda _: step / 2) if found is None else (lambda amplitude: found(amplitude)["estimate"] / 2)


def _decline(n: Indices, size: Array, stated: float, error: Array | float) -> Decline | None:
    """What ln A loses in a half-swing at an amplitude: the sum of powers of A that the criterion chooses."""
    gap = np.diff(n)
    # The geometric mean is the amplitude in the middle of a half-swing; sums forgive noise where differences would not.
    middle = np.sqrt(size[1:] * size[:-1]) / size[0]
    sums = {k: -np.concatenate([[0.0], np.cumsum(gap * middle**k)]) for k in _POWERS}
    # Of a few points all choices of one power have as many numbers: their sums of squares alone compare them.
    few = len(n) < _LEAST
    sets = [c for count in range(1, (1 if few else _TERMS) + 1) for c in combinations(_POWERS, count)]
    weight = size / size[0] / error  # where the errors of the amplitudes are alike, those of their logarithms are not
    found = []
    for powers in sets:
        V = np.stack([np.ones(len(size)), *(sums[k] for k in powers)], axis=1) * weight[:, None]
        y = weight * np.log(size)
        # The rest position was taken from them too, which counts where they are few.
        c, freedom = np.linalg.lstsq(V, y, rcond=None)[0], max(len(size) - V.shape[1] - few, 1)
        left = y - V @ c
        rss = max(float((left**2).sum()), 1e-24)
        deviance = len(y) * log(rss / len(y))
        value = deviance if few else aicc(deviance, V.shape[1] + 1, len(y))
        if np.isfinite(value):
            # What is told of the amplitudes elsewhere counts where it is more than the scatter, as for a smooth line.
            noise = max(rss / freedom, (stated / size[0]) ** 2) * memory_factor(left)
            covariance = (np.linalg.pinv(V.T @ V) * noise)[1:, 1:] * float(stdtrit(freedom, 0.975)) ** 2
            found.append((value, _Fall(powers, c[1:], covariance)))
    if not found:
        return None
    least = min(value for value, _ in found)
    near = [fall for value, fall in sorted(found, key=lambda pair: pair[0]) if value < least + _NEAR]

    def decline(amplitude: float) -> Ends:
        each = [fall.at(amplitude / size[0]) for fall in near]
        return {
            "low": min(value - error for value, error in each), "estimate": each[0][0],
            "high": max(value + error for value, error in each),
        }  # fmt: skip

    return decline


@dataclass(frozen=True)
class _Fall:
    """The fall of ln A in a half-swing as a sum of powers; ``covariance``: times the square of the quantile."""

    powers: tuple[int, ...]
    coefficients: Array
    covariance: Array

    def at(self, amplitude: float) -> tuple[float, float]:
        by = np.array([amplitude**k for k in self.powers])
        return float(by @ self.coefficients), float(np.sqrt(by @ self.covariance @ by))


def _quality(amplitude: float, fall: Ends, stride: float) -> Ends:
    """Q = pi/2 over the fall in a half-swing; without a limit where that may be 0."""
    ends = {name: pi / 2 * stride / fall[by] if fall[by] > 0 else inf for name, by in _INVERTED.items()}
    return {"amplitude": amplitude, **ends}


def _inverse(row: Ends, of: float) -> Ends:
    """``of`` over the ends of an interval, whose order turns round."""
    return {name: of / row[by] for name, by in _INVERTED.items()}


def _rate(amplitude: float, fall: Ends, half_swing: float) -> Ends:
    return {"amplitude": amplitude, **{name: value / half_swing for name, value in fall.items()}}


def _period(n: Indices, t: Array) -> Ends:
    """Twice the slope of the turning times; its chirp widens the interval."""
    line, deviation = np.polyfit(n, t, 1, cov=True)
    reach = 2 * float(np.sqrt(deviation[0, 0])) * float(stdtrit(len(n) - 2, 0.975))
    middle = 2 * float(line[0])
    return {"low": middle - reach, "estimate": middle, "high": middle + reach}


def _half_life(decline: Decline, size: Array, lasts: Callable[[float], float]) -> Ends:
    """The time in which ln A falls by ln 2; below the last amplitude as there."""
    grid = np.linspace(log(size[0] / 2), log(size[0]), _GRID)
    places = [max(float(np.exp(s)), float(size.min())) for s in grid]
    found, half = [decline(a) for a in places], np.array([lasts(a) for a in places])
    ends = {}
    for name, by in _INVERTED.items():
        fall = np.array([each[by] for each in found])
        ends[name] = float(np.trapezoid(half / fall, grid)) if (fall > 0).all() else inf
    return ends


def _span(ends: Ends, digits: int = 3) -> str:
    low, high = ("-" if not np.isfinite(ends[k]) else f"{ends[k]:.{digits}g}" for k in ("low", "high"))
    middle = f"{ends['estimate']:.{digits}g}" if np.isfinite(ends["estimate"]) else "without limit"
    return middle if low == middle == high else f"{middle} [{low}, {high}]"


def _texts(ends: Ends | None) -> dict[str, str | None] | None:
    return None if ends is None else {k: f"{v:.6g}" if np.isfinite(v) else None for k, v in ends.items()}
