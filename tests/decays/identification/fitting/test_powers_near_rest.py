"""The motion of losses |v|^alpha whose force has a kink or a jump at rest: a free exponent at 0, and broken ones."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import asymptotics as asy
from asymptotics.decays.identification.fitting import waveform as module
from asymptotics.decays.identification.forward.coefficients import loss
from asymptotics.decays.identification.forward.swing import HalfSwingModel
from tests.decays.identification.test_real_layouts import friction

STRENGTH, PLACES = 0.05, np.linspace(0.01, 3.1, 300)
DRY = 0.034


def integrated(alpha):
    """Second route: SciPy, from rest at 1."""

    def force(_, y):
        return [y[1], -y[0] + STRENGTH * (max(-y[1], 0.0) ** alpha if alpha else 1.0)]

    found = solve_ivp(force, (0, 3.2), [1, -1e-14], rtol=1e-11, atol=1e-13, method="DOP853", max_step=0.02)
    again = solve_ivp(
        force, (0, 3.2), [1, -1e-14], rtol=1e-11, atol=1e-13, method="DOP853", max_step=0.02, t_eval=PLACES
    )
    assert found.y[1, -1] < 0.1
    return again.y[0]


def by_nodes(alpha):
    """x, and its slope by the exponent."""
    swing = HalfSwingModel((loss(alpha),), free=True)
    nodes = module._nodes(swing, np.zeros(1), np.array([STRENGTH, alpha]), 0.0)
    x = module._between(*nodes, np.zeros(len(PLACES), int), PLACES, 0)[0]
    return x[0], (x[-1] - x[0]) / module._STEP


@pytest.mark.parametrize("alpha", [0.0, 1e-6, 3e-4, 0.05, 0.5, 1.0, 1.5, 2.0])
def test_the_nodes_follow_any_power_of_the_speed(alpha):
    """Failed before: 1.6e-3 off at exponents that are nearly 0, 1.2e-4 at a half."""
    assert np.abs(by_nodes(alpha)[0] - integrated(alpha)).max() < 5e-7


def test_the_slope_by_an_exponent_that_is_0_is_a_number():
    """Failed before: 164 in place of 0.05, so that the exponent was known to 1e-7."""
    slope = (integrated(1e-3) - integrated(0.0)) / 1e-3
    assert by_nodes(0.0)[1] == pytest.approx(slope, abs=2e-4)
    assert np.abs(slope).max() > 0.02


def test_near_miss_even_steps_do_not_follow_them(monkeypatch):
    monkeypatch.setattr(module, "_graded", lambda z: (z, np.ones(len(z))))
    assert np.abs(by_nodes(0.05)[0] - integrated(0.05)).max() > 5e-5


def test_a_sample_beyond_the_last_turning_point_is_on_the_polynomial_of_a_wide_interval():
    swing = HalfSwingModel((loss(0.0),), free=True)
    nodes = module._nodes(swing, np.zeros(1), np.array([STRENGTH, 0.0]), 0.0)
    end = float(nodes[0][-1, 0, 0])
    since, n = np.array([-0.2, end + 0.2]), np.zeros(2, int)
    exact = np.array([STRENGTH + (1 - STRENGTH) * np.cos(-0.2), STRENGTH - (1 - STRENGTH) * np.cos(0.2)])
    assert module._between(*nodes, n, since, 0, 7)[0][0] == pytest.approx(exact, abs=1e-5)
    # Near miss: the first and the last graded interval are too narrow to be continued.
    assert np.abs(module._between(*nodes, n, since, 0, 1)[0][0] - exact).max() > 1e-3


@pytest.mark.parametrize("laws", [["free"], ["0", "free"]])
def test_a_free_exponent_holds_dry_friction(laws):
    """Failed before: the strength was known to 1e-11 of itself on one side, and the truth outside; of f02 six times
    shorter than by the law without a free one, and alone "the data do not show any loss"."""
    t = np.arange(0, 40, 0.36)
    x = friction(t / 2.76, 1.0, DRY, 0.0) + 2e-4 * np.random.default_rng(7).standard_normal(len(t))
    answer = asy.identify((t, x), laws=laws, bootstrap=False)
    free = answer.law("free").law
    assert free.verdict == "consistent" and free.epsilon[0].contains(DRY) and free.alpha.low <= 1e-9
    assert free.alpha.high > 1e-4
    length = free.epsilon[0].high - free.epsilon[0].low
    assert length < 0.05 * DRY
    if "0" in laws:
        alone = answer.law("0").law.epsilon[0]
        assert length > 0.9 * (alone.high - alone.low)
