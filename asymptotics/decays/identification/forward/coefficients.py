"""The half-swing series in doubles, for any sum of losses and springs: values on a grid, spectrally integrated.

With X = r cos(theta), X' = -r sin(theta), s = sin(theta), c = cos(theta), y = ln r, the motion between two turning
points 0 <= theta <= pi obeys

    dy/dtheta = -s m,   dtau/dtheta = 1 + c m,   m = N + c N m,   N = sum_i delta_i f_i(theta) exp(w_i y),

where a loss |x|^p v|v|^(q-1) has f = |c|^p s^q and a spring x|x|^(p-1)|v|^q has f = -c|c|^(p-1) s^q, and w = p + q - 1.
Each degree in the local strengths delta_i needs lower degrees only.  Here every function of theta is its values on two
double-exponential sinc grids, one for each quarter-swing: fractional powers of s at the turning points and kinks of |c|
at the passage stand at the ends of a grid, where this quadrature does not see them.  No reversal identity is used, so
the certified series of the package (balls, first quarter only) are an independent route to the same numbers; the tests
compare them.  These doubles serve identification only: nothing here is a certificate.

>>> swing = swing_coefficients((loss(1.5),), 2)
>>> swing.keys[1:], float(swing.L[0, 1])                        # L = -pi M_(5/2) delta + ...
(((1,), (2,)), -1.43776828168...)
>>> float(swing_coefficients((loss(2.0),), 2).T[0, 2])        # pi/6
0.523598775...
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from asymptotics.decays.identification.forward.blocks import product
from asymptotics.decays.identification.forward.grids import ThetaGrid, sinc_grid
from asymptotics.numbers.context import cache, lru_cache
from asymptotics.series import Key, monomials

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Element:
    """A term of the force: a loss |x|^position v|v|^(velocity-1) or a spring x|x|^(position-1) |v|^velocity."""

    kind: str
    velocity: float
    position: int = 0

    @property
    def weight(self) -> float:
        """w = degree - 1: the local strength is delta = epsilon A^w."""
        return self.velocity + self.position - 1


def loss(alpha: float, position: int = 0) -> Element:
    """The loss |x|^position v|v|^(alpha-1)."""
    return Element("loss", float(alpha), position)


def spring(power: int) -> Element:
    """The restoring force x|x|^(power-1)."""
    return Element("spring", 0.0, power)


@dataclass(frozen=True)
class SwingCoefficients:
    """Coefficients of L, T (half-swing) and R, T_q (quarter-swing): arrays (alphas, keys), in the order of ``keys``."""

    weights: Array
    keys: tuple[Key, ...]
    L: Array
    T: Array
    R: Array
    T_q: Array


@lru_cache(maxsize=256)
def swing_coefficients(elements: tuple[Element, ...], order: int, alphas: tuple[float, ...] = ()) -> SwingCoefficients:
    """The series through total degree ``order``.

    With ``alphas`` the first element is a loss v|v|^(alpha-1) for each of them, and its own exponent is not used:
    ``weights`` then has one row for each alpha.
    """
    grid = sinc_grid()
    first = np.array(alphas or (elements[0].velocity,))[:, None]
    exponents: list[Array | float] = [first, *(e.velocity for e in elements[1:])]
    shapes = [shape(e, grid, velocity) for e, velocity in zip(elements, exponents)]
    weights = [np.asarray(v + e.position - 1.0) for v, e in zip(exponents, elements)]
    m = _solve(shapes, weights, order, grid)
    keys = tuple(k for d in range(order + 1) for k in keys_of(len(elements), d))
    all_m = np.concatenate(m)
    rate = all_m * grid.cosine
    quarter = grid.middle
    R, L = (_ends(-all_m * grid.sine, w) for w in (quarter, grid.weights))
    T_q, T = (_ends(rate, w) for w in (quarter, grid.weights))
    # The constant 1 of 1 + c m is not in m: its integrals are known.
    T_q[:, 0], T[:, 0] = np.pi / 2, np.pi
    # One row of weights for each exponent, also where the others have one weight for all of them.
    rows = np.broadcast_arrays(*(w.reshape(-1) for w in weights))
    return SwingCoefficients(np.stack(rows, axis=1), keys, L, T, R, T_q)


def _ends(integrand: Array, weights: Array) -> Array:
    return product(integrand, weights[:, None])[..., 0].T.copy()


def shape(element: Element, grid: ThetaGrid, velocity: Array | float) -> Array:
    """f(theta) of the module docstring on the grid, for one exponent or a column of exponents."""
    # No node stands at an end, so that the logarithm is finite, and s^0 is 1 as friction wants it.
    powers = np.exp(velocity * np.log(grid.sine)) * np.ones((1, 1))
    if element.kind == "loss":
        return np.asarray(powers * np.abs(grid.cosine) ** element.position)
    return np.asarray(-powers * grid.cosine * np.abs(grid.cosine) ** (element.position - 1))


@cache
def keys_of(variables: int, degree: int) -> tuple[Key, ...]:
    """The exponents of all monomials of a degree."""
    return tuple(monomials(variables, degree))


@cache
def _sum_indices(variables: int, left: int, right: int) -> NDArray[np.intp]:
    """Where key_i + key_j stands among the keys of degree left + right."""
    place = {k: i for i, k in enumerate(keys_of(variables, left + right))}
    rows = [
        [place[tuple(p + q for p, q in zip(a, b))] for b in keys_of(variables, right)] for a in keys_of(variables, left)
    ]
    return np.array(rows, dtype=np.intp)


def graded_product(variables: int, left: list[Array], right: list[Array], i: int, j: int) -> Array:
    """Degree i of ``left`` times degree j of ``right``: arrays (keys, alphas, nodes)."""
    a, b, places = left[i], right[j], _sum_indices(variables, i, j)
    # The loop runs over the shorter factor; monomials of one degree are distinct sums, so that += hits each place once.
    if len(a) > len(b):
        a, b, places = b, a, places.T
    total = np.zeros((len(keys_of(variables, i + j)), *np.broadcast_shapes(a.shape[1:], b.shape[1:])))
    for row, place in zip(a, places):
        total[place] += row * b
    return total


def _solve(shapes: list[Array], weights: list[Array], order: int, grid: ThetaGrid) -> list[Array]:
    """m by degree, each an array (keys, alphas, nodes)."""
    count = len(shapes)
    blank = np.zeros((1, *np.broadcast_shapes(*(s.shape for s in shapes))))
    y, m, n = [blank], [blank], [blank]
    strength = [[blank + s] for s in shapes]
    for d in range(1, order + 1):
        n.append(forced(count, strength, d))
        # m = N + c N m in degree d; N begins with degree 1, so that lower degrees of m are enough.
        m.append(n[d] + sum(graded_product(count, n, m, j, d - j) for j in range(1, d)) * grid.cosine)
        y.append(product(-m[d] * grid.sine, grid.cumulative.T))
        if d < order:
            for known, weight in zip(strength, weights):
                # exp(w y) by its logarithmic derivative in the degree: d E_d = w sum_j j y_j E_(d-j).
                known.append(sum(j * graded_product(count, y, known, j, d - j) for j in range(1, d + 1)) * (weight / d))
    return m


def forced(count: int, strength: list[list[Array]], d: int) -> Array:
    """N in degree d: sum_i delta_i (f_i exp(w_i y)) in degree d - 1."""
    total = np.zeros((len(keys_of(count, d)), *strength[0][d - 1].shape[1:]))
    places = _sum_indices(count, 1, d - 1)
    units = {k.index(1): i for i, k in enumerate(keys_of(count, 1))}
    for i, known in enumerate(strength):
        total[places[units[i]]] += known[d - 1]
    return total
