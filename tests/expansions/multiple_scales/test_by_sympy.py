"""SymPy alone gives what the rings of rationals give, term by term; and one term that is altered is named."""

import pytest
import sympy

from asymptotics.errors import InputError
from asymptotics.expansions.multiple_scales.by_sympy import ansatz
from asymptotics.expansions.multiple_scales.orders import a, psi
from asymptotics.expansions.multiple_scales.symbolic import multiple_scales
from asymptotics.expansions.multiple_scales.turning import turning_hierarchy
from asymptotics.numbers.exact import MAX_ORDER


def ours(alpha, order):
    """Waves and rates by the exact engines; for alpha = 2 from the coefficients of the turning-point hierarchy."""
    if alpha % 2:
        found = multiple_scales((alpha,), order)
        return tuple(one.solution.rhs for one in found.orders), found.rates
    kernel = turning_hierarchy((alpha,), order)
    waves = tuple(a ** (n + 1) * part[(n,)].to_sympy() for n, part in enumerate(kernel.X))
    p, Omega = ({k: c for (k,), c in closed(series).items()} for series in (kernel.p, kernel.Omega))
    return waves, tuple((-(a ** (n + 1)) * p.get(n, 0), a**n * Omega.get(n, 0) + int(n == 0)) for n in range(order + 1))


def closed(series):
    return {key: value.to_sympy() for key, value in series.coefficients.items()}


@pytest.mark.parametrize(("alpha", "order"), [(1, 4), (3, 6), (5, 3), (7, 2), (2, 2)])
def test_term_by_term(alpha, order):
    assert ansatz(alpha, order).differences(*ours(alpha, order)) == ()


@pytest.mark.slow
@pytest.mark.parametrize(("alpha", "order"), [(1, 6), (5, 6), (7, 6), (9, 6), (2, 4)])
def test_term_by_term_to_the_last_order(alpha, order):
    assert ansatz(alpha, order).differences(*ours(alpha, order)) == ()


@pytest.mark.parametrize("alpha", [3, 2])
def test_a_term_that_is_altered_is_named(alpha):
    found = ansatz(alpha, 2)
    waves, rates = ours(alpha, 2)
    assert found.differences((*waves[:2], waves[2] + a * sympy.sin(5 * psi) / 1000), rates) == ("X_2",)
    wrong = (rates[0], (2 * rates[1][0], rates[1][1]), (rates[2][0], rates[2][1] - a / 9))
    assert found.differences(waves, wrong) == ("D_1 a", "D_2 psi")


def test_the_first_orders_are_those_of_the_textbook():
    cubic = ansatz(3, 1)
    assert cubic.waves == (a * sympy.cos(psi), a**3 * sympy.sin(3 * psi) / 32)
    assert cubic.gauge == "no-first-harmonic" and ansatz(2, 0).gauge == "turning-point"


@pytest.mark.parametrize(
    ("alpha", "order", "word"), [(4, 1, "alpha"), (0, 1, "alpha"), (3, 7, "order"), (2, 5, "order")]
)
def test_what_is_not_run(alpha, order, word):
    with pytest.raises(InputError, match=word):
        ansatz(alpha, order)
    assert MAX_ORDER > 7  # which the exact engine serves
