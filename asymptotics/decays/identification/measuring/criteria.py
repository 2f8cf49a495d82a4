"""How many parameters the data bear: the criteria of Akaike and of Schwarz, and the fit that one of them chooses.

The field's word is model selection: Akaike 1974 (IEEE Trans. Autom. Control 19, 716-723), with the small-sample term of
Hurvich and Tsai 1989 (Biometrika 76, 297-307), and Schwarz 1978 (Ann. Statist. 6, 461-464).

With k parameters and n data, the noise among the parameters where it is fitted too, and -2 ln(likelihood) the deviance,

    AICc = deviance + 2 k + 2 k (k + 1)/(n - k - 1),        BIC = deviance + k ln n.

>>> aicc(10.0, 2, 7), aicc(10.0, 2, 3), round(bic(10.0, 2, 7), 3)
(17.0, inf, 13.892)
"""

from collections.abc import Callable, Iterable
from math import inf, log

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array

Criterion = Callable[[float, int, int], float]


def aicc(deviance: float, parameters: int, data: int) -> float:
    """Akaike's criterion with the correction for small samples; infinite when there are too few data."""
    spare = data - parameters - 1
    return inf if spare <= 0 else deviance + 2 * parameters + 2 * parameters * (parameters + 1) / spare


def bic(deviance: float, parameters: int, data: int) -> float:
    """Schwarz's criterion."""
    return float(deviance + parameters * log(data))


def chosen(bases: Iterable[Array], y: Array, criterion: Criterion) -> tuple[Array, float, int] | None:
    """(coefficients, sum of squares, parameters) of the basis with the least criterion; None if all are infinite.

    Each basis is a matrix of columns; y is its sum with normal noise of unknown size, which counts as a parameter.
    """
    best, found = inf, None
    for columns in bases:
        c = np.asarray(np.linalg.lstsq(columns, y, rcond=None)[0], dtype=float)
        # A basis that leaves nothing at all must still have a logarithm.
        rss, parameters = max(float(((y - columns @ c) ** 2).sum()), 1e-300), columns.shape[1] + 1
        value = criterion(len(y) * log(rss / len(y)), parameters, len(y))
        # Of equals the first, which is the smallest where the bases grow.
        if value < best:
            best, found = value, (c, rss, parameters)
    return found


def memory_factor(r: Array) -> float:
    """(1 + rho)/(1 - rho) of residuals whose neighbours are correlated by rho: by it the variances of a fit grow.

    Turning points of one smooth line have errors that are as smooth as the line.  1 where rho is not beyond doubt.

    >>> white = np.random.default_rng(0).standard_normal(400)
    >>> memory_factor(white), memory_factor(np.convolve(white, np.ones(8), "valid")) > 5
    (1.0, True)
    """
    rho = float(r[1:] @ r[:-1]) / max(float(r @ r), 1e-300)
    # Two standard errors of white noise; at 0.9 intervals are four times as long.
    rho = min(rho, 0.9)
    return (1 + rho) / (1 - rho) if rho > 2 / np.sqrt(len(r)) else 1.0
