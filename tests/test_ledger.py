"""The ledger of trust says what is answered."""

from tests.ledger import ANSWERS, LAWS, PAGE, cell, page


def test_the_page_is_what_is_answered():
    assert PAGE.read_text(encoding="utf-8") == page(), "python -m tests.ledger rewrites it"


def test_an_answer_that_drifts_is_noticed(monkeypatch):
    """Without a certificate the cell is another one, and so is the page."""
    answer, _ = ANSWERS["turning points"]
    monkeypatch.setattr("tests.ledger.of_turning_points", lambda *_: 1 / 0)
    try:
        cell(answer, LAWS["quadratic"])
    except ZeroDivisionError:
        return
    raise AssertionError
