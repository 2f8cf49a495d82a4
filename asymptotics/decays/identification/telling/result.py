"""What identification found: a frozen record with a table, LaTeX and JSON."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Any

from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.decays.identification.judging.judgement import rivals
from asymptotics.decays.identification.judging.laws import Judged
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.decays.identification.telling.agreement import agreed
from asymptotics.decays.identification.telling.envelope import MeasuredEnvelope, envelope, why_none
from asymptotics.decays.identification.telling.equivalents import equivalent, equivalent_texts, number_text
from asymptotics.decays.identification.telling.in_words import in_words
from asymptotics.decays.identification.telling.law_answer import LETTERS, LawAnswer
from asymptotics.decays.identification.telling.plots import draw_decrements, draw_panels, drawn_run, shown_laws
from asymptotics.decays.identification.telling.record_units import RecordUnits
from asymptotics.decays.identification.telling.verdicts import IDENTIFIED, MANY, Verdict
from asymptotics.errors import require_choice
from asymptotics.numbers.alike import Alike
from asymptotics.numbers.context import cached_property
from asymptotics.numbers.policy import exact_integer
from asymptotics.present.counts import many
from asymptotics.present.drawn import Drawn
from asymptotics.present.shown import Page, Rows, plain


@dataclass(frozen=True, repr=False, eq=False)
class Identification(Alike, Rows, Drawn):
    """The answer for one or several runs.

    ``verdict``: one of four, in words; ``laws``: the candidates, best first; ``runs``: the data; ``textbook``: the
    classical estimators by name; ``notes``: what was found, discarded, assumed; ``per_run``: for several runs, each
    run's answer.
    """

    verdict: Verdict
    laws: tuple[LawAnswer, ...]
    runs: tuple[Observations | Decrements, ...]
    textbook: dict[str, Any]
    notes: tuple[str, ...]
    units: RecordUnits
    per_run: tuple["Identification", ...] = ()

    @property
    def best(self) -> LawAnswer:
        """The first law of the verdict."""
        return self.laws[0]

    @property
    def of_the_verdict(self) -> tuple[LawAnswer, ...]:
        """The laws that compete, best first; where there are none, the first law."""
        chosen = {law.candidate for law in rivals([answer.law for answer in self.laws])[0]}
        return tuple(answer for answer in self.laws if answer.law.candidate in chosen) or self.laws[:1]

    @property
    def in_words(self) -> str:
        """Q at both ends of the record (of all runs) and the half-life, of the first law; empty for tables."""
        return in_words(self._equivalent(), self.units.shown)

    @property
    def lines(self) -> tuple[str, ...]:
        """Of each law of the verdict (three at most) words, equation, strengths and Q; what all of them say of Q; and
        Q of the envelope, which needs no law."""
        laws = self.of_the_verdict
        # A law without strengths, of which nothing was found, heads no answer.
        found = [line for answer in laws[:MANY] if answer.law.epsilon for line in answer.lines]
        together = agreed([answer.law for answer in laws], self.units)
        return (*found, *([] if together is None else [str(together)]), *self._bare_lines())

    @property
    def quality_in_words(self) -> str:
        """Q in one line: by all laws of the verdict, by the one, or before any law."""
        together = agreed([answer.law for answer in self.of_the_verdict], self.units)
        return self.in_words if together is None else str(together)

    def _bare_lines(self) -> list[str]:
        """What the envelope says, of each of the first runs."""
        if len(self.per_run) > 1:
            return [f"{one.runs[0].name}: {line}" for one in self.per_run[:MANY] for line in one._bare_lines()]
        bare, run = self._bare(), self.runs[0]
        untold = [f"no envelope: {self._why_bare()}"] if isinstance(run, Observations) else []
        return untold if bare is None else [bare.in_words()]

    def _why_bare(self) -> str:
        """Why there is no envelope."""
        run = self.runs[0]
        return why_none(run) if isinstance(run, Observations) else "decrements are no decay: they tell Q themselves"

    def _equivalent(self) -> dict[str, Any] | None:
        return equivalent(self.best.law, self.units.omega_0) if self.laws else None

    def _bare(self) -> MeasuredEnvelope | None:
        """Period, Q(A) and half-life before any law; of several runs, those of the first."""
        return self._envelope

    @cached_property
    def _envelope(self) -> MeasuredEnvelope | None:
        run = self.runs[0]
        return envelope(run) if isinstance(run, Observations) else None

    def _bare_rows(self) -> list[dict[str, Any]]:
        """Q, zeta, period, omega, rate of decay and half-life before any law, as rows like those of ``strengths``."""
        if len(self.per_run) > 1:
            return [row for one in self.per_run for row in one._bare_rows()]
        bare = self._bare()
        head = {"law": "before any law", "verdict": self.runs[0].name}
        return [] if bare is None else [{**head, "parameter": name, **_ends(ends)} for name, ends in bare.rows()]

    def law(self, text: str) -> LawAnswer:
        """The answer for the candidate ``text``, such as ``1+2`` or ``free+s3``; InputError if it is not there."""
        named = {str(answer.law.candidate): answer for answer in self.laws}
        return named[require_choice(text, "text", named)]

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: numbers are strings."""
        bare, together = self._bare(), agreed([answer.law for answer in self.of_the_verdict], self.units)
        found: dict[str, Any] = {
            "verdict": self.verdict.text,
            "verdict_kind": self.verdict.kind,
            "telling": self.verdict.telling or None,
            "equivalent": equivalent_texts(self.best.law, self.units.omega_0) if self.laws else None,
            "envelope": None if bare is None else bare.to_dict(self.verdict.kind == IDENTIFIED),
            "envelope_untold": self._why_bare() if bare is None else None,
            "agreed": None if together is None else together.to_dict(),
            "not_excluded": [term.to_dict() for term in self.verdict.allowed],
            "laws": [law.to_dict() for law in self.laws],
            "untried": [str(law.law.candidate) for law in self.laws if law.law.untried],
            "data": [_data(run) for run in self.runs],
            "textbook": self.textbook,
            "unit": self.units.shown or None,
            "omega_0": None if self.units.omega_0 is None else number_text(self.units.omega_0),
            "notes": list(self.notes),
        }
        if self.per_run:
            found["runs"] = [run.to_dict() for run in self.per_run]
        return found

    @property
    def told_laws(self) -> tuple[LawAnswer, ...]:
        """All laws, or none where no law was fitted: rows that say the same of each of them tell nothing."""
        return self.laws if any(answer.law.strengths for answer in self.laws) else ()

    def table(self, count: int = 12) -> str:
        """The first ``count`` laws as a table of text."""
        count = exact_integer(count, "count", 1, 10_000)  # more than are ever tried
        if not self.told_laws:
            return f"none of {many(len(self.laws), 'law')} was fitted"
        rows: list[tuple[str, ...]] = [("law", "verdict", "dAICc", "held-out", "strengths [interval]")]
        rows += [answer.row() for answer in self.told_laws[:count]]
        widths = [max(len(row[i]) for row in rows) for i in range(4)]
        return "\n".join("  ".join([*(c.ljust(w) for c, w in zip(row, widths)), row[4]]).rstrip() for row in rows)

    def __repr__(self) -> str:
        return f"Identification({self.verdict.text})"

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Decay, decrement against amplitude, residuals and profiles; on given axes ``ax`` the decrements alone.

        Of several runs the first is drawn.  ``style`` as of ``Motion.plot``.  InputError for printed decrements, and as
        there.
        """
        return super().plot(ax, **{"panels": ax is None, **style})

    def _heading(self) -> str:
        return self.verdict.text

    def _size(self, style: Mapping[str, Any]) -> tuple[float, float]:
        return (10, 7.5) if style.get("panels") else super()._size(style)

    def _curve(self, axes: Any, **style: Any) -> bool:
        panels = bool(style.pop("panels", False))
        if panels:
            draw_panels(self, axes)
        else:
            one = drawn_run(self)
            draw_decrements(axes, shown_laws(one), one.units.shown)
        return panels

    def _formula(self) -> str:
        if not self.told_laws:
            return rf"\text{{{plain(self.verdict.text)}}}"
        return rf"\text{{{plain(self.verdict.text)}}}\quad\text{{first of {len(self.laws)}: }} {self.best._formula()}"

    def _page(self) -> Page:
        """The verdict, then what tells the laws apart, the table of the first laws and the notes."""
        head = ("law", "verdict", "ΔAICc", "held-out error", "strengths [interval]")
        lines = (*self.lines, self.verdict.telling, *self.notes)
        return Page(self.verdict.text, lines, head, tuple(a.row() for a in self.told_laws))

    def _letters(self) -> dict[str, str]:
        return LETTERS

    def _table(self) -> dict[str, list[Any]]:
        rows = [row for answer in self.laws for row in answer.strengths()]
        return {name: [row[name] for row in rows] for name in (rows[0] if rows else ())}


def _ends(found: Mapping[str, float]) -> dict[str, float | None]:
    """An estimate and its interval; None for an end without a limit."""
    return {name: found[name] if isfinite(found[name]) else None for name in ("estimate", "low", "high")}


def _data(run: "Observations | Decrements") -> dict[str, Any]:
    if isinstance(run, Decrements):
        return {"name": run.name, "decrements": len(run.decrement)}
    return {"name": run.name, "turning_points": len(run.n), "times": run.has_times, "first": number_text(run.reference)}


def sorted_laws(laws: Sequence[Judged]) -> list[Judged]:
    """The laws of the verdict (consistent, no term too many) first, of these the physical ones, then by the criterion;
    laws without one last.  Where none is consistent, those that are no result, being unphysical or far outside the
    data, come after those that are: they do not head an answer."""
    standing = any(law.verdict == "consistent" for law in laws)

    def place(law: Judged) -> tuple[bool, bool, float, int]:
        chosen = law.verdict == "consistent" and not law.unneeded
        spoilt = bool(law.negative or law.evidence.outside) and (chosen or not standing)
        return not chosen, spoilt, law.criterion, len(law.candidate.losses)

    return sorted(laws, key=place)
