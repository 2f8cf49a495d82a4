"""A symbolic exponent: rates held by name give the closed solution, and every letter is defined."""

import pytest
import sympy

import asymptotics as asy
from asymptotics.curves.solution import D, epsilon, tau
from asymptotics.envelopes.named_slow_time import named_slow_time, rate_letters
from asymptotics.expansions.half_swings.symbolic import alpha as symbolic_alpha
from asymptotics.expansions.multiple_scales.orders import a


@pytest.mark.parametrize("order", [4, 5, 7])
def test_rates_held_by_name_give_the_closed_solution(order):
    """Letters replaced by the exact rates of alpha = 2: the solution of that law; with one of them wrong it is not."""
    exact, (relative, phase) = asy.solution("2", order=order), named_slow_time(symbolic_alpha, order)
    values = {symbolic_alpha: 2}
    for letters, side in zip(rate_letters(order), (0, 1)):
        for n, letter in letters.items():
            values[letter] = exact.scales.rates[n][side].subs(a, 1) * (1 if side else -1)
    assert sympy.expand(relative.subs(values) - exact.relative) == 0
    assert sympy.expand(phase.subs(values) - exact.slow_phase) == 0
    third = next(letter for letter in values if str(letter) == "p_3")
    assert sympy.expand(relative.subs(values | {third: values[third] * 2}) - exact.relative) != 0


def test_every_letter_of_a_symbolic_exponent_is_defined():
    found = asy.solution("symbolic", order=5)
    told = found.to_dict()["where"]
    letters = (found.amplitude.free_symbols | found.phase.free_symbols) - {tau, epsilon, symbolic_alpha}
    assert letters and all(any(line.startswith(f"{letter} = ") for line in told) for letter in letters)
    assert any(line.startswith("p_5 = -a**(") and "f_5" in line for line in told)
    assert any(line.startswith("f_5 = Integral(") for line in told)


@pytest.mark.slow
def test_a_symbolic_exponent_reaches_order_twelve():
    """No rate is expanded: the whole of order 12 in a few seconds, and still x(0) = 1."""
    found = asy.solution("symbolic", order=12)
    assert sympy.expand(found.relative.subs(D, 1)) == 1 and sympy.expand(found.slow_phase.subs(D, 1)) == 0
