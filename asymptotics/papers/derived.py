"""The derivations as data: name, title, source, and the statements for which each is cited; listed by paper, or found.

>>> [found.name for found in derivations("closed sum")][:1], derivations("squaring trick friction")[0].paper
(['smith-closed-sum'], 'lelas2024')
"""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import cache
from typing import Any

from asymptotics.errors import InputError
from asymptotics.papers.documented import documentation
from asymptotics.papers.keywords import ASKED, OF_DERIVATIONS
from asymptotics.papers.lookup import statements
from asymptotics.papers.search import Searched, everyday, plain, ranked
from asymptotics.papers.statement import PaperStatement
from asymptotics.papers.stored import stored

OTHERS = "beyond the papers"
"""What the group of the derivations is called that belong to no paper."""


@dataclass(frozen=True)
class DerivationRecord:
    """One derivation, not run: ``paper`` is empty beyond the papers, ``section`` is that of its first statement."""

    name: str
    title: str
    source: str
    paper: str
    section: str
    statements: tuple[str, ...]

    def to_dict(self) -> dict[str, Any]:
        """The record as plain data."""
        return {**asdict(self), "statements": list(self.statements)}


@cache
def _all() -> tuple[DerivationRecord, ...]:
    records = stored()["derivations"]
    assert isinstance(records, list)
    return tuple(DerivationRecord(**{**r, "statements": tuple(r["statements"])}) for r in records)


def derivations(words: str | None = None) -> tuple[DerivationRecord, ...]:
    """All derivations, by paper and section; with ``words`` those that have most of them, best first.

    InputError where nothing has any of the words.
    """
    if words is None:
        return _all()
    if not isinstance(words, str) or not words.strip():
        raise InputError(
            "words", "is no text", "words of a title (closed sum), a paper (Smith) or the id of a statement"
        )
    known = {d.name: d for d in _all()}
    asked = words.strip()
    named = [d for d in _all() if asked in d.statements or "-".join(asked.lower().split()) == d.name]
    found = named or [known[key.partition(":")[2]] for key in ranked(searched(), words)]
    if not found:
        pages = "; ".join(map(str, documentation(words)[:3]))
        elsewhere = f"; of the documentation {pages}" if pages else ", such as closed sum"
        raise InputError("words", f"no derivation has {words.strip()[:80]!r}", f"words of a title{elsewhere}")
    return tuple(found)


def grouped() -> Mapping[str, tuple[DerivationRecord, ...]]:
    """The derivations by the key of their paper, those that belong to none last.

    >>> list(grouped())
    ['lancaster2020', 'lelas2024', 'smith2012', 'beyond the papers']
    """
    keys = dict.fromkeys(d.paper or OTHERS for d in _all())
    return {key: tuple(d for d in _all() if (d.paper or OTHERS) == key) for key in keys}


@cache
def searched() -> tuple[Searched, ...]:
    """The derivations as they are searched, each by the words of its statements too."""
    known = {s.id: s for s in statements()}
    return tuple(_searched(d, [known[i] for i in d.statements]) for d in _all())


def _searched(d: DerivationRecord, cited: Sequence[PaperStatement]) -> Searched:
    """Its id has the paper, so that an author's name selects; of its statements the wrong ones give it their words."""
    name = d.name.replace("-", " ")
    notes = plain(" ".join((name, d.source, *d.statements, *(s.title for s in cited))))
    wrong = [ASKED[s.printed] for s in cited if s.printed in ("misprint", "refuted", "partly")]
    said = " ".join((name, OF_DERIVATIONS.get(d.name, ""), *(everyday(s.id) for s in cited), *dict.fromkeys(wrong)))
    return Searched(f"{d.paper}:{d.name}", plain(d.title), said, "", notes)
