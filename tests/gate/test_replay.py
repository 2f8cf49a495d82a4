"""What command lines answered when they were recorded, they answer today; a sample of them in ``make test``."""

import pytest

from tests.gate.replay import digest, outcome, recorded

ROWS = recorded()
_EVERY = 15  # of make test: ten seconds


def test_the_record_has_lines_of_every_command():
    from asymptotics.ask.registry import QUESTIONS  # noqa: PLC0415 (what is loaded when the record is read)

    assert {row[0][0] for row in ROWS if row[0]} >= set(QUESTIONS) - {"identify"}
    assert len(ROWS) > 1000


@pytest.mark.parametrize("row", ROWS[::_EVERY], ids=lambda row: " ".join(row[0])[:60].encode("unicode_escape").decode())
def test_a_line_answers_as_it_was_recorded(row):
    words, *was = row
    assert outcome(words) == was


@pytest.mark.slow
def test_all_lines_answer_as_they_were_recorded():
    differ = [row[0] for row in ROWS if outcome(row[0]) != row[1:]]
    assert differ == []


def test_another_answer_is_noticed():
    assert digest("c_1 = -0.0909280010378") != digest("c_1 = -0.0909280010379")
    assert digest('"code": "ab"') == digest('"code": "cd"')
