import pytest
import sympy
from flint import arb, ctx, fmpq

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.exact import exact_half_swing
from asymptotics.expansions.half_swings.symbolic import I_4, alpha, nested_integral_exact
from asymptotics.expansions.moments.symbolic import moment
from asymptotics.expansions.normal_form.closed_forms import symbolic_coefficients
from asymptotics.expansions.normal_form.expansion import exact_expansion
from asymptotics.expansions.normal_form.flow import flow_of
from asymptotics.expansions.normal_form.in_moments import second_order_sum
from asymptotics.expansions.normal_form.symbolic import omega_2, symbolic_expansion
from asymptotics.gauges import GAUGES
from tests.each import each
from tests.second_route.closed_forms import certified_coefficients, derived_coefficient


@pytest.mark.parametrize(("name", "k"), [("U", 1), ("U", 3), ("W", 2), ("W", 4)])
def test_closed_forms_are_what_the_half_swing_gives(name, k):
    """As rational functions of alpha, pi, the moments and I_4, treated as independent."""
    stated = symbolic_expansion()[name][k]
    assert sympy.cancel(sympy.together(derived_coefficient(name, k) - stated)) == 0


@pytest.mark.parametrize("n", range(7))
def test_symbolic_against_exact_at_integers(n):
    expansion, exact = symbolic_expansion(), exact_expansion((n,), 4)
    value = nested_integral_exact(n).to_sympy()
    for found, series in ((expansion["p"], exact.p), (expansion["Omega"], exact.Omega)):
        for k, closed in found.items():
            c = series[k]
            at_n = closed.subs(I_4(alpha), value).subs(alpha, n)
            assert sympy.simplify(at_n - (c if isinstance(c, int) else c.to_sympy())) == 0


@pytest.mark.parametrize("n", range(5))
def test_certified_closed_forms_enclose_the_exact_ones(n):
    exact = exact_expansion((n,), 4)
    with ctx.workprec(200):
        found = certified_coefficients(arb(n))
        for name, series in (("p", exact.p), ("Omega", exact.Omega)):
            for k, ball in found[name].items():
                c = series[k]
                truth = arb(0) if isinstance(c, int) else c.ball()
                assert ball.overlaps(truth) and ball.rad() < arb(10) ** -40
                assert not ball.overlaps(truth + arb(10) ** -20)


@each("n", range(7))
@each("gauge", GAUGES)
def test_omega_2_in_each_gauge(n, gauge):
    c = exact_expansion((n,), 2, gauge).Omega[2]
    assert sympy.simplify(omega_2(gauge).subs(alpha, n) - (c if isinstance(c, int) else c.to_sympy())) == 0


@pytest.mark.parametrize("alphas", [(0, 2), (1, 2), (1, 3), (0, 1, 2)])
def test_second_order_of_sums(alphas):
    W = flow_of(exact_half_swing(alphas, 2)).W
    for key, closed in second_order_sum(alphas, moment).items():
        c = W[key]
        assert sympy.simplify(closed - (c if isinstance(c, int) else c.to_sympy())) == 0


def test_refusals():
    with pytest.raises(InputError):
        omega_2("energy")
    with pytest.raises(InputError):
        certified_coefficients(arb(fmpq(-1, 2)))


@pytest.mark.parametrize("order", [1, 2, 3, 4])
def test_each_symbolic_order_has_exactly_its_coefficients(order):
    # By parity p is odd and Omega, W are even in delta; the averaging gauge is known through second order only.
    found, full = symbolic_coefficients(order, "turning-point", 6), symbolic_expansion()
    odd, even = [k for k in (1, 3) if k <= order], [k for k in (2, 4) if k <= order]
    assert {k: c.expression for k, c in found.amplitude.items()} == {str(k): full["p"][k] for k in odd}
    assert {k: c.expression for k, c in found.frequency.items()} == {str(k): full["Omega"][k] for k in even}
    assert {k: c.expression for k, c in found.W.items()} == {str(k): full["W"][k] for k in even}
    assert list(found.integrals) == (["I_4"] if order == 4 else [])
    if order > 2:
        with pytest.raises(InputError, match="through order 2"):
            symbolic_coefficients(order, "averaging", 6)
    else:
        other = symbolic_coefficients(order, "averaging", 6)
        assert [c.expression for c in other.frequency.values()] == [omega_2("averaging")][: len(even)]
        assert not other.W
