"""Springs and position-dependent losses by the classical route: a second way to the flow, L and T of the engine."""

import pytest
from flint import fmpq
from sympy import Rational, cos, diff, expand, expand_trig, sin, symbols

import asymptotics as asy
from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.exact import exact_half_swing, exact_quarter_swing
from asymptotics.expansions.half_swings.quarter import half_swing
from asymptotics.expansions.multiple_scales import exact
from asymptotics.expansions.multiple_scales.exact import odd_hierarchy
from asymptotics.expansions.multiple_scales.initial import map_to_turning_points
from asymptotics.expansions.multiple_scales.orders import a, psi
from asymptotics.expansions.multiple_scales.symbolic import multiple_scales
from asymptotics.expansions.normal_form.expansion import exact_expansion
from asymptotics.gauges import GAUGES
from asymptotics.terms import Term
from paper_checks.verdict import Outcome
from tests.second_route.multiscale_observables import flow_in, half_swing_of
from tests.second_route.multiscale_residual import equation_residual, residual_order, with_amplitude_coefficient

DUFFING, QUINTIC, INERTIAL = (Term(1, q, p, "position") for q, p in ((0, 3), (0, 5), (2, 1)))
PENDULUM = Term(1, 0, 3, "position", "pendulum")
LINEAR, CUBIC, VAN_DER_POL = Term(1, 1), Term(1, 3), Term(1, 1, 2)
SUMS = {
    "Duffing": ([DUFFING], 8),
    "van der Pol": ([LINEAR, VAN_DER_POL], 6),
    "Rayleigh": ([LINEAR, CUBIC], 6),
    "Duffing with linear loss": ([LINEAR, DUFFING], 6),
    "Duffing with cubic loss": ([CUBIC, DUFFING], 6),
    "pendulum with linear loss": ([LINEAR, PENDULUM], 6),
    "pendulum with cubic loss": ([CUBIC, PENDULUM], 5),
    "x^2 x'^3, quintic, x x'^2": ([Term(1, 3, 2), QUINTIC, INERTIAL], 3),
}
each = pytest.mark.parametrize(("terms", "order"), SUMS.values(), ids=SUMS)


@each
def test_the_residual_of_the_equation_is_exactly_zero(terms, order):
    solved = odd_hierarchy(terms, order)
    assert equation_residual(solved) is Outcome.CONFIRMED
    assert residual_order(solved) == order + 1


@each
@pytest.mark.parametrize("gauge", GAUGES)
def test_the_flow_is_that_of_the_fourier_route_in_every_gauge(terms, order, gauge):
    found, engine = flow_in(odd_hierarchy(terms, order), gauge), exact_expansion(terms, order, gauge)
    assert (found.p - engine.p).coefficients == {}
    assert (found.Omega - engine.Omega).coefficients == {}


@each
def test_turning_amplitudes_and_half_periods_are_those_of_the_half_swing(terms, order):
    found, engine = half_swing_of(odd_hierarchy(terms, order)), exact_half_swing(terms, order)
    assert (found.L - engine.L).coefficients == {}
    assert (found.T - engine.T).coefficients == {}


def test_and_those_of_the_reversal_identity():
    found = half_swing_of(odd_hierarchy([CUBIC, DUFFING], 3))
    engine = half_swing(exact_quarter_swing([CUBIC, DUFFING], 3))
    assert (found.L - engine.L).coefficients == (found.T - engine.T).coefficients == {}


def test_the_start_is_the_bracket_of_the_gauge():
    own = map_to_turning_points(odd_hierarchy([LINEAR, DUFFING], 4)).inverse()
    engine = exact_expansion([LINEAR, DUFFING], 4, "no-first-harmonic").gauge_map
    assert (own.log_modulus - engine.log_modulus).coefficients == {}
    assert (own.argument - engine.argument).coefficients == {}


def test_textbook_values():
    duffing = odd_hierarchy([DUFFING], 3)
    assert [duffing.Omega[n] for n in (1, 2, 3)] == [fmpq(3, 8), fmpq(-15, 256), fmpq(123, 8192)]
    assert duffing.harmonics((1,)) == {3: fmpq(1, 32)}
    circling = odd_hierarchy([LINEAR, VAN_DER_POL], 2)  # -mu (1 - x^2) x': a = 2, omega = 1 - mu^2/16
    assert circling.p[1, 0] == 4 * circling.p[0, 1] == fmpq(1, 2)
    assert sum(c * (-1) ** k[0] * 2 ** (2 * k[1]) for k, c in circling.Omega.coefficients.items()) == fmpq(-1, 16)


def test_orders_of_both_parities_carry_both_rates():
    solved = odd_hierarchy([LINEAR, DUFFING], 4)
    assert {sum(k) for k in solved.p.coefficients} == {sum(k) for k in solved.Omega.coefficients} == {1, 2, 3, 4}
    assert all(k[0] % 2 == 1 for k in solved.p.coefficients)
    assert all(k[0] % 2 == 0 for k in solved.Omega.coefficients)


def test_a_spring_with_the_sign_of_a_loss_is_refuted(monkeypatch):
    right = odd_hierarchy([CUBIC, DUFFING], 3)
    monkeypatch.setattr(exact, "in_eta", lambda m: m.ratio * (-1) ** ((m.integer_velocity + 1) // 2 + (m.sign > 0)))
    wrong = odd_hierarchy([CUBIC, DUFFING], 3)
    monkeypatch.undo()
    assert equation_residual(right) is Outcome.CONFIRMED
    assert equation_residual(wrong) is Outcome.REFUTED
    assert wrong.Omega[0, 1] == -right.Omega[0, 1]


def test_parity_by_total_degree_is_refuted(monkeypatch):
    kind = type(odd_hierarchy([DUFFING], 1).forces)
    monkeypatch.setattr(kind, "loss_degree", lambda self, key: sum(key))
    wrong = odd_hierarchy([LINEAR, DUFFING], 2)
    assert equation_residual(wrong) is Outcome.REFUTED


def test_a_wrong_mixed_coefficient_is_seen_in_the_residual_and_in_the_turning_amplitudes():
    solved = odd_hierarchy([LINEAR, DUFFING], 3)
    wrong = with_amplitude_coefficient(solved, (1, 1), solved.p[1, 1] / 2)
    assert equation_residual(wrong) is Outcome.REFUTED
    assert (half_swing_of(wrong).L - exact_half_swing([LINEAR, DUFFING], 3).L)[1, 1] != 0


def test_the_displayed_waveform_solves_the_equation_in_sympy():
    found = multiple_scales([VAN_DER_POL, DUFFING], 2)
    loss, spring = found.symbols
    step = symbols("s")

    def total(f):
        return expand(found.amplitude_rate * diff(f, a) + found.phase_rate * diff(f, psi))

    X = found.waveform
    velocity = total(X)
    left = total(velocity) + X + loss * X**2 * velocity + spring * X**3
    whole = expand(left.subs({loss: step * loss, spring: step * spring}))
    for n in range(3):
        powers = expand(expand_trig(whole.coeff(step, n)))
        assert expand(powers.subs(cos(psi) ** 2, 1 - sin(psi) ** 2)).equals(0)


def test_each_order_is_what_its_operators_say():
    found = multiple_scales([LINEAR, DUFFING], 2)
    eps, c = found.symbols
    order = found.orders[2]
    assert str(order.hierarchy.rhs).count("X_0**2*X_1") == 1
    values = {e.lhs: e.rhs for e in order.solvability}
    assert all(expand(s.subs(values)) == 0 for _, s in order.conditions)
    assert found.rates[1] == (-a * eps / 2, Rational(3, 8) * a**2 * c)
    assert found.commutator(1, 2) != (0, 0)


def test_the_public_function_serves_a_spring():
    found = asy.multiple_scales({1: "1/10"}, spring={3: "1/10"}, order=4)
    assert len(found.orders) == 5 and found.kernel.p[1, 1] == fmpq(-3, 16)
    assert asy.multiple_scales(1, spring="pendulum").phase_rate.has(*found.orders[0].solution.rhs.free_symbols - {psi})
    assert asy.multiple_scales(asy.Oscillator({1: "1/10"}, spring={3: 1})).shapes == ("x'", "x^3")


def test_the_kernel_refuses_by_name_too():
    for bad, name in ((Term(1, 0, 2, "position"), "spring"), (Term(1, 1, 1), "law"), (Term(1, "3/2"), "alpha")):
        with pytest.raises(InputError, match=f"argument {name}"):
            odd_hierarchy([LINEAR, bad] if name != "alpha" else [bad], 2)
