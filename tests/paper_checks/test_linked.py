"""The statements as linked data: each a claim with a review, an identity that stays, the papers by their DOIs."""

import json
import re
from pathlib import Path

import pytest

from paper_checks.reader import digest
from paper_checks.registry import FOLLOW_UPS, IDENTIFIERS, Entry, expected_outcomes, load
from paper_checks.report.linked import OWN, URN, linked

ROOT = Path(__file__).parents[2]
SCHEMA = {  # the terms of schema.org that are used, by the type that has them
    "ScholarlyArticle": {"name", "identifier", "sameAs", "about"},
    "Claim": {"name", "text", "encodingFormat", "position", "appearance", "correction", "isPartOf", "about"},
    "ClaimReview": {"itemReviewed", "claimReviewed", "reviewBody", "reviewRating", "version", "identifier"},
    "Dataset": {"name", "description", "isBasedOn", "variableMeasured", "hasPart", "version"},
}


@pytest.fixture(scope="module")
def data(report):
    return json.loads((report / "registry.jsonld").read_text())


def test_every_statement_is_a_claim_with_a_review_and_an_identity_that_stays(data):
    nodes = data["@graph"]
    claims = {n["@id"]: n for n in nodes if n["@type"] == "Claim"}
    reviews = {n["itemReviewed"]["@id"]: n for n in nodes if n["@type"] == "ClaimReview"}
    articles = {n["@id"]: n for n in nodes if n["@type"] == "ScholarlyArticle"}
    assert set(reviews) == {URN + key for key in load()} <= set(claims)
    for key, entry in load().items():
        claim, review = claims[URN + key], reviews[URN + key]
        assert set(articles[claim["appearance"]["@id"]]["identifier"]) == {
            f"{kind}:{number}".replace("arxiv", "arXiv") for kind, number in IDENTIFIERS[entry.paper].items() if number
        }
        assert claim.get("equation") == (found[1] if (found := re.fullmatch(r"\w+:(\d+[a-z]?)", key)) else None)
        assert (claim["text"], claim.get("correction")) == (entry.latex, entry.corrected_latex)
        assert review["verdict"] == review["reviewRating"]["alternateName"] == entry.verdict
        assert (review["evidence"], review["conditions"]) == (entry.evidence, entry.conditions)
        assert review.get("shortfall") == entry.shortfall and review["identifier"] == f"sha256:{digest(entry)}"
    assert len({n["@id"] for n in nodes}) == len(nodes)


def test_how_far_a_sample_reaches_is_in_the_review():
    class Sampled(Entry):
        extent = "sampled: 4 points"

    s = load()["smith2012:69"]
    (review,) = (n for n in linked([Sampled(s, expected_outcomes(s), 0.0)])["@graph"] if n["@type"] == "ClaimReview")
    assert (
        review["extent"] == "sampled: 4 points"
        and "extent: sampled: 4 points" in review["reviewRating"]["ratingExplanation"]
    )


def test_every_row_of_a_table_has_an_id_and_the_statements_about_it(data, report):
    nodes = {n["@id"]: n for n in data["@graph"]}
    tables = [t for p in json.loads((report / "report.json").read_text())["papers"] for t in p["tables"]]
    assert len(tables) == 3
    for table in tables:
        whole = nodes[URN + table["table"]]
        rows = [nodes[part["@id"]] for part in whole["hasPart"]]
        assert len(rows) == len(table["rows"]) and all(
            cell in row["text"] for row, cells in zip(rows, table["rows"]) for cell in cells
        )
    fourth = nodes[URN + "smith2012.table1:4"]
    assert [a["@id"] for a in fourth["about"]] == [URN + "smith2012:table1.S3", URN + "smith2012:table1.u3"]
    assert [a["@id"] for a in nodes[URN + "lancaster2020.table1:3/2"]["about"]] == [
        URN + "lancaster2020:table1.alpha3-2"
    ]


def test_the_later_papers_bear_on_statements(data):
    nodes = {n["@id"]: n for n in data["@graph"]}
    for number, title, ids in FOLLOW_UPS:
        node = nodes[f"https://arxiv.org/abs/{number}"]
        assert node["name"] == title and {a["@id"] for a in node["about"]} == {URN + i for i in ids} <= set(nodes)


def test_every_term_is_of_schema_org_or_of_the_context(data):
    own = set(data["@context"][1])
    assert own == set(OWN)
    for node in data["@graph"]:
        assert set(node) - {"@id", "@type"} <= SCHEMA[node["@type"]] | own, node["@id"]


def test_the_papers_are_named_by_their_dois_on_every_page(report):
    cited = (ROOT / "CITATION.cff").read_text()
    for known in IDENTIFIERS.values():
        assert f"doi: {known['doi']}" in cited and (not known["arxiv"] or f"arXiv:{known['arxiv']}" in cited)
    for page in report.glob("*.html"):
        assert all(f"doi:{known['doi']}" in page.read_text() for known in IDENTIFIERS.values()), page.name
