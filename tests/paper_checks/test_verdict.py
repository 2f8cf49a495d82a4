import pytest
from flint import arb

from paper_checks.verdict import Outcome, balls_agree


def test_an_outcome_is_not_a_boolean():
    for outcome in Outcome:
        with pytest.raises(TypeError):
            bool(outcome)


def test_a_huge_ball_does_not_pass_by_overlapping():
    assert balls_agree(arb(1, 0.1), arb(1), 5) == Outcome.UNDECIDED
    assert balls_agree(arb(1, 1e-9), arb(1), 5) == Outcome.CONFIRMED
    assert balls_agree(arb(1, 1e-9), arb("1.00001"), 5) == Outcome.REFUTED
    assert balls_agree(arb.nan(), arb(1), 5) == Outcome.UNDECIDED


@pytest.mark.parametrize("swap", [False, True])
def test_both_balls_must_be_finite_and_narrow(swap: bool):
    # digits = 2 at the value 1: the radius may be at most 10^-2 (1 + 1) = 0.02.
    for wide, outcome in ((arb(1, 0.019), Outcome.CONFIRMED), (arb(1, 0.021), Outcome.UNDECIDED)):
        pair = (wide, arb(1)) if not swap else (arb(1), wide)
        assert balls_agree(*pair, 2) == outcome
    infinite = (arb("inf"), arb(1)) if not swap else (arb(1), arb("inf"))
    assert balls_agree(*infinite, 2) == Outcome.UNDECIDED


def test_narrow_is_relative_to_the_magnitude():
    # At the value 100 the radius may be at most 10^-2 (100 + 100) = 2; at 1/100 at most 2e-4.
    assert balls_agree(arb(100, 1.9), arb(100), 2) == Outcome.CONFIRMED
    assert balls_agree(arb(100, 2.1), arb(100), 2) == Outcome.UNDECIDED
    assert balls_agree(arb(0.01, 1.9e-4), arb(0.01), 2) == Outcome.CONFIRMED
    assert balls_agree(arb(0.01, 2.1e-4), arb(0.01), 2) == Outcome.UNDECIDED
    # 10^-digits, not 11^-digits: at ten digits these differ by a factor of 2.6.
    assert balls_agree(arb(1, 1.9e-10), arb(1), 10) == Outcome.CONFIRMED
    assert balls_agree(arb(0), arb(0), 10) == Outcome.CONFIRMED  # exact zeros: a radius of 0 is narrow


def test_what_is_infinite_or_wide_on_either_side_agrees_with_nothing():
    infinite = arb("inf")
    for a, b in ((infinite, arb(2)), (infinite, infinite), (arb(1, 0.1), arb(1))):
        assert balls_agree(a, b, 5) == balls_agree(b, a, 5) == Outcome.UNDECIDED
