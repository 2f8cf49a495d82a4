"""Intervals step by step: on a straight model, where each number has a formula, and the search for an end alone."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.stats import norm
from scipy.stats import t as student

from asymptotics.decays.identification.fitting import profile
from asymptotics.decays.identification.fitting.directions import Directions
from asymptotics.decays.identification.fitting.profile import (
    Interval,
    coordinate,
    profile_curve,
    profile_interval,
    quantile,
    wald_interval,
)
from asymptotics.decays.identification.forward.quadrature import TooStrongError

J = np.array([[1.0, 0.0], [1.0, 1.0], [1.0, 2.0], [1.0, 4.0]])
DATA = np.array([0.1, 1.2, 1.9, 4.3])
SIGMA = 0.5


def straight(known=True, freedom=2.0):
    """The fit of a straight line to four data: the least squares of ``J theta`` to ``DATA``."""
    theta = np.linalg.lstsq(J, DATA, rcond=None)[0]
    model = SimpleNamespace(
        data=DATA,
        predict=lambda at: (J @ at, J),
        scale_vector=lambda scales: np.full(4, scales["x"]),
        swing=SimpleNamespace(free=False, tolerance=None),
        predicted=None,
    )
    r = (DATA - J @ theta) / SIGMA
    return SimpleNamespace(
        theta=theta, known=known, freedoms={"x": freedom, "t": 7.0}, scales={"x": SIGMA}, model=model,
        chi2=float(r @ r),
        directions=Directions.of(J / SIGMA), covariance=np.linalg.inv(J.T @ J) * SIGMA**2,
    )  # fmt: skip


def error(gradient):
    return float(np.sqrt(gradient @ np.linalg.inv(J.T @ J) @ gradient)) * SIGMA


def slope(theta):
    """Half of the slope of the line less its level."""
    return float(theta[1] / 2 - theta[0]), np.array([-1.0, 0.5])


def ends(interval):
    return [interval.low, interval.estimate, interval.high]


def test_an_interval_without_an_end_holds_all_beyond_and_keeps_none_when_it_grows():
    lower, upper, whole = Interval(None, 1.0, 2.0), Interval(0.5, 1.0, None), Interval(0.5, 1.0, 2.0)
    assert [each.contains(0.4) for each in (lower, upper, whole)] == [True, False, False]
    assert [each.contains(2.1) for each in (lower, upper, whole)] == [False, True, False]
    assert whole.contains(0.5) and whole.contains(2.0)
    assert ends(whole.widened(0.25, 1.0)) == [0.25, 1.0, 3.0] and ends(whole.stretched(3.0)) == [-0.5, 1.0, 4.0]
    assert ends(lower.widened(1.0, 1.0)) == [None, 1.0, 3.0] and ends(upper.stretched(2.0)) == [0.0, 1.0, None]
    assert ends(upper.widened(0.5, 1.0)) == [0.0, 1.0, None] and ends(lower.stretched(2.0)) == [None, 1.0, 3.0]
    assert upper.to_dict() == {"low": "0.5", "estimate": "1", "high": None}
    assert Interval(1 / 3, 2 / 3, 1.0).to_dict()["low"] == "0.333333"


def test_an_interval_is_told_with_its_ends():
    page = Interval(None, 2 / 3, 1 / 3)._page()
    assert page.title == "0.666667" and page.rows == (("no limit", "0.333333"),)
    assert page.head == ("at least", "at most") and page.lines == ("estimate, in doubles",)
    assert Interval(None, 2 / 3, 1 / 3)._formula() == r"0.666667\ \text{in}\ [-,\, 0.333333]"


def test_a_coordinate_is_one_parameter_times_its_factor():
    value, gradient = coordinate(1, 3.0)(np.array([1.0, 2.0, 4.0]))
    assert value == 6.0 and gradient.tolist() == [0.0, 3.0, 0.0]
    value, gradient = coordinate(2)(np.array([1.0, 2.0, 4.0]))
    assert value == 4.0 and gradient.tolist() == [0.0, 0.0, 1.0]


def test_the_quantile_is_normal_where_the_noise_is_known_and_that_of_student_otherwise():
    assert quantile(straight(), 0.9, "x") == pytest.approx(norm.ppf(0.95), rel=1e-12)
    assert quantile(straight(False), 0.9, "x") == pytest.approx(student.ppf(0.95, 2), rel=1e-9)
    assert quantile(straight(False), 0.9, "t") == pytest.approx(student.ppf(0.95, 7), rel=1e-9)
    assert quantile(straight(False, 0.2), 0.9, "x") == pytest.approx(student.ppf(0.95, 1), rel=1e-9)  # one at least


@pytest.mark.parametrize("level", [0.5, 0.95])
def test_on_a_straight_model_both_intervals_are_the_same(level):
    fit = straight()
    value, gradient = slope(fit.theta)
    reach = norm.ppf((1 + level) / 2) * error(gradient)
    assert ends(wald_interval(fit, slope, level)) == pytest.approx([value - reach, value, value + reach], rel=1e-9)
    assert ends(profile_interval(fit, slope, level)) == pytest.approx([value - reach, value, value + reach], rel=6e-3)
    for interval, close in ((wald_interval, 1e-9), (profile_interval, 6e-3)):
        by_times = interval(straight(False), slope, level, kind="t")
        reach = student.ppf((1 + level) / 2, 7) * error(gradient)
        assert by_times.high - value == pytest.approx(reach, rel=close) == value - by_times.low


def test_ninety_five_percent_by_x_unless_it_is_said():
    fit = straight(False)
    for interval in (wald_interval, profile_interval):
        assert ends(interval(fit, slope)) == ends(interval(fit, slope, 0.95, "x"))


def test_what_no_data_see_has_no_limit():
    fit = straight()
    blind = lambda theta: (theta[0], np.array([0.0, 0.0]))  # noqa: E731  (no error at all: nothing to step by)
    assert ends(profile_interval(fit, blind)) == [None, fit.theta[0], None]
    fit.directions = SimpleNamespace(standard_error=lambda _: np.inf)
    for interval in (wald_interval, profile_interval):
        assert ends(interval(fit, slope)) == [None, slope(fit.theta)[0], None]


def test_the_curve_of_a_straight_model_is_its_parabola():
    """(v - g)^2 over the variance, at places up to so many standard errors on both sides."""
    fit = straight()
    value, gradient = slope(fit.theta)
    values, rise = profile_curve(fit, slope, count=9, reach=2.0)
    assert (values - value) / error(gradient) == pytest.approx(np.linspace(-2, 2, 9), abs=2e-3)
    assert rise == pytest.approx(((values - value) / error(gradient)) ** 2, abs=1e-6)
    assert len(profile_curve(fit, slope)[0]) == 21
    assert np.ptp(profile_curve(fit, slope)[0]) == pytest.approx(6 * error(gradient), rel=1e-3)


def test_each_point_of_a_curve_begins_where_the_last_one_ended_and_the_curve_ends_with_the_model(monkeypatch):
    asked = []

    def minimum(fit, g, start, target, width):
        asked.append((start, target, width))
        if target > 1.5:
            raise TooStrongError("no")
        return f"after {target:.3g}", target + 0.01, 4.0

    monkeypatch.setattr(profile, "_minimum_at", minimum)
    fit = SimpleNamespace(theta="theta", directions=SimpleNamespace(standard_error=lambda _: 1.0))
    values, rise = profile_curve(fit, lambda _: (0.0, 0), count=5, reach=2.0)
    assert asked == [("theta", -1, 1.0), ("after -1", -2, 1.0), ("theta", 1, 1.0), ("after 1", 2, 1.0)]
    assert values.tolist() == [-1.99, -0.99, 0.0, 1.01] and rise.tolist() == [4.0, 4.0, 0.0, 4.0]


def searched(monkeypatch, rise, t=2.0, error=1.0, value=10.0):
    """The end that is found where the profile rises so, the places that were asked for, and where each began."""
    asked = []

    def minimum(fit, g, start, target, width):
        asked.append((start, target, width))
        return f"at {target:.6g}", target, rise(target)

    monkeypatch.setattr(profile, "_minimum_at", minimum)
    fit = SimpleNamespace(theta="theta")
    return profile._end(fit, None, value, error, t), asked


@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_the_end_of_a_parabola_is_found_at_once(monkeypatch, sign):
    end, asked = searched(monkeypatch, lambda v: (v - 10) ** 2, error=sign)
    assert end == 10 + 2 * sign and asked == [("theta", end, 1.0)]


@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_the_end_of_a_bent_profile_is_met_to_half_a_percent_by_secants(monkeypatch, sign):
    height = lambda v: abs(v - 10) ** 1.5 / 4  # noqa: E731
    end, asked = searched(monkeypatch, lambda v: height(v) ** 2, error=sign)
    assert height(end) == pytest.approx(2.0, rel=5e-3) and end == pytest.approx(10 + 4 * sign, rel=5e-3)
    # The first secant goes through the estimate, height 0, and the first place, 2 errors away.
    first = height(10 + 2 * sign)
    assert asked[1][1] == pytest.approx(10 + sign * 2 * 2 / first, rel=1e-12)
    assert [start for start, *_ in asked[1:]] == [f"at {target:.6g}" for _, target, _ in asked[:-1]]


def test_of_the_points_those_nearest_to_the_height_make_the_secant(monkeypatch):
    """Heights 0 and 1 at 10 and 12; the secant leads to 14, whose height is 6: then 12 and 14 are not nearest, but 10
    and 12 (2 - 0 and 2 - 1) are, the larger one having been left."""
    rises = {12.0: 1.0, 14.0: 36.0}
    _, asked = searched(monkeypatch, lambda v: rises.get(round(v, 6), 4.0))
    assert [target for _, target, _ in asked[:2]] == [12.0, 14.0]
    assert asked[2][1] == pytest.approx(14.0)  # 10 + 2 * (12 - 10)/(1 - 0)


def test_a_profile_that_falls_or_does_not_rise_sets_no_limit(monkeypatch):
    assert searched(monkeypatch, lambda v: 0.0)[0] is None  # flat: the secant has no slope
    assert searched(monkeypatch, lambda v: -1.0)[0] is None
    end, asked = searched(monkeypatch, lambda v: (1e-9 * (v - 10)) ** 2)
    assert end is None and abs(asked[-1][1] - 10) > 1e3  # a thousand errors away, and not there yet
    assert all(abs(target - 10) <= 1.0001e4 for _, target, _ in asked)


def test_where_the_model_ends_the_search_goes_half_way_back(monkeypatch):
    asked = []

    def minimum(fit, g, start, target, width):
        asked.append(target)
        if target > 11.2:
            raise TooStrongError("the motion ends")
        return "theta", target, (2.2 * (target - 10)) ** 2

    monkeypatch.setattr(profile, "_minimum_at", minimum)
    end = profile._end(SimpleNamespace(theta="theta"), None, 10.0, 1.0, 2.0)
    assert asked[:3] == [12.0, 11.0, pytest.approx(10 + 2 / 2.2)] and end == pytest.approx(10 + 2 / 2.2)
    asked.clear()

    def higher(fit, g, start, target, width):
        asked.append(target)
        if target > 11.2:
            raise TooStrongError("the motion ends")
        return "theta", target, (target - 10) ** 2

    monkeypatch.setattr(profile, "_minimum_at", higher)  # the height is never reached: no limit
    assert profile._end(SimpleNamespace(theta="theta"), None, 10.0, 1.0, 2.0) is None
    assert asked[:4] == [12.0, 11.0, 12.0, 11.5] and len(asked) == 12


def test_secants_that_do_not_meet_the_height_leave_the_straight_line_between_points_around_it(monkeypatch):
    """A step of the profile from height 1 to 3 at v = 11.5."""
    end, asked = searched(monkeypatch, lambda v: 1.0 if v < 11.5 else 9.0)
    assert len(asked) == 12 and 10 < end < 12.1


def test_a_point_of_the_profile_is_the_least_sum_of_squares_at_its_value():
    """By the formula of constrained least squares: the rise is (v - g)^2 over the variance, whatever the start."""
    fit = straight()
    value, gradient = slope(fit.theta)
    own = error(gradient)
    for start in (fit.theta, fit.theta + 3.0):
        theta, at, rise = profile._minimum_at(fit, slope, start, value + 1.7 * own, own)
        assert at == slope(theta)[0] == pytest.approx(value + 1.7 * own, abs=2e-3 * own)
        assert rise == pytest.approx(((at - value) / own) ** 2, rel=1e-6)
        shift = np.linalg.inv(J.T @ J) @ gradient
        assert theta - fit.theta == pytest.approx(shift * (at - value) / (gradient @ shift), rel=1e-4)


def test_a_point_is_sought_along_the_straight_line_and_from_the_start_where_that_leaves_the_model(monkeypatch):
    fit, begun = straight(), []
    value, gradient = slope(fit.theta)

    def minimise(model, theta, scales, penalty):
        begun.append(theta)
        miss, pull = penalty(theta)
        assert pull == pytest.approx(gradient / (0.02 * 0.25)) and scales is fit.scales and model is fit.model
        assert miss == pytest.approx((slope(theta)[0] - value - 2.0) / (0.02 * 0.25), abs=1e-9)
        if len(begun) == 1:
            raise TooStrongError("outside")
        return theta, True

    monkeypatch.setattr(profile, "minimise", minimise)
    theta, at, rise = profile._minimum_at(fit, slope, np.array([5.0, 6.0]), value + 2.0, 0.25)
    shift = np.linalg.inv(J.T @ J) @ gradient
    assert begun[0] - fit.theta == pytest.approx(shift * 2.0 / (gradient @ shift)) and begun[1].tolist() == [5.0, 6.0]
    r = (DATA - J @ theta) / SIGMA
    assert theta.tolist() == [5.0, 6.0] and at == -2.0 and rise == pytest.approx(float(r @ r) - fit.chi2)
