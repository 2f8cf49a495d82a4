"""One's own values beside certified ones: right digits, wrong digits marked, and what the errors look like.

  asymptotics compare mine.csv --alpha 2 --epsilon 1/10 --columns n,x,tau
  asymptotics compare motion.csv --law 0:1/20 --law 2:1/10 --columns tau=time,x=pos --plot lost.svg
  asymptotics compare table_one.csv --table smith2012.table1 --columns half_cycle,S_hat,u
  asymptotics compare exported.csv                           # a table of this program says itself what it is
  asymptotics compare points.csv                             # so does a file of --csv: its header has the oscillator
  asymptotics compare cycle.csv                              # and one of damping, envelope, stokes, smith or a sweep
  asymptotics compare series.csv --alpha 3/2                 # coefficients from expand --csv or half-swing --csv
  asymptotics compare lab.csv --alpha 3/2 --damping 1/10 --mass 3/2 --stiffness 30 --x0 1/5 --columns t,x

FILE is CSV; an exported sweep may be JSON or Parquet.  A row is a turning point (n, with x, amplitude, tau or t),
a moment (tau or t, with x or v) or a moment of an envelope (tau or t, with amplitude or phase: the averaged law).
With --damping, --mass or --stiffness the file is in m, s and m/s, --law gives b, and --epsilon is still the
dimensionless strength b omega_0^alpha x0^(alpha-1)/k; without them nothing has a unit (tau = omega_0 t), and x is X.
digits is -log10 of the relative error: 0 for a wrong sign, at most what the certified value has.
"""

import argparse
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path

from asymptotics.ask.forces import add_forces, read_law
from asymptotics.ask.moving import PHYSICAL, add_physical, add_start, read_oscillator
from asymptotics.cli.again import asked_again, compare_again, is_motion, told_request
from asymptotics.cli.answer import Answer, add_common, shortened
from asymptotics.cli.files import add_csv, add_plot, picture_maker, read_files, write_files
from asymptotics.comparison.order import told_order
from asymptotics.comparison.run import MAX_DIGITS, ComparedValue, Comparison, compare_file
from asymptotics.comparison.stated import stated
from asymptotics.comparison.tabled import compare_table, series_table
from asymptotics.errors import InputError
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_integer
from asymptotics.present.files import require_different
from asymptotics.present.inputs import stated_inputs
from asymptotics.sweeps.grid import values
from asymptotics.tables.inputs import Inputs
from asymptotics.tables.registry import names

# Lines that fill a screen: half from the head of the file, half the worst.
_SHOWN = 40


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("file", metavar="FILE", help="a CSV file of values")
    add_forces(parser, "epsilon", "E", "its dimensionless strength, b omega_0^alpha x0^(alpha-1) / k", springs=False)
    add_physical(parser)
    add_start(parser)
    parser.add_argument("--table", metavar="NAME", help="compare with this table instead (asymptotics table --list)")
    parser.add_argument("--columns", metavar="LIST", help="n,x,tau or n=index,x=pos: which column is what")
    parser.add_argument("--digits", metavar="D", help="digits of the certified values (default: four more than yours)")
    add_plot(parser, "digits lost against time")
    add_csv(parser, "all rows")
    add_common(parser)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    files = read_files(options)
    # --csv must not overwrite the file that is read, be it through a link.
    require_different({"FILE": Path(options.file), **files})
    digits = None if options.digits is None else parse_integer(options.digits, "--digits", 1, MAX_DIGITS)
    make, equation = _asked(options, digits)
    return _answer(options, files, make(), equation)


def cut_short(options: argparse.Namespace, found: Comparison) -> Answer:
    """The rows that were done when the time was over."""
    answer = _answer(options, read_files(options), found, _asked(options, None)[1])
    return shortened(answer, len({row.line for row in found.rows}), found.summary["missing"])


def _answer(options: argparse.Namespace, files: dict[str, Path], found: Comparison, equation: str) -> Answer:
    """The answer that is printed, after its files are written."""
    write_files(files, {"--plot": picture_maker(options, lambda: [found]), "--csv": lambda _: found.to_csv()})
    beside = "law" if options.table is None else "table"
    return Answer({beside: equation, **found.to_dict()}, _text(found, equation), options.json)


def _asked(options: argparse.Namespace, digits: int | None) -> tuple[Callable[[], Comparison], str]:
    """The comparison, still to be made, and what the values are held against."""
    path = Path(options.file)
    head = stated(path)
    # From what is most certain to what is asked: the head of a table names itself and its inputs; a header names its
    # whole request; coefficients are known by their columns; a header names an oscillator; the options say it.  What
    # the command says itself goes before what the file says.
    if options.table is None and head is not None and head.table in names() and not _said(options):
        law = list(head.law) or None
        inputs = Inputs.read(None, None, _sum(law)) if law else Inputs.of(head.alphas, None, head.epsilons)
        make = partial(compare_table, path, head.table, replace(inputs, rows=head.rows))
        return partial(make, columns=options.columns, digits=digits), f"{head.table}, with the inputs of its head"
    if options.table is None and not _said(options) and asked_again(path):
        if options.columns is not None:
            raise InputError("--columns", "a file that names its own request has its own columns", "no --columns")
        return partial(compare_again, path, digits), told_request(path)
    name = series_table(path) if options.table is None else options.table
    if not _said(options) and options.table is None:
        options = _with_its_inputs(options, path, series=name is not None)
    if name is None:
        given = read_oscillator(options, "epsilon", epsilon_beside_units=True)
        # A start that was given makes x a length of its own; otherwise x is in units of x0, as the law alone has it.
        own = given.si or options.x0 is not None or getattr(options, "v0", None) is not None
        make = partial(compare_file, path, given.oscillator, si=own)
        told = str(given.oscillator) if own else str(given.oscillator.law)
        return partial(make, columns=options.columns, digits=digits), told
    for option in (*PHYSICAL, "x0"):
        if getattr(options, option) is not None:
            raise InputError(f"--{option}", "a table has its own units", "no such option with a table")
    if options.table is None and not (options.alpha or options.law):
        raise InputError("--alpha", "is missing: coefficients alone do not say of which law", "--alpha A, or --law A:E")
    if options.law and (options.alpha is not None or options.epsilon is not None):
        raise InputError("--law", "it stands next to --alpha or --epsilon", "one or the other")
    inputs = Inputs.read(
        None if options.alpha is None else values(options.alpha, "--alpha"),
        None if options.epsilon is None else values(options.epsilon, "--epsilon"),
        _sum(options.law) if options.law else None,
    )
    return partial(compare_table, path, name, inputs, columns=options.columns, digits=digits), name


def _sum(laws: list[str]) -> Law:
    return read_law(argparse.Namespace(alpha=None, epsilon=None, law=laws), "epsilon")


def _with_its_inputs(options: argparse.Namespace, path: Path, *, series: bool) -> argparse.Namespace:
    """The options, with the oscillator that the file's own header says; coefficients have their exponents alone."""
    inputs = stated_inputs(path)
    if "static" in inputs:
        reason = (
            f"it is a motion with --static={inputs['static']}, and its law alone does not hold the mass where it turns"
        )
        raise InputError("FILE", reason, "a motion without --static")
    special = next((name for name in ("spring", "v0") if inputs.get(name, "0") != "0"), None)
    # Points and coefficients of such an oscillator depend on more than INPUTS: they need the request itself.
    if special and not is_motion(path):
        reason = f"it is of an oscillator with --{special}, and its header does not name the request"
        raise InputError("FILE", reason, "a motion, or turning points written by --csv of this version")
    kept = {k: v for k, v in inputs.items() if k in ("alpha", "law") or not series}
    return argparse.Namespace(**{**vars(options), **kept})


def _said(options: argparse.Namespace) -> bool:
    """Whether the command itself says what the values are of."""
    return any(getattr(options, name) is not None for name in (*PHYSICAL, "alpha", "epsilon", "law", "x0"))


def _text(found: Comparison, equation: str) -> str:
    summary, look = found.summary, found.summary["look"]
    rows = found.rows
    if len(rows) > _SHOWN:
        # Fewest right digits first; in the order of the file when they are shown.
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
        *([order] if (order := told_order(summary.get("order", {}))) else []),
        f"the errors look like {look['kind']}: {look['reason']}",
        *([summary["ended"]] if "ended" in summary else []),
        *summary.get("differs", ()),
        *([f"doubles, right within the errors of the header: {', '.join(d)}"] if (d := summary.get("doubles")) else []),
        *([f"estimates, not counted: lines {_listed(summary['estimates'])}"] if "estimates" in summary else []),
        *(f"not compared: {name} ({_why(name)})" for name in summary.get("not_compared", ())),
        f"certified: {str(found.certified).lower()} ({found.method})",
    ]
    return "\n".join(lines)


def _why(name: str) -> str:
    if name in ("amplitude", "phase"):
        return "of a gauge and an order"
    return "of one force of the sum; the table has the sum" if "[" in name else "a bound, a remark or a mark"


def _listed(lines: list[int]) -> str:
    more = f" and {len(lines) - _SHOWN} more" if len(lines) > _SHOWN else ""
    return ", ".join(map(str, lines[:_SHOWN])) + more


def _cells(row: ComparedValue) -> tuple[str, ...]:
    return (str(row.line), row.key, row.column, row.marked, row.certified or "none", row.digits)
