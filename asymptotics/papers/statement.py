"""One statement of a paper, as it is shown: printed form, verdict, what is true instead, and why."""

from dataclasses import asdict, dataclass
from importlib import import_module
from typing import Any, cast

from asymptotics.present.html import Tex
from asymptotics.present.letters import letters
from asymptotics.present.shown import Page, Shown


@dataclass(frozen=True)
class PaperStatement(Shown):
    """A numbered equation, table entry, figure or claim with the verdict of its check.

    ``printed`` is the verdict on the printed form (holds, misprint, transcription, partly, refuted, open, definition),
    ``evidence`` what it rests on (proved, certified, measured, none) and ``extent`` how far that reaches; ``latex`` is
    the printed form (with ``paraphrase``: in our words), ``corrected`` what is true instead (None if it holds),
    ``shortfall`` in which way it is partly true, ``slip`` a slip that changes nothing; ``line`` is the line of the
    derivation that proves it, or that has what is true instead; ``source`` is the file and line of the check.
    """

    id: str
    paper: str
    kind: str
    title: str
    printed: str
    evidence: str
    extent: str
    latex: str
    corrected: str | None
    conditions: str
    note: str
    methods: tuple[str, ...]
    derivation: str | None
    line: int | None
    paraphrase: bool
    shortfall: str | None
    slip: str
    digits: int | None
    order: str | None
    near_miss: str | None
    source: str

    def __repr__(self) -> str:
        return f"<{self.id}: {self.title} ({self.printed}, {self.evidence})>"

    def _page(self) -> Page:
        true = self.corrected and Tex(self.corrected)
        named = {"printed": Tex(self.latex), "true instead": true, "conditions": self.conditions,
                 "near miss, refuted": self.near_miss, "derivation": self.derivation, "note": self.note}  # fmt: skip
        rows = tuple((name, text) for name, text in named.items() if text)
        title = f"{self.id}: {self.title}"
        return Page(title, (f"{self.printed}, {self.evidence}: {self.extent}",), ("", ""), rows)

    def _formula(self) -> str:
        return self.latex

    def _letters(self) -> dict[str, str]:
        # The papers' letters are their own: gamma is no gamma function here.
        return dict.fromkeys(letters(self.latex), f"as in {self.paper}")

    def to_dict(self) -> dict[str, Any]:
        """The JSON of ``asymptotics papers``."""
        return {**asdict(self), "methods": list(self.methods)}

    def check(self, *, max_seconds: float | str = 60) -> dict[str, Any]:
        """Its check, run again: ``outcomes`` of each form (confirmed, refuted), and whether they bear the verdict out.

        ``apart``: the two sides that the check has told apart at the near miss (LaTeX, values, where), if it has.

        InputError where the checks, a part of the wheel of their own, are not installed.

        >>> from asymptotics.papers.lookup import paper
        >>> found = paper("smith2012:45").check()
        >>> found["outcomes"], found["agrees"], found["apart"]["values"]
        ({'printed': 'confirmed', 'near miss': 'refuted'}, True, (...))
        """
        again = import_module("asymptotics.papers.checked").check  # what computes is heavy, what looks up is not
        return cast("dict[str, Any]", again(self.paper, self.id, max_seconds=max_seconds))
