"""How good an order is: its error against the reference motion, as kappa falls, and the order that the errors show.

For X(0) = 1 at rest, sup |X_N - X_ref| is taken over a grid of 0 <= tau <= 1/kappa (for alpha < 1 over tau <=
min(1/kappa, 0.8/((1-alpha) kappa)), short of the fictitious extinction).  On that time the error of order N should fall
like kappa^N: the first neglected term of the slow equations, of relative order kappa^(N+1), acts for 1/kappa, and
the first neglected term of the waveform is of order kappa^N.  All of this is measured, nothing is proved.

>>> first, second = measured_errors(["2"], (1, 2), kappas=(Fraction(1, 5), Fraction(1, 10)), points=4)
>>> 0.6 < first.fitted_order < 1.4, second.fitted_order > 1.9
(True, True)
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import log
from typing import Any

import numpy as np

from asymptotics.expansions.moments.certified import moment
from asymptotics.law import Oscillator
from asymptotics.motions.asymptotic import AsymptoticMotion
from asymptotics.motions.reference import reference_motion, reference_states
from asymptotics.numbers.exact import ExactReal, parse_real

KAPPAS = (Fraction(1, 5), Fraction(1, 10), Fraction(1, 20), Fraction(1, 40))
_DIGITS = 12


@dataclass(frozen=True)
class MeasuredErrors:
    """sup |X_N - X_ref| at each kappa, and the slope of log error against log kappa (least squares)."""

    alphas: tuple[str, ...]
    order: int
    kappas: tuple[Fraction, ...]
    errors: tuple[float, ...]

    @property
    def fitted_order(self) -> float:
        """The measured order; nan if an error is no larger than the digits compared (the order is exact then)."""
        if min(self.errors) < 10 * 10.0**-_DIGITS:
            return float("nan")
        slope, _ = np.polyfit([log(k) for k in self.kappas], [log(e) for e in self.errors], 1)
        return float(slope)


def measured_errors(
    alphas: Sequence[str], orders: Sequence[int], kappas: Sequence[Fraction] = KAPPAS, points: int = 30
) -> tuple[MeasuredErrors, ...]:
    """The errors of each order for a law, or a sum whose terms share kappa equally, at ``points`` times."""
    columns = [_sup_errors(alphas, orders, kappa, points) for kappa in kappas]
    return tuple(
        MeasuredErrors(tuple(alphas), order, tuple(kappas), tuple(column[i] for column in columns))
        for i, order in enumerate(orders)
    )


def _sup_errors(alphas: Sequence[str], orders: Sequence[int], kappa: Fraction, points: int) -> list[float]:
    oscillator = unit_oscillator(alphas, kappa)
    times = [horizon(alphas, kappa) * k / points for k in range(1, points + 1)]
    exact = _reference(oscillator, times)
    at = np.array([float(t) for t in times])
    return [float(np.max(np.abs(AsymptoticMotion.of(oscillator, n).sample(at).x - exact))) for n in orders]


def _reference(oscillator: Oscillator, times: Sequence[Fraction]) -> Any:
    """X_ref at all times: from the exact solution if there is one, else from one integration for all of them."""
    if oscillator.law.integer_alphas in ((0,), (1,), (2,)):
        texts = [reference_motion(oscillator, t, _DIGITS).x for t in times]
        return np.array([float(parse_real(x, "x").rational) for x in texts])
    states = reference_states(oscillator, [ExactReal(t) for t in times], _DIGITS)
    return np.array([float(x.mid()) for x in states.x])


def unit_oscillator(alphas: Sequence[str], kappa: Fraction) -> Oscillator:
    """m = k = x0 = 1 with sum kappa_i = kappa; epsilon_i = kappa_i / M_(alpha_i+1), rounded to a rational."""
    share = kappa / len(alphas)
    strengths = {a: share * Fraction(1 / _moment(a)).limit_denominator(10**9) for a in alphas}
    return Oscillator(strengths)


def _moment(alpha: str) -> float:
    return float(moment(parse_real(alpha, "alpha").ball() + 1).mid())


def horizon(alphas: Sequence[str], kappa: Fraction) -> Fraction:
    """The end of the time interval of the module's docstring."""
    lowest = min(parse_real(a, "alpha") for a in alphas)
    if not lowest < 1:
        return 1 / kappa
    return min(1 / kappa, Fraction(4, 5) / ((1 - Fraction(lowest.rational)) * kappa))
