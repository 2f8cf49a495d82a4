"""Every statement of the paper: present, borne out by its check, and refutable."""

from dataclasses import replace
from pathlib import Path

import pytest
from latex2mathml.converter import convert

from asymptotics.verdict import Evidence, Outcome, Printed
from paper_checks.registry import load
from paper_checks.runner import examine, examine_all

ENTRIES = load("smith2012")
RESULTS = {result.statement.id: result for result in examine_all(ENTRIES.values())}

LETTERED = {
    1: "ab", 4: "ab", 18: "ab", 20: "abcd", 24: "abcd", 27: "abc",
    38: "ab", 39: "ab", 46: "abc", 52: "abc", 56: "abcd", 59: "abcd", 60: "abcdefgh", 62: "ab",
}
NUMBERED = [
    f"{number}{letter}" for number in range(1, 73) for letter in (LETTERED.get(number) or ("",))
]  # (1a)-(72) as the paper numbers them
TABLE = ["table1.S", *(f"table1.{column}{row}" for row in range(6) for column in ("S", "u"))]
FIGURES = [f"fig{number}" for number in range(1, 8)]
NOT_HOLDING = {  # found by hand from the paper's own equations, see the notes of the entries
    "claim.integrating-factor-exists": "partly", "claim.hat-T": "partly", "31": "partly", "34": "misprint",
    "claim.integrating-factors": "misprint", "38b": "misprint", "40": "misprint", "48": "misprint", "49": "misprint",
    "51": "misprint", "52a": "misprint", "52b": "misprint", "54": "misprint", "55": "misprint",
    "56b": "transcription", "56c": "transcription", "62b": "misprint", "63": "misprint", "71": "partly",
    "72": "misprint", "table1.S3": "misprint", "table1.S5": "misprint", "claim.second-cycle": "partly",
    "claim.not-identifiable": "refuted",
}


def short(key: str) -> str:
    return key.removeprefix("smith2012:")


def test_the_ids_are_the_papers_numbering():
    ids = {short(key) for key in ENTRIES}
    claims = {key for key in ids if key.startswith("claim.")}
    assert ids - claims == {*NUMBERED, *TABLE, *FIGURES, "fn8"}
    assert len(claims) >= 20


def test_entries_stand_in_reading_order():
    numbers = [short(key) for key in ENTRIES if short(key)[:1].isdigit()]
    assert numbers == NUMBERED


@pytest.mark.parametrize("key", ENTRIES)
def test_the_check_bears_out_the_recorded_verdict(key):
    result = RESULTS[key]
    assert result.agrees, result.outcomes
    assert result.printed == ENTRIES[key].verdict


@pytest.mark.parametrize("key", ENTRIES)
def test_the_check_can_fail(key):
    assert RESULTS[key].outcomes["near miss"] == Outcome.REFUTED
    assert RESULTS[key].outcomes["printed"] != Outcome.UNDECIDED


def test_verdicts_other_than_holds():
    exceptions = (Printed.HOLDS, Printed.DEFINITION)
    found = {short(key): str(entry.verdict) for key, entry in ENTRIES.items() if entry.verdict not in exceptions}
    assert found == NOT_HOLDING


@pytest.mark.parametrize("key", ENTRIES)
def test_what_is_wrong_is_corrected_and_explained(key):
    entry = ENTRIES[key]
    wrong = entry.verdict not in (Printed.HOLDS, Printed.DEFINITION)
    assert (entry.corrected_latex is not None) == wrong
    assert (entry.corrected is not None) == wrong
    assert bool(entry.note) or not wrong
    assert entry.evidence != Evidence.NONE
    assert entry.methods


@pytest.mark.parametrize("key", ENTRIES)
def test_planted_fault_is_noticed(key):
    """With the near miss in the place of the printed form the entry must disagree, or a wrong one look right."""
    entry = ENTRIES[key]
    if entry.verdict in (Printed.HOLDS, Printed.DEFINITION):
        planted = replace(entry, printed=entry.near_miss)
    else:
        planted = replace(entry, printed=entry.corrected)
    result = examine(planted)
    assert not result.agrees
    assert result.printed == Printed.OPEN
    assert result.to_dict()["evidence"] == "none"


@pytest.mark.parametrize("key", ENTRIES)
def test_latex_becomes_mathml(key):
    for latex in filter(None, (ENTRIES[key].latex, ENTRIES[key].corrected_latex)):
        mathml = convert(latex)
        assert mathml.startswith("<math")
        assert "\\" not in mathml, mathml


def test_derivations_named_by_entries_exist():
    folder = Path(__file__).parents[2] / "derivations"
    named = {entry.derivation for entry in ENTRIES.values()} - {None}
    assert named <= {path.stem.replace("_", "-") for path in folder.glob("smith_*.py")}
