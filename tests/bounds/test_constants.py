"""The constants by which errors add up: above (or below) an independent value, and not a factor of two off."""

import numpy as np
import pytest
from flint import arb
from scipy.integrate import solve_ivp

from asymptotics.bounds.local import flow_majorant, local_bounds
from asymptotics.bounds.turning import largest, turning_bounds
from asymptotics.numbers.exact import parse_real
from tests.bounds.test_local import true_swing, truncated_swing


def reals(*texts):
    return [parse_real(text, "alpha") for text in texts]


def slopes(alphas, deltas, h=1e-3):
    """delta dL/d delta and delta dT/d delta along the ray, by central differences of the certified half-swing."""
    above, below = (true_swing(alphas, [d * k for d in deltas]) for k in (1 + h, 1 - h))
    return [(a - b) / (2 * h) for a, b in zip(above, below)]


@pytest.mark.parametrize(("alpha", "delta"), [("2", 0.04), ("3/2", 0.05), ("3", 0.02)])
def test_durations_change_with_delta_as_fast_as_B_says(alpha, delta):
    bounds = turning_bounds(reals(alpha), 2, [arb(delta)])
    _, change = slopes(reals(alpha), [delta])
    assert abs(change) < float(bounds.B) * delta**2 < 1.6 * abs(change)


@pytest.mark.parametrize(("alpha", "delta"), [("2", 0.05), ("3/2", 0.05), ("3", 0.03)])
def test_amplitudes_draw_together_as_fast_as_k_says(alpha, delta):
    bounds = turning_bounds(reals(alpha), 2, [arb(delta)])
    change, _ = slopes(reals(alpha), [delta])
    k = float(bounds.fading) / (float(arb(parse_real(alpha, "alpha").ball())) - 1)
    assert 0.7 * -change / delta < k < -change / delta


@pytest.mark.parametrize(("alpha", "epsilon", "order"), [("2", 0.05, 1), ("3/2", 0.05, 3), ("3", 0.04, 2)])
def test_the_truncated_orbit_falls_between_g_and_G(alpha, epsilon, order):
    bounds = turning_bounds(reals(alpha), order, [arb(epsilon)])
    weight = float(parse_real(alpha, "alpha").ball()) - 1
    logs = _truncated_logs(alpha, epsilon, order, 40, bounds.local.flow)
    steps = np.diff(np.exp(-weight * logs) / epsilon)
    assert float(bounds.g) <= steps.min() * (1 + 1e-9)
    assert steps.max() <= float(bounds.G) * (1 + 1e-9)
    assert float(bounds.G) < 1.25 * float(bounds.g)


def _truncated_logs(alpha, epsilon, order, count, flow):
    p, Omega = ({n: float(arb(c)) for (n,), c in f.truncate(order).coefficients.items()} for f in (flow.p, flow.Omega))
    weight = float(parse_real(alpha, "alpha").ball()) - 1

    def rates(_, y):
        d = epsilon * np.exp(weight * y[0])
        return [-sum(c * d**n for n, c in p.items()) / (1 + sum(c * d**n for n, c in Omega.items()))]

    grid = np.arange(count + 1) * np.pi
    return solve_ivp(rates, (0, grid[-1]), [0.0], method="DOP853", rtol=1e-12, atol=1e-14, t_eval=grid).y[0]


SLOW = [pytest.param(("1/2", "2"), marks=pytest.mark.slow), pytest.param(("3/2", "3"), marks=pytest.mark.slow)]


@pytest.mark.parametrize("alphas", [("1", "2"), *SLOW])
def test_the_majorant_of_a_sum_is_nearly_attained(alphas):
    bounds = local_bounds(reals(*alphas), 2)
    rho = float(bounds.delta_max) / 2
    growth, excess = flow_majorant(bounds.flow, 2, arb(rho))
    L, T = truncated_swing(bounds, [-rho, -rho])
    assert abs(L) < float(growth) < 1.2 * abs(L)
    assert abs(T - np.pi) < float(excess)


def test_the_phase_runs_as_fast_as_Omega_says():
    bounds = turning_bounds(reals("2"), 3, [arb("0.1")])
    Omega = bounds.local.flow.Omega.truncate(3)
    swing = abs(float(arb(Omega[2]))) * 0.1**2
    assert float(largest(Omega, arb("0.1"))) == pytest.approx(swing, rel=1e-12)
    assert float(bounds.phase(10) / bounds.time(10)) == pytest.approx(1 + swing, rel=1e-12)
