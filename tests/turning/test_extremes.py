"""Strengths far out: an answer, or a refusal by name before the work begins."""

import pytest

from asymptotics.errors import InputError, LimitError
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_real
from asymptotics.turning.general import turning_points
from asymptotics.turning.half_swing import half_swing_result


@pytest.mark.parametrize("law", [{"3/2": "1e300"}, {3: "1e300"}, {1: "1/2", 2: "1e12"}], ids=str)
def test_a_stiff_motion_is_refused_by_its_estimate(law):
    with pytest.raises(LimitError, match="would take about"):
        turning_points(Law(law), 2, 10)


@pytest.mark.parametrize("law", [{"3/2": "1/10"}, {3: "1/20"}], ids=str)
def test_a_thousand_digits_are_refused_by_their_estimate(law):
    with pytest.raises(LimitError, match="2 half-swings with 1000 digits would take about 2"):
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


def test_dry_friction_that_stops_at_the_centre_or_before():
    zero = [parse_real("0", "a")]
    for delta, words in (("1/2", "A'/A = 0, T = pi"), ("3/4", "before the centre"), ("2", "where it is")):
        with pytest.raises(InputError, match=words):
            half_swing_result(zero, [parse_real(delta, "d")], 10)
    assert half_swing_result(zero, [parse_real("0.49", "d")], 10).amplitude == "0.02000000000"
