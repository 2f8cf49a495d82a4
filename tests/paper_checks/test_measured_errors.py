"""Orders of the errors against the reference motion."""

from fractions import Fraction
from math import isnan

import pytest

from paper_checks.report.measured_errors import horizon, measured_errors, unit_oscillator

KAPPAS = (Fraction(1, 10), Fraction(1, 20), Fraction(1, 40))


@pytest.mark.parametrize("alphas", [["1/2"], ["3/2"], ["2"], ["3"], ["1", "2"]])
def test_the_error_of_order_n_falls_like_kappa_to_the_n(alphas):
    first, second, third = measured_errors(alphas, (1, 2, 3), KAPPAS, points=12)
    assert 0.8 < first.fitted_order < 1.4
    assert second.fitted_order > 1.9
    assert third.fitted_order > 2.7
    assert first.fitted_order < 1.9  # a first-order motion does not pass for a second-order one


def test_dry_friction_is_exact_from_second_order_on():
    first, second = measured_errors(["0"], (1, 2), KAPPAS, points=24)
    assert 0.9 < first.fitted_order < 1.1
    assert isnan(second.fitted_order)
    assert max(second.errors) < 1e-11


def test_the_horizon_stays_short_of_extinction():
    assert horizon(["3"], Fraction(1, 10)) == 10
    assert horizon(["0"], Fraction(1, 10)) == 8
    assert horizon(["0", "2"], Fraction(1, 10)) == 8
    # kappa = M_3 epsilon = 4/(3 pi) epsilon for alpha = 2
    (epsilon,) = unit_oscillator(["2"], Fraction(1, 10)).epsilons()
    assert abs(float(epsilon.mid()) - 0.2356194490) < 1e-8
