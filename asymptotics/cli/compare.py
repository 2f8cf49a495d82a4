"""One's own values beside certified ones: right digits, wrong digits marked, and what the errors look like.

  asymptotics compare mine.csv --alpha 2 --epsilon 1/10 --columns n,x,tau
  asymptotics compare motion.csv --law 0:1/20 --law 2:1/10 --columns tau=time,x=pos --plot lost.svg
  asymptotics compare table_one.csv --table smith2012.table1 --columns half_cycle,S_hat,u
  asymptotics compare lab.csv --alpha 3/2 --damping 1/10 --mass 3/2 --stiffness 30 --x0 1/5 --columns t,x

FILE is CSV.  A row is a turning point (n, with x, amplitude, tau or t) or a moment (tau or t, with x or v).
Without an oscillator everything is dimensionless (X = x/x0, tau = omega_0 t); with --mass, --stiffness or --x0 the file
is in m, s and m/s, --damping and --law give b in SI, and --epsilon is still the dimensionless strength.
digits is -log10 of the relative error: 0 for a wrong sign, at most what the certified value has.
"""

import argparse
from fractions import Fraction
from pathlib import Path
from typing import Any

from asymptotics.cli.answer import Answer, add_json, add_max_seconds
from asymptotics.cli.files import add_csv, read_files, write_files
from asymptotics.cli.forces import add_forces, read_law
from asymptotics.cli.table import table_inputs
from asymptotics.comparison.picture import picture_of
from asymptotics.comparison.run import MAX_DIGITS, Comparison, Row, compare_file
from asymptotics.comparison.tabled import compare_table
from asymptotics.errors import InputError
from asymptotics.law import Oscillator
from asymptotics.numbers.exact import ExactReal, parse_integer, parse_real
from asymptotics.present.files import require_different

_SHOWN = 40
_SI = ("mass", "stiffness", "x0")


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("file", metavar="FILE", help="a CSV file of values")
    add_forces(parser, "epsilon", "E", "its dimensionless strength, b omega_0^alpha x0^(alpha-1) / k", springs=False)
    parser.add_argument("--damping", metavar="B", help="its strength b in SI, in place of --epsilon")
    for name, unit in zip(_SI, ("m in kg", "k in N/m", "x(0) in m")):
        parser.add_argument(f"--{name}", metavar="V", help=f"{unit} (default 1): the file is in SI")
    parser.add_argument("--table", metavar="NAME", help="compare with this table instead (asymptotics table --list)")
    parser.add_argument("--columns", metavar="LIST", help="n,x,tau or n=index,x=pos: which column is what")
    parser.add_argument("--digits", metavar="D", help="digits of the certified values (default: four more than yours)")
    parser.add_argument("--plot", metavar="FILE", help="digits lost against time: .svg or .png")
    add_csv(parser, "all rows")
    add_max_seconds(parser)
    add_json(parser)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    files = read_files(options)
    require_different({"FILE": Path(options.file), **files})
    digits = None if options.digits is None else parse_integer(options.digits, "--digits", 1, MAX_DIGITS)
    found, equation = _compared(options, digits)
    write_files(files, {"--plot": lambda kind: picture_of(found, kind), "--csv": lambda _: found.to_csv()})
    beside = "law" if options.table is None else "table"
    return Answer({beside: equation, **found.to_dict()}, _text(found, equation), options.json)


def _compared(options: argparse.Namespace, digits: int | None) -> tuple[Comparison, str]:
    """The comparison, and what the values were held against."""
    path = Path(options.file)
    if options.table is None:
        oscillator, si = _oscillator(options)
        found = compare_file(path, oscillator, columns=options.columns, digits=digits, si=si)
        return found, str(oscillator) if si else str(oscillator.law)
    for name in ("damping", *_SI):
        if getattr(options, name) is not None:
            raise InputError(f"--{name}", "a table has its own units", "no such option with --table")
    inputs = table_inputs(options.alpha, options.epsilon, options.law, None)
    return compare_table(path, options.table, inputs, columns=options.columns, digits=digits), options.table


def _oscillator(options: argparse.Namespace) -> tuple[Oscillator, bool]:
    """The oscillator, and whether the file is in SI."""
    texts = {name: getattr(options, name) for name in _SI if getattr(options, name) is not None}
    given: dict[str, Any] = {name: parse_real(text, f"--{name}") for name, text in texts.items()}
    if options.damping is not None:
        if options.epsilon is not None:
            raise InputError("--damping", "it stands next to --epsilon", "one strength: b in SI, or epsilon")
        if not given:
            raise InputError("--damping", "it is in SI", "--mass, --stiffness and --x0, or --epsilon instead")
        return Oscillator(read_law(options, "damping"), **given), True
    law = read_law(options, "epsilon")
    if not given:
        return Oscillator(law), False
    unit = Oscillator(law, **given)
    return (unit if options.law else _with_epsilon(unit)), True


def _with_epsilon(unit: Oscillator) -> Oscillator:
    """The oscillator whose dimensionless strength is what stands in ``unit`` as b; InputError if its b is no root."""
    (term,) = unit.law.terms
    epsilon = term.strength
    scale = unit.units.scale(ExactReal(Fraction(1)), term.velocity, term.weight)
    if not isinstance(scale, ExactReal) or not isinstance(epsilon, ExactReal):
        reason = f"the b of epsilon = {epsilon} is no exact number for this mass, stiffness and x0"
        raise InputError("--epsilon", reason, "--damping B, or a file without units")
    return unit.with_law({term.velocity: epsilon / scale})


def _text(found: Comparison, equation: str) -> str:
    summary, look = found.summary, found.summary["look"]
    rows = found.rows
    if len(rows) > _SHOWN:
        worst = set(sorted(range(len(rows)), key=lambda i: float(rows[i].digits))[: _SHOWN // 2])
        rows = tuple(row for i, row in enumerate(rows) if i < _SHOWN // 2 or i in worst)
    cells = [("line", found.rows[0].key_name, "column", "given", "certified", "digits"), *map(_cells, rows)]
    widths = [max(map(len, column)) for column in zip(*cells)]
    lines = [equation, "", *("  ".join(c.rjust(w) for c, w in zip(row, widths)) for row in cells)]
    if len(rows) < len(found.rows):
        lines.append(f"({len(found.rows)} values: the first {_SHOWN // 2} and the worst ones; --csv or --json for all)")
    lines += [
        "",
        f"right digits: worst {summary['worst_digits']} (line {summary['worst_line']}), "
        f"median {summary['median_digits']}, best {summary['best_digits']}; "
        f"{summary['all_right']} of {summary['values']} values are right in every digit written",
        f"the errors look like {look['kind']}: {look['reason']}",
        *([summary["ended"]] if "ended" in summary else []),
        f"certified: {str(found.certified).lower()} ({found.method})",
    ]
    return "\n".join(lines)


def _cells(row: Row) -> tuple[str, ...]:
    return (str(row.line), row.key, row.column, row.marked, row.certified or "none", row.digits)
