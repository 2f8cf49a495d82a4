"""The backbone of a record: its period at the amplitudes of the data, before any law.

The time of a half-swing is half the period at its amplitude, T(A) = c_0 and powers 1, 2 and 4 of A (a spring x|x|, a
cubic or fifth one, a pendulum), two of them at most, by AICc; sums over the swings are fitted to the turning times,
which forgives noise.  What a loss does to the period is of second order in its strength, and stands in T as it is.

>>> n = np.arange(40)
>>> size = 0.97**n
>>> t = np.concatenate([[0], np.cumsum(np.pi * (1 - 0.1 * size[1:] * size[:-1]))])
>>> [f"{row['estimate']:.3f}" for row in backbone(n, size, t, 0.0)]
['5.655', '6.092', '6.225']
"""

from collections.abc import Callable

import numpy as np
from scipy.special import stdtrit

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.criteria import aicc, memory_factor
from asymptotics.decays.identification.measuring.observations import Indices

Row = dict[str, float]
_POWERS, _LEAST, _NEAR = ((0,), (0, 1), (0, 2), (0, 4), (0, 2, 4), (0, 1, 2)), 8, 6.0
"""Of A; turning times below which there is no error; and the AICc above the best up to which a
choice is believed too."""


def backbone(n: Indices, size: Array, t: Array, stated: float) -> list[Row]:
    """T at the first amplitude, the geometric mean and the last, with 95 % intervals; none of too few times.

    ``stated``: the standard error of a turning time, where it is known to be more than the scatter.
    """
    found = period_at(n, size, t, stated)
    ends = (float(size[0]), float(np.sqrt(size[0] * size[-1])), float(size[-1]))
    return [] if found is None else [found(a) for a in ends]


def period_at(n: Indices, size: Array, t: Array, stated: float) -> Callable[[float], Row] | None:
    """T with its interval as a function of the amplitude; None of too few times."""
    if len(n) < _LEAST:
        return None
    gap = np.diff(n)
    middle = np.sqrt(size[1:] * size[:-1]) / size[0]
    found: list[tuple[float, tuple[int, ...], Array, Array]] = []
    for powers in _POWERS:
        sums = [np.concatenate([[0.0], np.cumsum(gap * middle**k)]) / 2 for k in powers]
        V = np.stack([np.ones(len(t)), *sums], axis=1)
        c: Array = np.asarray(np.linalg.lstsq(V, t, rcond=None)[0], dtype=np.float64)
        freedom = len(t) - V.shape[1]
        left = t - V @ c
        rss = max(float((left**2).sum()), (1e-12 * float(np.ptp(t))) ** 2)
        noise = max(rss / freedom, stated**2)
        value = float(aicc(len(t) * np.log(noise), V.shape[1] + 1, len(t)))
        covariance = (np.linalg.pinv(V.T @ V) * noise * memory_factor(left))[1:, 1:] * float(
            stdtrit(freedom, 0.975)
        ) ** 2
        found.append((value, powers, c[1:], covariance))
    least = min(value for value, *_ in found)
    near = sorted((f for f in found if f[0] < least + _NEAR), key=lambda f: f[0])
    return lambda a: _row(a, [_at(a / size[0], powers, c, spread) for _, powers, c, spread in near])


def _at(amplitude: float, powers: tuple[int, ...], c: Array, covariance: Array) -> tuple[float, float]:
    by = np.array([amplitude**k for k in powers])
    return float(by @ c), float(np.sqrt(by @ covariance @ by))


def _row(amplitude: float, each: list[tuple[float, float]]) -> Row:
    low, high = min(v - e for v, e in each), max(v + e for v, e in each)
    return {"amplitude": amplitude, "low": low, "estimate": each[0][0], "high": high}
