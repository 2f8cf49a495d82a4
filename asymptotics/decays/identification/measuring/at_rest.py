"""The end of a record in which nothing swings any more: noise about a place of rest, off centre by dry friction.

The noise is that of differences between neighbours; a tail whose own scatter is no larger holds no motion.  Where it
begins, the last half-swing may have ended short of its turning point on the other side (friction held it), so that it
is no swing of a decay: the record is cut half a period before the rest.

>>> t = np.arange(0, 20, 0.05)
>>> x = np.where(t < 10, (1 - t / 10) * np.cos(6 * t), 0.02) + 1e-3 * np.random.default_rng(0).standard_normal(400)
>>> bool(8.5 < t[moving(t, x, 2 * np.pi / 6)][-1] < 10)
True
"""

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array

_SCATTER, _PERIODS, _A_PERIOD, _PAIRS = 1.3, 1.0, 8, 10
"""A scatter above this times the noise is motion (an amplitude of 1.2 of the noise); a shorter rest may be chance; a
motion scatters twice as much as neighbours differ that are an eighth of its period apart; and so many neighbours as
near as that know the noise."""
_FEW, _SHORT = 2.0, 1.0
"""Periods of a record that is cut half a period before its rest, and of one that is cut at all.  Choices."""
_ROUNDING = 1e-6
"""Of a time stamp, in steps of the clock."""


def moving(t: Array, x: Array, period: float) -> slice:
    """The samples before the rest, all where there is none."""
    if len(t) < 2:
        return slice(None)
    # Sums from the end: the scatter of each tail about its own mean.
    back = x[::-1] - x[-1]
    count = np.arange(1, len(x) + 1)
    scatter = np.cumsum(back**2) / count - (np.cumsum(back) / count) ** 2
    # Neighbours far apart, of few samples a period or beside a gap, differ as much as the motion is large.
    near = _A_PERIOD * np.diff(t)[::-1] <= period * (1 + _ROUNDING)
    pairs = np.cumsum(near)[:-1]
    steps = np.cumsum(np.where(near, np.diff(back) ** 2, 0.0))[:-1] / (2 * np.maximum(pairs, 1))
    # A tail that does not change at all is one; a record that does not, or is noise throughout, is refused elsewhere.
    still = (pairs >= _PAIRS) & (scatter[2:] <= _SCATTER**2 * steps)
    if not still.any() or still[-1]:
        return slice(None)
    # The longest tail without motion.
    last = int(np.flatnonzero(still)[-1]) + 3
    if t[-1] - t[-last] < _PERIODS * period:
        return slice(None)
    begin = _first_quiet(t, x, period, len(t) - last, float(steps[last - 3]))
    cut = t[begin] - period / 2
    if cut - t[0] > _FEW * period:
        return slice(int(np.searchsorted(t, cut)))
    # Of a swing or two the last half one is much of what there is; of less a damped cosine tells more with its rest.
    return slice(begin) if t[begin] - t[0] > _SHORT * period else slice(None)


def _first_quiet(t: Array, x: Array, period: float, begin: int, noise: float) -> int:
    """The first sample from ``begin`` on from which a period holds no motion: in a long rest the last swings of a
    strong decay are few of many samples, and drown."""
    total, squares = (np.concatenate([[0.0], np.cumsum((x - x[-1]) ** k)]) for k in (1, 2))
    first = np.arange(begin, len(t))
    after = np.searchsorted(t, t[first] + period)
    whole = after < len(t)
    first, after = first[whole], after[whole]
    count = after - first
    scatter = (squares[after] - squares[first]) / count - ((total[after] - total[first]) / count) ** 2
    quiet = np.flatnonzero(scatter <= _SCATTER**2 * noise)
    return int(first[quiet[0]]) if len(quiet) else begin
