"""The sheets that can be sent: complete, two pages at most, and every one of them compiled where there is an engine."""

import re
import shutil
import subprocess

import pytest

from paper_checks.errata import GARBLED, LINES, SAME, WRONG, harmless, sheets
from paper_checks.registry import PAPERS, expected_outcomes, load
from paper_checks.report.sheets import ENGINE, compiled
from paper_checks.report.tex import said
from paper_checks.verdict import Printed

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
                assert len(e.why) < 100 and e.why.endswith(".") and e.effect.endswith(".")
                assert e.effect.startswith((SAME, "Changes ")) and e.statement.corrected_latex
                number = e.statement.id.partition(":")[2]
                assert not number[0].isdigit() or e.place == f"Eq. ({number})"
    slipped = {f"smith2012:{name}" for name in ("52c", "56a", "59d", "claim.maximum-velocity")} | {"lelas2024:44"}
    assert slipped <= {s.id for key in PAPERS for s in harmless(key)}


def test_each_form_of_a_sheet_is_refuted_as_printed_and_confirmed_as_corrected():
    for key in LINES:
        outcomes = {name: str(outcome) for name, outcome in expected_outcomes(load()[key]).items()}
        assert (outcomes["printed"], outcomes["corrected"]) == ("refuted", "confirmed"), key


def misplaced(places):
    """The ids whose place in the text is not where the statement stands in reading order."""
    faults = []
    for key in PAPERS:
        ids = list(load(key))
        numbers = [n if re.fullmatch(r"\d+[a-d]?", n := i.partition(":")[2]) else None for i in ids]
        for at, key_of in enumerate(ids):
            if said_there := re.fullmatch(r"Text (above|below).*\((\w+)\)", places.get(key_of, "")):
                near = numbers[at::1] if said_there[1] == "above" else numbers[at::-1]
                faults += [key_of] if next(filter(None, near), None) != said_there[2] else []
    return faults


def test_a_place_in_the_text_is_where_the_statement_stands():
    places = {key: place for key, (place, *_) in LINES.items()}
    assert misplaced(places) == []
    assert misplaced({**places, "lancaster2020:claim.velocity-sign": "Text above (19)"}) != []


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
@pytest.mark.parametrize("name", DOCUMENTS)
def test_no_line_of_a_document_is_too_long(report, tmp_path, name):
    assert too_long(tmp_path, (report / f"{name}.tex").read_text()) == []


@needs_engine
def test_a_line_that_is_too_long_is_noticed(tmp_path):
    text = r"\documentclass{article}\begin{document}" + "m" * 200 + r"\end{document}"
    assert too_long(tmp_path, text) != []


def too_long(folder, text):
    """By how many points lines stand out into the margin, beyond 2."""
    (folder / "sheet.tex").write_text(text)
    run = subprocess.run([ENGINE, "-interaction=batchmode", "sheet.tex"], cwd=folder, capture_output=True, check=False)
    assert run.returncode == 0
    log = (folder / "sheet.log").read_text(errors="replace")
    return [float(found) for found in re.findall(r"Overfull \\hbox \(([\d.]+)pt", log) if float(found) > 2]


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
