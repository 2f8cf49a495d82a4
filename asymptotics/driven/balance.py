"""How far first order is off, as an estimate: the balance of the odd harmonics up to the ninth, in doubles.

x = sum_n a_n cos(n theta) + b_n sin(n theta) with (k - n^2 mu) (a_n, b_n) + the harmonic of the losses = f for n = 1,
by Newton's method from first order, which is the same with n = 1 alone.  The losses are integrated between the zeros of
the speed, theta = z + pi (1 - cos s)/2, by Gauss and Legendre in s: what a power of the speed does there is smooth.
For dry friction, whose harmonics fall slowly, a fifth of the error lies beyond the ninth.

>>> import numpy as np
>>> viscous = ((0.1, 1.0),)
>>> waves = balanced(1.0, 1.0, viscous, (0.0, 10.0))
>>> [round(float(x), 12) + 0.0 for x in waves[:2].ravel()]
[0.0, 10.0, 0.0, 0.0]
"""

from math import pi

import numpy as np
from flint import arb
from numpy.typing import NDArray

from asymptotics.driven import first_order
from asymptotics.driven.drive import Drive
from asymptotics.numbers.context import ctx, lru_cache

HARMONICS = (1, 3, 5, 7, 9)
NAME = "estimate: balance of the harmonics 1 to 9"
_NODES, _STEPS, _GRID, _SEEN = 48, 20, 720, 1e-11  # choices
Array = NDArray[np.float64]
_N = np.array(HARMONICS)


def estimated_error(drive: Drive) -> dict[str, str] | None:
    """The response's amplitude and phase less those of first order, two digits of an estimate; None where not found.

    What doubles do not see, below 1e-11 of the amplitude or of a radian, is left out.
    """
    with ctx.workprec(64):
        balls = drive.balls()
        A = first_order.amplitude(balls)
        scaled, lag = balls.in_units(A.mid()), float(first_order.phase(balls, A).mid())
    losses = tuple((float(c.mid()), float(alpha.mid())) for c, alpha in scaled.losses)
    with np.errstate(all="ignore"):
        waves = balanced(float(scaled.k.mid()), float(scaled.mu.mid()), losses, (np.cos(lag), np.sin(lag)))
        if waves is None:
            return None
        off, later = _largest(waves) - 1, float(np.arctan2(waves[0, 1], waves[0, 0])) - lag
    told = {"amplitude": (A * off).mid(), "phase": arb(later)}
    seen = {"amplitude": abs(off), "phase": abs(later)}
    return {**{name: value.str(2, radius=False) for name, value in told.items() if seen[name] > _SEEN}, "method": NAME}


def balanced(k: float, mu: float, losses: tuple[tuple[float, float], ...], first: tuple[float, float]) -> Array | None:
    """(a_n, b_n), one row for each harmonic, for the force cos(theta); None where Newton's method finds none."""
    z = np.zeros((len(_N), 2))
    z[0] = first
    stiff, force = (k - mu * _N**2)[:, None], np.zeros_like(z)
    force[0, 0] = 1

    def left(waves: Array) -> Array:
        return (stiff * waves + _loss(waves, losses) - force).ravel()

    for _ in range(_STEPS):
        here = left(z)
        if not np.all(np.isfinite(here)):
            return None
        d = 1e-6
        slopes = [(left(z + d * unit.reshape(z.shape)) - here) / d for unit in np.eye(z.size)]
        if not np.all(np.isfinite(slopes)):
            return None
        step = np.linalg.lstsq(np.array(slopes).T, here)[0]
        z = z - step.reshape(z.shape)
        if np.max(abs(step)) < 1e-10:
            return z
    return None


def _speed(waves: Array, theta: Array) -> Array:
    angle = np.multiply.outer(theta, _N)
    found: Array = np.cos(angle) @ (_N * waves[:, 1]) - np.sin(angle) @ (_N * waves[:, 0])
    return found


@lru_cache(maxsize=1)
def _gauss() -> tuple[Array, Array]:
    """The nodes and weights: an eigenvalue problem, solved once."""
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    return nodes, weights


def _loss(waves: Array, losses: tuple[tuple[float, float], ...]) -> Array:
    """The harmonics (2/pi) int sum c v|v|^(alpha-1) (cos, sin)(n theta) over half a period that begins at rest."""
    zero = np.arctan2(waves[0, 1], waves[0, 0])  # where the first harmonic is largest; the speed itself is 0 nearby
    for _ in range(8):
        there = np.array([zero])
        rate = -(np.cos(_N * zero) @ (_N**2 * waves[:, 0]) + np.sin(_N * zero) @ (_N**2 * waves[:, 1]))
        zero = zero - float(_speed(waves, there)[0]) / rate
    nodes, weights = _gauss()
    s = pi * (nodes + 1) / 2
    theta, weights = zero + pi * (1 - np.cos(s)) / 2, weights * pi / 2 * pi / 2 * np.sin(s)
    v = _speed(waves, theta)
    loss = sum(c * np.sign(v) * abs(v) ** alpha for c, alpha in losses) * weights
    angle = np.multiply.outer(theta, _N)
    return 2 / pi * np.stack([loss @ np.cos(angle), loss @ np.sin(angle)], axis=1)


def turns_of(waves: Array) -> list[tuple[float, float]]:
    """(theta, x) of the turning points in half a period that begins a little before the largest first harmonic."""
    begin = np.arctan2(waves[0, 1], waves[0, 0]) - pi / 2
    theta = begin + np.arange(_GRID + 1) * (pi / _GRID)
    v = _speed(waves, theta)
    found = []
    for n in np.flatnonzero((v[1:] > 0) != (v[:-1] > 0)):
        at = theta[n] + (theta[n + 1] - theta[n]) * v[n] / (v[n] - v[n + 1])
        found.append((float(at), float(np.cos(_N * at) @ waves[:, 0] + np.sin(_N * at) @ waves[:, 1])))
    return found


def _largest(waves: Array) -> float:
    """The largest |x|, by a parabola through the three highest places of a grid."""
    theta = np.arange(_GRID) * (pi / _GRID)
    angle = np.multiply.outer(theta, _N)
    x = abs(np.cos(angle) @ waves[:, 0] + np.sin(angle) @ waves[:, 1])
    i = int(np.argmax(x))
    a, b, c = x[i - 1], x[i], x[(i + 1) % _GRID]
    bend = a - 2 * b + c
    return float(b - (a - c) ** 2 / (8 * bend)) if bend < 0 else float(b)
