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
    return slice(int(np.searchsorted(t, t[-last] - period / 2)))
