"""One candidate law as it is reported: JSON, a row of the table, lines of text."""

import re
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from asymptotics.decays.identification.fitting.profile import Interval
from asymptotics.decays.identification.forward.candidates import FREE
from asymptotics.decays.identification.judging.laws import Judged
from asymptotics.decays.identification.telling.equivalents import equivalent, equivalent_texts, number_text
from asymptotics.decays.identification.telling.in_words import in_words, law_in_words, shares_in_words
from asymptotics.decays.identification.telling.record_units import RecordUnits
from asymptotics.numbers.alike import Alike
from asymptotics.numbers.policy import exact_integer
from asymptotics.present.shown import Page, Rows

LETTERS = {"x": "displacement", "b": "strength of a loss", "c": "strength of a spring",
            r"\alpha": "the exponent that is fitted", r"\varepsilon": "strength of a loss"}  # fmt: skip


_IN_TEX = ((r"\be(\d+)", r"\\varepsilon_{\1}"), (r"\bc(\d+)", r"c_{\1}"), (r"\^\(([^()]*)\)", r"^{\1}"))


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
            "unexplained": None if law.evidence.unexplained is None else number_text(law.evidence.unexplained.share),
            "reason": law.reason or None,
            "epsilon": [e.to_dict() for e in law.epsilon],
            "spring_strengths": [e.to_dict() for e in law.springs],
            "alpha": None if law.alpha is None else law.alpha.to_dict(),
            "criterion": number_text(law.criterion),
            "criterion_difference": number_text(law.excess),
            "unneeded": list(law.unneeded),
            "p_value": number_text(law.evidence.against.p),
            "bic": None if law.fit is None else number_text(law.fit.bic),
            "intervals": self._how(),
            "unphysical": list(law.negative),
            "held_out_error": None if law.evidence.held_out is None else number_text(law.evidence.held_out),
            "formula": candidate.formula(),
            "words": law_in_words(law),
            "equivalent": equivalent_texts(law, self.units.omega_0) if law.verdict == "consistent" else None,
        }
        if law.fit is not None:
            found["residual"] = {k: number_text(v) for k, v in law.fit.scales.items()}
        physical = [self.physical(i) for i in range(len(law.epsilon))]
        if any(p is not None for p in physical):
            units = [None if (known := self.beside(i)) is None else known[2] for i in range(len(law.epsilon))]
            found["physical"] = [
                None if p is None else {"quantity": p[0], **p[1].to_dict(), "unit": unit}
                for p, unit in zip(physical, units, strict=True)
            ]
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

    def beside(self, i: int) -> tuple[str, Interval, str] | None:
        """(name, interval, unit) of b_i or b_i/m, in units of x where that of x is not known."""
        i = exact_integer(i, "i", 0, len(self.law.epsilon) - 1)
        element = self.law.candidate.elements[i]
        # The unit of b would depend on the exponent that was found.
        if self.law.candidate.losses[i][0] == FREE:
            return None
        return self.units.beside(element.velocity, element.position, self.law.epsilon[i])

    @property
    def lines(self) -> tuple[str, ...]:
        """The law in words, its equation, and of each loss b or b/m and its share, and Q: lines of text."""
        law, unit = self.law, self.units.shown
        found = [f"{law.candidate}: {law_in_words(law)}; {law.candidate.formula()}"]
        parts = shares_in_words(law, unit)
        for i, name in enumerate(law.candidate.alphas[: len(law.epsilon)]):
            said = [*([] if (known := self.beside(i)) is None else [_with_unit(*known)]), *parts[i : i + 1]]
            found += [f"  {name}: {', '.join(said)}"] if said else []
        q = in_words(equivalent(law, self.units.omega_0), unit)
        return (*found, *([f"  {q}"] if q else []))

    def strengths(self) -> list[dict[str, Any]]:
        """One row for each strength, as epsilon and as b or b/m with its unit where known, and for a free exponent:
        estimate and both ends of its interval, as numbers."""
        law, candidate = self.law, self.law.candidate
        named = [("alpha", law.alpha)] if law.alpha is not None else []
        named += [(f"epsilon {name}", e) for name, e in zip(candidate.alphas, law.epsilon)]
        named += [(f"spring {p}", e) for p, e in zip(candidate.springs, law.springs)]
        known = [(name, self.beside(i)) for i, name in enumerate(candidate.alphas[: len(law.epsilon)])]
        named += [(f"{found[0]} of {name} [{found[2]}]", found[1]) for name, found in known if found is not None]
        head = {"law": str(candidate), "verdict": law.verdict + (", unphysical" if law.negative else "")}
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
        return LETTERS

    def row(self) -> tuple[str, ...]:
        """One line of the table: law, verdict, AICc difference, held-out error, strengths by exponent."""
        law = self.law
        names = [*law.candidate.alphas, *(f"s{p}" for p in law.candidate.springs)]
        found = [shown_interval(e) for e in (*law.epsilon, *law.springs)]
        named = [f"{name}: {text}" for name, text in zip(names, found)] if len(found) > 1 else found
        strengths = "  ".join(([] if law.alpha is None else [f"alpha {shown_interval(law.alpha)}"]) + named)
        excess = f"{law.excess:.1f}" if np.isfinite(law.excess) else "-"
        held = "-" if law.evidence.held_out is None else f"{law.evidence.held_out:.2f}"
        verdict = law.graded + (f", {' and '.join(law.unneeded)} not needed" if law.unneeded else "")
        verdict += ", unphysical" if law.negative else ""
        return str(law.candidate), verdict, excess, held, strengths


def _end(value: float | None) -> str:
    return "no limit" if value is None else f"{value:.6g}"


def shown_interval(interval: Interval) -> str:
    """An estimate with both ends of its interval, to two digits of it."""
    size = abs(interval.estimate)
    width = min((abs(v - interval.estimate) for v in (interval.low, interval.high) if v is not None), default=size)
    # Two digits of the shorter half of the interval; four at least, twelve at most.
    digits = 4 if not 0 < width < size else min(12, max(4, 2 + int(np.ceil(np.log10(size / width)))))
    ends = ["-" if v is None else f"{v:.{digits}g}" for v in (interval.low, interval.high)]
    return f"{interval.estimate:.{digits}g} [{ends[0]}, {ends[1]}]"


def _with_unit(name: str, ends: Interval, unit: str) -> str:
    return f"{name} = {shown_interval(ends)} {unit}"
