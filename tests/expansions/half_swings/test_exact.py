import pytest
from flint import arb, ctx, fmpq

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.exact import (
    even_half_swing,
    exact_half_swing,
    exact_quarter_swing,
    odd_half_swing,
)
from asymptotics.expansions.half_swings.grading import Grading
from asymptotics.expansions.half_swings.pi_ring import PI
from asymptotics.expansions.half_swings.quarter import half_swing
from paper_checks.report.verification import numerical_half_swing


@pytest.mark.parametrize(
    ("alphas", "order"), [((0,), 6), ((2,), 6), ((4,), 4), ((1,), 6), ((3,), 6), ((5,), 4), ((0, 2), 4), ((1, 3), 4)]
)
def test_two_algebras_agree(alphas, order):
    """Polynomials in c, or the Fourier flow, against polynomials in theta with the reversal identity."""
    direct, reversed_twice = exact_half_swing(alphas, order), half_swing(exact_quarter_swing(alphas, order))
    assert (direct.L - reversed_twice.L).coefficients == {}
    assert (direct.T - reversed_twice.T).coefficients == {}
    other = exact_half_swing(tuple(a + 2 for a in alphas), order)
    assert (direct.L - other.L).coefficients != {}


@pytest.mark.parametrize("alphas", [(0,), (2,), (3,), (0, 1), (1, 2)])
def test_the_map_is_reversible(alphas):
    """F^-1(delta) = -F(-delta)."""
    half = exact_half_swing(alphas, 5)
    back = half.grading.reversed(half.grading.flip(f) for f in half.F)
    for i, f in enumerate(half.F):
        identity = f.compose(back)
        assert identity.coefficients == {tuple(int(j == i) for j in range(len(alphas))): 1}


def test_coulomb_is_exact():
    # amplitude falls by 2 delta each half-swing: L = ln(1 - 2 delta), T = pi
    half = exact_half_swing((0,), 8)
    assert [half.L[n].as_rational() for n in range(1, 9)] == [-fmpq(2**n, n) for n in range(1, 9)]
    assert half.T.coefficients == {(0,): PI}


def test_linear_is_exact():
    # T = pi/sqrt(1 - d^2/4) and L = -(d/2) T
    half = exact_half_swing((1,), 7)
    assert half.T[2] == PI / 8 and half.T[4] == PI * fmpq(3, 128) and half.T[6] == PI * fmpq(5, 1024)
    assert all(half.L[n + 1] == -half.T[n] / 2 for n in range(0, 7, 2))
    assert half.F[0].coefficients == {(1,): 1}


def test_quadratic_map_is_lambert():
    # Smith's turning points: with y = 1 + 2 u_n and w = 1 - 2 u_(n+1), w e^(-w) = y e^(-y), that is
    # ln(1 - 2 F) + 2 F = ln(1 + 2 delta) - 2 delta
    F = exact_half_swing((2,), 9).F[0]
    delta = F * 0 + F.variable(0, 1, 9, fmpq(1))
    assert ((1 - F * 2).log() + F * 2 - (1 + delta * 2).log() + delta * 2).coefficients == {}


@pytest.mark.parametrize(
    ("alphas", "deltas"), [((0,), (0.05,)), ((3,), (0.1,)), ((4,), (0.08,)), ((1, 2), (0.05, 0.08))]
)
def test_against_numerical_integration(alphas, deltas):
    half = exact_half_swing(alphas, 8)
    L, T = numerical_half_swing(alphas, deltas)
    values = tuple(arb(d) for d in deltas)
    ours = [float(s.map(lambda x: (x * PI / PI).ball()).at(values).mid()) for s in (half.L, half.T)]
    assert ours == pytest.approx([L, T], abs=2e-6) and ours != pytest.approx([L, T * 1.001], abs=2e-6)


@pytest.mark.parametrize("alpha", [2, 3])
def test_forty_orders_begin_with_the_first_five(alpha):
    long, short = exact_half_swing((alpha,), 40), exact_half_swing((alpha,), 5)
    assert long.L[40] != 0
    assert (long.L.truncate(5) - short.L).coefficients == {}


def test_routes_refuse_nothing_silently():
    for bad in ((-1,), (fmpq(3, 2),)):
        with pytest.raises(InputError):
            exact_half_swing(bad, 3)
    assert even_half_swing((2,), 2).L == exact_half_swing((2,), 2).L
    assert odd_half_swing((3,), 2).T == exact_half_swing((3,), 2).T


def test_ball_pipeline_contains_the_exact_one():
    """The generic reversal identity in balls encloses the rational result."""
    quarter = exact_quarter_swing((3,), 6)
    with ctx.workprec(200):
        R, T_q = (s.map(lambda x: x.ball()) for s in (quarter.R, quarter.T_q))
        balls = type(quarter)(Grading.of((arb(3),)), R, T_q)
        half = half_swing(balls)
        exact = half_swing(quarter)
        for n in range(1, 7):
            assert half.L[n].overlaps(exact.L[n].ball()) and half.L[n].rad() < arb(10) ** -40
