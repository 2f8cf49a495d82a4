"""The statements as installed data: fresh, complete, found by id, number and words."""

import json

import pytest

from asymptotics.errors import InputError
from asymptotics.papers.lookup import SHORTFALLS, find, paper, papers, statements
from asymptotics.shell.main import main
from paper_checks import data
from paper_checks.data import DATA, written
from paper_checks.registry import PAPERS, load
from tests.each import each


def test_the_data_are_those_of_the_registry():
    assert DATA.read_text(encoding="utf-8") == written(), "run python -m paper_checks --data"


def test_pages_that_a_target_writes_are_no_part_of_them(tmp_path, monkeypatch):
    """After `make benchmarks` the test above failed, for docs/benchmarks.md stood there."""
    for name in ("benchmarks.md", "reference/motion.md", "auto_gallery/plot.md", "symbols.md"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("# Title\n\n## Heading\n")
    monkeypatch.setattr(data, "DOCS", tmp_path)
    assert [page["page"] for page in data.doc_records()] == ["symbols"]
    ignored = (data.ROOT / ".gitignore").read_text().split()
    written_there = {line.removeprefix("docs/").rstrip("/*.") for line in ignored if line.startswith("docs/")}
    assert {name for name in written_there if not name.endswith(".rst")} <= {*data.UNREAD}


def test_every_statement_is_there():
    assert set(papers()) == set(PAPERS)
    assert [s.id for s in statements()] == list(load())
    assert {s.paper for s in statements("lelas2024")} == {"lelas2024"}


@pytest.mark.parametrize(
    ("query", "wanted"),
    [
        ("smith2012:62b", "smith2012:62b"),
        ("62b", "smith2012:62b"),
        ("(43)", "smith2012:43"),
        ("fn22", "lancaster2020:fn22"),
        ("Lambert", "smith2012:table1.u1"),
        ("S_3", "smith2012:table1.S3"),
        ("critically damped never", "smith2012:claim.never-overdamped"),
    ],
)
def test_found_by_id_number_and_words(query, wanted):
    assert wanted in [s.id for s in find(query)]


@each(
    ("query", "first"),
    [
        ("Lancaster eq. 13", "lancaster2020:13"),
        ("Lancaster's equation (13)", "lancaster2020:13"),
        ("smith 2012 eq 62b", "smith2012:62b"),
        ("Lelas (49)", "lelas2024:49"),
        ("Smith Table I", "smith2012:table1.S"),
        ("Lancaster Table 1", "lancaster2020:table1.alpha0"),
        ("envelope for alpha = 3/2", "lancaster2020:table1.alpha3-2"),
        ("envelope for \u03b1 = 3/2", "lancaster2020:table1.alpha3-2"),
        ("dry friction envelope", "lancaster2020:table1.alpha0"),
        ("Smith fig. 5", "smith2012:fig5"),
        ("figure 7", "smith2012:fig7"),
        ("footnote 22", "lancaster2020:fn22"),
        ("\u03ba", "lancaster2020:claim.kappa"),
        ("kappa", "lancaster2020:claim.kappa"),
        ("S_3", "smith2012:table1.S3"),
    ],
)
def test_the_words_of_a_referee_find_the_entry_first(query, first):
    assert find(query)[0].id == first


@each(
    ("query", "among"),
    [
        ("hypergeometric", "lancaster2020:fn22"),
        ("closed form of the recurrence", "smith2012:62b"),
        ("quadratic drag amplitude", "lelas2024:45"),
        ("where does the block stop", "lelas2024:value.rest-a"),
        ("when does the mass stick", "lancaster2020:fig1"),
        ("misprint", "smith2012:72"),
        ("typo", "lelas2024:10"),
        ("errata Smith", "smith2012:54"),
        ("refuted", "smith2012:claim.not-identifiable"),
        ("open", "lancaster2020:claim.fn20-speed"),
        ("generating function", "smith2012:claim.not-identifiable"),
        ("Coulomb friction envelope", "lelas2024:32"),
        ("equivalent linearisation", "lancaster2020:13"),
        ("exact period of the quadratic oscillator", "smith2012:55"),
        ("overdamping", "lancaster2020:claim.no-overdamping"),
        ("two laws together", "lancaster2020:20"),
        ("misprint of the zeppelin", "smith2012:72"),
    ],
)
def test_the_words_people_use_find_an_entry_among_the_first(query, among):
    assert among in [s.id for s in find(query)][:30]


def test_a_partial_match_is_shown_instead_of_nothing_and_a_full_one_alone():
    assert find("Lambert zeppelin") == find("Lambert")
    assert {s.printed for s in find("misprint")} == {"misprint"}


@pytest.mark.parametrize(("greek", "latin"), [("\u03b1", "alpha"), ("\u03c9", "omega"), ("\u03b3", "gamma")])
def test_greek_and_latin_letters_find_the_same(greek, latin):
    assert find(greek) == find(latin)


@pytest.mark.parametrize("query", ["smith:43", "Lambbert", "zzzz", "", "   ", "x" * 10_000, "\x00", "((((", "\\frac{"])
def test_what_is_not_found_is_said_in_one_line(query, capsys):
    assert main(["papers", query, "--verdict", "open"]) in (0, 2)
    shown = capsys.readouterr()
    assert "argument WHAT: " in shown.err or not shown.err
    assert "Traceback" not in shown.err
    assert shown.err.count("\n") <= 1
    assert len(shown.err) < 600


def test_near_words_are_suggested():
    with pytest.raises(InputError, match="smith2012:43"):
        paper("smith:43")
    with pytest.raises(InputError, match="Lambert"):
        find("Lambbert")
    for bad in (None, 43, 1.5, True):
        with pytest.raises(InputError):
            paper(bad)


def test_a_record_shows_itself():
    record = paper("smith2012:48")
    assert record.printed == "misprint"
    assert repr(record).startswith("<smith2012:48")
    assert record._repr_latex_().startswith("$")
    assert json.loads(json.dumps(record.to_dict()))["corrected"]


def test_each_way_of_being_partly_true_is_selected_and_counted(capsys):
    partly = statements(verdict="partly")
    chosen = {name: statements(verdict=name) for name in SHORTFALLS}
    assert sorted(s.id for found in chosen.values() for s in found) == sorted(s.id for s in partly)
    assert all(s.shortfall == SHORTFALLS[name] for name, found in chosen.items() for s in found) and all(
        chosen.values()
    )
    assert main(["papers", "--verdict", "partly-range"]) == 0
    assert capsys.readouterr().out.endswith(f"{len(chosen['partly-range'])} statements\n")
    assert main(["papers"]) == 0
    out = capsys.readouterr().out
    assert all(said in out for said in SHORTFALLS.values())
