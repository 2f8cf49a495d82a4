"""Single results by name: the reference tables, and Smith's machinery for quadratic damping.

>>> f(3)                                                   # f_3(w) = sum_i C_i^3 w^i
{0: Fraction(-1, 3), 2: Fraction(8, 15)}
>>> C(31, 10)
Fraction(2010398511427223552, 37418691427425)
>>> G(1).in_z()
2*z**2/(3*z**2 + 3)
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from asymptotics.api.units import law_of
from asymptotics.errors import InputError, shown
from asymptotics.law import LawLike
from asymptotics.motions.invariants.exact import coefficient, coefficients
from asymptotics.motions.invariants.symbolic import GeneratingFunction, generating_function
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number, exact_integer, exact_number
from asymptotics.numbers.rounding import MODES
from asymptotics.public import public
from asymptotics.tables import registry
from asymptotics.tables.inputs import MAX_ROWS, Inputs
from asymptotics.tables.table import Table

# Sizes of answers that still come at once and can be read; they refuse, and nothing that is answered rests on them.
MAX_P, MAX_DIGITS, MAX_ROW, MAX_N, MAX_G = 10_000, 10_000, 5_000, 10_000, 100


@public
def table(
    name: str,
    *,
    alpha: Number | Sequence[Number] | None = None,
    epsilon: Number | Sequence[Number] | None = None,
    law: LawLike | None = None,
    rows: int | None = None,
    rounding: str = "nearest",
    digits: int = 30,
    max_seconds: Number = 60,
) -> Table:
    """A reference table by name (``table_names`` lists them): rows of certified strings with their provenance.

    ``alpha`` and ``epsilon`` are numbers or lists of them, ``law`` is one sum, ``rows`` how many rows (or the order),
    ``rounding`` a mode of ``asymptotics table``.  InputError for what changes nothing in the table.

    >>> table("turning-points", law={0: "1/20", "3/2": "1/10"}, rows=2, digits=6).rows[1][2]
    '-0.779510'
    """
    if not isinstance(name, str):
        raise InputError("name", f"a {type(name).__name__} is no name", ", ".join(registry.names()))
    inputs = table_inputs(alpha, epsilon, law, rows)
    if not isinstance(rounding, str):
        raise InputError("rounding", f"{shown(rounding)} is no mode", ", ".join(MODES))
    return registry.build(name, exact_integer(digits, "digits", 1, registry.MAX_DIGITS), inputs, rounding)


def table_inputs(alpha: Any, epsilon: Any, law: Any, rows: Any = None) -> Inputs:
    """What a table is asked for; InputError by name."""
    exponents, strengths = _listed(alpha, "alpha"), _listed(epsilon, "epsilon")
    count = None if rows is None else exact_integer(rows, "rows", 1, MAX_ROWS)
    return Inputs.of(exponents, None if law is None else law_of(law), strengths, count)


def _listed(given: Any, name: str) -> tuple[ExactReal, ...]:
    """One number or several."""
    several = given if isinstance(given, list | tuple) else () if given is None else (given,)
    return tuple(exact_number(value, name) for value in several)


@public
def table_names(*, max_seconds: Number = 60) -> dict[str, str]:
    """The names of the tables and their titles.

    >>> table_names()["moments"]
    'The averages M_p = <|sin|^p> that the first orders need'
    """
    return registry.names()


@public
def f(n: int, *, max_seconds: Number = 60) -> dict[int, Fraction]:
    """Smith's polynomial f_n(w) = sum_i C_i^n w^i: i -> C_i^n (Smith 2012, (59) and (62)), exactly."""
    return dict(coefficients(exact_integer(n, "n", 1, MAX_ROW)))


@public
def C(n: int, i: int, *, max_seconds: Number = 60) -> Fraction:
    """Smith's coefficient C_i^n, exactly."""
    row = exact_integer(n, "n", 1, MAX_N)
    return coefficient(row, exact_integer(i, "i", 0, row - 1))


@public
def G(i: int, *, max_seconds: Number = 60) -> GeneratingFunction:
    """The sum G_i(z) = sum_n C_i^n z^n in closed form, for any i (derivation ``smith-generating-functions``)."""
    return generating_function(exact_integer(i, "i", 0, MAX_G))
