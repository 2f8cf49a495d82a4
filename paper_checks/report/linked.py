"""The statements as linked data (JSON-LD, schema.org): each a Claim of its paper, with the ClaimReview of its check.

An id is that of the statement, a row of a table included, and stays when its place in the code changes; the digest is
that of everything printed of the statement and of its forms, as the ledger has it.

>>> from paper_checks.registry import load
>>> graph = linked([load()["smith2012:table1.S3"]])["@graph"]
>>> [node["@type"] for node in graph], graph[1]["@id"], graph[2]["reviewRating"]["alternateName"]
(['ScholarlyArticle', 'Claim', 'ClaimReview'], 'urn:power-law-oscillator:smith2012:table1.S3', 'misprint')
"""

from collections.abc import Sequence
from typing import Any

from asymptotics import __version__
from paper_checks.reader import digest
from paper_checks.registry import IDENTIFIERS, PAPERS, Statement
from paper_checks.verdict import Printed

URN = "urn:power-law-oscillator:"
RATINGS = {  # out of 5, as ClaimReview has it: for what reads numbers alone
    Printed.HOLDS: 5, Printed.DEFINITION: 5, Printed.TRANSCRIPTION: 4, Printed.PARTLY: 3, Printed.MISPRINT: 2,
    Printed.REFUTED: 1,
}  # fmt: skip


def linked(statements: Sequence[Statement]) -> dict[str, Any]:
    """The graph of the papers, their claims and the reviews of these."""
    papers = [key for key in PAPERS if any(s.paper == key for s in statements)]
    nodes = [_article(key) for key in papers]
    for statement in statements:
        nodes += [_claim(statement), _review(statement)]
    return {"@context": "https://schema.org", "@graph": nodes}


def _article(key: str) -> dict[str, Any]:
    doi, arxiv = IDENTIFIERS[key]["doi"], IDENTIFIERS[key]["arxiv"]
    other = {"sameAs": f"https://arxiv.org/abs/{arxiv}"} if arxiv else {}
    name = {"name": PAPERS[key][0], "identifier": f"doi:{doi}"}
    return {"@type": "ScholarlyArticle", "@id": f"https://doi.org/{doi}", **name, **other}


def _claim(s: Statement) -> dict[str, Any]:
    found = {"name": s.title, "text": s.latex, "position": s.id.partition(":")[2]}
    corrected = {"correction": s.corrected_latex} if s.corrected_latex else {}
    article = {"@id": f"https://doi.org/{IDENTIFIERS[s.paper]['doi']}"}
    return {"@type": "Claim", "@id": URN + s.id, **found, "appearance": article, **corrected}


def _review(s: Statement) -> dict[str, Any]:
    marks = {"alternateName": str(s.verdict), "ratingExplanation": "; ".join(filter(None, _marks(s)))}
    rating = {"ratingValue": RATINGS[s.verdict], "bestRating": 5, "worstRating": 1} if s.verdict in RATINGS else {}
    return {
        "@type": "ClaimReview",
        "@id": f"{URN}{s.id}#review",
        "itemReviewed": {"@id": URN + s.id},
        "claimReviewed": s.title,
        "reviewBody": s.note,
        "reviewRating": {"@type": "Rating", **rating, **marks},
        "version": __version__,
        "identifier": f"sha256:{digest(s)}",
    }


def _marks(s: Statement) -> tuple[str, ...]:
    return str(s.shortfall or ""), str(s.evidence), s.extent, f"conditions: {s.conditions}"
