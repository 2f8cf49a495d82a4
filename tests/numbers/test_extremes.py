"""The largest and the least of several balls."""

from flint import arb, ctx

from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.extremes import greatest, least


def test_the_extremes_of_balls_hold_those_of_their_numbers():
    with ctx.workprec(200):
        near = [ExactReal(1).ball(), 1 + arb(10) ** -40]
        assert greatest(near).contains(near[1].mid()) and greatest(near) > 1 and least(near[::-1]) == near[0]
        wide = [arb(2, 1), arb(3, "0.5")]
        assert all(greatest(wide).contains(x) for x in (arb("2.5"), arb("3.5"))) and greatest(wide) > 2
        assert all(least(wide).contains(x) for x in (arb(1), arb(3)))
