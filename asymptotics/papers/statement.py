"""One statement of a paper, as it is shown: printed form, verdict, what is true instead, and why."""

from dataclasses import asdict, dataclass
from typing import Any


@dataclass(frozen=True)
class PaperStatement:
    """A numbered equation, table entry, figure or claim with the verdict of its check.

    ``printed`` is the verdict on the printed form (holds, misprint, transcription, partly, refuted, open, definition),
    ``evidence`` what it rests on (proved, certified, measured, none) and ``extent`` how far that reaches; ``latex`` is
    the printed form, ``corrected`` what is true instead (None if it holds); ``source`` is the file
    and line of the check.
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
    digits: int | None
    order: str | None
    near_miss: str | None
    source: str

    def __repr__(self) -> str:
        return f"<{self.id}: {self.title} ({self.printed}, {self.evidence})>"

    def _repr_latex_(self) -> str:
        return f"${self.latex}$"

    def to_dict(self) -> dict[str, Any]:
        """The JSON of ``asymptotics papers``."""
        return {**asdict(self), "methods": list(self.methods)}
