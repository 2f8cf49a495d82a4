"""A root is claimed where the speed on the whole ball bounds how far it may be, and nowhere else."""

import pytest
from flint import arb

from asymptotics.numbers.root import verified_root


@pytest.mark.parametrize("side", [-1, 1])
def test_the_root_may_stand_at_the_end_of_the_ball(side):
    """f(s) = s, the target at one: the ball of radius one about zero holds it, and none that is smaller."""
    found = verified_root(arb(0), arb(1), lambda _: arb(1), [arb("0.9"), arb(1), arb(2)])
    assert found.contains(side) and not found.contains(arb(side) * 1.01)


def test_the_largest_speed_on_the_ball_counts():
    """f(s) = s/2 up to 1/2 and then s/8: a miss of 1/2 is made up for at s = 5/2, not at 1."""

    def speed(near):
        return arb(2).union(arb(8)) if near.upper() > arb(1) / 2 else arb(2)

    assert verified_root(arb(0), arb(1) / 2, speed, [arb(1), arb(3)]) is None
    assert verified_root(arb(0), arb(1) / 2, speed, [arb("4.1")]).contains(arb(5) / 2)


@pytest.mark.parametrize("speed", [arb(-1), arb(0, 1), arb("nan")])
def test_a_function_that_may_turn_has_no_root_that_is_proved(speed):
    assert verified_root(arb(0), arb(1), lambda _: speed, [arb(2)]) is None
