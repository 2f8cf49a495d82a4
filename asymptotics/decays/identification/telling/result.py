"""What identification found: a frozen record with a table, LaTeX and JSON."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.decays.identification.fitting.profile import Interval
from asymptotics.decays.identification.forward.candidates import FREE
from asymptotics.decays.identification.judging.laws import Judged
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.decays.identification.telling.envelope import envelope
from asymptotics.decays.identification.telling.in_words import equivalent, in_words
from asymptotics.decays.identification.telling.plots import draw_decrements, draw_panels, shown_laws
from asymptotics.decays.identification.telling.verdicts import IDENTIFIED, Verdict
from asymptotics.errors import require_choice
from asymptotics.numbers.alike import Alike
from asymptotics.numbers.policy import exact_integer
from asymptotics.present.drawn import Drawn
from asymptotics.present.shown import Page, Rows, plain

_LETTERS = {"x": "displacement", "b": "strength of a loss", "c": "strength of a spring",
            r"\alpha": "the exponent that is fitted", r"\varepsilon": "strength of a loss"}  # fmt: skip


_IN_TEX = ((r"\be(\d+)", r"\\varepsilon_{\1}"), (r"\bc(\d+)", r"c_{\1}"), (r"\^\(([^()]*)\)", r"^{\1}"))


@dataclass(frozen=True)
class RecordUnits:
    """What is known of the oscillator beside the record: mass, stiffness, omega_0 (SI), and the unit of x in SI."""

    unit: str = ""
    size: float = 1.0
    mass: float | None = None
    stiffness: float | None = None
    omega_0: float | None = None

    def physical(self, alpha: float, position: int, epsilon: Interval) -> tuple[str, Interval] | None:
        """(name, interval) of b or b/m in SI: b/m = epsilon omega_0^(2-alpha) (unit of x)^(1-alpha-m)."""
        omega = self.omega_0
        # The strength of a linear loss has no unit of length in it.
        if omega is None or not (self.unit or alpha + position == 1):
            return None
        # x'' + omega_0^2 x + (b/m) |x|^m x'|x'|^(alpha - 1) = 0 in SI, scaled to the unit of x and the time omega_0 t.
        factor = omega ** (2 - alpha) * self.size ** (1 - alpha - position)
        name = "b/m"
        if self.mass is not None:
            name, factor = "b", factor * self.mass
        low, high = (None if v is None else v * factor for v in (epsilon.low, epsilon.high))
        return name, Interval(low, epsilon.estimate * factor, high)


@dataclass(frozen=True, repr=False, eq=False)
class LawAnswer(Alike, Rows):
    """A candidate law for one run, as it is reported."""

    law: Judged
    units: RecordUnits = field(default_factory=RecordUnits)
    certified: bool = False

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: numbers are strings."""
        law, candidate = self.law, self.law.candidate
        found: dict[str, Any] = {
            "alphas": list(candidate.alphas),
            "springs": [str(p) for p in candidate.springs],
            "pendulum": candidate.pendulum,
            "verdict": law.verdict,
            "grade": law.grade,
            "unexplained": None if law.evidence.unexplained is None else _number(law.evidence.unexplained.share),
            "reason": law.reason or None,
            "epsilon": [e.to_dict() for e in law.epsilon],
            "spring_strengths": [e.to_dict() for e in law.springs],
            "alpha": None if law.alpha is None else law.alpha.to_dict(),
            "criterion": _number(law.criterion),
            "criterion_difference": _number(law.excess),
            "unneeded": list(law.unneeded),
            "p_value": _number(law.evidence.against.p),
            "bic": None if law.fit is None else _number(law.fit.bic),
            "intervals": self._how(),
            "unphysical": list(law.negative),
            "held_out_error": None if law.evidence.held_out is None else _number(law.evidence.held_out),
            "formula": candidate.formula(),
        }
        if law.fit is not None:
            found["residual"] = {k: _number(v) for k, v in law.fit.scales.items()}
        physical = [self.physical(i) for i in range(len(law.epsilon))]
        if any(p is not None for p in physical):
            found["physical"] = [None if p is None else {"quantity": p[0], **p[1].to_dict()} for p in physical]
        return found

    def _how(self) -> str:
        """By what its intervals were found."""
        return (
            "certified set" if self.certified else "profile likelihood" if self.law.intervals.profiled else "curvature"
        )

    def physical(self, i: int) -> tuple[str, Interval] | None:
        """b_i or b_i/m in SI, if the units are known and the exponent is given."""
        i = exact_integer(i, "i", 0, len(self.law.epsilon) - 1)
        element = self.law.candidate.elements[i]
        # The unit of b would depend on the exponent that was found.
        if self.law.candidate.losses[i][0] == FREE:
            return None
        return self.units.physical(element.velocity, element.position, self.law.epsilon[i])

    def strengths(self) -> list[dict[str, Any]]:
        """One row for each strength (and for a free exponent): estimate and both ends of its interval, as numbers."""
        law, candidate = self.law, self.law.candidate
        named = [("alpha", law.alpha)] if law.alpha is not None else []
        named += [(f"epsilon {name}", e) for name, e in zip(candidate.alphas, law.epsilon)]
        named += [(f"spring {p}", e) for p, e in zip(candidate.springs, law.springs)]
        head = {"law": str(candidate), "verdict": law.verdict}
        rest = {"dAICc": float(law.excess), "held_out_error": law.evidence.held_out}
        return [
            {**head, "parameter": name, "estimate": e.estimate, "low": e.low, "high": e.high, **rest}
            for name, e in named
        ]

    def _page(self) -> Page:
        rows = tuple(
            (r["parameter"], f"{r['estimate']:.6g}", _end(r["low"]), _end(r["high"])) for r in self.strengths()
        )
        title = f"law {self.law.candidate}: {self.law.verdict}"
        return Page(
            title, (self.law.reason or "", f"intervals: {self._how()}"), ("", "estimate", "at least", "at most"), rows
        )

    def _table(self) -> dict[str, list[Any]]:
        rows = self.strengths()
        return {name: [row[name] for row in rows] for name in (rows[0] if rows else ())}

    def _formula(self) -> str:
        formula = self.law.candidate.formula().removesuffix(" = 0").replace("sgn(x')", r"\operatorname{sgn}(x')")
        for plain_text, tex in _IN_TEX:
            formula = re.sub(plain_text, tex, formula)
        return formula.replace("alpha", r"\alpha") + " = 0"

    def _letters(self) -> dict[str, str]:
        return _LETTERS

    def row(self) -> tuple[str, ...]:
        """One line of the table: law, verdict, AICc difference, held-out error, strengths by exponent."""
        law = self.law
        names = [*law.candidate.alphas, *(f"s{p}" for p in law.candidate.springs)]
        found = [_shown(e) for e in (*law.epsilon, *law.springs)]
        named = [f"{name}: {text}" for name, text in zip(names, found)] if len(found) > 1 else found
        strengths = "  ".join(([] if law.alpha is None else [f"alpha {_shown(law.alpha)}"]) + named)
        excess = f"{law.excess:.1f}" if np.isfinite(law.excess) else "-"
        held = "-" if law.evidence.held_out is None else f"{law.evidence.held_out:.2f}"
        verdict = law.graded + (f", {' and '.join(law.unneeded)} not needed" if law.unneeded else "")
        verdict += ", unphysical" if law.negative else ""
        return str(law.candidate), verdict, excess, held, strengths


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
    def in_words(self) -> str:
        """Q at both ends of the record and the half-life, of the first law; empty beside springs and for tables."""
        return in_words(self._equivalent(), self.units.unit)

    def _equivalent(self) -> dict[str, Any] | None:
        return None if self.per_run or not self.laws else equivalent(self.best.law, self.units.omega_0)

    def _equivalent_texts(self) -> dict[str, Any] | None:
        """The same as JSON: numbers are strings."""
        found = self._equivalent()
        if found is None:
            return None
        rows = {name: [_number(x) for x in found[name]] for name in ("amplitudes", "Q", "zeta")}
        return rows | {"half_life": _number(found["half_life"]), "half_life_unit": found["half_life_unit"]}

    def _envelope(self) -> dict[str, Any] | None:
        """Period, Q(A) and half-life before any law, as JSON; of several runs, the first."""
        run = self.runs[0]
        found = envelope(run) if isinstance(run, Observations) else None
        return None if found is None else found.to_dict(self.verdict.kind == IDENTIFIED)

    def law(self, text: str) -> LawAnswer:
        """The answer for one candidate, by its name such as ``1+2`` or ``free+s3``; InputError if it is not there."""
        named = {str(answer.law.candidate): answer for answer in self.laws}
        return named[require_choice(text, "text", named)]

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: numbers are strings."""
        found: dict[str, Any] = {
            "verdict": self.verdict.text,
            "verdict_kind": self.verdict.kind,
            "telling": self.verdict.telling or None,
            "equivalent": self._equivalent_texts(),
            "envelope": self._envelope(),
            "not_excluded": [term.to_dict() for term in self.verdict.allowed],
            "laws": [law.to_dict() for law in self.laws],
            "untried": [str(law.law.candidate) for law in self.laws if law.law.untried],
            "data": [_data(run) for run in self.runs],
            "textbook": self.textbook,
            "unit": self.units.unit or None,
            "omega_0": None if self.units.omega_0 is None else _number(self.units.omega_0),
            "notes": list(self.notes),
        }
        if self.per_run:
            found["runs"] = [run.to_dict() for run in self.per_run]
        return found

    def table(self, count: int = 12) -> str:
        """The first laws as a table of text."""
        count = exact_integer(count, "count", 1, 10_000)  # more than are ever tried
        rows: list[tuple[str, ...]] = [("law", "verdict", "dAICc", "held-out", "strengths [interval]")]
        rows += [answer.row() for answer in self.laws[:count]]
        widths = [max(len(row[i]) for row in rows) for i in range(4)]
        return "\n".join("  ".join([*(c.ljust(w) for c, w in zip(row, widths)), row[4]]).rstrip() for row in rows)

    def __repr__(self) -> str:
        return f"Identification({self.verdict.text})"

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Decay, decrement against amplitude, residuals and profiles; on given axes the decrements alone.

        InputError for several runs and printed decrements, and as ``Motion.plot``.
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
            draw_decrements(axes, shown_laws(self), self.units.unit)
        return panels

    def _formula(self) -> str:
        return rf"\text{{{plain(self.verdict.text)}}}\quad\text{{first of {len(self.laws)}: }} {self.best._formula()}"

    def _page(self) -> Page:
        """The verdict, then what tells the laws apart, the table of the first laws and the notes."""
        head = ("law", "verdict", "ΔAICc", "held-out error", "strengths [interval]")
        lines = (self.in_words, self.verdict.telling, *self.notes)
        return Page(self.verdict.text, lines, head, tuple(a.row() for a in self.laws))

    def _letters(self) -> dict[str, str]:
        return _LETTERS

    def _table(self) -> dict[str, list[Any]]:
        rows = [row for answer in self.laws for row in answer.strengths()]
        return {name: [row[name] for row in rows] for name in (rows[0] if rows else ())}


def _data(run: "Observations | Decrements") -> dict[str, Any]:
    if isinstance(run, Decrements):
        return {"name": run.name, "decrements": len(run.decrement)}
    return {"name": run.name, "turning_points": len(run.n), "times": run.has_times, "first": _number(float(run.x[0]))}


def _number(value: float) -> str | None:
    return f"{value:.8g}" if np.isfinite(value) else None


def _end(value: float | None) -> str:
    return "no limit" if value is None else f"{value:.6g}"


def _shown(interval: Interval) -> str:
    size = abs(interval.estimate)
    width = min((abs(v - interval.estimate) for v in (interval.low, interval.high) if v is not None), default=size)
    # Two digits of the shorter half of the interval; four at least, twelve at most.
    digits = 4 if not 0 < width < size else min(12, max(4, 2 + int(np.ceil(np.log10(size / width)))))
    ends = ["-" if v is None else f"{v:.{digits}g}" for v in (interval.low, interval.high)]
    return f"{interval.estimate:.{digits}g} [{ends[0]}, {ends[1]}]"


def sorted_laws(laws: Sequence[Judged]) -> list[Judged]:
    """The laws of the verdict (consistent, no term too many) first, of these the physical ones, then by the criterion;
    laws without one last."""

    def place(law: Judged) -> tuple[bool, bool, float, int]:
        chosen = law.verdict == "consistent" and not law.unneeded
        return not chosen, chosen and bool(law.negative), law.criterion, len(law.candidate.losses)

    return sorted(laws, key=place)
