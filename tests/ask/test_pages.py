"""The page of --html of every question: formulas are MathML, nothing is program text, nothing is fetched."""

import re
import shlex
import sys
from functools import cache
from html import unescape

import pytest

from asymptotics.ask.registry import QUESTIONS
from asymptotics.errors import InputError
from asymptotics.made_by import code
from asymptotics.present.page import displayed, paragraphs, text
from asymptotics.present.signs import signs
from asymptotics.shell.main import main
from tests.every_question import example

FULL = {  # with formulas that the examples, which are answered at once, do not have
    "derive": "smith-turning-points",
    "motion": "--alpha 2 --epsilon 1/10 --time 1 --bound --order 2",
    "solution": "--alpha 2 --epsilon 1/10 --order 2 --time 7",
    "limit-cycle": "--law 1:-1 --law 3:1 --mu 1/10 --order 2 --digits 5",
    "multiple-scales": "--alpha 2 --order 1",
    "envelope": "--law 1:1/10 --law 2:1/20 --digits 5",
}
FORMULAS = [n for n in QUESTIONS if n not in ("compare", "identify", "sweep", "table", "papers", "smith")]


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    """The page of a question, written once."""

    @cache
    def written(name):
        folder = tmp_path_factory.mktemp(name)
        path = folder / f"{name}.html"
        words = [name, *shlex.split(FULL[name])] if name in FULL else example(name, folder)
        assert main([*words, "--html", str(path), "--quiet"]) in (0, 1), name
        return path.read_text(encoding="utf-8")

    return written


@pytest.mark.parametrize("name", QUESTIONS)
def test_every_question_has_a_page(page, name):
    html = page(name)
    seen = re.sub(r"<svg.*?</svg>|<style.*?</style>", "", html, flags=re.DOTALL)
    assert "\\" not in seen and "**" not in seen and "$" not in seen.replace("US$", ""), "program text on the page"
    assert not re.search(r"<script|https?://(?!www\.w3\.org)[^\s\"<]*\"", seen), "something is fetched"
    assert "Provenance" in seen and "power-law-oscillator" in seen
    assert code()[:16] in seen  # which code made it, as test_made_by.py asks of all other files
    assert ("<math" in seen) or name not in FORMULAS
    assert ("<svg" in html) or "No picture" in html or name not in ("damping", "motion", "turning-points", "response")


def unexplained(html):
    """The letters of formulas, words in upright letters apart, that the line below does not explain."""
    html = unescape(html)
    told_below = re.search(r'<p class="small">where(.*?)</p>', html, re.DOTALL)
    explained = set(re.findall(r"<mi>(\w)</mi>", told_below[1] if told_below else ""))
    shown = re.findall(r"<mi>(\w)</mi>", re.sub(r"<p class.*?</p>", "", html, flags=re.DOTALL))
    return set(shown) - explained - {"d", "e", "π"}  # of a differential, and numbers


@pytest.mark.parametrize("name", FORMULAS)
def test_the_letters_of_its_formulas_are_explained(page, name):
    """Each letter that the page sets in a formula stands in the line below, unless it names a function or a unit."""
    html = page(name)
    if name == "derive":  # a derivation explains its own letters, line by line; the line below said others
        assert '<p class="small">where' not in html
    else:
        assert unexplained(html) == set()
    stripped = re.sub(r'<p class="small">where.*?</p>', "", html, flags=re.DOTALL)
    assert unexplained(stripped) or name in ("derive", "moment"), "the walk sees no letter"


@pytest.mark.parametrize(("name", "meaning"), [
    ("stokes", "the imaginary unit"), ("multiple-scales", "velocity, V"),
    ("multiple-scales", "derivative with respect"),
    ("limit-cycle", "its period"), ("damping", "displacement; under an integral"), ("envelope", "slow amplitude; A(0)"),
])  # fmt: skip
def test_a_letter_means_on_a_page_what_it_means_there(page, name, meaning):
    """They were told as everywhere: i as a number that counts, V as a rate, T as the duration of a half-swing."""
    assert meaning in re.sub(r"<[^>]+>", "", page(name))


def test_a_driven_motion_has_its_force_in_the_equation(page):
    """The page had the equation of the free oscillator."""
    equation = re.sub(r"<[^>]+>", "", unescape(page("response").partition("<math")[2].partition("</math>")[0]))
    assert "cos" in equation and not equation.endswith("=0")


def test_hostile_text_stays_text(tmp_path, capsys):
    path = tmp_path / "<b>x.csv"
    path.write_text("n,x\n0,1\n1,-0.8766\n")
    page = tmp_path / "page.html"
    assert main(["compare", str(path), "--alpha", "2", "--epsilon", "1/10", "--html", str(page), "--quiet"]) == 0
    assert "<b>" not in page.read_text() and "&lt;b&gt;" in page.read_text()


def test_columns_are_a_table_and_words_are_not():
    assert paragraphs(["a  b", "c  d", "one blank"]).count("<tr>") == 2
    assert paragraphs(["one blank"]) == "<p>one blank</p>"


def test_without_the_extra_it_is_refused_by_name(monkeypatch):
    monkeypatch.setitem(sys.modules, "latex2mathml.converter", None)
    with pytest.raises(InputError, match="extra report"):
        displayed("x")


def test_a_greek_letter_without_a_meaning_is_seen():
    """latex2mathml writes them as entities: a walk over the characters alone passed them by."""
    assert unexplained(f"<p>{displayed(chr(92) + 'rho = 1')}</p>") == {"ρ"}


@pytest.mark.parametrize(
    ("line", "meant"),
    [
        ("expand --alpha 2 --spring pendulum --order 2", ["epsilon_1 A of x'|x'|", "A^2 of (sin x - x)"]),
        ("half-swing --law 2:1/10 --spring 3:1/5 --order 1", ["1/10 A of x'|x'|", "1/5 A^2 of x^3"]),
        ("expand --alpha 3/2 --order 2", ["epsilon A^(1/2) of x'|x'|^(1/2)"]),
    ],
)
def test_delta_means_what_it_is_of_each_force(tmp_path, capsys, line, meant):
    assert main([*line.split(), "--digits=5", "--html", str(tmp_path / "page.html"), "--quiet"]) == 0
    page = (tmp_path / "page.html").read_text()
    assert "epsilon A^(alpha-1)" not in page
    assert [part for part in meant if signs(text(part)) not in page] == []
