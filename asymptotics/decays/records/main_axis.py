"""Of several columns, such as three axes of a sensor, the one that carries the oscillation.

The axes of one swing have one frequency: that of the highest line in the sum of their spectra.  Where a column holds
nine tenths of the power of that line it is taken; where two share it, the swing lies between the axes, and it is asked.

>>> t = np.arange(0, 60, 0.05)
>>> swing = np.exp(-0.02 * t) * np.cos(3 * t)
>>> carrying({4: 0.1 * swing + np.sin(0.1 * t), 5: swing + 9.81, 6: np.zeros(len(t))})
5
>>> carrying({4: swing, 5: 0.7 * swing}) is None
True

Columns of different units have no common power; each has its own line, and a share of its own power there.

>>> [(line.place, line.share > 0.5) for line in map(line_of, (swing, swing**2, np.random.default_rng(0).random(1200)))]
[(29, True), (57, True), (600, False)]
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
_SHARE, _LEAST, _LOWEST, _SIDE, _WIDE = 0.9, 50, 3, 2, 0.2
"""The share of the power of the line; samples below which there is no line and all that varies is counted; the lowest
bin that is no drift; bins on each side of the line that belong to it; and the width of a line that decays fast, as a
share of its frequency."""


class Line(NamedTuple):
    """The highest line of a column: its bin, its power, and the share of all power above the drift that is near it."""

    place: float
    power: float
    share: float


def carrying(columns: Mapping[int, Array]) -> int | None:
    """The place of the column; None where none holds nine tenths."""
    powers = {place: _spectrum(values) for place, values in columns.items()}
    if any(power is None for power in powers.values()):
        return None
    stacked = np.stack([power for power in powers.values() if power is not None])
    if stacked.shape[1] > _LEAST // 2:
        stacked[:, :_LOWEST] = 0
        line = int(np.argmax(stacked.sum(axis=0)))
        stacked = stacked[:, max(line - _SIDE, 0) : line + _SIDE + 1]
    near = stacked.sum(axis=1)
    best = int(np.argmax(near))
    return list(powers)[best] if near[best] > _SHARE * near.sum() > 0 else None


def line_of(values: Array) -> Line | None:
    """The line of one column; None where it is too short, has gaps, or does not vary."""
    power = _spectrum(values)
    if power is None or len(power) <= _LEAST // 2:
        return None
    power[:_LOWEST] = 0
    if not power.sum() > 0:
        return None
    line = int(np.argmax(power))
    wide = max(_SIDE, int(_WIDE * line))
    near = float(power[max(line - wide, 0) : line + wide + 1].sum())
    return Line(line, near, near / float(power.sum()))


def _spectrum(values: Array) -> Array | None:
    """The power of a column about its line, under Hann's window; None where it has gaps of its own."""
    x = values[np.isfinite(values)]
    if len(x) < max(4, 0.9 * len(values)):
        return None
    # A missing sample here and there does not move a line.
    x = np.interp(np.arange(len(values)), np.flatnonzero(np.isfinite(values)), x)
    u = np.linspace(-1, 1, len(x))
    x = x - np.polynomial.Polynomial.fit(u, x, 1)(u)
    return np.asarray(np.abs(np.fft.rfft(x * np.hanning(len(x)))) ** 2)
