"""What ln A loses in a half-swing at an amplitude: a sum of powers of A, fitted to the amplitudes of a decay.

The fall L of ln A from A_n to A_(n+1) is told by 2 sinh(L/2), the loss of A over the geometric mean of both: of dry
friction, whose loss of A is the same in each half-swing, that is a power of the mean exactly, where L is one to first
order only.  Which powers, whole ones or one that is fitted too, nobody knows: each choice has the weight of its AICc,
and the interval is that of their average (``averaged``).  Of an angle beyond 1 rad what the same losses take beside a
pendulum are further choices.  The errors of amplitudes are alike and independent (turning
points), proportional to numbers that are known, or have a covariance that is known (a smooth line): then sums of
squares count in units of it, and are no less than what it says.

>>> n = np.arange(30)
>>> found = decline_of(n, 2 * np.exp(-0.05 * n), 0.0, 1.0)(1.0)
>>> f"{found['estimate']:.4f}"
'0.0500'
"""

from dataclasses import dataclass
from itertools import combinations
from math import log

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.criteria import aicc, memory_factor
from asymptotics.decays.identification.measuring.observations import Indices
from asymptotics.decays.identification.telling.averaged import Ends, Told, averaged, mean_of, united

_POWERS, _TERMS, LEAST, _NEAR = (-1, 0, 1, 2, 3), 3, 5, 4.0
"""Of A, in the fall of ln A: those by the losses of exponents 0 to 3, and of a loss in v^2 beside a pendulum; how many
together; turning points below which there is one power alone, and what their criterion may then be above the best."""
_BESIDE, _STEPS, _WITHIN, _STILL = ((), (-1,), (0,)), 12, (-1.5, 4.0), 1e-6
"""What stands beside a power that is fitted, as of a loss whose exponent is no whole number; its steps from viscous
drag on, what it may be, and a step that ends them.  Powers of halves and quarters in its place hold the fall by
exponents 4/3 and 17/10 in 0 to 40 % of the intervals of decays in a noise of 0.0003."""
_STEP = 1e-4
"""Of a power, for a derivative by it."""
_ROUGHLY, _FAR_OFF = (-1, 0, 1), (-20.0, 5.0)
"""The powers of a first fit; logarithms beyond which its curve is none."""
FAR, TOP = 1.0, 3.1
"""Angles from which on the fall may be that of a pendulum, and up to which its amplitudes are told.  Below the first
three powers follow the fall by a loss in v^2 and less within 0.07 %, that in v^3 within 0.3 %."""
_PLACES = np.pi / 4 * (1 + np.tanh(np.sinh(np.linspace(-3, 3, 61))))
_COSINES = np.cos(_PLACES)
_WEIGHTS = np.cosh(np.linspace(-3, 3, 61)) / np.cosh(np.sinh(np.linspace(-3, 3, 61))) ** 2
"""Of integrals over a quarter of a turn, by the rule of Takahasi and Mori: for any power of the cosine, and up to the
top; a factor of all weights counts for nothing."""
_FOR_SCATTER = 6
"""Third differences that tell a scatter.  A choice."""


@dataclass(frozen=True)
class _Fall:
    """2 sinh of half the fall of ln A in a half-swing as a sum of powers, with the ``covariance`` of the coefficients;
    ``free``: the last power was fitted too, and the last coefficient, which is 0, is that of its change; the
    ``criterion`` of this choice, and the freedoms behind its errors; ``angle``: of powers beside a pendulum, the first
    amplitude in rad (0: beside a linear spring)."""

    powers: tuple[float, ...]
    coefficients: Array
    covariance: Array
    criterion: float = 0.0
    freedom: float = np.inf
    free: bool = False
    angle: float = 0.0

    def at(self, amplitude: float) -> Told:
        """The fall of ln A."""
        by = np.array([_power(np.array(amplitude), k, self.angle) for k in self.powers])
        if self.free:
            by = np.append(by, _by_power(np.array(amplitude), self.powers[-1], self.angle))
        half, error = float(by @ self.coefficients) / 2, float(np.sqrt(by @ self.covariance @ by))
        return Told(2 * float(np.arcsinh(half)), error / float(np.hypot(1.0, half)), self.criterion, self.freedom)

    @property
    def dry(self) -> Told:
        """The part in 1/A, as of dry friction."""
        if -1 not in self.powers:
            return Told(0.0, 0.0, self.criterion)
        place = self.powers.index(-1)
        small = _sine(self.angle)
        error = small * float(np.sqrt(self.covariance[place, place]))
        return Told(small * float(self.coefficients[place]), error, self.criterion, self.freedom)


@dataclass(frozen=True)
class Decline:
    """What ln A loses in a half-swing at an amplitude, by several choices of powers of A over ``first``; ``every``: the
    interval holds those of all of them, since there is nothing to choose by, and the first is told."""

    first: float
    falls: tuple[_Fall, ...]
    every: bool = False

    def __call__(self, amplitude: float) -> Ends:
        """The loss at an amplitude, with its interval."""
        told = [fall.at(amplitude / self.first) for fall in self.falls]
        return united(told) if self.every else averaged(told)

    def friction(self) -> Ends:
        """Half of what A itself loses in a half-swing by the part in 1/A: the force of dry friction over the stiffness,
        in the unit of A, never negative; 0 where no choice has the part.  A power that is fitted says nothing of it."""
        ends = mean_of([fall.dry for fall in self.falls if not fall.free])
        return {name: max(value, 0.0) * self.first / 2 for name, value in ends.items()}


def decline_of(
    n: Indices, size: Array, stated: float, error: Array | float, root: Array | None = None, angle: float = 0.0
) -> Decline | None:
    """What ln A loses in a half-swing at an amplitude: sums of powers of A, weighted by their criterion.

    ``root``: F of the covariance F F^T of the amplitudes, where it is known, as that of a smooth line; ``angle``: the
    first amplitude in rad, where they are those of an angle (0: they are not).
    """
    # Of a few points all choices of one power have as many numbers: their sums of squares alone compare them.
    few = len(n) < LEAST
    tried = _Logarithms(n, size, error, root, stated, few)
    found = [tried.fall(c) for c in _choices(_POWERS, 1 if few else _TERMS)]
    if not few:
        found += [tried.free(beside) for beside in _BESIDE]
        if FAR < angle < TOP:
            found += [tried.fall(c, angle) for c in _choices(_POWERS[:-1], _TERMS)]
            found += [tried.free(beside, angle) for beside in _BESIDE]
    falls = sorted((f for f in found if np.isfinite(f.criterion)), key=lambda fall: fall.criterion)
    if few:
        falls = [fall for fall in falls if fall.criterion < falls[0].criterion + _NEAR]
    return Decline(float(size[0]), tuple(falls), every=few) if falls else None


def _choices(powers: tuple[float, ...], most: int) -> list[tuple[float, ...]]:
    """Every choice of so many of them at most."""
    return [c for count in range(1, most + 1) for c in combinations(powers, count)]


class _Logarithms:
    """The logarithms of amplitudes as sums over their half-swings; ``stated``: the error of an amplitude, of no use
    where there is a ``root`` of the covariance; ``error``: errors in proportion, those of logarithms, or 1 where the
    amplitudes have errors that are alike.

    Then a logarithm weighs as its amplitude, that of the curve: what a noise lifts would else weigh more than what it
    lowers, and the curve would lie above them.  And the mean of ln(A + e) is ln A - sigma^2/(2 A^2).
    """

    def __init__(
        self, n: Indices, size: Array, error: Array | float, root: Array | None, stated: float, few: bool
    ) -> None:
        white = np.eye(len(size)) if root is None else np.linalg.pinv(root / size[0])
        self.known, self.few, self.stated = root is not None, few, stated / size[0]
        self.gap, self.white = np.diff(n), white
        # The geometric mean is the amplitude in the middle.
        self.middle = np.sqrt(size[1:] * size[:-1]) / size[0]
        self.bent = np.ones(len(self.gap))
        logarithm = np.log(size / size[0])
        self._weigh(size / size[0] / error, logarithm)
        V = np.stack([self.ones, *(self.column(self.middle**k) for k in _ROUGHLY)], axis=1)
        c = np.linalg.lstsq(V, self.y, rcond=None)[0]
        s = np.stack([self.middle**k for k in _ROUGHLY], axis=1) @ c[1:]
        # s = 2 sinh(L/2) is the sum of powers, and L is what ln A loses: L/s hardly depends on a first s.
        half = np.clip(np.abs(s), 1e-6, 2.0) / 2
        self.bent = np.arcsinh(half) / half
        if np.ndim(error) == 0 and not few:
            curve = np.exp(np.clip(c[0] - np.concatenate([[0.0], np.cumsum(self.gap * s)]), *_FAR_OFF))
            spread = (
                _scatter(self.gap, (logarithm - np.log(curve)) * curve) if root is None else _lengths(root) / size[0]
            )
            self._weigh(curve, logarithm + (spread / curve) ** 2 / 2)

    def _weigh(self, weight: Array, logarithm: Array) -> None:
        self.weight, self.ones, self.y = weight, self.white @ weight, self.white @ (weight * logarithm)

    def column(self, each: Array) -> Array:
        """What the falls in each half-swing make of the logarithms: sums forgive noise where differences would not."""
        return np.asarray(self.white @ (self.weight * -np.concatenate([[0.0], np.cumsum(self.gap * self.bent * each)])))

    def fall(self, powers: tuple[float, ...], angle: float = 0.0) -> _Fall:
        """By these powers."""
        return self._told(powers, [self.column(_power(self.middle, k, angle)) for k in powers], angle=angle)

    def free(self, beside: tuple[float, ...], angle: float = 0.0) -> _Fall:
        """By one power that is fitted, beside others: linear steps from 0, as long as they lead anywhere."""
        power, columns = 0.0, [self.column(_power(self.middle, k, angle)) for k in beside]
        for _ in range(_STEPS):
            by = [*columns, *self._moved(power, angle)]
            c = np.linalg.lstsq(np.stack([self.ones, *by], axis=1), self.y, rcond=None)[0]
            step = float(np.clip(c[-1] / c[-2], -0.5, 0.5)) if c[-2] else 0.0
            power = float(np.clip(power + step, *_WITHIN))
            if abs(step) < _STILL:
                break
        return self._told((*beside, power), [*columns, *self._moved(power, angle)], True, angle)

    def _moved(self, power: float, angle: float) -> list[Array]:
        """The columns of a power and of its change."""
        return [self.column(part(self.middle, power, angle)) for part in (_power, _by_power)]

    def _told(self, powers: tuple[float, ...], columns: list[Array], free: bool = False, angle: float = 0.0) -> _Fall:
        V = np.stack([self.ones, *columns], axis=1)
        # The rest position was taken from them too, which counts where they are few.
        freedom = max(len(self.y) - V.shape[1] - self.few, 1)
        c = np.linalg.lstsq(V, self.y, rcond=None)[0]
        left = self.y - V @ c
        rss = max(float((left**2).sum()), 1e-24)
        deviance = rss if self.known else len(self.y) * log(rss / len(self.y))
        value = aicc(deviance, V.shape[1] + 1, len(self.y))
        if self.few or self.known:
            value = (deviance if self.few else deviance + 2 * V.shape[1]) if len(self.y) >= V.shape[1] else np.inf
        # What is told of the amplitudes elsewhere counts where it is more than the scatter, as for a smooth line.
        noise = max(rss / freedom, 1.0) if self.known else max(rss / freedom, self.stated**2) * memory_factor(left)
        covariance = (np.linalg.pinv(V.T @ V) * noise)[1:, 1:]
        told = np.asarray(c[1:], dtype=float)
        return _Fall(powers, told, covariance, value, np.inf if self.known else freedom, free, angle)


def _power(amplitude: Array, power: float, angle: float) -> Array:
    """A power of A in units of the first; where that is an ``angle``, what stands in its place beside a pendulum: the
    fall by a loss in v^(power + 1), to first order.

    With q = 2 sin(x/2) = 2 k cos(phi) such a loss takes from ln q in a half-swing what is in proportion to
    q^power int_0^(pi/2) cos(phi)^(power + 2)/sqrt(1 - k^2 sin(phi)^2) dphi, and d ln A/d ln q = tan(A/2)/(A/2).

    >>> from scipy.special import ellipe, ellipk
    >>> k = np.sin(1.0)  # viscous drag, at 2 rad
    >>> viscous = 4 / np.pi * (ellipe(k**2) - (1 - k**2) * ellipk(k**2)) / k**2 * np.tan(1.0)
    >>> bool(np.isclose(_power(np.array([1.0]), 0.0, 2.0)[0], viscous, rtol=1e-8))
    True
    """
    if not angle:
        return np.asarray(amplitude**power)
    half = np.minimum(amplitude * angle, TOP) / 2
    k = np.sin(half)
    each = _COSINES ** (power + 2) / np.sqrt(1 - (k[..., None] ** 2) * (1 - _COSINES**2))
    ratio = (each @ _WEIGHTS) / (_COSINES ** (power + 2) @ _WEIGHTS)
    return np.asarray((k / np.sin(angle / 2)) ** power * ratio * np.tan(half) / half)


def _by_power(amplitude: Array, power: float, angle: float) -> Array:
    """The derivative of ``_power`` by the power."""
    if not angle:
        return np.asarray(amplitude**power * np.log(amplitude))
    up, down = (_power(amplitude, power + step, angle) for step in (_STEP, -_STEP))
    return np.asarray((up - down) / (2 * _STEP))


def _sine(angle: float) -> float:
    """sin(x/2)/(x/2): what a small amplitude is in units of the first, over the same of the well coordinate."""
    return float(np.sinc(angle / 2 / np.pi))


def _scatter(gap: Indices, left: Array) -> float:
    """The error of an amplitude by the third differences of what a curve leaves, which a smooth rest does not enter; 0
    of too few that are as far apart."""
    third = np.diff(left, 3)[(gap[2:] == gap[1:-1]) & (gap[1:-1] == gap[:-2])]
    return float(np.median(np.abs(third))) / (0.6745 * 20**0.5) if len(third) >= _FOR_SCATTER else 0.0


def _lengths(root: Array) -> Array:
    """The standard errors by a root of their covariance."""
    return np.asarray(np.sqrt((root**2).sum(axis=1)))


def decline_of_few(n: Indices, size: Array, stated: float) -> Decline:
    """The same of two or three amplitudes: of every power alone, whose intervals are those of ``stated`` errors where
    they are known, else of what a straight line leaves of three."""
    middle, weight, gap = np.sqrt(size[1:] * size[:-1]) / size[0], size / size[0], np.diff(n)
    half = np.maximum(np.abs(np.diff(np.log(size))) / gap / 2, _STILL)
    gap, freedom, y = gap * half / np.sinh(half), len(n) - 2, weight * np.log(size)
    falls = []
    for k in sorted(_POWERS, key=abs):  # viscous drag first: its estimate is told
        V = np.stack([weight, -weight * np.concatenate([[0.0], np.cumsum(gap * middle**k)])], axis=1)
        c = np.linalg.lstsq(V, y, rcond=None)[0]
        left = float(((y - V @ c) ** 2).sum()) / max(freedom, 1)
        noise = max(left if freedom else 0.0, (stated / size[0]) ** 2)
        covariance = np.linalg.inv(V.T @ V)[1:, 1:] * noise
        falls.append(_Fall((k,), c[1:], covariance, freedom=np.inf if stated else freedom))
    return Decline(float(size[0]), tuple(falls), every=True)
