"""The classical multiple-scale derivation, order by order: equation, secular terms, their removal, solution.

  asymptotics multiple-scales --alpha 3 --order 4
  asymptotics multiple-scales --alpha 3/2 --order 2 --latex
  asymptotics multiple-scales --alpha symbolic
  asymptotics multiple-scales --law 1 --law 3 --order 3 --json
  asymptotics multiple-scales --law 1 --spring 3 --order 4
  asymptotics multiple-scales --law 1 --law 1,2 --order 4
  asymptotics multiple-scales --alpha 3/2 --spring pendulum
  asymptotics multiple-scales --alpha symbolic --spring 3

Scales T_n = epsilon^n tau, X = X_0 + epsilon X_1 + ..., X_0 = a cos psi.  Polynomial forces go exactly to any order:
losses |x|^M x'^A with A odd and M even, springs x^P x'^Q with P odd and Q even, the pendulum (x in units of theta_0).
Powers x'|x'|^(A-1) with any other exponent (or a symbolic one) go to second order, beside springs x|x|^(P-1) of any P
and the pendulum.  Strengths stay symbols: epsilon_i of the losses, c_j of the springs, in the order given; their
values are told below the equations, where they are given.  The gauge
is no-first-harmonic: a is the coefficient of cos psi.
"""

import argparse
from typing import Any

import sympy

from asymptotics.api.hierarchy import MAX_ORDER, multiple_scales, symbolic_multiple_scales
from asymptotics.cli.answer import Answer, add_json, add_max_seconds
from asymptotics.cli.forces import add_forces, read_terms
from asymptotics.cli.rows import strengths_given
from asymptotics.errors import InputError
from asymptotics.law import Law
from asymptotics.multiscale.general import SecondOrder
from asymptotics.multiscale.orders import Order
from asymptotics.multiscale.symbolic import MultipleScales
from asymptotics.numbers.exact import parse_integer, parse_real


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    text = "its strength, told with the result: the derivation holds for every strength"
    add_forces(parser, "epsilon", "E", text)
    parser.add_argument("--order", default="2", metavar="N", help=f"1 to {MAX_ORDER}; above 2 for polynomial forces")
    parser.add_argument("--latex", action="store_true", help="print LaTeX instead of text")
    add_max_seconds(parser)
    add_json(parser)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    order = parse_integer(options.order, "--order", 1, MAX_ORDER)
    strengths = _strengths(options)
    found = _found(options, order)
    rates = {"amplitude_rate": found.amplitude_rate, "phase_rate": found.phase_rate}
    start = {"initial_amplitude": found.initial_amplitude, "initial_phase": found.initial_phase}
    data: dict[str, Any] = {
        "order": order,
        "gauge": found.gauge,
        **{name: str(rate) for name, rate in (rates | start).items()},
        "strengths": strengths,
        "orders": [_order(one) for one in found.orders],
        "latex": _latex(found.orders, rates),
    }
    text = "\n".join([*map(str, found.orders), f"da/dtau = {found.amplitude_rate}", f"dpsi/dtau = {found.phase_rate}"])
    text += f"\nstart at rest from X = 1: a(0) = {found.initial_amplitude}, psi(0) = {found.initial_phase}"
    text += "" if isinstance(found, MultipleScales) else " (to first order)"
    text += "".join(f"\n{letter} = {value}" for letter, value in strengths.items())
    return Answer(data, data["latex"] if options.latex else f"{text}\ngauge: {found.gauge}", options.json)


def _strengths(options: argparse.Namespace) -> dict[str, str]:
    """The strengths that were given, by the letters of the derivation."""
    if options.alpha == "symbolic":
        return {} if options.epsilon is None else {"epsilon": str(parse_real(options.epsilon, "--epsilon"))}
    given = read_terms(options)
    if not strengths_given(given, options):
        return {}
    found: dict[str, str] = {}
    for letter, sign in (("epsilon", -1), ("c", 1)):
        terms = [t for t in given.terms if t.sign == sign and not t.family]
        found |= {letter + (f"_{i}" if len(terms) > 1 else ""): str(t.strength) for i, t in enumerate(terms)}
    return found


def _found(options: argparse.Namespace, order: int) -> MultipleScales | SecondOrder:
    """The derivation; a symbolic exponent stands alone or beside springs."""
    if options.alpha != "symbolic":
        given = read_terms(options)
        return multiple_scales(Law.from_terms(given.terms, given.notes), order=order)
    if options.law is not None:
        raise InputError("--law", "cannot be combined with --alpha symbolic", "one symbolic exponent, and springs")
    options.alpha = None
    return symbolic_multiple_scales(read_terms(options).terms if options.spring else (), order)


def _order(one: Order) -> dict[str, Any]:
    """One order as JSON data: SymPy-readable text."""
    solution = None if one.solution is None else str(one.solution.rhs)
    return {
        "n": one.n,
        "equation": f"{one.equation.lhs} = {one.equation.rhs}",
        "solvability": [f"{e.lhs} = {e.rhs}" for e in one.solvability],
        "solution": solution,
    }


def _latex(orders: tuple[Order, ...], rates: dict[str, Any]) -> str:
    lines = [one._repr_latex_().strip("$") for one in orders]
    amplitude, phase = (sympy.latex(rate) for rate in rates.values())
    rows = [rf"\frac{{da}}{{d\tau}} = {amplitude}", rf"\frac{{d\psi}}{{d\tau}} = {phase}"]
    return "\n".join(rf"\[ {line} \]" for line in (*lines, *rows))
