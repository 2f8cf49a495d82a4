"""The classical multiple-scale derivation, order by order: equation, conditions, rates, solution.

  asymptotics multiple-scales --alpha 3 --order 4
  asymptotics multiple-scales --alpha 3/2 --order 2 --latex
  asymptotics multiple-scales --alpha symbolic
  asymptotics multiple-scales --law 1 --law 3 --order 3 --json
  asymptotics multiple-scales --law 1 --spring 3 --order 4
  asymptotics multiple-scales --law 1 --law 1,2 --order 4
  asymptotics multiple-scales --alpha 3/2 --spring pendulum
  asymptotics multiple-scales --alpha symbolic --spring 3
  asymptotics multiple-scales --alpha 5/2 --order 6 --phase 1 --digits 20
  asymptotics multiple-scales --alpha 2 --order 8
  asymptotics multiple-scales --alpha 3 --order 3 --gauge turning-point --map

Scales T_n = epsilon^n tau, X = X_0 + epsilon X_1 + ..., X_0 = a cos psi, V_n = (X')_n.  Every law, any order: integer
exponents exactly, with X_n polynomials in psi, sin psi, cos psi; others (and symbolic) with closed forms where there
are any and named integrals beyond, to order 12.  Strengths stay symbols: epsilon_i of the losses, c_j of the springs,
theta_0 of a pendulum (x in units of theta_0), in the order given; their values are told below the equations.

Gauges: no-first-harmonic (a is the coefficient of cos psi; the default for polynomial forces |x|^M x'|x'|^(A-1), A odd
and M even, x^P |x'|^Q, P odd and Q even) and turning-point (a is the turning amplitude, X_n on 0 < psi < pi and
X(a, psi + pi) = -X(a, psi); the default for all other laws).  --map tells the exact map between them where both exist.
--phase: every X_n there (turning-point gauge), certified, the named integrals among them.
"""

import argparse
from typing import Any

import sympy

from asymptotics.api.hierarchy import (
    MAX_OPEN_ORDER,
    MAX_ORDER,
    any_start,
    map_of_gauges,
    multiple_scales,
    ordered,
    symbolic_multiple_scales,
)
from asymptotics.ask.forces import add_forces, read_terms
from asymptotics.cli.answer import Answer, add_common, add_digits, read_digits
from asymptotics.errors import InputError
from asymptotics.expansions.multiple_scales.orders import Order
from asymptotics.expansions.multiple_scales.symbolic import MultipleScales
from asymptotics.gauges import TURNING_POINT
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_integer, parse_real

MAX_DIGITS = 300


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    text = "its strength, told with the result: the derivation holds for every strength"
    add_forces(parser, "epsilon", "E", text)
    parser.add_argument(
        "--order", default="2", metavar="N", help=f"1 to {MAX_ORDER}; to 12 unless exponents are integers"
    )
    parser.add_argument("--gauge", metavar="GAUGE", help="turning-point or no-first-harmonic (default: see above)")
    parser.add_argument("--map", action="store_true", help="the exact map from no-first-harmonic to turning-point too")
    parser.add_argument("--start", action="store_true", help="a(0), psi(0) of any start, in motion too")
    parser.add_argument("--phase", metavar="PSI", help="the value of every X_n at this phase (rad), certified")
    add_digits(parser, MAX_DIGITS)
    parser.add_argument("--latex", action="store_true", help="print LaTeX instead of text")
    add_common(parser)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    order = parse_integer(options.order, "--order", 1, MAX_ORDER)
    found = _found(options, order)
    strengths = _strengths(options, found)
    rates = {"amplitude_rate": found.amplitude_rate, "phase_rate": found.phase_rate}
    start = {"initial_amplitude": found.initial_amplitude, "initial_phase": found.initial_phase}
    data: dict[str, Any] = {
        "order": order,
        "gauge": found.gauge,
        **{name: str(rate) for name, rate in (rates | start).items()},
        "strengths": strengths,
        "orders": [_order(one) for one in found.orders],
    }
    # Written only where it is shown: a high order has terms by the thousand.
    if options.json or options.latex:
        data["latex"] = _latex(found.orders, rates)
    lines = [*map(str, found.orders), f"da/dtau = {found.amplitude_rate}", f"dpsi/dtau = {found.phase_rate}"]
    lines.append(f"start at rest from X = 1: a(0) = {found.initial_amplitude}, psi(0) = {found.initial_phase}")
    if options.start:
        data["start"] = {name: str(e) for name, e in any_start(found).items()}
        lines.append("any start X(0) = r cos theta, X'(0) = -r sin theta, 0 < theta < pi:")
        lines += [f"  {name} = {text}" for name, text in data["start"].items()]
    if options.map:
        data["map"] = {
            name: str(e) for name, e in map_of_gauges(Law.from_terms(read_terms(options).terms), order=order).items()
        }
        lines += [f"turning-point gauge from no-first-harmonic: {name} = {text}" for name, text in data["map"].items()]
    if options.phase is not None:
        data |= {"phase": options.phase, "waves": _waves(options, found)}
        lines += _waves_text(options.phase, data["waves"], found)
    lines += [f"{letter} = {value}" for letter, value in strengths.items()]
    if found.gauge == TURNING_POINT:
        lines.append("X_n: on 0 < psi < pi, and X(a, psi + pi) = -X(a, psi)")
    text = data["latex"] if options.latex else "\n".join([*lines, f"gauge: {found.gauge}"])
    return Answer(data, text, options.json)


def _waves(options: argparse.Namespace, found: MultipleScales) -> dict[str, str]:
    """x_k at --phase; InputError in the other gauge and without numbers."""
    if found.gauge != TURNING_POINT:
        raise InputError("--phase", f"the gauge is {found.gauge}", f"--gauge {TURNING_POINT} --phase PSI")
    if options.symbolic:
        raise InputError("--phase", "a symbolic exponent has no numbers", "--alpha A or --law A")
    from asymptotics.api.waves import Waveforms  # noqa: PLC0415 (NumPy and splines: only --phase needs them)

    order = parse_integer(options.order, "--order", 1, MAX_OPEN_ORDER)
    # In the order of the symbols above, so that the indices of x_k are those of the strengths in the text.
    waves = Waveforms(tuple(ordered(read_terms(options).terms, found)), order)
    values = waves.at(parse_real(options.phase, "--phase"), digits=read_digits(options, MAX_DIGITS))
    return {str(k) if isinstance(k, int) else ",".join(map(str, k)): value for k, value in values.items()}


def _waves_text(phase: str, waves: dict[str, str], found: MultipleScales) -> list[str]:
    delta = "delta^k, delta = epsilon a^(d-1)" if len(found.symbols) == 1 else "prod_i (strength_i a^(d_i-1))^k_i"
    head = f"X = a (cos psi + sum_k x_k {delta}), d: degree of the force; at psi = {phase}, certified:"
    return [head, *(f"  x_{n} = {value}" for n, value in waves.items())]


def _strengths(options: argparse.Namespace, found: MultipleScales) -> dict[str, str]:
    """The strengths that were given, by the letters of the derivation."""
    if options.symbolic:
        return {} if options.epsilon is None else {"epsilon": str(parse_real(options.epsilon, "--epsilon"))}
    given = read_terms(options)
    if not given.known:
        return {}
    told: dict[str, str] = {}
    for letter, sign in (("epsilon", -1), ("c", 1)):
        # A pendulum has the angle theta_0 for its letter, which no strength is told of.
        terms = [t for t in ordered(given.terms, found) if t.sign == sign and not t.family]
        told |= {letter + (f"_{i}" if len(terms) > 1 else ""): str(t.strength) for i, t in enumerate(terms)}
    return told


def _found(options: argparse.Namespace, order: int) -> MultipleScales:
    """The derivation; a symbolic exponent stands alone or beside springs."""
    options.symbolic = options.alpha == "symbolic"
    if not options.symbolic:
        given = read_terms(options)
        return multiple_scales(Law.from_terms(given.terms, given.notes), order=order, gauge=options.gauge)
    if options.law is not None:
        raise InputError("--law", "cannot be combined with --alpha symbolic", "one symbolic exponent, and springs")
    if options.map:
        raise InputError("--map", "no-first-harmonic does not exist for a symbolic exponent", "polynomial forces")
    options.alpha = None
    return symbolic_multiple_scales(read_terms(options).terms if options.spring else (), order, options.gauge)


def _order(one: Order) -> dict[str, Any]:
    """One order as JSON data: SymPy-readable text."""
    solution = None if one.solution is None else str(one.solution.rhs)
    return {
        "n": one.n,
        "hierarchy": f"{one.hierarchy.lhs} = {one.hierarchy.rhs}",
        "equation": f"{one.equation.lhs} = {one.equation.rhs}",
        "conditions": [f"{c} = 0" for _, c in one.conditions],
        "solvability": [f"{e.lhs} = {e.rhs}" for e in one.solvability],
        "solution": solution,
        "where": [f"{e.lhs} = {e.rhs}" for e in one.where],
    }


def _latex(orders: tuple[Order, ...], rates: dict[str, Any]) -> str:
    lines = [one._formula() for one in orders]
    amplitude, phase = (sympy.latex(rate) for rate in rates.values())
    rows = [rf"\frac{{da}}{{d\tau}} = {amplitude}", rf"\frac{{d\psi}}{{d\tau}} = {phase}"]
    return "\n".join(rf"\[ {line} \]" for line in (*lines, *rows))
