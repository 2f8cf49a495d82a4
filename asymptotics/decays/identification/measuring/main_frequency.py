"""The frequency of the motion in a record: that of the line, or the falling line, that holds most of the energy.

A decay has its energy at its beginning, a slow tail (a base line that wanders, a drift, a step) all along: under a
window over the whole record the tail may be the higher line.  So the record is compared with falling lines
e^(-g t) cos(w t) for several g (a matched filter): each explains the energy
|sum x e^(-g t) e^(-i w t)|^2/sum e^(-2 g t).

>>> t = np.arange(0, 60, 0.05)
>>> x = np.exp(-0.2 * t) * np.cos(2 * t) + 0.3 * np.sin(0.05 * t)
>>> round(main_frequency(t, x), 1)
2.0
"""

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array

_DIRECT, _OVER = 1500, 4
"""Up to 1500 samples the frequency is sought in them as they lie, beyond by the fast transform, for the cost of the
first is their square; and trials in the width of a line, so that none is missed between two."""
_FALLS = (3.0, 6.0, 12.0, 24.0)
"""By which powers of e the falling lines have sunk at the end of the record: a factor of two apart, for a filter
that is off by that much still sees nine tenths of the energy."""
_LEAST, _CYCLES, _ALIKE = 1.5, 3.0, 0.2
"""Cycles in the record below which nothing is an oscillation, and below which a falling line is not told from a drift;
frequencies that differ by less than a fifth are those of one motion."""


def main_frequency(t: Array, x: Array) -> float:
    """Of few samples, however they lie, up to half as many periods as samples; of many, by the fast transform."""
    if len(t) > _DIRECT:
        return 2 * np.pi / dominant_period(t, x)
    span = t[-1] - t[0]
    # More than half as many periods as samples are an alias (Nyquist).
    low, high = 2 * np.pi * _LEAST / span, np.pi * (len(t) - 1) / span
    trials = np.linspace(low, high, int(_OVER * (high - low) * span / (2 * np.pi)) + 2)
    even = x - np.polynomial.Polynomial.fit(t, x, 1)(t)
    falling = _falling((t - t[0]) / span)
    waves = np.exp(-1j * trials[:, None] * (t - t[0]))
    steady = float(trials[np.argmax(np.abs(waves @ even))])
    energy = (np.abs(waves @ _weighted(falling, t, x).T) ** 2 / (falling**2).sum(axis=1)).max(axis=1)
    energy[trials * span < _CYCLES * 2 * np.pi] = 0
    return _chosen(steady, float(trials[np.argmax(energy)]))


def dominant_period(t: Array, x: Array) -> float:
    """The period of the motion, from the record resampled evenly."""
    # Resampled at least as finely as the record; 2^17 bins are enough for any number of periods that is read.
    count = int(min(2**17, max(256, 2 ** int(np.log2(len(t)) + 1))))
    grid = np.linspace(t[0], t[-1], count)
    resampled = np.interp(grid, t, x)
    even = resampled - np.polynomial.Polynomial.fit(grid, resampled, 1)(grid)
    power = np.abs(np.fft.rfft(even * np.hanning(count)))
    # The line at 0 and its side lobe under the window.
    power[:2] = 0
    falling = _falling(np.linspace(0, 1, count))
    spectra = np.abs(np.fft.rfft(_weighted(falling, grid, resampled))) ** 2
    energy = (spectra / (falling**2).sum(axis=1)[:, None]).max(axis=0)
    energy[: int(_CYCLES)] = 0
    k = _chosen(float(np.argmax(power)), float(np.argmax(energy)))
    return float((t[-1] - t[0]) * count / (count - 1) / k)


def _falling(u: Array) -> Array:
    """The envelopes of the lines that are compared, a row for each; u from 0 to 1 over the record."""
    return np.exp(-np.array(_FALLS)[:, None] * u)


def _weighted(falling: Array, t: Array, x: Array) -> Array:
    """The record under each envelope, about the line through it that has the same weights."""
    return np.stack([w * (x - np.polynomial.Polynomial.fit(t, x, 1, w=w)(t)) for w in falling])


def _chosen(steady: float, falling: float) -> float:
    """The steady line where both see one motion, for it has the sharper peak; else the falling one."""
    return steady if abs(falling - steady) < _ALIKE * steady else falling
