"""Half-swings too strong for the series: the integral equation of the motion, iterated on the same grid in theta.

    y(theta) = -int_0^theta s m dtheta',    m = N/(1 - c N),    N = sum_i delta_i f_i exp(w_i y)

is a Volterra equation, so Picard's iteration converges for every strength at which m stays bounded; the derivatives by
the amplitude, the strengths and the exponent solve the linearised equation and are iterated in the same way.  All
amplitudes run at once.
"""

from collections.abc import Sequence

import numpy as np

from asymptotics.identification.forward.coefficients import Array, Element, ThetaGrid, product, shape, theta_grid

_ITERATIONS = 60
_CLOSE, _CLOSE_SLOPES = 1e-12, 1e-9


class TooStrongError(ArithmeticError):
    """There is no turning point on the other side: the mass sticks, creeps, escapes, or the parameters are wild."""


def integrated_swings(
    elements: Sequence[Element], a: Array, strengths: Array, alpha: float | None
) -> tuple[Array, Array, Array]:
    """(values, d/da, d/dparameters) as in ``swing.SwingValues`` at a = ln A; TooStrongError if the iteration fails."""
    grid = theta_grid()
    velocity = [e.velocity for e in elements]
    if alpha is not None:
        velocity[0] = alpha
    shapes = np.concatenate([shape(e, grid, v) for e, v in zip(elements, velocity)])
    weights = np.array([v + e.position - 1 for v, e in zip(velocity, elements)])
    local = np.exp(np.clip(weights[:, None] * a, -50, 50))
    forces = (strengths[:, None] * local)[:, :, None] * shapes[:, None, :]
    y = _log_radius(forces, weights, grid)
    powers = np.exp(weights[:, None, None] * y)
    n = (forces * powers).sum(axis=0)
    d = 1 - grid.cosine * n
    m, gain = n / d, 1 / d**2  # dm = gain dN
    units = local[:, :, None] * shapes[:, None, :] * powers
    by_y = (weights[:, None, None] * forces * powers).sum(axis=0)
    sources = [by_y, *units]
    if alpha is not None:
        sources.append(forces[0] * powers[0] * (np.log(grid.sine) + y + a[:, None]))
    derivatives = np.stack([_linearised(by_y, gain, source, grid) for source in sources])
    values = _ends(m, grid, constants=True)
    slopes = np.stack([_ends(x, grid, constants=False) for x in derivatives])
    return values, slopes[0], slopes[1:]


def _log_radius(forces: Array, weights: Array, grid: ThetaGrid) -> Array:
    y = np.zeros(forces.shape[1:])
    for _ in range(_ITERATIONS):
        n = (forces * np.exp(np.clip(weights[:, None, None] * y, -30, 30))).sum(axis=0)
        d = 1 - grid.cosine * n
        if not (d > 0.01).all():
            break
        known, y = y, product(-grid.sine * n / d, grid.cumulative.T)
        if not np.isfinite(y).all():
            break
        if np.abs(y - known).max() < _CLOSE:
            return y
    raise TooStrongError("no turning point follows on the other side")


def _linearised(by_y: Array, gain: Array, source: Array, grid: ThetaGrid) -> Array:
    """dm for z = dy, z = -int s dm, dm = gain (by_y z + source)."""
    z = np.zeros_like(by_y)
    for _ in range(_ITERATIONS):
        known, z = z, product(-grid.sine * gain * (by_y * z + source), grid.cumulative.T)
        if np.abs(z - known).max() <= _CLOSE_SLOPES * (1 + np.abs(z).max()):
            break
    return gain * (by_y * z + source)


def _ends(m: Array, grid: ThetaGrid, *, constants: bool) -> Array:
    """L, T, R, T_q from m (or their derivatives from dm)."""
    loss, rate = -grid.sine * m, grid.cosine * m
    rows = [loss @ grid.weights, rate @ grid.weights, loss @ grid.middle, rate @ grid.middle]
    if constants:
        rows[1] = rows[1] + np.pi
        rows[3] = rows[3] + np.pi / 2
    return np.stack(rows)
