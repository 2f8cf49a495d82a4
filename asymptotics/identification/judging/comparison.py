"""All candidates fitted to one run, and how one of them predicts swings it has not seen."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from asymptotics.budget import tick
from asymptotics.identification.fitting.in_time import ALL, Time
from asymptotics.identification.fitting.least_squares import Fit, Model, Noise, fit
from asymptotics.identification.fitting.printed import DecrementModel, Decrements, decrement_start
from asymptotics.identification.fitting.starting import starting_values
from asymptotics.identification.fitting.waveform import WaveformModel
from asymptotics.identification.forward.candidates import Candidate
from asymptotics.identification.forward.coefficients import Array
from asymptotics.identification.forward.quadrature import TooStrongError
from asymptotics.identification.judging.contradiction import further_parameters
from asymptotics.identification.judging.laws import Fitted
from asymptotics.identification.measuring.observations import Observations

_ALWAYS, _MARGIN, _WORSE = 6, 50.0, 1e-3
"""The best six of the first look are always fitted, for a coarse look may misjudge them; further laws up to 50 of AICc
above the best, for e^-25 is no rival; log-likelihoods are alike within 1e-3, by which two runs of the minimiser may
differ.  These are choices, not measurements: they decide which law is tried to its end, never its verdict."""
_MANY, _FAR, _WEAKER = 6, 10.0, 3
"""So many laws of one spring are worth a look at the largest first; so many margins from the best are far; so often a
start is weakened by 0.8.  Choices, as those above."""
_SHARE = 0.2
"""Of the time that is left, what one fit may take."""
UNTRIED = "not tried to its end: the time was over"


def fit_laws(
    candidates: Sequence[Candidate], seen: Observations, noise: Noise | None = None, time: Time = ALL
) -> list[Fitted]:
    """All candidates, from few parameters to many, each with a share of the time: a coarse fit, by the series alone,
    then the full one of each that could have support.

    A coarse fit is left as it is only if it is far from the best and what its series neglects is small beside its
    residuals.  A law that fits worse than one it contains has missed its optimum and starts again from there.  What
    the time does not suffice for has no fit, and says so.
    """
    fits = [Fitted(c, None, reason=UNTRIED) for c in candidates]
    half, points, look, first = time.part(0.5), seen, noise, first_of_families(candidates)  # half for the first look
    if seen.samples is not None:
        points, look = (
            replace(seen, samples=None),
            # Of samples the turning points are made up: their stated errors weigh the first look.
            Noise(*(float(np.sqrt(np.mean(s**2))) for s in (seen.sigma_x, seen.sigma_t))),
        )
    for i in sorted(range(len(fits)), key=lambda i: (candidates[i] not in first, fits[i].parameters)):
        far = _beyond_hope(candidates[i], fits, first)
        if far:
            fits[i] = Fitted(candidates[i], None, far=True, reason=far)
            continue
        tick(f"the first look at the law {candidates[i]}")
        fits[i] = half.within(_SHARE, partial(fit_law, candidates[i], points, look, coarse=True), fits[i])
    order, least = sorted(range(len(fits)), key=lambda i: fits[i].criterion), float("inf")
    margin = _margin(fits)
    for rank, i in enumerate(order):
        rough = fits[i]
        if rough.far:  # beyond hope already
            continue
        if rank < _ALWAYS or rough.criterion < least + margin or not _is_good(rough.fit):
            tick(f"the law {candidates[i]}; the best at the first look: {candidates[order[0]]}")
            work = partial(fit_law, candidates[i], seen, noise, start=None if rough.fit is None else rough.fit.theta)
            kept = rough if _is_good(rough.fit) and points is seen else Fitted(candidates[i], None, reason=UNTRIED)
            fits[i] = time.within(_SHARE, work, kept)
            least = min(least, (fits[i] if points is seen else rough).criterion)
        elif points is not seen:
            reason = f"far from the data at the first look (AICc {rough.criterion - least:.3g} above the best)"
            fits[i] = Fitted(candidates[i], None, far=True, reason=reason)
    fits = _nested(_reconsidered(fits, seen, noise, time), seen, noise, time)
    return fits


def _reconsidered(fits: Sequence[Fitted], seen: Observations, noise: Noise | None, time: Time) -> list[Fitted]:
    """The same fits, with those that the first look left out although a law that contains them hardly needs its
    further terms: their strengths are 0 within ``_MARGIN`` of chi-squared."""
    found = list(fits)
    for i in sorted(range(len(found)), key=lambda i: -found[i].parameters):
        if not found[i].far:
            continue
        least = min((law.criterion for law in found), default=float("inf"))
        near = [law for law in found if law.usable and law.criterion < least + _MARGIN]
        for law in near:
            if law.fit is not None and found[i].candidate.is_within(law.candidate) and _dispensable(law, found[i]):
                start = _embedded(law.fit, law.candidate, found[i].candidate)
                work = partial(fit_law, found[i].candidate, seen, noise, start=start)
                found[i] = time.within(_SHARE, work, Fitted(found[i].candidate, None, reason=UNTRIED))
                break
    return found


def _dispensable(larger: Fitted, law: Fitted) -> bool:
    assert larger.fit is not None
    first = larger.fit.model.law.start
    further = [first + k for k, e in enumerate(larger.candidate.elements) if e not in law.candidate.elements]
    strengths, covariance = larger.fit.theta[further], larger.fit.covariance[np.ix_(further, further)]
    return float(strengths @ np.linalg.pinv(covariance) @ strengths) < _MARGIN  # Wald's chi-squared of 0


def _margin(fits: Sequence[Fitted]) -> float:
    """How far from the best a law is far: farther where the best itself leaves more than the noise that is stated."""
    best = min((law for law in fits if law.fit is not None), key=lambda law: law.criterion, default=None)
    if best is None or best.fit is None or not best.fit.known:
        return _MARGIN
    return _MARGIN * max(best.fit.chi2 / max(best.fit.freedom, 1), 1.0)


def first_of_families(candidates: Sequence[Candidate]) -> dict[Candidate, list[Candidate]]:
    """The law of a spring (or the pendulum) that contains the others with it, where they are many, with those; and
    the smallest ones, which show whether the fit of the largest can be trusted."""
    families: dict[tuple[tuple[int, ...], bool], list[Candidate]] = {}
    for candidate in candidates:
        families.setdefault((candidate.springs, candidate.pendulum), []).append(candidate)
    found: dict[Candidate, list[Candidate]] = {}
    for family in families.values():
        largest = max(family, key=lambda c: len(c.losses))
        inside = [c for c in family if c.is_within(largest)]
        if len(inside) >= _MANY:
            found[largest] = inside
            found |= {c: [] for c in inside if len(c.losses) == 1}
    return found


def _beyond_hope(candidate: Candidate, fits: Sequence[Fitted], first: Mapping[Candidate, Sequence[Candidate]]) -> str:
    """Why a law needs no look: the one that contains it is far from the data, and no worse than what it contains."""
    if candidate in first:
        return ""
    looked = {law.candidate: law for law in fits if law.fit is not None and law.candidate in first}
    least = min((law.criterion for law in looked.values()), default=float("inf"))
    for largest, inside in first.items():
        head = looked.get(largest)
        if head is None or candidate not in inside or not _is_good(head.fit):
            continue
        # A law that contains another fits at least as well; where it does not, the minimiser failed, and nothing
        # follows.
        trusted = all(head.likelihood >= looked[c].likelihood - _WORSE for c in inside if c in looked)
        if trusted and -2 * head.likelihood > least + _FAR * _margin(fits):
            # The deviance of the largest law is below that of each law inside it, and so below the AICc of each.
            beyond = -2 * head.likelihood - least
            return (
                f"far from the data at the first look: so is {largest}, which contains it ({beyond:.3g} above the best)"
            )
    return ""


def _nested(fits: Sequence[Fitted], seen: Observations, noise: Noise | None, time: Time) -> list[Fitted]:
    """The same fits, none worse than that of a law it contains."""
    found = list(fits)
    for i in sorted(range(len(found)), key=lambda i: found[i].parameters):
        if found[i].reason == UNTRIED or found[i].far:
            continue
        inside = [law for law in found if law.usable and further_parameters(law.candidate, found[i].candidate) == 0]
        best = max((law for law in inside if law.fit), key=lambda law: law.likelihood, default=found[i])
        if best.fit is not None and best.likelihood > found[i].likelihood + _WORSE:
            start, coarse = _embedded(best.fit, best.candidate, found[i].candidate), best.fit.model.swing.coarse
            work = partial(fit_law, found[i].candidate, seen, noise, coarse=coarse, start=start)
            missed = Fitted(found[i].candidate, None, reason=UNTRIED)
            found[i] = max(found[i], time.within(_SHARE, work, missed), key=lambda law: law.likelihood)
    return found


def _embedded(fit: Fit, law: Candidate, larger: Candidate) -> Array:
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


def _is_good(found: Fit | None) -> bool:
    """Whether what the series of a coarse fit neglects is small beside the residuals it leaves."""
    if found is None:
        return False
    return found.model.neglected(found.theta) < found.scales["x"] / found.model.seen.reference


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
        return Fitted(candidate, None, reason=f"{len(model.data)} samples for {model.size} unknowns")
    try:
        if start is None:
            first = Model(candidate.swing(), replace(seen, samples=None), pendulum=candidate.pendulum)
            start = fit(first, starting_values(first)).theta
        return Fitted(candidate, _fit_from(model, model.start(start), noise))
    except (TooStrongError, np.linalg.LinAlgError) as error:
        return Fitted(candidate, None, reason=f"no fit: {error}")


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


def predicted_error(law: Fitted, seen: Observations, share: float = 2 / 3) -> float | None:
    """Fit the first ``share`` of the swings, predict the amplitudes of the rest: rms error over the noise.

    None if the first part does not determine the law.
    """
    if law.fit is None or seen.samples is not None:
        return None
    early = seen.up_to(int(share * seen.last))
    first = fit_law(law.candidate, early)
    if first.fit is None:
        return None
    model = Model(first.fit.model.swing, seen, first.fit.model.offset, law.candidate.pendulum)
    late = np.flatnonzero(seen.n > early.last)  # what the fit has not seen
    try:
        predicted, _ = model.predict(first.fit.theta)
    except TooStrongError:
        return None
    return float(np.sqrt(np.mean((seen.x - predicted[: len(seen.x)])[late] ** 2)) / law.fit.scales["x"])
