"""Every result type shows itself: verdict or value first, every symbol defined, a few lines, rows as numbers."""

import inspect
import re
import sys
import time
from html.parser import HTMLParser

import pytest

import asymptotics as asy
from asymptotics.errors import InputError
from asymptotics.present.letters import MEANINGS, letters
from asymptotics.present.shown import MAX_LINES, Page, Rows, Shown, frame
from asymptotics.present.signs import signs
from tests.each import each
from tests.present import every_type
from tests.present.every_type import SAMPLES, name_of, types

CLAIM = re.compile(r"certified|estimate|measured|exact|proved|correctly rounded|heuristic|formal|intervals: ")
SAYINGS = {  # what was asked, a verdict in words, or a report of what was done: no number that could be uncertain
    "law.Law", "law.Oscillator", "law.PhysicalLaw", "terms.Term", "frames.Frame", "sweeps.run.SweepResult",
    "papers.statement.PaperStatement",
    "decays.identification.telling.result.Identification", "decays.identification.telling.verdicts.Verdict",
    "decays.identification.judging.allowance.Allowance",
}  # fmt: skip


@pytest.fixture(scope="module")
def made():
    return {name: every_type.made()[text] for name, text in SAMPLES.items()}


@pytest.fixture(scope="module")
def cards(made):
    """What a notebook shows of each, written once: a picture takes a tenth of a second."""
    return {name: found._repr_html_() for name, found in made.items()}


class Elements(HTMLParser):
    """The elements of a page, opened and closed in their order."""

    def __init__(self, page):
        super().__init__()
        self.open, self.seen = [], []
        self.feed(page)
        assert not self.open

    def handle_starttag(self, tag, attrs):
        self.seen.append(tag)
        if tag != "img":
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


@each("text", (*SAMPLES.values(), *every_type.VARIANTS))
def test_the_repr_of_every_result_is_instant_and_short(text):
    found = every_type.made()[text]
    begin = time.process_time()
    shown = repr(found)
    assert time.process_time() - begin < 0.02
    if type(found).__module__.startswith("asymptotics.curves") or isinstance(found, asy.Equations):
        assert len(shown) < 300
    for show in ("_repr_latex_", "to_dict", "__str__"):
        assert getattr(found, show, lambda: "")() is not None


def test_every_type_has_a_sample_and_shows_itself():
    assert {name_of(found) for found in types()} == set(SAMPLES)
    assert [name_of(found) for found in types() if not issubclass(found, Shown)] == []


def test_the_walk_finds_a_type_that_does_not_show_itself(monkeypatch):
    class Silent:
        """A new result."""

    Silent.__module__ = "asymptotics.somewhere"

    def new() -> Silent:
        """A public function."""
        return Silent()

    new.__annotations__["return"] = Silent
    monkeypatch.setattr(asy, "__all__", [*asy.__all__, "new"])
    monkeypatch.setattr(asy, "new", new, raising=False)
    types.cache_clear()
    assert "somewhere.test_the_walk_finds_a_type_that_does_not_show_itself.<locals>.Silent" in map(name_of, types())
    types.cache_clear()


@pytest.mark.timeout(120)
def test_pages_start_with_the_verdict_and_say_what_it_is_worth(made, cards):
    for name, found in made.items():
        assert name_of(type(found)) == name
        page, shown = found._page(), cards[name]
        Elements(shown)
        assert shown.startswith("<div><p><strong>") and page.title, name
        assert name in SAYINGS or CLAIM.search("\n".join([page.title, *page.lines])), f"{name}: {page}"
        assert "object at 0x" not in shown, name
        assert all(len(row) == len(page.head) for row in page.rows), name


def test_a_program_may_look_at_every_result(made):
    """``hasattr`` and ``inspect.getmembers`` meet no error: what a value has not, it has not."""
    for found in made.values():
        assert inspect.getmembers(found)
    assert not hasattr(made["limit_cycles.result.LimitCycle"], "at")
    assert hasattr(asy.turning_points({2: 1}, 2, times=True)[1], "tau")
    assert not hasattr(asy.turning_points({2: 1}, 2, times=True)[1], "t")


UNSET = re.compile(
    r"\*|\\|sqrt\(|\^|Integral\(|Derivative\(|(?<![A-Za-z_])[A-Za-z]_\d|\b(?:alpha|epsilon|kappa|omega)_\d"
)


def unset(html):
    """The signs of a program or of TeX that a card shows; what stands inside a tag is none."""
    return UNSET.findall(re.sub(r"<[^>]*>", "", html))


@pytest.mark.timeout(120)
def test_the_mathematics_of_every_card_is_typeset(cards):
    assert {name: found for name, card in cards.items() if (found := unset(card))} == {}
    assert {s.id: found for s in asy.statements() if (found := unset(s._repr_html_()))} == {}
    assert "<math" in asy.paper("smith2012:62b")._repr_html_()


@pytest.mark.parametrize("text", [r"\sum_n", "a**2", "2*x", "sqrt(2)", "x^2", "kappa_1", "Integral(x, x)"])
def test_a_sign_of_a_program_is_noticed(text):
    assert unset(f"<p>{text}</p>")


def test_what_is_to_be_copied_or_is_a_name_stays():
    for text in ("asymptotics expand --alpha 2 --order 4", "asy.law(epsilon_1)", "energy_loss", "my_x_file.csv"):
        assert signs(text) == text


def test_without_the_converter_a_notebook_sets_the_formula(monkeypatch):
    monkeypatch.setitem(sys.modules, "latex2mathml.converter", None)
    assert "$e^{-2u_0}" in asy.paper("smith2012:43")._repr_html_()


def test_at_is_a_method_wherever_it_is(made):
    """One word, one meaning: ``.at(t)`` is a call; a result without it has no such attribute, or refuses it by name."""
    asked = {}
    for name, found in made.items():
        try:
            asked[name] = getattr(found, "at", None)
        except InputError:
            continue
    assert sum(each is not None for each in asked.values()) > 3
    assert [name for name, each in asked.items() if each is not None and not callable(each)] == []


def undefined(formula, own):
    """The letters of a formula that nothing defines."""
    return letters(formula) - set(MEANINGS) - set(own)


@pytest.mark.timeout(120)
def test_formulas_define_their_letters(made):
    for name, found in made.items():
        formula = found._formula()
        assert undefined(formula, found._letters()) == set(), name
        shown = found._repr_latex_()
        assert shown.startswith("$") and formula.count("{") == formula.count("}"), name
        assert all(f"${letter}$: " in shown for letter in letters(formula)), name


def test_a_letter_that_nothing_defines_is_noticed():
    assert undefined(r"\zeta + x_{\lambda} + \sin y", {}) == {r"\zeta", r"\lambda"}
    assert undefined(r"\zeta", {r"\zeta": "known here"}) == set()


@pytest.mark.timeout(120)
def test_representations_are_a_few_lines(made):
    for name, found in made.items():
        lines = repr(found).splitlines()
        assert 0 < len(lines) <= MAX_LINES + 1 and max(map(len, lines)) <= 240, name


@pytest.mark.timeout(120)
def test_rows_become_columns_of_numbers(made):
    shown = {name: found.to_dataframe() for name, found in made.items() if isinstance(found, Rows)}
    assert len(shown) > 12
    for name, table in shown.items():
        assert len(table) and len(table.columns), name
        for column in table.columns:
            cells = table[column].dropna()
            assert not any(isinstance(cell, str) and re.match(r"\[.*,.*\]", cell) for cell in cells), (name, column)
        for low in [c for c in table.columns if c.endswith("_low")]:
            value, high = low.removesuffix("_low"), low.replace("_low", "_high")
            inside = table[[low, value, high]].dropna()
            assert (inside[low] <= inside[value]).all() and (inside[value] <= inside[high]).all(), name


def test_the_ends_of_a_column_hold_the_number(made):
    table = made["tables.table.Table"].to_dataframe()
    assert table["half_cycle"].tolist()[:3] == [1, 2, 3]
    lambert = -0.410719686061039446699724  # Smith 2012, Table I, u_2
    assert table["u_low"][1] <= lambert <= table["u_high"][1]
    assert table["u_high"][1] - table["u_low"][1] < 1.1e-9


def test_an_estimate_has_no_ends(made):
    table = made["motions.result.MotionSamples"].to_dataframe()
    assert list(table.columns) == ["t [s]", "x [m]", "v [m/s]", "amplitude [m]", "phase [rad]"]
    assert not any(c.endswith("_low") for c in table.columns)


def test_a_frame_without_pandas_says_what_is_missing(monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(InputError, match=r"pip install '.*\[pandas\]'"):
        frame({"n": [1]})


def test_a_long_table_is_cut_and_says_so():
    class Long(Shown):
        def _page(self):
            return Page("n", (), ("n",), tuple((n,) for n in range(40)))

    shown = Long()._repr_html_()
    assert shown.count("<tr>") == 14 and "28 more rows" in shown


@pytest.mark.timeout(120)
def test_what_is_shown_is_escaped():
    class Sly(Shown):
        def _page(self):
            return Page("<script>", ("<b>",), ("<i>",), (("<u>",),))

    known = {"div", "p", "strong", "table", "thead", "tbody", "tr", "th", "td"}
    assert set(Elements(Sly()._repr_html_()).seen) <= known
