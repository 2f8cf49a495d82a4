"""The theorem for all turning points, against the truncated equations and the certified orbit, and its parts alone."""

from dataclasses import replace
from itertools import islice
from types import SimpleNamespace

import numpy as np
import pytest
from flint import arb, ctx
from scipy.integrate import solve_ivp

from asymptotics.bounds import turning
from asymptotics.bounds.turning import TurningBounds, largest, rates, sensitivity, turning_bounds
from asymptotics.errors import InputError, LimitError
from asymptotics.numbers.exact import parse_real
from asymptotics.series import Series
from tests.bounds.test_local import true_swing
from tests.second_route.quarter_series import finite_quarter


def reals(*texts):
    return [parse_real(text, "alpha") for text in texts]


def measured(alpha, epsilon, order, count, flow):
    """|ln A_n - ln A^_n| and |tau_n - tau^_n| for n = 0 ... count."""
    p, Omega = ({n: float(arb(c)) for (n,), c in f.truncate(order).coefficients.items()} for f in (flow.p, flow.Omega))
    weight = float(parse_real(alpha, "alpha").ball()) - 1

    def rates(psi, y):
        d = epsilon * np.exp(weight * y[0])
        speed = 1 + sum(c * d**n for n, c in Omega.items())
        return [-sum(c * d**n for n, c in p.items()) / speed, 1 / speed - 1]

    grid = np.arange(count + 1) * np.pi
    hats = solve_ivp(rates, (0, grid[-1]), [0.0, 0.0], method="DOP853", rtol=1e-12, atol=1e-14, t_eval=grid).y
    with ctx.workprec(70):
        quarter = finite_quarter(reals(alpha), [arb(epsilon)], 55)
        rows = list(islice(quarter.orbit([arb(epsilon)], arb(0), arb(0)), count + 1))
        lags = np.concatenate([[0.0], np.cumsum([float(row[2] - arb.pi()) for row in rows[:-1]])])
    return np.abs([float(row[0]) for row in rows] - hats[0]), np.abs(lags - hats[1])


# Exponent, epsilon, order, and how far above the error the bounds may be: at n = 10, and over 300 half-swings.
CASES = [
    ("3/2", 0.05, 1, 1.3, 1.5),
    ("2", 0.05, 2, 1.9, 2.2),
    ("3/2", 0.1, 3, 1.9, 2.4),
    ("3", 0.05, 1, 1.9, 4.5),
    ("1", 0.1, 1, 1.6, 1.6),
]


def slopes(alphas, deltas, h=1e-3):
    """delta dL/d delta and delta dT/d delta along the ray, by central differences of the certified half-swing."""
    above, below = (true_swing(alphas, [d * k for d in deltas]) for k in (1 + h, 1 - h))
    return [(a - b) / (2 * h) for a, b in zip(above, below)]


def _truncated_logs(alpha, epsilon, order, count, flow):
    p, Omega = ({n: float(arb(c)) for (n,), c in f.truncate(order).coefficients.items()} for f in (flow.p, flow.Omega))
    weight = float(parse_real(alpha, "alpha").ball()) - 1

    def rates(_, y):
        d = epsilon * np.exp(weight * y[0])
        return [-sum(c * d**n for n, c in p.items()) / (1 + sum(c * d**n for n, c in Omega.items()))]

    grid = np.arange(count + 1) * np.pi
    return solve_ivp(rates, (0, grid[-1]), [0.0], method="DOP853", rtol=1e-12, atol=1e-14, t_eval=grid).y[0]


DELTA = arb("0.25")


TIGHT = arb(1e-9)


def series(**coefficients):
    """1 + ... of one variable: c2="1/3" is the coefficient of its square."""
    return Series({(int(name[1:]),): arb(value) for name, value in coefficients.items()}, 1, 3)


def attained(bound, value):
    return bool(value <= bound * (1 + TIGHT) and bound <= value * (1 + TIGHT))


def rest(M, rho, order, delta):
    """Of M sum_(k > order) x^k, x = delta/rho, delta times the derivative, term by term."""
    return sum((k * M * (delta / rho) ** k for k in range(order + 1, order + 200)), arb(0))


@pytest.mark.parametrize(("alpha", "epsilon", "order", "slack", "later"), CASES)
def test_the_theorem_holds_for_every_n_and_its_half_would_not(alpha, epsilon, order, slack, later):
    bounds = turning_bounds(reals(alpha), order, [arb(epsilon)])
    amplitude, time = measured(alpha, epsilon, order, 300, bounds.local.flow)
    for n in (1, 2, 10, 60, 300):
        assert amplitude[n] < float(bounds.log_amplitude(n)) < later * amplitude[n]
        assert time[n] < float(bounds.time(n)) < later * time[n]
    assert float(bounds.log_amplitude(10)) < slack * amplitude[10]
    assert float(bounds.time(10)) < slack * time[10]
    assert slack < 2
    assert bounds.log_amplitude(0) == 0


def test_the_errors_are_bounded_for_all_time():
    bounds = turning_bounds(reals("2"), 3, [arb("0.05")])
    assert bounds.log_amplitude(10**18) < bounds.log_amplitude(100)
    assert bounds.time(10**18) < 2 * bounds.time(100)
    assert bounds.phase(5) <= bounds.time(5) * 2
    for bound in (bounds.log_amplitude, bounds.time, bounds.phase):
        assert all(bound(n) <= bound(None) for n in (1, 10, 1000, 10**18))
        assert bound(None) < 3 * max((bound(n) for n in (3, 10, 30, 100)), key=float)
    linear = turning_bounds(reals("1", "2"), 1, [arb("0.01"), arb("0.01")])
    assert linear.log_amplitude(1000) > 900 * linear.log_amplitude(1)  # a linear term: in proportion to n
    assert not linear.log_amplitude(None).is_finite()
    assert linear.log_amplitude(None) > 10**300


def test_what_the_theorem_does_not_cover_is_refused():
    with pytest.raises(InputError, match="1/2 is below 1"):
        turning_bounds(reals("1/2"), 1, [arb("0.01")])
    with pytest.raises(LimitError, match="range of the theorem"):
        turning_bounds(reals("2"), 1, [arb(1)])


def test_without_their_premises_the_sharper_bounds_are_not_claimed():
    """What does not fade, or does not fall, adds up: n |delta|^m, and no less."""
    bounds = replace(turning_bounds(reals("2"), 1, [arb("0.05")]), delta=arb("0.3"), G=arb(1))
    slow = replace(bounds, g=arb("0.001"), fading=arb(-1))
    assert abs(slow.log_amplitude(10) - slow._crude(10)) < 1e-9
    rising = replace(bounds, g=arb(-1), fading=arb(1))
    assert abs(rising.log_amplitude(10) - rising._crude(10)) < 1e-9
    steep = replace(bounds, g=arb(10))
    assert abs(steep._sum(arb(2), 5) - 5 * arb("0.3") ** 2) < 1e-9


@pytest.mark.parametrize("found", [(-1, 1), (1, -1)])
def test_an_amplitude_equation_that_may_lose_its_sign_is_refused(monkeypatch, found):
    monkeypatch.setattr(turning, "rates", lambda *_: tuple(map(arb, found)))
    with pytest.raises(LimitError, match="may lose its sign"):
        turning_bounds(reals("2"), 1, [arb("0.05")])


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


def test_the_phase_runs_as_fast_as_Omega_says():
    bounds = turning_bounds(reals("2"), 3, [arb("0.1")])
    Omega = bounds.local.flow.Omega.truncate(3)
    swing = abs(float(arb(Omega[2]))) * 0.1**2
    assert float(largest(Omega, arb("0.1"))) == pytest.approx(swing, rel=1e-12)
    assert float(bounds.phase(10) / bounds.time(10)) == pytest.approx(1 + swing, rel=1e-12)


@pytest.mark.parametrize("sign", [-1, 1])
def test_the_rates_count_the_higher_terms_of_both_series(sign):
    """p = d - d^2/2 and Omega = d/3 are slowest at the far end, p = d + d^2/2 and Omega = -d/3 fastest."""
    low, high = rates(series(c1=1, c2=sign * 0.5), series(c1=-sign / 3), DELTA)
    truth = (1 + sign * DELTA / 2) / (1 - sign * DELTA / 3)
    assert attained(high if sign > 0 else low, truth)
    assert low <= truth * (1 + TIGHT) and truth <= high * (1 + TIGHT)


@pytest.mark.parametrize("order", [1, 3, 8])
def test_the_sum_beyond_is_that_of_its_terms(order):
    M, rho = arb("0.7"), arb("0.6")
    assert attained(turning._beyond(M, rho, order, DELTA), rest(M, rho, order, DELTA))


def test_the_steepness_and_the_sensitivity_are_attained_by_their_majorants():
    """-L = d - d^2/9 - M sum x^k falls slowest, T = pi + d^2/5 + M sum x^k changes fastest."""
    M, rho = arb("0.01"), arb("0.6")
    beyond = SimpleNamespace(cauchy=M, radius=rho)
    half = SimpleNamespace(L=series(c1=-1, c2=arb(1) / 9), T=series(c0=arb.pi(), c2=arb(1) / 5))
    local = SimpleNamespace(half=half, amplitude=beyond, duration=beyond)
    tail = rest(M, rho, 3, DELTA)
    assert attained(turning._steepness(local, DELTA), 1 - 2 * DELTA / 9 - tail / DELTA)
    assert attained(sensitivity(local, DELTA), arb(2) / 5 + tail / DELTA**2)
    assert tail / DELTA**2 > arb("0.01")


@pytest.mark.parametrize("e", ["0.05", "0.3"])
def test_a_motion_that_is_ahead_by_e_has_the_strengths_of_its_own_amplitude(e):
    """T = pi + c delta^2, alpha = 2, B = 2 c: late by c delta^2 (e^(2 e) - 1) after one half-swing."""
    e, c, none = arb(e), arb(1) / 12, arb(0)
    local = SimpleNamespace(duration=SimpleNamespace(power=4), amplitude=SimpleNamespace(power=3))
    bounds = TurningBounds(local, DELTA, none, none, arb(1), arb(1), none, none, none, 2 * c, e, arb(1))
    late = c * DELTA**2 * ((2 * e).exp() - 1)
    assert late <= bounds.time(1) < late * (1 + arb("1.2") * e)
    assert 2 * c * e * DELTA**2 < late


@pytest.mark.parametrize(("alpha", "weight"), [("2", 1), ("3", 2)])
def test_an_uncertain_start_makes_the_strength_the_larger_one(alpha, weight):
    e, epsilon = arb("0.1"), arb(1) / 50
    bounds = turning_bounds([parse_real(alpha, "alpha")], 2, [epsilon], e)
    swell = (weight * e).exp()
    assert attained(bounds.delta, epsilon * swell)
    assert swell <= bounds.widening and bounds.widening <= swell**2 * (1 + TIGHT)  # what is needed is one factor
