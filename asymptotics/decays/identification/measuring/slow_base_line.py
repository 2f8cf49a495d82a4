"""A base line that wanders (a draught, a creeping support, a warming sensor): measured beside the motion and taken off.

An offset and a drift belong to every fit.  What wanders slower than half the frequency of the motion is no part of a
decay either, however it is shaped: no odd force makes it.  The motion (``demodulation``) and the cosines of at most
half its frequency,

    x(t) = base + drift u + Re(P(u) e^(i w t)) + Re(Q(u) e^(3 i w t)) + sum_k c_k cos(k pi (1 + u)/2),   u in [-1, 1],

are fitted together, so many cosines as Akaike's criterion chooses, and their sum is taken off where it stands out:
of noise, white or with a memory of less than a period, the slow part is about as loud as what lies between it and the
motion.  So it must be louder than that by far, and not what a modulation of the motion could be.

>>> t = np.arange(0, 150, 0.1)
>>> pure, base = np.exp(-0.01 * t) * np.cos(t), 0.05 / (1 + np.exp(-(t - 110) / 4))
>>> noise = 1e-3 * np.random.default_rng(0).standard_normal(len(t))
>>> found = slow_base_line(t, pure + base + noise)
>>> left = base - found.values
>>> bool(np.abs(left - np.polyval(np.polyfit(t, left, 1), t)).max() < 1e-3), found.in_words
(True, 'the base line wanders by up to 0.02 beside its drift: measured and taken off')
>>> slow_base_line(t, pure + noise) is None
True
"""

from dataclasses import dataclass

import numpy as np

from asymptotics.decays.identification.forward.blocks import triangle
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.demodulation import SpectralLine, demodulated
from asymptotics.decays.identification.measuring.main_frequency import dominant_period
from asymptotics.decays.identification.measuring.second_mode import WORTH, motion_columns, solved

_LEAST, _PERIODS, _MOST = 200, 6.0, 6_000
"""Samples, and periods of the record, below which slow and fast are not apart; as many samples as the fit is given."""
_FASTEST, _BETWEEN = 0.5, 0.8
"""The frequencies of the cosines end at half that of the motion; from there to 0.8 of it, noise alone is seen."""
_ROUGH = 5
"""Coefficients of the modulation in the rough fit: few, as in ``second_mode``."""
_BESIDE, _BINS, _CANCEL = 0.9, 1.0, 0.01
"""Beside a law, which knows the shape of the motion, the cosines go on so far, but no nearer to it than the periods of
the samples tell apart: what begins within a period has parts above half the frequency.  Of 150 decays with an unquiet
tail (seed 79002) the intervals hold 86.7 % without cosines in the fit of the law (rms of the misses 1.31), 92.5 % with
those up to 0.75 (1.14), 93.3 % up to 0.9 (1.04); up to 0.97 the intervals are four times as long.  Directions below
0.01 of the largest are left out: over a few periods the cosines of a long record could be any motion."""
_LOUDER = 25.0
"""By how much the mean square of the slow coefficients exceeds that of those between: five times the size.  A choice:
AR(1) noise whose correlation falls to 1/e in half a period has 3.5, and what is taken off in error is signal lost."""
_OWN = 0.3
"""The part of its mean square that no modulation of the motion could be.  What friction stops, and a pendulum from far
up, has a modulation of many coefficients, and cosines that cancel it are no base line: "15 degrees" where there was
none, a share of 0.003.  Six such decays have 0.01 to 0.4; steps, waves and walks 0.6 to 1 but for the fewest swings."""


@dataclass(frozen=True)
class SlowBaseLine:
    """What wanders beside the drift, at the samples; ``start`` and ``span`` of the record, ``omega`` of the motion."""

    values: Array
    start: float
    span: float
    omega: float

    @property
    def in_words(self) -> str:
        """Of what size it is."""
        size = float(np.abs(self.values).max())
        return f"the base line wanders by up to {size:.2g} beside its drift: measured and taken off"

    def columns(self, t: Array) -> Array:
        """What the cosines of the record span at the times of the samples that a law is given, orthonormal."""
        periods = float(t[-1] - t[0]) * self.omega / (2 * np.pi)
        fastest = max(_FASTEST, min(_BESIDE, 1 - _BINS / periods))
        count = int(fastest * self.span * self.omega / np.pi)
        # Over a part of the record they are dependent: what only large ones that cancel would make is no base line.
        left, size, _ = np.linalg.svd(_cosines((t - self.start) / self.span, count), full_matrices=False)
        return np.asarray(left[:, size > _CANCEL * size[0]])


def slow_base_line(t: Array, x: Array) -> SlowBaseLine | None:
    """What wanders beside the drift of a record; None where it is no louder than what lies beside it."""
    if len(t) < _LEAST or not np.ptp(x) > 0:
        return None
    omega = 2 * np.pi / dominant_period(t, x)
    periods = float(t[-1] - t[0]) * omega / (2 * np.pi)
    some = slice(None, None, -(-len(t) // _MOST))
    T, X = t[some], x[some]
    if periods < _PERIODS or len(T) < 4 * periods:
        return None
    slow = int(2 * _FASTEST * periods)
    u = (t - t[0]) / (t[-1] - t[0])
    waves = _cosines(u[some], int(2 * _BETWEEN * periods))
    rough = motion_columns(SpectralLine(T, omega, np.zeros(_ROUGH), np.zeros(1), 0.0, 0.0, 0.0), T)
    first = X - waves[:, :slow] @ solved(rough, waves[:, :slow], X)[rough.shape[1] :]
    # Without it, or the modulation of the motion would follow it.
    main = motion_columns(demodulated(T, first, 2 * np.pi / omega), T)
    # Orthonormal columns: noise has the same share in each.  The last coordinate is what lies outside all of them.
    along = triangle(np.concatenate([main, waves, X[:, None]], axis=1))[:, -1]
    power = along[main.shape[1] : -1] ** 2
    left = float((along[main.shape[1] :] ** 2).sum()) - np.concatenate([[0.0], np.cumsum(power[:slow])])
    count = np.arange(slow + 1)
    criteria = len(T) * np.log(np.maximum(left, 1e-300) / len(T)) + 2.0 * count + np.where(count, WORTH, 0.0)
    chosen = int(np.argmin(criteria))
    if not chosen or power[:chosen].mean() < _LOUDER * power[slow:].mean():
        return None
    c = solved(main, waves[:, :chosen], X)[main.shape[1] :]
    taken = _cosines(u, chosen) @ c
    taken = taken - np.polynomial.Polynomial.fit(t, taken, 1)(t)
    if power[:chosen].sum() < _OWN * float(taken[some] @ taken[some]):
        return None
    size = float(np.abs(taken).max())
    # As in ``second_mode``: larger than the record itself, it is one of two that cancel.
    if size > float(np.ptp(x)) / 2:
        return None
    return SlowBaseLine(taken, float(t[0]), float(t[-1] - t[0]), omega)


def _cosines(place: Array, count: int) -> Array:
    """cos(k pi s), k = 1 ... count, at the places s, from 0 to 1 over the record."""
    return np.asarray(np.cos(np.pi * place[:, None] * np.arange(1, count + 1)))
