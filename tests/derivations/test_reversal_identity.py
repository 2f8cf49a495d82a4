"""The reversal identity on half-swings integrated directly, theta from 0 to pi (derivation reversal-identity)."""

import pytest
import sympy

from asymptotics.expansions.half_swings.formal_solution import FormalSolution
from asymptotics.expansions.half_swings.grading import Grading
from asymptotics.expansions.half_swings.theta_algebra import COSINE, SINE, THETA, ThetaTrig, sine_power

LAWS = {(0,): 5, (1,): 4, (2,): 4, (3,): 3, (1, 2): 3}
"""Exponents -> order through which the identity is checked."""


def flight(alphas, order):
    """R, T_q (theta = pi/2) and L, T (theta = pi) of one and the same orbit."""
    powers = tuple(sine_power(a) for a in alphas)
    grading, keys = Grading.of(alphas), (tuple(int(i == j) for j in range(len(alphas))) for i in range(len(alphas)))
    orbit = FormalSolution.solve(grading, order, list(zip(keys, powers)), COSINE, lambda m: -(SINE * m).integral())
    log_r = orbit.series(orbit.log_r, lambda f: f)
    time = orbit.series(orbit.m, lambda m: (COSINE * m).integral()) + THETA
    return tuple(f.map(at) for at in (ThetaTrig.at_quarter, ThetaTrig.at_half) for f in (log_r, time))


def defects(alphas, swing, sign=-1):
    """L - R(delta) + R(-F) and T - T_q(delta) - T_q(-F), F_i = delta_i exp((alpha_i-1) L)."""
    R, T_q, L, T = swing
    lower = L.truncate(L.order - 1)
    images = tuple(((lower * (a - 1)).exp() * sign).shift(i) for i, a in enumerate(alphas))
    return L - R + R.compose(images), T - T_q - T_q.compose(images)


@pytest.mark.parametrize("alphas", LAWS, ids=str)
def test_the_half_swing_is_the_quarter_swing_and_its_reverse(alphas):
    swing = flight(alphas, LAWS[alphas])
    off_log, off_time = defects(alphas, swing)
    assert all(c == 0 for part in (off_log, off_time) for c in part.coefficients.values())
    near_miss, _ = defects(alphas, swing, 1)  # +F in the place of -F
    assert any(c != 0 for c in near_miss.coefficients.values())


def test_the_quarter_period_of_linear_loss():
    e = sympy.Symbol("epsilon", positive=True)
    root = sympy.sqrt(4 - e**2)
    closed = sympy.series(2 / root * (sympy.pi / 2 + sympy.atan(e / root)), e, 0, 4).removeO()
    T_q = flight((1,), 4)[1]
    assert all(sympy.simplify(T_q[n].to_sympy() - closed.coeff(e, n)) == 0 for n in range(4))
