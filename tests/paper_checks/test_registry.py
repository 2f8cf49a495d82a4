"""The bookkeeping of statements: one id, one verdict, and nothing undecided ever counted as true."""

import sys
from concurrent.futures import ThreadPoolExecutor

import pytest

from asymptotics.errors import LimitError
from paper_checks import registry
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


def test_statements_whose_import_was_stopped_are_loaded_again(monkeypatch):
    """Failed before: two entries with the id smith2012:1b, for as long as the process lived."""
    load("smith2012")
    stopped, whole = [], registry.add
    for name in [name for name in sys.modules if name.startswith("paper_checks.smith2012")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setattr(registry, "_REGISTRY", {})

    def stop_once(entry):
        whole(entry)
        if entry.id == "smith2012:1b" and not stopped:
            stopped.append(entry.id)
            raise LimitError("max_seconds", "1 s are over", "more")

    monkeypatch.setattr(registry, "add", stop_once)
    with pytest.raises(LimitError):
        load("smith2012")
    assert stopped and "smith2012:1b" not in registry._REGISTRY
    assert "smith2012:1b" in load("smith2012")
