"""The report in plain English: a legend of the verdicts, no word of ours for a reader, no link or table cut short."""

import json
import re
import sys
from pathlib import Path

import pytest

from paper_checks.report.words import LEGEND, counted
from paper_checks.verdict import Printed

sys.path.insert(0, str(Path(__file__).parent))  # the module beside this one

from drawing import missing

OURS = re.compile(
    r"\bForm:|\bForm as for|\bBy:|\bholds claim\b"
    r"|(?<![\w.])(?<!= )(?:[2-9]|[1-9]\d+) (?:definition|misprint|transcription|partly)\b(?! true| slip)"
)
PLANTED = ("<p>28 definition, 3 open</p>", "<p>holds claim</p>", "<p>Form: the sign.</p>", "<p>By: quadrature</p>")


def told(page):
    """The text of a page without its tags, without TeX to be copied and listings of the source."""
    page = re.sub(r"(?s)<(pre|script|style)\b.*?</\1>", "", page)
    return re.sub(r"\s+", " ", re.sub(r"<[^>]*>", " ", page))


def test_the_legend_says_what_each_verdict_means(report):
    index = (report / "index.html").read_text()
    legend = index[index.index('class="legend"') :].partition("</dl>")[0]
    assert {name for name, *_ in LEGEND} == {*map(str, Printed)}
    for name, _, _, meaning in LEGEND:
        assert f">{name}</dt><dd>{meaning}</dd>" in legend


def test_no_page_has_a_word_of_the_program_for_a_reader(report):
    for page in report.glob("*.html"):
        if not page.name.startswith("source-"):
            assert OURS.findall(told(page.read_text())) == [], page.name


@pytest.mark.parametrize("page", PLANTED)
def test_such_a_word_is_noticed(page):
    assert OURS.findall(told(page))


def test_one_and_several_are_counted_in_words():
    shown = [counted(name, n) for name, *_ in LEGEND for n in (1, 2)]
    assert {"1 misprint", "2 misprints", "2 hold", "1 definition", "2 definitions"} <= {*shown}


def test_every_reference_table_says_whether_mpmath_has_recomputed_it(report):
    tables = [t for p in json.loads((report / "report.json").read_text())["papers"] for t in p["tables"]]
    assert [table["table"] for table in tables if ": equal" in table["validation"]] == ["smith2012.table1"]
    for name, route in (("smith2012", "recomputed by mpmath"), ("lancaster2020", "not by mpmath alone")):
        assert route in told((report / f"{name}.html").read_text())
    assert (report / "report.tex").read_text().count("mpmath") == len(tables)


def test_the_footer_leads_only_to_files_that_the_report_has(report):
    for page in report.glob("*.html"):
        footer = page.read_text().rpartition("<footer")[2]
        links = [link for link in re.findall(r'href="([^"]*)"', footer) if not link.startswith("https://doi.org/")]
        assert all((report / link).exists() for link in links), page.name
    assert "make docs" in (report / "index.html").read_text()  # what another command makes is named, not linked


@pytest.mark.skipif(bool(missing("chromium")), reason="needs Debian's chromium and chromium-driver")
@pytest.mark.parametrize(
    "pages",
    [("engine", "index"), pytest.param(("lancaster2020", "lelas2024", "smith2012"), marks=pytest.mark.slow)],
    ids=["tables", "papers"],
)
def test_no_table_is_cut_on_a_desktop(browser, report, pages):
    browser.set_window_size(1280, 900)
    cut = "return [...document.querySelectorAll('.scroll')].filter(s => s.scrollWidth > s.clientWidth + 1).length"
    for page in pages:
        browser.get((report / f"{page}.html").as_uri())
        assert browser.execute_script(cut) == 0, page
    browser.execute_script("document.querySelector('.scroll').style.width = '10em'")
    assert browser.execute_script(cut) > 0  # it can fail
