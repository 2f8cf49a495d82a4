"""What becomes of a candidate law: fitted to a run (``Fitted``), then judged beside the others (``Judged``).

>>> law = Judged.of(Fitted(Candidate((("1", 0),)), None, "2 data for 3 unknowns"))
>>> law.verdict, law.reason, law.usable
('undetermined', '2 data for 3 unknowns', False)
"""

from dataclasses import dataclass, replace

import numpy as np

from asymptotics.decays.identification.fitting.least_squares import Fit
from asymptotics.decays.identification.fitting.profile import Function, Interval, coordinate
from asymptotics.decays.identification.forward.candidates import Candidate
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.judging.contradiction import Contradiction
from asymptotics.decays.identification.judging.grades import Unexplained, grade_of, in_words

LIMIT = "the limit of work or time"
UNTRIED = f"not judged: {LIMIT} was reached"


@dataclass(frozen=True)
class Fitted:
    """A candidate with its fit to one run, or with the ``reason`` why there is none.

    ``far``: it was left out, for it is far from the data; ``left``: the share of the sum of squares that an unseen
    spring would leave.
    """

    candidate: Candidate
    fit: Fit | None
    reason: str = ""
    far: bool = False
    left: float = 1.0

    @property
    def criterion(self) -> float:
        """AICc; infinite without a fit."""
        return float("inf") if self.fit is None else self.fit.aicc

    @property
    def likelihood(self) -> float:
        """ln(likelihood); minus infinity without a fit."""
        return -float("inf") if self.fit is None else self.fit.log_likelihood

    @property
    def usable(self) -> bool:
        """Whether there is a fit with data to spare."""
        return self.fit is not None and bool(np.isfinite(self.fit.aicc))

    @property
    def terms(self) -> int:
        """How many terms the law has."""
        return len(self.candidate.elements)

    @property
    def parameters(self) -> int:
        """How many numbers the law has: strengths, and the exponent if it is free."""
        return self.terms + self.candidate.free

    @property
    def functions(self) -> list[Function]:
        """The strengths, and the exponent if it is free, as functions of the parameter vector of the fit."""
        assert self.fit is not None
        model = self.fit.model
        counted = model.seen.stride
        found = [strength(self.candidate, i, model.reference, model.law.start, counted) for i in range(self.terms)]
        return [*found, coordinate(model.law.start + self.terms)] if self.candidate.free else found


@dataclass(frozen=True)
class Intervals:
    """Of the losses, the springs and the free exponent; ``profiled``: by profile likelihood, else by curvature.

    ``stretches``: by how much correlated residuals lengthen each; ``apart``: of several runs, the strengths that differ
    by more than their errors.
    """

    epsilon: tuple[Interval, ...] = ()
    springs: tuple[Interval, ...] = ()
    alpha: Interval | None = None
    profiled: bool = False
    stretches: tuple[float, ...] = ()
    apart: tuple[str, ...] = ()


@dataclass(frozen=True)
class Evidence:
    """What speaks about a law: its residuals in words, and again as ``misfit`` where they are no noise; the law that
    speaks ``against`` it most; what it leaves of the loss; its error of prediction (``held_out``); that its amplitudes
    lie far ``outside`` the data."""

    residuals: str = ""
    misfit: str = ""
    against: Contradiction = Contradiction()
    unexplained: Unexplained | None = None
    held_out: float | None = None
    outside: str = ""


@dataclass(frozen=True)
class Judged:
    """A fitted law with its intervals, what speaks about it, and its verdict with the ``reason``.

    ``excess``: AICc above the best; ``total``: of several runs, the sum of AICc, and ``runs``: the law in each of them;
    ``unneeded``: terms that a smaller consistent law does without.
    """

    fitted: Fitted
    intervals: Intervals = Intervals()
    evidence: Evidence = Evidence()
    verdict: str = "undetermined"
    reason: str = ""
    excess: float = float("inf")
    total: float | None = None
    unneeded: tuple[str, ...] = ()
    runs: tuple["Judged", ...] = ()

    @classmethod
    def of(cls, fitted: Fitted) -> "Judged":
        """Not judged yet; the reason is that of the missing fit."""
        return cls(fitted, verdict="refuted" if fitted.far else "undetermined", reason=fitted.reason)

    @property
    def candidate(self) -> Candidate:
        """The law."""
        return self.fitted.candidate

    @property
    def fit(self) -> Fit | None:
        """Its fit, if there is one."""
        return self.fitted.fit

    @property
    def fits(self) -> tuple[Fit, ...]:
        """Its fit, or those to several runs."""
        return tuple(law.fit for law in self.runs or (self,) if law.fit is not None)

    @property
    def usable(self) -> bool:
        """Whether there is a fit with data to spare."""
        return self.fitted.usable

    @property
    def parameters(self) -> int:
        """How many numbers the law has."""
        return self.fitted.parameters

    @property
    def epsilon(self) -> tuple[Interval, ...]:
        """The strengths of the losses."""
        return self.intervals.epsilon

    @property
    def springs(self) -> tuple[Interval, ...]:
        """The strengths of the springs."""
        return self.intervals.springs

    @property
    def alpha(self) -> Interval | None:
        """The exponent, if it is free."""
        return self.intervals.alpha

    @property
    def strengths(self) -> list[tuple[str, Interval]]:
        """All strengths with the names of their terms."""
        springs = [f"s{p}" for p in self.candidate.springs]
        return [*zip(self.candidate.alphas, self.epsilon), *zip(springs, self.springs)]

    @property
    def negative(self) -> tuple[str, ...]:
        """The losses whose estimate is negative: unphysical, but not clipped."""
        return tuple(a for a, e in zip(self.candidate.alphas, self.epsilon) if e.estimate < 0)

    @property
    def inflation(self) -> float:
        """By how much correlated residuals stretch its intervals at most."""
        return max(self.intervals.stretches, default=1.0)

    @property
    def criterion(self) -> float:
        """AICc (of several runs: their sum); infinite without a fit."""
        return self.fitted.criterion if self.total is None else self.total

    @property
    def grade(self) -> str:
        """consistent (at the noise level), adequate (contradicted, but it leaves little of the loss), refuted, or
        undetermined."""
        left = self.evidence.unexplained
        return self.verdict if left is None or self.negative else grade_of(self.verdict, left.share)

    @property
    def untried(self) -> bool:
        """Whether the limit of work or time was reached before it was judged."""
        return self.fitted.reason == UNTRIED

    @property
    def graded(self) -> str:
        """The grade in words."""
        left = self.evidence.unexplained
        return self.grade if left is None else in_words(self.grade, left.share)

    def judged_as(self, verdict: str, reason: str) -> "Judged":
        """The same law, judged."""
        return replace(self, verdict=verdict, reason=reason)

    def with_evidence(self, **found: object) -> "Judged":
        """The same law with more evidence."""
        return replace(self, evidence=replace(self.evidence, **found))  # type: ignore[arg-type]


def strength(
    candidate: Candidate, index: int, reference: float, first: int = 1, stride: float = 1.0
) -> Function:  # fmt: skip
    """epsilon_i = s_i A_ref^(-w_i)/stride as a function of the parameter vector, for x0 = 1 unit of the file.

    ``first``: where the law begins in the vector; ``stride``: the half-swings that one n of an envelope counts.
    """
    if not (candidate.free and index == 0):
        return coordinate(first + index, reference ** -candidate.elements[index].weight / stride)
    place = first + len(candidate.elements)

    def g(theta: Array) -> tuple[float, Array]:
        factor = reference ** (1 - theta[place]) / stride
        gradient = np.zeros(len(theta))
        gradient[first], gradient[place] = factor, -np.log(reference) * factor * theta[first]
        return float(theta[first] * factor), gradient

    return g
