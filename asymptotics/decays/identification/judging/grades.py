"""How much of the loss a law leaves unexplained, and its grade: consistent, adequate to p % of the loss, refuted.

With A_n the amplitudes of the fitted law and r_n = (measured - A_n)/A_n, the measured loss per swing at amplitude A is
1 + dr/ds times that of the law, s = ln A.  r is fitted by a polynomial in s, its degree by BIC, so that what noise
alone makes counts for nothing; p is the root mean square of dr/ds over the measured range of s.

>>> s = np.linspace(0.0, -1.5, 60)
>>> noise = 1e-3 * np.random.default_rng(0).standard_normal(60)
>>> open_share(np.exp(s), noise / np.exp(s)).share
0.0
>>> round(open_share(np.exp(s), 0.08 * s + noise).share, 2)
0.08
"""

from dataclasses import dataclass

import numpy as np

from asymptotics.decays.identification.fitting.least_squares import Fit
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.measuring.criteria import bic, chosen
from asymptotics.present.percent import percent

ADEQUATE = 0.10
"""A choice, told to the user with the share itself: a law that misses a tenth of the loss is still of use."""
_DEGREES, _POINTS = 6, 41
"""What a law leaves is a smooth function of ln A, so that a low degree will do, chosen by BIC; places at which it is
then averaged, many for that degree."""
_SEEN = 5e-4
"""A share below this is nothing that a damping measured to three digits shows."""
_LEAST_FALL = 0.05
"""The range of ln A below which a slope in it would be noise alone."""


@dataclass(frozen=True)
class Unexplained:
    """``share`` of the loss, over ``amplitudes``; ``ratio``: measured loss over that of the law, less 1, at each."""

    share: float
    amplitudes: Array
    ratio: Array

    @property
    def ends(self) -> tuple[float, float]:
        """The smallest and the largest amplitude."""
        return float(self.amplitudes.min()), float(self.amplitudes.max())


def unexplained(fit: Fit) -> Unexplained | None:
    """What a fitted law leaves of the loss; None where there are no turning points, or they hardly fall."""
    model, seen = fit.model, fit.model.seen
    # Printed decrements are no sequence; four points have no polynomial to spare.
    if not model.alternating or len(seen.n) < 5:
        return None
    try:
        size = model.amplitudes(fit.theta)[0][seen.n[seen.inside]]
    except TooStrongError:
        return None
    if not (size > 0).all() or np.ptp(np.log(size)) < _LEAST_FALL:
        return None
    return open_share(size, ((seen.sign * (seen.x - fit.rest))[seen.inside] - size) / size)


def open_share(size: Array, residual: Array) -> Unexplained:
    """From the amplitudes of the law and the relative residuals, whose noise is as 1/amplitude."""
    s = np.log(size)
    u = 2 * (s - s.min()) / np.ptp(s) - 1
    # Three data for each coefficient.
    degrees = range(min(_DEGREES, len(s) // 3) + 1)
    # Both sides times the amplitude: the noise of the turning points is then equal, as least squares wants it.
    polynomials = (np.polynomial.chebyshev.chebvander(u, d) * size[:, None] for d in degrees)
    found = chosen(polynomials, residual * size, bic)
    c = np.zeros(1) if found is None else found[0]
    grid = np.linspace(-1, 1, _POINTS)
    slope = np.polynomial.chebyshev.chebder(c) if len(c) > 1 else np.zeros(1)
    # d/ds = (2/range) d/du.
    ratio = np.polynomial.chebyshev.chebval(grid, slope) * 2 / np.ptp(s)
    return Unexplained(float(np.sqrt(np.mean(ratio**2))), np.exp(s.min() + (grid + 1) / 2 * np.ptp(s)), ratio)


def grade_of(verdict: str, share: float) -> str:
    """``adequate`` for a refuted law that leaves a small ``share`` of the loss; else its verdict."""
    return "adequate" if verdict == "refuted" and share <= ADEQUATE else verdict


def in_words(grade: str, share: float) -> str:
    """The grade, with the share where it is one of ``adequate``; a share that is told as 0 contradicts nothing.

    >>> in_words("adequate", 0.031), in_words("adequate", 1e-5), in_words("refuted", 0.4)
    ('adequate to 3.1 % of the loss', 'consistent with the loss', 'refuted')
    """
    if grade != "adequate":
        return grade
    return f"adequate to {percent(share)} of the loss" if share >= _SEEN else "consistent with the loss"


def off(share: float) -> str:
    """By how much a damping is off, in words; never a share above the whole.

    >>> off(0.123), off(170.0)
    ('12 % off on average', 'off by more than the whole of it')
    """
    return f"{percent(share)} off on average" if share < 1 else "off by more than the whole of it"
