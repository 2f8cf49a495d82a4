"""The interval of a number that several models tell: its tail areas are the averages of theirs.

The field's word is a model-averaged tail-area interval (Turek and Fletcher 2012, Comput. Stat. Data Anal. 56,
2809-2815).  A model of criterion c (an AICc) has the weight e^(-c/2); below the lower end lies 2.5 % of the weighted
sum of the distributions of the models, each about its value with its error.  Of models that agree it is the interval of
each; what is hardly believed hardly moves it.  The union of the intervals of all models near the best is longer.

>>> one, other = Told(2.0, 0.1, 0.0), Told(2.3, 0.1, 2.0)
>>> [round(end, 3) for end in averaged([one]).values()]
[1.804, 2.0, 2.196]
>>> [round(end, 3) for end in averaged([one, other]).values()]
[1.818, 2.047, 2.432]
"""

from collections.abc import Iterable
from dataclasses import dataclass
from math import inf, nan

import numpy as np
from scipy.optimize import brentq
from scipy.special import ndtr, stdtr, stdtrit

from asymptotics.decays.identification.forward.coefficients import Array

Ends = dict[str, float]
NORMAL = 1.96
"""Of the normal distribution, for errors that are known."""
_TAILS = {"low": 0.025, "estimate": 0.5, "high": 0.975}
ENDS = tuple(_TAILS)
_LEAST = 1e-4
"""A weight beside the best below which a model is not asked."""
_FAR = 13.0
"""Standard errors beyond which less than the tail of one freedom lies, twice over."""


@dataclass(frozen=True)
class Told:
    """A value with its standard error, the criterion of the model that tells it, and the freedoms behind the error."""

    value: float
    error: float
    criterion: float
    freedom: float = inf


def weights(criteria: Array) -> Array:
    """The share of each model in what is believed."""
    each = np.exp(-(criteria - criteria.min()) / 2)
    return np.asarray(each / each.sum())


def averaged(each: list[Told], names: Iterable[str] = ENDS) -> Ends:
    """The median, and the 95 % interval, of the weighted sum of their distributions; or some of these ``names``."""
    share = weights(np.array([told.criterion for told in each]))
    asked = share > _LEAST
    w = share[asked] / share[asked].sum()
    value, error, freedom = (np.array([getattr(t, k) for t in each])[asked] for k in ("value", "error", "freedom"))
    if not error.any() and np.ptp(value) == 0:
        return dict.fromkeys(names, float(value[0]))
    error = np.maximum(error, 1e-12 * np.abs(value).max())
    known = np.isinf(freedom)
    finite = np.where(known, 1.0, freedom)

    def below(x: float, tail: float) -> float:
        z = (x - value) / error
        if known.any():
            each = ndtr(z) if known.all() else np.where(known, ndtr(z), stdtr(finite, z))
        else:
            each = stdtr(freedom, z)
        return float(w @ each) - tail

    low, high = float((value - _FAR * error).min()), float((value + _FAR * error).max())
    tolerance = 1e-6 * float(error.min())
    return {name: float(brentq(below, low, high, (_TAILS[name],), xtol=tolerance)) for name in names}


def mean_of(each: list[Told]) -> Ends:
    """The mean of the weighted sum, and the interval of a normal distribution of its variance."""
    share = weights(np.array([told.criterion for told in each]))
    value, error = (np.array([getattr(told, name) for told in each]) for name in ("value", "error"))
    mean = float(share @ value)
    reach = NORMAL * float(np.sqrt(share @ (error**2 + (value - mean) ** 2)))
    return {"low": mean - reach, "estimate": mean, "high": mean + reach}


def united(each: list[Told]) -> Ends:
    """The value of the first and the interval that holds those of all; without freedoms no ends."""
    reach = [told.error * _quantile(told.freedom) for told in each]
    ends = np.array([[told.value - r, told.value + r] for told, r in zip(each, reach, strict=True)])
    return {"low": float(ends[:, 0].min()), "estimate": each[0].value, "high": float(ends[:, 1].max())}


def _quantile(freedom: float) -> float:
    if freedom == inf:
        return NORMAL
    return float(stdtrit(freedom, _TAILS["high"])) if freedom else nan
