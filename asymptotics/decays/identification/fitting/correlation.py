"""Residuals that remember: intervals corrected by a block bootstrap over swings.

The block bootstrap is Kunsch's (1989, Ann. Statist. 17, 1217-1241) with blocks that go round the end of the record;
whether it is wanted says the test of Ljung and Box (1978, Biometrika 65, 297-303).

Neighbouring residuals that agree make intervals too short.  Blocks of whole swings (all data of a swing together) are
drawn with replacement and added to the prediction; each replica is fitted by one Gauss-Newton step, which is exact for
a linear model and so good here that the profile likelihood, where it bends, keeps its shape: only its lengths are
multiplied, by the ratio of the replicas' spread to the standard error.
"""

import numpy as np
from scipy.special import chdtrc

from asymptotics.decays.identification.fitting.least_squares import Fit
from asymptotics.decays.identification.fitting.profile import Function
from asymptotics.decays.identification.forward.blocks import Array, product

REPLICAS = 400
"""A standard deviation from 400 draws has an error of 1/sqrt(800), 3.5 %: so well is the stretch of an interval
known."""


def is_correlated(fit: Fit, level: float = 0.01) -> bool:
    """Whether some kind of residual fails Ljung and Box's test of whiteness at ``level``, shared between the kinds."""
    # The level is shared (Bonferroni); with fewer than 12 data the statistic has two lags or less, and tells nothing.
    kinds = [fit.weighted[group] for group in fit.model.groups]
    return any(_whiteness(r) < level / len(kinds) for r in kinds if len(r) >= 12)


def _whiteness(r: Array) -> float:
    """The p-value of Ljung and Box's statistic, with min(10, N/5) lags."""
    r, n = r - r.mean(), len(r)
    # The customary number: more lags dilute what the first ones show.
    lags = min(10, n // 5)
    power = float(r @ r)
    if power == 0 or lags < 1:
        return 1.0
    rho = np.array([float(r[k:] @ r[:-k]) / power for k in range(1, lags + 1)])
    q = n * (n + 2) * float((rho**2 / (n - np.arange(1, lags + 1))).sum())
    return float(chdtrc(lags, q))


def block_length(fit: Fit) -> int:
    """Twice the lag at which the slowest autocorrelation has fallen to noise; at least 3 swings, at most a fifth."""
    longest = 1
    for group in fit.model.groups:
        r = fit.weighted[group]
        r = r - r.mean()
        power = float(r @ r) or 1.0
        for k in range(1, len(r) // 5):
            # 2/sqrt(n) is the two-sided 95 % of the correlations of white noise.
            if abs(float(r[k:] @ r[:-k])) / power < 2 / np.sqrt(len(r)):
                break
            longest = max(longest, k + 1)
    swings = fit.model.units
    # Blocks must be longer than the memory, and many enough to differ: at least five of them.
    return int(np.clip(2 * longest, 3, max(3, swings // 5)))


def replicas(fit: Fit, count: int = REPLICAS, seed: int = 1) -> Array:
    """Parameter vectors (count, parameters) of the bootstrap; the same at every call."""
    # A fixed seed: the same data have the same answer.
    generator = np.random.default_rng(seed)
    swings, length = fit.model.units, block_length(fit)
    starts = generator.integers(0, swings, size=(count, swings // length + 1))
    # The blocks go round, so that a swing near an end is drawn as often as any other.
    round_the_end = np.arange(swings + length) % swings
    drawn = np.empty((count, len(fit.residuals)))
    for group in fit.model.groups:
        r = fit.weighted[group]
        # Residuals are smaller than the noise by what the fit took out; 2 stands for that in each kind, a choice that
        # matters in short records alone.
        r = (r - r.mean()) * np.sqrt(len(r) / max(len(r) - 2.0, 1.0))
        blocks = np.lib.stride_tricks.sliding_window_view(r[round_the_end % len(r)], length)
        drawn[:, group] = blocks[starts].reshape(count, -1)[:, : len(r)]
    # The least-squares solution of each replica; what no data see does not change.
    found = fit.directions
    along = product(drawn, found.left[: len(fit.residuals), found.seen]) / found.values[found.seen]
    return np.asarray(fit.theta + along @ found.right[found.seen] / found.size)


def stretch(fit: Fit, g: Function, drawn: Array) -> float:
    """By how much the interval of g must be longer than for white residuals; never shorter."""
    gradient = g(fit.theta)[1]
    error = fit.directions.standard_error(gradient)
    if not 0 < error < np.inf:
        return 1.0
    # In units of the error: the square of a strength for x0 = 1 unit may leave the doubles.
    spread = float(np.std((drawn - fit.theta) @ (gradient / error)))
    # Neighbours that alternate would shorten the interval; that is not believed.
    return max(1.0, spread)
