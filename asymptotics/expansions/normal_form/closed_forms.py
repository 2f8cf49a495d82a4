"""The coefficients with a symbolic exponent: closed forms, and the one integral that remains.

>>> found = symbolic_coefficients(2, "averaging", 10)
>>> found.amplitude["1"].exact
'gamma(alpha/2 + 1)/(sqrt(pi)*gamma(alpha/2 + 3/2))'
"""

from functools import partial
from typing import Any

import sympy
from flint import arb, fmpq

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.symbolic import alpha, nested_integral, nested_integral_definition
from asymptotics.expansions.moments import symbolic as moments
from asymptotics.expansions.normal_form.expansion import exact_expansion
from asymptotics.expansions.normal_form.results import Coefficient, Coefficients, Row
from asymptotics.expansions.normal_form.spring_terms import cross_term
from asymptotics.expansions.normal_form.symbolic import omega_2, symbolic_expansion
from asymptotics.gauges import TURNING_POINT
from asymptotics.numbers.decimals import MAX_DIGITS, certified_decimal
from asymptotics.numbers.exact import MAX_ORDER
from asymptotics.numbers.integers import require_integer
from asymptotics.terms import Term

# From p_5 on nested integrals remain that reduce to no name (``multiple_scales.open_orders`` shows them).
MAX_SYMBOLIC_ORDER = 4
_SAMPLES = (fmpq(1, 2), fmpq(3, 2), fmpq(5, 2))


def symbolic_coefficients(order: int, gauge: str, digits: int) -> Coefficients:
    """The closed forms through ``order`` <= 4 (<= 2 outside the turning-point gauge); InputError above."""
    require_integer(order, "order", 1, MAX_ORDER)
    require_integer(digits, "digits", 1, MAX_DIGITS)
    highest = MAX_SYMBOLIC_ORDER if gauge == TURNING_POINT else 2
    if order > highest:
        reason = f"{order}: in the gauge {gauge} closed forms in alpha are known through order {highest}"
        raise InputError("order", reason, f"an integer from 1 to {highest}")
    source = symbolic_expansion()
    p, Omega, W = ({k: v for k, v in source[name].items() if k <= order} for name in ("p", "Omega", "W"))
    # The source is the turning-point gauge: through order 2 the others differ from it in Omega_2 alone.
    if 2 in Omega:
        Omega[2] = omega_2(gauge)
    return Coefficients(
        gauge,
        order,
        "symbolic",
        _row(p),
        _row(Omega),
        _row(W) if gauge == TURNING_POINT else {},
        _integrals(order, digits),
    )


def symbolic_with_spring(p: int, order: int) -> Coefficients:
    """One loss of symbolic exponent and the spring x|x|^(p-1): closed forms through second order, turning-point gauge.

    Keys count the loss, then the spring.  InputError above second order.

    >>> found = symbolic_with_spring(3, 2)
    >>> found.frequency["0,1"].exact, found.amplitude["1,1"].expression.subs(alpha, 1)
    ('3/8', -5/32)
    """
    if not 1 <= order <= 2:
        raise InputError("order", f"{order}: with a spring closed forms in alpha are known through order 2", "1 or 2")
    p_1, shift = moments.moment(alpha + 1), moments.moment(p + 1)
    amplitude: dict[str, sympy.Expr] = {"1,0": p_1}
    frequency: dict[str, sympy.Expr] = {"0,1": shift}
    if order == 2:
        amplitude["1,1"] = p_1 * shift - cross_term(alpha, 0, p, moments)
        spring = exact_expansion([Term(1, 0, p, "position")], 2).Omega[2]
        frequency |= {"0,2": spring.to_sympy(), "2,0": omega_2()}
    p_row, Omega_row = ({k: Coefficient(None, v) for k, v in row.items()} for row in (amplitude, frequency))
    return Coefficients(TURNING_POINT, order, "symbolic", p_row, Omega_row)


def _row(values: dict[int, sympy.Expr]) -> Row:
    return {str(k): Coefficient(None, v) for k, v in values.items()}


def _integrals(order: int, digits: int) -> dict[str, dict[str, Any]]:
    """I_4, which enters at fourth order: its definition, and certified values at a few exponents."""
    if order < 4:
        return {}
    values = {str(a): certified_decimal(partial(nested_integral, arb(a)), digits) for a in _SAMPLES}
    return {"I_4": {"definition": str(nested_integral_definition()), "values": values}}
