"""The theorem for all turning points, against the truncated equations and the certified orbit."""

from dataclasses import replace
from itertools import islice

import numpy as np
import pytest
from flint import arb, ctx
from scipy.integrate import solve_ivp

from asymptotics.bounds import turning
from asymptotics.bounds.turning import turning_bounds
from asymptotics.errors import InputError, LimitError
from asymptotics.numbers.exact import parse_real
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
