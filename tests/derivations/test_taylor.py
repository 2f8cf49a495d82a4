"""A quotient of polynomials, expanded by division, beside the series of SymPy."""

import pytest
import sympy

from derivations.steps import Taylor

X, A, B = sympy.symbols("x a b")
QUOTIENTS = (  # with a pole or none, with the variable above alone, to a power below the first
    (1 / (X - 1), 4), ((1 + X) ** 2 / (X**3 * (sympy.pi - A * X)), 2), (X**3 / (A + X**2) ** 2, 8), (A / (X * B), 3),
    (X**2 / (B + X), 1), ((A - B) / (A**2 - B**2) / (1 + X / A), 2), (X / (X + X**2) - 1, 3),
)  # fmt: skip


@pytest.mark.parametrize(("f", "n"), QUOTIENTS)
def test_a_quotient_is_expanded_as_sympy_expands_it(f, n):
    series = sympy.expand(sympy.series(f, X, 0, n + 1).removeO())
    kept = sympy.Add(*(term for term in sympy.Add.make_args(series) if term.as_coeff_exponent(X)[1] <= n))
    assert sympy.cancel(Taylor(f, X, n).doit() - kept) == 0
