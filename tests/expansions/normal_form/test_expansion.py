from math import exp, prod

import pytest
import sympy
from flint import arb

from asymptotics.errors import InputError, LimitError
from asymptotics.expansions.half_swings.exact import exact_half_swing
from asymptotics.expansions.normal_form.expansion import exact_expansion
from asymptotics.expansions.normal_form.show import sum_latex, sum_text
from asymptotics.gauges import GAUGES
from asymptotics.numbers.value import Coefficient
from asymptotics.terms import Term
from paper_checks.report.growth import growth_ratios
from paper_checks.report.verification import (
    equation_residual,
    exact_reference,
    map_residual,
    numerical_half_swing,
    residual_order,
    verify,
)
from paper_checks.verdict import Outcome
from tests.second_route.gauge_observables import observables


@pytest.mark.parametrize("gauge", GAUGES)
@pytest.mark.parametrize(("alphas", "order"), [((0,), 3), ((1,), 3), ((2,), 4), ((3,), 4), ((0, 1), 3)])
def test_verify_confirms_and_measures_the_order(gauge, alphas, order):
    expansion = exact_expansion(alphas, order, gauge)
    found = verify(expansion, exact_reference(alphas, order))
    assert found.residual is Outcome.CONFIRMED and found.residual_order == order + 1 and found.exact
    assert found.measured_order == pytest.approx(order + 1, abs=0.35)


def test_verify_refutes_a_wrong_coefficient():
    """Maxima: -567/8192 beside a no-first-harmonic waveform; here a flow of one gauge under the map of another."""
    right, other = exact_expansion((3,), 3, "no-first-harmonic"), exact_expansion((3,), 3, "averaging")
    wrong = type(right)(right.gauge, right.arithmetic, right.order, other.flow, right.half, right.gauge_map)
    found = verify(wrong)
    assert found.residual is Outcome.REFUTED and found.residual_order == 2
    assert found.measured_order < 2.5


@pytest.mark.parametrize("gauge", GAUGES)
@pytest.mark.parametrize(("alphas", "order"), [((3,), 8), ((1,), 5), ((1, 3), 4), ((5,), 4)])
def test_residual_in_the_equation_of_motion_vanishes(gauge, alphas, order):
    assert equation_residual(alphas, order, gauge) is Outcome.CONFIRMED


@pytest.mark.parametrize("gauge", GAUGES)
def test_residual_of_polynomials_in_x_and_v_vanishes(gauge):
    van_der_pol = [Term(-1, 1), Term(-1, 1, 2)]
    assert equation_residual(van_der_pol, 4, gauge) is Outcome.CONFIRMED
    assert equation_residual([Term(-1, 3, 2), Term(1, 0, 3, "position")], 3, gauge) is Outcome.CONFIRMED


@pytest.mark.parametrize("alpha", [1, 3])
def test_a_named_spring_is_read_through_the_order(alpha):
    forces = [Term(1, alpha), Term(1, 0, 3, "position", "pendulum")]
    assert all(equation_residual(forces, 5, gauge) is Outcome.CONFIRMED for gauge in GAUGES)
    half, deltas = exact_half_swing(forces, 5), (0.02, 0.03)
    found = numerical_half_swing(forces, deltas)
    assert found == pytest.approx([_value(s, *deltas) for s in (half.L, half.T)], abs=1e-8)
    plain = [Term(1, alpha), Term(1, 0, 3, "position")]  # its x^5 is felt
    assert numerical_half_swing(plain, deltas)[1] != pytest.approx(_value(half.T, *deltas), abs=1e-6)


def test_reference_of_another_law_is_refuted():
    expansion = exact_expansion((2,), 3)
    assert map_residual(expansion, exact_half_swing((4,), 3)) is Outcome.REFUTED
    assert residual_order(expansion, exact_half_swing((4,), 3)) == 1


def test_results_carry_gauge_arithmetic_and_order():
    text = str(exact_expansion((0, 2), 2, "averaging"))
    assert "averaging" in text and "exact" in text and "order 2" in text


@pytest.mark.parametrize(
    ("alphas", "order", "gauge", "kind"),
    [
        ((2,), 0, "averaging", InputError),
        ((2,), 5, "energy", InputError),
        ((2,), 10**6, "turning-point", InputError),
        ((2,), 900, "turning-point", LimitError),
        ((0, 1, 2, 3), 40, "averaging", LimitError),
        ((-1,), 3, "turning-point", InputError),
    ],
)
def test_bad_requests_are_refused(alphas, order, gauge, kind):
    with pytest.raises(kind):
        exact_expansion(alphas, order, gauge)


def test_observables_against_a_numerical_half_swing():
    seen, delta = observables(exact_expansion((2,), 14)), 0.1
    L, T = numerical_half_swing([2.0], [delta])
    values = [_value(s, delta) for s in (seen.amplitude_ratio, seen.half_period, seen.energy_loss)]
    assert values == pytest.approx([exp(L), T, 1 - exp(2 * L)], abs=1e-8)
    following, _ = numerical_half_swing([2.0], [delta * exp(L)])
    assert _value(seen.log_decrement, delta) == pytest.approx(-L - following, abs=1e-8)


def _value(series, *deltas):
    total = 0.0
    for key, c in series.coefficients.items():
        total += float((c.ball() if hasattr(c, "ball") else arb(c)).mid()) * prod(map(pow, deltas, key))
    return total


def test_a_sum_is_written_as_by_hand():
    row = {(n,): Coefficient(str(c), sympy.Rational(c)) for n, c in ((1, -1), (2, "-1/100"), (3, 1), (4, 0))}
    assert sum_text(row, ("d",)) == "-d - 1/100 d^2 + d^3" and sum_text({}, ("d",)) == "0"
    assert sum_latex(row, ("d",)) == r"-d - \frac{1}{100} d^{2} + d^{3}"
    mixed = {(1, 1): Coefficient("1.5e-7", None), (2, 0): Coefficient("2", sympy.Integer(2))}
    assert sum_latex(mixed, ("a", "b"), "1") == r"1 + 2 a^{2} + 1.5 \cdot 10^{-7} a b"


@pytest.mark.parametrize("alpha", [2, 3])
def test_large_orders_follow_the_prediction(alpha):
    """V_(k+2)/V_k against -k^2 (|alpha-1| p_1/2)^2: the quotient tends to 1 like 1 - 3/k, as (k-1)(k-2)/k^2 does."""
    ratios = growth_ratios(exact_expansion((alpha,), 41))
    k, ratio = ratios[-1]
    assert abs(ratio - (k - 1) * (k - 2) / k**2) < 10 / k**2
    assert abs(ratio - 1) < 0.1 < abs(ratios[3][1] - 1)


@pytest.mark.parametrize("alphas", [(0,), (1,), (2, 3)])
def test_large_orders_refuse_what_does_not_diverge(alphas):
    with pytest.raises(InputError):
        growth_ratios(exact_expansion(alphas, 4))
