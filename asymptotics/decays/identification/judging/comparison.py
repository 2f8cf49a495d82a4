"""All candidates fitted to one run: each to the data themselves, or contained in a law that was, and is far from them.

A law has at most the likelihood of a law that contains it.  So where a larger law is fitted and far from the best, all
laws inside it are refuted by the same fit; all others are fitted.  A minimiser may end where no law is near: witnesses
inside the larger law, fitted by themselves, must not be better, or the larger one begins there.  What the limit of work
or time leaves has no fit and says so (``UNTRIED``): it is not judged.
"""

from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from asymptotics.decays.identification.fitting.least_squares import Fit
from asymptotics.decays.identification.fitting.model import Noise
from asymptotics.decays.identification.forward.candidates import Candidate
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.forward.work import ALL, Work
from asymptotics.decays.identification.judging.contradiction import further_parameters
from asymptotics.decays.identification.judging.laws import UNTRIED, Fitted
from asymptotics.decays.identification.judging.single_fits import embedded, fit_law
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.running.budget import tick

_MARGIN, _WORSE, _MANY, _WITNESSES = 50.0, 1e-3, 6, 2
"""AICc above the best, beyond which a law is no rival (e^-25); log-likelihoods are alike within 1e-3, by which two runs
of the minimiser may differ; a spring with so many laws has its largest fitted first, which so many inside it may
contradict.  Choices: they decide which laws a larger one speaks for, never what is said of a law that is fitted."""


def fit_laws(
    candidates: Sequence[Candidate], seen: Observations, noise: Noise | None = None, work: Work = ALL
) -> list[Fitted]:
    """All candidates: the largest law of each spring first, then from few terms to many."""
    heads = heads_of(candidates)
    found = {c: Fitted(c, None, UNTRIED) for c in candidates}
    for head in sorted(heads, key=lambda c: len(c.elements) + c.free):
        tick(f"the law {head}, of {len(found)}")
        found[head] = work.within(partial(_fitted, head, found, seen, noise), found[head])
    for head in heads:
        if _is_far(found[head], found.values()):
            tick(f"laws inside {head}")
            unsure = {head: Fitted(head, None, UNTRIED)}  # without witnesses it speaks for nobody
            found |= work.within(partial(_with_witnesses, found[head], candidates, seen, noise), unsure)
    for candidate in sorted(candidates, key=lambda c: len(c.elements) + c.free):
        law = found[candidate]
        if law.reason != UNTRIED:
            continue
        tick(f"the law {candidate}, {sum(f.reason != UNTRIED for f in found.values()) + 1} of {len(found)}")
        said = _spoken_for(candidate, found)
        if said:
            found[candidate] = Fitted(candidate, None, said, far=True)
            continue
        found[candidate] = work.within(partial(_fitted, candidate, found, seen, noise), law)
    return _nested(list(found.values()), seen, noise, work)


def heads_of(candidates: Sequence[Candidate]) -> list[Candidate]:
    """Of each spring (and the pendulum) with many laws the one that contains the most."""
    families: dict[tuple[tuple[int, ...], bool], list[Candidate]] = {}
    for candidate in candidates:
        families.setdefault((candidate.springs, candidate.pendulum), []).append(candidate)
    largest = [(max(family, key=lambda c: len(c.losses)), family) for family in families.values()]
    return [head for head, family in largest if sum(c.is_within(head) for c in family) >= _MANY]


def _with_witnesses(
    head: Fitted, candidates: Sequence[Candidate], seen: Observations, noise: Noise | None
) -> dict[Candidate, Fitted]:
    """Two laws with one loss inside a head, fitted by themselves (viscous drag and dry friction, where they are among
    them), and the head from the better one, where it is worse.  Of a pendulum from 145 degrees four losses at once went
    astray, and none of its laws was tried."""
    inside = [c for c in candidates if len(c.losses) == 1 and c != head.candidate and c.is_within(head.candidate)]
    inside.sort(key=lambda c: abs(c.elements[0].velocity - 1))
    found = {c: fit_law(c, seen, noise) for c in inside[:_WITNESSES]}
    best = max(found.values(), key=lambda law: law.likelihood, default=head)
    if best.fit is not None and best.likelihood > head.likelihood + _WORSE:
        start = embedded(best.fit, best.candidate, head.candidate)
        again = fit_law(head.candidate, seen, noise, start=start)
        found[head.candidate] = max(head, again, key=lambda law: law.likelihood)
    return found


def _fitted(candidate: Candidate, found: dict[Candidate, Fitted], seen: Observations, noise: Noise | None) -> Fitted:
    """The fit, begun where the smallest law that contains it leads; by itself where there is none, or this fails."""
    larger = [law for law in found.values() if law.usable and candidate.is_within(law.candidate)]
    for law in sorted(larger, key=lambda law: law.parameters)[:1]:
        if law.fit is not None and len(candidate.elements) > 1:
            near = fit_law(candidate, seen, noise, start=_without(law.fit, law.candidate, candidate))
            if near.fit is not None and near.fit.converged:
                return near
    return fit_law(candidate, seen, noise)


def _without(fit: Fit, larger: Candidate, law: Candidate) -> Array:
    """Where the parabola of the larger law has its minimum with its further strengths at 0, as a vector of ``law``."""
    first = fit.model.law.start
    further = [first + k for k, e in enumerate(larger.elements) if e not in law.elements]
    covariance = fit.covariance
    pull = covariance[:, further] @ np.linalg.pinv(covariance[np.ix_(further, further)]) @ fit.theta[further]
    moved = replace(fit, theta=fit.theta - pull)
    return embedded(moved, larger, law)


def _spoken_for(candidate: Candidate, found: dict[Candidate, Fitted]) -> str:
    """Why a law needs no fit: one that contains it is fitted, far from the best, and no worse than what it contains."""
    least = min((law.criterion for law in found.values()), default=float("inf"))
    for law in found.values():
        if law.fit is None or not law.fit.converged or not candidate.is_within(law.candidate):
            continue
        if _is_far(law, found.values()) and _is_trusted(law, found):
            beyond = -2 * law.likelihood - least
            return f"{law.candidate}, which contains it, is fitted and {beyond:.3g} of AICc above the best"
    return ""


def _is_far(law: Fitted, laws: Collection[Fitted]) -> bool:
    """Whether the likelihood of a fit makes it, and all that is inside it, no rival of the best."""
    least = min((other.criterion for other in laws), default=float("inf"))
    return law.fit is not None and -2 * law.likelihood - least > _margin(laws)


def _is_trusted(law: Fitted, found: dict[Candidate, Fitted]) -> bool:
    """A law fits at least as well as those it contains: where it does not, the minimiser failed."""
    inside = (other for other in found.values() if other.fit is not None and other.candidate.is_within(law.candidate))
    return all(law.likelihood >= other.likelihood - _WORSE for other in inside)


def _margin(laws: Iterable[Fitted]) -> float:
    """How far from the best a law is far: farther where the best itself leaves more than the noise that is stated."""
    best = min((law for law in laws if law.fit is not None), key=lambda law: law.criterion, default=None)
    if best is None or best.fit is None or not best.fit.known:
        return _MARGIN
    return _MARGIN * max(best.fit.chi2 / max(best.fit.freedom, 1), 1.0)


def _nested(fits: Sequence[Fitted], seen: Observations, noise: Noise | None, work: Work) -> list[Fitted]:
    """The same fits, none worse than that of a law it contains."""
    found = list(fits)
    for i in sorted(range(len(found)), key=lambda i: found[i].parameters):
        if found[i].reason == UNTRIED or found[i].far:
            continue
        inside = [law for law in found if law.usable and further_parameters(law.candidate, found[i].candidate) == 0]
        best = max((law for law in inside if law.fit), key=lambda law: law.likelihood, default=found[i])
        if best.fit is not None and best.likelihood > found[i].likelihood + _WORSE:
            start = embedded(best.fit, best.candidate, found[i].candidate)
            again = partial(fit_law, found[i].candidate, seen, noise, start=start)
            missed = Fitted(found[i].candidate, None, UNTRIED)
            found[i] = max(found[i], work.within(again, missed), key=lambda law: law.likelihood)
    return found
