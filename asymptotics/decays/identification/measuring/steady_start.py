"""A drive that holds the amplitude before the decay begins: seen without any law, cut off and told.

Every loss that is here grows with the amplitude or stays as it is: A falls ever more slowly, A(t) is convex, and a
convex curve lies above each of its chords where these are prolonged.  A least-squares line through later amplitudes is
such a chord, so that its value at the start is a lower bound of the amplitude there; an amplitude that is lower by many
errors is that of no free decay.  It is a drive where the amplitudes are constant, and bend to the decay suddenly: a
constant and a cubic behind it leave far less than one smooth curve through both.  What only begins slowly, a beat or a
sensor at its limit, is told and not cut.  (A pendulum from beyond 2 rad begins slowly in its velocity.)

>>> t = np.arange(0, 120, 0.1)
>>> x = np.exp(-0.02 * np.maximum(t - 50, 0)) * np.cos(2 * t) + 0.01 * np.random.default_rng(0).standard_normal(1200)
>>> found = steady_start(t, x)
>>> found.sure, 50 < found.end < 57
(True, True)
>>> steady_start(t, np.exp(-0.0005 * t) * np.cos(2 * t)) is None
True
"""

from dataclasses import dataclass

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.records.repairs import swings_of

_FEWEST, _CLEAR, _SHARP = 4, 6.0, 20.0
"""Windows on each side of the bend; how many errors the start lies below the line of what follows; and by how much the
sum of squares of a smooth curve exceeds that of the bend, in squares of the noise.  Choices: of 1620 free decays (Q 5
to 2000, alpha 0 to 2, noise 0 to 3 %) none is cut and none told, of 480 beats none is cut; of 1152 records driven for 3
to 30 periods (Q 20 to 200, noise 0.3 and 1 %) 953 are cut and 183 told, of 576 at a noise of 3 % 183 and 259."""
_OVERLAP = 2.0
"""Windows overlap by half: so many of them are as good as one."""
_LEVEL, _SIGMAS = 0.2, 3.0
"""A start is constant if it changes by less than a fifth of what follows, and so many errors."""
_DEEP, _BEND, _SMOOTH = 0.5, 3, 5
"""The share of the level down to which what follows is looked at; the degrees of the curve behind the bend, and of the
smooth one through all, which has as many coefficients as
the constant, the curve and the place of the bend."""
_NOISY = 3.0
"""What the bend may leave, in the scatter of neighbouring amplitudes."""
_GROWTH = 1.4
"""From one length of the line to the next."""
_LEAST = 1e-4
"""The least noise of an amplitude, as a share of the level: rounding and curvature leave more than a computed record
has."""


@dataclass(frozen=True)
class SteadyStart:
    """``end``: the time at which the decay has begun; ``periods``: how long the start lasts; ``sure``: whether it is
    constant and ends in a bend, else the amplitude only falls more slowly there than later."""

    end: float
    periods: float
    sure: bool

    @property
    def in_words(self) -> str:
        """What the record does, and what was made of it."""
        if self.sure:
            held = f"the amplitude is held for {self.periods:.3g} periods before it falls, as by a drive"
            return f"{held}: the decay is taken from t = {self.end:.6g} on"
        slow = f"over its first {self.periods:.3g} periods the amplitude falls more slowly than later"
        told = "no loss beside a linear spring does so: a drive, a beat, a sensor at its limit, a pendulum from far up?"
        return f"{slow}; {told} (nothing is cut)"


def steady_start(t: Array, x: Array) -> SteadyStart | None:
    """The stretch before the decay in which the amplitude falls more slowly than in it; None where there is none."""
    seen = swings_of(t, x)
    if seen is None or len(seen.size) < 2 * _FEWEST + 1:
        return None
    size = seen.size
    first = _clearest(size, seen.noise)
    if first is None:
        return None
    bend, sure = _bend(size, first, seen.noise)
    end = float(seen.centres[min(bend + 3, len(size) - 1)])
    return SteadyStart(end, (bend + 1) / 2, sure)


def _clearest(size: Array, noise: float) -> int | None:
    """The number of windows whose mean lies the most errors below a line through those that follow; None below
    ``_CLEAR`` of them."""
    count, sums = len(size), [np.concatenate([[0.0], np.cumsum(size * np.arange(len(size)) ** p)]) for p in (0, 1)]
    squares = np.concatenate([[0.0], np.cumsum(size**2)])
    best, place, length = _CLEAR, None, float(_FEWEST)
    while length <= count - _FEWEST - 1:
        m = int(length)
        k = np.arange(_FEWEST, count - m)  # the first k windows, one between, and the m behind it
        a, b = k + 1, k + 1 + m
        level = sums[0][k] / k
        middle, mean = (a + b - 1) / 2, (sums[0][b] - sums[0][a]) / m
        spread = m * (m * m - 1) / 12
        slope = (sums[1][b] - sums[1][a] - middle * m * mean) / spread
        away = middle - (k - 1) / 2
        left = squares[b] - squares[a] - m * mean**2 - slope**2 * spread + squares[k] - k * level**2
        # What both leave, and never less than the samples say.
        scatter = np.sqrt(np.maximum(left, 0) / np.maximum(k + m - 3, 1))
        error = np.maximum(np.maximum(scatter, noise), _LEAST * level) * np.sqrt(
            _OVERLAP * (1 / k + 1 / m + away**2 / spread)
        )
        worth = (mean - slope * away - level) / error
        if worth.max() > best:
            best, place = float(worth.max()), int(k[np.argmax(worth)])
        length *= _GROWTH
    return place


def _bend(size: Array, first: int, noise: float) -> tuple[int, bool]:
    """The number of constant windows before the decay, found anew, and whether they are constant and end suddenly."""
    level = float(np.mean(size[:first]))
    low = np.flatnonzero(size[first:] < _DEEP * level)
    stop = max(first + int(low[0]) if len(low) else len(size), min(first + 2 * _FEWEST, len(size)))
    places, tried = np.arange(stop, dtype=float), range(max(_FEWEST, first // 2), min(2 * first, stop - _FEWEST - 2))
    left = {k: _left_by(size[:stop], places, k) for k in tried}
    if not left:
        return first, False
    k = min(left, key=lambda k: left[k])
    own, s = max(noise, _LEAST * level, _scatter(size[:stop])), float(np.sqrt(left[k] / max(stop - _BEND - 3, 1)))
    smooth = np.polynomial.Polynomial.fit(places, size[:stop], _SMOOTH)(places)
    sharp = float(np.sum((size[:stop] - smooth) ** 2)) - left[k] > _SHARP * _OVERLAP * max(s, own) ** 2
    before, behind = (float(np.polyfit(places[p], size[p], 1)[0]) for p in (slice(0, k), slice(k + 2, k + 2 + _FEWEST)))
    error = max(s, own) * np.sqrt(_OVERLAP * 12 / (k * (k * k - 1)))
    constant = abs(before) < _LEVEL * abs(behind) + _SIGMAS * error
    # A beat is near a constant and a curve, and leaves far more than noise.
    return k, bool(sharp and constant and s < _NOISY * own)


def _scatter(size: Array) -> float:
    """The noise of amplitudes from window to window, of windows that share no sample: third differences."""
    return float(np.median(np.abs(size[6:] - 3 * size[4:-2] + 3 * size[2:-4] - size[:-6]))) / (0.6745 * 20**0.5)


def _left_by(size: Array, places: Array, k: int) -> float:
    """The sum of squares that a constant over the first k windows and a curve behind the next two, which hold the bend,
    leave."""
    behind = slice(k + 2, None)
    degree = min(_BEND, len(size) - k - 3)
    curve = np.polynomial.Polynomial.fit(places[behind], size[behind], degree)(places[behind])
    return float(np.sum((size[:k] - size[:k].mean()) ** 2) + np.sum((size[behind] - curve) ** 2))
