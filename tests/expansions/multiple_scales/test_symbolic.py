"""The SymPy side: the displayed hierarchy is recomputed from its own words, residual and start included."""

from dataclasses import FrozenInstanceError

import pytest
from latex2mathml.converter import convert
from sympy import Rational, cos, diff, expand, expand_trig, series, simplify, sin

from asymptotics.expansions.multiple_scales.orders import a, epsilon, psi
from asymptotics.expansions.multiple_scales.symbolic import multiple_scales


@pytest.fixture(scope="module")
def cubic():
    return multiple_scales((3,), 3)


def vanishes(f):
    return simplify(expand(expand_trig(f)).subs(cos(psi) ** 2, 1 - sin(psi) ** 2)) == 0


def test_each_order_is_what_its_operators_say(cubic):
    X = [order.solution.rhs for order in cubic.orders]
    D = cubic.slow_derivative
    V = [sum(D(j, X[k - j]) for j in range(k + 1)) for k in range(3)]
    forces = [0, V[0] ** 3, 3 * V[0] ** 2 * V[1], 3 * V[0] ** 2 * V[2] + 3 * V[0] * V[1] ** 2]
    for n, order in enumerate(cubic.orders[1:], start=1):
        pairs = [(i, j) for i in range(n + 1) for j in range(n + 1 - i) if i + j]
        right = -sum(D(i, D(j, X[n - i - j])) for i, j in pairs) - forces[n]
        solved = order.equation.rhs.subs({e.lhs: e.rhs for e in order.solvability})
        assert vanishes(right - solved)
        assert vanishes(diff(X[n], psi, 2) + X[n] - solved)
        assert all(s.subs({e.lhs: e.rhs for e in order.solvability}) == 0 for _, s in order.conditions)


def test_residual_in_sympy(cubic):
    def total(f):
        return expand(cubic.amplitude_rate * diff(f, a) + cubic.phase_rate * diff(f, psi))

    velocity = total(cubic.waveform)
    residual = expand(total(velocity) + cubic.waveform + epsilon * velocity**3)
    assert all(vanishes(residual.coeff(epsilon, n)) for n in range(4))
    assert not vanishes(residual.coeff(epsilon, 4))


def test_initial_conditions_in_sympy(cubic):
    start = {a: cubic.initial_amplitude, psi: cubic.initial_phase}
    rate = cubic.amplitude_rate * diff(cubic.waveform, a) + cubic.phase_rate * diff(cubic.waveform, psi)
    assert series(cubic.waveform.subs(start), epsilon, 0, 4).removeO() == 1
    assert series(rate.subs(start), epsilon, 0, 4).removeO() == 0


def test_slow_derivatives_do_not_commute(cubic):
    # D_1 D_2 psi = (9/256)(4 a^3)(-3/8 a^3), D_2 D_1 psi = 0
    assert cubic.commutator(1, 2) == (0, -Rational(27, 512) * a**6)
    assert cubic.commutator(0, 1) == (0, 0)


def test_order_two_shows_everything(cubic):
    order = cubic.orders[2]
    names = [name for name, _ in order.lines]
    assert names[0] == "order 2"
    assert {"velocity", "equation", "solvability", "solution, no-first-harmonic"} <= set(names)
    assert "D_2 psi = g_2 = 9*a**4/256" in str(order)
    assert r"D_{1} D_{0} X_{1}" in order._repr_latex_()
    for part in (*cubic.orders, cubic):
        assert part._repr_latex_().startswith("$")
    for _, line in order.lines:
        assert convert(line).startswith("<math")


def test_orders_are_immutable(cubic):
    with pytest.raises(FrozenInstanceError):
        cubic.orders[1].n = 5
    with pytest.raises(FrozenInstanceError):
        cubic.kernel = None


def test_two_laws_contain_each_alone():
    both, cubic = multiple_scales((1, 3), 3), multiple_scales((3,), 3)
    first, second = (s for s in sorted(both.amplitude_rate.free_symbols - {a}, key=str))
    assert expand(both.amplitude_rate.subs(first, 0) - cubic.amplitude_rate.subs(epsilon, second)) == 0
    assert expand(both.waveform.subs(first, 0) - cubic.waveform.subs(epsilon, second)) == 0
    assert both.amplitude_rate.coeff(first, 1).coeff(second, 2) != 0
    assert both.gauge == "no-first-harmonic"


@pytest.mark.parametrize("order", [3, 6])
def test_waveform_and_initial_conditions_reach_the_order(order):
    result = multiple_scales((3,), order)
    assert result.waveform.coeff(epsilon, order) != 0
    assert result.initial_phase != 0
