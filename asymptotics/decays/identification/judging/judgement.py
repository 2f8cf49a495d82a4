"""Each law against the data and against the others: consistent, refuted, or undetermined.

*Refuted* means that the data contradict the law: its residuals exceed the noise, or another law with no negative loss
explains the data better than chance allows, or one of its strengths is negative beyond doubt.  A law that contains a
consistent law and is not contradicted itself is *consistent* too, and the answer says which of its terms are not
needed.  *Undetermined*: the data set no limit to its strengths, or it could not be fitted.
"""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from asymptotics.decays.identification.fitting.correlation import is_correlated, replicas, stretch
from asymptotics.decays.identification.fitting.least_squares import Fit
from asymptotics.decays.identification.fitting.profile import Interval, profile_interval, wald_interval
from asymptotics.decays.identification.fitting.waveform import WaveformModel
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.forward.work import ALL, Work
from asymptotics.decays.identification.judging.adequacy import Levels, adequate
from asymptotics.decays.identification.judging.contradiction import (
    REFUTED,
    Contradiction,
    contradiction,
    further_parameters,
)
from asymptotics.decays.identification.judging.grades import unexplained
from asymptotics.decays.identification.judging.laws import UNTRIED, Evidence, Fitted, Intervals, Judged
from asymptotics.running.budget import tick

_PROFILED = FEW = 8
"""So many candidates get profile likelihoods all, whether the data support them or not; of more, the laws of the
verdict: a matter of work, and of the shape of their intervals, which by curvature are symmetric."""
_BEYOND, _BEFORE = 1.5, 3.0
"""By how much the amplitudes of a fit may exceed the data within the record (few samples miss the peaks), and in the
half swing before the first of them.  Choices.  What a base line that wanders has still beside the right law is less
than what was taken off, in 40 decays with an unquiet tail by a factor of 2 to 100; wrong laws have had six times it."""
_DISFAVOURED = 1e-2
"""A law with more parameters, not refuted but less probable than this beside a simpler one, is not its rival.  A choice
between the level of an interval and that of a refutation; such a law is named beside the verdict."""


def judged(
    fits: Sequence[Fitted], levels: Levels, *, growing: bool = False, bootstrap: bool = False, work: Work = ALL
) -> list[Judged]:
    """Verdicts and intervals: by profile likelihood for the laws that matter (or all, if few), else by curvature, as
    where the limit of work or time is reached."""
    found = [_measured(law, levels, bootstrap) for law in fits]
    least = min((law.criterion for law in found), default=float("inf"))
    found = [replace(law, excess=law.criterion - least) if law.usable else law for law in found]
    # First intervals and signs, for only a law without a negative loss may refute another.
    found = [law.with_evidence(against=worst(law, found, growing)) for law in found]
    rough = [labelled(law, growing) for law in found]
    # The laws of the verdict; where few are asked for, all of them.
    order = rough if len(rough) <= FEW else minimal(rough)
    matter = [law.candidate for law in order if law.usable][:_PROFILED]
    profiled = {law.candidate: law for law in rough}
    for candidate in matter:
        tick(f"the intervals of the law {candidate}")
        law = profiled[candidate]
        cut_off = replace(law, fitted=replace(law.fitted, reason=UNTRIED))
        profiled[candidate] = work.within(partial(_profiled, law), cut_off)
    # A profile may hold 0, or exclude it, where the curvature did not: the verdicts are made again.
    return relabelled([profiled[law.candidate] for law in rough], growing)


def _measured(law: Fitted, levels: Levels, bootstrap: bool) -> Judged:
    """Intervals by curvature, whether the residuals are noise, and how much their memory stretches intervals."""
    if law.fit is None or not law.usable:
        return Judged.of(law)
    good, said = adequate(law.fit, levels, law.left)
    stretches: tuple[float, ...] = ()
    if bootstrap and is_correlated(law.fit):
        # One set of draws for all strengths of the law.
        drawn = replicas(law.fit)
        stretches = tuple(stretch(law.fit, g, drawn) for g in law.functions)
    evidence = Evidence(
        residuals=said, misfit="" if good else said, unexplained=unexplained(law.fit), outside=outside(law.fit)
    )
    return Judged(law, _intervals(law, stretches, profiled=False), evidence)


def outside(fit: Fit) -> str:
    """That a fit has amplitudes which no datum reaches, in words: it has found another motion, and is no result."""
    model, seen = fit.model, fit.model.seen
    if not model.alternating:
        return ""
    largest = float(np.abs(seen.x - fit.rest)[seen.inside].max())
    if seen.samples is not None and seen.samples.derivative == 0:
        # The smooth line may be wild too: the motion itself goes up and down by twice its amplitude.
        largest = min(largest, float(np.ptp(seen.samples.x)) / 2)
    size = model.amplitudes(fit.theta)[0][seen.n]
    within, before = float((size * _shown(fit))[seen.inside].max()), float(size.max())
    if within > _BEYOND * largest or before > _BEFORE * largest:
        return f"its amplitude, {before:.3g}, is far outside the data ({largest:.3g})"
    return _base_outside(fit)


def _base_outside(fit: Fit) -> str:
    """That the base line beside a law wanders by more than the record's, in words: it has taken up the motion."""
    model = fit.model
    if not isinstance(model, WaveformModel) or model.samples.slow is None:
        return ""
    t, base = model.samples.t, model.base_line(fit.theta)
    size = float(np.abs(base - np.polynomial.Polynomial.fit(t, base, 1)(t)).max())
    known = model.samples.wander
    return f"its base line, {size:.3g}, is none of the record's ({known:.3g})" if size > _BEFORE * known else ""


def _shown(fit: Fit) -> Array:
    """The share of each amplitude that the nearest sample shows, a cosine: clipped peaks and peaks in gaps are told by
    what is left of their swing, of which a third is asked for."""
    seen = fit.model.seen
    if seen.samples is None or seen.samples.derivative:
        return np.ones(len(seen.n))
    t, times = seen.samples.t, fit.model.turning_times(fit.theta)[seen.n]
    after = np.clip(np.searchsorted(t, times), 1, len(t) - 1)
    nearest = np.minimum(np.abs(t[after] - times), np.abs(t[after - 1] - times))
    angle = np.pi * nearest / float(np.median(np.diff(times)))
    return np.asarray(np.maximum(np.cos(np.minimum(angle, np.pi / 2)), 1 / _BEFORE))


def _intervals(law: Fitted, stretches: tuple[float, ...], *, profiled: bool) -> Intervals:
    """The intervals of the strengths and of the exponent, by profile likelihood or by curvature."""
    fit = law.fit
    assert fit is not None
    losses, terms = len(law.candidate.losses), law.terms
    # Springs are seen in the times, best in the passages: Student's t has the freedom of those.
    clock = next((k for k in ("passage", "t") if k in fit.model.kinds), "x")
    interval = profile_interval if profiled else wald_interval
    kinds = ["x"] * losses + [clock] * len(law.candidate.springs) + ["x"] * law.candidate.free
    ends = [interval(fit, g, kind=kind) for g, kind in zip(law.functions, kinds, strict=True)]
    if stretches:
        ends = [e.stretched(by) for e, by in zip(ends, stretches, strict=True)]
    alpha = _within_range(ends[terms]) if law.candidate.free else None
    return Intervals(tuple(ends[:losses]), tuple(ends[losses:terms]), alpha, profiled, stretches)


def _within_range(alpha: Interval) -> Interval:
    return Interval(0.0 if alpha.low is None else max(alpha.low, 0.0), alpha.estimate, alpha.high)


def worst(law: Judged, others: Sequence[Judged], growing: bool = False) -> Contradiction:
    """The physically admissible law that contradicts ``law`` most: a loss that feeds a decay refutes nothing."""
    rivals = (other for other in others if other.candidate != law.candidate and _admissible(other, growing))
    found = (against(law, other) for other in rivals)
    return min(found, key=lambda c: c.p, default=Contradiction())


def _admissible(law: Judged, growing: bool) -> bool:
    return (growing or not law.negative) and not law.evidence.outside


def against(law: Judged, other: Judged) -> Contradiction:
    """How far ``other`` contradicts ``law``; not at all if one of them has no fit."""
    if law.fit is None or other.fit is None or not (law.usable and other.usable):
        return Contradiction()
    return contradiction(law.candidate, law.fit, other.candidate, other.fit, other.inflation, law.fitted.left)


def _profiled(law: Judged) -> Judged:
    found = replace(law, intervals=_intervals(law.fitted, law.intervals.stretches, profiled=True))
    if law.verdict == "refuted" and any(e.low is None or e.high is None for e in found.epsilon):
        return law  # far from the data the profile may leave the model's domain: the curvature serves
    return found


def labelled(law: Judged, growing: bool) -> Judged:
    """The law with its verdict and the reason for it."""
    if not law.usable:
        return law
    if law.untried:
        return law.judged_as("undetermined", UNTRIED)
    # In this order: what other laws say, what the residuals say, what physics says, what the data leave open.
    if law.evidence.against.p < REFUTED:
        return law.judged_as("refuted", str(law.evidence.against))
    if law.evidence.misfit:
        return law.judged_as("refuted", f"its residuals are not independent noise: {law.evidence.misfit}")
    negative = [a for a, e in zip(law.candidate.alphas, law.epsilon) if is_negative(e)]
    if negative and not growing:
        return law.judged_as("refuted", f"unphysical: the strength of {', '.join(negative)} is negative")
    if law.evidence.outside:
        return law.judged_as("undetermined", law.evidence.outside)
    if all(e.low is None and e.high is None for e in law.epsilon):
        return law.judged_as("undetermined", "the data set no limit to its strengths")
    return law.judged_as("consistent", "")


def relabelled(laws: Sequence[Judged], growing: bool) -> list[Judged]:
    """The verdicts once more, after the intervals have changed."""
    found = [labelled(law, growing) for law in laws]
    return commented([_beside_better(law, found, growing) for law in found])


def _beside_better(law: Judged, laws: Sequence[Judged], growing: bool) -> Judged:
    """No law is consistent because it hides a disturbance in a worse fit: where a better law is refuted for nothing but
    its residuals, that are no independent noise, the disturbance is none of the loss and this law has it too."""
    if law.verdict != "consistent":
        return law
    for other in laws:
        alone = other.usable and bool(other.evidence.misfit) and other.evidence.against.p >= REFUTED
        if alone and _admissible(other, growing) and other.criterion < law.criterion and not contains(other, law):
            reason = f"{other.candidate} explains the data better, and leaves what is no independent noise"
            return law.judged_as("refuted", f"{reason}: {other.evidence.misfit}")
    return law


def is_negative(strength: Interval) -> bool:
    """Whether a strength is negative beyond doubt: 0 lies outside the interval stretched to twice its length."""
    # Twice the 95 % interval is about four standard errors: a true strength near 0 is hardly ever refuted by its sign.
    high = strength.stretched(2.0).high
    return high is not None and high < 0


def contains(larger: Judged, smaller: Judged) -> bool:
    """Whether ``smaller`` is a special case of ``larger``.

    sin x = x - x^3/6 + x^5/120 - ... has no coefficient to find: a spring x + c3 x^3 with c3 free contains the pendulum
    where the data do not tell them apart, as a free exponent contains the exponent in its interval.
    """
    one, other = smaller.candidate, larger.candidate
    if one == other:
        return False
    if one.is_within(other):
        return True
    if one.pendulum and other.springs:
        alike = set(one.losses) <= set(other.losses) or (other.free and _holds_exponent(larger, smaller))
        # Where the free spring explains the data better than the sine, it is a law of its own.
        return alike and against(smaller, larger).p >= _DISFAVOURED
    return other.free and further_parameters(one, other) == 0 and _holds_exponent(larger, smaller)


def _holds_exponent(larger: Judged, smaller: Judged) -> bool:
    """Whether the exponent of the one loss of ``smaller`` may be the free one of ``larger``."""
    losses = smaller.candidate.losses
    if len(losses) > 1 or losses[0][1]:
        return False
    # Stretched as in ``is_negative``: outside of it the exponent of the smaller law is excluded beyond doubt.
    return larger.alpha is None or larger.alpha.stretched(2.0).contains(smaller.candidate.elements[0].velocity)


def minimal(laws: Sequence[Judged]) -> list[Judged]:
    """The consistent laws that contain no other consistent law, the best physical one first; a physical law is not set
    aside by one inside it that needs a negative loss."""
    consistent = [law for law in laws if law.verdict == "consistent"]
    kept = [law for law in consistent if not any(_sets_aside(other, law) for other in consistent)]
    return sorted(kept, key=lambda law: (bool(law.negative), law.criterion))


def _sets_aside(smaller: Judged, larger: Judged) -> bool:
    """Whether the terms that ``larger`` has beside ``smaller`` are not needed."""
    return contains(larger, smaller) and (bool(larger.negative) or not smaller.negative)


def rivals(laws: Sequence[Judged]) -> tuple[list[Judged], list[Judged]]:
    """The minimal laws that compete, and those that do not: with more parameters than a simpler one that makes them
    improbable; or with a negative loss beside a physical law, for with none below 0 they are a law inside them, which
    is not consistent."""
    chosen = minimal(laws)
    physical = [law for law in chosen if not law.negative] or chosen
    standing = [
        law
        for law in physical
        if not any(other.parameters < law.parameters and against(law, other).p < _DISFAVOURED for other in physical)
    ]
    return standing, [law for law in chosen if law not in standing]


def commented(laws: Sequence[Judged]) -> list[Judged]:
    """Consistent laws that contain a smaller consistent one say which of their terms are not needed."""
    smallest = minimal(laws)
    return [_commented(law, smallest) if law.verdict == "consistent" else law for law in laws]


def _commented(law: Judged, smallest: Sequence[Judged]) -> Judged:
    inside = next((other for other in smallest if _sets_aside(other, law)), None)
    if inside is None:
        return replace(law, reason="", unneeded=())
    held = {name: ends.contains(0.0) for name, ends in law.strengths}
    known = {*inside.candidate.alphas, *(f"s{p}" for p in inside.candidate.springs)}
    names = [*law.candidate.alphas, *(f"s{p}" for p in law.candidate.springs)]
    further = {name: held.get(name, True) for name in names if name not in known}
    if law.candidate.free and not inside.candidate.free:
        # The free loss is the loss of the smaller law: what is not needed is that its exponent is free.
        del further[law.candidate.alphas[0]]
        value = inside.candidate.elements[0].velocity
        further["a free exponent"] = law.alpha is None or law.alpha.contains(value)
    if inside.candidate.pendulum and not law.candidate.pendulum:
        further |= {name: True for name in further if name.startswith("s")}  # they stand for sin x, not for 0
    excluded = [name for name, held in further.items() if not held]
    beyond = f"; the interval of {', '.join(excluded)} excludes it, but not beyond doubt" if excluded else ""
    reason = f"contains {inside.candidate}, which is consistent; not needed: {', '.join(further)}{beyond}"
    if law.reason:
        reason += f"; {law.reason}"
    return replace(law, reason=reason, unneeded=tuple(further))
