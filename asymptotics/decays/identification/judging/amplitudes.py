"""Amplitudes without times cannot tell a nonlinear spring from a loss: how far an unseen spring can move the strengths.

A spring c x^3 changes the decrement of every loss (derivation ``ignored-spring``): viscous loss with it looks like
viscous and cubic loss.  The drift of the frequency over the record bounds c: omega falls or rises by (3/8) c A^2.
Where there are times the drift is measured from them; without times a drift is assumed, and said.
"""

from dataclasses import replace

import numpy as np

from asymptotics.decays.identification.fitting.least_squares import minimise
from asymptotics.decays.identification.fitting.model import Model
from asymptotics.decays.identification.fitting.profile import coordinate, wald_interval
from asymptotics.decays.identification.forward.candidates import Candidate
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.forward.swing import HalfSwingModel
from asymptotics.decays.identification.judging.laws import Fitted, Judged, strength
from asymptotics.decays.identification.judging.single_fits import fit_law
from asymptotics.decays.identification.measuring.observations import Observations

ASSUMED_DRIFT = 0.01
"""The relative change of frequency that is assumed when it cannot be measured: a choice, which the answer tells.  Twice
as much widens the intervals nearly twice as much, by the first-order effect of the spring."""


def spring_bound(seen: Observations) -> tuple[float, str]:
    """(bound of |c| A_0^2, where it comes from): measured from the times if there are any."""
    if seen.has_times:
        fitted = fit_law(Candidate((("1", 0),), (3,)), seen).fit
        if fitted is not None:
            # The vector is ln A_0, epsilon_1, gamma = c A_0^2: the larger end of its interval is the bound.
            found = wald_interval(fitted, coordinate(2), kind="t")
            bound = max(abs(found.low or 0.0), abs(found.high or 0.0))
            return bound, f"the times show a drift of at most {3 / 8 * bound:.2g} of the frequency"
    # omega moves by (3/8) c A^2.
    return 8 / 3 * ASSUMED_DRIFT, f"no times: a drift of {ASSUMED_DRIFT:g} of the frequency is assumed"


def relieved(law: Fitted, bound: float) -> Fitted:
    """The law with the share of its sum of squares that a cubic spring of at most this size would leave.

    In between, the sum of squares is a parabola in the spring: three values give its least.
    """
    if law.fit is None:
        return law
    low, high = (_with_spring(law, sign * bound) for sign in (-1.0, 1.0))
    if low is None or high is None:
        return law
    middle = law.fit.chi2
    bend = low[1] + high[1] - 2 * middle
    # The vertex of the parabola through -1, 0 and 1, if it has one between them.
    place = float(np.clip((low[1] - high[1]) / (2 * bend), -1, 1)) if bend > 0 else 0.0
    parabola = middle + place * (high[1] - low[1]) / 2 + place**2 * bend / 2
    least = max(min(low[1], high[1], parabola), 0.0)
    return replace(law, left=min(least / middle, 1.0) if middle > 0 else 1.0)


def widened(law: Judged, bound: float) -> Judged:
    """The intervals, longer by what a cubic spring of either sign and of this size would move the estimates."""
    if law.fit is None or not law.epsilon:
        return law
    moved = [_with_spring(law, sign * bound) for sign in (-1.0, 1.0)]
    known = [m[0] for m in moved if m is not None]
    if not known:
        return law
    at_zero = np.array([e.estimate for e in law.epsilon])
    # Both signs: the intervals move to the side to which the spring would move the estimates, each by its largest
    # shift.
    shifts = np.stack(known) - at_zero
    below, above = -np.minimum(shifts.min(axis=0), 0), np.maximum(shifts.max(axis=0), 0)
    moved_ends = tuple(e.widened(float(b), float(a)) for e, b, a in zip(law.epsilon, below, above))
    return replace(law, intervals=replace(law.intervals, epsilon=moved_ends))


def _with_spring(law: Fitted | Judged, gamma: float) -> tuple[Array, float] | None:
    """The strengths refitted with a cubic spring held at c A_ref^2 = gamma, and the weighted sum of squares."""
    assert law.fit is not None
    old, candidate = law.fit.model, law.candidate
    # A law with this spring has no unseen one.
    if 3 in candidate.springs:
        return None
    larger = Candidate(candidate.losses, (*candidate.springs, 3))
    model = Model(HalfSwingModel(larger.elements, larger.free), old.seen, old.offset)
    model.swing.tolerance = old.swing.tolerance
    place = len(larger.elements)
    theta = np.insert(law.fit.theta, place, gamma)

    def held(at: Array) -> tuple[float, Array]:
        gradient = np.zeros(len(at))
        # One residual that holds the spring: 1e8 standard errors for a unit, so that it moves by nothing that matters.
        gradient[place] = 1e8
        return (float(at[place]) - gamma) * 1e8, gradient

    try:
        theta, _ = minimise(model, theta, law.fit.scales, held)
        r = (model.data - model.predict(theta)[0]) / model.scale_vector(law.fit.scales)
    except TooStrongError:
        return None
    reference = old.seen.reference
    strengths = [strength(larger, i, reference)(theta)[0] for i in range(len(candidate.losses))]
    return np.array(strengths), float(r @ r)
