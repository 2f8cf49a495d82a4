"""Time stamps of a buffer: many samples are stamped when they are handed over, together, and not when they were taken.

Most gaps are then far below the mean, the others are one hand-over apart, and all stamps lie near a line in the number
of the sample.  A sensor that truly samples in bursts has such stamps as well; its values jump where the clock does,
those of a buffer do not.

>>> n = np.arange(600)
>>> stamps = np.floor(n / 10) * 0.1 + 1e-4 * (n % 10)
>>> even, size = evened(stamps, np.cos(0.1 * n))
>>> size, bool(np.abs(np.diff(even) - 0.01).max() < 1e-4)
(10.0, True)
>>> evened(stamps, np.cos(10 * stamps))[1]                          # what it shows at its stamps is smooth
0.0
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
_LEAST, _OFTEN, _TOGETHER, _REGULAR, _JUMP = 50, 8, 0.3, 3.0, 3.0
"""Samples and hand-overs below which nothing is told; the usual gap within a burst, as a share of the mean gap; the
longest gap between bursts, in usual ones; and how much further than within a burst the values may go between two."""


def evened(t: Array, x: Array) -> tuple[Array, float]:
    """Even times and the usual number of samples of a burst; the times as they are and 0 where there are no bursts."""
    gaps = np.diff(t)
    if len(t) < _LEAST or (gaps < 0).any():
        return t, 0.0
    mean = float(gaps.mean())
    between = gaps > mean
    if between.sum() < _OFTEN or not np.median(gaps) < _TOGETHER * mean:
        return t, 0.0
    usual = float(np.median(gaps[between]))
    line = np.polynomial.Polynomial.fit(np.arange(len(t)), t, 1)(np.arange(len(t)))
    # A pause, or samples that were lost, leave the line.
    if gaps.max() > _REGULAR * usual or np.abs(t - line).max() > 1.5 * usual:
        return t, 0.0
    step = np.abs(np.diff(x))
    if float(step[between].mean()) > _JUMP * max(float(step[~between].mean()), 1e-9 * float(np.ptp(x))):
        return t, 0.0
    return line, float(np.median(np.diff(np.flatnonzero(between))))
