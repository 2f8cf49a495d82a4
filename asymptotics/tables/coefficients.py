"""The normal form and the half-swing as coefficients of powers of delta, for a grid of exponents or one sum of laws.

The return map (Poincare) from one turning point to the next, and the flow through it, its iterative logarithm.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction

import sympy

from asymptotics.expansions.normal_form.coefficients import expansion_coefficients, half_swing_coefficients
from asymptotics.expansions.normal_form.results import Coefficient
from asymptotics.numbers.exact import ExactReal
from asymptotics.tables.cells import Cell, Formula, Nearest
from asymptotics.tables.inputs import GRID, Inputs
from asymptotics.tables.recipe import Found, rows_in_progress

_ORDER = 4


def normal_form(inputs: Inputs, digits: int) -> Found:
    """Rows (alpha, coefficient, value, exact): p_k and Omega_k in the turning-point gauge; --rows is the order."""
    found = Found(rows_in_progress(), True)
    for alphas in _exponents(inputs):
        made = expansion_coefficients(alphas, inputs.count(_ORDER), digits)
        for name, row in (("p", made.amplitude), ("Omega", made.frequency)):
            found = _with(found, alphas, name, row)
    return found


def half_swing(inputs: Inputs, digits: int) -> Found:
    """Rows (alpha, coefficient, value, exact): L, T, U, W and, for one law, F and V; --rows is the order."""
    found = Found(rows_in_progress(), True)
    for alphas in _exponents(inputs):
        made = half_swing_coefficients(alphas, inputs.count(_ORDER), digits)
        rows = [("L", made.log_ratio), ("T", made.duration), ("U", made.U), ("W", made.W)]
        # Of a sum F and V have a component for each law: their names would need two indices.
        if len(alphas) == 1:
            rows += [("F", made.map[0]), ("V", made.V[0])]
        for name, row in rows:
            found = _with(found, alphas, name, row)
    return found


def _exponents(inputs: Inputs) -> list[tuple[ExactReal, ...]]:
    if inputs.law is not None:
        return [inputs.law.alphas]
    return [(a,) for a in inputs.alphas_or(GRID)]


def _with(found: Found, alphas: Sequence[ExactReal], name: str, row: Mapping[str, Coefficient]) -> Found:
    label = ",".join(map(str, alphas))
    rows = [(label, f"{name}_{key}", _value(c), _exact(c)) for key, c in row.items()]
    found.rows.extend(rows)
    return Found(found.rows, found.certified and all(c.value is not None for c in row.values()))


def _value(c: Coefficient) -> Cell:
    # Exact where it can be: a decimal that ends is a tie for every directed rounding.
    if isinstance(c.expression, sympy.Rational):
        return Fraction(int(c.expression.p), int(c.expression.q))
    return "" if c.value is None else Nearest(c.value)


def _exact(c: Coefficient) -> Cell:
    return "" if c.expression is None else Formula(str(c.expression), sympy.latex(c.expression))
