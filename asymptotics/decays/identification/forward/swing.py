"""One half-swing at many amplitudes at once: L, T, R, T_q and their exact derivatives, in doubles.

Amplitudes enter as a = ln(A/A_ref), strengths as s_i = epsilon_i A_ref^(w_i), so that the local strengths are
delta_i = s_i exp(w_i a).  Where they are small the series of ``coefficients`` is summed (one matrix product for all
values and derivatives); where its last degree still matters the half-swing is integrated (``quadrature``).  A free
exponent interpolates the coefficients in alpha at Chebyshev points of [0, 5].

>>> from asymptotics.decays.identification.forward.coefficients import loss
>>> swing = HalfSwingModel((loss(1.0),))
>>> value = swing.at(np.array([0.0]), np.array([0.1]))
>>> float(value.of("L")[0])                                    # -pi (epsilon/2)/sqrt(1 - epsilon^2/4), epsilon = 0.1
-0.157276...
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from asymptotics.decays.identification.forward.blocks import product
from asymptotics.decays.identification.forward.coefficients import (
    Array,
    Element,
    SwingCoefficients,
    swing_coefficients,
)
from asymptotics.decays.identification.forward.quadrature import TooStrongError, integrated_swings
from asymptotics.decays.identification.forward.work import counted
from asymptotics.numbers.context import lru_cache

Mask = NDArray[np.bool_]
QUANTITIES = ("L", "T", "R", "T_q")
MAX_FREE_ALPHA = 5.0
"""A choice: a free exponent is sought up to here, and the answers say so; a larger one can be named as a law."""
_ALPHA_NODES = 28
"""Places of a free exponent in [0, 5]: the coefficients are smooth in it, and are made once for all of them.  In degree
k they are singular at alpha = -2/k, where s^(k alpha + 1) has no integral, so that the high degrees are interpolated
worst.  Against tables of fixed exponents (0.3 to 4.9) they are off by 2e-11 in degree 1, 2e-8 in degree 2, 1e-6 in
degree 4."""
_ORDERS = {1: 12, 2: 10, 3: 7, 4: 6, 5: 5}
"""By the number of terms: the number of coefficients grows like order^terms and decides the cost of a fit; what a lower
order does not reach is integrated."""
TOLERANCE, COARSE = 1e-11, 3e-3
"""The largest last degree of a series that is summed; what follows it is smaller by another factor delta.  The first is
the error of the coefficients themselves; the second is that of a first look, whose law is fitted again if it may
matter."""


@dataclass(frozen=True)
class HalfSwingArrays:
    """``values``: (quantities, swings); ``by_amplitude``: d/da; ``by_parameter``: (parameters, quantities, swings).

    The parameters are the strengths s_i, then the exponent if it is free.
    """

    values: Array
    by_amplitude: Array
    by_parameter: Array

    def of(self, name: str) -> Array:
        """The values of one of L, T, R, T_q."""
        return np.asarray(self.values[QUANTITIES.index(name)])


class HalfSwingModel:
    """The half-swing of a sum of terms; ``free`` lets the exponent of the first term vary.

    ``tolerance`` decides where the series ends and the integration begins; a ``coarse`` swing never integrates: what
    its series cannot reach is out of its domain."""

    def __init__(self, elements: Sequence[Element], free: bool = False, *, coarse: bool = False) -> None:
        self.elements, self.free, self.coarse = tuple(elements), free, coarse
        self.tolerance = COARSE if coarse else TOLERANCE
        # Six terms have the order of five.
        self.order = _ORDERS[min(len(self.elements), max(_ORDERS))]

    @property
    def parameters(self) -> int:
        """How many numbers describe the law: the strengths, and the exponent if it is free."""
        return len(self.elements) + self.free

    def at(self, a: Array, parameters: Array) -> HalfSwingArrays:
        """All quantities at the amplitudes ``a``; TooStrongError where there is no next turning point on the other
        side."""
        count = len(self.elements)
        alpha = float(parameters[count]) if self.free else None
        table = _table(self.elements, self.order, alpha)
        # A step of the search may lead to any amplitude; e^50 is out of the series' reach, without an overflow.
        scale = np.exp(np.clip(table.weights[:, None] * a, -50.0, 50.0))
        delta = parameters[:count, None] * scale
        with np.errstate(over="ignore", invalid="ignore"):
            monomials = table.monomials(delta)
            found = _summed(table, a, delta, scale, monomials)
            # Written so that nan is wild too.
            wild = ~(table.top @ np.abs(monomials[table.top_keys]) < self.tolerance)
        return self.integrate(found, wild, a, parameters)

    def integrate(
        self, found: HalfSwingArrays, wild: Mask, a: Array, parameters: Array, k2: float = 0.0
    ) -> HalfSwingArrays:
        """``found`` with the half-swings that the series does not reach integrated; ``k2`` as in
        ``integrated_swings``."""
        terms, strong = len(self.elements), int(wild.sum())
        counted(50 + 0.7 * len(a) * terms)
        if not strong:
            return found
        if self.coarse:
            raise TooStrongError("the series does not reach these strengths")
        alpha = float(parameters[terms]) if self.free else None
        exact = integrated_swings(self.elements, a[wild], parameters[:terms], alpha, k2, self.tolerance)
        for part, replaced in zip((found.values, found.by_amplitude, found.by_parameter), exact, strict=True):
            part[..., wild] = replaced
        return found

    def neglected(self, a: Array, parameters: Array) -> float:
        """The last degree of the series, summed over swings from the amplitudes ``a``: what follows it is smaller."""
        count = len(self.elements)
        table = _table(self.elements, self.order, float(parameters[count]) if self.free else None)
        delta = parameters[:count, None] * np.exp(np.clip(table.weights[:, None] * a, -50.0, 50.0))
        return float((table.top @ np.abs(table.monomials(delta)[table.top_keys])).sum())


@dataclass(frozen=True)
class _Table:
    """Rows of ``matrix``: the four quantities, their derivatives by delta_i, and (if free) by alpha."""

    weights: Array
    powers: np.ndarray[tuple[int, int], np.dtype[np.intp]]
    matrix: Array
    order: int
    top: Array
    top_keys: slice

    def monomials(self, delta: Array) -> Array:
        """delta^key, an array (keys, swings)."""
        rows = np.broadcast_to(delta[:, None, :], (len(delta), self.order, delta.shape[1]))
        table = np.concatenate([np.ones_like(delta)[:, None, :], np.cumprod(rows, axis=1)], axis=1)
        found = table[0, self.powers[:, 0]]
        for i in range(1, len(delta)):
            found *= table[i, self.powers[:, i]]
        return np.asarray(found)


# The coefficients of a law are asked for at every step of its fit. With a free exponent each value has a table of its
# own; 256 of them hold a fit.
@lru_cache(maxsize=256)
def _table(elements: tuple[Element, ...], order: int, alpha: float | None) -> _Table:
    if alpha is None:
        c = swing_coefficients(elements, order)
        return _assembled(c.weights[0], c, np.stack([getattr(c, q)[0] for q in QUANTITIES]), None, order)
    nodes = _alpha_nodes()
    c = swing_coefficients(elements, order, nodes)
    basis = interpolation(len(nodes))
    series = np.stack([basis @ getattr(c, q) for q in QUANTITIES])
    u = 2 * alpha / MAX_FREE_ALPHA - 1
    series = np.moveaxis(series, 1, 0)
    values = chebyshev.chebval(u, series)
    # d/dalpha = (2/5) d/du.
    slopes = np.asarray(chebyshev.chebval(u, chebyshev.chebder(series)) * 2 / MAX_FREE_ALPHA)
    return _assembled(np.array([alpha - 1, *c.weights[0, 1:]]), c, values, slopes, order)


def _alpha_nodes() -> tuple[float, ...]:
    return tuple((np.cos(chebyshev_angles(_ALPHA_NODES)) + 1) / 2 * MAX_FREE_ALPHA)


def chebyshev_angles(count: int) -> Array:
    """The angles whose cosines are the Chebyshev points of [-1, 1]."""
    return np.asarray(np.pi * (np.arange(count) + 0.5) / count)


@lru_cache(maxsize=4)
def interpolation(count: int) -> Array:
    """From values at Chebyshev points to Chebyshev coefficients."""
    matrix = np.cos(np.arange(count)[:, None] * chebyshev_angles(count)) * 2 / count
    # The constant has half the weight of the others in a Chebyshev series.
    matrix[0] /= 2
    return np.asarray(matrix)


def _assembled(weights: Array, c: SwingCoefficients, values: Array, slopes: Array | None, order: int) -> _Table:
    keys = np.array(c.keys, dtype=np.intp)
    place = {k: i for i, k in enumerate(c.keys)}
    blocks = [values]
    for i in range(keys.shape[1]):
        derivative = np.zeros_like(values)
        for j, key in enumerate(c.keys):
            if key[i]:
                # The derivative by delta_i is a sum over the same monomials, so that one product with them gives values
                # and slopes.
                derivative[:, place[(*key[:i], key[i] - 1, *key[i + 1 :])]] = key[i] * values[:, j]
        blocks.append(derivative)
    if slopes is not None:
        blocks.append(slopes)
    degrees = keys.sum(axis=1)
    top = slice(int(np.argmax(degrees == order)), len(keys))
    return _Table(weights, keys, np.concatenate(blocks), order, np.abs(values[:, top]).max(axis=0), top)


def _summed(table: _Table, a: Array, delta: Array, scale: Array, monomials: Array) -> HalfSwingArrays:
    count, q = len(delta), len(QUANTITIES)
    # delta_i = s_i e^(w_i a): by a through every strength, by s_i through its own.
    rows = product(monomials.T, table.matrix.T).T.reshape(-1, q, len(a))
    by_delta = rows[1 : count + 1]
    by_amplitude = ((table.weights[:, None] * delta)[:, None, :] * by_delta).sum(axis=0)
    by_strength = by_delta * scale[:, None, :]
    if len(rows) > count + 1:
        # The exponent enters through the coefficients, and through delta_0 = s_0 e^((alpha - 1) a).
        by_alpha = rows[count + 1] + by_delta[0] * (delta[0] * a)
        return HalfSwingArrays(rows[0], by_amplitude, np.concatenate([by_strength, by_alpha[None]]))
    return HalfSwingArrays(rows[0], by_amplitude, by_strength)
