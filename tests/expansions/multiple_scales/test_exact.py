"""The recurrence on Fourier coefficients: against the engine, closed forms and the equation of motion."""

import pytest
from flint import fmpq

from asymptotics.errors import InputError, LimitError
from asymptotics.expansions.multiple_scales.exact import odd_hierarchy
from asymptotics.expansions.normal_form.expansion import exact_expansion
from paper_checks.verdict import Outcome
from tests.second_route.multiscale_residual import (
    equation_residual,
    residual,
    residual_order,
    with_amplitude_coefficient,
)

LAWS = [((1,), 6), ((3,), 6), ((5,), 6), ((3,), 12), ((1, 3), 5), ((3, 5), 4), ((7, 1, 3), 3)]


@pytest.mark.parametrize(("alphas", "order"), LAWS)
def test_flow_is_the_engines_in_the_same_gauge(alphas, order):
    solved = odd_hierarchy(alphas, order)
    engine = exact_expansion(alphas, order, "no-first-harmonic")
    assert (engine.p - solved.p).coefficients == {}
    assert (engine.Omega - solved.Omega).coefficients == {}
    other = exact_expansion(alphas, order, "averaging")
    assert (other.Omega - solved.Omega).coefficients != {} or alphas == (1,)


@pytest.mark.parametrize(("alphas", "order"), LAWS)
def test_residual_is_exactly_zero(alphas, order):
    solved = odd_hierarchy(alphas, order)
    assert equation_residual(solved) is Outcome.CONFIRMED
    assert residual_order(solved) == order + 1


def test_linear_damping_is_the_exact_solution():
    # x = a cos psi with a = exp(-eps tau/2), psi = sqrt(1 - eps^2/4) tau: no harmonic at all
    solved = odd_hierarchy((1,), 8)
    assert dict(solved.p.coefficients) == {(1,): fmpq(1, 2)}
    assert [solved.Omega[n] for n in (2, 4, 6)] == [fmpq(-1, 8), fmpq(-1, 128), fmpq(-1, 1024)]
    assert all(solved.harmonics((n,)) == {} for n in range(1, 9))


def test_commuting_derivatives_are_refuted():
    solved = odd_hierarchy((3,), 4)
    assert solved.p[3] == fmpq(351, 8192)
    wrong = with_amplitude_coefficient(solved, (3,), fmpq(567, 8192))
    assert equation_residual(wrong) is Outcome.REFUTED
    assert residual_order(wrong) == 3
    # D^2 acts on a cos psi: 2 (567 - 351)/8192 sin psi
    assert residual(wrong)[(3,)] == {1: fmpq(27, 512)}
    assert residual(with_amplitude_coefficient(solved, (3,), fmpq(351, 8192))) == {}


def test_harmonics_have_the_parity_of_the_order_and_no_first():
    solved = odd_hierarchy((3,), 5)
    for n in range(1, 6):
        found = solved.harmonics((n,))
        assert 1 not in found
        assert max(found) == 2 * n + 1
    assert solved.right_side((1,)) == {1: fmpq(3, 4), 3: fmpq(-1, 4)}  # a^3 sin^3 psi


@pytest.mark.parametrize("alphas", [(), (2,), (-1,), (3, 0), (1.0,), ("3",)])
def test_other_exponents_are_refused(alphas):
    with pytest.raises(InputError, match="alpha"):
        odd_hierarchy(alphas, 2)


@pytest.mark.parametrize("order", [0, -1, 2.5])
def test_other_orders_are_refused(order):
    with pytest.raises(InputError, match="order"):
        odd_hierarchy((3,), order)


def test_too_much_work_is_refused_before_it_begins():
    with pytest.raises(LimitError, match="would take about"):
        odd_hierarchy((3,), 10**4)
