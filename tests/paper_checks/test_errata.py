"""The sheets that can be sent: complete, two pages at most, and every one of them compiled where there is an engine."""

import json
import re
import shutil
from pathlib import Path

import pytest

from paper_checks.errata import GARBLED, LINES, WRONG, harmless, sheets
from paper_checks.reader import digest
from paper_checks.registry import IDENTIFIERS, PAPERS, load
from paper_checks.report.linked import URN, linked
from paper_checks.report.sheets import ENGINE, compiled
from paper_checks.report.tex import said
from paper_checks.verdict import Printed

ROOT = Path(__file__).parents[2]
DOCUMENTS = [f"errata-{key}" for key in PAPERS] + ["comment-smith2012"]
needs_engine = pytest.mark.skipif(shutil.which(ENGINE) is None, reason=f"needs {ENGINE}, of texlive-latex-base")


def test_a_sheet_has_every_slip_of_its_paper_and_no_other():
    wrong = {key for key, entry in load().items() if entry.verdict in WRONG}
    assert set(LINES) == wrong
    for key, sheet in sheets().items():
        assert {e.statement.id for errata in sheet.values() for e in errata} == {i for i in wrong if i.startswith(key)}
        for errata in sheet.values():
            for e in errata:
                assert (e.origin == GARBLED) == (e.statement.verdict == Printed.TRANSCRIPTION), e.statement.id
                assert len(e.why) < 100 and e.why.endswith(".") and e.statement.corrected_latex
                number = e.statement.id.partition(":")[2]
                assert not number[0].isdigit() or e.place == f"Eq. ({number})"
    assert harmless("smith2012")


def unbalanced(text):
    """What a lexer finds wrong: braces, environments, an index outside of mathematics."""
    faults, depth, text = [], 0, re.sub(r"\\[{}$%&#_]", "", text)
    for sign in text:
        depth += {"{": 1, "}": -1}.get(sign, 0)
        faults += ["a brace too many"] if depth < 0 else []
    faults += [f"{depth} braces open"] if depth else []
    faults += ["a dollar is open"] if text.count("$") % 2 else []
    opened = re.findall(r"\\begin\{(\w+\*?)\}", text)
    faults += [e for e in set(opened) if opened.count(e) != len(re.findall(rf"\\end\{{{re.escape(e)}\}}", text))]
    return faults


@pytest.mark.parametrize("name", DOCUMENTS)
def test_the_documents_are_balanced_and_ascii(report, name):
    text = (report / f"{name}.tex").read_text()
    assert unbalanced(text) == [] and text.isascii()


def test_the_lexer_notices():
    assert unbalanced(r"\begin{a}$x$}") != [] and unbalanced("$x") != [] and unbalanced("{") != []


@needs_engine
@pytest.mark.parametrize("name", DOCUMENTS)
def test_the_documents_compile_to_two_pages_at_most(report, name):
    pdf = (report / f"{name}.pdf").read_bytes()
    assert pdf.startswith(b"%PDF") and pdf == compiled((report / f"{name}.tex").read_text())
    found = re.findall(rb"/Type\s*/Page\b", pdf) or re.findall(rb"/Count (\d+)", pdf)
    assert not found or len(found) <= 2


@needs_engine
def test_a_document_that_does_not_compile_says_why():
    with pytest.raises(RuntimeError, match="Undefined control sequence"):
        compiled(r"\documentclass{article}\begin{document}\nonsense\end{document}")


@needs_engine
@pytest.mark.slow
def test_the_whole_report_compiles(report):
    text = re.sub(r"\\includegraphics\[[^]]*\]\{[^{}]*\}", "", (report / "report.tex").read_text())
    assert compiled(text).startswith(b"%PDF")


def test_every_note_becomes_latex():
    for key, entry in load().items():
        for text in (entry.note, entry.conditions, entry.slip, *entry.methods):
            shown = said(text)
            assert unbalanced(shown) == [], (key, shown)
            assert not re.search(r"(?<!\\)[_^]", re.sub(r"\$[^$]*\$", "", shown)), (key, shown)


def test_every_statement_is_a_claim_with_a_review_and_an_identity_that_stays():
    nodes = linked(list(load().values()))["@graph"]
    claims = {n["@id"]: n for n in nodes if n["@type"] == "Claim"}
    reviews = {n["itemReviewed"]["@id"]: n for n in nodes if n["@type"] == "ClaimReview"}
    articles = {n["@id"] for n in nodes if n["@type"] == "ScholarlyArticle"}
    assert set(claims) == set(reviews) == {URN + key for key in load()}
    for key, entry in load().items():
        assert claims[URN + key]["appearance"]["@id"] in articles
        assert reviews[URN + key]["reviewRating"]["alternateName"] == entry.verdict
        assert reviews[URN + key]["identifier"] == f"sha256:{digest(entry)}"
    assert len({n["@id"] for n in nodes}) == len(nodes)


def test_the_data_of_the_report_has_the_registry_and_the_dois(report):
    assert json.loads((report / "registry.jsonld").read_text()) == linked(list(load().values()))
    cited = (ROOT / "CITATION.cff").read_text()
    for known in IDENTIFIERS.values():
        assert f"doi: {known['doi']}" in cited and (not known["arxiv"] or f"arXiv:{known['arxiv']}" in cited)
    for page in report.glob("*.html"):
        if page.name != "play.html":
            assert all(f"doi:{known['doi']}" in page.read_text() for known in IDENTIFIERS.values()), page.name
