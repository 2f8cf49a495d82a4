"""One law against one run: its fit, the intervals of its strengths, and how it predicts swings it has not seen."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from asymptotics.identification.candidates import Candidate
from asymptotics.identification.coefficients import Array
from asymptotics.identification.fitting import Fit, Model, Noise, fit
from asymptotics.identification.observations import Observations
from asymptotics.identification.printed import DecrementModel, Decrements, decrement_start
from asymptotics.identification.profile import Function, Interval, coordinate, profile_interval, wald_interval
from asymptotics.identification.quadrature import TooStrongError
from asymptotics.identification.starting import starting_values

SUPPORT = 10.0
"""A law whose AICc is larger than the smallest by more than this has essentially no support (a factor e^5)."""
_ALWAYS, _MARGIN = 6, 40.0
_PROFILED = 8


@dataclass(frozen=True)
class LawFit:
    """A candidate with its fit; ``reason`` says why there is none, or why the law is judged as it is."""

    candidate: Candidate
    fit: Fit | None
    verdict: str = "undetermined"
    reason: str = ""
    excess: float = float("inf")
    epsilon: tuple[Interval, ...] = ()
    springs: tuple[Interval, ...] = ()
    alpha: Interval | None = None
    profiled: bool = False
    held_out: float | None = None
    total: float | None = None

    @property
    def criterion(self) -> float:
        """AICc (of several runs: their sum); infinite without a fit."""
        if self.total is not None:
            return self.total
        return float("inf") if self.fit is None else self.fit.aicc

    def judged_as(self, verdict: str, reason: str, excess: float) -> "LawFit":
        """The same law, judged."""
        return replace(self, verdict=verdict, reason=reason, excess=excess)

    @property
    def terms(self) -> int:
        """How many terms the law has."""
        return len(self.candidate.elements)

    @property
    def negative(self) -> tuple[str, ...]:
        """The losses whose estimate is negative: unphysical, but not clipped."""
        return tuple(a for a, e in zip(self.candidate.alphas, self.epsilon) if e.estimate < 0)


def fit_laws(candidates: Sequence[Candidate], seen: Observations, noise: Noise | None = None) -> list[LawFit]:
    """All candidates: a coarse fit of each, by the series alone, then the full one of each that could have support."""
    fits = [fit_law(c, seen, noise, coarse=True) for c in candidates]
    order = sorted(range(len(fits)), key=lambda i: fits[i].criterion)
    least = float("inf")
    for rank, i in enumerate(order):
        if rank < _ALWAYS or fits[i].criterion < least + SUPPORT + _MARGIN or least == float("inf"):
            fits[i] = fit_law(candidates[i], seen, noise, start=fits[i].fit)
            least = min(least, fits[i].criterion)
    return fits


def fit_law(
    candidate: Candidate,
    seen: Observations,
    noise: Noise | None = None,
    *,
    coarse: bool = False,
    start: Fit | None = None,
) -> LawFit:
    """The fit of one candidate; without one if the data are too few or the motion of the law ends too early."""
    model = Model(candidate.swing(coarse), seen)
    if len(model.data) < model.size + 2:
        return LawFit(candidate, None, reason=f"{len(model.data)} data for {model.size} unknowns")
    try:
        found = fit(model, starting_values(model) if start is None else start.theta, noise)
    except (TooStrongError, np.linalg.LinAlgError) as error:
        return LawFit(candidate, None, "refuted", f"no fit: {error}")
    if not np.isfinite(found.aicc):
        return LawFit(candidate, found, reason=f"{len(model.data)} data for {model.size} unknowns")
    return LawFit(candidate, found)


def fit_decrements(candidate: Candidate, table: Decrements, noise: Noise | None = None) -> LawFit:
    """The fit of one candidate to printed decrements."""
    model = DecrementModel(candidate.swing(), table)
    if len(model.data) < model.size + 1:
        return LawFit(candidate, None, reason=f"{len(model.data)} data for {model.size} unknowns")
    try:
        return LawFit(candidate, fit(model, decrement_start(model), noise))
    except (TooStrongError, np.linalg.LinAlgError) as error:
        return LawFit(candidate, None, "refuted", f"no fit: {error}")


def judged(fits: Sequence[LawFit], growing: bool, everything: bool = False) -> list[LawFit]:
    """Verdicts by AICc, and intervals: by profile likelihood for the laws that matter (or all), else by curvature."""
    least = min((f.criterion for f in fits), default=float("inf"))
    found = [_judged(f, least, growing) for f in fits]
    supported = sorted((f for f in found if f.excess <= SUPPORT), key=lambda f: f.criterion)
    chosen = found if everything else [*minimal(found), *supported][:_PROFILED]
    matter = {f.candidate for f in chosen if np.isfinite(f.criterion)}
    return [_profiled(f, growing) if f.candidate in matter else f for f in found]


def _profiled(law: LawFit, growing: bool) -> LawFit:
    assert law.fit is not None
    found = _with_intervals(law, law.fit, profiled=True)
    if law.excess > SUPPORT and any(e.low is None or e.high is None for e in found.epsilon):
        return law  # far from the data the profile may leave the model's domain: the curvature serves
    return verdict_by_intervals(found, growing)


def _judged(law: LawFit, least: float, growing: bool) -> LawFit:
    if law.fit is None or not np.isfinite(law.criterion):
        return law
    rough = _with_intervals(law, law.fit, profiled=False)
    return verdict_by_intervals(replace(rough, excess=law.criterion - least), growing)


def verdict_by_intervals(law: LawFit, growing: bool) -> LawFit:
    """The law with its verdict: by AICc first, then by the signs of its strengths."""
    if law.excess > SUPPORT:
        return replace(law, verdict="refuted", reason=f"AICc exceeds the smallest by {law.excess:.4g}")
    negative = [a for a, e in zip(law.candidate.alphas, law.epsilon) if is_negative(e)]
    if negative and not growing:
        return replace(law, verdict="refuted", reason=f"unphysical: the strength of {', '.join(negative)} is negative")
    if all(e.low is None and e.high is None for e in law.epsilon):
        return replace(law, verdict="undetermined", reason="the data set no limit to its strengths")
    return replace(law, verdict="consistent", reason="")


def is_negative(strength: Interval) -> bool:
    """Whether a strength is negative beyond doubt: 0 lies outside the interval stretched to twice its length."""
    high = strength.stretched(2.0).high
    return high is not None and high < 0


def strength(candidate: Candidate, index: int, reference: float, first: int = 1) -> Function:
    """epsilon_i = s_i A_ref^(-w_i) as a function of the parameter vector, for x0 = 1 unit of the file.

    ``first``: where the law begins in the vector.
    """
    if not (candidate.free and index == 0):
        return coordinate(first + index, reference ** -candidate.elements[index].weight)
    place = first + len(candidate.elements)

    def g(theta: Array) -> tuple[float, Array]:
        factor = reference ** (1 - theta[place])
        gradient = np.zeros(len(theta))
        gradient[first], gradient[place] = factor, -np.log(reference) * factor * theta[first]
        return float(theta[first] * factor), gradient

    return g


def _with_intervals(law: LawFit, found: Fit, profiled: bool) -> LawFit:
    candidate, reference = law.candidate, found.model.seen.reference
    clock = next((k for k in ("passage", "t") if k in found.model.kinds), "x")
    interval = profile_interval if profiled else wald_interval
    losses = len(candidate.losses)
    kinds = ["x"] * losses + [clock] * len(candidate.springs)
    first = found.model.law.start
    ends = [interval(found, strength(candidate, i, reference, first), kind=kind) for i, kind in enumerate(kinds)]
    alpha = None
    if candidate.free:
        alpha = _within_range(interval(found, coordinate(first + len(candidate.elements)), kind="x"))
    return replace(law, epsilon=tuple(ends[:losses]), springs=tuple(ends[losses:]), alpha=alpha, profiled=profiled)


def _within_range(alpha: Interval) -> Interval:
    return Interval(0.0 if alpha.low is None else max(alpha.low, 0.0), alpha.estimate, alpha.high)


def predicted_error(law: LawFit, seen: Observations, share: float = 2 / 3) -> float | None:
    """Fit the first ``share`` of the swings, predict the amplitudes of the rest: rms error over the noise.

    None if the first part does not determine the law.
    """
    if law.fit is None:
        return None
    early = seen.up_to(int(share * seen.last))
    first = fit_law(law.candidate, early)
    if first.fit is None:
        return None
    model = Model(first.fit.model.swing, seen, first.fit.model.offset)
    late = np.flatnonzero(seen.n > early.last)
    try:
        predicted, _ = model.predict(first.fit.theta)
    except TooStrongError:
        return None
    return float(np.sqrt(np.mean((seen.x - predicted[: len(seen.x)])[late] ** 2)) / law.fit.scales["x"])


def contains(larger: LawFit, smaller: LawFit) -> bool:
    """Whether ``smaller`` is a special case of ``larger``."""
    if smaller.candidate.is_within(larger.candidate):
        return True
    one = smaller.candidate
    if larger.candidate.free and not one.free and len(one.losses) == 1 and one.losses[0][1] == 0:
        inside = larger.alpha is not None and larger.alpha.stretched(2.0).contains(one.elements[0].velocity)
        return inside and set(one.springs) <= set(larger.candidate.springs)
    return False


def minimal(fits: Sequence[LawFit]) -> list[LawFit]:
    """The consistent laws that contain no other consistent law, best first."""
    consistent = [f for f in fits if f.verdict == "consistent"]
    kept = [f for f in consistent if not any(contains(f, g) for g in consistent)]
    return sorted(kept, key=lambda f: f.criterion)
