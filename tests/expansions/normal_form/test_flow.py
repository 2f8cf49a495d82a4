import pytest
from flint import arb, fmpq
from sympy import coth, pi, series, sqrt, symbols

from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.exact import exact_half_swing
from asymptotics.expansions.half_swings.fourier_flow import fourier_flow
from asymptotics.expansions.half_swings.grading import Grading
from asymptotics.expansions.half_swings.pi_ring import PI
from asymptotics.expansions.normal_form.flow import flow_of
from asymptotics.series import Series


def test_coulomb():
    flow = flow_of(exact_half_swing((0,), 12))
    assert flow.V[0].coefficients == {(2,): 2 / PI} and flow.W.coefficients == {(0,): 1}


def test_linear():
    # U = -(d/2)(1 - d^2/4)^(-1/2), W = (1 - d^2/4)^(-1/2): coefficients binomial(2k, k)/16^k
    flow = flow_of(exact_half_swing((1,), 9))
    expected = [fmpq(1), fmpq(1, 8), fmpq(3, 128), fmpq(5, 1024), fmpq(35, 32768)]
    assert [flow.W[2 * k].as_rational() if k else 1 for k in range(5)] == expected
    assert [flow.U[2 * k + 1].as_rational() for k in range(5)] == [-e / 2 for e in expected]
    assert flow.V[0].coefficients == {}


def test_coulomb_with_linear():
    """U = -mu (1 + delta_0 coth(pi mu/2)), W = (1 - d^2/4)^(-1/2), mu = (d/2) W, d = delta_1."""
    order, d = 9, symbols("d")
    flow = flow_of(exact_half_swing((0, 1), order))
    mu = d / 2 / sqrt(1 - d**2 / 4)
    linear = series(-mu, d, 0, order + 1).removeO()
    mixed = series(-mu * coth(pi * mu / 2), d, 0, order).removeO()
    for k in range(order + 1):
        assert _sympy(flow.U, (0, k)) == linear.coeff(d, k)
        if k < order:
            assert (_sympy(flow.U, (1, k)) - mixed.coeff(d, k)).expand() == 0
        assert _sympy(flow.W, (0, k)) == series(1 / sqrt(1 - d**2 / 4), d, 0, order + 1).removeO().coeff(d, k)
    assert all(i <= 1 for i, _ in flow.U.coefficients) and all(i == 0 for i, _ in flow.W.coefficients)


def _sympy(found, key):
    c = found.coefficients.get(key, 0)
    return c if isinstance(c, int) else c.to_sympy()


@pytest.mark.parametrize(("alphas", "order"), [((3,), 9), ((5,), 6), ((1, 3), 5), ((1, 3, 5), 3)])
def test_log_of_the_map_is_the_fourier_flow(alphas, order):
    flow, direct = flow_of(exact_half_swing(alphas, order)), fourier_flow(alphas, order)
    assert (flow.U - direct.U).coefficients == {} and (flow.W - direct.W).coefficients == {}


@pytest.mark.parametrize("alphas", [(2,), (4,), (0, 2), (1, 2)])
def test_exp_of_the_flow_is_the_map(alphas):
    half = exact_half_swing(alphas, 6)
    again = flow_of(half).half_swing(PI)
    assert (again.L - half.L).coefficients == {} and (again.T - half.T).coefficients == {}


def test_parity_is_checked_not_assumed():
    half = exact_half_swing((2,), 4)
    spoiled = type(half)(half.grading, half.L + Series({(2,): fmpq(1)}, 1, 4), half.F, half.T)
    with pytest.raises(UndecidedError):
        flow_of(spoiled)
    assert Grading.of((2,)).of_parity(Series({(1,): arb(1), (2,): arb(0, 1)}, 1, 2), 1).coefficients.keys() == {(1,)}
