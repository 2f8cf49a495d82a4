"""Amplitudes at times, or at counted swings, as the loss between them: two amplitudes and a time tell one strength.

To first order d ln A/d tau = -zeta(A) with zeta(A) = sum_i b_i z_i(A), so that between A_0 and A_1, a time tau apart,

    ln(A_0/A_1)/tau = sum_i b_i <z_i>,   <z_i> = int z_i/zeta dA/A / int 1/zeta dA/A,

the mean over the time in between: exact for any ratio of the two amplitudes.  With one term <z_i> knows no b; with
several the strengths of the last round weigh the next, until they stay.

>>> both, decrement = pairs(np.array([4.0, 2.0, 1.0]), np.array([0.0, 1.0, 3.0]))
>>> both.tolist(), decrement
([[4.0, 2.0], [2.0, 1.0]], array([0.69314718, 0.34657359]))
>>> means([lambda a: a], both, decrement)                           # drag in v^2: 1/<A> is the mean of 1/A
array([[2.77258872],
       [1.38629436]])
"""

from collections.abc import Callable, Sequence

import numpy as np
from scipy.optimize import nnls

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.errors import InputError
from asymptotics.present.counts import many

_NODES, _ROUNDS, _STAYS = 8, 60, 1e-10
"""Of Gauss and Legendre in ln A; rounds of the strengths, and the change at which they stay."""


def pairs(amplitude: Array, cycles: Array) -> tuple[Array, Array]:
    """Neighbouring amplitudes, and the logarithmic decrement of a cycle between them; InputError where none is lost."""
    if len(amplitude) < 2:
        raise InputError("table", f"{many(len(amplitude), 'amplitude')} at times", "two at least")
    if (np.diff(cycles) <= 0).any():
        raise InputError("table", "its times or counts do not increase", "rows in the order of time")
    if (np.diff(amplitude) >= 0).any():
        place = int(np.argmax(np.diff(amplitude) >= 0))
        reason = f"amplitude {amplitude[place + 1]:g} after {amplitude[place]:g}: nothing is lost"
        raise InputError("table", reason, "falling amplitudes; of a noisy decay asymptotics identify")
    both = np.stack([amplitude[:-1], amplitude[1:]], axis=1)
    return both, np.log(both[:, 0] / both[:, 1]) / np.diff(cycles)


def means(units: Sequence[Callable[[float], float]], both: Array, zeta: Array) -> Array:
    """The means over the time of the zeta of unit strengths: a row for each pair, a column for each term.

    ``zeta``: what was measured, to which strengths >= 0 are fitted in each round.
    """
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    middle, half = np.log(both[:, 0] * both[:, 1]) / 2, np.log(both[:, 0] / both[:, 1]) / 2
    at = np.exp(middle[:, None] + half[:, None] * nodes)
    each = np.array([[[unit(float(a)) for a in row] for row in at] for unit in units])
    b = 1 / each.mean(axis=(1, 2))  # every term as strong as any other, to begin with
    for _ in range(_ROUNDS):
        time = weights / np.tensordot(b, each, 1)
        columns = ((each * time).sum(axis=2) / time.sum(axis=1)).T
        found = nnls(columns, zeta)[0]
        if not found.any() or np.abs(found - b).max() < _STAYS * found.max():
            break
        b = found
    return np.asarray(columns)
