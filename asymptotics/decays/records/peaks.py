"""Peaks of one side with their times (``t amplitude``): turning points 0, 2, 4, ... of a motion whose samples are gone.

A column that is called amplitude or peak, all above 0, falling nearly always, at nearly even times, is no sampled
swing: it is read as the maxima of one side, a period apart.  A peak that was missed leaves a gap in n.

>>> t = np.array([0.0, 2.0, 4.1, 8.1, 10.0])
>>> peaks_of_one_side("amplitude (cm)", t, np.exp(-0.1 * t))
array([ 0.,  2.,  4.,  8., 10.])
>>> peaks_of_one_side("x (cm)", t, np.exp(-0.1 * t)) is None
True
"""

import re

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
_NAMES = re.compile(r"ampl|peak|maxim|max\b|scheitel|crest", re.IGNORECASE)
_LEAST, _MOST, _FALLING, _EVEN = 5, 500, 0.8, 0.15
"""Rows that are peaks: of fewer nothing is told, more are a sampled envelope; the share of steps that fall; and by how
much of a period a peak may be off its place."""


def peaks_of_one_side(name: str, t: Array, x: Array) -> Array | None:
    """The numbers n of the turning points; None for what is no sequence of peaks."""
    whole = np.isfinite(t) & np.isfinite(x)
    if not _NAMES.search(name) or not whole.all() or not _LEAST <= len(x) <= _MOST or not (x > 0).all():
        return None
    steps = np.diff(t)
    period = float(np.median(steps))
    if not period > 0 or np.mean(np.diff(x) < 0) < _FALLING:
        return None
    periods = steps / period
    near = (np.abs(periods - np.round(periods)) < _EVEN) & (np.round(periods) >= 1)
    return np.concatenate([[0.0], 2 * np.cumsum(np.round(periods))]) if near.all() else None
