"""The half-swing of a model: elliptic integrals, the integral equation, and differences."""

import numpy as np
import pytest
from scipy.special import ellipk

from asymptotics.decays.identification.forward.coefficients import loss, spring
from asymptotics.decays.identification.forward.quadrature import integrated_swings
from asymptotics.decays.identification.forward.swing import HalfSwingModel

SUMS = [
    ((loss(1), loss(2)), (0.02, 0.03), False),
    ((loss(0), loss(1)), (0.02, 0.03), False),
    ((loss(1), loss(2), spring(3), spring(5)), (0.02, 0.03, 0.02, -0.01), False),
    ((loss(1), spring(3)), (0.04, 0.03, 1.37), True),
    ((loss(1, 2), loss(0.5, 1), spring(2)), (0.04, 0.03, 0.03), False),
]


def test_the_conservative_spring_has_the_period_of_the_elliptic_integral():
    gamma_ = 0.05  # x'' + x + gamma x^3: half period 2 K(m)/sqrt(1 + gamma), m = gamma/(2 (1 + gamma))
    swing = HalfSwingModel((loss(1.0), spring(3)))
    found = swing.at(np.array([0.0]), np.array([0.0, gamma_]))
    exact = 2 * ellipk(gamma_ / (2 * (1 + gamma_))) / np.sqrt(1 + gamma_)
    assert found.of("T")[0] == pytest.approx(exact, abs=1e-9)
    assert found.of("L")[0] == pytest.approx(0, abs=1e-12)


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
