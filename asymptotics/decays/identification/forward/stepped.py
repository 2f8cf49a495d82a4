"""Half-swings by Runge and Kutta's steps in theta, where the series does not reach and the noise asks for few digits.

The classical fourth-order method (Hairer, Norsett and Wanner 1993, II.1) in the angle, where the ends of a half-swing
are known beforehand; the derivatives are complex steps (Squire and Trapp 1998, SIAM Rev. 40, 110-112).

The equations of ``coefficients`` (and of ``pendulum``: k2 > 0) for all swings and all derivatives at once; the
derivatives by a step in the imaginary direction, which loses no digit.  The exponents are whole: their forces are
smooth, and N is a polynomial in e^y over e^y.  48 steps (192 near the top of the circle) leave 6e-8 at a loss of a
quarter in one half-swing: measured against the quadratures.  Where more may be left the steps are fewer, by the fourth
root.

>>> from asymptotics.decays.identification.forward.coefficients import loss
>>> values, by_amplitude, _ = stepped_swings((loss(1.0),), np.zeros(1), np.array([0.1]))
>>> bool(abs(values[0, 0] + np.pi * 0.05 / np.sqrt(1 - 0.05**2)) < 1e-9), float(by_amplitude[0, 0])
(True, 0.0)
"""

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array, Element
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.numbers.context import lru_cache

PRECISE = 1e-7
"""The tolerance from which on these steps serve."""
_STEPS, _NEAR_THE_TOP, _HIGH = 48, 192, 0.7
"""Steps of a half-swing; four times as many from k^2 = 0.7 on, where the clock of the pendulum has a peak."""
_IMAGINARY, _FEWEST = 1e-30, 12
"""A step in the imaginary direction of which the square is below any double; and the fewest steps for a tolerance."""


def is_smooth(elements: tuple[Element, ...]) -> bool:
    """Whether all exponents are whole."""
    return all(float(e.velocity).is_integer() for e in elements)


# A step of the search may leave the doubles, where e^y is 0 too: no swing there.
@np.errstate(over="ignore", invalid="ignore", divide="ignore")
def stepped_swings(
    elements: tuple[Element, ...], a: Array, strengths: Array, k2: float = 0.0, tolerance: float = PRECISE
) -> tuple[Array, Array, Array]:
    """(values, d/da, d/dstrengths) of L, T, R, T_q at the amplitudes; TooStrongError where no turning point follows."""
    count = len(elements)
    sets = 2 + count
    # Column 0 as it is, column 1 with a moved, then each strength.
    nudge = 1j * _IMAGINARY * np.eye(sets)
    A = np.repeat(a[None], sets, axis=0) + nudge[:, 1:2]
    weights = [int(e.weight) for e in elements]
    delta = (strengths[:, None, None] + nudge[:, 2:].T[:, :, None]) * np.exp(np.array(weights)[:, None, None] * A)
    # By falling weight, which is -1 at least.
    order = sorted(range(count), key=lambda i: -weights[i])
    falling, delta = tuple(elements[i] for i in order), delta[order]
    gaps, least = [weights[i] - weights[j] for i, j in zip(order, order[1:])], weights[order[-1]]
    size = k2 * np.exp(2 * A)
    # One number of steps for all swings, by the largest: they run together.
    steps = _NEAR_THE_TOP if k2 and (k2 * np.exp(2 * a)).max() > _HIGH else _STEPS
    # Even, so that the passage through the base line is a node.
    steps = max(2 * round(steps / 2 * (PRECISE / max(tolerance, PRECISE)) ** 0.25), _FEWEST)
    h = np.pi / steps
    sines, cosines, shapes = _places(falling, steps)

    def rates(k: int, y: Array) -> tuple[Array, Array]:
        s, c, E = sines[k], cosines[k], np.exp(y)
        parts = delta * shapes[k]
        N = parts[0]
        for part, gap in zip(parts[1:], gaps):
            for _ in range(gap):
                N = N * E
            N = N + part
        for _ in range(least):
            N = N * E
        if least < 0:
            N = N / E
        g = np.sqrt(1 - size * (c * E) ** 2) if k2 else 1.0
        d = g - c * N
        # d = 0: the loss has taken all of the spring's force, and the phase stands still.
        if not (d.real > 0).all():
            raise TooStrongError("no turning point follows on the other side")
        return -s * N / d, 1 / d

    y, tau = np.zeros_like(A), np.zeros_like(A)
    middle = (y, tau)
    for k in range(0, 2 * steps, 2):
        if k == steps:
            middle = (y, tau)
        y1, t1 = rates(k, y)
        y2, t2 = rates(k + 1, y + h / 2 * y1)
        y3, t3 = rates(k + 1, y + h / 2 * y2)
        y4, t4 = rates(k + 2, y + h * y3)
        y, tau = y + h / 6 * (y1 + 2 * y2 + 2 * y3 + y4), tau + h / 6 * (t1 + 2 * t2 + 2 * t3 + t4)
    found = np.stack([y, tau, *middle])
    if not np.isfinite(found.real).all():
        raise TooStrongError("the amplitudes leave every bound")
    slopes = np.moveaxis(found.imag / _IMAGINARY, 1, 0)
    return found[:, 0].real, slopes[1], slopes[2:]


@lru_cache(maxsize=256)
def _places(elements: tuple[Element, ...], steps: int) -> tuple[list[float], list[float], list[Array]]:
    """sin, cos and the shapes of the terms at the ends and the middles of the steps; both ends are at rest."""
    theta = np.arange(2 * steps + 1) * np.pi / steps / 2
    s, c = np.sin(theta), np.cos(theta)
    # sin(pi) is 1.2e-16 in doubles; both ends are at rest exactly, where friction, s^0, is 1.
    s[[0, -1]] = 0.0
    shapes = [
        s**e.velocity * np.abs(c) ** e.position if e.kind == "loss" else -c * np.abs(c) ** max(e.position - 1, 0)
        for e in elements
    ]
    return s.tolist(), c.tolist(), list(np.stack(shapes, axis=1)[:, :, None, None])
