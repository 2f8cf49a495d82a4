"""The backbone of a record: its period at the amplitudes of the data, before any law.

The time of a half-swing is half the period at its amplitude, T(A) = c_0 and powers 1, 2 and 4 of A (a spring x|x|, a
cubic or fifth one, a pendulum), two of them at most, of an angle beyond 1 rad also these times that of a pendulum,
2 K(sin(A/2))/pi; each choice has the weight of its AICc (``averaged``).  Sums over
the swings are fitted to the turning times, which forgives noise.  What a loss does to the period is of second order in
its strength, and stands in T as it is.

Turning times that are measured late by dry friction, of strength f/A by late f, are late by more and more as A sinks,
and a period of them is too long.  How much of that friction there is the amplitudes tell (``Decline.friction``): the
times are corrected by its estimate, and the intervals hold what its interval may do.

>>> n = np.arange(40)
>>> size = 0.97**n
>>> t = np.concatenate([[0], np.cumsum(np.pi * (1 - 0.1 * size[1:] * size[:-1]))])
>>> [f"{row['estimate']:.3f}" for row in backbone(TurningTimes(n, size, t))]
['5.655', '6.092', '6.225']
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np
from scipy.special import ellipk

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.criteria import aicc, memory_factor
from asymptotics.decays.identification.measuring.observations import Indices
from asymptotics.decays.identification.telling.averaged import ENDS, NORMAL, Told, averaged, united
from asymptotics.decays.identification.telling.decline import FAR, TOP

Row = dict[str, float]
_POWERS, _LEAST = ((0,), (0, 1), (0, 2), (0, 4), (0, 2, 4), (0, 1, 2)), 8
"""Of A, and turning times below which there is no error."""


@dataclass(frozen=True)
class TurningTimes:
    """``t`` of the turning points ``n`` with amplitudes ``size``; ``weight``: of each, over that of
    the first, where their errors are not alike; ``stated``: the standard error of the first, where it is known to be
    more than the scatter; ``root``: F of the covariance F F^T of their errors, where that is known, as of a
    smooth line; ``late``: by how much each is measured late over the strength of a dry friction, whose interval in the
    unit of ``size`` is ``friction`` (None: by nothing); ``angle``: the first amplitude in rad (0: it is none)."""

    n: Indices
    size: Array
    t: Array
    stated: float = 0.0
    weight: Array | None = None
    root: Array | None = None
    late: Array | None = None
    friction: Row | None = None
    angle: float = 0.0

    @property
    def true(self) -> Array:
        """The times without what they are late."""
        return self.t if self.late is None or self.friction is None else self.t - self.late * self.friction["estimate"]

    @property
    def unsure(self) -> float:
        """The standard error of the friction."""
        return 0.0 if self.friction is None else (self.friction["high"] - self.friction["low"]) / (2 * NORMAL)

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
            noise, spare = noise * memory_factor(left), float(max(freedom, 1))
        else:  # a line of few degrees has no more errors than them, and tells no more coefficients
            value, spare = rss + 2 * V.shape[1] if freedom > 0 else np.inf, np.inf
        moved = np.zeros(len(c)) if self.late is None else -(inverse @ (white @ self.late))
        return _Fitted(value, spare, c[1:], (inverse @ inverse.T)[1:, 1:] * noise, moved[1:])

    def row(self, amplitude: float, each: list[tuple["_Fitted", Array]], names: Iterable[str]) -> Row:
        """What the fits say, each of its coefficients in these proportions, and what the friction leaves open."""
        return {"amplitude": amplitude, **averaged([fit.told(by, self.unsure) for fit, by in each], names)}


@dataclass(frozen=True)
class _Fitted:
    """The criterion, and the freedoms of the noise; the coefficients but the first; their covariance; and how they
    change with a friction."""

    criterion: float
    freedom: float
    c: Array
    covariance: Array
    moved: Array

    def told(self, by: Array, unsure: float) -> Told:
        """The sum of the coefficients in these proportions; ``unsure``: the standard error of the friction."""
        error = float(np.sqrt(by @ self.covariance @ by))
        return Told(float(by @ self.c), float(np.hypot(error, by @ self.moved * unsure)), self.criterion, self.freedom)


def backbone(times: TurningTimes) -> list[Row]:
    """T at the first amplitude, the geometric mean and the last, with 95 % intervals; none of too few times."""
    found, size = period_at(times), times.size
    ends = (float(size[0]), float(np.sqrt(size[0] * size[-1])), float(size[-1]))
    return [] if found is None else [found(a) for a in ends]


def period_at(times: TurningTimes, names: Iterable[str] = ENDS) -> Callable[[float], Row] | None:
    """T with its interval, or some of these ``names``, as a function of the amplitude; None of too few times."""
    n, size = times.n, times.size
    if len(n) < _LEAST:
        return None
    middle = np.sqrt(size[1:] * size[:-1]) / size[0]
    kinds = (0.0, times.angle) if FAR < times.angle < TOP else (0.0,)
    found = []
    for angle in kinds:
        each = {k: np.diff(n) * _period(middle, k, angle) for k in (0, 1, 2, 4)}
        sums = {k: np.concatenate([[0.0], np.cumsum(column)]) / 2 for k, column in each.items()}
        found += [(angle, powers, times.fitted([sums[k] for k in powers])) for powers in _POWERS]
    found = [(angle, powers, fit) for angle, powers, fit in found if np.isfinite(fit.criterion)]
    if not found:
        return None

    def at(amplitude: float) -> Row:
        place = np.array(amplitude / size[0])
        told = [(fit, np.array([_period(place, k, angle) for k in powers])) for angle, powers, fit in found]
        return times.row(amplitude, told, names)

    return at


def _period(amplitude: Array, power: int, angle: float) -> Array:
    """A power of A in units of the first; of an ``angle`` there, times the period of a pendulum over that of a small
    swing."""
    ratio = 2 / np.pi * ellipk(np.sin(np.minimum(amplitude * angle, TOP) / 2) ** 2)
    return np.asarray(amplitude**power * ratio)


def mean_period(times: TurningTimes) -> Row:
    """Twice the slope of at least three turning times, each as good as the other: its chirp widens the interval."""
    return united([times.fitted([times.n / 2]).told(np.ones(1), times.unsure)])
