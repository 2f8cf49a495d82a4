"""Statements, derivations and documentation by the same words: what the search on the pages of the report shows.

>>> found = look_up("Lambert")
>>> found.statements[0].id, [d.name for d in found.derivations]
('smith2012:43', ['smith-turning-points'])
"""

from dataclasses import dataclass

from asymptotics.papers import derived, documented, lookup
from asymptotics.papers.derived import DerivationRecord, derivations
from asymptotics.papers.documented import Section, sections
from asymptotics.papers.lookup import statements
from asymptotics.papers.search import ranked
from asymptotics.papers.statement import PaperStatement


@dataclass(frozen=True)
class Everything:
    """What was found of each kind, best first: all of it has as many of the words as anything has."""

    statements: tuple[PaperStatement, ...]
    derivations: tuple[DerivationRecord, ...]
    documentation: tuple[Section, ...]

    def __bool__(self) -> bool:
        return bool(self.statements or self.derivations or self.documentation)


def look_up(query: str) -> Everything:
    """What has most of the words, over all kinds together; empty where nothing has any."""
    ids = ranked([*lookup.searched(), *derived.searched(), *documented.searched()], query)
    by_id = {s.id: s for s in statements()}
    of_name = {f"{d.paper}:{d.name}": d for d in derivations()}
    return Everything(
        tuple(by_id[i] for i in ids if i in by_id),
        tuple(of_name[i] for i in ids if i in of_name),
        tuple(sections()[i] for i in ids if i in sections()),
    )
