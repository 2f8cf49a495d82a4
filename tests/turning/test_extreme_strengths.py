"""Strengths far out: an answer, or a refusal by name before the work begins."""

import pytest
from scipy.integrate import solve_ivp

from asymptotics.errors import LimitError, UndecidedError
from asymptotics.law import Law
from asymptotics.turning.choose import turning_points


@pytest.mark.parametrize("law", [{"3/2": "1e300"}, {3: "1e300"}, {1: "1/2", 2: "1e12"}], ids=str)
def test_a_stiff_motion_is_refused_by_its_estimate(law):
    with pytest.raises(LimitError, match="would take about"):
        turning_points(Law(law), 2, 10)


@pytest.mark.parametrize("law", [{"3/2": "1/10"}, {3: "1/20"}], ids=str)
def test_a_thousand_digits_are_refused_by_their_estimate(law):
    with pytest.raises(LimitError, match="2 half-swings with 1000 digits would take about [23]"):
        turning_points(Law(law), 2, 1000)


def test_a_stiff_start_within_reach_is_served():
    table = turning_points(Law({3: 300}), 2, 10)
    assert table.certified and len(table.points) == 2


@pytest.mark.parametrize(("alpha", "epsilon"), [("1/2", "1e300"), ("1/1000", "1e300"), ("1/2", "1e30")])
def test_whether_a_strong_sublinear_damping_creeps_is_decided_at_rest(alpha, epsilon):
    table = turning_points(Law({alpha: epsilon}), 3, 10)
    assert table.ended == {"n": 0, "reason": "creeps"} and [p.x for p in table.points] == ["1.000000000"]


@pytest.mark.parametrize("law", [{"3/2": "1e-300"}, {"1/2": "1e-300"}, {1: "1e-300", 2: "1e-300"}], ids=str)
def test_weak_damping_is_served(law):
    table = turning_points(Law(law), 2000, 10, times=True)
    assert table.points[-1].x == "-1.000000000" and table.points[-1].tau == "6280.043715"


@pytest.mark.parametrize("law", [{"1/2": "1/5"}, {"1/100": "1/5", 2: "1/10"}, {"1/10000000": "3/10"}], ids=str)
def test_a_start_far_beyond_the_last_turning_point_is_told_at_once(law):
    table, near = (turning_points(Law(law), 1, 10, start=start) for start in (10**18, 0))
    assert table.points == () and table.ended["reason"] == "creeps" and near.points
    assert turning_points(Law(law), 20, 10).ended == table.ended


@pytest.mark.parametrize(
    ("law", "start"),
    [
        ({"3/5000000000000000000000000": "1.58", "3/2": "1.91"}, ("0.861", "-0.232")),
        ({"3/10": "0.966", "3000000000000000001/10000000000000000000": "1.49"}, ("-0.343", "-1.96")),
        ({"1/125000000000000000000000000000": "1.01"}, ("1", "0")),
        ({"1/1000": "1/5", "1/500": "1/5"}, ("1", "0")),
    ],
    ids=str,
)
def test_exponents_near_0_and_near_each_other_are_served(law, start):
    x0, v0 = start
    ten, more = (turning_points(Law(law), 5, digits, x0=x0, v0=v0) for digits in (10, 24))
    assert ten.certified and ten.ended == more.ended and ten.ended["reason"] == "creeps"
    assert all(abs(float(p.x) - float(q.x)) < 1e-9 for p, q in zip(ten.points, more.points, strict=True))


def test_exponents_of_a_thousand_are_served_or_refused_by_name():
    third = turning_points(Law({980: "0.179"}), 1, 10, start=3)
    strike = lambda _, s: [s[1], -s[0] - 0.179 * s[1] * abs(s[1]) ** 979]  # noqa: E731
    rest = lambda t, s: s[1]  # noqa: E731
    rest.direction = 1
    found = solve_ivp(strike, (0, 10), [1.0, 0.0], "DOP853", events=rest, rtol=1e-12, atol=1e-12, max_step=0.01)
    assert float(third.points[0].x) == pytest.approx(found.y_events[0][-1][0], abs=1e-8)
    with pytest.raises((LimitError, UndecidedError)):
        turning_points(Law({980: "0.179"}), 1, 10, start=10**9, max_seconds=1)
