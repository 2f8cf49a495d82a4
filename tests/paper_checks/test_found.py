"""What a referee, a teacher or an engineer types finds the right thing: on a page, in the shell and in Python."""

import json
import sys
from pathlib import Path

import pytest

from asymptotics.errors import InputError
from asymptotics.papers import derived, documented, lookup
from asymptotics.papers.derived import derivations
from asymptotics.papers.documented import documentation
from asymptotics.papers.everything import look_up
from asymptotics.papers.lookup import statements
from asymptotics.papers.search import ranked
from asymptotics.shell.main import main
from paper_checks.data import DOCS

sys.path.insert(0, str(Path(__file__).parent))  # the module beside this one

from drawing import missing

from tests.each import each

ASKED = {  # what is typed: what must be among the first five of its kind
    "hypergeometric": ("lancaster2020:fn22", "two-laws-time", ""),
    "closed form of the recurrence": ("smith2012:62b", "smith-closed-sum", ""),
    "quadratic drag amplitude": ("lelas2024:45", "lelas-air", ""),
    "where does the block stop": ("lelas2024:49", "lelas-friction-exact", ""),
    "misprint": ("lelas2024:10", "lelas-viscous", ""),
    "hysteretic": ("", "equivalent-damping", "docs/words: Hysteretic damping"),
    "loss factor": ("", "equivalent-damping", "docs/words: Loss factor"),
    "structural damping": ("", "equivalent-damping", "docs/words: Structural damping"),
    "backbone": ("", "duffing-first-order", "docs/words: Backbone curve"),
    "equivalent linearisation": ("lancaster2020:13", "equivalent-damping", "docs/words: Equivalent linearisation"),
    "driven": ("", "driven-unique", "docs/words: Driven oscillator"),
    "forced oscillator": ("", "", "docs/words: Driven oscillator"),
    "stick-slip": ("lelas2024:49", "lelas-friction-exact", ""),
    "quality factor": ("", "equivalent-damping", "docs/theory/equivalent_damping: Equivalent damping"),
    "logarithmic decrement": ("lancaster2020:14", "equivalent-damping", "docs/words: Logarithmic decrement"),
    "terminal amplitude": ("lancaster2020:claim.forgets-x0", "creep-arrival", "docs/words: Terminal amplitude"),
    "energy loss per cycle": ("lelas2024:48", "equivalent-damping", ""),
    "is it ever overdamped": ("lancaster2020:claim.no-overdamping", "no-overdamping", ""),
    "how slow is the phase drift": ("lancaster2020:claim.phase-constant", "finite-phase-lag", ""),
    "first-order period": ("smith2012:70", "smith-generating-functions", ""),
    "dry friction exact solution": ("lelas2024:49", "lelas-friction-exact", ""),
    "phase portrait": ("smith2012:fig1", "smith-matching", ""),
    "conserved quantity": ("smith2012:38b", "smith-integrating-factor", ""),
    "combined linear and quadratic damping": ("lancaster2020:21", "two-laws-time", ""),
    "weak damping condition": ("lelas2024:33", "lelas-friction", ""),
    "squaring trick": ("lelas2024:32", "lelas-friction", ""),
    "Euler beta function": ("lancaster2020:12", "lancaster-average", ""),
    "turning points closed form": ("smith2012:43", "smith-turning-points", ""),
    "numerical integration artefact": ("lancaster2020:fn20", "", ""),
    "elementary functions": ("smith2012:claim.not-elementary", "smith-not-elementary", ""),
    "pendulum": ("", "pendulum-first-order", "docs/theory/springs: Springs and position-dependent losses"),
    "Rayleigh dissipation": ("lancaster2020:7", "", "docs/words: Rayleigh dissipation function"),
    "how do I cite a value": ("", "", "docs/tables: How to cite a value"),
    "Lambert zeppelin": ("smith2012:43", "smith-turning-points", ""),
}
FIRST = 5


def asked(kind):
    return [(query, wanted[kind]) for query, wanted in ASKED.items() if wanted[kind]]


@each(("query", "wanted"), asked(0))
def test_python_finds_the_statement(query, wanted):
    assert wanted in [s.id for s in statements(query)][:FIRST]


@each(("query", "wanted"), asked(1))
def test_python_and_the_shell_find_the_derivation(query, wanted, capsys):
    assert wanted in [d.name for d in derivations(query)][:FIRST]
    if "-" not in query:  # else it is a slip of a name
        assert main(["derive", query]) == 0
        assert wanted in capsys.readouterr().out


@each(("query", "wanted"), asked(2))
def test_the_documentation_is_found(query, wanted):
    assert wanted in [str(section) for section in documentation(query)][:FIRST]


def looked_up(query):
    """All that must be found of a query in the search over all kinds, where the best match has as many words."""
    found = look_up(query)
    return [s.id for s in found.statements] + [d.name for d in found.derivations] + list(map(str, found.documentation))


@pytest.mark.parametrize("query", ASKED)
def test_one_search_over_all_kinds_finds_the_right_thing(query, capsys):
    assert {*ASKED[query]} & {*looked_up(query)}
    assert main(["papers", query]) == 0
    out = capsys.readouterr().out
    assert any(wanted in out for wanted in ASKED[query] if wanted)
    assert main(["papers", query, "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    names = [e["id"] for e in data["entries"]] + [d["name"] for d in data["derivations"]]
    assert len(names) + len(data["documentation"]) == len(looked_up(query))


@pytest.mark.parametrize("query", ["hysteretic", "cluster"])
def test_where_no_statement_has_a_word_the_error_names_the_page_that_has(query, capsys):
    with pytest.raises(InputError, match="docs/(words|cluster): "):
        statements(query)
    assert main(["derive", "phone"]) == 2
    assert "docs/tutorials/phone: Tutorial" in capsys.readouterr().err


def test_what_nobody_has_is_not_found():
    assert not look_up("zzzz") and documentation("zzzz") == ()


def test_every_page_that_is_found_exists_with_its_heading():
    for section in documented.sections().values():
        if section.page.startswith("gallery/"):
            assert section.title in (DOCS / f"{section.page}.py").read_text()
        else:
            text = (DOCS / f"{section.page}.md").read_text()
            heads = [
                line.lstrip("# ").translate(str.maketrans("", "", "`*$")) for line in text.splitlines() if "#" in line
            ]
            assert {section.title, section.heading or section.title} <= {*heads}


@pytest.mark.skipif(bool(missing("chromium")), reason="needs Debian's chromium and chromium-driver")
def test_the_search_of_a_page_finds_the_same(browser, report):
    browser.get((report / "index.html").as_uri())
    ranks = browser.execute_script("return arguments[0].map(q => ranked(q).map(e => e.id))", list(ASKED))
    everything = [*lookup.searched(), *derived.searched(), *documented.searched()]
    tables = {name.replace(".", ":") for name in ("lancaster2020.table1", "smith2012.table1", "smith2012.transit-time")}
    for query, found in zip(ASKED, ranks):
        assert [key for key in found if key not in tables] == ranked(everything, query), query
    browser.find_element("id", "search").send_keys("structural damping")
    shown = browser.find_element("id", "found").text
    assert "docs/words Structural damping" in shown and "equivalent-damping" in shown
