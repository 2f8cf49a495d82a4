"""The series of a half-swing in doubles, against certified balls and closed forms."""

from fractions import Fraction

import numpy as np
import pytest
from scipy.special import beta, gamma

from asymptotics.decays.identification.forward.coefficients import loss, spring, swing_coefficients
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.quarter import half_swing
from asymptotics.numbers.exact import parse_real
from asymptotics.terms import Term
from tests.each import each


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


@each("alpha", [0.0, 1.0, 1.5, 2.0, 3.0])
@each("p", [2, 3, 5])
def test_the_first_coupling_of_a_loss_and_a_spring_has_its_closed_form(alpha, p):
    # The mixed coefficient of L is that of pi U (W has none), and, with M = M_(alpha+1),
    # U_mixed = M (p - alpha)/(p + 1) + p/(p + 1) <|c|^(p-1) |s|^(alpha+1)>; for the time T = pi W, W = -M_(p+1) gamma.
    found = swing_coefficients((loss(alpha), spring(p)), 2)
    place = {k: i for i, k in enumerate(found.keys)}
    mixed = moment(alpha + 1) * (p - alpha) / (p + 1) + p / (p + 1) * beta(p / 2, (alpha + 2) / 2) / np.pi
    assert found.L[0, place[1, 1]] == pytest.approx(np.pi * mixed, rel=1e-11)
    assert found.T[0, place[0, 1]] == pytest.approx(-np.pi * moment(p + 1), rel=1e-11)
    assert abs(found.L[0, place[0, 2]]) < 1e-12  # a spring alone loses nothing
