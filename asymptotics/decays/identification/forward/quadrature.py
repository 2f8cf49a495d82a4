"""Half-swings too strong for the series: the integral equation of the motion, iterated on the same grid in theta.

    y(theta) = -int_0^theta s m dtheta',    m = N/d,    d = g - c N,    N = sum_i delta_i f_i exp(w_i y)

is a Volterra equation, so Picard's iteration converges for every strength at which m stays bounded; the derivatives by
the amplitude, the strengths and the exponent solve the linearised equation and are iterated in the same way.  All
amplitudes run at once.  For a linear spring g = 1; for a pendulum (``pendulum``) g^2 = 1 - q, q = k^2 c^2 e^(2 y), and

    dm = (g dN + N q (da + dy)/g)/d^2,    dtau/dtheta = (1 + c m)/g,    d(dtau/dtheta) = c dm/g + q (da + dy)/(g^2 d).
"""

from collections.abc import Sequence

import numpy as np

from asymptotics.decays.identification.forward.blocks import product
from asymptotics.decays.identification.forward.coefficients import Array, Element, ThetaGrid, shape, theta_grid

_ITERATIONS = 80
"""Picard's error falls like a^k/k!, where a is the size of the kernel: 80 suffice unless the motion is about to stick,
and then it is refused like one that does."""
_CLOSE, _CLOSE_SLOPES = 1e-12, 1e-9
"""Changes at which the iterations stop: that of the values is the error of the grid; slopes only steer a fit."""
_LEAST = 0.01
"""The part of the spring's force that the losses must leave: near 0 the mass sticks, and the grid no longer serves."""


class TooStrongError(ArithmeticError):
    """There is no turning point on the other side: the mass sticks, creeps, escapes, or the parameters are wild."""


@np.errstate(over="ignore", invalid="ignore")  # a step of the search may leave the doubles: no swing there
def integrated_swings(
    elements: Sequence[Element], a: Array, strengths: Array, alpha: float | None, k2: float = 0.0
) -> tuple[Array, Array, Array]:
    """(values, d/da, d/dparameters) as in ``swing.HalfSwingArrays`` at a = ln A; TooStrongError if the iteration fails.

    ``k2``: k^2 of a pendulum at a = 0, or 0 for a linear spring.
    """
    grid = theta_grid()
    velocity = [e.velocity for e in elements]
    if alpha is not None:
        velocity[0] = alpha
    shapes = np.concatenate([shape(e, grid, v) for e, v in zip(elements, velocity)])
    weights = np.array([v + e.position - 1 for v, e in zip(velocity, elements)])
    # A step of a search may lead anywhere; e^50 is refused below as too strong, where infinities would be nan.
    local = np.exp(np.clip(weights[:, None] * a, -50, 50))
    forces = (strengths[:, None] * local)[:, :, None] * shapes[:, None, :]
    squares = k2 * np.exp(2 * a)[:, None] * grid.cosine**2 if k2 else None
    y = _log_radius(forces, weights, squares, grid)
    powers = np.exp(weights[:, None, None] * y)
    n = (forces * powers).sum(axis=0)
    q, g = _root(squares, y)
    d = g - grid.cosine * n
    m, gain = n / d, g / d**2  # dm = gain (dN + N q (da + dy)/g^2)
    units = local[:, :, None] * shapes[:, None, :] * powers
    # The derivative of N by y at fixed amplitude, and the pendulum's part, which a and y enter in the same way.
    by_y = (weights[:, None, None] * forces * powers).sum(axis=0) + n * q / g**2
    sources = [by_y, *units]
    if alpha is not None:
        # w = A e^y s is the speed: d(w^alpha)/d alpha brings its logarithm, here of the local one.
        sources.append(forces[0] * powers[0] * (np.log(grid.sine) + y + a[:, None]))
    values = _ends(m, (grid.cosine * m + (1 - g)) / g, grid)
    # The clock without loss; what is integrated is the difference, which is small.
    values[[1, 3]] += [[np.pi], [np.pi / 2]]
    slopes = []
    for da, source in zip((1, *[0] * len(sources)), sources):  # the first source is that of the amplitude
        dy, dm = _linearised(by_y, gain, source, grid)
        slopes.append(_ends(dm, grid.cosine * dm / g + q * (da + dy) / (g**2 * d), grid))
    return values, slopes[0], np.stack(slopes[1:])


def _root(squares: Array | None, y: Array) -> tuple[Array | float, Array | float]:
    """q and g = sqrt(1 - q) at y."""
    if squares is None:
        return 0.0, 1.0
    q = squares * np.exp(2 * y)
    return q, np.sqrt(1 - q)


def _log_radius(forces: Array, weights: Array, squares: Array | None, grid: ThetaGrid) -> Array:
    y = np.zeros(forces.shape[1:])
    for _ in range(_ITERATIONS):
        # Only iterates that diverge meet the clip.
        n = (forces * np.exp(np.clip(weights[:, None, None] * y, -30, 30))).sum(axis=0)
        g = _root(squares, y)[1]
        d = g - grid.cosine * n
        # Here the equation has no solution up to pi, or the iterate has left its neighbourhood: refused either way.
        if not (d > _LEAST * g).all():
            break
        known, y = y, product(-grid.sine * n / d, grid.cumulative.T)
        if not np.isfinite(y).all():
            break
        if np.abs(y - known).max() < _CLOSE:
            return y
    raise TooStrongError("no turning point follows on the other side")


def _linearised(by_y: Array, gain: Array, source: Array, grid: ThetaGrid) -> tuple[Array, Array]:
    """dy and dm: dy = -int s dm, dm = gain (by_y dy + source)."""
    z = np.zeros_like(by_y)
    for _ in range(_ITERATIONS):
        known, z = z, product(-grid.sine * gain * (by_y * z + source), grid.cumulative.T)
        # Linear in z: it converges for every source, and the last iterate serves if 80 should not do.
        if np.abs(z - known).max() <= _CLOSE_SLOPES * (1 + np.abs(z).max()):
            break
    return z, gain * (by_y * z + source)


def _ends(m: Array, rate: Array, grid: ThetaGrid) -> Array:
    """L, T, R, T_q from m and the rate of the clock (or their derivatives from those)."""
    loss = -grid.sine * m
    return np.stack([loss @ grid.weights, rate @ grid.weights, loss @ grid.middle, rate @ grid.middle])
