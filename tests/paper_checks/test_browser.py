"""The report in a real browser: pages load without a network, formulas and figures are drawn, links and search work."""

import re
import sys
from pathlib import Path

import numpy as np
import pytest
from scipy import ndimage
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import Select, WebDriverWait

from asymptotics import present
from asymptotics.papers import derived, documented, lookup
from asymptotics.papers.search import ranked as by_command
from asymptotics.present.mathml import mathml
from paper_checks.report import font
from paper_checks.report.font import font_face

sys.path.insert(0, str(Path(__file__).parent))  # the two modules beside this one

from constructs import EXAMPLES, occurring
from drawing import Camera, inks, missing, reference, room, start, unlike

pytestmark = pytest.mark.skipif(
    bool(missing("chromium")), reason="needs Debian's chromium and chromium-driver, which .ci/run installs where it can"
)

_PAGE = Path(present.__file__).parent / "page.html"


@pytest.fixture(scope="module", params=["chromium", "firefox"])
def drawing(request, tmp_path_factory):
    """Every browser that is installed draws the formulas."""
    if missing(request.param):
        pytest.skip(f"not installed: {', '.join(missing(request.param))}")
    if request.param == "chromium":
        return request.getfixturevalue("browser")
    return start(request.param, tmp_path_factory.mktemp(request.param))


def widest(report, folder):
    """The page of the derivations with its longest formulas alone: to lay all of them out takes a browser seconds."""
    line = re.compile(r'<li id=".*?</li>', re.DOTALL)
    text = (report / "derivations.html").read_text(encoding="utf-8")
    formulas = {each: re.sub("<[^>]*>", "", each.partition('<div class="formula">')[2]) for each in line.findall(text)}
    kept = {*sorted(formulas, key=lambda each: len(formulas[each]))[-40:]}
    assert len(kept) == 40 < len(formulas) / 5
    page = folder / "derivations.html"
    text = line.sub(lambda found: found[0] if found[0] in kept else "", text)
    page.write_text(text.replace("<head>", f'<head><base href="{report.as_uri()}/">'), encoding="utf-8")
    return page


KINDS_OF_PAGES = ("engine", "errata", "errata-lelas2024", "index", "lelas2024", "play")
"""One of each, for `make test`; a paper's page takes a browser seconds, and `make test-thorough` asks it for all."""


@pytest.mark.parametrize("widths", [(390,), pytest.param((390, 768, 1280, 1920), marks=pytest.mark.slow)])
def test_no_page_is_wider_than_its_window(browser, report, widths, tmp_path):
    listings = sorted(report.glob("source-*.html"), key=lambda page: max(map(len, page.read_text().splitlines())))
    pages = sorted(report.glob("*.html"))
    if 1920 not in widths:  # of the listings, which differ in their longest line alone, the widest
        pages = [listings[-1], *(report / f"{name}.html" for name in KINDS_OF_PAGES), widest(report, tmp_path)]
    for page in pages:
        browser.get(page.as_uri())
        assert browser.find_element(By.TAG_NAME, "h1").text
        for width in widths:
            browser.set_window_size(width, 844)
            near = f"return Math.abs(innerWidth - {width}) < 20"
            WebDriverWait(browser, 20, poll_frequency=0.02).until(lambda b, near=near: b.execute_script(near))
            inner, needed = browser.execute_script("return [innerWidth, document.documentElement.scrollWidth]")
            assert needed <= inner, f"{page.name} is wider than {width} by {needed - inner} pixels"


def test_formulas_and_figures_are_drawn(browser, report):
    browser.get((report / "smith2012.html").as_uri())
    asked = "return [...document.querySelectorAll(arguments[0])].map(f => f.getBoundingClientRect().height)"
    heights = browser.execute_script(asked, "article > .formula math")
    assert len(heights) > 100
    assert min(heights) > 5
    fraction = browser.find_element(By.CSS_SELECTOR, "math mfrac").size["height"]
    assert fraction > 18  # two storeys: the browser lays MathML out, it does not print its text in a row
    figures = browser.find_elements(By.CSS_SELECTOR, "figure img")
    assert figures
    for figure in figures:
        browser.execute_script("arguments[0].scrollIntoView(); arguments[0].loading = 'eager'", figure)
        assert (
            browser.execute_async_script(
                "const [image, done] = arguments; image.decode().then(() => done(image.naturalWidth))", figure
            )
            > 100
        )


@pytest.fixture(scope="module")
def used(report):
    """The constructs of the report, their formulas, and the rules of the font as the pages carry them."""
    page = "".join(path.read_text() for path in sorted(report.glob("*.html")))
    css = (report / "style.css").read_text()
    return sorted(occurring(page)), page, css[css.index("@font-face") :]


def test_every_construct_is_drawn_as_the_reference_lays_it_out(drawing, used, tmp_path):
    names, _, css = used
    assert not set(names) - set(EXAMPLES), "constructs without a comparison"
    cells = [mathml(EXAMPLES[name], display=True) for name in names]
    got = inks(drawing, tmp_path / "drawn.html", cells, css)
    wanted = inks(drawing, tmp_path / "reference.html", [reference(cell) for cell in cells], css)
    slack = {n: room(drawing, n) for n in names}
    assert {n: unlike(g, w, slack[n]) for n, g, w in zip(names, got, wanted) if unlike(g, w, slack[n])} == {}


def test_a_font_without_the_root_or_without_tall_brackets_is_noticed(drawing, tmp_path, monkeypatch):
    """The comparison can fail: the subset of the text alone, which once hid every root, and one that cannot grow.

    Firefox takes what is missing from another font: there the letters without their root must be noticed.
    """
    cell = mathml(EXAMPLES["msqrt"], display=True)
    monkeypatch.setattr(font, "_BY_ELEMENT", {})
    bare = cell.replace("<msqrt>", "<mrow>").replace("</msqrt>", "</mrow>")
    (got,) = inks(drawing, tmp_path / "a.html", [bare if isinstance(drawing, Camera) else cell], font_face([cell]))
    (wanted,) = inks(drawing, tmp_path / "b.html", [reference(cell)], "")
    assert unlike(got, wanted)
    if isinstance(drawing, Camera):
        return
    tall = mathml(EXAMPLES["stretchy ("], display=True).replace('stretchy="true"', 'stretchy="false"')
    (got,) = inks(drawing, tmp_path / "c.html", [tall], font_face([tall]))
    (wanted,) = inks(drawing, tmp_path / "d.html", [reference(mathml(EXAMPLES["stretchy ("], display=True))], "")
    assert unlike(got, wanted)


def test_a_power_beside_an_index_leaves_the_letter_alone(drawing, tmp_path):
    """V leans over the place of its power: the page's style moves the power away; moved the other way they touch.

    Without a style they touch in earlier Chromiums, and no longer in 156.
    """
    cell = mathml("V_0^2")
    (style,) = re.findall(r"msubsup [^{}]*\{[^{}]*\}", _PAGE.read_text("utf-8"))
    nearer = "msubsup > :nth-child(3) { transform: translateX(-.5em); }"
    assert pieces(*inks(drawing, tmp_path / "touching.html", [cell], nearer)) == 2
    assert pieces(*inks(drawing, tmp_path / "apart.html", [cell], style)) == 3


def pieces(ink):
    """In how many pieces the ink falls: a letter, its index, its power."""
    return ndimage.label(ink > 0.15, np.ones((3, 3)))[1]


def test_brackets_about_a_letter_stand_close_to_it(drawing, tmp_path):
    """As close as brackets that stand by themselves, and those with the room that Chromium left are seen to be wide.

    Before 156 it left room for the largest size about a bracket that may grow.
    """
    pair = [mathml(r"X{\left(\psi \right)}"), mathml(r"X(\psi)")]
    assert 'stretchy="true"' not in pair[0]
    roomy = re.sub(r'(?=form="(pre|post)fix")', 'lspace=".2em" rspace=".2em" ', pair[0])
    widths = [ink.shape[1] for ink in inks(drawing, tmp_path / "brackets.html", [*pair, roomy], "")]
    assert widths[0] == widths[1] < widths[2] - 5


@pytest.mark.parametrize("page", ["index", "lelas2024", pytest.param("derivations", marks=pytest.mark.slow)])
def test_a_statement_is_found_from_every_page(browser, report, page):
    browser.get((report / f"{page}.html").as_uri())
    box, hits = browser.find_element(By.ID, "search"), {}
    for query, wanted in (("62b", "smith2012:62b"), ("S_3", "smith2012:table1.S3"), ("(43)", "smith2012:43")):
        box.clear()
        box.send_keys(query)
        links = browser.find_elements(By.CSS_SELECTOR, "#found a")
        hits[wanted] = next(a.get_attribute("href") for a in links if a.get_attribute("href").endswith("#" + wanted))
    for wanted, link in hits.items():  # the page of the hits is loaded once
        browser.get(link)
        assert browser.find_element(By.ID, wanted).is_displayed()


QUERIES = (
    "Lancaster eq. 13", "Lancaster's equation (13)", "Smith 2012 equation 62b", "Lelas (49)", "Smith fig. 5", "S_3",
    "footnote 22", "envelope for alpha = 3/2", "envelope for \u03b1 = 3/2", "dry friction envelope", "\u03ba", "kappa",
    "\u03c9", "omega", "\u03b1", "alpha", "Lambert", "critically damped never", "squaring trick", "Smith", "zzzz",
    r"\frac{",
)  # fmt: skip


def test_the_search_of_a_page_ranks_as_the_command_does(browser, report):
    browser.get((report / "index.html").as_uri())
    ranks = browser.execute_script("return arguments[0].map(q => ranked(q).map(e => e.id))", list(QUERIES))
    searched = [*lookup.searched(), *derived.searched(), *documented.searched()]
    tables = {name.replace(".", ":") for name in ("lancaster2020.table1", "smith2012.table1", "smith2012.transit-time")}
    for query, found in zip(QUERIES, ranks):
        assert [key for key in found if key not in tables] == by_command(searched, query), query


def test_a_table_is_the_first_hit_of_its_number(browser, report):
    browser.get((report / "index.html").as_uri())
    for query, wanted in (("Smith Table I", "smith2012.table1"), ("Lancaster Table 1", "lancaster2020.table1")):
        browser.find_element(By.ID, "search").clear()
        browser.find_element(By.ID, "search").send_keys(query)
        first = browser.find_element(By.CSS_SELECTOR, "#found a").get_attribute("href")
        assert first.endswith("#" + wanted), first


def test_nothing_found_is_said_and_verdicts_are_filtered(browser, report):
    browser.get((report / "smith2012.html").as_uri())
    box = browser.find_element(By.ID, "search")
    box.send_keys("zzzz")
    assert "Nothing found" in browser.find_element(By.ID, "found").text
    Select(browser.find_element(By.ID, "filter")).select_by_visible_text("misprint")
    # what takes no room is not displayed
    asked = "return [...document.querySelectorAll('article')].filter(a => a.offsetHeight).map(a => a.dataset.verdict)"
    assert {*browser.execute_script(asked)} == {"misprint"}
