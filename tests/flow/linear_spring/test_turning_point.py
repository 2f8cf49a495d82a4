"""When a turning point beside the linear spring is said to be near."""

from flint import arb, ctx

from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring import turning_point as arrivals
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.law import Law
from tests.flow.forces import damping_of

LAW = Law({1: "1/2"})


def test_a_turning_point_is_not_near_while_the_place_may_be_on_this_side():
    spring = LinearSpring(Damping.of_law(LAW))
    with ctx.workprec(60):
        assert spring.turns_within(arb("-0.01"), arb("1e-6"), arb("1e-9"))
        assert not spring.turns_within(arb("-0.01"), arb("1e-6"), arb("0.02"))


def test_a_mass_that_leaves_its_turning_point_does_not_turn():
    law = damping_of(("2", "1/10"))
    assert arrivals.turns_within(law, arb("-0.1"), arb("0.001"), arb(0))
    assert not arrivals.turns_within(law, arb("0.1"), arb("0.001"), arb(0))
