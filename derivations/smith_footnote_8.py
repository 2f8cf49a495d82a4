"""Footnote 8: sum_{k<=m} (2k+1)!!/(2^k k!) = (2m+3)!!/(3 2^m m!), by telescoping and from C_1^n = (-1)^((n-2)/2) 2/3.

>>> len(derivation.steps)
7
"""

import sympy

from derivations.steps import At, Derivation, defined

m, k = sympy.symbols("m k", integer=True, positive=True)
sign = sympy.Symbol("sigma")

derivation = Derivation(
    "smith-footnote-8",
    "The sum of footnote 8",
    source="Smith 2012, footnote 8 and (65)-(67); smith2012:fn8, 65, 66, 67",
)
step, asserts = derivation.step, derivation.asserts


def odd_double(N: sympy.Expr) -> sympy.Expr:
    """(2N+1)!! = (2N+2)!/(2^(N+1) (N+1)!)."""
    return sympy.factorial(2 * N + 2) / (2 ** (N + 1) * sympy.factorial(N + 1))


def term(k: sympy.Expr) -> sympy.Expr:
    """The summand (2k+1)!!/(2^k k!)."""
    return odd_double(k) / (2**k * sympy.factorial(k))


def right(m: sympy.Expr) -> sympy.Expr:
    """The right side (2m+3)!!/(3 2^m m!)."""
    return odd_double(m + 1) / (3 * 2**m * sympy.factorial(m))


t, r, odd = defined("t", term), defined("r", right), defined("F", odd_double)
asserts(
    "(2k+1)!! = F(k) = (2k+2)!/(2^{k+1}(k+1)!): it is 1 at k = 0, and from k to k + 1 it gains the factor 2k+3",
    sympy.Eq(odd(0), 1, evaluate=False),
    sympy.Eq(odd(k + 1) / odd(k), 2 * k + 3, evaluate=False),
)
step("m = 0: one term", t(0), r(0))
step("The right side r over the summand t", r(m) / t(m), (2 * m + 3) / sympy.Integer(3))
step("and one step before", r(m - 1) / t(m), 2 * m / sympy.Integer(3))
step(
    "so the difference is the summand: the sum telescopes",
    (r(m) - r(m - 1)) / t(m),
    1,
    proves=("smith2012:fn8",),
)

n = sympy.Symbol("n", integer=True, positive=True)
before, below = sympy.symbols("C_0^{n-1} C_1^{n-2}")
step(
    "The induction step (66), (67): (62a) at i = 1 with C_0^{n-1} = sigma/(n-1), C_1^{n-2} = -(2/3)"
    " sigma, sigma = (-1)^{(n-2)/2}",
    At(
        (2 * (n - 1) * before - (n - 2) * below) / (n + 1),
        {before: sign / (n - 1), below: -sympy.Rational(2, 3) * sign},
    ),
    sympy.Rational(2, 3) * sign,
    proves=("smith2012:66", "smith2012:67", "smith2012:claim.induction-start"),
)
# With k -> m+1-k the terms of (62b) at i = 1, n = 2m+2 are (2k+1)!!/(2k)!! times the common factor of the next line.
step(
    "(62b), corrected, at i = 1 and n = 2m+2 is the sum times 2 sigma (2m)!!/(2m+3)!!; so the sum is"
    " (2m+3)!!/(3 (2m)!!)",
    2 * 2**m * sympy.factorial(m) / odd(m + 1) * r(m),
    sympy.Rational(2, 3),
)
