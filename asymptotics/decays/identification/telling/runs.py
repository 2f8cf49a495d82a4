"""Several runs of one oscillator: a common law, each run's strengths, and an interval for their mean.

Where Cochran's Q = sum_i (y_i - y)^2/sigma_i^2 is no larger than chance makes it (p >= 0.05, runs - 1 degrees), there
is one strength, and the mean has the errors within the runs, 1/sum_i sigma_i^-2.  Where it is larger the strengths
differ: the interval is that of random effects (the variance between the runs by DerSimonian and Laird, the interval
with Hartung and Knapp's variance and Student's t with runs - 1 degrees), and the verdict says so.

>>> alike, between = mean_of_runs([1.0, 1.01], [0.01, 0.01])
>>> round(alike.high - alike.low, 3), between
(0.028, 0.0)
>>> apart, between = mean_of_runs([1.0, 1.2], [0.01, 0.01])
>>> apart.contains(0.0), between > 0.1
(True, True)
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy.special import chdtrc, ndtri, stdtrit

from asymptotics.decays.identification.fitting.profile import Interval
from asymptotics.decays.identification.judging.allowance import WEAK, allowance_text, allowances
from asymptotics.decays.identification.judging.contradiction import REFUTED, Contradiction
from asymptotics.decays.identification.judging.judgement import against, commented, is_negative, rivals
from asymptotics.decays.identification.judging.laws import LIMIT, Fitted, Intervals, Judged
from asymptotics.decays.identification.telling.verdicts import (
    IDENTIFIED,
    MANY,
    NONE,
    SEVERAL,
    UNDECIDED,
    UNTOLD,
    Verdict,
    imitation,
)

_ALIKE = 0.05
"""The p-value of Cochran's Q from which on the strengths of the runs are one: the customary level, by which one pair in
twenty of equal strengths is told to differ, and has the wider interval (measured in the tests: 3 to 7 %)."""


def mean_of_runs(estimates: Sequence[float], errors: Sequence[float], level: float = 0.95) -> tuple[Interval, float]:
    """(interval of the mean, standard deviation between runs: 0 where they agree within their errors)."""
    y, v = np.asarray(estimates, dtype=float), np.asarray(errors, dtype=float) ** 2
    if len(y) < 2:
        return Interval(None, float(y[0]), None), 0.0
    w = 1 / np.maximum(v, 1e-300)
    mean, freedom = float(w @ y / w.sum()), len(y) - 1
    Q = float(w @ (y - mean) ** 2)
    if chdtrc(freedom, Q) >= _ALIKE:
        reach = float(ndtri((1 + level) / 2) / np.sqrt(w.sum()))
        return Interval(mean - reach, mean, mean + reach), 0.0
    # DerSimonian and Laird 1986: the variance that makes Q as large as expected. Here Q exceeds its 95 % quantile, and
    # so its expectation.
    between = (Q - freedom) / float(w.sum() - (w**2).sum() / w.sum())
    w = 1 / (v + between)
    mean = float(w @ y / w.sum())
    # Hartung and Knapp 2001: the scatter that is there, not that of the errors.
    variance = float(w @ (y - mean) ** 2) / freedom / float(w.sum())
    reach = float(stdtrit(freedom, (1 + level) / 2)) * float(np.sqrt(variance))
    return Interval(mean - reach, mean, mean + reach), float(np.sqrt(between))


def common(per_run: Sequence[Sequence[Judged]]) -> list[Judged]:
    """One Judged for each candidate: the criteria added, the strengths averaged, the verdict of all runs together."""
    found = [_common(laws) for laws in zip(*per_run, strict=True)]
    least = min((law.criterion for law in found), default=float("inf"))
    return commented([_judged(i, found, least, per_run) for i in range(len(found))])


def _common(laws: Sequence[Judged]) -> Judged:
    total = float(sum(law.criterion for law in laws))
    first = laws[0]
    # The sum of the criteria is that of the runs together, for their data are independent; one run without a fit has
    # none.
    if not np.isfinite(total):
        return Judged(Fitted(first.candidate, None), reason="not every run determines it")
    wild = [law.evidence.outside for law in laws if law.evidence.outside]
    if wild:
        return Judged(Fitted(first.candidate, None), reason=f"in {len(wild)} of {len(laws)} runs {wild[0]}")
    epsilon = [_mean([law.epsilon[i] for law in laws]) for i in range(len(first.epsilon))]
    springs = [_mean([law.springs[i] for law in laws]) for i in range(len(first.springs))]
    exponents = [law.alpha for law in laws if law.alpha is not None]
    alpha = _mean(exponents)[0] if exponents else None
    intervals = Intervals(_ends(epsilon), _ends(springs), alpha)
    found = Judged(Fitted(first.candidate, None), intervals, total=total, runs=tuple(laws))
    scatter = zip(found.strengths, (*epsilon, *springs), strict=True)
    apart = tuple(name for (name, _), (_, between) in scatter if between > 0)
    return replace(found, intervals=replace(found.intervals, apart=apart))


def _ends(means: Sequence[tuple[Interval, float]]) -> tuple[Interval, ...]:
    return tuple(interval for interval, _ in means)


def _mean(intervals: Sequence[Interval]) -> tuple[Interval, float]:
    # The standard error of a 95 % interval, 2 times 1.96.
    errors = [(i.high - i.low) / 3.92 if i.low is not None and i.high is not None else np.inf for i in intervals]
    if not np.isfinite(errors).all():
        return Interval(None, float(np.mean([i.estimate for i in intervals])), None), 0.0
    return mean_of_runs([i.estimate for i in intervals], errors)


def _judged(place: int, laws: Sequence[Judged], least: float, per_run: Sequence[Sequence[Judged]]) -> Judged:
    law = laws[place]
    if not np.isfinite(law.criterion):
        return law
    # As for one run: a loss that feeds a decay refutes nothing.
    alien = {i for run in per_run for i, other in enumerate(run) if other.evidence.outside}
    rivals = [i for i, other in enumerate(laws) if i != place and not other.negative and i not in alien]
    found = [_combined([against(run[place], run[i]) for run in per_run]) for i in rivals]
    law = replace(law, excess=law.criterion - least)
    law = law.with_evidence(against=min(found, key=lambda c: c.p, default=Contradiction()))
    if law.evidence.against.p < REFUTED:
        return law.judged_as("refuted", f"{law.evidence.against}, in all runs together")
    misfits = sum(bool(run[place].evidence.misfit) for run in per_run)
    if misfits:
        return law.judged_as("refuted", f"its residuals are not independent noise in {misfits} of {len(per_run)} runs")
    negative = [a for a, e in zip(law.candidate.alphas, law.epsilon) if is_negative(e)]
    if negative:
        return law.judged_as("refuted", f"unphysical: the strength of {', '.join(negative)} is negative")
    return law.judged_as("consistent", "")


def _combined(found: Sequence[Contradiction]) -> Contradiction:
    """Fisher's combination: -2 sum ln(p) has chi-squared's distribution with two degrees of freedom for each run."""
    # A p-value that has underflowed is as small as can be said.
    logarithms = sum(np.log(max(c.p, 1e-300)) for c in found)
    p = float(chdtrc(2 * len(found), -2 * logarithms))
    return Contradiction(found[0].by, sum(c.ratio for c in found), sum(c.terms for c in found), p)


def verdict_of_runs(runs: Sequence[Verdict], laws: Sequence[Judged], first: float | None = None) -> Verdict:
    """One verdict for all runs, from their common laws: no better than that of the runs, if a run fits no law.

    ``first``: the first amplitude, at which the shares of further terms are told.
    """
    chosen = rivals(laws)[0]
    names = "; ".join(str(law.candidate) for law in chosen[:6])
    best = f"; best: {names}" if names else ""
    cut = sum(v.kind == UNDECIDED for v in runs)
    if cut:
        text = f"{UNDECIDED}: {LIMIT} was reached before all laws were judged in {cut} of {len(runs)} runs{best}"
        return Verdict(UNDECIDED, text, "more time (max_seconds), or fewer candidates (laws)")
    inadequate = sum(v.kind == NONE for v in runs)
    if inadequate:
        text = f"{NONE} at the noise level in {inadequate} of {len(runs)} runs (model inadequate){best}"
        return Verdict(NONE, text, next(v.telling for v in runs if v.kind == NONE))
    imitated = imitation(chosen)
    if imitated is not None:
        return imitated
    if len(chosen) == 1:
        return _one_law(chosen[0], laws, len(runs), first)
    if not chosen and not any(law.verdict == "refuted" for law in laws):
        return Verdict(UNTOLD, f"{UNTOLD} to tell: the {len(runs)} runs together determine no law")
    if not chosen:
        return Verdict(NONE, f"{NONE}: no law is consistent with all {len(runs)} runs together")
    if len(chosen) > MANY:
        return Verdict(UNTOLD, f"{UNTOLD} to tell {len(chosen)} laws apart: {names}")
    return Verdict(SEVERAL, f"{SEVERAL} with {len(runs)} runs: {names}")


def _one_law(law: Judged, laws: Sequence[Judged], runs: int, first: float | None) -> Verdict:
    """Identified, unless a further term may carry a large part of the loss; strengths that differ are told."""
    allowed = allowances(law, laws, first)
    said, apart = allowance_text(allowed), _apart(law)
    if any(a.share is not None and a.share > WEAK for a in allowed):
        text = f"{SEVERAL} with {runs} runs: {law.candidate} is the smallest, but a further term may carry"
        return Verdict(SEVERAL, f"{text} over a fifth of the loss{apart}{said}", "", allowed)
    if not apart and all(e.contains(0.0) for e in law.epsilon):
        return Verdict(UNTOLD, f"{UNTOLD} to tell: the data do not show any loss", "more swings, or less noise")
    text = f"{IDENTIFIED} in {runs} runs: {law.candidate}, among the laws tried{apart}{said}"
    return Verdict(IDENTIFIED, text, "", allowed)


def _apart(law: Judged) -> str:
    """That the strengths of the runs differ, in words."""
    if not law.intervals.apart:
        return ""
    said = f"; but the strength of {', '.join(law.intervals.apart)} differs from run to run by more than its errors"
    return f"{said}: the interval is that of the mean"
