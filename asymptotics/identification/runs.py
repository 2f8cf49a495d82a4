"""Several runs of one oscillator: a common law, each run's strengths, and an interval for their mean.

The runs scatter by more than their own errors, so the mean has a random-effects interval: the variance between the runs
by DerSimonian and Laird, the interval with Hartung and Knapp's variance and Student's t with (runs - 1) degrees.

>>> mean, between = random_effects([1.0, 1.2, 0.9], [0.01, 0.01, 0.01])
>>> mean.contains(1.0), between > 0.1
(True, True)
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy.special import chdtrc, stdtrit

from asymptotics.identification.allowance import allowances, told
from asymptotics.identification.comparison import LawFit
from asymptotics.identification.contradiction import REFUTED, Contradiction
from asymptotics.identification.judgement import against, commented, is_negative, minimal
from asymptotics.identification.profile import Interval
from asymptotics.identification.verdicts import IDENTIFIED, NONE, SEVERAL, UNTOLD, Verdict


def random_effects(estimates: Sequence[float], errors: Sequence[float], level: float = 0.95) -> tuple[Interval, float]:
    """(interval of the mean, standard deviation between runs)."""
    y, v = np.asarray(estimates, dtype=float), np.asarray(errors, dtype=float) ** 2
    if len(y) < 2:
        return Interval(None, float(y[0]), None), 0.0
    v = np.maximum(v, 1e-300)
    w = 1 / v
    fixed = float(w @ y / w.sum())
    excess = float(w @ (y - fixed) ** 2) - (len(y) - 1)
    between = max(0.0, excess / float(w.sum() - (w**2).sum() / w.sum()))
    w = 1 / (v + between)
    mean = float(w @ y / w.sum())
    variance = max(float(w @ (y - mean) ** 2) / (len(y) - 1), 1.0 if between == 0 else 0.0) / float(w.sum())
    reach = float(stdtrit(len(y) - 1, (1 + level) / 2)) * float(np.sqrt(variance))
    return Interval(mean - reach, mean, mean + reach), float(np.sqrt(between))


def common(per_run: Sequence[Sequence[LawFit]]) -> list[LawFit]:
    """One LawFit for each candidate: the criteria added, the strengths averaged, the verdict of all runs together."""
    found = [_common(laws) for laws in zip(*per_run, strict=True)]
    least = min((law.criterion for law in found), default=float("inf"))
    return commented([_judged(i, found, least, per_run) for i in range(len(found))])


def _common(laws: Sequence[LawFit]) -> LawFit:
    total = float(sum(law.criterion for law in laws))
    first = laws[0]
    if not np.isfinite(total):
        return LawFit(first.candidate, None, reason="not every run determines it")
    epsilon = tuple(_mean([law.epsilon[i] for law in laws]) for i in range(len(first.epsilon)))
    springs = tuple(_mean([law.springs[i] for law in laws]) for i in range(len(first.springs)))
    exponents = [law.alpha for law in laws if law.alpha is not None]
    alpha = _mean(exponents) if exponents else None
    return LawFit(first.candidate, None, epsilon=epsilon, springs=springs, alpha=alpha, total=total)


def _mean(intervals: Sequence[Interval]) -> Interval:
    errors = [(i.high - i.low) / 3.92 if i.low is not None and i.high is not None else np.inf for i in intervals]
    if not np.isfinite(errors).all():
        return Interval(None, float(np.mean([i.estimate for i in intervals])), None)
    return random_effects([i.estimate for i in intervals], errors)[0]


def _judged(place: int, laws: Sequence[LawFit], least: float, per_run: Sequence[Sequence[LawFit]]) -> LawFit:
    law = laws[place]
    if not np.isfinite(law.criterion):
        return law
    rivals = [i for i, other in enumerate(laws) if i != place and not other.negative]
    found = [_combined([against(run[place], run[i]) for run in per_run]) for i in rivals]
    law = replace(law, excess=law.criterion - least, against=min(found, key=lambda c: c.p, default=Contradiction()))
    if law.against.p < REFUTED:
        return law.judged_as("refuted", f"{law.against}, in all runs together")
    misfits = sum(bool(run[place].misfit) for run in per_run)
    if misfits:
        return law.judged_as("refuted", f"its residuals are not independent noise in {misfits} of {len(per_run)} runs")
    negative = [a for a, e in zip(law.candidate.alphas, law.epsilon) if is_negative(e)]
    if negative:
        return law.judged_as("refuted", f"unphysical: the strength of {', '.join(negative)} is negative")
    return law.judged_as("consistent", "")


def _combined(found: Sequence[Contradiction]) -> Contradiction:
    """Fisher's combination: -2 sum ln(p) has chi-squared's distribution with two degrees of freedom for each run."""
    logarithms = sum(np.log(max(c.p, 1e-300)) for c in found)
    p = float(chdtrc(2 * len(found), -2 * logarithms))
    return Contradiction(found[0].by, sum(c.ratio for c in found), sum(c.terms for c in found), p)


def verdict_of_runs(runs: Sequence[Verdict], laws: Sequence[LawFit]) -> Verdict:
    """One verdict for all runs, from their common laws: no better than that of the runs, if a run fits no law."""
    chosen = minimal(laws)
    names = "; ".join(str(law.candidate) for law in chosen[:6])
    best = f"; best: {names}" if names else ""
    inadequate = sum(v.kind == NONE for v in runs)
    if inadequate:
        text = f"{NONE} at the noise level in {inadequate} of {len(runs)} runs (model inadequate){best}"
        return Verdict(NONE, text, next(v.telling for v in runs if v.kind == NONE))
    if len(chosen) == 1:
        allowed = allowances(chosen[0], laws, None)
        text = f"{IDENTIFIED} in {len(runs)} runs: {names}, among the laws tried{told(allowed)}"
        return Verdict(IDENTIFIED, text, "", allowed)
    if not chosen or len(chosen) > 3:
        return Verdict(UNTOLD, f"{UNTOLD} to tell {len(chosen)} laws apart: {names}")
    return Verdict(SEVERAL, f"{SEVERAL} with {len(runs)} runs: {names}")
