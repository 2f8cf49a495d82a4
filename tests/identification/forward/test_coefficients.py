"""The forward model: against certified balls, closed forms, other integrations, and differences."""

from fractions import Fraction

import numpy as np
import pytest
from scipy.special import beta, ellipk, gamma

from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.quarter import half_swing
from asymptotics.identification.forward.coefficients import loss, spring, swing_coefficients
from asymptotics.identification.forward.quadrature import TooStrongError, integrated_swings
from asymptotics.identification.forward.sequence import turning_sequence
from asymptotics.identification.forward.swing import HalfSwingModel
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_real
from asymptotics.terms import Term
from asymptotics.turning.choose import turning_points


@pytest.mark.parametrize("law", [("3/2",), ("0", "1"), ("1/10", "2"), ("0", "1/2", "3")])
def test_series_in_doubles_agree_with_certified_balls(law):
    exponents = [parse_real(a, "a") for a in law]
    quarter = quarter_swing(exponents, 5)
    half = half_swing(quarter)
    found = swing_coefficients(tuple(loss(float(Fraction(a))) for a in law), 5)
    certified = {"L": half.L, "T": half.T, "R": quarter.R, "T_q": quarter.T_q}
    for name, series in certified.items():
        for i, key in enumerate(found.keys):
            if any(key) or name.startswith("T"):
                ball = series[key]
                assert abs(getattr(found, name)[0, i] - float(ball)) < 3e-12 * (1 + abs(float(ball))), (name, key)
    near_miss = swing_coefficients(
        (loss(float(Fraction(law[0])) + 1e-6), *(loss(float(Fraction(a))) for a in law[1:])), 5
    )
    assert max(abs(near_miss.L[0] - found.L[0])) > 1e-8


def test_series_with_springs_agree_with_certified_balls():
    quarter = quarter_swing([Term(1, "3/2"), Term(1, 0, 3, "position")], 4)
    half = half_swing(quarter)
    found = swing_coefficients((loss(1.5), spring(3)), 4)
    for name, series in {"L": half.L, "T": half.T, "R": quarter.R, "T_q": quarter.T_q}.items():
        for i, key in enumerate(found.keys):
            if any(key) or name.startswith("T"):
                assert abs(getattr(found, name)[0, i] - float(series[key])) < 1e-11 * (1 + abs(float(series[key])))


def moment(p):
    return gamma((p + 1) / 2) / (np.sqrt(np.pi) * gamma(p / 2 + 1))


@pytest.mark.parametrize("alpha", [0.0, 1.0, 1.5, 2.0, 3.0])
@pytest.mark.parametrize("p", [2, 3, 5])
def test_the_first_coupling_of_a_loss_and_a_spring_has_its_closed_form(alpha, p):
    # The mixed coefficient of L is that of pi U (W has none), and, with M = M_(alpha+1),
    # U_mixed = M (p - alpha)/(p + 1) + p/(p + 1) <|c|^(p-1) |s|^(alpha+1)>; for the time T = pi W, W = -M_(p+1) gamma.
    found = swing_coefficients((loss(alpha), spring(p)), 2)
    place = {k: i for i, k in enumerate(found.keys)}
    mixed = moment(alpha + 1) * (p - alpha) / (p + 1) + p / (p + 1) * beta(p / 2, (alpha + 2) / 2) / np.pi
    assert found.L[0, place[1, 1]] == pytest.approx(np.pi * mixed, rel=1e-11)
    assert found.T[0, place[0, 1]] == pytest.approx(-np.pi * moment(p + 1), rel=1e-11)
    assert abs(found.L[0, place[0, 2]]) < 1e-12  # a spring alone loses nothing


def test_the_conservative_spring_has_the_period_of_the_elliptic_integral():
    gamma_ = 0.05  # x'' + x + gamma x^3: half period 2 K(m)/sqrt(1 + gamma), m = gamma/(2 (1 + gamma))
    swing = HalfSwingModel((loss(1.0), spring(3)))
    found = swing.at(np.array([0.0]), np.array([0.0, gamma_]))
    exact = 2 * ellipk(gamma_ / (2 * (1 + gamma_))) / np.sqrt(1 + gamma_)
    assert found.of("T")[0] == pytest.approx(exact, abs=1e-9)
    assert found.of("L")[0] == pytest.approx(0, abs=1e-12)


SUMS = [
    ((loss(1), loss(2)), (0.02, 0.03), False),
    ((loss(0), loss(1)), (0.02, 0.03), False),
    ((loss(1), loss(2), spring(3), spring(5)), (0.02, 0.03, 0.02, -0.01), False),
    ((loss(1), spring(3)), (0.04, 0.03, 1.37), True),
    ((loss(1, 2), loss(0.5, 1), spring(2)), (0.04, 0.03, 0.03), False),
]


@pytest.mark.parametrize(("elements", "parameters", "free"), SUMS)
def test_the_series_agree_with_the_integral_equation_and_both_with_differences(elements, parameters, free):
    swing, p, a = HalfSwingModel(elements, free), np.array(parameters), np.linspace(-1.0, -0.4, 7)
    swing.tolerance = 1e-3
    found = swing.at(a, p)
    other = integrated_swings(elements, a, p[: len(elements)], p[-1] if free else None)
    for one, two in zip((found.values, found.by_amplitude, found.by_parameter), other, strict=True):
        assert np.abs(one - two).max() < 2e-6
    h = 1e-6
    slope = (swing.at(a + h, p).values - swing.at(a - h, p).values) / (2 * h)
    assert np.abs(slope - found.by_amplitude).max() < 1e-7
    for i in range(len(p)):
        e = np.eye(len(p))[i] * h
        slope = (swing.at(a, p + e).values - swing.at(a, p - e).values) / (2 * h)
        assert np.abs(slope - found.by_parameter[i]).max() < 1e-7


LAWS = [[("1/10", "3/2")], [("1/25", "0"), ("1/20", "1")], [("1/10", "1"), ("1/10", "2")]]


@pytest.mark.parametrize("law", LAWS)
def test_turning_points_and_times_are_those_of_the_certified_program(law):
    swings = 8
    table = turning_points(Law({a: e for e, a in law}), swings + 1, 14, times=True)
    swing = HalfSwingModel([loss(float(Fraction(a))) for _, a in law])
    found = turning_sequence(swing, swings, np.array([0.0, *(float(Fraction(e)) for e, _ in law)]))
    assert np.abs(np.exp(found.a) - [abs(float(p.x)) for p in table.points]).max() < 1e-10
    assert np.abs(found.tau - [float(p.tau) for p in table.points]).max() < 1e-10


def test_the_derivatives_of_the_sequence_are_exact():
    swing, p = HalfSwingModel((loss(1), loss(2), spring(3))), np.array([0.0, 0.01, 0.02, 0.02])
    found, h = turning_sequence(swing, 60, p), 1e-6
    for i in range(4):
        e = np.eye(4)[i] * h
        up, down = turning_sequence(swing, 60, p + e), turning_sequence(swing, 60, p - e)
        for name in ("a", "tau", "passage", "log_speed"):
            slope = (getattr(up, name) - getattr(down, name)) / (2 * h)
            assert np.abs(slope - getattr(found, "d_" + name)[i]).max() < 1e-6 * (1 + np.abs(slope).max()), name


def test_motion_that_sticks_has_no_next_turning_point():
    with pytest.raises(TooStrongError):
        turning_sequence(HalfSwingModel((loss(0),)), 6, np.array([0.0, 0.1]))  # from 1 by 0.2: five swings
