"""What a fitted law says at an amplitude, as smooth curves with bands: decrements and periods, of any half-swing.

A law has a decrement and a period for each half-swing, whatever it begins with: beside the turning points of the record
stand those of decays that begin a little higher or lower, and all of them lie on one curve.  A parameter p that changes
a value y of the n-th half-swing and its amplitude a moves, at an amplitude that is kept, only

    (dy/dp) - (dy/da_0)/(da/da_0) (da/dp),                a_0: the first amplitude, along whose change the curve runs.

>>> from asymptotics.decays.identification.forward.candidates import read_candidate
>>> from asymptotics.decays.identification.judging.single_fits import fit_law
>>> from asymptotics.decays.identification.synthetic import observed
>>> fit = fit_law(read_candidate("1"), observed("1", [0.05], 8, 1e-3, seed=1)).fit
>>> amplitude, fall, spread = decrement_curve(fit)
>>> len(amplitude) > 40, bool(np.allclose(fall / amplitude, fall[0] / amplitude[0]))
(True, True)
"""

from collections.abc import Callable
from math import ceil

import numpy as np
from scipy.interpolate import CubicSpline, PchipInterpolator

from asymptotics.decays.identification.fitting.least_squares import Fit
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.forward.quadrature import TooStrongError

_POINTS, _STEP, _DRAWN = 16, 0.1, 120
"""Half-swings between the first amplitude and the last, and steps of ln A at the first, that a smooth curve goes
through; and its points.  Choices."""
_SAME = 0.1
"""Places nearer than this share of the usual gap are one."""
Curve = tuple[Array, Array, Array]
_Points = tuple[Array, Array, Array]
"""Amplitudes, values, and the derivatives of the values by the parameters (parameters, half-swings)."""


def decrement_curve(fit: Fit) -> Curve:
    """(mean amplitude, decrement, its standard error there), from large amplitudes to small ones."""

    def of(theta: Array) -> _Points:
        size, by = _sizes(fit, theta)
        mean, fall = (size[1:] + size[:-1]) / 2, size[:-1] - size[1:]
        return _at_its_amplitude(mean, fall, (by[:, 1:] + by[:, :-1]) / 2, by[:, :-1] - by[:, 1:])

    return _joined(fit, of)


def period_curve(fit: Fit) -> Curve:
    """(geometric mean of the amplitudes, period in s, its standard error there), from large ones to small ones."""

    def of(theta: Array) -> _Points:
        size, by = _sizes(fit, theta)
        middle, rate = np.sqrt(size[1:] * size[:-1]), by / size
        period, slopes = fit.model.periods(theta)
        return _at_its_amplitude(middle, period, middle * (rate[:, 1:] + rate[:, :-1]) / 2, slopes.T)

    return _joined(fit, of)


def _sizes(fit: Fit, theta: Array) -> tuple[Array, Array]:
    """The amplitudes and their derivatives by all parameters."""
    size, by_law = fit.model.amplitudes(theta)
    by = np.zeros((fit.model.size, len(size)))
    by[: fit.model.after] = by_law
    return size, by


def _at_its_amplitude(amplitude: Array, value: Array, moved: Array, by: Array) -> _Points:
    """The derivatives of the value where the amplitude is kept; ``moved``: those of the amplitude."""
    return amplitude, value, by - by[0] / moved[0] * moved


def _joined(fit: Fit, of: Callable[[Array], _Points]) -> Curve:
    """One curve within the amplitudes of the decay, through it and through others that begin up to a half-swing above
    and below, where the law has them."""
    size = fit.model.amplitudes(fit.theta)[0]
    falls = np.log(size[:-1] / size[1:])
    count = max(ceil(_POINTS / len(falls)), ceil(falls[0] / _STEP))
    found = []
    for j in range(-count, 2 * count):
        theta = fit.theta.copy()
        theta[0] -= falls[0] * j / count
        try:
            found.append(of(theta))
        except TooStrongError:  # a mass that is stuck sooner, or a first swing that is out of the domain
            continue
    amplitude, value = (np.concatenate([each[i] for each in found]) for i in range(2))
    slopes = np.concatenate([each[2] for each in found], axis=1)
    spread = np.sqrt(np.maximum(np.einsum("in,ij,jn->n", slopes, fit.covariance, slopes), 0.0))
    order = np.argsort(amplitude)
    order = order[(amplitude[order] <= size[0]) & (amplitude[order] >= size[-1])]
    place = np.log(amplitude[order])
    order = order[np.diff(place, prepend=-np.inf) > _SAME * float(falls.min()) / count]
    return _smooth(amplitude[order], value[order], spread[order])


def _smooth(amplitude: Array, value: Array, spread: Array) -> Curve:
    """More places between them, from large to small."""
    place = np.log(amplitude)
    fine = np.linspace(place[-1], place[0], max(_DRAWN, len(place)))
    return np.exp(fine), CubicSpline(place, value)(fine), PchipInterpolator(place, spread)(fine)
