"""Which evidence a check produced, written down as it runs: labels are computed, not typed.

The primitives call ``mark``: an identity reduced to zero is PROVED, an inequality of balls CERTIFIED, an order of
convergence or an integration in floats MEASURED.  A verdict is worth its weakest part, unless a derivation proves it.

>>> from asymptotics.verdict import Evidence
>>> with recorded() as marks:
...     mark(Evidence.PROVED)
...     mark(Evidence.MEASURED)
>>> weakest(marks)
<Evidence.MEASURED: 'measured'>
"""

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

from asymptotics.verdict import Evidence

STRENGTH = (Evidence.MEASURED, Evidence.CERTIFIED, Evidence.PROVED)
_marks: ContextVar[list[Evidence] | None] = ContextVar("marks", default=None)


def mark(evidence: Evidence) -> None:
    """Note that this sort of evidence was used."""
    marks = _marks.get()
    if marks is not None:
        marks.append(evidence)


@contextmanager
def recorded() -> Iterator[list[Evidence]]:
    """Collect the marks of what runs inside."""
    marks: list[Evidence] = []
    token = _marks.set(marks)
    try:
        yield marks
    finally:
        _marks.reset(token)


def weakest(marks: list[Evidence]) -> Evidence:
    """The weakest evidence that was used; PROVED for a check that decided by exact comparisons alone."""
    return next((evidence for evidence in STRENGTH if evidence in marks), Evidence.PROVED)
