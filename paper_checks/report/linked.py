"""The statements as linked data (JSON-LD, schema.org): each a Claim of its paper, with the ClaimReview of its check.

An id is that of the statement and stays when its place in the code changes; a row of a table has the id of its table
and its first cell.  The digest is that of everything printed of the statement and of its forms, as the ledger has it.
What schema.org has no word for (evidence, extent, shortfall) is a term of our own, named in the context.

>>> from paper_checks.registry import expected_outcomes, load
>>> s = load()["smith2012:table1.S3"]
>>> graph = linked([Entry(s, expected_outcomes(s), 0.0)])["@graph"]
>>> [node["@type"] for node in graph], graph[1]["@id"], graph[2]["reviewRating"]["alternateName"]
(['ScholarlyArticle', 'Claim', 'ClaimReview'], 'urn:power-law-oscillator:smith2012:table1.S3', 'misprint')
"""

import re
from collections.abc import Iterator, Sequence
from typing import Any

from asymptotics import __version__
from paper_checks.reader import digest
from paper_checks.registry import FOLLOW_UPS, IDENTIFIERS, PAPERS, Entry, Statement
from paper_checks.verdict import Printed

URN = "urn:power-law-oscillator:"
OWN = ("conditions", "digits", "equation", "evidence", "extent", "order", "shortfall", "slip", "verdict")
CONTEXT = ["https://schema.org", {name: f"{URN}term:{name}" for name in OWN}]
RATINGS = {  # out of 5, as ClaimReview has it: for what reads numbers alone
    Printed.HOLDS: 5, Printed.DEFINITION: 5, Printed.TRANSCRIPTION: 4, Printed.PARTLY: 3, Printed.MISPRINT: 2,
    Printed.REFUTED: 1,
}  # fmt: skip


def linked(entries: Sequence[Entry], tables: Sequence[dict[str, Any]] = ()) -> dict[str, Any]:
    """The graph of the papers, their claims and the reviews of these, the authors' later papers, and the tables."""
    known = {e.statement.id for e in entries}
    nodes = [_article(key) for key in PAPERS if any(e.statement.paper == key for e in entries)]
    for entry in entries:
        nodes += [_claim(entry.statement), _review(entry)]
    for number, title, ids in FOLLOW_UPS:
        about = [{"@id": URN + i} for i in ids if i in known]
        nodes += [{"@type": "ScholarlyArticle", **_arxiv(number), "name": title, "about": about}] if about else []
    for table in tables:
        nodes += _table(table, known)
    return {"@context": CONTEXT, "@graph": nodes}


def _arxiv(number: str) -> dict[str, str]:
    return {"@id": f"https://arxiv.org/abs/{number}", "identifier": f"arXiv:{number}"}


def _doi(key: str) -> str:
    return f"https://doi.org/{IDENTIFIERS[key]['doi']}"


def _article(key: str) -> dict[str, Any]:
    doi, arxiv = IDENTIFIERS[key]["doi"], IDENTIFIERS[key]["arxiv"]
    identifiers = [f"doi:{doi}", *([f"arXiv:{arxiv}"] if arxiv else [])]
    other = {"sameAs": f"https://arxiv.org/abs/{arxiv}"} if arxiv else {}
    return {"@type": "ScholarlyArticle", "@id": _doi(key), "name": PAPERS[key][0], "identifier": identifiers, **other}


def _claim(s: Statement) -> dict[str, Any]:
    local = s.id.partition(":")[2]
    found = {"name": s.title, "text": s.latex, "encodingFormat": "text/x-latex", "position": local}
    number = {"equation": local} if re.fullmatch(r"\d+[a-z]?", local) else {}
    corrected = {"correction": s.corrected_latex} if s.corrected_latex else {}
    return {"@type": "Claim", "@id": URN + s.id, **found, **number, "appearance": {"@id": _doi(s.paper)}, **corrected}


def _review(entry: Entry) -> dict[str, Any]:
    s = entry.statement
    rating = {"ratingValue": RATINGS[entry.printed]} if entry.printed in RATINGS else {}
    marks = {
        "verdict": str(entry.printed), "evidence": str(entry.evidence), "extent": entry.extent,
        "shortfall": str(s.shortfall or ""), "conditions": s.conditions, "order": s.order, "digits": s.digits,
        "slip": s.slip,
    }  # fmt: skip
    marks = {name: value for name, value in marks.items() if value not in ("", None)}
    return {
        "@type": "ClaimReview",
        "@id": f"{URN}{s.id}#review",
        "itemReviewed": {"@id": URN + s.id},
        "claimReviewed": s.title,
        "reviewBody": s.note,
        "reviewRating": {"@type": "Rating", **rating, "bestRating": 5, "worstRating": 1,
                         "alternateName": str(entry.printed),
                         "ratingExplanation": "; ".join(f"{name}: {value}" for name, value in marks.items())},
        **marks,
        "version": __version__,
        "identifier": f"sha256:{digest(s)}",
    }  # fmt: skip


def _table(table: dict[str, Any], known: set[str]) -> Iterator[dict[str, Any]]:
    """The table and a node for each of its rows, with the statements about it."""
    paper, _, name = table["table"].partition(".")
    whole = URN + table["table"]
    rows = [f"{whole}:{row[0]}" for row in table["rows"]]
    parts = [{"@id": row} for row in rows]
    yield {"@type": "Dataset", "@id": whole, "name": table["title"], "description": table["provenance"],
           "isBasedOn": {"@id": _doi(paper)}, "variableMeasured": table["columns"], "hasPart": parts,
           "version": __version__}  # fmt: skip
    for here, row in zip(rows, table["rows"]):
        text = ", ".join(f"{column} = {cell}" for column, cell in zip(table["columns"], row))
        about = [{"@id": URN + i} for i in of_row(paper, name, row[0]) if i in known]
        yield {"@type": "Claim", "@id": here, "name": f"{table['title']}, row {row[0]}", "text": text,
               "isPartOf": {"@id": whole}, **({"about": about} if about else {})}  # fmt: skip


def of_row(paper: str, table: str, first: str) -> tuple[str, ...]:
    """The ids that statements about a row have: its exponent, or of half-cycle n the columns of S_(n-1) and u_(n-1).

    >>> of_row("lancaster2020", "table1", "3/2"), of_row("smith2012", "table1", "4")
    (('lancaster2020:table1.alpha3-2',), ('smith2012:table1.S3', 'smith2012:table1.u3'))
    """
    if paper == "lancaster2020":
        return (f"{paper}:{table}.alpha{first.replace('/', '-')}",)
    return tuple(f"{paper}:{table}.{column}{int(first) - 1}" for column in ("S", "u"))
