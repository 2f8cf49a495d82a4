"""The backbone of a record: its period at the amplitudes of the data, before any law.

The time of a half-swing is half the period at its amplitude, T(A) = c_0 and powers 1, 2 and 4 of A (a spring x|x|, a
cubic or fifth one, a pendulum), two of them at most, by AICc; sums over the swings are fitted to the turning times,
which forgives noise.  What a loss does to the period is of second order in its strength, and stands in T as it is.

Turning times that are measured late by dry friction, of strength f/A by late f, are late by more and more as A sinks,
and a period of them is too long.  How much of that friction there is the amplitudes tell (``Decline.friction``): the
times are corrected by its estimate, and the intervals hold what its interval may do.

>>> n = np.arange(40)
>>> size = 0.97**n
>>> t = np.concatenate([[0], np.cumsum(np.pi * (1 - 0.1 * size[1:] * size[:-1]))])
>>> [f"{row['estimate']:.3f}" for row in backbone(TurningTimes(n, size, t))]
['5.655', '6.092', '6.225']
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.special import stdtrit

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.criteria import aicc, memory_factor
from asymptotics.decays.identification.measuring.observations import Indices

Row = dict[str, float]
NORMAL = 1.96
"""Of the normal distribution, for errors that are known."""
_POWERS, _LEAST, _NEAR = ((0,), (0, 1), (0, 2), (0, 4), (0, 2, 4), (0, 1, 2)), 8, 6.0
"""Of A; turning times below which there is no error; and the AICc above the best up to which a
choice is believed too."""


@dataclass(frozen=True)
class TurningTimes:
    """``t`` of the turning points ``n`` with amplitudes ``size``; ``weight``: of each, over that of
    the first, where their errors are not alike; ``stated``: the standard error of the first, where it is known to be
    more than the scatter; ``root``: F of the covariance F F^T of their errors, where that is known, as of a
    smooth line; ``late``: by how much each is measured late over the strength of a dry friction, whose interval in the
    unit of ``size`` is ``friction`` (None: by nothing)."""

    n: Indices
    size: Array
    t: Array
    stated: float = 0.0
    weight: Array | None = None
    root: Array | None = None
    late: Array | None = None
    friction: Row | None = None

    @property
    def true(self) -> Array:
        """The times without what they are late."""
        return self.t if self.late is None or self.friction is None else self.t - self.late * self.friction["estimate"]

    def fitted(self, columns: list[Array]) -> "_Fitted":
        """1 and the columns, by least squares in units of the errors."""
        alike = np.diag(np.ones(len(self.t)) if self.weight is None else self.weight)
        white = alike if self.root is None else np.linalg.pinv(self.root)
        V = white @ np.stack([np.ones(len(self.t)), *columns], axis=1)
        inverse, y = np.linalg.pinv(V), white @ self.true
        c = inverse @ y
        freedom, left = len(y) - V.shape[1], y - V @ c
        rss = max(float((left**2).sum()), (1e-12 * float(np.ptp(self.t))) ** 2)
        known = 1.0 if self.root is not None else self.stated**2
        noise = max(rss / max(freedom, 1), known)
        if self.root is None:
            value = float(aicc(len(y) * np.log(noise), V.shape[1] + 1, len(y)))
            reach = noise * memory_factor(left) * float(stdtrit(max(freedom, 1), 0.975)) ** 2
        else:  # a line of few degrees has no more errors than them, and tells no more coefficients
            value, reach = rss + 2 * V.shape[1] if freedom > 0 else np.inf, noise * NORMAL**2
        moved = np.zeros(len(c)) if self.late is None else -(inverse @ (white @ self.late))
        return _Fitted(value, c[1:], (inverse @ inverse.T)[1:, 1:] * reach, moved[1:])

    def row(self, amplitude: float, each: list[tuple[float, float, float]]) -> Row:
        """The value of the first of (value, error, change with friction), and the interval of all of them."""
        f = self.friction or {"low": 0.0, "estimate": 0.0, "high": 0.0}
        low, high = np.inf, -np.inf
        for value, error, moved in each:
            ends = [moved * (f[k] - f["estimate"]) for k in ("low", "high")]
            low = min(low, value - float(np.hypot(error, min(*ends, 0.0))))
            high = max(high, value + float(np.hypot(error, max(*ends, 0.0))))
        return {"amplitude": amplitude, "low": low, "estimate": each[0][0], "high": high}


@dataclass(frozen=True)
class _Fitted:
    """The criterion; the coefficients but the first; their covariance times the square of the quantile; and how they
    change with a friction."""

    criterion: float
    c: Array
    covariance: Array
    moved: Array

    def at(self, by: Array) -> tuple[float, float, float]:
        return float(by @ self.c), float(np.sqrt(by @ self.covariance @ by)), float(by @ self.moved)


def backbone(times: TurningTimes) -> list[Row]:
    """T at the first amplitude, the geometric mean and the last, with 95 % intervals; none of too few times."""
    found, size = period_at(times), times.size
    ends = (float(size[0]), float(np.sqrt(size[0] * size[-1])), float(size[-1]))
    return [] if found is None else [found(a) for a in ends]


def period_at(times: TurningTimes) -> Callable[[float], Row] | None:
    """T with its interval as a function of the amplitude; None of too few times."""
    n, size = times.n, times.size
    if len(n) < _LEAST:
        return None
    middle = np.sqrt(size[1:] * size[:-1]) / size[0]
    sums = {k: np.concatenate([[0.0], np.cumsum(np.diff(n) * middle**k)]) / 2 for k in (0, 1, 2, 4)}
    found = [(powers, times.fitted([sums[k] for k in powers])) for powers in _POWERS]
    least = min(fit.criterion for _, fit in found)
    near = sorted((f for f in found if f[1].criterion < least + _NEAR), key=lambda f: f[1].criterion)

    if not near:
        return None

    def at(amplitude: float) -> Row:
        by = {powers: np.array([(amplitude / size[0]) ** k for k in powers]) for powers, _ in near}
        return times.row(amplitude, [fit.at(by[powers]) for powers, fit in near])

    return at


def mean_period(times: TurningTimes) -> Row:
    """Twice the slope of at least three turning times, each as good as the other: its chirp widens the interval."""
    found = times.fitted([times.n / 2])
    value, error, moved = found.at(np.ones(1))
    row = times.row(0.0, [(value, error, moved)])
    return {name: row[name] for name in ("low", "estimate", "high")}
