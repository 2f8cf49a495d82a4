"""The law behind a table of equivalent damping, as a result: the verdict in words first, then strengths with intervals.

Estimates in doubles (``inverse_damping``); what the first order neglects is measured against certified motion and told.
"""

from dataclasses import dataclass, field
from fractions import Fraction
from math import isnan
from typing import Any

from asymptotics.decays.identification.forward.candidates import loss_in_words
from asymptotics.decays.identification.inverse_damping import DampingCandidate, Problem, Strength
from asymptotics.decays.identification.judging.grades import off
from asymptotics.decays.identification.telling.record_units import unit_of_strength
from asymptotics.decays.identification.telling.verdicts import IDENTIFIED, NONE, SEVERAL, UNDECIDED, Verdict
from asymptotics.errors import require_choice
from asymptotics.frames import Frame
from asymptotics.present.percent import at_most, percent
from asymptotics.present.shown import Page, Rows
from asymptotics.terms_given import PENDULUM

UNIT_OF_X = "(unit of x)"
"""Of strengths over the mass, where amplitudes have a unit that nobody says."""
UNTESTED = "not tested"
"""The grade of the laws of one strength beside one loss: each meets it."""
# So many rivals are named; the table below has all of them.
_SHOWN = 4


@dataclass(frozen=True, repr=False)
class DampingLaw(Rows):
    """``laws``: the candidates, best first; ``neglected``: what the first order lacks of the motion, relative, at most.

    ``resolution``: of the values, relative, the median; ``frame``: strengths are b in its units, or epsilon;
    ``per_mass``: they are b/m, where the frequency alone is known, in the unit of the amplitudes.
    ``verdict`` says in words what the table tells and what not.  ``table``: the columns that were used, in m or rad.
    """

    problem: Problem
    laws: tuple[DampingCandidate, ...]
    points: int
    amplitudes: tuple[float, float]
    neglected: float | None
    resolution: float
    frame: Frame
    notes: tuple[str, ...] = field(default=(), compare=False)
    table: dict[str, list[float]] = field(default_factory=dict, compare=False)
    per_mass: bool = False

    @property
    def best(self) -> DampingCandidate:
        """The first of the candidates."""
        return self.laws[0]

    def law(self, name: str) -> DampingCandidate:
        """A candidate by its ``name`` such as ``1+2``; InputError if it is not there."""
        named = {c.name: c for c in self.laws}
        return named[require_choice(name, "name", named)]

    @property
    def verdict(self) -> Verdict:
        """The law, how good it is, its strengths, and what the table cannot tell; of which kind that is."""
        best = self.best
        # Of its own grade, and not merely the same law with a term too many.
        others = [c.name for c in self.laws[1:] if c.grade == best.grade and not c.unneeded]
        if best.grade == UNTESTED:
            told = " or ".join(self._shown(s) for c in self.laws for s in c.strengths)
            return Verdict(UNDECIDED, f"one loss tests no law: {told}")
        kind = NONE if best.grade == "refuted" else SEVERAL if others else IDENTIFIED
        return Verdict(kind, self._told(best, others))

    def _told(self, best: DampingCandidate, others: list[str]) -> str:
        head = f"{_words(best)}: {best.grade_in_words()}"
        if best.grade == "refuted":
            head = f"no candidate fits; nearest is {_words(best)}, whose damping is {off(best.left)} (root mean square)"
        parts = [head, ", ".join(self._shown(s) for s in best.strengths)]
        unsaid = [] if not others or best.grade == "refuted" else [f"it from {' or '.join(others[:_SHOWN])}"]
        wider = [c for c in self.laws if c.unneeded and best.name != c.name and c.grade == "consistent"]
        for c in wider[:1]:
            extra = [s for s in c.strengths if s.alpha in c.unneeded]
            limits = " and ".join(f"{loss_in_words(s.alpha)} below {s.high:.3g}{self._unit(s)}" for s in extra)
            unsaid.append(f"{limits} from none")
        return "; ".join([*parts, *([f"the table cannot tell {', nor '.join(unsaid)}"] if unsaid else [])])

    def _unit(self, s: Strength) -> str:
        unit = (
            unit_of_strength(float(Fraction(s.alpha)), 0, self.frame.x, False)
            if self.per_mass
            else self.frame.unit_of_loss(s.alpha)
        )
        return f" {unit}" if unit else ""

    def _shown(self, s: Strength) -> str:
        letter = "b/m" if self.per_mass else "b" if self.frame else "epsilon"
        ends = "" if isnan(s.low) else f" [{s.low:.4g}, {s.high:.4g}]"
        return f"{letter}_{s.alpha} = {s.estimate:.4g}{ends}{self._unit(s)}"

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: numbers are strings."""
        pendulum, verdict = self.problem.spring == PENDULUM, self.verdict
        laws = [
            {
                "law": c.name, "pendulum": pendulum, "grade": c.grade, "told": c.grade_in_words(),
                "left": f"{c.left:.4g}", "p_value": f"{c.p:.4g}",
                "chi_squared": f"{c.chi_squared:.6g}", "criterion": f"{c.criterion:.6g}", "unneeded": list(c.unneeded),
                "strengths": [
                    {"alpha": s.alpha, "low": _end(s.low), "estimate": repr(s.estimate), "high": _end(s.high)}
                    for s in c.strengths
                ],
            }
            for c in self.laws
        ]  # fmt: skip
        low, high = self.amplitudes
        return {
            "verdict": verdict.text, "verdict_kind": verdict.kind, "untried": [],
            "quantity": self.problem.quantity, "points": self.points,
            "amplitudes": [repr(low), repr(high)], "laws": laws, "per_mass": self.per_mass,
            "si": bool(self.frame) and self.frame.x != UNIT_OF_X, "certified": False,
            "neglected": None if self.neglected is None else f"{self.neglected:.2g}", "notes": list(self.notes),
        }  # fmt: skip

    def __str__(self) -> str:
        lines = [
            f"{c.name:8} {c.grade_in_words():32} {', '.join(self._shown(s) for s in c.strengths)}".rstrip()
            for c in self.laws
        ]
        return "\n".join([self.verdict.text, *lines, *self._worth()])

    def _worth(self) -> list[str]:
        told = "intervals: profiles, 95 %; estimates in doubles of the first-order law"
        if self.neglected is not None:
            told += f"; the motion differs from it by {at_most(self.neglected)} at these amplitudes"
            if self.neglected > self.resolution:
                told += f", more than the resolution ({percent(self.resolution)}): the strengths are off by about that"
        return [told, *self.notes]

    def _page(self) -> Page:
        rows = tuple((c.name, c.grade_in_words(), ", ".join(self._shown(s) for s in c.strengths)) for c in self.laws)
        return Page(self.verdict.text, tuple(self._worth()), ("law", "grade", "strengths [95 %]"), rows)

    def _table(self) -> dict[str, list[Any]]:
        rows = [(c, s) for c in self.laws for s in c.strengths]
        return {
            "law": [c.name for c, _ in rows],
            "grade": [c.grade for c, _ in rows],
            "alpha": [s.alpha for _, s in rows],
            "strength": [s.estimate for _, s in rows],
            "strength_low": [s.low for _, s in rows],
            "strength_high": [s.high for _, s in rows],
        }


def _end(value: float) -> str | None:
    """An end of an interval; None where there is none."""
    return None if isnan(value) else repr(value)


def _words(candidate: DampingCandidate) -> str:
    return " and ".join(loss_in_words(s.alpha) for s in candidate.strengths)
