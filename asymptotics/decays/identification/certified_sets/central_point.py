"""Strengths in the middle of what a printed table allows: found in doubles, proved in balls.

The table asks |D(epsilon) - D_k| <= r_k.  In doubles the least t with |D(epsilon) - D_k| <= t r_k is found by linear
programs on the exact derivatives of the forward model (Chebyshev's problem, by successive linearisation).  Where t < 1,
balls decide whether the point meets every row.

>>> from asymptotics.decays.identification.forward.candidates import read_candidate
>>> table = Decrements(np.array([1.0, 0.8]), np.array([0.10, 0.06]), np.array([0.005, 0.005]))
>>> least, point = chebyshev_point(read_candidate("2"), table)
>>> bool(least < 1), bool(0.07 < point[0] < 0.08)
(True, True)
"""

import numpy as np
from scipy.optimize import linprog

from asymptotics.decays.identification.fitting.printed import DecrementModel, Decrements, decrement_start
from asymptotics.decays.identification.forward.candidates import Candidate
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.forward.swing import MAX_FREE_ALPHA

_STEPS = 12
_CLOSE = 1e-3
"""Linearisations, each with the gain quadratic near the end, and the relative gain below which they stop.  They decide
how near to the middle the point lies: a point that misses a row is never called consistent, for balls decide that."""


def chebyshev_point(candidate: Candidate, table: Decrements, *, physical: bool = True) -> tuple[float, Array]:
    """(t, parameters): strengths at the largest amplitude of the table, and the exponent if it is free.

    ``physical``: only strengths >= 0.  t is infinite where the model has no half-swing.
    """
    assert table.resolution is not None
    model = DecrementModel(candidate.swing(), table)
    # A resolution of 0 asks for equality, which doubles cannot have: 1e-12 only keeps the division finite.
    width = np.maximum(table.resolution, 1e-12 * table.amplitude)
    lowest = np.full(model.size, 0.0 if physical else -np.inf)
    highest = np.full(model.size, np.inf)
    if candidate.free:
        lowest[-1], highest[-1] = 0.0, MAX_FREE_ALPHA
    theta, best = np.clip(decrement_start(model), lowest, highest), (np.inf, np.zeros(model.size))
    for _ in range(_STEPS):
        try:
            predicted, slopes = model.predict(theta)
        except TooStrongError:
            # The linear step led to a motion that ends: weaker losses, at the same exponent. 0.7 is a choice; 12 steps
            # of it reach 1 %.
            theta = theta * np.append(np.full(model.size - candidate.free, 0.7), [1.0] * candidate.free)
            continue
        missed = (table.decrement - predicted) / width
        least = float(np.abs(missed).max())
        gained = best[0] - least
        if least < best[0]:
            best = (least, theta)
        # The first gain is infinite, so that one step is always made.
        if not gained > _CLOSE * least:
            break
        theta = np.clip(
            theta + _step(slopes / width[:, None], missed, lowest - theta, highest - theta), lowest, highest
        )
    return best


def _step(slopes: Array, missed: Array, low: Array, high: Array) -> Array:
    """The change y that minimises the largest |missed - slopes y|, in units in which the columns are comparable."""
    # The unknowns are y and t: slopes y - t <= missed and -slopes y - t <= -missed, the least t.
    size = np.abs(slopes).max(axis=0) + 1e-300
    ones = np.ones((len(missed), 1))
    matrix = np.block([[slopes / size, -ones], [-slopes / size, -ones]])
    cost = np.append(np.zeros(len(size)), 1.0)
    limits = [*zip(low * size, high * size), (0.0, None)]
    found = linprog(cost, A_ub=matrix, b_ub=np.concatenate([missed, -missed]), bounds=limits, method="highs")
    # A program without a solution leaves the point where it is, which ends the iteration.
    return np.zeros(len(size)) if found.x is None else np.asarray(found.x[:-1] / size)
