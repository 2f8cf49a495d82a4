"""The model against routes that share nothing with it."""

from fractions import Fraction

import pytest
import sympy
from flint import arb, ctx

from paper_checks.identities import rounds_to
from paper_checks.smith2012.model import coefficient, invariant, orbit, polynomial_row
from paper_checks.smith2012.section_4_sums import closed_sum, is_closed_sum
from paper_checks.verdict import Outcome


def test_rows_obey_the_differential_equation_in_sympy():
    w = sympy.Symbol("w")
    rows = [[sympy.Rational(c.numerator, c.denominator) for c in polynomial_row(n)] for n in range(1, 9)]
    f = [sum(c * w**i for i, c in enumerate(row)) for row in rows]
    for n in range(3, 9):
        line = (n - 2) * f[n - 3] + w * sympy.diff(f[n - 1], w) + n * f[n - 1] - 2 * w * (n - 1) * f[n - 2]
        assert sympy.expand(line) == 0


def test_leading_and_constant_coefficients():
    # f_n(0) = (-1)^((n-1)/2)/n and C_(n-1)^n = product of 2(k-1)/(2k-1): by induction from (60h)
    product = Fraction(1)
    for n in range(2, 30):
        product *= Fraction(2 * (n - 1), 2 * n - 1)
        assert coefficient(n, n - 1) == product
        assert coefficient(n, 0) == (Fraction((-1) ** ((n - 1) // 2), n) if n % 2 else 0)


def test_turning_points_solve_43():
    with ctx.workprec(200):
        points = orbit(8)
        for index, (a, b) in enumerate(zip(points, points[1:])):
            assert invariant(index, a).overlaps(invariant(index, b))
            assert bool(abs(b) < abs(a)) and bool(a * b < 0)


@pytest.mark.parametrize(
    ("printed", "outcome"),
    [("0.33333", Outcome.CONFIRMED), ("0.33334", Outcome.REFUTED), ("0.3333", Outcome.CONFIRMED)],
)
def test_rounding(printed, outcome):
    assert rounds_to(printed, arb(1) / 3) == outcome


def test_a_wide_ball_rounds_to_nothing():
    assert rounds_to("0.333", arb(1, 1)) == Outcome.UNDECIDED


@pytest.mark.parametrize("column", range(1, 9))
def test_closed_sums_and_parity(column):
    P, R = closed_sum(column)
    assert is_closed_sum(column)
    assert all(P[power] == 0 for power in range(P.degree() + 1) if (power - column) % 2)
    assert all(R[power] == 0 for power in range(R.degree() + 1) if (power - column - 1) % 2)
