"""Defects of a record: what stops the analysis, and what the answer must mention."""

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.sampled import LEAST_SAMPLES
from asymptotics.decays.records.rows import RowPlaces
from asymptotics.errors import InputError
from asymptotics.present.counts import many

Flags = np.ndarray[tuple[int], np.dtype[np.bool_]]
_MOST_CLIPPED = 0.6
"""The share of samples that must be whole: with less the phases near the turning points are never seen.  A choice; it
refuses."""
_PLATEAU = 4
"""Equal samples that make a plateau on their own, if it is entered and left at speed."""


def usable(t: Array, x: Array, rows: RowPlaces) -> Flags:
    """Which samples are not clipped; InputError for a record that is too short, constant, or clipped for the most
    part."""
    if len(t) < LEAST_SAMPLES:
        raise InputError(
            "FILE", f"{rows.name} has {many(len(t), 'row')} with numbers", f"at least {LEAST_SAMPLES} samples"
        )
    if not np.ptp(x) > 0:
        raise InputError("FILE", f"{rows.name}, column x: all values are {x[0]:g}", "a motion")
    whole = np.ones(len(x), dtype=bool)
    for extreme, word in ((x.max(), "largest"), (x.min(), "smallest")):
        runs = _runs(x == extreme)
        # Two equal extreme samples are ordinary in a quantised record, and one is the extreme itself.
        long = [run for run in runs if run[1] - run[0] >= 3]
        sharp = [run for run in long if run[1] - run[0] >= _PLATEAU and _is_sharp(x, *run)]
        # One plateau that is entered at speed, or three that are so in the median: a single slow one is a hand that
        # holds, or rest.
        if sharp or (len(long) >= 3 and _is_cut(x, long, float(extreme))):
            whole[x == extreme] = False
        if whole.mean() < _MOST_CLIPPED:
            where = rows.where(int(np.argmin(whole)), "x")
            reason = f"{where}: {1 - whole.mean():.0%} of the samples are clipped at the {word} value {extreme:g}"
            raise InputError("FILE", reason, "a record whose peaks are whole")
    return whole


def _runs(flags: np.ndarray[tuple[int], np.dtype[np.bool_]]) -> list[tuple[int, int]]:
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]]).astype(int)))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist()))


def _is_sharp(x: Array, start: int, stop: int) -> bool:
    """Whether a plateau is entered and left faster than rest, steps of the last digit and noise allow.

    From rest the first two steps, a/2 and 3a/2, sum to twice the second difference a; a hand that holds the body
    before its release leaves a plateau so.
    """
    # Eight samples on each side, the nearest first; five of them measure the second difference.
    before, after = x[max(start - 8, 0) : start][::-1], x[stop : stop + 8]
    steps = np.abs(np.diff(x))
    quantum = float(steps[steps > 0].min())
    for outside in (before, after):
        if len(outside) < 5:
            return False
        away = np.diff(outside, prepend=x[start])
        bend = float(np.abs(np.diff(away[1:5])).max())
        # From rest it would be 2 bend: 3 leaves room for noise, 4 steps of the last digit for rounding.
        if float(np.abs(away[:2]).sum()) < 4 * quantum + 3 * bend:
            return False
    return True


def _is_cut(x: Array, runs: list[tuple[int, int]], extreme: float) -> bool:
    """Whether the record enters the plateau at speed: a whole peak, even a quantised one, rises slowly to its top."""
    entries = []
    for start, _ in runs:
        before = x[max(start - 2, 0) : start]
        if len(before) == 2:
            entries.append(abs(extreme - before[1]) + abs(before[1] - before[0]))
    steps = np.abs(np.diff(x))
    quantum = float(steps[steps > 0].min())
    return bool(entries) and float(np.median(entries)) > 4 * quantum and np.median([b - a for a, b in runs]) >= 3


def shape_notes(t: Array, x: Array, turning: Array, sigma: Array, period: float) -> list[str]:
    """Growth, and amplitudes that beat: signs of a second mode, of forcing, or of self-excitation."""
    size = np.abs(turning)
    notes = []
    # Beyond five standard errors of both ends: noise does not.
    if size[-1] > size[0] + 5 * (sigma[0] + sigma[-1]):
        notes.append("the amplitude grows: this is not a decay")
    # Turning points of one side, so that an offset makes no rise; 1e-6 is what the fit of an extreme leaves without
    # noise.
    rise = np.diff(size[::2]) > 6 * (sigma[::2][1:] + sigma[::2][:-1]) + 1e-6 * size[0]
    # One may be a knock, which is cut elsewhere.
    if rise.sum() >= 2:
        notes.append(f"the amplitude rises {rise.sum()} times: a second mode, forcing, or an unquiet base")
    gap = float(np.diff(t).max())
    # A fifth of a period hides an extreme or a passage.
    if gap > 0.2 * period:
        notes.append(f"the longest gap between samples is {gap:.3g}, {gap / period:.2g} periods")
    return notes


def is_growing(size: Array) -> bool:
    """Whether the last third of the amplitudes exceeds the first third."""
    third = max(1, len(size) // 3)
    return bool(np.mean(np.abs(size[-third:])) > np.mean(np.abs(size[:third])))


def is_constant(size: Array) -> bool:
    """Whether a straight line through the amplitudes has no slope beyond 4 standard errors, nor they another shape.

    Then one number is seen, the mean amplitude: no exponent, no spring (it is a shift of the frequency).
    """
    # Too few to tell a slope from noise: then the amplitude is not called constant.
    if len(size) < 8:
        return False
    n = np.linspace(-1.0, 1.0, len(size))
    steps = np.diff(size)
    # Differences of neighbours know the noise whatever the trend is (von Neumann's ratio, 1941).
    noise = float(np.sqrt((steps**2).sum() / (2 * len(steps))))
    slope = float(n @ size) / float(n @ n)
    # 1.5: white noise has a ratio near 1, a smooth shape a larger one. Both limits are choices, which only keep laws
    # from being compared that the data cannot tell apart.
    return bool(abs(slope) < 4 * noise / np.sqrt(n @ n) and size.std() < 1.5 * noise)
