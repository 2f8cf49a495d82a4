"""What N turning points with noise sigma can tell, before anything is measured: the Fisher information of the map.

The turning points x_n(theta) depend on theta = (ln A_0, strengths, offset) through the half-swing map; with independent
normal errors the information is J^T J/sigma^2, J = dx_n/dtheta, and its inverse bounds every unbiased estimator's
covariance (Cramer and Rao).  A term is needed, at 95 % with power 90 %, when its strength exceeds (1.96 + 1.28)
standard errors.

>>> errors = standard_errors("1+2", [0.01, 0.02], swings=100, noise=1e-3)
>>> [float(e) for e in errors.round(6)]
[3e-05, 8.1e-05]
>>> swings_needed("1+2", [0.002, 0.03], term=0, noise=1e-3)      # is there linear loss beside the quadratic one?
16
"""

from collections.abc import Callable, Sequence

import numpy as np

from asymptotics.decays.identification.fitting.directions import Directions
from asymptotics.decays.identification.fitting.model import Model
from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.measuring.observations import Observations

SIGNIFICANT = 1.96 + 1.28
"""Quantiles of the normal distribution: two-sided 95 %, and one-sided 90 % for the power."""
MOST_SWINGS = 4000
"""A limit of the search, in time; longer decays are hardly ever recorded."""
_FEW = 7
"""Swings with 8 turning points, the fewest beside which an offset is fitted (``least_squares.Model``)."""


def standard_errors(law: str, strengths: Sequence[float], *, swings: int, noise: float) -> Array:
    """The smallest standard errors that strengths can have (Cramér and Rao), from the turning points 0 ... ``swings``.

    Parameters
    ----------
    law
        the exponents as text, such as "1+2"
    strengths
        one for each term, where m = k = x0 = 1
    swings
        how many half-swings are observed
    noise
        the standard deviation of x, in units of x0

    Returns
    -------
    array
        one for each strength; infinite where the turning points do not tell it from the others

    Examples
    --------
    >>> standard_errors("1+2", [0.1, 0.1], swings=10, noise=0.001).round(4).tolist()
    [0.0007, 0.0017]
    """
    candidate = read_candidate(law)
    # The signs of turning points alone: the design has no data, and the information does not depend on them.
    n = np.arange(swings + 1)
    model = Model(candidate.swing(), Observations.of(n, np.where(n % 2, -1.0, 1.0)))
    theta = np.array([0.0, *strengths, *([0.0] if model.offset else [])])
    found = Directions.of(model.predict(theta)[1] / noise)
    return np.array([found.standard_error(along) for along in np.eye(model.size)[model.law]])


def swings_needed(law: str, strengths: Sequence[float], *, term: int, noise: float) -> int | None:
    """The least number of half-swings that show that a term is needed; None if no number up to the limit does.

    Parameters
    ----------
    law
        the exponents as text, such as "1+2"
    strengths
        one for each term, where m = k = x0 = 1
    term
        the term that is to be told from 0, counted from 0
    noise
        the standard deviation of x, in units of x0

    Returns
    -------
    int or None
        the number of half-swings

    Examples
    --------
    >>> swings_needed("1+2", [0.1, 0.1], term=1, noise=0.001)
    2
    """

    def error(swings: int) -> float | None:
        try:
            return float(standard_errors(law, strengths, swings=swings, noise=noise)[term])
        except TooStrongError:
            # The motion ends before so many swings: no more of them can be had.
            return None

    def enough(swings: int) -> bool:
        found = error(swings)
        return found is not None and strengths[term] > SIGNIFICANT * found

    # Up to here one by one: an offset that is a parameter from 8 turning points on may ask for more of them.
    for few in range(1, _FEW + 1):
        if enough(few):
            return few
    # From there on each swing adds to what is known: doubled until it is enough, then halved in between.
    low, high = _FEW, 2 * _FEW
    while not enough(high):
        if error(high) is None:
            high = _last(low, high, error)
            if not enough(high):
                return None
            break
        low, high = high, 2 * high
        if high > MOST_SWINGS:
            return None
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if enough(middle) else (middle, high)
    return high


def _last(low: int, high: int, error: Callable[[int], float | None]) -> int:
    """The last swing before the motion ends, which is at ``low`` or later and before ``high``."""
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if error(middle) is None else (middle, high)
    return low
