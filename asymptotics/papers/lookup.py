"""Find a statement by its id, by its number alone, or by a referee's words (``search``).

>>> paper("smith2012:45").title
'The velocity at the first passage through equilibrium'
>>> [found.id for found in find("(43)")]
['lelas2024:43', 'smith2012:43']
>>> find("Lancaster eq. 13")[0].id, find("envelope for alpha = 3/2")[0].id
('lancaster2020:13', 'lancaster2020:table1.alpha3-2')
>>> paper("smith:43")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument id: no statement 'smith:43'; did you mean ...? (accepted: an id ...)
"""

import re
from difflib import get_close_matches
from functools import cache

from asymptotics.errors import InputError, require_choice
from asymptotics.papers.documented import documentation
from asymptotics.papers.search import Searched, ranked
from asymptotics.papers.statement import PaperStatement
from asymptotics.papers.stored import stored

MAX_QUERY = 200
"""Characters of a query that are looked at."""


@cache
def _all() -> dict[str, PaperStatement]:
    records = stored()["statements"]
    assert isinstance(records, list)
    return {r["id"]: PaperStatement(**{**r, "methods": tuple(r["methods"])}) for r in records}


def papers() -> dict[str, str]:
    """The keys of the papers with their references."""
    references = stored()["papers"]
    assert isinstance(references, dict)
    return dict(references)


def cited(key: str) -> str:
    """The reference of a paper with its DOI and its arXiv number.

    >>> cited("smith2012")
    'B. R. Smith, Jr., The quadratically damped oscillator, Am. J. Phys. 80, 816 (2012), doi:10.1119/1.4729440'
    """
    known = identifiers()[key]
    arxiv = f", arXiv:{known['arxiv']}" if known["arxiv"] else ""
    return f"{papers()[key]}, doi:{known['doi']}{arxiv}"


def identifiers() -> dict[str, dict[str, str]]:
    """DOI and arXiv number of each paper, by its key; the number is empty where there is none."""
    known = stored()["identifiers"]
    assert isinstance(known, dict)
    return {key: dict(found) for key, found in known.items()}


def later(statement: str) -> tuple[str, ...]:
    """The authors' later papers that bear on a statement: title and arXiv number.

    >>> later("lelas2024:7")[0].rpartition(", ")[2]
    'arXiv:2602.19725'
    """
    known = stored()["follow_ups"]
    assert isinstance(known, list)
    return tuple(f"{found['title']}, arXiv:{found['arxiv']}" for found in known if statement in found["on"])


VERDICTS = ("holds", "misprint", "transcription", "partly", "refuted", "open", "definition")
SHORTFALLS = {
    "partly-condition": "true under an omitted condition",
    "partly-consequence": "does not follow",
    "partly-range": "false in a stated range",
}
"""The three ways of being partly true, by the words that select them."""


def statements(
    paper: str | None = None, *, words: str | None = None, verdict: str | None = None
) -> tuple[PaperStatement, ...]:
    """All statements of one paper or of all three, in reading order; with words those that are found, best first.

    Parameters
    ----------
    paper
        lancaster2020, lelas2024 or smith2012; what is no paper is words: ``statements("Lambert")``
    words
        words, or a number, that the statement has
    verdict
        only those whose printed form has it: holds, misprint, transcription, partly, refuted, open or definition;
        partly-condition, partly-consequence and partly-range are the three ways of being partly true

    Returns
    -------
    tuple
        of ``PaperStatement``

    Raises
    ------
    InputError
        for an unknown paper or verdict, and for words that nothing has

    Examples
    --------
    >>> [found.id for found in statements("smith2012", words="Lambert", verdict="holds")][:2]
    ['smith2012:43', ...]
    >>> statements("Lambert")[0].id
    'smith2012:43'
    """
    if isinstance(paper, str) and words is None and paper not in papers():
        paper, words = None, paper
    if paper is not None:
        require_choice(paper, "paper", papers())
    if verdict is not None:
        require_choice(verdict, "verdict", (*VERDICTS, *SHORTFALLS))
    if words is not None and not isinstance(words, str):
        raise InputError("words", "is not text", "a number (43) or words (Lambert)")
    found = tuple(_all().values()) if words is None else find(words)
    return tuple(s for s in found if paper in (None, s.paper) and has_verdict(s, verdict))


def has_verdict(s: PaperStatement, verdict: str | None) -> bool:
    """Whether a statement has this verdict, or is partly true in this way; None asks for no verdict.

    >>> [has_verdict(paper("lancaster2020:15"), verdict) for verdict in ("partly", "partly-range", "partly-condition")]
    [True, True, False]
    """
    return verdict in (None, s.printed) or s.shortfall is not None and SHORTFALLS.get(str(verdict)) == s.shortfall


def paper(id: str) -> PaperStatement:  # noqa: A002 (the papers' own word)
    """One statement of the papers by its id, with the verdict of its check.

    Parameters
    ----------
    id
        such as "smith2012:43"

    Returns
    -------
    PaperStatement
        the equation, table entry, figure or claim; ``check`` runs its check again

    Raises
    ------
    InputError
        for an id that is none, with the nearest ids

    Examples
    --------
    >>> paper("smith2012:43").printed
    'holds'
    """
    if not isinstance(id, str):
        raise InputError("id", "is not text", "an id such as smith2012:43")
    if id not in _all():
        wanted = id[:MAX_QUERY]
        # What is no id may be words of a statement: the ids of those that have them are ids, the words are none.
        held = [*ranked(searched(), wanted.strip())][:3] if wanted.strip() else []
        if held:
            raise InputError("id", f"no statement has the id {wanted!r}", f"an id, such as {', '.join(held)}")
        raise InputError("id", f"no statement {wanted!r}{_meant(wanted)}", _FORMS)
    return _all()[id]


def find(query: str) -> tuple[PaperStatement, ...]:
    """The statements with this id or number, else those with every word, best first; InputError if there is none."""
    wanted = query.strip()[:MAX_QUERY]
    if not wanted:
        raise InputError("query", "is empty", _FORMS)
    if wanted in _all():
        return (_all()[wanted],)
    found = tuple(_all()[key] for key in ranked(searched(), wanted))
    if not found:
        pages = ", ".join(dict.fromkeys(str(section) for section in documentation(wanted)[:3]))
        if pages:
            raise InputError("query", f"nothing found for {wanted!r}", f"{pages} (documentation)")
        raise InputError("query", f"nothing found for {wanted!r}{_meant(wanted)}", _FORMS)
    return found


@cache
def searched() -> tuple[Searched, ...]:
    """The statements as they are searched."""
    return tuple(map(Searched.of, _all().values()))


_FORMS = "an id (smith2012:43), a number (43) or words (Lambert)"


def _meant(wanted: str) -> str:
    # Ratios of difflib: 0.6 is its own default, and words must be nearer than ids, whose beginnings are all alike.
    # They decide what is suggested, nothing else.
    near = get_close_matches(wanted, _all(), n=3, cutoff=0.6) or get_close_matches(
        wanted, _vocabulary(), n=3, cutoff=0.7
    )
    return f"; did you mean {', '.join(near)}?" if near else ""


@cache
def _vocabulary() -> tuple[str, ...]:
    return tuple(
        sorted({word for s in _all().values() for word in re.findall(r"[A-Za-z]{4,}", s.title + " " + s.note)})
    )
