"""One law fitted to one run, or the reason why there is no fit."""

from dataclasses import replace

import numpy as np

from asymptotics.decays.identification.fitting.least_squares import Fit, fit
from asymptotics.decays.identification.fitting.model import Model, Noise
from asymptotics.decays.identification.fitting.printed import DecrementModel, Decrements, decrement_start
from asymptotics.decays.identification.fitting.starting import starting_values
from asymptotics.decays.identification.fitting.tail import from_the_tail
from asymptotics.decays.identification.fitting.waveform import WaveformModel
from asymptotics.decays.identification.forward.candidates import Candidate
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.judging.laws import Fitted
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.present.counts import many

_WEAKER = 3
"""So often a start is weakened by 0.8.  A choice."""


def fit_law(
    candidate: Candidate,
    seen: Observations,
    noise: Noise | None = None,
    *,
    coarse: bool = False,
    start: Array | None = None,
) -> Fitted:
    """The fit of one candidate; without one if the data are too few or the motion of the law ends too early."""
    if seen.samples is not None:
        return _fit_motion(candidate, seen, noise, start)
    model = Model(candidate.swing(coarse), seen, pendulum=candidate.pendulum)
    # Two data to spare: AICc divides by what is left.
    if len(model.data) < model.size + 2:
        return Fitted(candidate, None, reason=f"{len(model.data)} data for {model.size} unknowns")
    try:
        found = fit(model, starting_values(model) if start is None else start, noise)
    except (TooStrongError, np.linalg.LinAlgError) as error:
        return Fitted(candidate, None, reason=f"no fit: {error}")
    if not np.isfinite(found.aicc):
        return Fitted(candidate, found, reason=f"{len(model.data)} data for {model.size} unknowns")
    return Fitted(candidate, found)


def _fit_motion(candidate: Candidate, seen: Observations, noise: Noise | None, start: Array | None) -> Fitted:
    """The fit to all samples, from where the turning points alone lead."""
    model = WaveformModel(candidate.swing(), seen, candidate.pendulum)
    if len(model.data) < model.size + 4:
        return Fitted(candidate, None, reason=f"{many(len(model.data), 'sample')} for {model.size} unknowns")
    try:
        if start is None:
            start, late = _from_turning_points(candidate, seen), from_the_tail(candidate, seen)
            start = start if late is None else min((start, late), key=lambda each: _misfit(model, each))
        found = _fit_from(model, model.start(start), noise)
        return Fitted(candidate, found)
    except (TooStrongError, np.linalg.LinAlgError) as error:
        return Fitted(candidate, None, reason=f"no fit: {error}")


def _misfit(model: WaveformModel, start: Array) -> float:
    """What a start leaves of the samples; no number is better than one of a motion that ends."""
    try:
        left = model.data - model.predict(model.start(start))[0]
    except TooStrongError:
        return float("inf")
    return float(left @ left)


def _from_turning_points(candidate: Candidate, seen: Observations) -> Array:
    """A start: the turning points of the smooth line, by the series alone and with the errors that are stated."""
    first = Model(candidate.swing(coarse=True), replace(seen, samples=None), pendulum=candidate.pendulum)
    begin = starting_values(first)
    stated = Noise(*(float(np.sqrt(np.mean(s**2))) for s in (seen.sigma_x, seen.sigma_t)))
    try:
        return fit(first, begin, stated).theta
    except TooStrongError:
        return begin


def _fit_from(model: WaveformModel, start: Array, noise: Noise | None) -> Fit:
    """The fit; from weaker strengths where the motion of the start ends before the record does."""
    for _ in range(_WEAKER):
        try:
            return fit(model, start, noise)
        except TooStrongError:
            start = np.concatenate([start[:1], 0.8 * start[1 : 1 + len(model.swing.elements)],
                                    start[1 + len(model.swing.elements) :]])  # fmt: skip
    return fit(model, start, noise)


def fit_decrements(candidate: Candidate, table: Decrements, noise: Noise | None = None) -> Fitted:
    """The fit of one candidate to printed decrements."""
    model = DecrementModel(candidate.swing(), table)
    if len(model.data) < model.size + 1:
        return Fitted(candidate, None, reason=f"{len(model.data)} data for {model.size} unknowns")
    try:
        return Fitted(candidate, fit(model, decrement_start(model), noise))
    except (TooStrongError, np.linalg.LinAlgError) as error:
        return Fitted(candidate, None, reason=f"no fit: {error}")


def embedded(fit: Fit, law: Candidate, larger: Candidate) -> Array:
    """The parameter vector of ``larger`` at which it is the fitted ``law``."""
    strengths = dict(zip(law.elements, fit.theta[1:]))
    first = [strengths.get(e, 0.0) for e in larger.elements]
    rest = fit.theta[1 + len(law.elements) :]
    if larger.free and not law.free:
        first[0] = fit.theta[1]
        first.append(law.elements[0].velocity)
    elif law.free and not larger.free:  # the exponent leaves the vector
        first[0] = fit.theta[1]
        rest = rest[1:]
    return np.concatenate([fit.theta[:1], first, rest])
