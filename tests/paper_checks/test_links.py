"""A derivation lifts a label only by a line that says what it proves; both ends of each link are there."""

from dataclasses import replace
from importlib import import_module

import pytest

from derivations.__main__ import names
from paper_checks.evidence import Marks
from paper_checks.registry import Entry, expected_outcomes, load, proved_by_line
from paper_checks.verdict import Evidence, Outcome

ENTRIES = load()
LINKED = [key for key, entry in ENTRIES.items() if entry.line is not None]


def derivation(name):
    return import_module("derivations." + name.replace("-", "_")).derivation


@pytest.mark.parametrize("key", LINKED)
def test_the_line_says_that_it_proves_the_statement(key):
    entry = ENTRIES[key]
    assert entry.evidence == Evidence.PROVED
    assert proved_by_line(entry)
    steps = derivation(entry.derivation).steps
    others = [k for k, step in enumerate(steps, 1) if key not in step.proves]
    assert not proved_by_line(replace(entry, line=others[0]))
    assert not proved_by_line(replace(entry, line=len(steps) + 1))


def test_what_a_line_says_it_proves_is_a_statement_that_names_it_or_rests_on_less():
    paper = [name for name in names() if name.startswith(("lancaster", "lelas", "smith", "two-laws"))]
    said = {(key, name, k) for name in paper for k, s in enumerate(derivation(name).steps, 1) for key in s.proves}
    assert {(key, ENTRIES[key].derivation, ENTRIES[key].line) for key in LINKED} <= said
    for key, name, k in said:
        entry = ENTRIES[key]
        assert (entry.derivation, entry.line) == (name, k) or entry.evidence == Evidence.MEASURED, key


def test_a_citation_alone_lifts_no_label():
    entry = ENTRIES["lancaster2020:12"]
    sampled = Marks([Evidence.CERTIFIED], 5)
    outcomes = {**expected_outcomes(entry), "printed": Outcome.CONFIRMED}
    linked, cited = (Entry(e, outcomes, 0.0, sampled) for e in (entry, replace(entry, line=None)))
    assert (linked.evidence, linked.extent) == (Evidence.PROVED, "")
    assert (cited.evidence, cited.extent) == (Evidence.CERTIFIED, "sampled: 5 points")
