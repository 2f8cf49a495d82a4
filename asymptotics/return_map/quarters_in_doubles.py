"""The quarter-swings of ``quarters`` in doubles: a first solution, its corrections, and how many nodes it will take.

Choices only: nothing here enters a bound.

>>> quarter = QuarterInDoubles(np.array([2.0]), np.array([[0.1]]), np.array([1.0]), np.array([0.0]))
>>> count, rim = quarter.planned(100)
>>> 50 < count < 100, 2 < rim < 3
(True, True)
"""

from dataclasses import dataclass

import numpy as np

from asymptotics.errors import UndecidedError
from asymptotics.numbers.context import lru_cache

Array = np.ndarray[tuple[int, ...], np.dtype[np.float64]]
# Too few make a poor plan, which costs nodes or is refused: 32 to 96 plan the same, 24 too few for alpha = 1/2
# (``benchmarks/constants.json``).
_FIRST = 48  # nodes of the trial
_ROUNDS, _AGREED = 40, 1e-13
# kappa near 1 makes M large and Gronwall's factor worse; 0.7 leaves 0.3 for 1 - kappa, and pieces serve beyond.
_FULL = 0.7  # of 1: the most of |c D| that a plan allows
_FLOOR = 1e-12  # coefficients below this part of the largest are rounding
# R from 1.1 to 33, three per cent apart.
_RIMS = np.exp(np.linspace(0.1, 3.5, 120))
_ARCS = 48
_ALONE = 250_000  # multiplications that one thread does


@dataclass(frozen=True)
class QuarterInDoubles:
    """alpha_i, the signed strengths by law and column, h and g_0 by column."""

    alphas: Array
    strengths: Array
    h: Array
    g0: Array

    def rates(self, g: Array) -> tuple[Array, Array]:
        """dg/dt at the nodes (rows), and its derivative by g."""
        z = self.h * (_nodes(len(g))[:, None] - 1)
        s, c = 1 / np.cosh(z), -np.tanh(z)
        drags = [e * s**a * np.exp((a - 1) * g) for a, e in zip(self.alphas, self.strengths)]
        drag, slope = sum(drags), sum((a - 1) * d for a, d in zip(self.alphas, drags))
        room = 1 - c * drag
        return -self.h * s**2 * drag / room, -self.h * s**2 * slope / room**2

    def solved(self, m: int) -> Array:
        """The solution g at m nodes, by Newton's method on the integral equation."""
        whole, _ = integration(m)
        g = np.zeros((m, 1)) + self.g0
        with np.errstate(all="ignore"):
            for _ in range(_ROUNDS):
                f, slope = self.rates(g)
                # Newton's method: the linear integral equation for the change by its integrating factor, once, as the
                # next step repeats it.
                change = corrected(slope, self.g0 + _product(whole, f)[:-1] - g, 1)
                g = g + change
                if not np.all(np.isfinite(change)):
                    break
                if np.max(np.abs(change)) < _AGREED:
                    return g
        raise UndecidedError("the quarter-swings were not found in doubles")

    def planned(self, bits: int) -> tuple[int, float]:
        """(how many nodes, the parameter of the ellipse) for an error near 2^-bits."""
        with np.errstate(all="ignore"):
            return self._planned(bits)

    def _planned(self, bits: int) -> tuple[int, float]:
        f, _ = self.rates(self.solved(_FIRST))
        b = np.max(np.abs(_product(integration(_FIRST)[1], f)), axis=1)
        # The coefficients of the integral, as in ``spectral.of_the_integral``.
        grown = np.abs(b[:-2] - b[2:])[: _FIRST - 3] / (2 * np.arange(1, _FIRST - 2))
        best = (np.inf, 0.0)
        for rim in _RIMS:
            size = self._size_on(rim, _sum_on(grown, rim))
            if size is not None:
                # ``chebyshev.cut`` for M + N, solved for m and minimised over R.
                count = (bits + np.log2(4 * size / (rim - 1) + 1)) / np.log2(rim)
                best = min(best, (count, float(rim)))
        if not best[0] < np.inf:
            raise UndecidedError("no ellipse about the quarter-swings is free of singularities")
        return int(best[0]) + 2, best[1]

    def _size_on(self, rim: float, swell: float) -> float | None:
        """M + N on the ellipse, None where it is too large."""
        phi = np.linspace(0, np.pi, _ARCS)
        t = (rim * np.exp(1j * phi) + np.exp(-1j * phi) / rim) / 2
        h = np.max(self.h)
        # A little below pi/2, where s has its pole.
        if h * (rim - 1 / rim) / 2 > 1.5 or not np.isfinite(swell):
            return None
        z = h * (t - 1)
        s = np.abs(1 / np.cosh(z))
        weights = self.alphas - 1
        sizes = np.max(np.abs(self.strengths) * np.exp(weights[:, None] * self.g0), axis=1)
        drag = sum(e * np.exp(abs(w) * swell) * s**a for e, w, a in zip(sizes, weights, self.alphas))
        kappa = np.max(drag * np.abs(np.tanh(z)))
        return float(h * np.max(s**2 * drag + s) / (1 - kappa)) if kappa < _FULL else None


def corrected(slope: Array, residual: Array, rounds: int = 5) -> Array:
    """The solution of e = residual + integral of (slope e): by the integrating factor, iterated."""
    whole, _ = integration(len(slope))
    factor = np.exp(_product(whole, slope)[:-1])
    found, left = np.zeros_like(residual), residual
    for k in range(rounds):
        if k:
            left = residual - found + _product(whole, slope * found)[:-1]
        found = found + left + factor * _product(whole, slope * left / factor)[:-1]
    return found


def _product(matrix: Array, columns: Array) -> Array:
    """Some columns at a time: larger products would be spread over threads, which cost more than they save."""
    step = max(1, _ALONE // matrix.size)
    return np.hstack([matrix @ columns[:, k : k + step] for k in range(0, columns.shape[1], step)])


def _sum_on(sizes: Array, rim: float) -> float:
    """sum |B_k| (R^k + R^-k)/2 with the part that is lost in rounding as a geometric series."""
    k = np.arange(1, len(sizes) + 1)
    known = int(np.max(np.nonzero(sizes > _FLOOR * np.max(sizes))[0])) + 1 if np.max(sizes) > 0 else 0
    if known < 4:
        return float(np.sum(sizes[:known] * rim ** k[:known]))
    fall = (sizes[known - 1] / sizes[known // 2]) ** (1 / (known - 1 - known // 2)) * rim
    # The coefficients fall more slowly than R^-k: G is not seen to be bounded on that ellipse.
    if not fall < 0.98:
        return np.inf
    return float(np.sum(sizes[:known] * rim ** k[:known]) / 2 + sizes[known - 1] * rim**known * fall / (1 - fall))


def _nodes(m: int) -> Array:
    angles: Array = np.pi * (2 * np.arange(m) + 1) / (2 * m)
    return np.cos(angles)


@lru_cache(maxsize=8)
def integration(m: int) -> tuple[Array, Array]:
    """The matrices ``spectral.integration`` and ``spectral.analysis``."""
    angles = np.pi * (2 * np.arange(m) + 1) / (2 * m)
    T = np.hstack([np.cos(np.arange(m + 1)[:, None] * angles), np.ones((m + 1, 1))])
    k = np.arange(2, m)[:, None]
    whole = np.empty((m, m + 1))
    whole[0], whole[1] = T[1] + 1, (T[2] - 1) / 4
    whole[2:] = T[3:] / (2 * (k + 1)) - T[1 : m - 1] / (2 * (k - 1)) - (-1.0) ** k / (k * k - 1)
    values = 2 / m * T[:m, :m]
    values[0] /= 2
    return whole.T @ values, values
