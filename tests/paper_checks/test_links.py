"""A derivation lifts a label only by a line that says what it proves; what fails names the line with what is true."""

from dataclasses import replace
from importlib import import_module
from pathlib import Path

import pytest

from derivations.__main__ import names
from paper_checks.evidence import Marks
from paper_checks.registry import Entry, corrected_by_line, expected_outcomes, load, proved_by_line
from paper_checks.verdict import Evidence, Outcome, Printed

FOLDER = Path(__file__).parents[2] / "derivations"
ENTRIES = load()
NAMING = [key for key, entry in ENTRIES.items() if entry.line is not None]  # whether it proves is asked when it runs
FAILING = [
    key
    for key, entry in ENTRIES.items()
    if entry.verdict in (Printed.MISPRINT, Printed.TRANSCRIPTION, Printed.PARTLY, Printed.REFUTED)
]
READ = {"lelas2024:claim.number-of-sections", "lelas2024:claim.figure-of-section-6"}  # a count, and a cross-reference


def derivation(name):
    return import_module("derivations." + name.replace("-", "_")).derivation


def source(name):
    return (FOLDER / f"{name.replace('-', '_')}.py").read_text(encoding="utf-8")


def linked():
    """The statements whose line proves them."""
    return [key for key in NAMING if proved_by_line(ENTRIES[key])]


@pytest.mark.parametrize("key", NAMING)
def test_the_line_says_that_it_proves_the_statement_or_what_is_true_instead(key):
    entry = ENTRIES[key]
    if key in FAILING and not proved_by_line(entry):
        assert corrected_by_line(entry)
        return
    assert entry.evidence == Evidence.PROVED
    assert proved_by_line(entry)
    steps = derivation(entry.derivation).steps
    others = [k for k, step in enumerate(steps, 1) if key not in step.proves]
    assert not proved_by_line(replace(entry, line=others[0]))
    assert not proved_by_line(replace(entry, line=len(steps) + 1))


def without_the_truth(entries):
    """The failing statements that do not name the line of a derivation that has what is true instead."""
    return {entry.id for entry in entries if not corrected_by_line(entry)}


def test_what_fails_names_the_line_of_a_derivation_that_has_what_is_true():
    failing = [ENTRIES[key] for key in FAILING]
    assert len(failing) > 70
    assert without_the_truth(failing) == READ  # no derivation can count the sections of a paper
    assert all(ENTRIES[key].extent == "read off the text" for key in READ)
    near = ENTRIES["smith2012:48"]
    for name, line in ((None, near.line), (near.derivation, None), (near.derivation, near.line + 1), ("q-log-q", 1)):
        assert without_the_truth([replace(near, derivation=name, line=line)]) == {near.id}


def test_a_line_that_corrects_is_named():
    correcting = [name for name in names() if "corrects=(" in source(name)]
    said = {
        (key, name, k) for name in correcting for k, s in enumerate(derivation(name).steps, 1) for key in s.corrects
    }
    assert {(key, ENTRIES[key].derivation, ENTRIES[key].line) for key, _, _ in said} == said
    assert {key for key, _, _ in said} <= set(FAILING)


def test_a_line_that_corrects_lifts_no_label():
    entry = ENTRIES["smith2012:table1.S3"]
    assert corrected_by_line(entry) and not proved_by_line(entry)
    sampled = Marks([Evidence.CERTIFIED], 5)
    assert Entry(entry, expected_outcomes(entry), 0.0, sampled).evidence == Evidence.CERTIFIED


def test_what_a_line_says_it_proves_is_a_statement_that_names_it_or_rests_on_less():
    paper = [name for name in names() if name.startswith(("lancaster", "lelas", "smith", "two-laws"))]
    said = {(key, name, k) for name in paper for k, s in enumerate(derivation(name).steps, 1) for key in s.proves}
    assert {(key, ENTRIES[key].derivation, ENTRIES[key].line) for key in linked()} <= said
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
