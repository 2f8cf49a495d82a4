"""Errors followed from turning point to turning point, alpha < 1 included, against the certified orbit."""

from fractions import Fraction
from itertools import islice

import numpy as np
import pytest
from flint import arb, ctx
from scipy.integrate import solve_ivp

from asymptotics.bounds.local import local_bounds
from asymptotics.bounds.turning import turning_bounds
from asymptotics.bounds.turning_sequence import TurningPointBound, _Steps, turning_sequence_bounds
from asymptotics.errors import LimitError
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_real
from asymptotics.turning.choose import turning_points


def reals(*texts):
    return [parse_real(text, "alpha") for text in texts]


def truncated(alphas, order, epsilons, count):
    """(A^_n, tau^_n - n pi) of the equations of order N, integrated in doubles."""
    flow = local_bounds(reals(*alphas), order).flow
    both = (flow.p.truncate(order), flow.Omega.truncate(order))
    p, Omega = ([(n, float(arb(c))) for n, c in f.coefficients.items()] for f in both)
    weights = [float(a.ball()) - 1 for a in reals(*alphas)]

    def rates(_, y):
        at = [float(e) * np.exp(w * y[0]) for e, w in zip(epsilons, weights)]
        P, W = (sum(c * np.prod([d**k for d, k in zip(at, n)]) for n, c in f) for f in (p, Omega))
        return [-P / (1 + W), 1 / (1 + W) - 1]

    grid = np.arange(count + 1) * np.pi
    y = solve_ivp(rates, (0, grid[-1]), [0.0, 0.0], method="DOP853", rtol=1e-12, atol=1e-14, t_eval=grid).y
    return np.exp(y[0]), y[1]


# Exponents, strengths, order; the parts of the bounds of amplitude and time that are attained after one half-swing.
CASES = [
    (("1/2",), ("0.03",), 1, 0.99, 0.99),
    (("1/2",), ("0.04",), 3, 0.99, 0.99),
    (("3/4",), ("0.05",), 2, 0.97, 0.99),
    (("0", "1"), ("0.02", "0.02"), 1, 0.38, 0.24),
    (("2",), ("0.05",), 1, 0.75, 0.85),
    (("1/2", "2"), ("0.01", "0.03"), 1, 0.7, 0.7),
]


@pytest.mark.parametrize(("alphas", "epsilons", "order", "share_A", "share_tau"), CASES)
def test_the_bounds_hold_and_half_of_them_would_not(alphas, epsilons, order, share_A, share_tau):
    steps = list(islice(turning_sequence_bounds(reals(*alphas), order, [arb(e) for e in epsilons]), 20))
    count = len(steps) - 1
    assert count > 2
    exact = turning_points(Law(dict(zip(alphas, epsilons))), count + 1, 20, times=True).points
    A, lag = truncated(alphas, order, epsilons, count)
    shares = []
    for step, point, near, late in list(zip(steps, exact, A, lag))[1:]:
        assert abs(float(step.A) - near) < 1e-8 + 2 * float(step.A.rad())
        assert abs(float(step.tau - arb.pi() * step.n) - late) < 1e-6 + 2 * float(step.tau.rad())
        errors = np.abs([abs(float(point.x)) - near, float(arb(point.tau) - arb.pi() * step.n) - late])
        shares.append(errors / [float(step.amplitude), float(step.time)])
        assert (shares[-1] < 1).all(), step
    assert (shares[0] > [share_A, share_tau]).all()
    assert (shares[-1] > [share_A / 4, share_tau / 4]).all()
    assert min(share_A, share_tau) > 0.5 or len(alphas) > 1


def test_it_ends_where_the_local_strength_leaves_the_range():
    steps = list(turning_sequence_bounds(reals("1/2"), 3, [arb(1) / 20]))
    assert len(steps) == 16
    assert steps[0].amplitude == 0
    with pytest.raises(LimitError, match="out of range"):
        next(turning_sequence_bounds(reals("1/2"), 3, [arb(1)]))


def test_where_both_theorems_hold_they_agree():
    quadratic, epsilon = reals("2"), [arb(1) / 20]
    every, followed = (
        turning_bounds(quadratic, 2, epsilon),
        list(islice(turning_sequence_bounds(quadratic, 2, epsilon), 11)),
    )
    relative = float(followed[10].amplitude / followed[10].A)
    assert float(every.log_amplitude(10)) < relative < 2 * float(every.log_amplitude(10))


HERE = TurningPointBound(4, arb("0.9"), arb(12), arb("0.01"), arb("0.00001"), arb(0))


@pytest.mark.parametrize(("alpha", "epsilon", "order"), [("1/2", "0.04", 3), ("3", "0.04", 2)])
def test_a_half_swing_adds_what_the_theorem_says(alpha, epsilon, order):
    """From an amplitude off by a hundredth: every part of the three bounds, in doubles."""
    steps = _Steps(local_bounds(reals(alpha), order), [arb(epsilon)])
    known, w = steps.local, abs(float(Fraction(alpha)) - 1)
    with ctx.workprec(128):
        there = steps.after(HERE)
        log = there.A.log() - HERE.A.log()
    delta = float(arb(epsilon)) * 0.9 ** (float(Fraction(alpha)) - 1)
    h = -w * np.log(1 - 0.01 / 0.9)
    amplitude = 0.01 + float(there.A) * np.expm1(float(known.amplitude(arb(delta))))
    time = 0.00001 + float(known.duration(arb(delta))) + float(steps.B) * h * (delta * np.exp(h)) ** 2
    assert float(there.amplitude) == pytest.approx(amplitude, rel=1e-9, abs=0)
    assert float(there.time) == pytest.approx(time, rel=1e-7, abs=0)
    assert float(there.phase) == pytest.approx(time * (1 + float(steps.Omega)), rel=1e-7, abs=0)
    assert float(steps.Omega) > 0 and float(steps.B) * h * delta**2 > 1e-3 * time
    for ball, f, remainder in ((log, steps.map.L, known.amplitude), (there.tau, steps.map.T, known.duration)):
        beyond = float(remainder.beyond(arb(delta), f.order + 1))
        assert beyond < float(ball.rad()) < 1.2 * beyond + 1e-30


def test_the_range_is_that_of_both_orbits():
    """Where an amplitude that is off by a tenth would have its local strength out of range, nothing more is claimed."""
    known = local_bounds(reals("1/2"), 2)
    for epsilon, error, goes_on in (("0.95", "0.01", True), ("0.95", "0.2", False), ("0.95", "1.1", False)):
        steps = _Steps(known, [known.limit * arb(epsilon)])
        here = TurningPointBound(1, arb(1), arb(3), arb(error), arb(0), arb(0))
        assert (steps.after(here) is not None) is goes_on
