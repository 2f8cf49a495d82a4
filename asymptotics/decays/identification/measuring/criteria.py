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
