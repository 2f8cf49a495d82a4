"""The headings of the documentation, found by the words of a referee as the statements are.

>>> [str(found) for found in documentation("loss factor")][:2]
['docs/theory/equivalent_damping: Equivalent damping', 'docs/words: Loss factor']
"""

from dataclasses import dataclass
from functools import cache

from asymptotics.papers.keywords import OF_PAGES
from asymptotics.papers.search import Searched, plain, ranked
from asymptotics.papers.stored import stored


@dataclass(frozen=True)
class Section:
    """A heading of a page: the page without its ending, its title, and the heading below it (empty: the page)."""

    page: str
    title: str
    heading: str

    def __str__(self) -> str:
        return f"docs/{self.page}: {self.heading or self.title}"

    def to_dict(self) -> dict[str, str]:
        """The section as plain data."""
        return {"page": self.page, "title": self.title, "heading": self.heading}


@cache
def sections() -> dict[str, Section]:
    """All sections by the id under which they are searched."""
    pages = stored()["documentation"]
    assert isinstance(pages, list)
    found = [Section(p["page"], p["title"], heading) for p in pages for heading in ("", *p["headings"])]
    return {f"docs:{section.page}#{number}": section for number, section in enumerate(found)}


@cache
def searched() -> tuple[Searched, ...]:
    """The sections as they are searched: a page by its title and the words people use, a heading by itself."""
    return tuple(_searched(key, section) for key, section in sections().items())


def _searched(key: str, s: Section) -> Searched:
    if s.heading:
        return Searched(key, plain(s.heading), "", "", plain(s.title))
    return Searched(key, plain(s.title), OF_PAGES.get(s.page, ""), "", s.page.replace("/", " ").replace("_", " "))


def documentation(words: str) -> tuple[Section, ...]:
    """The sections that have most of the words, best first; none where no heading has any."""
    return tuple(sections()[key] for key in ranked(searched(), words))
