"""The bookkeeping of statements: one id, one verdict, and nothing undecided ever counted as true."""

from concurrent.futures import ThreadPoolExecutor

import pytest

from paper_checks.registry import Statement, add, expected_outcomes, load
from paper_checks.runner import examine, examine_all
from paper_checks.verdict import Evidence, Kind, Outcome, Printed


def check(form):
    return {1: Outcome.CONFIRMED, 0: Outcome.REFUTED}.get(form, Outcome.UNDECIDED)


def entry(**data):
    plain = {
        "id": "test:1",
        "kind": Kind.IDENTITY,
        "title": "",
        "latex": "",
        "verdict": Printed.HOLDS,
        "conditions": "none",
        "evidence": Evidence.PROVED,
        "printed": 1,
        "near_miss": 0,
        "check": check,
    }
    return Statement(**{**plain, **data})


@pytest.mark.parametrize(
    ("data", "agrees"),
    [
        ({}, True),
        ({"printed": 2}, False),  # undecided is not true
        ({"near_miss": 1}, False),
        ({"near_miss": 2}, False),  # nor is it false
        ({"verdict": Printed.MISPRINT, "printed": 0, "corrected": 1}, True),
        ({"verdict": Printed.MISPRINT, "printed": 1, "corrected": 1}, False),
        ({"verdict": Printed.MISPRINT, "printed": 0, "corrected": 2}, False),
        ({"verdict": Printed.REFUTED, "printed": 0}, True),
        ({"verdict": Printed.OPEN, "printed": 2}, True),
    ],
)
def test_agreement(data, agrees):
    assert examine(entry(**data)).agrees is agrees


def test_a_disagreement_is_reported_as_open_without_evidence():
    report = examine(entry(printed=0)).to_dict()
    assert (report["printed"], report["recorded"], report["evidence"]) == ("open", "holds", "none")


def test_expected_outcomes_without_near_miss():
    assert expected_outcomes(entry(near_miss=None)) == {"printed": Outcome.CONFIRMED}


def test_two_entries_with_one_id_are_refused():
    taken = next(iter(load("smith2012").values()))
    with pytest.raises(ValueError, match="two entries"):
        add(taken)


def test_an_entry_without_check_cannot_hold():
    with pytest.raises(ValueError, match="needs a check"):
        add(entry(check=None))


def test_a_pool_returns_the_same_results_in_the_same_order():
    entries = list(load("smith2012").values())[:4]
    finished = []
    with ThreadPoolExecutor(1) as executor:
        pooled = examine_all(entries, executor, finished.append)
    assert finished == [e.id for e in entries]
    assert [r.outcomes for r in pooled] == [r.outcomes for r in examine_all(entries)]
