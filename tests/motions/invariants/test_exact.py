from fractions import Fraction
from math import prod

import pytest
from hypothesis import given
from hypothesis import strategies as st

from asymptotics.motions.invariants.exact import (
    coefficient,
    coefficients,
    integer_rows,
)
from asymptotics.numbers.rationals import to_fraction
from tests.second_route.smith_rows import (
    coefficient_by_closed_sum,
    leading_coefficient,
    rows_by_integration,
    rows_by_rationals,
)

LAST = 60


def test_four_routes_agree_far_beyond_the_printed_rows():
    rational, integrated = rows_by_rationals(LAST), rows_by_integration(LAST)
    for n in range(1, LAST + 1):
        row = coefficients(n)
        assert row == rational[n - 1]
        assert row == {i: to_fraction(c) for i, c in enumerate(integrated[n - 1]) if c}
        assert all(coefficient(n, i) == row.get(i, 0) for i in range(n + 2))


@given(st.integers(1, 90), st.integers(0, 90))
def test_the_corrected_closed_sum_gives_the_same(n: int, i: int):
    assert coefficient_by_closed_sum(n, i) == coefficient(n, i)


def test_the_printed_sign_of_the_closed_sum_is_refuted():
    # With (-1)^k the k = 1 term alone, 2(n-1)/(n+i) C_(i-1)^(n-1), changes sign; for C_1^2 it is the whole sum.
    assert coefficient(2, 1) == Fraction(2, 3) != -Fraction(2, 3)


@pytest.mark.parametrize("n", [1, 2, 7, 100, 301])
def test_double_factorials_clear_the_denominators(n: int):
    for i, c in coefficients(n).items():
        assert prod(range(n + i, 0, -2)) % c.denominator == 0
        assert prod(range(2 * n - 1, 0, -2)) % c.denominator == 0
    # Near miss: (2n-3)!! does not clear the leading coefficient when 2n - 1 is prime.
    if n == 7:
        assert prod(range(2 * n - 3, 0, -2)) % leading_coefficient(n).denominator != 0


@given(st.integers(1, 400))
def test_the_leading_coefficient_has_a_closed_form(n: int):
    assert coefficient(n, n - 1) == leading_coefficient(n)


@given(st.integers(1, 120))
def test_rows_have_alternating_signs(n: int):
    # sign C_i^n = (-1)^((n-i-1)/2): by induction from the recurrence (used for the absolute convergence of (61)).
    assert all((c > 0) == ((n - i - 1) // 2 % 2 == 0) for i, c in coefficients(n).items())


def test_all_rows_to_800_satisfy_the_operator_form():
    # (n + x d/dx) R_n = 2(n-1) x R_(n-1) - (n-2) R_(n-2), checked on row 800 through its neighbours in Fractions.
    wanted = {798, 799, 800}
    rows = {n: row for n, row in zip(range(1, 801), (r for _, r in integer_rows())) if n in wanted}
    scale = {n: {i: prod(range(n + i, 0, -2)) for i in (1, 2, 399, 400)} for n in wanted}

    def c(n: int, i: int) -> Fraction:
        return Fraction(int(rows[n][i // 2]), scale[n][i])

    for i in (2, 400):
        assert (799 + i) * c(799, i) != 0
    assert (800 + 399) * c(800, 399) == 2 * 799 * coefficient(799, 398) - 798 * coefficient(798, 399)
