"""Single results by name: the moments, the reference tables, and Smith's machinery for quadratic damping.

>>> print(moment("5/2", digits=12), moment(3).exact)
0.457655858101 4/(3*pi)
>>> f(3)                                                   # f_3(w) = sum_i C_i^3 w^i
{0: Fraction(-1, 3), 2: Fraction(8, 15)}
>>> C(31, 10)
Fraction(2010398511427223552, 37418691427425)
>>> G(1).in_z()
2*z**2/(3*z**2 + 3)
"""

from fractions import Fraction
from typing import Any

from asymptotics.errors import InputError
from asymptotics.invariants.exact import coefficient, coefficients
from asymptotics.invariants.symbolic import GeneratingFunction, generating_function
from asymptotics.moments.certified import moment as moment_ball
from asymptotics.moments.symbolic import moment as moment_expression
from asymptotics.numbers.bridge import from_sympy, to_sympy
from asymptotics.numbers.decimals import certified_decimal, rational_decimal
from asymptotics.numbers.policy import exact_integer, exact_number, float_notes
from asymptotics.numbers.value import Coefficient
from asymptotics.tables import registry
from asymptotics.tables.table import Table

MAX_P, MAX_DIGITS, MAX_ROW, MAX_N, MAX_G = 10_000, 10_000, 5_000, 10_000, 100


def moment(p: Any, *, digits: Any = 30) -> Coefficient:
    """M_p = <|sin|^p> = Gamma((p+1)/2)/(sqrt(pi) Gamma(p/2+1)), p > -1: certified digits and closed form.

    InputError for p <= -1, where the average diverges, and for what is not an exact number.
    """
    number, D = exact_number(p, "p"), exact_integer(digits, "digits", 1, MAX_DIGITS)
    if not number > -1 or number > MAX_P:
        reason = "the average diverges" if not number > -1 else "is out of range"
        raise InputError("p", f"{number}: {reason}", f"a real number above -1, at most {MAX_P}")
    expression = moment_expression(to_sympy(number))
    if expression.is_Rational:  # even p: exactly known, ties included
        return Coefficient(rational_decimal(from_sympy(expression), D), expression, float_notes(p=p))
    return Coefficient(certified_decimal(lambda: moment_ball(number.ball()), D), expression, float_notes(p=p))


def table(name: str, *, digits: Any = 30) -> Table:
    """A reference table by name (``table_names`` lists them): rows of certified strings with their provenance."""
    if not isinstance(name, str):
        raise InputError("name", f"a {type(name).__name__} is no name", ", ".join(registry.names()))
    return registry.build(name, exact_integer(digits, "digits", 1, registry.MAX_DIGITS))


def table_names() -> dict[str, str]:
    """The names of the tables and their titles."""
    return registry.names()


def f(n: Any) -> dict[int, Fraction]:
    """Smith's polynomial f_n(w) = sum_i C_i^n w^i: i -> C_i^n (Smith 2012, (59) and (62)), exactly."""
    return dict(coefficients(exact_integer(n, "n", 1, MAX_ROW)))


def C(n: Any, i: Any) -> Fraction:
    """Smith's coefficient C_i^n, exactly."""
    row = exact_integer(n, "n", 1, MAX_N)
    return coefficient(row, exact_integer(i, "i", 0, row - 1))


def G(i: Any) -> GeneratingFunction:
    """The sum G_i(z) = sum_n C_i^n z^n in closed form, for any i (derivation ``smith-generating-functions``)."""
    return generating_function(exact_integer(i, "i", 0, MAX_G))
