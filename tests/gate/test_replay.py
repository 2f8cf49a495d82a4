"""What command lines answered when they were recorded, they answer today; a sample of them in ``make test``."""

import pytest

from asymptotics.ask.registry import QUESTIONS
from tests.gate.replay import digest, outcome, recorded, unrecorded

ROWS = recorded()
_EVERY = 15  # of make test: ten seconds


def test_the_record_has_lines_of_every_command():
    """A new one enters with its example, when the lines are recorded again."""
    commands = {row[0][0] for row in ROWS if row[0]} | {words[0] for words in unrecorded(ROWS)}
    assert commands >= set(QUESTIONS) - {"compare", "identify", "sweep"}
    assert len(ROWS) > 1000 and len(unrecorded(ROWS)) < 5
    assert [words[0] for words in unrecorded([row for row in ROWS if row[0][:1] != ["moment"]])] == ["moment"]


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
