import pytest
from flint import arb

from asymptotics.verdict import Outcome, balls_agree


def test_an_outcome_is_not_a_boolean():
    for outcome in Outcome:
        with pytest.raises(TypeError):
            bool(outcome)


def test_a_huge_ball_does_not_pass_by_overlapping():
    assert balls_agree(arb(1, 0.1), arb(1), 5) == Outcome.UNDECIDED
    assert balls_agree(arb(1, 1e-9), arb(1), 5) == Outcome.CONFIRMED
    assert balls_agree(arb(1, 1e-9), arb("1.00001"), 5) == Outcome.REFUTED
    assert balls_agree(arb.nan(), arb(1), 5) == Outcome.UNDECIDED
