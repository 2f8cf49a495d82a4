"""Which evidence a check produced, written down as it runs: labels are computed, not typed.

The primitives call ``mark``: an identity reduced to zero is PROVED, an inequality of balls CERTIFIED, an order of
convergence or an integration in floats MEASURED.  A verdict is worth its weakest part, unless a derivation proves it.

A check that looks at some members of an infinite family (values of an exponent, strengths, times) takes them through
``sampled``: however exact each comparison is, the family is not proved by it, and the label says how many were tried.

>>> from paper_checks.verdict import Evidence
>>> with recorded() as marks:
...     mark(Evidence.PROVED)
...     for alpha in sampled((0, 2)):
...         mark(Evidence.CERTIFIED)
>>> marks.weakest, marks.extent
(<Evidence.CERTIFIED: 'certified'>, 'sampled: 2 points')
>>> Marks([Evidence.PROVED], 3).weakest
<Evidence.MEASURED: 'measured'>

An exact computation on one example of a general statement says so, and so does what was found by reading:

>>> Marks([Evidence.PROVED], 1).extent, Marks(read_off=True).weakest, Marks(read_off=True).extent
('exact, one example', <Evidence.MEASURED: 'measured'>, 'read off the text')
"""

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from typing import TypeVar

from paper_checks.verdict import Evidence

ONE_EXAMPLE, READ_OFF = "exact, one example", "read off the text"
STRENGTH = (Evidence.MEASURED, Evidence.CERTIFIED, Evidence.PROVED)
Point = TypeVar("Point")


@dataclass(frozen=True)
class Difference:
    """Two sides that a check has told apart: as LaTeX, their values, and at which point."""

    left: str
    relation: str
    right: str
    values: tuple[str, str] = ("", "")
    where: str = ""


@dataclass
class Marks:
    """The sorts of evidence that were used, at how many sample points, what was told apart, and what was read."""

    evidence: list[Evidence] = field(default_factory=list)
    points: int = 0
    differences: list[Difference] = field(default_factory=list)
    read_off: bool = False

    @property
    def weakest(self) -> Evidence:
        """The weakest evidence; PROVED for exact comparisons alone, which at sample points are a measurement."""
        found = next((evidence for evidence in STRENGTH if evidence in self.evidence), Evidence.PROVED)
        return Evidence.MEASURED if (self.points or self.read_off) and found == Evidence.PROVED else found

    @property
    def extent(self) -> str:
        """How far the evidence reaches; empty if as far as the statement."""
        if self.read_off:
            return READ_OFF
        if self.points == 1 and set(self.evidence) <= {Evidence.PROVED}:
            return ONE_EXAMPLE
        return f"sampled: {self.points} points" if self.points else ""


_marks: ContextVar[Marks | None] = ContextVar("marks", default=None)


def mark(evidence: Evidence) -> None:
    """Note that this sort of evidence was used."""
    marks = _marks.get()
    if marks is not None:
        marks.evidence.append(evidence)


def differ(found: Callable[[], Difference]) -> None:
    """Note the sides of a comparison that failed; where nobody reads them, they are not written down."""
    marks = _marks.get()
    if marks is not None:
        marks.differences.append(found())


def sampled(points: Iterable[Point]) -> tuple[Point, ...]:
    """These points, noted as a sample of a family that has more."""
    found, marks = tuple(points), _marks.get()
    if marks is not None:
        marks.points += len(found)
    return found


def read_off(printed: Point) -> Point:
    """What the paper says in its own words or signs: found by reading, not by computing."""
    marks = _marks.get()
    if marks is not None:
        marks.read_off = True
    return printed


@contextmanager
def recorded() -> Iterator[Marks]:
    """Collect the marks of what runs inside."""
    marks = Marks()
    token = _marks.set(marks)
    try:
        yield marks
    finally:
        _marks.reset(token)
