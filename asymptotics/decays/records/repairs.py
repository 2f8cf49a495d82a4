"""What stands in a record beside one free decay: spikes, which are left out, and several releases, which are cut apart.

>>> t = np.arange(0, 60, 0.02)
>>> x = np.exp(-0.05 * t) * np.cos(5 * t)
>>> x[700] = 9.99
>>> np.flatnonzero(spikes(x)).tolist()
[700]
>>> twice = np.concatenate([x[:1500], np.full(300, 1.1), 1.1 * x[:1500]])
>>> [(int(p[0]), int(p[-1])) for p in releases(np.arange(len(twice)) * 0.02, twice)]
[(0, ...), (..., 3299)]
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from asymptotics.numbers.context import lru_cache

Array = NDArray[np.float64]
Places = NDArray[np.intp]
_FAR, _TALL, _MOST = 20.0, 0.3, 0.02
"""A spike misses the cubic through its neighbours by so many typical misses and by this share of the motion; where more
than so many of the samples do, they are no spikes."""
_A_PERIOD, _LEAST_PERIODS, _MOST_RELEASES = 24, 4, 12
"""Samples of a period that are looked at; periods of a decay that is worth a run; more releases than this are no
releases, and the record stays whole."""
NOISE, _GROWN, _HELD, _SHAPE, _JUMP, _NODE = 8.0, 1.3, 0.1, 0.25, 0.4, 0.6
"""A swing larger by this than a period before, and by so many times the noise of an amplitude, was touched; below this
share of the largest it is held or over, and so it is where a line and a wave leave more than a quarter of its
amplitude.  A phase that jumps by more than ``_JUMP`` (radians) was touched too, between windows none of which swings
less than the share ``_NODE`` of both.  Choices, tried on decays, growth, beats and noise, which must stay whole
(``tests/decays/records/test_repairs.py``)."""


_KEPT = 100_000
"""Samples of a record whose windows are kept, up to which its bytes are no matter."""


def spikes(x: Array) -> NDArray[np.bool_]:
    """Which samples lie far from the cubic through the two on each side, alone."""
    found = np.zeros(len(x), dtype=bool)
    # Of few samples the typical miss is not known.
    if len(x) < 50:
        return found
    # The size of the motion, without its spikes; 100,000 samples know it as well as all.
    low, high = np.quantile(x[:: max(len(x) // 100_000, 1)], [0.01, 0.99])
    y = np.array(x, dtype=float)
    for _ in range(3):  # a spike hides a smaller one beside it
        size = np.zeros(len(y))
        # Lagrange's cubic through the neighbours at -2, -1, 1, 2, taken at 0.
        size[2:-2] = np.abs(y[2:-2] - (4 * (y[1:-3] + y[3:-1]) - y[:-4] - y[4:]) / 6)
        limit = max(_FAR * float(np.median(size)), _TALL * (high - low) / 2)
        far = np.flatnonzero((size > limit) & ~found)
        # A spike spoils the cubics of its neighbours too: only the largest miss is one.
        largest = size[far] >= np.max([size[(far + k) % len(y)] for k in (-2, -1, 1, 2)], axis=0)
        # The motion goes on across a spike; at a step or a knock its neighbours differ as much as it does.
        across = np.abs(y[(far + 1) % len(y)] - y[far - 1]) < size[far] / 2
        new = far[largest & across]
        if not len(new):
            break
        found[new] = True
        y[new] = (y[new - 1] + y[new + 1]) / 2
    # Many are the character of the record, such as 3 samples a period.
    return found if found.sum() <= max(_MOST * len(x), 1) else np.zeros(len(x), dtype=bool)


@dataclass(frozen=True)
class Swings:
    """A record in windows of a ``period``, half of it apart, about ``centres``: the ``size`` and ``phase`` of the wave
    in each (half a turn a window taken off), what a line and it leave (``rest``); ``noise``: the error of a size."""

    period: float
    centres: Array
    size: Array
    rest: Array
    phase: Array
    noise: float


def swings_of(t: Array, x: Array) -> Swings | None:
    """The windows of a record; None where its samples are too few, uneven or gaping, or the record is too short."""
    # Releases, beats and a steady start are sought in the same windows, one after the other.
    if len(t) > _KEPT:
        return _swings_of(t, x)
    return _kept_swings(np.asarray(t, dtype=float).tobytes(), np.asarray(x, dtype=float).tobytes())


@lru_cache(maxsize=2)
def _kept_swings(t: bytes, x: bytes) -> Swings | None:
    return _swings_of(np.frombuffer(t), np.frombuffer(x))


def _swings_of(t: Array, x: Array) -> Swings | None:
    steps = np.diff(t)
    # Few samples or uneven ones: windows of a period would hold too few of them.
    if len(t) < 50 or float(np.quantile(steps, 0.9)) > 2 * float(np.median(steps)):
        return None
    period = _period(t, x)
    per_period = period / float(np.median(steps))
    # Too few samples, a gap, or too short for two releases: nothing can be told of its swings.
    if per_period < 8 or float(steps.max()) > period / 2 or (t[-1] - t[0]) / period < 2 * _LEAST_PERIODS:
        return None
    centres, size, rest, phase = swings(t, x, period, max(int(per_period / _A_PERIOD), 1))
    if len(size) < 4 * _LEAST_PERIODS:
        return None
    # The error of an amplitude from so many samples; the lower quartile, for touched windows leave more.
    noise = float(np.quantile(rest, 0.25)) * np.sqrt(2 / _A_PERIOD)
    return Swings(period, centres, size, rest, phase, noise)


def releases(t: Array, x: Array) -> list[Places]:
    """The stretches of free decay where there are several, or one beside a long hold; else one stretch of all."""
    whole, seen = [np.arange(len(t))], swings_of(t, x)
    if seen is None:
        return whole
    period, centres, size, rest, noise = seen.period, seen.centres, seen.size, seen.rest, seen.noise
    top = float(size.max())
    free = (size > _HELD * top) & (size > NOISE * noise) & (rest < _SHAPE * size)
    grown = np.zeros(len(size), dtype=bool)
    grown[2:] = size[2:] > _GROWN * size[:-2] + NOISE * noise
    jumped = _jumps(seen.phase, size, free, noise)
    grown |= jumped
    # Windows overlap by half: the one before a growth and the one before that hold the touch as well.
    free &= ~(grown | np.roll(grown, -1) | np.roll(grown, -2))
    edges = np.flatnonzero(np.diff(np.concatenate([[0], free.astype(int), [0]])))
    parts = [(a, b) for a, b in zip(edges[::2], edges[1::2]) if b - a >= 2 * _LEAST_PERIODS]
    # One stretch without growth is a decay with a beginning and an end, which the extraction finds.
    if not 1 <= len(parts) <= _MOST_RELEASES or not (grown.any() or len(parts) > 1):
        return whole
    found = []
    for (start, end), (a, _) in zip(_ends(t, centres, size, grown, parts, period), parts):
        # Where the phase jumped the windows before are those of the touch, whatever their size.
        clear = float(centres[a]) - period / 2 if jumped[max(a - 3, 0) : a].any() else start
        found.append(np.flatnonzero((t >= max(start, clear)) & (t <= end)))
    return found


def _jumps(phase: Array, size: Array, free: NDArray[np.bool_], noise: float) -> NDArray[np.bool_]:
    """The windows in which the clock of the motion becomes another: it was held and let go again, perhaps no higher."""
    found = np.zeros(len(phase), dtype=bool)
    # Four windows apart the wave has turned twice, but for what its frequency differs.
    turned = np.angle(np.exp(1j * (phase[4:] - phase[:-4])))
    around = [turned[max(j - 10, 0) : j + 11] for j in range(len(turned))]
    usual = np.array([float(np.median(each)) for each in around])
    off = np.abs(np.angle(np.exp(1j * (turned - usual))))
    spread = np.array([float(np.median(np.abs(each - u))) for each, u in zip(around, usual)])
    for j in range(len(turned)):
        # A wave on both sides, and between them none much smaller: at a node of beats there is.
        smaller = float(min(size[j], size[j + 4]))
        wave = free[j] and free[j + 4] and float(size[j : j + 5].min()) > _NODE * smaller
        sudden = off[j] > _JUMP + NOISE * (spread[j] + noise / smaller) and off[j] >= off[max(j - 3, 0) : j + 4].max()
        if wave and sudden and len(around[j]) > 8:
            found[j + 2 : j + 4] = True
    return found


def _ends(
    t: Array, centres: Array, size: Array, grown: NDArray[np.bool_], parts: list[tuple[int, int]], period: float
) -> list[tuple[float, float]]:
    """From the first window that is free wholly, which swings most, to the last before it is touched again."""
    first = [a - 3 + int(np.argmax(size[a - 3 : a + 1])) if a > 3 else 0 for a, _ in parts]
    starts = [float(centres[k] - period / 2) for k in first]
    if len(parts) == 1 and starts[0] - t[0] < (t[-1] - t[0]) / 2:
        starts = [float(t[0])]  # a short hold is known by its turning points
    nexts = [*(a for a, _ in parts[1:]), len(size)]
    touched = [bool(grown[b:following].any()) for (_, b), following in zip(parts, nexts)]
    return [
        (start, float(centres[b - 1] + period / 2) if cut else float(t[-1]))
        for start, cut, (_, b) in zip(starts, touched, parts)
    ]


def _period(t: Array, x: Array) -> float:
    """Of the strongest line in the spectrum of the velocity: holds and hands have their power below it."""
    # A rough period is enough for windows, and 65,536 points know it.
    count = int(min(2**16, 2 ** int(np.log2(len(t)))))
    grid = np.linspace(t[0], t[-1], count)
    slope = np.gradient(np.interp(grid, t, x))
    power = np.abs(np.fft.rfft(slope * np.hanning(count)))
    power[:2] = 0
    k = int(np.argmax(power))
    return float((t[-1] - t[0]) / k) if power[k] > 0 else 0.0


def swings(t: Array, x: Array, period: float, step: int = 1) -> tuple[Array, Array, Array, Array]:
    """Amplitudes of the wave in windows of a period, half a period apart; what a line and the wave leave; its phase, of
    which half a turn a window is taken off."""
    t, x = t[::step], x[::step]
    centres = np.arange(t[0] + period / 2, t[-1] - period / 2, period / 2)
    low, high = np.searchsorted(t, centres - period / 2), np.searchsorted(t, centres + period / 2)
    found = []
    for centre, a, b in zip(centres, low, high):
        u = (t[a:b] - centre) / period
        if b - a < 6:
            found.append((0.0, 0.0, 0.0))
            continue
        V = np.stack([np.ones(b - a), u, np.cos(2 * np.pi * u), np.sin(2 * np.pi * u)], axis=1)
        c = np.linalg.lstsq(V, x[a:b], rcond=None)[0]
        turn = np.pi * (len(found) % 2)
        found.append(
            (float(np.hypot(c[2], c[3])), float(np.std(x[a:b] - V @ c)), float(np.arctan2(-c[3], c[2])) - turn)
        )
    size, rest, phase = np.array(found).reshape(-1, 3).T
    return centres, size, rest, phase
