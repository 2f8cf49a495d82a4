"""The half-swing of a pendulum with losses: x'' + sin x + sum_i epsilon_i x'|x'|^(alpha_i - 1) = 0, at any amplitude.

With the well coordinate q = 2 sin(x/2) = r cos(theta) and the velocity x' = -r sin(theta) the spring is exact:

    dy/dtheta = -s m,   dtau/dtheta = (1 + c m)/g,   m = N/(g - c N),   g = sqrt(1 - k^2 c^2 e^(2y)),   k = sin(A/2),

r = 2 sin(A/2) e^y, N as for a linear spring (``coefficients``).  Without losses y = 0 and the half-swing lasts 2 K(k).
The series in the local strengths has coefficients that depend on k: they are interpolated in u = -ln(1 - k^2) at
Chebyshev points, where they are smooth up to the top of the circle.

>>> from asymptotics.decays.identification.forward.coefficients import loss
>>> swing = PendulumHalfSwing((loss(1.0),), amplitude=1.5)
>>> value = swing.at(np.array([0.0]), np.array([0.0]))
>>> from scipy.special import ellipk
>>> bool(abs(value.of("T")[0] - 2 * ellipk(np.sin(0.75) ** 2)) < 1e-9)
True
"""

from collections.abc import Sequence

import numpy as np
from numpy.polynomial import chebyshev

from asymptotics.decays.identification.forward.blocks import product
from asymptotics.decays.identification.forward.coefficients import (
    Array,
    Element,
    forced,
    graded_product,
    keys_of,
    shape,
)
from asymptotics.decays.identification.forward.grids import sinc_grid
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.forward.swing import (
    QUANTITIES,
    HalfSwingArrays,
    HalfSwingModel,
    chebyshev_angles,
    interpolation,
)
from asymptotics.numbers.context import lru_cache

Powers = np.ndarray[tuple[int, int], np.dtype[np.intp]]
HIGHEST = 3.1
"""The largest amplitude, in rad: 177.6 degrees."""
_NODES, _ROOM = 22, 1.3
"""Places of the amplitude at which the coefficients are made, and how far beyond the first amplitude the table goes, in
u, for a fit may begin with a larger one."""
_ORDERS = {1: 8, 2: 6, 3: 5}
"""By the number of losses, lower than beside a linear spring: each coefficient is a function of the amplitude here."""


class PendulumHalfSwing(HalfSwingModel):
    """The half-swing at amplitudes A with 2 sin(A/2) = 2 sin(amplitude/2) e^a; ``amplitude``, and the ``largest`` that
    there may be, in rad."""

    def __init__(
        self, elements: Sequence[Element], amplitude: float, *, largest: float = 0.0, coarse: bool = False
    ) -> None:
        super().__init__(elements, coarse=coarse)
        # With four losses and more the order is 4.
        self.order = _ORDERS.get(len(self.elements), 4)
        self.k2 = float(np.sin(min(amplitude, HIGHEST) / 2) ** 2)
        # Three digits, so that near amplitudes share one table of the cache; 0.02 keeps the interval of u from
        # vanishing at small angles.
        far = np.sin(min(max(amplitude, largest), HIGHEST) / 2) ** 2
        self.top = float(f"{min(max(_ROOM * -np.log1p(-far), 0.02), -np.log(np.cos(HIGHEST / 2) ** 2)):.3g}")
        self._series = _interpolated(self.elements, self.order, self.top)
        self._slopes = chebyshev.chebder(self._series) * 2 / self.top
        # Set by each evaluation; before the first nothing is known of what is neglected.
        self._last = float("inf")

    def period_ratio(self, a: Array) -> Array:
        """The half-swing without losses, in units of pi."""
        u = -np.log1p(-np.minimum(self.k2 * np.exp(2 * a), np.sin(HIGHEST / 2) ** 2))
        return np.asarray(chebyshev.chebval(2 * u / self.top - 1, self._series[:, 1, 0]) / np.pi)

    def at(self, a: Array, parameters: Array) -> HalfSwingArrays:
        """As ``HalfSwingModel.at``; TooStrongError over the top, and where the series does not reach."""
        k2 = self.k2 * np.exp(2 * np.clip(a, -50, 50))
        if not (k2 < np.sin(HIGHEST / 2) ** 2).all():
            raise TooStrongError("the pendulum goes over the top")
        # k^2 goes with e^(2a), so that du/da = 2 k^2/(1 - k^2).
        u, v = -np.log1p(-k2), 2 * k2 / (1 - k2)
        # An extrapolated Chebyshev series is worthless a little beyond its interval; a thousandth is harmless.
        if u.max() > 1.001 * self.top:
            raise TooStrongError("the amplitude leaves the table")
        weights = np.array([e.weight for e in self.elements])
        delta = parameters[:, None] * np.exp(np.clip(weights[:, None] * a, -50, 50))
        keys = _all_keys(len(self.elements), self.order)
        powers = np.cumprod(np.broadcast_to(delta[:, None], (len(delta), self.order, len(a))), axis=1)
        table: Array = np.concatenate([np.ones_like(delta)[:, None], powers], axis=1)
        monomials = np.prod([table[i, keys[:, i]] for i in range(len(delta))], axis=0)
        basis = chebyshev.chebvander(2 * u / self.top - 1, _NODES - 1).T
        C = np.einsum("cqk,cn->qkn", self._series, basis)
        by_u = np.einsum("cqk,cn->qkn", self._slopes, basis[:-1])
        last = keys.sum(axis=1) == self.order
        beyond = np.abs(C[:, last] * monomials[last]).sum(axis=1).max(axis=0)
        # Written so that nan is wild too.
        wild = ~(beyond < self.tolerance)
        self._last = float(beyond[~wild].max(initial=0.0))
        by_delta = np.stack([(C * _lowered(keys, table, i)).sum(axis=1) for i in range(len(delta))])
        # The amplitude enters through the coefficients and through every local strength.
        by_a = (by_u * monomials).sum(axis=1) * v + ((weights[:, None] * delta)[:, None] * by_delta).sum(axis=0)
        scale = np.exp(np.clip(weights[:, None] * a, -50, 50))
        found = HalfSwingArrays((C * monomials).sum(axis=1), by_a, by_delta * scale[:, None])
        return self.integrate(found, wild, a, parameters, self.k2)

    def neglected(self, a: Array, parameters: Array) -> float:
        """The last degree of the series, at the swing where it is largest, times their number."""
        self.at(a, parameters)
        return self._last * len(a)


def _lowered(keys: Powers, table: Array, i: int) -> Array:
    """The derivatives of the monomials by the strength i."""
    # A monomial without this strength has the factor 0; its power is then any.
    place = np.maximum(keys[:, i] - 1, 0)
    rest: list[Array] = [table[j, keys[:, j]] for j in range(len(table)) if j != i]
    return np.asarray(keys[:, i, None] * table[i, place] * (np.prod(rest, axis=0) if rest else 1.0))


@lru_cache(maxsize=16)
def _all_keys(count: int, order: int) -> Powers:
    return np.array([k for d in range(order + 1) for k in keys_of(count, d)], dtype=np.intp)


@lru_cache(maxsize=64)
def _interpolated(elements: tuple[Element, ...], order: int, top: float) -> Array:
    """Chebyshev coefficients in u of L, T, R, T_q: an array (nodes, quantities, keys)."""
    # k^2 = 1 - e^(-u) at the Chebyshev points of u.
    k2 = -np.expm1(-(np.cos(chebyshev_angles(_NODES)) + 1) / 2 * top)
    return np.asarray(np.einsum("cr,qrk->cqk", interpolation(_NODES), _coefficients(elements, order, k2)))


def _coefficients(elements: tuple[Element, ...], order: int, k2: Array) -> Array:
    """L, T, R, T_q by degree in the local strengths: an array (quantities, k2, keys)."""
    grid, count = sinc_grid(), len(elements)
    c, s = grid.cosine, grid.sine
    blank = np.zeros((1, len(k2), len(c)))
    y, m, n, E = [blank], [blank], [blank], [np.ones_like(blank)]
    g = [blank + np.sqrt(1 - k2[:, None] * c**2)]
    h = [1 / g[0]]
    strength = [[blank + shape(e, grid, e.velocity)] for e in elements]
    for d in range(1, order + 1):

        def sums(left: list[Array], right: list[Array], first: int, last: int, d: int = d) -> Array:
            parts = [graded_product(count, left, right, j, d - j) for j in range(first, last + 1)]
            return np.asarray(sum(parts)) if parts else np.zeros((1, 1, 1))

        n.append(forced(count, strength, d))
        # (g - c N) m = N by degrees: g_0, which does not vanish below the top, stands alone on the left.
        m.append((n[d] + c * sums(n, m, 1, d - 1) - sums(g, m, 1, d - 1)) / g[0])
        y.append(product(-m[d] * s, grid.cumulative.T))
        # E = e^(2y), by its logarithmic derivative in the degree.
        E.append(np.asarray(sum(j * graded_product(count, y, E, j, d - j) for j in range(1, d + 1)) * (2 / d)))
        # From g^2 = 1 - k^2 c^2 E.
        g.append((-k2[:, None] * c**2 * E[d] - sums(g, g, 1, d - 1)) / (2 * g[0]))
        # The clock: g h = 1 + c m.
        h.append((c * m[d] - sums(g, h, 1, d)) / g[0])
        if d < order:
            for known, e in zip(strength, elements):
                rate = sum(j * graded_product(count, y, known, j, d - j) for j in range(1, d + 1))
                known.append(np.asarray(rate * (e.weight / d)))
    radius, clock = -np.concatenate(m) * s, np.concatenate(h)
    found = [radius @ grid.weights, clock @ grid.weights, radius @ grid.middle, clock @ grid.middle]
    assert len(found) == len(QUANTITIES)
    return np.stack([part.T for part in found])


def well(x: Array | float, size: float) -> Array:
    """q = 2 sin(x/2) of an angle, both in units of ``size`` rad."""
    return np.asarray(2 / size * np.sin(size * np.asarray(x) / 2))


def angle(q: Array, size: float) -> tuple[Array, Array]:
    """The angle with this well coordinate, and its derivative; both in units of ``size`` rad."""
    sine = np.clip(size * q / 2, -1, 1)
    # At the top the derivative is infinite; 1e-12 keeps a step of the search finite.
    return 2 / size * np.arcsin(sine), 1 / np.sqrt(np.maximum(1 - sine**2, 1e-12))
