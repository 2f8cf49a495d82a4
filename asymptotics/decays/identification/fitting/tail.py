"""Where the fit of a pendulum from far up begins: the law of its late swings, followed backwards.

A smooth line does not follow the first swings of a pendulum that is released near the top, whose periods change by a
tenth from one to the next; a fit that begins there may end anywhere.  Its late swings are like those of other records:
a law is fitted to their turning points, and the first amplitude is that from which its motion comes to them.
"""

from dataclasses import replace
from math import log

import numpy as np
from scipy.optimize import brentq

from asymptotics.decays.identification.fitting.least_squares import fit
from asymptotics.decays.identification.fitting.model import Model, Noise
from asymptotics.decays.identification.fitting.starting import starting_values
from asymptotics.decays.identification.forward.candidates import Candidate
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.forward.sequence import turning_sequence
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.decays.records.units import UNITS

_NEAR, _LEAST, _STEP = 1.4, 6, 0.02
"""The angle in rad below which swings are late ones, how many turning points of them tell a law, and the step in ln of
the amplitude in which the first one is sought."""


def from_the_tail(candidate: Candidate, seen: Observations) -> Array | None:
    """The vector of ``Model`` for all turning points, by those below 80 degrees; None where that is not the way."""
    near = np.abs(seen.x) * UNITS.get(seen.unit, 1.0) < _NEAR
    if not candidate.pendulum or near.all() or near.sum() < _LEAST or not seen.has_times:
        return None
    first = int(np.flatnonzero(~near)[-1]) + 1
    tail = seen.since(first)
    if len(tail.n) < _LEAST:
        return None
    late = Model(candidate.swing(coarse=True), tail, pendulum=True)
    whole = Model(candidate.swing(), replace(seen, samples=None), pendulum=True)
    stated = Noise(*(float(np.sqrt(np.mean(s**2))) for s in (tail.sigma_x, tail.sigma_t)))
    try:
        theta = fit(late, starting_values(late), stated).theta
        scale = log(whole.reference / late.reference)
        weights = np.array([e.weight for e in candidate.elements])
        law = theta[late.law] * np.exp(scale * weights)
        count = int(seen.n[first])
        a = _begun(whole, law, count, float(theta[0]) - scale)
        lasts = float(turning_sequence(whole.swing, count, np.array([a, *law])).tau[-1])
    except (TooStrongError, np.linalg.LinAlgError):
        return None
    rest = [theta[late.after] if late.offset else 0.0] if whole.offset else []
    return np.array([a, *law, *rest, theta[-2], theta[-1] - np.exp(-theta[-2]) * lasts])


def _begun(model: Model, law: Array, count: int, end: float) -> float:
    """ln of the amplitude from which the motion comes to ``end`` after so many half-swings; of a law that would begin
    beyond the top, the largest that is none; TooStrongError where it does not last so long."""

    def beyond(a: float) -> float:
        return float(turning_sequence(model.swing, count, np.array([a, *law])).a[-1]) - end

    low, behind = end, beyond(end)
    while behind < 0:
        try:
            behind = beyond(low + _STEP)
        except TooStrongError:
            return low
        low += _STEP
    return float(brentq(beyond, low - _STEP, low, xtol=1e-6)) if low > end else low
