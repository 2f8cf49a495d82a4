"""Peaks of one side with their times (``t amplitude``): turning points 0, 2, 4, ... of a motion whose samples are gone.

A column that is called amplitude or peak, all above 0, falling nearly always, at nearly even times, is no sampled
swing: it is read as the maxima of one side, a period apart.  A peak that was missed leaves a gap in n; one that a
search for maxima found twice, at both edges of its flat top, counts once.  More rows than an eye or a tracker finds
peaks, or rows further apart than the period that the file says, are a sampled envelope, and so are volts on an even
clock: a lock-in's readings, of which the clock says no period.  Where the name says peak to peak, half of it is the
amplitude.

>>> t = np.array([0.0, 2.0, 4.1, 8.1, 10.0])
>>> peaks_of_one_side("amplitude (cm)", t, np.exp(-0.1 * t))
array([ 0.,  2.,  4.,  8., 10.])
>>> peaks_of_one_side("x (cm)", t, np.exp(-0.1 * t)) is None, is_envelope("amplitude (V)", t, np.exp(-0.1 * t), 1e4)
(True, True)
>>> even = np.arange(6.0)
>>> [is_envelope(name, even, np.exp(-0.1 * even), None) for name in ("amplitude (V)", "amplitude (cm)")]
[True, False]
>>> is_double("peak-to-peak (cm)"), is_double("peak (cm)")
(True, False)
"""

import re

import numpy as np
from numpy.typing import NDArray

from asymptotics.decays.records.units import suffix

Array = NDArray[np.float64]
_NAMES = re.compile(r"ampl|peak|maxim|max\b|scheitel|crest|envelope|h(?:ue|\u00fc)llkurve|magnitude", re.IGNORECASE)
_DOUBLE = re.compile(
    r"peak[ _-]*(?:to|2)?[ _-]*peak|\bp-?p\b|pk-?pk|double[ _]ampl|crest[ _-]*to[ _-]*trough", re.IGNORECASE
)
_LEAST_FALLING, _LINE, _SMALL = 12, 0.5, 0.05
"""Rows that fall by no accident of a swing; and which share of what their cubic leaves is a line, and how small that
is beside the fall.  Choices."""
_VOLTS, _CLOCK = ("v", "mv", "uv", "\u00b5v", "\u03bcv"), 1e-3
"""Units of what a lock-in amplifier reads, and by how much of itself the step of its clock changes, printed."""
_LOCK_IN = re.compile(r"R\b")
"""What a lock-in amplifier calls the magnitude, beside X, Y and theta."""
_HIDDEN, _SWINGING = 5.0, 10.0
"""Standard errors below which an amplitude is its noise, as for extremes (``extraction``); and above which what follows
is none, but swings."""
_CYCLES = re.compile(r"\bcycles?\b", re.IGNORECASE)
_ONE = r"(?:peak|maxim(?:um|a)|crest|cycle|period|oscillation|scheitel|schwingung|periode|pic|pico|oscilaci[o\u00f3]n)"
_NUMBERED = re.compile(
    rf"{_ONE}(?:s|en)?[ _.-]*(?:(?:number|nummer|numero|num|count|index|idx|nr|no)\.?|#)|oscillations|schwingungen"
    rf"|(?:number of|anzahl|no\. of|#)\s*(?:the\s+)?{_ONE}(?:s|en|n)?",
    re.IGNORECASE,
)
_PEAKS, _TURNS, LEAST, _MOST, _FALLING, _EVEN, _FALLS, _APART, _TWICE = 2, 3, 5, 500, 0.8, 0.15, -0.9, 1.5, 0.2
"""Rows that are peaks of one side, turning points of both, and samples of an envelope; more are no peaks; the share of
steps that fall; by how much of a period a peak may be off its place; the correlation of an envelope with the time; how
many periods apart no peaks are; and within which share of a period a second maximum is the same peak."""


def _is_amplitude(name: str) -> bool:
    """Whether a name says so: by a word, or as the letter A."""
    return bool(_NAMES.search(name) or re.match(r"A\b", name))


def peaks_of_one_side(name: str, t: Array, x: Array) -> Array | None:
    """The numbers n of the turning points; None for what is no sequence of peaks."""
    whole = np.isfinite(t) & np.isfinite(x)
    # Two rows under the letter A may be any two amplitudes: their time is no period.
    least = _PEAKS if _NAMES.search(name) else _TURNS
    if not _is_amplitude(name) or not whole.all() or not least <= len(x) <= _MOST or not (x > 0).all():
        return None
    steps = np.diff(t)
    period = float(np.median(steps))
    # Of a slow decay noise makes many a peak larger than the one before: the whole falls all the same.
    if not period > 0 or (np.mean(np.diff(x) < 0) < _FALLING and not _falls(x)):
        return None
    periods = steps / period
    near = (np.abs(periods - np.round(periods)) < _EVEN) & (np.round(periods) >= 1)
    return np.concatenate([[0.0], 2 * np.cumsum(np.round(periods))]) if near.all() else None


def _falls(x: Array) -> bool:
    """Whether values fall from the first to the last, whatever their noise; a swing about a base line does not."""
    # Spearman's correlation with the place.
    order = np.argsort(np.argsort(x))
    return float(np.corrcoef(np.arange(len(order)), order)[0, 1]) < _FALLS


def never_swings(t: Array, x: Array) -> bool:
    """Whether values of one sign fall from the first to the last without a turn: amplitudes, whatever their name.

    What a cubic leaves of their logarithm is small and has no line in its spectrum; a swing on a drift has.

    >>> t = np.arange(40.0)
    >>> noise = 0.01 * np.random.default_rng(1).standard_normal(40)
    >>> [never_swings(t, np.exp(-0.05 * t) * y) for y in (1 + noise, 1 + 0.1 * np.cos(t), np.cos(t))]
    [True, False, False]
    """
    if not _LEAST_FALLING <= len(x) <= _MOST or not np.isfinite(t + x).all() or not (x > 0).all() or not _falls(x):
        return False
    if (np.diff(x) <= 0).all():
        return True
    left = np.log(x) - np.polynomial.Polynomial.fit(t, np.log(x), 3)(t)
    power = np.abs(np.fft.rfft(left)) ** 2
    # A line lies in two neighbouring bins.
    line = float((power[1:] + power[:-1]).max())
    return line < _LINE * float(power.sum()) and float(left.std()) < _SMALL * float(np.ptp(np.log(x)))


def found_twice(t: Array) -> NDArray[np.bool_]:
    """Which rows stand so shortly behind the one before that they are the same peak.

    >>> found_twice(np.array([0.0, 2.0, 2.1, 4.0, 6.0])).tolist(), found_twice(np.array([0.0, 1.0, 3.0])).tolist()
    ([False, False, True, False, False], [False, False, False])
    """
    steps = np.diff(t)
    near = (steps > 0) & (steps < _TWICE * float(np.median(steps))) if len(steps) else np.zeros(0, dtype=bool)
    return np.concatenate([[False], near])


def turns(t: Array, x: Array) -> Array | None:
    """The numbers n of turning points of both sides, a row each; None for what is sampled more finely.

    Signs alternate from row to row and sizes fall, half a period apart: samples of a swing do not keep such a step.

    >>> t = np.arange(9.0)
    >>> turns(t, (-0.9) ** t), turns(t, 0.9**t * np.cos(2.8 * t)) is None
    (array([0., 1., 2., 3., 4., 5., 6., 7., 8.]), True)
    """
    whole = np.isfinite(t) & np.isfinite(x)
    if not whole.all() or not _TURNS <= len(x) <= _MOST or not (x[1:] * x[:-1] < 0).all():
        return None
    steps = np.diff(t)
    even = np.abs(steps / np.median(steps) - 1) < _EVEN if np.median(steps) > 0 else np.zeros(1, dtype=bool)
    falls = np.mean(np.diff(np.abs(x)) < 0) >= _FALLING
    return np.arange(float(len(x))) if even.all() and falls else None


def is_double(name: str) -> bool:
    """Whether a column holds the distance from one side to the other, twice the amplitude."""
    return bool(_DOUBLE.search(name))


def counts_cycles(name: str) -> bool:
    """Whether a column counts whole cycles, each of two half-swings.

    >>> [counts_cycles(name) for name in ("cycle", "Cycles (n)", "n", "peak number", "period (s)")]
    [True, True, False, True, False]
    """
    return bool(_CYCLES.search(name)) or numbers_peaks(name)


def numbers_peaks(name: str) -> bool:
    """Whether a column numbers the peaks of one side, or what else comes once in a period.

    >>> [numbers_peaks(n) for n in ("peak number", "Peak #", "no. of oscillations", "Schwingung Nr.", "peak", "period")]
    [True, True, True, True, False, False]
    """
    return bool(_NUMBERED.fullmatch(name.strip()))


def rows_above_noise(x: Array) -> int:
    """How many rows stand before noise hides the amplitude: all, where none after the largest is 0 or negative, or what
    follows swings; else those before the first below five times what their second differences say.

    >>> x = 10 * np.exp(-0.1 * np.arange(100)) + 0.01 * (-1.0) ** np.arange(100)
    >>> rows_above_noise(x), rows_above_noise(np.abs(x)), rows_above_noise(np.array([-1.0, 2.0, 1.0]))
    (45, 100, 3)
    >>> rows_above_noise(np.cos(np.arange(100) / 8))
    100
    """
    first = int(np.nanargmax(x)) if np.isfinite(x).any() else 0
    if not (x[first:] <= 0).any():
        return len(x)
    noise = float(np.nanmedian(np.abs(np.diff(x[first:], 2)))) / (0.6745 * 6**0.5)
    kept = first + int(np.flatnonzero(x[first:] <= _HIDDEN * noise)[0])
    # One in twenty may be a knock.
    return len(x) if np.nanquantile(np.abs(x[kept:]), 0.95) > _SWINGING * noise else kept


def periods_between(t: Array, frequency: float | None) -> float | None:
    """How many periods lie between rows, where that is more than neighbouring peaks have; else None.

    >>> periods_between(np.array([0.0, 30.0]), 2.0), periods_between(np.array([0.0, 0.5]), 2.0)
    (60.0, None)
    """
    between = 0.0 if frequency is None or len(t) < 2 else float(np.median(np.diff(t))) * frequency
    return between if between > _APART else None


def is_envelope(name: str, t: Array, x: Array, frequency: float | None) -> bool:
    """Whether amplitudes are samples of an envelope: too many for peaks, or further apart than the period."""
    whole = np.isfinite(t) & np.isfinite(x)
    if whole.sum() < LEAST:
        return False
    t, x = t[whole], x[whole]
    apart = periods_between(t, frequency) is not None
    if apart:
        t, x = t[: rows_above_noise(x)], x[: rows_above_noise(x)]
    if len(x) < LEAST or not (x > 0).all():
        return False
    steps = np.diff(t)
    # Whatever its name, what is sampled less than once a period shows no swings.
    if not (apart or _is_amplitude(name) or (_LOCK_IN.match(name) and suffix(name).lower() in _VOLTS)):
        return False
    first = int(np.argmax(x))
    if len(x) - first < LEAST:
        return False
    read = suffix(name).lower() in _VOLTS and float(np.ptp(steps)) < _CLOCK * float(np.median(steps))
    return _falls(x[first:]) and (apart or read or len(x) > _MOST)
