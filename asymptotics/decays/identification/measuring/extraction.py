"""Turning points and passages of a sampled record, by local polynomials with propagated errors.

The record may be uneven, have gaps and NaN, drift, a forced beginning and a noisy tail.  In turn: rows without numbers
go; the period is found in the spectrum; a smoothed copy gives the lobes between passages through the base line; around
each extreme and each passage a polynomial is fitted to the raw samples, and its extreme (or root) is taken with the
error that follows from the residuals and their correlation; the base line (offset and drift) is fitted to the means
(x_(n-2) + 4 x_(n-1) + 6 x_n + 4 x_(n+1) + x_(n+2))/16, in which a decay leaves its fourth difference only, and
everything is done once more about it; the free decay begins at the largest turning point, and ends where the
amplitude sinks into the noise.  What was discarded is said in ``notes``.

>>> t = np.linspace(0, 60, 6001)
>>> seen = observations_of_record(t, np.exp(-0.02 * t) * np.cos(2 * t))
>>> seen.last, bool(np.allclose(np.diff(seen.t), np.pi / 2, atol=1e-5))
(36, True)
"""

from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.counted_swings import EXACT, half_swings_between, start_of_freedom
from asymptotics.decays.identification.measuring.defects import shape_notes, usable
from asymptotics.decays.identification.measuring.extremes import (
    SAMPLES,
    WIDEST,
    WINDOW,
    Extremes,
    extremes_of,
    half_width,
)
from asymptotics.decays.identification.measuring.few_swings import observations_of_few_swings
from asymptotics.decays.identification.measuring.late_extremes import DEGREE, Window
from asymptotics.decays.identification.measuring.main_frequency import dominant_period
from asymptotics.decays.identification.measuring.observations import Indices, Observations, Samples
from asymptotics.decays.identification.measuring.quiet_times import quiet_times
from asymptotics.decays.identification.measuring.sampled import MAX_SAMPLES, observations_of_motion
from asymptotics.decays.records.rows import RowPlaces
from asymptotics.decays.records.table import RecordTable
from asymptotics.decays.records.units import UNITS
from asymptotics.errors import InputError
from asymptotics.numbers.quantities import ANGLES
from asymptotics.present.counts import many

_RECORD = RowPlaces("the record")
_COARSE = 2e-4
"""What the widest local fit leaves without noise, as ``EXACT`` of the narrowest."""
_LEAST_SAMPLES = 22
"""Samples a period below which extremes cannot be fitted."""
# Below this the spectrum and the lobes are too coarse: the motion is fitted.
_LEAST_ROWS = 50
_FAR = 1.4
"""Radians beyond which the flat extremes and the growing half periods of a pendulum are no cosines any more."""
_SPARSE, _NOISY, _DEEP = 100.0, 2e-3, 8.0
"""Extremes tell less than the samples do where the noise is above 0.002 of the first amplitude and the samples are
fewer than 100 a period, or the decay comes nearer to the noise than eight times: then the motion is fitted.  The first
is also the least number of samples of an uneven record whose extremes are fitted."""
_FEW_EXTREMES = 20
"""So few extremes tell their noise badly, the more so where it remembers; samples whose noise is seen tell it well."""
_LEAST_EXTREMES, _SCARCE, _LOUD = 4, 8, 0.02
"""Extremes of a free decay; and where they are fewer than 8 under a noise above 0.02 of the largest, the samples are
fitted however short the record is: a local polynomial loses such extremes, or moves them."""
_STRONG = 3.0
"""How much further the motion was before its first extreme, for a swing of which so little is left that what follows
tells no amplitude before it.  A choice, that of ``judgement.outside``."""
_FALLEN = 0.1
"""Of the first value, at which a first fall is over."""
# Nine tenths of the gaps must be below twice the usual one, or a window has too few samples somewhere.
_UNEVEN = 2.0
_FOUND = 0.75
"""Of the extremes: below this share the usual gap between two of them would soon be two half-swings.  A choice."""
_FEW = 1.0
"""Extremes a period (there are two) below which a line is taken off before the passages are sought."""
# Binomial weights: the alternating part cancels up to its fourth difference, in short records up to the second.
_MEANS, _FEW_MEANS = np.array([1.0, 4.0, 6.0, 4.0, 1.0]) / 16, np.array([1.0, 2.0, 1.0]) / 4


def observations_of_record(
    t: Array, x: Array, *, unit: str = "", rows: RowPlaces = _RECORD, whole_motion: bool = False
) -> Observations:
    """Turning points, turning times and passages of a sampled motion; InputError for a record that has none.

    ``whole_motion``: all samples are to be fitted, wherever a smooth line through them can be begun.
    """
    columns = {"t": np.asarray(t, dtype=float), "x": np.asarray(x, dtype=float)}
    table = RecordTable("record", columns, unit, rows).whole()
    t, x, rows, name, notes = table.columns["t"], table.columns["x"], table.rows, rows.name, list(table.notes)
    whole = usable(t, x, rows)
    back = np.flatnonzero(np.diff(t) <= 0)
    if len(back):
        raise InputError("FILE", f"{rows.where(int(back[0]) + 1, 't')}: the time does not increase", "increasing times")
    if not whole.all():
        said = f"{int((~whole).sum())} clipped samples masked, the first is row {rows.row(int(np.argmin(whole)))}"
        return observations_of_motion(t[whole], x[whole], unit=unit, name=name, notes=(*table.notes, said))
    if len(t) < _LEAST_ROWS:
        return observations_of_motion(t, x, unit=unit, name=name, notes=table.notes)
    period = dominant_period(t, x)
    per_period = period / float(np.median(np.diff(t)))
    steps = np.diff(t)
    uneven = float(np.quantile(steps, 0.9)) > _UNEVEN * float(np.median(steps))
    if per_period < (_SPARSE if uneven else _LEAST_SAMPLES):
        return observations_of_motion(t, x, unit=unit, name=name, notes=table.notes)
    period, found, base = _with_extremes(t, x, period)
    if len(found.x) < 4 or _is_full_of_gaps(found, period):
        return observations_of_motion(t, x, unit=unit, name=name, notes=table.notes)
    # A drift below three errors is removed all the same, but not worth telling.
    if abs(base[1]) * (t[-1] - t[0]) > 3 * np.median(found.sigma_x):
        notes.append(f"base line {base[0]:.4g} and drift {base[1]:.3g} a second removed")
    else:
        notes.append(f"base line {base[0]:.4g} removed")
    chosen, discarded = _free_decay(found)
    if _is_scarce(found, chosen, x):
        free = t >= (found.t[chosen[0]] if len(chosen) else t[0])
        return observations_of_motion(t[free], x[free], unit=unit, name=name, notes=table.notes, period=period)
    if len(chosen) < _LEAST_EXTREMES:
        free = t >= (found.t[chosen[0]] if len(chosen) else t[0])
        kept = (*table.notes, *discarded, f"of a free decay only {many(len(chosen), 'turning point')}")
        return observations_of_few_swings(t[free], x[free], unit=unit, name=name, notes=kept)
    # Windows of nine samples for seven coefficients throw most of a sparse record away: noise that is seen is enough.
    sparse = per_period < SAMPLES / WINDOW
    noisy = found.noise > (_COARSE if sparse else _NOISY) * abs(found.x[chosen[0]])
    hard = per_period < _SPARSE or abs(found.x[chosen[-1]]) < _DEEP * found.noise
    # Of a few periods the smooth line has too little to begin with.
    few = len(chosen) < _FEW_EXTREMES and found.noise > _COARSE * abs(found.x[chosen[0]])
    if (whole_motion or few or noisy and hard) and (t[-1] - t[0]) / period > 4:
        free, told = _to_passages(found, chosen, t, x - base[0] - base[1] * (t - t[0]))
        kept = (*table.notes, *discarded, *told)
        return observations_of_motion(t[free], x[free], unit=unit, name=name, notes=kept, period=period)
    found = _at_quiet_times(t, x - base[0] - base[1] * (t - t[0]), found, chosen, half_width(t, period))
    notes += discarded + shape_notes(t, x, found.x[chosen], found.sigma_x[chosen], period)
    seen = _assembled(found, chosen, unit, name, [*notes, f"sample noise {found.noise:.3g}"])
    if unit in ANGLES and abs(found.x[chosen[0]]) * UNITS[unit] > _FAR and len(t) <= MAX_SAMPLES:
        free = (t >= seen.t[0]) & (t <= seen.t[-1])
        samples = Samples(t[free], x[free], found.noise, float(free.sum()))
        far = f"angles beyond {np.degrees(_FAR):.0f} degrees: all {free.sum()} samples fitted"
        error = np.full(len(seen.n), found.noise)
        return replace(seen, samples=samples, notes=(*seen.notes, far), sigma_x=error, sigma_t=error / seen.reference)
    half = half_width(t, period)
    floor = float(np.interp(half / period, (WINDOW, WIDEST), (EXACT, _COARSE)))
    free = (t >= seen.t[0]) & (t <= seen.t[-1])
    record = t[free], (x - base[0] - base[1] * (t - t[0]))[free]
    return replace(seen, window=Window.of(t, seen.t, half, 2 * np.pi / period), floor=floor, record=record)


def _to_passages(found: Extremes, chosen: Indices, t: Array, x: Array) -> tuple[NDArray[np.bool_], list[str]]:
    """Which samples lie between the first chosen extreme and the last, and on to the passage beside it where nothing
    was left out there; not before a first one of a swing that leaves little, which is told.

    At its very ends a smooth line is known badly; who passes the base line is free.
    """
    first, last = float(found.t[chosen[0]]), float(found.t[chosen[-1]])
    before, after = found.passage_t[found.passage_t < first], found.passage_t[found.passage_t > last]
    half, told = float(np.median(np.diff(found.t))), []
    if chosen[0] == 0 and len(before) and first - before[-1] < half:
        start, left = float(np.abs(x[t < first]).max()), abs(float(found.x[0]))
        if start > _STRONG * left:
            told = [f"the first swing, from {start:.3g} to {left:.3g}, is not fitted: what follows tells little of it"]
        else:
            first = float(before[-1])
    if chosen[-1] == len(found.t) - 1 and len(after) and after[0] - last < half:
        last = float(after[0])
    return (t >= first) & (t <= last), told


def _with_extremes(t: Array, x: Array, period: float) -> tuple[float, Extremes, Array]:
    """The period, the extremes and the base line; where they are too few, those with the period of what follows the
    first fall from a release: where that takes nine tenths, the spectrum of the whole is that of the fall."""
    found, base = _about_base_line(t, x, period)
    if len(found.x) >= _LEAST_EXTREMES:
        return period, found, base
    away = np.abs(x - np.median(x))
    fallen = np.flatnonzero(away < _FALLEN * away[0])
    if not len(fallen) or len(t) - fallen[0] <= _LEAST_ROWS:
        return period, found, base
    rest = dominant_period(t[fallen[0] :], x[fallen[0] :])
    behind, level = _about_base_line(t, x, rest)
    # Noise has extremes too.
    if len(behind.x) >= _LEAST_EXTREMES and abs(behind.x[0]) > _DEEP * behind.noise:
        return rest, behind, level
    return period, found, base


def _about_base_line(t: Array, x: Array, period: float) -> tuple[Extremes, Array]:
    """The extremes and passages about the base line, and its level and slope."""
    base = np.array([float(np.median(x)), 0.0])
    found = extremes_of(t, x - base[0], period)
    if len(found.x) < _FEW * (t[-1] - t[0]) / period:  # the drift hides the passages
        slope, level = np.polyfit(t - t[0], x, 1)
        base = np.array([level, slope])
        found = extremes_of(t, x - base[0] - base[1] * (t - t[0]), period)
    # Each pass leaves a fraction of the offset: extremes about a wrong base line are moved by it.
    for _ in range(2):
        base = base + _base_line(found, t[0])
        found = extremes_of(t, x - base[0] - base[1] * (t - t[0]), period)
    return found, base


def _at_quiet_times(t: Array, x: Array, found: Extremes, chosen: Indices, half: float) -> Extremes:
    """The extremes with their values at the times of a smooth curve through all turning times (``quiet_times``)."""
    times = quiet_times(
        found.t[chosen], found.x[chosen], found.sigma_t[chosen], found.passage_t, half_swings_between(found.t[chosen])
    )
    if times is None:
        return found
    values = found.x.copy()
    for place, centre in zip(chosen, times):
        low, high = np.searchsorted(t, [centre - half, centre + half])
        u = (t[low:high] - centre) / half
        # Two data to spare, and samples on both sides: an extreme is never extrapolated.
        if len(u) >= DEGREE + 3 and u[0] < -0.7 and u[-1] > 0.7:
            V = np.vander(u, DEGREE + 1, increasing=True)
            values[place] = np.linalg.solve(V.T @ V, V.T @ x[low:high])[0]
    return replace(found, x=values)


def _base_line(found: Extremes, start: float) -> Array:
    """Offset at the start and drift from the means of neighbours, weighted by the amplitude's smallness."""
    x, t = found.x, found.t
    weights = _MEANS if len(x) >= 12 else _FEW_MEANS
    if len(x) < len(weights):
        return np.zeros(2)
    side = len(weights) // 2
    middle, time = np.convolve(x, weights, mode="valid"), t[side:-side]
    # Only where all five alternate does their mean cancel the motion.
    alternate = np.convolve(np.sign(x[1:]) * np.sign(x[:-1]) >= 0, np.ones(2 * side), mode="valid") < 0.5
    if alternate.sum() < 3:
        return np.zeros(2)
    middle, time = middle[alternate], time[alternate]
    # Four median deviations: a knock does not bend the line.
    near = np.abs(middle - np.median(middle)) <= 4 * np.median(np.abs(middle - np.median(middle))) + 1e-300
    # A drift from fewer means would be the noise's.
    if near.sum() < 8:
        return np.array([float(np.median(middle)), 0.0])
    slope, level = np.polyfit(time[near] - start, middle[near], 1)
    return np.array([level, slope])


def _free_decay(found: Extremes) -> tuple[Indices, list[str]]:
    """Indices of the free decay: from the largest turning point to the first that the noise hides."""
    size, notes, turning = np.abs(found.x), [], partial(many, thing="turning point")
    first = int(np.argmax(size >= size.max() - 4 * float(np.median(found.sigma_x))))  # noise alone makes none larger
    if first > len(size) // 2:  # a growing record: nothing to cut off
        first = 0
    else:
        started = start_of_freedom(found.t[first:])
        if started:
            notes.append(f"{turning(started)} after the release, with disturbed durations, left out")
        first += started
    # Below five standard errors an extreme is chosen by its noise.
    hidden = np.flatnonzero(size[first:] < 5 * found.sigma_x[first:])
    last = first + int(hidden[0]) if len(hidden) else len(size)
    chosen = np.arange(first, last)
    # Signs alternate over an odd number of half-swings; where they do not, one was lost or invented.
    side = np.sign(found.x[chosen])
    same = np.flatnonzero((side[1:] * side[:-1] >= 0) != (half_swings_between(found.t[chosen]) % 2 == 0))
    if len(same):
        chosen = chosen[: same[0] + 1]
        notes.append(f"from t = {found.t[chosen[-1]]:.6g} on, extremes do not alternate: left out")
    if first:
        notes.append(f"{turning(first)} in all before t = {found.t[first]:.6g} left out: forced or released")
    if last < len(size):
        notes.append(f"{turning(len(size) - last)} hidden by noise (t > {found.t[last - 1]:.6g}) left out")
    return chosen, notes


def _is_full_of_gaps(found: Extremes, period: float) -> bool:
    """Whether cells that are missing here and there leave so few of the extremes that they cannot be counted."""
    loud = found.t[np.abs(found.x) > 5 * found.sigma_x]
    return len(loud) > 1 and len(loud) - 1 < _FOUND * (loud[-1] - loud[0]) / (period / 2)


def _is_scarce(found: Extremes, chosen: Indices, x: Array) -> bool:
    """Whether the extremes are so few and so noisy that the samples tell more."""
    # Neighbours of white noise differ by sqrt(2) of it, half of them by less than 0.6745 of that; steps and kinks,
    # which no polynomial follows, are none.
    scatter = float(np.median(np.abs(np.diff(x)))) / (0.6745 * 2**0.5)
    return len(chosen) < _SCARCE and min(found.noise, scatter) > _LOUD * float(np.abs(found.x).max())


def _assembled(found: Extremes, chosen: Indices, unit: str, name: str, notes: list[str]) -> Observations:
    """Numbers by the clock, so that a gap in the record is a gap in n; passages between the chosen extremes."""
    t = found.t[chosen]
    steps = half_swings_between(t)
    n = np.concatenate([[0], np.cumsum(steps)]).astype(int)
    inside = (found.passage_t > t[0]) & (found.passage_t < t[-1])
    p, s = found.passage_t[inside], found.sigma_passage[inside]
    place = np.searchsorted(t, p) - 1
    # Across a gap the number of a passage is not known.
    whole = np.concatenate([steps == 1, [False]])[place]
    seen = Observations.of(
        n, found.x[chosen], t, passage_n=n[place[whole]], passage_t=p[whole], sigma_x=found.sigma_x[chosen],
        sigma_t=found.sigma_t[chosen], sigma_passage=s[whole], unit=unit, name=name, notes=notes,
    )  # fmt: skip
    return replace(seen, x=found.x[chosen])
