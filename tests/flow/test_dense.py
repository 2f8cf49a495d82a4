"""States at a time: how uncertain times, places and speeds widen them, each part against the truth."""

from types import SimpleNamespace

import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.flow import dense
from asymptotics.flow.turning import TurningState, at_rest
from asymptotics.flow.wells.even_well import EvenWell
from tests.flow.forces import FREE, Steep, in_a_well
from tests.flow.forces import WELLS as FORCES


class Falling:
    """The force 1 everywhere."""

    def strongest(self, _u, _w):
        return arb(1)


def test_an_uncertain_time_moves_a_state_where_the_force_is_largest():
    flow = SimpleNamespace(force=Steep())
    du, dw = dense._moved(flow, arb(1), arb("0.8"), arb("0.01"))
    # The force counts wherever the state may move, which half of the first box would leave out.
    assert du >= arb("0.008") and dw >= arb("0.01") * (1 + du) ** 20


def test_the_distance_of_a_turning_point_counts_the_force_at_its_farther_place():
    flow = SimpleNamespace(force=Steep(), unit=lambda *_: arb(1))
    found = dense._distance(flow, TurningState(0, 1, arb(1), arb(0), arb("0.25"), arb("0.0001")))
    assert found >= arb("0.25") + arb("0.0001") * arb("1.25") ** 20


def test_the_window_about_a_turning_point_is_attained():
    """Within the time e the speed grows to e s_0."""
    here = TurningState(3, 1, arb(1), arb(10), arb(0), arb(2) ** -20)
    distance = dense._distance(EvenWell(FREE), here)
    with ctx.workprec(100):
        e = arb(2) ** -20
        truth = ((1 - e.cos()) ** 2 + e.sin() ** 2).sqrt()
        assert truth <= distance and distance / 2 < truth


@pytest.mark.parametrize("name", ["pendulum", "duffing", "place"])
def test_the_error_of_a_time_only_adds(name):
    """A motion that is late at one turning point is as late at the next: seen exactly, and not counted twice."""
    e = arb(2) ** -20
    with ctx.workprec(80):
        there = dense._swing(
            EvenWell(FORCES[name]),
            TurningState(0, 1, arb(1), arb(0), arb(0), e),
            dense._Wanted(EvenWell(FORCES[name]), [arb(9)]),
        )
        exactly = dense._swing(EvenWell(FORCES[name]), at_rest(arb(1)), dense._Wanted(EvenWell(FORCES[name]), [arb(9)]))
        assert exactly.time_error + e * arb("0.999") < there.time_error < e * arb("1.001")


def test_an_uncertain_time_moves_a_state():
    """A free linear oscillator at (0.6, 0.8) within the time e: 0.8 e in place and 0.6 e in speed, and hardly more."""
    e = arb(2) ** -12
    du, dw = dense._moved(EvenWell(FREE), arb("0.6"), arb("0.8"), e)
    for moved, truth in ((du, arb("0.8") * e), (dw, arb("0.6") * e)):
        assert truth <= moved and moved / 2 < truth
    wide, _ = dense._moved(EvenWell(FREE), arb("0.6"), arb("0.8"), arb("0.5"))
    assert wide >= arb("0.8") * arb("0.5").sin() + arb("0.6") * (1 - arb("0.5").cos())
    with pytest.raises(UndecidedError, match="too uncertain"):
        dense._moved(EvenWell(in_a_well({2: 0}, {3: 1000})), arb(1), arb(1), arb(1))


def test_a_time_counts_from_its_lower_to_its_upper_end():
    """A free linear oscillator at rest at 1, asked at r +- r: -sin(2 r) at the latest, which r alone does not reach."""
    r = arb(2) ** -8
    ((x, v),) = dense.states(EvenWell(FREE), arb(1), arb(0), [arb(r, r)])
    assert x.contains((2 * r).cos()) and v.contains(-(2 * r).sin()) and v.rad() < 3 * r


def test_a_state_holds_its_neighbours_in_place_speed_and_time():
    """From X +- e, V +- e, at a time +- e: every corner is inside, and the ball is at most some times as wide."""
    force, e = FORCES["pendulum"], arb(2) ** -16
    with ctx.workprec(90):
        (wide,) = dense.states(EvenWell(force), arb("0.5", e), arb("0.25", e), [arb(3, e)])
        farthest = [arb(0), arb(0)]
        for sides in ((1, 1, 1), (1, -1, 1), (-1, 1, 1), (1, 1, -1), (-1, -1, -1), (1, -1, -1)):
            a, b, c = (side * e for side in sides)
            (state,) = dense.states(EvenWell(force), arb("0.5") + a, arb("0.25") + b, [arb(3) + c])
            for k, (ball, x) in enumerate(zip(wide, state, strict=True)):
                assert ball.contains(x.mid())
                farthest[k] = max(farthest[k], abs(x - ball.mid()).mid(), key=float)
        assert all(ball.rad() < 12 * far for ball, far in zip(wide, farthest, strict=True))


@pytest.mark.parametrize(("place", "speed"), [(1, 0), (0, 1)])
def test_a_start_that_is_uncertain_in_place_or_speed_alone(place, speed):
    force, e = FORCES["pendulum"], arb(2) ** -16
    with ctx.workprec(90):
        (wide,) = dense.states(EvenWell(force), arb("0.5", place * e), arb("0.25", speed * e), [arb(3)])
        for side in (1, -1):
            start = arb("0.5") + side * place * e, arb("0.25") + side * speed * e
            (state,) = dense.states(EvenWell(force), *start, [arb(3)])
            assert all(ball.contains(x.mid()) and ball.rad() < 8 * e for ball, x in zip(wide, state, strict=True))


def test_a_late_fall_is_off_in_place_too(monkeypatch):
    """Speed t and way t^2/2 under the force 1, the distance counting places tenfold: the speed alone is less."""
    monkeypatch.setattr(EvenWell, "unit", lambda *_: arb(10))
    t = arb(1) / 8
    truth = ((10 * t**2 / 2) ** 2 + t**2).sqrt()
    found = dense._distance(EvenWell(Falling()), TurningState(1, 1, arb(1), arb(3), arb(0), t))
    assert t * arb("1.1") < truth <= found < 2 * truth


def test_what_is_uncertain_about_a_turning_point_is_a_distance():
    """The error of the amplitude, the speed that the time allows and the way it allows, in the unit of the distance."""
    force, e = FORCES["free pendulum"], arb(2) ** -10
    unit = EvenWell(force).unit(arb(1), arb(0))
    for amplitude, time in ((e, arb(0)), (arb(0), e), (e, e), (arb(0), arb(1) / 8)):
        found = dense._distance(EvenWell(force), TurningState(1, 1, arb(1), arb(3), amplitude, time))
        speed, way = arb(1).sin() * time, arb(1).sin() * time**2 / 2
        truth = ((unit * (amplitude + way)) ** 2 + speed**2).sqrt()
        assert truth <= found < 2.5 * truth
