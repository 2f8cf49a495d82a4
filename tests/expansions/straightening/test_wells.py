"""Straightened losses against the springs they came from, and the first order of the pendulum against integration."""

import numpy as np
import pytest
from flint import acb, arb, fmpq
from scipy.integrate import solve_ivp

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.exact import exact_half_swing
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.straightening import wells
from asymptotics.expansions.straightening.wells import Loss, Well
from asymptotics.numbers.precision import TooWideError
from asymptotics.terms import Term
from tests.second_route.straightened import coordinate, slope, straighten

PENDULUM = Term(1, 0, 3, "position", "pendulum")
DUFFING, QUINTIC = Term(1, 0, 3, "position"), Term(1, 0, 5, "position")
ORDER = 5


def relabelled(forces, straight):
    """L in the amplitude A, written in xi, minus the L of the straightened losses: both at the strengths of A."""
    grading = forces.exact_grading()
    log = (forces.potential(ORDER)).log() / 2  # ln(xi_A/A)
    original = exact_half_swing(forces, ORDER)
    L = original.L + log.compose(original.F) - log
    return L - exact_half_swing(straight, ORDER).L.compose(grading.strengths(log))


@pytest.mark.parametrize(
    "terms",
    [[Term(1, 2), PENDULUM], [Term(1, 1), DUFFING], [Term(1, 0, 2), DUFFING], [Term(1, 2, 2), QUINTIC],
     [Term(1, 1), Term(1, 0, 2, "position")]],
)  # fmt: skip
def test_turning_amplitudes_know_the_straightened_loss_only(terms):
    forces, straight = Forces.read(terms, ORDER), straighten(terms, ORDER)
    assert all(c == 0 for c in relabelled(forces, straight).coefficients.values())
    plain = Forces.read([terms[0], DUFFING], ORDER)  # near miss: the loss without its factor x'(xi)
    assert not all(c == 0 for c in relabelled(forces, Forces(plain.weights, plain.signs, plain.velocities,
                                                             plain.members[:1])).coefficients.values())  # fmt: skip


def test_the_clock_of_the_pendulum_is_a_binomial_series():
    assert [slope([PENDULUM], 6)[n] for n in range(4)] == [1, fmpq(1, 8), fmpq(3, 128), fmpq(5, 1024)]
    assert coordinate([DUFFING], 2).coefficients == {(0,): 1, (1,): fmpq(-1, 4), (2,): fmpq(7, 32)}


def test_a_velocity_dependent_spring_has_no_potential():
    with pytest.raises(InputError, match="potential"):
        straighten([Term(1, 1), Term(1, 2, 1, "position")], 3)


def test_the_error_is_of_second_order_in_the_loss():
    well, errors = Well.pendulum(arb(1)), []
    first = float((arb.pi() * well.loss(Loss(arb(1), arb("1.5")), -well.xi(arb(2)).log())).mid())
    for eps in (0.02, 0.01):

        def stop(t, y):
            return y[1]

        stop.terminal, stop.direction = True, 1
        run = solve_ivp(lambda t, y, e=eps: [y[1], -np.sin(y[0]) - e * y[1] * abs(y[1]) ** 0.5], (0, 40), [2.0, -1e-13],
                        events=stop, rtol=1e-12, atol=1e-14)  # fmt: skip
        found = np.log(np.sin(-run.y[0, -1] / 2) / np.sin(1.0))
        errors.append(abs(found + eps * first))
    assert 3.4 < errors[0] / errors[1] < 4.6


@pytest.mark.parametrize("place", ["-1", "4", "0"])
@pytest.mark.parametrize("well", [Well.pendulum(arb(1)), Well.duffing(arb(-1) / 9)])
def test_a_place_that_is_not_certainly_in_the_well_has_no_coordinate(well, place):
    assert well.xi(arb("0.5")) > 0
    with pytest.raises(InputError, match="not certainly inside"):
        well.xi(arb(place))


@pytest.mark.parametrize("A", [arb(0, 1e-9), arb(1, 1e-9)])
def test_a_place_that_may_be_in_the_well_is_too_wide(A):
    """x - x^3 has its tops at -1 and 1: a ball about 0, and one about a top."""
    with pytest.raises(TooWideError, match="not certainly inside"):
        Well.duffing(arb(-1)).xi(A)


def test_the_integrator_is_told_where_a_ball_may_meet_the_cut():
    """2F1 jumps across [1, infinity): a finite value there would be integrated as if it were analytic."""
    half, across = arb(1) / 2, acb(arb(2, 0.25), arb(0, 0.25))
    beside = across + acb(0, 1)
    assert not wells._hypergeometric(half, half, arb(1), across, True).is_finite()
    assert wells._hypergeometric(half, half, arb(1), across, False).is_finite()
    assert wells._hypergeometric(half, half, arb(1), beside, True).is_finite()
