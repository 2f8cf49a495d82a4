"""The closed forms in alpha, derived from the half-swing as rational functions, and enclosed at an exponent."""

from flint import arb
from sympy import Expr, factor

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.symbolic import FIELD, field_half_swing, nested_integral, to_expression
from asymptotics.expansions.moments.certified import moment as moment_ball
from asymptotics.expansions.normal_form.flow import Flow, flow_of
from asymptotics.expansions.normal_form.in_moments import rates
from asymptotics.expansions.normal_form.symbolic import flow_through_fourth_order
from asymptotics.numbers.context import cache


@cache
def field_flow() -> Flow:
    """U and W with coefficients in Q(alpha)(pi, moments, J), from the half-swing by log C/(C - 1)."""
    return flow_of(field_half_swing())


def derived_coefficient(series: str, k: int) -> Expr:
    """U_k or W_k as the pipeline derives it, in SymPy.

    >>> from asymptotics.expansions.normal_form.symbolic import symbolic_expansion
    >>> derived_coefficient("W", 2) - symbolic_expansion()["W"][2]
    0
    """
    flow = field_flow()
    return factor(to_expression({"U": flow.U, "W": flow.W}[series][k] * FIELD.one))


def certified_coefficients(exponent: arb) -> dict[str, dict[int, arb]]:
    """p_1, p_3, Omega_2, Omega_4 as balls at a ball alpha >= 0, from the closed forms and the certified I_4.

    >>> found = certified_coefficients(arb(2))
    >>> found["Omega"][4].str(10), (-arb(7) / 432).str(10)
    ('[-0.01620370370 +/- ...]', '[-0.01620370370 +/- ...]')
    """
    if not exponent >= 0:
        raise InputError("alpha", f"{exponent.str(5)} is not certainly >= 0", "alpha >= 0")
    p, Omega = rates(*flow_through_fourth_order(exponent, moment_ball, nested_integral(exponent)))
    return {"p": p, "Omega": Omega}
