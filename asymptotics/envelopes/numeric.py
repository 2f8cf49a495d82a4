"""The averaged law for NumPy arrays, in double precision: heuristic, nothing here is an enclosure.

ds/dtau = g(s) = sum_i kappa_i e^(-(alpha_i-1)s), s = -ln A.  One law is closed.  For several laws tau(s) is tabulated
once on panels of width 1/(4 max(1, |alpha_i-1|)) with eight Gauss-Legendre nodes each (the integrand is analytic on a
strip that is wide against a panel); A(tau) is a bisection in the table and three Newton steps inside the panel.

NaN stays NaN in its place; times at or after the extinction time give 0, as the averaged law does; a negative time is
refused.  Amplitudes below e^-700 come out as 0.

>>> envelope = NumericEnvelope.of([(1.0, 0.1), (2.0, 0.05)])
>>> tau = np.array([0.0, 5.0, np.nan])
>>> A = envelope.amplitude(tau)
>>> A.round(9).tolist(), envelope.time(A).round(12).tolist()
([1.0, 0.506821332, nan], [0.0, 5.0, nan])
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from asymptotics.errors import InputError

Array = NDArray[np.float64]

NODES = 8
# e^-700 is still a normal double; e^-709 is not.
LAST_S = 700.0


@dataclass(frozen=True, eq=False)
class NumericEnvelope:
    """A(tau), tau(A) for ``weights`` alpha_i - 1 and strengths ``kappas``; ``edges``, ``times``: a table of tau(s)."""

    weights: tuple[float, ...]
    kappas: tuple[float, ...]
    edges: Array
    times: Array

    @classmethod
    def of(cls, laws: Iterable[tuple[float, float]]) -> "NumericEnvelope":
        """From (alpha, kappa) pairs; zero strengths are dropped.  InputError for negative or infinite strengths."""
        return cls.of_weights((a - 1, k) for a, k in laws)

    @classmethod
    def of_weights(cls, laws: Iterable[tuple[float, float]]) -> "NumericEnvelope":
        """The same from (alpha - 1, kappa): of an alpha next to 1 a double would keep few digits of the difference."""
        pairs = sorted((float(w), float(k)) for w, k in laws)
        for _, kappa in pairs:
            if not 0 <= kappa < np.inf:
                raise InputError("kappa", f"{kappa} is not a strength", "finite numbers >= 0")
        active = [(w, k) for w, k in pairs if k > 0]
        if not active:
            raise InputError("law", "every strength is zero: the amplitude is constant", "at least one kappa > 0")
        weights, kappas = tuple(w for w, _ in active), tuple(k for _, k in active)
        return cls(weights, kappas, *_table(weights, kappas))

    @property
    def extinction_time(self) -> float | None:
        """tau where A reaches 0, for a least exponent below 1; None otherwise."""
        below = -self.weights[0]
        if below <= 0:
            return None
        if len(self.weights) == 1:
            return 1 / (below * self.kappas[0])
        # Behind the table the least exponent rules alone: the rest is its integral to infinity.
        return float(self.times[-1]) + float(np.exp(-below * self.edges[-1])) / (below * self.kappas[0])

    def roundings(self, A: float) -> float:
        """How often a time is rounded on the way down to A: half a last place for each panel of a sum, and a few."""
        panels = 0 if len(self.weights) == 1 else int(np.searchsorted(self.edges, -np.log(A))) + 1
        return 8 + panels / 2

    def amplitude(self, tau: ArrayLike) -> Array:
        """A at an array of times >= 0 (any shape), 0 from the extinction time on; InputError for a negative time."""
        t = np.asarray(tau, dtype=float)
        with np.errstate(invalid="ignore"):
            return np.where(np.isnan(t), np.nan, np.exp(-self.log_decay(t)))

    def log_decay(self, tau: ArrayLike) -> Array:
        """s = -ln A at an array of times >= 0, infinite from the extinction time on."""
        t = np.asarray(tau, dtype=float)
        if np.any(t < 0):
            raise InputError("time", "a time is negative", "times from the start on")
        if len(self.weights) > 1:
            return self._from_table(t)
        exponent, kappa = self.weights[0], self.kappas[0]
        if exponent == 0:
            return kappa * t
        # From the extinction on log1p(-1)/exponent is infinity (the
        # exponent is negative): A = 0, as the averaged law has it.
        growth = np.maximum(exponent * kappa * t, -1.0)
        with np.errstate(divide="ignore"):
            return np.asarray(np.log1p(growth) / exponent)

    def time(self, A: ArrayLike) -> Array:
        """tau at an array of amplitudes in (0, 1]; InputError for others (NaN stays)."""
        a = np.asarray(A, dtype=float)
        if np.any((a <= 0) | (a > 1)):
            raise InputError("amplitude", "an amplitude is not in (0, 1]", "0 < A <= 1, in units of x0")
        s = -np.log(a)
        if len(self.weights) == 1:
            exponent = self.weights[0]
            return np.asarray((np.expm1(exponent * s) / exponent if exponent else s) / self.kappas[0])
        known = np.where(np.isnan(s), 0.0, s)
        if np.any(known > self.edges[-1]):
            raise InputError("amplitude", "an amplitude is too small for double precision", f"ln A >= -{LAST_S}")
        panel = self._panel_of(self.edges, known)
        value = self.times[panel] + self._piece(self.edges[panel], known)
        return np.where(np.isnan(s), np.nan, value)

    def _from_table(self, t: Array) -> Array:
        inside = np.where(np.isnan(t), 0.0, np.minimum(t, self.times[-1]))
        panel = self._panel_of(self.times, inside)
        left, width = self.edges[panel], self.edges[1]
        # Inside a panel the rate changes by e^(1/4) at most, so that the chord is off by some per cent of it and three
        # steps of Newton's method, each of which squares the error, end within a double.
        s = left + width * (inside - self.times[panel]) / (self.times[panel + 1] - self.times[panel])
        for _ in range(3):
            s = s + (inside - self.times[panel] - self._piece(left, s)) * self._rate(s)
        return np.where(np.isnan(t), np.nan, np.where(t > self.times[-1], np.inf, s))

    def _panel_of(self, table: Array, values: Array) -> Any:
        return np.clip(np.searchsorted(table, values, side="right") - 1, 0, len(table) - 2)

    def _rate(self, s: Array) -> Array:
        total = np.zeros_like(s)
        for w, k in zip(self.weights, self.kappas):
            total = total + k * np.exp(-w * s)
        return total

    def _piece(self, left: Array, right: Array) -> Array:
        """int_left^right ds/g by Gauss-Legendre, elementwise."""
        nodes, weights = np.polynomial.legendre.leggauss(NODES)
        half = (right - left) / 2
        total = np.zeros_like(half)
        for x, w in zip(nodes, weights):
            total = total + w / self._rate(left + half * (1 + x))
        return half * total


def _table(weights: tuple[float, ...], kappas: tuple[float, ...]) -> tuple[Array, Array]:
    """Panel edges in s and tau there, as far as tau is finite; a trivial table for one law."""
    if len(weights) == 1:
        return np.zeros(1), np.zeros(1)
    width = 0.25 / max(1.0, *(abs(w) for w in weights))
    edges: Array = np.asarray(np.arange(int(LAST_S / width) + 1) * width, dtype=np.float64)
    bare = NumericEnvelope(weights, kappas, edges, edges)
    with np.errstate(over="ignore", divide="ignore", under="ignore"):
        sums = np.concatenate([[0.0], np.cumsum(bare._piece(edges[:-1], edges[1:]))])
        # What comes after an infinite entry has left the doubles.
        times: Array = np.asarray(sums[np.isfinite(sums)], dtype=np.float64)
    # Toward an extinction the panels end by adding nothing to tau in doubles: a bisection needs a table that grows.
    stuck = np.flatnonzero(np.diff(times) <= 0)
    last = int(stuck[0]) + 1 if len(stuck) else len(times)
    return edges[:last], times[:last]
