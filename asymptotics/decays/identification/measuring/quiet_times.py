"""Turning times, each from all of them: where noise does not move an extreme, its value is not too large.

The extreme of a noisy curve is taken where the noise is high: moved by d it gains |x''| d^2/2, the more the smaller the
amplitude is, so that a decay looks too slow.  The times of turning points and passages lie on one smooth curve
(a polynomial in the number n, and for the passages a line more), which knows each time better than its extreme does.

>>> n, random = np.arange(30), np.random.default_rng(1)
>>> t, sigma = np.pi * n, 0.02 * np.exp(n / 15)
>>> noisy = t + sigma * random.standard_normal(30)
>>> passages = t[:-1] + np.pi / 2 + 0.25 * sigma[:-1] * random.standard_normal(29)
>>> found = quiet_times(noisy, np.exp(-n / 15), sigma, passages, np.ones(29))
>>> bool(np.abs(found - t).max() < np.abs(noisy - t).max() / 5)
True
"""

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.criteria import bic

_DEGREES = (1, 2, 3, 5)
"""Turning times are nearly n T: a spring or a loss bends them, a deep pendulum by more; BIC chooses."""
_LEAST = 12
"""Twice the coefficients of degree 5: with fewer times the curve would follow their noise."""
_PASSAGE = 0.25
"""The error of a passage as a share of that of an extreme: the motion is steep there."""
_NOISY = 3.0
"""A curve that misses the times by more than this many of their errors is not the truth, and is not used there."""
_BESIDE = 5
"""So many neighbours tell it: a single time may miss its curve by chance."""
_CLIP, _MOST = 4.0, 0.7
"""Misfits beyond so many typical ones do not bend the curve, if they are few."""


def quiet_times(t: Array, x: Array, sigma: Array, passages: Array, steps: Array) -> Array | None:
    """The times of the extremes ``t`` with values ``x`` on a smooth curve; None if no curve goes through them.

    Where the curve misses its neighbourhood (at the start of a deep pendulum decay, whose period changes fast), the
    times stay: there the motion is large, and noise hardly moves an extreme.

    ``sigma``: their standard errors; ``passages``: times of passages through the base line; ``steps``: how many
    half-swings lie between successive extremes.
    """
    if len(t) < _LEAST or not (sigma > 0).all():
        return None
    n = np.concatenate([[0.0], np.cumsum(steps)])
    inside = passages[(passages > t[0]) & (passages < t[-1])]
    where = np.interp(inside, t, n)
    # Passages stand half-way in number; what damping and drift make of that is the line that they have more.
    place = np.floor(where) + 0.5
    # The error of a time goes like 1/amplitude, so that the amplitude is its weight.
    size = np.interp(n, n, _smooth_size(n, x))
    error = float(np.median(sigma * size))
    rows = np.concatenate([n, place])
    weights = np.concatenate([size, np.interp(place, n, size) / _PASSAGE])
    data = np.concatenate([t, inside])
    late = np.concatenate([np.zeros(len(n)), np.ones(len(place))])
    tried = [_fitted(degree, rows / n[-1] * 2 - 1, late, data, weights) for degree in _DEGREES]
    best, curve = min(tried, key=lambda pair: pair[0])
    # The median: a few wild times do not decide that there is no curve.
    typical = float(np.median(np.abs(t - curve[: len(t)]) * size))
    if typical >= _NOISY * error:
        return None
    missed = np.pad(np.abs(t - curve[: len(t)]) / sigma, _BESIDE // 2, mode="edge")
    nearby = np.median(np.lib.stride_tricks.sliding_window_view(missed, _BESIDE), axis=1)
    return np.where(nearby <= _NOISY, curve[: len(t)], t)


def _smooth_size(n: Array, x: Array) -> Array:
    """|x| on a parabola of its logarithm: noise in a small amplitude does not enter the weights."""
    size = np.log(np.abs(x))
    return np.asarray(np.exp(np.polynomial.Polynomial.fit(n, size, 2)(n)))


def _fitted(degree: int, u: Array, late: Array, data: Array, weights: Array) -> tuple[float, Array]:
    """(BIC, the curve) of a polynomial, with a line more for the passages, by clipped least squares."""
    columns = [u**k for k in range(degree + 1)] + ([late, late * u] if late.any() else [])
    V = np.stack(columns, axis=1)
    keep = np.ones(len(data), dtype=bool)
    for _ in range(4):
        c, *_rest = np.linalg.lstsq(V[keep] * weights[keep, None], data[keep] * weights[keep], rcond=None)
        misfit = (data - V @ c) * weights
        # The standard deviation of a normal distribution from its median deviation.
        scale = 1.4826 * float(np.median(np.abs(misfit)))
        near = np.abs(misfit) <= _CLIP * scale
        # So many misses are no outliers: the degree is wrong, and BIC will say so.
        if near.mean() < _MOST:
            break
        keep = near
    # Clipped misses count at the clip, so that no degree gains by leaving more of them out.
    rss = float((np.minimum(np.abs(misfit), _CLIP * max(scale, 1e-15)) ** 2).sum())
    return bic(len(data) * np.log(max(rss, 1e-300)), len(columns), len(data)), V @ c
