"""The half-swing from one turning point to the next as power series in delta = epsilon A^(alpha-1):

log_ratio L = ln(A'/A),  map F: delta -> delta',  duration T,  and the smooth flow that interpolates them,
U = d ln A/dpsi,  V = d delta/dpsi,  W = dtau/dpsi  (turning-point gauge).

asymptotics half-swing --alpha 3/2 --order 6 --digits 40
asymptotics half-swing --alpha 3/2 --spring 3 --order 4
asymptotics half-swing --alpha symbolic --order 2

With --delta, the numbers at that local strength instead: A'/A, L and T, certified, with the enclosure, the route, the
number of terms and the tail; a sum takes one strength for each law, then one for each spring (A^2 for a pendulum).

asymptotics half-swing --alpha 3/2 --delta 1/5 --digits 30
asymptotics half-swing --law 1 --law 2 --delta 1/50,1/40
asymptotics half-swing --alpha 3/2 --spring pendulum --delta 1/10,4
"""

import argparse
from pathlib import Path

import sympy

from asymptotics.ask.forces import GivenTerms, add_forces, read_terms
from asymptotics.ask.rows import (
    asked_besides,
    deltas_latex,
    local_strengths,
    order_of,
    row_text,
    rows_csv,
    rows_latex,
    strengths_given,
)
from asymptotics.cli.answer import Answer, add_common, read_digits, read_max_seconds
from asymptotics.cli.expand import MAX_DIGITS, MAX_ORDER
from asymptotics.cli.files import Makers, add_csv, add_plot, picture_maker, read_files, write_files
from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.symbolic import symbolic_half_swing
from asymptotics.expansions.normal_form.closed_forms import MAX_SYMBOLIC_ORDER
from asymptotics.expansions.normal_form.coefficients import half_swing_coefficients
from asymptotics.expansions.normal_form.results import Coefficient, row_to_dict
from asymptotics.numbers.exact import parse_integer, parse_real
from asymptotics.present.inputs import csv_text
from asymptotics.turning.half_swing import half_swing_of_terms


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    add_forces(parser)
    parser.add_argument("--order", default="4", metavar="N", help=f"the highest power of delta, 1 to {MAX_ORDER}")
    parser.add_argument("--exact", action="store_true", help="demand exact coefficients (integer exponents)")
    text = "the number at this local strength instead of the series; a sum: D_1,D_2,... laws, then springs"
    parser.add_argument("--delta", metavar="D", help=text)
    parser.add_argument("--latex", action="store_true", help="print the series, or the numbers, as LaTeX")
    add_plot(parser, "A'/A against the local strength")
    add_csv(parser, "the coefficients, or the numbers: name, powers, digits, exact form")
    add_common(parser, MAX_DIGITS)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    files = read_files(options)
    if options.alpha == "symbolic":
        return _symbolic(options, files)
    given = read_terms(options)
    if options.delta is not None:
        return _at(options, given, files)
    order = parse_integer(options.order, "--order", 1, MAX_ORDER)
    digits = read_digits(options, MAX_DIGITS)
    seconds = read_max_seconds(options)
    found = half_swing_coefficients(given.terms, order, digits, exact_only=options.exact, max_seconds=seconds)
    names = [("L", found.log_ratio), ("T", found.duration), ("U", found.U), ("W", found.W)]
    # F and V have a component for each force, L, T, U and W are common to all.
    suffixes = [""] if len(given.terms) == 1 else [f"[{name}]" for name in given.names]
    names += [(f"{n}{s}", row) for n, rows in (("F", found.map), ("V", found.V)) for s, row in zip(suffixes, rows)]
    deltas = local_strengths(given, options)
    lines = [f"turning-point gauge, {found.arithmetic}", *order_of(given)]
    lines += [f"{name} = {value} for {force}" for name, force, value in deltas if strengths_given(given, options)]
    lines += [line for name, row in names for line in row_text(name, row)]
    data = {"alpha": given.shown, "terms": given.to_list(), **found.to_dict(), "notes": list(given.notes)}
    data["delta"] = [{"name": name, "force": force, "value": value} for name, force, value in deltas]
    latex = rows_latex({_index(name, given): row for name, row in names}, deltas_latex(given), digits)
    makers: Makers = {"--csv": lambda _: rows_csv(dict(names)), "--plot": picture_maker(options, lambda: [found])}
    written = write_files(files, makers, options, "half-swing")
    data |= asked_besides(options, latex, written)
    return Answer(data, "\n".join([latex] if options.latex else [*lines, *given.notes, *written]), options.json)


def _symbolic(options: argparse.Namespace, files: dict[str, Path]) -> Answer:
    """L, F and T of one law with a symbolic exponent, in closed form."""
    others = {"--csv": files, "--law": options.law, "--spring": options.spring, "--exact": options.exact}
    for name, value in {**others, "--delta": options.delta, "--epsilon": options.epsilon}.items():
        if value:
            raise InputError(name, "cannot be combined with --alpha symbolic", "one law, in closed form")
    # Beyond, the coefficients in alpha hold nested integrals without a closed form.
    order = parse_integer(options.order, "--order", 1, MAX_SYMBOLIC_ORDER)
    # Read for its refusal: digits mean nothing here, but a wrong number is told.
    read_digits(options, MAX_DIGITS)
    half = symbolic_half_swing()
    series = {"log_ratio": ("L", half.L), "map": ("F", half.F[0]), "duration": ("T", half.T)}
    rows = {long: (name, [(k, s[k]) for k in range(order + 1) if s[k] != 0]) for long, (name, s) in series.items()}
    lines = [f"{name}_{k} = {c}" for name, row in rows.values() for k, c in row]
    latex = " \\\\\n".join(f"{name}_{{{k}}} = {sympy.latex(c)}" for name, row in rows.values() for k, c in row)
    data = {"alpha": "symbolic", "order": order, "arithmetic": "symbolic", **asked_besides(options, latex, [])}
    data |= {long: row_to_dict({str(k): Coefficient(None, c) for k, c in row}) for long, (_, row) in rows.items()}
    return Answer(data, latex if options.latex else "\n".join(["symbolic", *lines]), options.json)


def _index(name: str, given: GivenTerms) -> str:
    """F[x'|x'|] as LaTeX: F_{1}, by the place of the force."""
    letter, bracket, force = name.partition("[")
    return letter + (f"_{{{given.names.index(force[:-1]) + 1}}}" if bracket else "")


def _at(options: argparse.Namespace, given: GivenTerms, files: dict[str, Path]) -> Answer:
    """The half-swing at a given strength."""
    if options.exact:
        raise InputError("--exact", "cannot be combined with --delta", "--delta alone: certified digits")
    if options.epsilon is not None:
        raise InputError("--epsilon", "cannot be combined with --delta", "--delta alone: the local strength")
    if options.plot is not None:
        raise InputError("--plot", "one half-swing is no curve", "--plot without --delta: A'/A against delta")
    delta = [parse_real(text, "--delta") for text in options.delta.split(",")]
    found = half_swing_of_terms(given.terms, delta, read_digits(options, MAX_DIGITS))
    names = {"A'/A": "amplitude", "L": "log_ratio", "T": "duration"}
    rows = [(shown, getattr(found, name), *found.enclosures[name]) for shown, name in names.items()]
    lines = [f"{shown:5} {value}" for shown, value, *_ in rows]
    lines.append(f"certified: {str(found.certified).lower()} ({found.route}, {found.terms} terms, tail {found.tail})")
    latex = ",\\quad ".join(f"{shown} = {value}" for shown, value, *_ in rows)
    written = write_files(
        files, {"--csv": lambda _: csv_text(["quantity", "value", "low", "high"], rows)}, options, "half-swing"
    )
    data = {**found.to_dict(), "notes": list(given.notes), **asked_besides(options, latex, written)}
    return Answer(data, latex if options.latex else "\n".join([*lines, *given.notes, *written]), options.json)
