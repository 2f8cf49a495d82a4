"""What ln A loses in a half-swing at an amplitude: a sum of powers of A, fitted to the amplitudes of a decay.

Which powers, the criterion of Akaike says; the interval is that of all choices near the best.  The errors of amplitudes
are alike and independent (turning points), proportional to numbers that are known, or have a covariance that is known
(a smooth line): then sums of squares count in units of it, and are no less than what it says.

>>> n = np.arange(30)
>>> found = decline_of(n, 2 * np.exp(-0.05 * n), 0.0, 1.0)(1.0)
>>> f"{found['estimate']:.4f}"
'0.0500'
"""

from dataclasses import dataclass
from functools import partial
from itertools import combinations
from math import log

import numpy as np
from scipy.special import stdtrit

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.criteria import aicc, memory_factor
from asymptotics.decays.identification.measuring.observations import Indices
from asymptotics.decays.identification.telling.backbone import NORMAL

Ends = dict[str, float]
_POWERS, _TERMS, LEAST, _NEAR = (-1, 0, 1, 2, 3), 3, 5, 4.0
"""Of A, in the fall of ln A: those by the losses of exponents 0 to 3, and of a loss in v^2 beside a pendulum; how many
together; turning points below which there is one power alone; and the AICc above the best up to which a choice of
powers is believed too."""
_HALVES, _REFUTED = (-0.5, 0.5, 1.5), 10.0
"""Powers by losses of exponents between, beside the others where their AICc is the lowest.  In 60 decays each in noise
of 0.03 to 1 % the whole powers alone hold the fall by 1/2, 5/4, 3/2, 17/10 and 5/2 in 26, 45, 48, 59 and 71 % of the
intervals, these in 97, 82, 98, 96 and 97 %, and those by 1, 2, 3 and sums of them as before, 5 % wider.  The whole
powers are left where their AICc is higher by 10: chance alone makes 4 of so many choices."""


@dataclass(frozen=True)
class _Fall:
    """The fall of ln A in a half-swing as a sum of powers; ``covariance``: times the square of the quantile."""

    powers: tuple[float, ...]
    coefficients: Array
    covariance: Array

    def at(self, amplitude: float) -> tuple[float, float]:
        by = np.array([amplitude**k for k in self.powers])
        return float(by @ self.coefficients), float(np.sqrt(by @ self.covariance @ by))

    @property
    def dry(self) -> tuple[float, float]:
        """The part in 1/A, as of dry friction, with the half length of its interval."""
        if -1 not in self.powers:
            return 0.0, 0.0
        place = self.powers.index(-1)
        return float(self.coefficients[place]), float(np.sqrt(self.covariance[place, place]))


@dataclass(frozen=True)
class Decline:
    """What ln A loses in a half-swing at an amplitude: the best choice of powers first, then those near it, of A over
    ``first``."""

    first: float
    falls: tuple[_Fall, ...]

    def __call__(self, amplitude: float) -> Ends:
        """The loss at an amplitude: the value of the best choice, the interval of all."""
        return _united([fall.at(amplitude / self.first) for fall in self.falls])

    def friction(self) -> Ends:
        """Half of what A itself loses in a half-swing by the part in 1/A: the force of dry friction over the stiffness,
        in the unit of A, never negative; 0 where no choice has the part."""
        ends = _united([fall.dry for fall in self.falls])
        return {name: max(value, 0.0) * self.first / 2 for name, value in ends.items()}


def decline_of(
    n: Indices, size: Array, stated: float, error: Array | float, root: Array | None = None
) -> Decline | None:
    """What ln A loses in a half-swing at an amplitude: the sum of powers of A that the criterion chooses.

    ``root``: F of the covariance F F^T of the amplitudes, where it is known, as that of a smooth line.
    """
    # Of a few points all choices of one power have as many numbers: their sums of squares alone compare them.
    few = len(n) < LEAST
    white = np.eye(len(size)) if root is None else np.linalg.pinv(root / size[0])
    weight = size / size[0] / error  # where the errors of the amplitudes are alike, those of their logarithms are not
    tried = partial(_tried, n, size, weight, white, None if root is not None else stated, few)
    found = _near(tried(_choices(_POWERS, 1 if few else _TERMS)))
    if not found:
        return None
    if not few:
        between = _near(tried([c for c in _choices((*_POWERS, *_HALVES), _TERMS) if set(c) & set(_HALVES)]))
        if between and between[0][0] < found[0][0]:
            # The others stay beside them, unless they are refuted.
            found = between + (found if found[0][0] < between[0][0] + _REFUTED else [])
    return Decline(float(size[0]), tuple(fall for _, fall in found))


def _near(tried: list[tuple[float, _Fall]]) -> list[tuple[float, _Fall]]:
    """The best first, and what is hardly worse."""
    ordered = sorted(tried, key=lambda pair: pair[0])
    return [pair for pair in ordered if pair[0] < ordered[0][0] + _NEAR]


def _choices(powers: tuple[float, ...], most: int) -> list[tuple[float, ...]]:
    """Every choice of so many of them at most."""
    return [c for count in range(1, most + 1) for c in combinations(powers, count)]


def _tried(
    n: Indices,
    size: Array,
    weight: Array,
    white: Array,
    stated: float | None,
    few: bool,
    choices: list[tuple[float, ...]],
) -> list[tuple[float, _Fall]]:
    """(criterion, fall) of each choice; ``stated``: None where ``white`` undoes a covariance that is known."""
    gap = np.diff(n)
    # The geometric mean is the amplitude in the middle; sums forgive noise where differences would not.
    middle = np.sqrt(size[1:] * size[:-1]) / size[0]
    powers = {k for c in choices for k in c}
    sums = {k: white @ (weight * -np.concatenate([[0.0], np.cumsum(gap * middle**k)])) for k in powers}
    ones, y = white @ weight, white @ (weight * np.log(size))
    found = []
    for choice in choices:
        V = np.stack([ones, *(sums[k] for k in choice)], axis=1)
        # The rest position was taken from them too, which counts where they are few.
        c, freedom = np.linalg.lstsq(V, y, rcond=None)[0], max(len(y) - V.shape[1] - few, 1)
        left = y - V @ c
        rss = max(float((left**2).sum()), 1e-24)
        known = stated is None
        deviance = rss if known else len(y) * log(rss / len(y))
        value = deviance if few else deviance + 2 * V.shape[1] if known else aicc(deviance, V.shape[1] + 1, len(y))
        if np.isfinite(value) and len(y) >= V.shape[1]:
            # What is told of the amplitudes elsewhere counts where it is more than the scatter, as for a smooth line.
            floor, memory = (1.0, 1.0) if stated is None else ((stated / size[0]) ** 2, memory_factor(left))
            noise = max(rss / freedom, floor) * memory
            quantile = NORMAL if known else float(stdtrit(freedom, 0.975))
            covariance = (np.linalg.pinv(V.T @ V) * noise)[1:, 1:] * quantile**2
            found.append((value, _Fall(choice, c[1:], covariance)))
    return found


def decline_of_few(n: Indices, size: Array, stated: float) -> Decline:
    """The same of two or three amplitudes: of every power alone, whose intervals are those of ``stated`` errors where
    they are known, else of what a straight line leaves of three."""
    middle, weight = np.sqrt(size[1:] * size[:-1]) / size[0], size / size[0]
    freedom, y = len(n) - 2, weight * np.log(size)
    quantile = NORMAL if stated else float(stdtrit(freedom, 0.975)) if freedom else np.nan
    falls = []
    for k in sorted(_POWERS, key=abs):  # viscous drag first: its estimate is told
        V = np.stack([weight, -weight * np.concatenate([[0.0], np.cumsum(np.diff(n) * middle**k)])], axis=1)
        c = np.linalg.lstsq(V, y, rcond=None)[0]
        left = float(((y - V @ c) ** 2).sum()) / max(freedom, 1)
        noise = max(left if freedom else 0.0, (stated / size[0]) ** 2)
        falls.append(_Fall((k,), c[1:], np.linalg.inv(V.T @ V)[1:, 1:] * noise * quantile**2))
    return Decline(float(size[0]), tuple(falls))


def _united(each: list[tuple[float, float]]) -> Ends:
    """The estimate of the first and the interval of all; without errors no ends."""
    ends = np.array([[value - error, value + error] for value, error in each])
    return {"low": float(ends[:, 0].min()), "estimate": each[0][0], "high": float(ends[:, 1].max())}
