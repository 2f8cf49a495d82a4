"""All routes to the turning points agree wherever two of them serve, and each says which it was."""

from fractions import Fraction
from itertools import combinations

import numpy as np
import pytest
from flint import arb, ctx
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from asymptotics.errors import InputError, LimitError
from asymptotics.law import Law
from asymptotics.turning.choose import choose, offers, turning_points
from asymptotics.turning.routes import ROUTES
from asymptotics.turning.table import PointsRequest

QUICK = [  # law, count, digits, and the rest of the request
    ({0: "10/503"}, 4, 20, {}),
    ({0: "10/503"}, 30, 12, {"times": True}),
    ({0: "1/10"}, 2, 8, {"x0": "0.46", "v0": "-0.48", "times": True}),
    ({1: "1/5"}, 4, 20, {"times": True}),
    ({1: "1/1000"}, 300, 12, {"start": 290}),
    ({2: "1/3"}, 4, 25, {}),
    ({2: "1/10"}, 300, 12, {"start": 295}),
    ({0: "1/50", 2: "1/10"}, 40, 12, {}),
    ({2: "1/5"}, 4, 20, {"spring": "pendulum", "x0": 2}),
    ({0: "1/21"}, 10, 15, {"spring": {3: "1/4"}}),
]
LONG = [
    ({2: "1/10"}, 3, 12, {"start": 900, "times": True}),
    ({0: "1/2000", 2: "1/10"}, 30, 12, {"start": 110}),
    ({"3/2": "1/5"}, 2, 12, {"start": 1500, "times": True}),
    ({"1/2": "1/400"}, 500, 12, {"start": 350, "times": True}),
    ({"3/2": "1/1000", 3: "1/100000"}, 2, 8, {"start": 2001, "times": True, "x0": "1/2", "v0": "-1"}),
]
ENOUGH = {"quick": 0.6, "long": 60.0}  # seconds by the estimate: dearer routes are left out


def asked(law, count, digits, rest):
    rest = dict(rest)
    return Law(law, spring=rest.pop("spring", None)), count, digits, rest


def agree(one, other, digits):
    """The same points to the digits of both, the same end."""
    same = one.ended == other.ended and len(one.points) == len(other.points)
    with ctx.workprec(4 * digits + 64):
        close = arb(10) ** (1 - digits)
        for p, q in zip(one.points, other.points):
            pairs = [(p.x, q.x), *([] if p.tau is None or q.tau is None else [(p.tau, q.tau)])]
            same &= p.n == q.n and all(abs(arb(a) - arb(b)) <= abs(arb(b)) * close for a, b in pairs)
    return same


def first(made):
    return next(iter(made[0]))


def off(made):
    """The first strength, a few units of the last digits larger."""
    return Fraction(made[0][first(made)]) * (1 + Fraction(1, 10 ** (made[2] - 4)))


def serving(made, enough):
    law, count, digits, rest = asked(*made)
    return [r.name for r, s in offers(PointsRequest.read(law, count, digits, **rest)) if s is not None and s < enough]


def compared(made, enough):
    (law, count, digits, rest), names = asked(*made), serving(made, enough)
    assert len(names) >= 2
    found = {name: turning_points(law, count, digits, route=name, **rest) for name in names}
    for one, other in combinations(names, 2):
        assert agree(found[one], found[other], digits), (one, other)
        assert found[one].method != found[other].method and found[one].certified
    near, *_ = asked(made[0] | {first(made): off(made)}, *made[1:])
    missed = turning_points(near, count, digits, **rest)
    assert not agree(missed, found[names[-1]], digits)


@pytest.mark.parametrize("made", QUICK, ids=str)
def test_every_pair_of_routes_that_serve_agrees_and_a_near_miss_does_not(made):
    compared(made, ENOUGH["quick"])


@pytest.mark.slow
@pytest.mark.parametrize("made", [*QUICK, *LONG], ids=str)
def test_the_dear_routes_agree_with_the_others(made):
    compared(made, ENOUGH["long"])


def test_every_route_stands_beside_another_in_these_tests():
    pairs = {pair for made in (*QUICK, *LONG) for pair in combinations(serving(made, ENOUGH["long"]), 2)}
    assert {name for pair in pairs for name in pair} == {route.name for route in ROUTES}


def test_dry_friction_and_drag_have_their_primitive_beside_the_linear_spring():
    """Refused after 60 s before, and answered at once with a spring of strength 1e-400."""
    law = Law({0: "1/50", 2: "1/10"})
    found = turning_points(law, 30, 300, max_seconds=60)
    beside = turning_points(Law({0: "1/50", 2: "1/10"}, spring={3: "1e-400"}), 30, 300)
    assert [p.x for p in found.points] == [p.x for p in beside.points] and found.ended == beside.ended
    assert found.method.startswith("primitive of the energy equation") and found.certified


def test_the_cheapest_route_is_taken_and_one_can_be_named():
    chosen = {
        "dry": PointsRequest.read(Law({0: "1/50"}), 5, 20),
        "linear": PointsRequest.read(Law({1: "1/5", 3: 0}), 5, 20),
        "quadratic": PointsRequest.read(Law({2: "1/5"}), 5, 20, start=10**9),
        "closed-primitive": PointsRequest.read(Law({2: "1/5"}, spring={3: 1}), 5, 20),
        "abel-series": PointsRequest.read(Law({"3/2": "1/5"}), 1, 40, start=10**9),
        "abel-flow": PointsRequest.read(Law({"3/2": "1/5", 3: 1}), 1, 20, start=10**9),
        "interpolated": PointsRequest.read(Law({"3/2": "1/5"}), 2000, 20),
        "stepping": PointsRequest.read(Law({"3/2": "1/5"}, spring="pendulum"), 5, 20),
    }
    assert {name: choose(request).name for name, request in chosen.items()} == {
        route.name: route.name for route in ROUTES
    }
    assert choose(chosen["dry"], "stepping").name == "stepping"
    with pytest.raises(InputError, match=r"argument route: linear does not serve this request .accepted: dry, closed"):
        choose(chosen["dry"], "linear")
    with pytest.raises(InputError, match="argument route: 'fast' is unknown"):
        turning_points(Law({2: 1}), 2, route="fast")


def test_a_route_with_times_or_a_velocity_is_one_that_knows_them():
    drag = Law({2: "1/5"}, spring="pendulum")
    assert choose(PointsRequest.read(drag, 5, 20, times=True)).name == "stepping"
    assert choose(PointsRequest.read(drag, 5, 20, v0=1)).name == "stepping"
    with pytest.raises(LimitError):
        turning_points(drag, 100_000, 900, max_seconds=5)


def test_the_method_names_how_the_nodes_were_found():
    collocated = turning_points(Law({2: "1/10", 3: "1/10"}), 200, 10, start=190).method
    assert "Taylor steps, quarter-swings by collocation, Chebyshev interpolation" in collocated
    assert "collocation" not in turning_points(Law({"1/2": "1/1000"}), 300, 10, start=290).method


@pytest.mark.slow
def test_a_far_start_is_certified_and_agrees_with_the_quadratic_route():
    far = turning_points(Law({"3/2": "1/5"}), 1, 50, start=10**9, times=True, max_seconds=600)
    assert far.certified
    assert far.points[0].x == "4.8375135770288450459451814859410988637559037236490e-17"
    exact, jumped = (
        turning_points(Law({2: "1/5"}), 1, 25, start=10**6, times=True, route=r) for r in ("quadratic", "abel-series")
    )
    assert exact.points == jumped.points


def swung_by_shooting(a, linear, root):
    """The next turning distance of a pendulum with linear damping and drag |v|^(3/2), in doubles.

    With t = s^2 from rest, and T - t = s^2 before the turning point ahead, x and v are smooth in s; both are led to
    x = 0, and the turning distance is the one whose speed there is that of the start.
    """

    def speed(start, way):
        def rates(s, state):
            x, v = state
            return [2 * s * v, 2 * s * (-np.sin(x) - way * (linear * v + root * v * np.sqrt(abs(v))))]

        def through(_, state):
            return state[0]

        through.terminal = True
        found = solve_ivp(rates, (0, 3), (start, 0), method="DOP853", rtol=1e-13, atol=1e-15, events=through)
        return abs(found.y_events[0][0][1])

    there = speed(a, 1)
    return brentq(lambda q: speed(q, -1) - there, a / 2, a, xtol=1e-15, rtol=1e-14)


def test_linear_and_three_halves_damping_beside_a_pendulum_by_shooting():
    """The third turning point: no other route serves it; a loss larger by 10^-9 is seen."""
    points = turning_points(Law({1: "1/10", "3/2": "1/10"}, spring="pendulum"), 4, 14).points
    found, near_miss = 1.0, 1.0
    for n in (1, 2, 3):
        found, near_miss = swung_by_shooting(found, 0.1, 0.1), swung_by_shooting(near_miss, 0.1, 0.1 * (1 + 1e-9))
        assert abs(abs(float(points[n].x)) - found) < 3e-12
    assert abs(abs(float(points[3].x)) - near_miss) > 3e-11
