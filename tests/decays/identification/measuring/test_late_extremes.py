"""Extremes of motions with friction: the polynomial finds them late, by what ``late_extremes`` says, and the law allows
for it."""

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.measuring.extraction import observations_of_record
from asymptotics.decays.identification.measuring.late_extremes import DEGREE, Window
from tests.decays.identification import test_real_layouts as layouts
from tests.decays.identification.test_real_layouts import friction

DRY, LINEAR = 0.0122, 0.0061
ROTATION = 2 * np.pi
"""A period of 1 s."""


def decay(per_period, noise=0.0):
    t = np.arange(0, 17, 1 / per_period) + 0.003
    return t, friction(t * ROTATION / layouts.W, 1.0, DRY, LINEAR) + layouts.noise(len(t), noise, 3)


def turns(count):
    """The exact turning points of ``decay``: numbers in half-swings, sizes."""
    mu, size = LINEAR / 2, [1.0]
    shrink = np.exp(-mu * np.pi / np.sqrt(1 - mu**2))
    for _ in range(count):
        size.append((size[-1] - DRY) * shrink - DRY)
    return np.array(size)


@pytest.mark.parametrize("per_period", [44, 60, 90, 120, 300])
def test_extremes_of_dry_friction_are_found_late_by_the_lateness(per_period):
    t, x = decay(per_period)
    seen = observations_of_record(t, x)
    half = 0.5 / np.sqrt(1 - (LINEAR / 2) ** 2)
    n = np.round((seen.t + 0.0) / half).astype(int)
    late = (seen.t - n * half) * ROTATION
    strength = DRY / turns(int(n[-1]))[n]
    expected = strength * seen.window.lateness(0.0)
    assert late[-1] > 0.01  # an angle that no noise of this record hides: what was wrong
    # Where the window has one sample more or less than a typical one it is 6 % of it; else a thousandth.
    assert np.allclose(late, expected, atol=1e-6, rtol=0.07)
    assert np.median(np.abs(late / expected - 1)) < 0.02


@pytest.mark.parametrize("noise", [1e-5, 1e-4, 1e-3])
def test_dry_friction_beside_a_drag_is_not_refuted_in_dense_quiet_records(noise):
    t, x = decay(120, noise)
    answer = asy.identify((t, x), laws=["0+1", "0+1+s3", "0+1+s3+s5"], bootstrap=False)
    law = answer.law("0+1").law
    assert law.verdict == "consistent"
    assert [e.contains(v) for e, v in zip(law.epsilon, (DRY, LINEAR), strict=True)] == [True, True]


def test_steps_of_the_last_digit_in_a_sparse_record_leave_the_law():
    t = 0.02 + 0.0522727 * np.arange(547)
    x = friction((t - 0.02) * 4.4 / layouts.W, 190.0, 2.28, 0.006)
    answer = asy.identify((np.round(t, 3), np.round(x + 440)), laws=["0+1", "0+1+s3", "0+1+s3+s5"], bootstrap=False)
    assert answer.verdict.text.startswith("identified: 0+1,") or answer.verdict.text.startswith("identified: 0+1 ")
    law = answer.law("0+1").law
    assert [e.contains(v) for e, v in zip(law.epsilon, (2.28, 0.006), strict=True)] == [True, True]


@pytest.mark.parametrize(("velocity", "position"), [(0.5, 0), (0.0, 2), (2.0, 0), (3.0, 0)])
def test_the_lateness_is_that_of_the_polynomial_through_the_forced_motion(velocity, position):
    """Second route: g'' + g = sin^q |cos|^p stepped by the central difference, and polyfit."""
    window, step = Window((tuple(np.linspace(-0.9, 0.9, 61)),)), 1e-4
    s = np.arange(0, 0.9 + step, step)
    force = np.sin(s) ** velocity * np.cos(s) ** position if velocity or position else np.ones(len(s))
    g, slope = np.zeros(len(s)), 0.0
    for i in range(1, len(s)):
        middle = 0.5 * (force[i] + force[i - 1])
        slope += step * (middle - g[i - 1])
        g[i] = g[i - 1] + step * slope
    u = np.linspace(-0.9, 0.9, 61)
    odd = np.sign(u) * np.interp(np.abs(u), s, g)
    found = np.polynomial.Polynomial.fit(u, odd, DEGREE).deriv()(0.0)
    assert window.lateness(velocity, position) == pytest.approx(found, abs=6e-5)
    assert abs(found) > 4e-4  # and is not nothing


def test_the_derivative_by_the_exponent_is_that_of_the_lateness():
    window = Window((tuple(np.linspace(-0.7, 0.7, 71)),))
    for q in (0.0, 0.5, 2.0):
        wide = (window.lateness(q + 0.01) - window.lateness(max(q - 0.01, 0.0))) / (0.02 if q else 0.01)
        assert window.by_exponent(q) == pytest.approx(wide, rel=0.05, abs=1e-4)


@pytest.mark.parametrize("text", [pytest.param("free+s3", marks=pytest.mark.slow), "0+2"])
def test_the_predicted_times_have_exact_derivatives_with_the_lateness(text):
    """The columns of ``predict`` against differences, for a free exponent and a spring."""
    t, x = decay(120, 1e-4)
    law = asy.identify((t, x), laws=[text], bootstrap=False).law(text).law
    model, theta = law.fit.model, law.fit.theta + 0.01 * np.abs(law.fit.theta)
    _, slopes = model.predict(theta)
    for k in range(len(theta)):
        by = np.zeros(len(theta))
        by[k] = 1e-5 * max(abs(theta[k]), 1e-2)
        difference = (model.predict(theta + by)[0] - model.predict(theta - by)[0]) / (2 * by[k])
        assert np.allclose(difference, slopes[:, k], atol=2e-4 * np.abs(slopes[:, k]).max() + 1e-9), k
