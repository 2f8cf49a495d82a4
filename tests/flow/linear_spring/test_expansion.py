"""Exponents near 0: one term at the turning points, Taylor steps up to them, and a trap that is seen in time."""

from fractions import Fraction

import pytest
from flint import arb, ctx
from scipy.integrate import solve_ivp

from asymptotics.errors import UndecidedError
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.expansion import TurningExpansion, room
from asymptotics.flow.linear_spring.kept_terms import KeptTerms
from asymptotics.law import Law
from asymptotics.numbers.exact import ExactReal
from asymptotics.return_map.half_swing_map import integrated
from asymptotics.turning.choose import turning_points


def damping(*terms):
    return Damping.of([(arb(e), ExactReal(Fraction(a))) for a, e in terms])


LAWS = [(("1/1000", "0.3"),), (("1/300", "0.25"), ("2", "0.5"))]


@pytest.mark.parametrize("terms", LAWS, ids=str)
def test_a_ladder_of_precisions(terms):
    with ctx.workprec(160):
        fine = integrated(damping(*terms), arb(1))
        assert fine.amplitude.rad() < 1e-33 and fine.duration.rad() < 1e-33
    for bits in (30, 50, 90):
        with ctx.workprec(bits + 32):
            law = damping(*terms)
        with ctx.workprec(bits):
            found = integrated(law, arb(1))
            for a, b in ((found.amplitude, fine.amplitude), (found.duration, fine.duration)):
                assert a.contains(b.mid()) and a.rad() < 2.0 ** (14 - bits)


@pytest.mark.parametrize("terms", LAWS, ids=str)
def test_the_half_swing_is_that_of_scipy(terms):
    laws = [(float(Fraction(a)), float(e)) for a, e in terms]

    def slope(_, state):
        y, w = state
        return [-w, y - sum(e * max(w, 0.0) ** a for a, e in laws)]

    turned = lambda t, state: state[1]  # noqa: E731
    turned.terminal, turned.direction = True, -1
    end = solve_ivp(slope, (0, 9), [1.0, 1e-13], "DOP853", events=turned, rtol=1e-12, atol=1e-13, max_step=0.05)
    with ctx.workprec(112):
        law = damping(*terms)
    with ctx.workprec(80):
        found = integrated(law, arb(1))
    assert abs(-end.y_events[0][0][0] - float(found.amplitude)) < 1e-9
    assert abs(end.t_events[0][0] - float(found.duration)) < 1e-8


def test_half_of_the_drop_or_of_the_delay_would_be_wrong():
    with ctx.workprec(60):
        law, w = damping(("1/1000", "0.1")), arb(2) ** -8
        for side in (1, -1):
            short = TurningExpansion._short(law, arb(side), w, KeptTerms(-8.0, 1, (), 1))
            y, tau = TurningExpansion.at(law, arb(side), w).state(w)
            about = short.state(w)
            assert about[0].contains(y) and about[1].contains(tau)
            assert not arb(side, short.tail / 2).contains(y)
            assert not (w * (side + arb(0, short.time_tail / 2))).contains(tau)


@pytest.mark.parametrize("strength", ["0.5", "0.8", "0.93"])
def test_the_drop_counts_that_braking_slows_the_motion(strength):
    """Under a nearly constant brake w' = 1 - N: the place falls by w^2/(2 (1 - N)), which the drop covers."""
    with ctx.workprec(60):
        law, w = damping(("1/1000", strength)), arb(2) ** -8
        drop, slowest, _ = room(law, arb(1), w)
        truth = w * w / (2 * (1 - law.resistance(w)))
        assert truth < drop < 4 * truth and drop >= w * w / (2 * slowest)


@pytest.mark.parametrize(
    ("law", "n"),
    [({"1/1000": "9/10"}, 0), ({"1/100000": "9/10"}, 0), ({"1/1000": "1/2"}, 1), ({"1/500": "1/3", "1/2": "1/10"}, 1)],
)
def test_strengths_near_1_are_served(law, n):
    table = turning_points(Law(law), 4, 12, times=True)
    assert table.certified and table.ended == {"n": n, "reason": "creeps"}


def test_a_moving_start_is_served():
    table = turning_points(Law({"1/1000": "9/10"}), 4, 12, x0="1/2", v0="-3")
    assert table.ended == {"n": 1, "reason": "creeps"} and table.points[1].x.startswith("0.15341082")


def test_where_braking_may_stop_the_motion_at_once_there_is_no_room():
    law = damping(("1", "1"))
    with pytest.raises(UndecidedError, match="may stop the motion at once"):
        room(law, arb("0.1"), arb("0.2"))
