"""The classical estimators, by their names, and what each gets wrong.

=====================  ===================================================================================
logarithmic decrement  ln(A_n/A_(n+1)) = pi epsilon_1/2
Froude                 D = A_n - A_(n+1) = (pi/2) epsilon_1 A + (4/3) epsilon_2 A^2, A the mean of both
Bertin                 the square alone
Feeny-Liang            (X_(n+1) + X_n)/(X_n + X_(n-1)) = -q, and friction from X_(n+1) + q X_n: dry and linear
energy                 (A_n^2 - A_(n+1)^2)/2 = (pi/2) epsilon_1 A^2 + (4/3) epsilon_2 A^3
=====================  ===================================================================================

Their systematic error is measured: the same estimator applied to the noiseless turning points of the exact map, for the
strengths fitted to the data, minus those strengths.

>>> exact = 0.9 ** np.arange(9.0)
>>> found = ESTIMATORS["logarithmic decrement"][1](exact * (-1.0) ** np.arange(9))
>>> float(found[0]), float(2 * np.log(1 / 0.9) / np.pi)
(0.067074..., 0.067074...)
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from asymptotics.decays.identification.forward.candidates import Candidate, read_candidate
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.forward.sequence import turning_sequence
from asymptotics.decays.identification.judging.single_fits import fit_law
from asymptotics.decays.identification.measuring.observations import Observations

Estimator = Callable[[Array], Array]
Exact = tuple[Array, Array]


def logarithmic_decrement(x: Array) -> Array:
    """(epsilon_1): from the slope of ln |x_n| against n."""
    n = np.arange(len(x))
    return np.array([-2 / np.pi * np.polyfit(n, np.log(np.abs(x)), 1)[0]])


def froude(x: Array) -> Array:
    """(epsilon_1, epsilon_2): Froude's decrement polynomial."""
    a, d = _means(x)
    return np.asarray(np.linalg.lstsq(np.stack([np.pi / 2 * a, 4 / 3 * a**2], axis=1), d, rcond=None)[0])


def bertin(x: Array) -> Array:
    """(epsilon_2): Bertin's law D = N A^2."""
    a, d = _means(x)
    return np.array([3 / 4 * float(d @ a**2) / float(a**2 @ a**2)])


def feeny_liang(x: Array) -> Array:
    """(epsilon_0, epsilon_1): dry friction and linear damping from the signed extremes, least squares."""
    sums = x[1:] + x[:-1]
    # Successive sums of extremes have the ratio -q of linear damping, whatever the friction is; beyond (0, 1] it is
    # noise, and the estimator has no value.
    q = float(-(sums[1:] @ sums[:-1]) / (sums[:-1] @ sums[:-1]))
    if not 0 < q <= 1:
        return np.full(2, np.nan)
    side = np.sign(x[:-1])
    shift = float(np.mean((x[1:] + q * x[:-1]) * side)) / (1 + q)
    lag = -np.log(q) / np.pi  # (epsilon/2)/sqrt(1 - epsilon^2/4)
    return np.array([shift, 2 * lag / np.sqrt(1 + lag**2)])


def energy_method(x: Array) -> Array:
    """(epsilon_1, epsilon_2): a polynomial for the loss of energy in a half-swing."""
    a, _ = _means(x)
    lost = (np.abs(x[:-1]) ** 2 - np.abs(x[1:]) ** 2) / 2
    return np.asarray(np.linalg.lstsq(np.stack([np.pi / 2 * a**2, 4 / 3 * a**3], axis=1), lost, rcond=None)[0])


def _means(x: Array) -> tuple[Array, Array]:
    size = np.abs(x)
    return (size[1:] + size[:-1]) / 2, size[:-1] - size[1:]


ESTIMATORS: dict[str, tuple[str, Estimator]] = {
    "logarithmic decrement": ("1", logarithmic_decrement),
    "Froude": ("1+2", froude),
    "Bertin": ("2", bertin),
    "Feeny-Liang": ("0+1", feeny_liang),
    "energy": ("1+2", energy_method),
}


def textbook_estimates(seen: Observations) -> dict[str, Any]:
    """Every estimator's strengths for x0 = 1 unit, with its systematic error at the strengths that fit the data."""
    if (
        seen.samples is not None
        or len(seen.n) < 4
        or not (np.diff(seen.n) == 1).all()
        or not (np.abs(seen.x) > 0).all()
    ):
        return {}
    found: dict[str, Any] = {}
    exact: dict[str, Exact | None] = {}  # two of them are of one law, which is fitted once
    for name, (law, estimator) in ESTIMATORS.items():
        estimate = estimator(seen.x)
        if not np.isfinite(estimate).all():
            continue
        if law not in exact:
            exact[law] = exact_points(read_candidate(law), seen)
        error = systematic_error(estimator, exact[law])
        found[name] = {
            "alphas": law.split("+"),
            "epsilon": [f"{e:.6g}" for e in estimate],
            "systematic_error": None if error is None else [f"{e:.3g}" for e in error],
        }
    return found


def systematic_error(estimator: Estimator, exact: Exact | None) -> Array | None:
    """What the estimator adds to the strengths when the data are exact; None if the law cannot be fitted."""
    return None if exact is None else np.asarray(estimator(exact[0]) - exact[1])


def exact_points(candidate: Candidate, seen: Observations) -> Exact | None:
    """The turning points of the law that fits the data, without noise, and its strengths for x0 = 1 unit."""
    fitted = fit_law(candidate, seen).fit
    if fitted is None:
        return None
    try:
        run = turning_sequence(candidate.swing(), seen.last, fitted.theta[: fitted.model.after])
    except TooStrongError:
        return None
    # The offset is left out: the estimators are judged by their formula, not by a base line.
    points = seen.sign * seen.reference * np.exp(run.a[seen.n])
    weights = np.array([e.weight for e in candidate.elements])
    # From strengths at the first amplitude to those of one unit of the data.
    true = fitted.theta[fitted.model.law] * seen.reference**-weights
    return points, true
