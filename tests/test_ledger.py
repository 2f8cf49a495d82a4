"""The ledger of trust says what is answered, of every command."""

import re

import pytest

from asymptotics.ask.registry import QUESTIONS
from derivations.__main__ import names
from tests import ledger
from tests.ledger import BESIDES, CERTIFICATE, CERTIFIED, LAWS, PAGE, REFUSED, cell, groups, page, row, rows_of_rests

REWRITES = "python -m tests.ledger rewrites it"
# A second or two each, and a class of their kind stays in make test.
DEARER = (
    "another rational power", "an irrational power", "a sum with dry friction", "air and a spring x^3",
    "a start in motion", "a pendulum in air", "a loss that knows the place",
)  # fmt: skip


@pytest.mark.parametrize("law", [pytest.param(n, marks=pytest.mark.slow) if n in DEARER else n for n in LAWS])
def test_a_row_is_what_is_answered(law):
    lines = PAGE.read_text(encoding="utf-8").splitlines()
    for columns in groups().values():
        assert row(columns, law) in lines, REWRITES


def test_all_else_of_the_page_is_as_it_is_written(monkeypatch):
    monkeypatch.setattr(ledger, "row", lambda columns, law: f"| {law}")
    heads = {f"| {name}" for name in LAWS}
    lines = PAGE.read_text(encoding="utf-8").splitlines()
    told = [line.partition(" | ")[0] if line.partition(" | ")[0] in heads else line for line in lines]
    assert page().splitlines() == told, REWRITES


def test_every_command_is_in_it():
    told = {row.split("`")[1] for row in rows_of_rests()}
    assert told == {*QUESTIONS, *BESIDES}
    assert all(row.count(" | ") == 1 and not row.endswith("|  |") for row in rows_of_rests())


def test_the_derivations_that_it_names_exist():
    named = {name for words in rows_of_rests() for name in re.findall(r"`([a-z]+(?:-[a-z]+)+)`", words)}
    named -= {*QUESTIONS}
    assert len(named) > 5 and named <= set(names())


WORDS = f"turning-points --count 3 --digits 8 {LAWS['quadratic']}"


def test_an_answer_that_drifts_is_noticed(monkeypatch):
    """Without a certificate, or without a proof, the cell is another one, and so is the page."""
    assert cell(WORDS) == CERTIFICATE
    answer = ledger.asked(WORDS)
    monkeypatch.setattr(ledger, "_has_certificate", lambda _: False)
    assert cell(WORDS) == CERTIFIED
    monkeypatch.setattr(ledger, "asked", lambda _: answer.__class__(answer.question, answer.request, _Estimate()))
    assert cell(WORDS) == "estimate"
    monkeypatch.setattr(ledger, "groups", lambda: {"one": (WORDS,)})
    assert page() != PAGE.read_text(encoding="utf-8")


class _Estimate:
    x_unit = "x0"

    def to_dict(self):
        return {"certified": False}


@pytest.mark.parametrize("law", ["gains", "gains and losses"])
def test_what_is_refused_says_so(law):
    assert cell(f"turning-points --count 3 --digits 8 {LAWS[law]}") == REFUSED
