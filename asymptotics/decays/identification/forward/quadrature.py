"""Half-swings too strong for the series: the integral equation of the motion, solved on a grid in theta.

    y(theta) = -int_0^theta s m dtheta',    m = N/d,    d = g - c N,    N = sum_i delta_i f_i exp(w_i y)

is an ordinary equation of first order.  Newton's iteration has linear ones to solve, z' = p (z + r), and these have
the solution z = e^P int e^(-P) p r, P = int p: a few products with the matrix of the integrals for all swings at once.
The derivatives by the amplitude, the strengths and the exponent solve linear equations with the last p.  For a linear
spring g = 1; for a pendulum (``pendulum``) g^2 = 1 - q, q = k^2 c^2 e^(2 y), and

    dm = (g dN + N q (da + dy)/g)/d^2,    dtau/dtheta = (1 + c m)/g,    d(dtau/dtheta) = c dm/g + q (da + dy)/(g^2 d).

Forces with whole exponents are smooth on each quarter: where few digits are asked for, Gauss's nodes serve.  Their
integrals are right to about the square of the highest coefficients of what is integrated; where ten times that is more
than is allowed, and for all other forces, the sinc grid of the series does.  Measured against that grid (3300 swings,
sums of whole exponents, tolerance 1e-7): values to 2.4e-8, slopes to 1.3e-6.

>>> from asymptotics.decays.identification.forward.coefficients import loss
>>> for tolerance in (0.0, PRECISE):
...     values, by_amplitude, _ = integrated_swings((loss(1.0),), np.zeros(1), np.array([0.1]), None, 0.0, tolerance)
...     print(bool(abs(values[0, 0] + np.pi * 0.05 / np.sqrt(1 - 0.05**2)) < 1e-13), float(by_amplitude[0, 0]))
True 0.0
True 0.0
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from asymptotics.decays.identification.forward.blocks import product
from asymptotics.decays.identification.forward.coefficients import Array, Element, shape
from asymptotics.decays.identification.forward.grids import ThetaGrid, gauss_grid, sinc_grid
from asymptotics.decays.identification.forward.work import counted

PRECISE = 1e-7
"""The tolerance from which on Gauss's nodes serve."""
_ITERATIONS = 8
"""Newton's iteration doubles the digits: of 5000 swings 90 % took two or three.  Where eight do not suffice, the motion
is about to stick: of dry friction a swing whose next amplitude is below 0.2 to 0.3 % of this one is refused."""
_CLOSE = 1e-6
"""The last change of y: the next would be its square."""
_LEAST = 0.01
"""The part of the spring's force that the losses must leave: near 0 the mass sticks, and the grid no longer serves."""
_FAR = 30.0
"""Beyond e^30 and e^-30 there is no radius; only iterates that diverge meet it."""


class TooStrongError(ArithmeticError):
    """There is no turning point on the other side: the mass sticks, creeps, escapes, or the parameters are wild."""


def is_smooth(elements: Sequence[Element]) -> bool:
    """Whether all exponents are whole."""
    return all(float(e.velocity).is_integer() for e in elements)


Found = tuple[Array, Array, Array]
Mask = NDArray[np.bool_]


def integrated_swings(
    elements: Sequence[Element],
    a: Array,
    strengths: Array,
    alpha: float | None,
    k2: float = 0.0,
    tolerance: float = 0.0,
) -> Found:
    """(values, d/da, d/dparameters) as in ``swing.HalfSwingArrays`` at a = ln A; TooStrongError if there is none.

    ``k2``: k^2 of a pendulum at a = 0, or 0 for a linear spring; ``tolerance``: the error of the values that is
    allowed.
    """
    few = alpha is None and tolerance >= PRECISE and is_smooth(elements)
    found, good = _Swings.of(elements, a, strengths, alpha, k2, gauss_grid() if few else sinc_grid()).solved(tolerance)
    if not good.all():
        finer, _ = _Swings.of(elements, a[~good], strengths, alpha, k2, sinc_grid()).solved(tolerance)
        for part, replaced in zip(found, finer, strict=True):
            part[..., ~good] = replaced
    return found


@dataclass(frozen=True)
class _State:
    """What stands in the equations at one y: the ``units`` e^(w y) of the terms, their ``parts`` of N, and
    dm = gain (by_y dy + dN + N q da/g^2)."""

    units: Array
    parts: Array
    q: Array | float
    g: Array | float
    d: Array
    m: Array
    gain: Array
    by_y: Array
    inside: Mask


@dataclass(frozen=True)
class _Swings:
    """Half-swings from amplitudes ``a``: the forces (terms, swings, nodes), and their ``units`` by the strength."""

    grid: ThetaGrid
    a: Array
    weights: Array
    units: Array
    forces: Array
    squares: Array | None
    free: bool

    @classmethod
    def of(
        cls,
        elements: Sequence[Element],
        a: Array,
        strengths: Array,
        alpha: float | None,
        k2: float,
        grid: ThetaGrid,
    ) -> "_Swings":
        velocity = [e.velocity for e in elements]
        if alpha is not None:
            velocity[0] = alpha
        nodes, terms = len(grid.sine), len(elements)
        counted(220 + 0.04 * len(a) * nodes * (2 + terms) * (1 + nodes / 100))
        shapes = np.concatenate([shape(e, grid, v) for e, v in zip(elements, velocity)])
        weights = np.array([v + e.position - 1 for v, e in zip(velocity, elements)])
        # A step of a search may lead anywhere; e^50 is refused below as too strong, where infinities would be nan.
        local = np.exp(np.clip(weights[:, None] * a, -50, 50))
        units = local[:, :, None] * shapes[:, None, :]
        squares = k2 * np.exp(2 * a)[:, None] * grid.cosine**2 if k2 else None
        return cls(grid, a, weights, units, strengths[:, None, None] * units, squares, alpha is not None)

    @np.errstate(over="ignore", invalid="ignore", divide="ignore")  # a step of the search may leave the doubles
    def solved(self, tolerance: float) -> tuple[Found, Mask]:
        """The values and slopes, and for which swings the grid resolves them; TooStrongError if there is no swing."""
        s, c = self.grid.sine, self.grid.cosine
        y, state = self._log_radius()
        values = np.stack([-s * state.m, (c * state.m + (1 - state.g)) / state.g])
        resolved = np.all(10 * (values @ self.grid.top) ** 2 < tolerance, axis=(0, 2))
        ends = self._ends(values)
        # The clock without loss; what is integrated is the difference, which is small.
        ends[[1, 3]] += [[np.pi], [np.pi / 2]]
        sources = [state.by_y, *(self.units * state.units)]
        if self.free:
            # w = A e^y s is the speed: d(w^alpha)/d alpha brings its logarithm, here of the local one.
            sources.append(state.parts[0] * (np.log(s) + y + self.a[:, None]))
        source = np.stack(sources)
        growth = np.exp(self._integral(-s * state.gain * state.by_y))
        dy = growth * self._integral(-s * state.gain * source / growth)
        dm = state.gain * (state.by_y * dy + source)
        rate = c * dm / state.g
        if self.squares is not None:
            # The first source is that of the amplitude.
            da = np.eye(len(source), 1)[:, :, None]
            rate += state.q * (da + dy) / (state.g**2 * state.d)
        slopes = np.moveaxis(self._ends(np.stack([-s * dm, rate])), 1, 0)
        return (ends, slopes[0], slopes[1:]), np.asarray(resolved)

    def _log_radius(self) -> tuple[Array, _State]:
        """y and the state there; TooStrongError where the iteration does not end inside the domain.

        The equation is continued past d = least g, with d as it is there: a solution that stays inside is that of both,
        and iterates may be outside for a while.  At first ``least`` is large, so that they are not led far."""
        s = self.grid.sine
        y = np.maximum(-self._integral(s * self.forces.sum(axis=0)), -1.0)
        for k in range(_ITERATIONS):
            state = self._at(y, max(_LEAST, 0.5 ** (k + 1)))
            p, next_y = -s * state.gain * state.by_y, self._integral(-s * state.m)
            growth = np.exp(self._integral(p))
            before, y = y, np.clip(next_y + growth * self._integral(p * (next_y - y) / growth), -_FAR, _FAR)
            if not np.isfinite(y).all():
                break
            # A swing outside is not done: its domain grows.
            if np.abs(y - before).max() < _CLOSE and state.inside.all():
                return y, self._at(y, _LEAST)
        raise TooStrongError("no turning point follows on the other side")

    def _at(self, y: Array, least: float) -> _State:
        units = np.exp(self.weights[:, None, None] * y)
        parts = self.forces * units
        n = parts.sum(axis=0)
        by_y = (self.weights[:, None, None] * parts).sum(axis=0)
        q: Array | float = 0.0
        g: Array | float = 1.0
        if self.squares is not None:
            q = self.squares * np.exp(2 * y)
            g = np.sqrt(np.maximum(1 - q, _LEAST**2))
            # The derivative of N by y at fixed amplitude, and the pendulum's part, which a and y enter in the same way.
            by_y += n * q / g**2
        d = g - self.grid.cosine * n
        inside = d > least * g
        d = np.maximum(d, least * g)
        gain = np.where(inside, g / d**2, 1 / d)
        return _State(units, parts, q, g, d, n / d, gain, by_y, inside)

    def _integral(self, rate: Array) -> Array:
        """The integral from 0 to each node."""
        return product(rate, self.grid.cumulative.T)

    def _ends(self, rates: Array) -> Array:
        """L, T, R, T_q from the rates of loss and clock: an array (four, ..., swings)."""
        ends = product(rates, np.stack([self.grid.weights, self.grid.middle], axis=1))
        return np.concatenate([ends[..., 0], ends[..., 1]])
