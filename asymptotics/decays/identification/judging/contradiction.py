"""When do the data contradict a law?  When another law explains them better than chance allows.

The likelihood-ratio test, for nested laws by Wilks's theorem (1938), for others by the inequality below.

Let C be the law in question, B another, and k the number of parameters that B has and C has not.  If C is true, then

    -2 ln(L_C/L_B)  <=  -2 ln(L_C/L_(B and C together)),

and the right-hand side is distributed as chi-squared with k degrees of freedom.  So the left-hand side, whether B
contains C or not, refutes C when it exceeds a quantile of that distribution.  A law that contains the true one can only
gain likelihood by its further terms and is never refuted by it: the further terms are not *needed*, which is another
matter.  For noise scales taken from the residuals, chi-squared is replaced by the F distribution that a linear model
with as many data would have; residuals that remember divide the ratio by the square of what stretches the intervals.
"""

from dataclasses import dataclass

import numpy as np
from scipy.special import chdtrc, fdtrc

from asymptotics.decays.identification.fitting.least_squares import Fit
from asymptotics.decays.identification.forward.candidates import Candidate
from asymptotics.decays.identification.forward.swing import MAX_FREE_ALPHA

REFUTED = 1e-3
"""The probability of so bad a fit, were the law true, below which it is refuted.  Small, for dozens of laws are
compared: one comparison in a thousand with a true law exceeds it, and for some law that contains the true one four
records in a thousand (``docs/how_often_right.md``)."""


@dataclass(frozen=True)
class Contradiction:
    """How much better ``by`` explains the data: the likelihood ratio, its degrees of freedom, the p-value."""

    by: Candidate | None = None
    ratio: float = 0.0
    terms: int = 0
    p: float = 1.0

    def __str__(self) -> str:
        return f"{self.by} explains the data better: likelihood ratio {self.ratio:.4g}, p = {self.p:.2g}"


def further_parameters(larger: Candidate, law: Candidate) -> int:
    """How many parameters ``larger`` has that ``law`` has not.

    A pendulum and a linear spring are two points of one family, sin x and x in some share: a parameter either way.

    >>> from asymptotics.decays.identification.forward.candidates import read_candidate as read
    >>> [further_parameters(read(b), read(c)) for b, c in (("1+2", "1"), ("1", "1+2"), ("2+s3", "1"), ("free", "1"))]
    [1, 0, 2, 1]
    """
    springs = len(set(larger.springs) - set(law.springs)) + (larger.pendulum != law.pendulum)
    if larger.free:
        if law.free:
            return springs
        # A single loss with exponent up to 5 lies within the free one, which has one parameter more; a sum does not:
        # two.
        return springs + (1 if len(law.losses) == 1 and _is_one_of_the_free(law) else 2)
    # A fixed exponent has nothing that the free one lacks.
    if law.free and len(larger.losses) == 1 and _is_one_of_the_free(larger):
        return springs
    return springs + len(set(larger.losses) - set(law.losses))


def _is_one_of_the_free(law: Candidate) -> bool:
    element = law.elements[0]
    return element.position == 0 and element.velocity <= MAX_FREE_ALPHA


def contradiction(
    law: Candidate, fit: Fit, by: Candidate, better: Fit, inflation: float = 1.0, left: float = 1.0
) -> Contradiction:
    """How far ``better``, the fit of ``by``, contradicts ``fit``, the fit of ``law``.

    ``inflation``: by how much correlated residuals of ``better`` stretch intervals; ``left``: the share of the
    sum of squares of ``law`` that effects which the data cannot show would leave.
    """
    # In units of twice the log-likelihood: with scales from the residuals, N ln of the share of the sum of squares.
    relief = fit.chi2 * (1 - left) if fit.known else -len(fit.residuals) * np.log(max(left, 1e-12))
    terms = further_parameters(by, law)
    # Residuals that remember are fewer independent data: by the square of what stretches an interval.
    ratio = (2 * (better.log_likelihood - fit.log_likelihood) - relief) / inflation**2
    if terms == 0 or not ratio > 0:
        return Contradiction(by, max(ratio, 0.0), terms, 1.0)
    return Contradiction(by, ratio, terms, _p_value(ratio, terms, better))


def _p_value(ratio: float, terms: int, better: Fit) -> float:
    """Of the likelihood ratio N ln(1 + k F/f), in the smallest group of data: N data, f degrees of freedom."""
    if better.known:
        return float(chdtrc(terms, ratio))
    sizes = [group.stop - group.start for group in better.model.groups]
    # The smallest group has the heaviest tail of F: the p-value is rather too large, which refutes less.
    place = int(np.argmin(sizes))
    freedom = max(better.freedoms[better.model.kinds[place]], 1.0)
    F = float(np.expm1(min(ratio / sizes[place], 700.0))) * freedom / terms
    return float(fdtrc(terms, freedom, F))
