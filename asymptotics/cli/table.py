"""Reference tables, exact or certified, with their provenance.

  asymptotics table --list
  asymptotics table smith2012.table1 --epsilon 1/2 --rows 20 --digits 40
  asymptotics table turning-points --law 0:1/20 --law 3/2:1/10 --rows 8 --format csv --output points.csv
  asymptotics table moments --alpha 0:4:1/4 --digits 12 --rounding interval --format latex

--alpha and --epsilon take comma lists and ranges start:stop:step.  Roundings: nearest (ties to even), down (toward
zero), up (away from zero), floor, ceil, interval (both ends).  Every file carries inputs, versions, commit and SHA-256.
"""

import argparse
from pathlib import Path

from asymptotics.ask.forces import read_law
from asymptotics.cli.answer import Answer, add_common, read_digits, shortened
from asymptotics.cli.files import add_csv, add_plot, picture_maker, read_files, write_files
from asymptotics.errors import InputError
from asymptotics.numbers.exact import parse_integer
from asymptotics.numbers.rounding import MODES, require_mode
from asymptotics.present.files import target_file, write_atomically
from asymptotics.sweeps.grid import values
from asymptotics.tables.inputs import MAX_ROWS, Inputs
from asymptotics.tables.registry import MAX_DIGITS, build, description, names
from asymptotics.tables.table import Table

FORMATS = ("text", "csv", "json", "latex", "parquet")


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("name", nargs="?", metavar="NAME", help="which table; --list shows them")
    parser.add_argument("--list", action="store_true", help="what each table is: columns, units, routes, cost, options")
    parser.add_argument("--alpha", metavar="LIST", help="exponents: 0,1/2,2 or 0:4:1/4")
    parser.add_argument("--epsilon", metavar="LIST", help="strengths (u_0 for Smith's tables)")
    parser.add_argument("--law", action="append", metavar="A:E", help="one term of a sum; repeat it")
    parser.add_argument("--rows", metavar="N", help="how many rows (of each law), or the order")
    parser.add_argument("--rounding", default="nearest", metavar="MODE", help=", ".join(MODES))
    parser.add_argument("--format", metavar="FORMAT", help=f"{', '.join(FORMATS)} (default: the first)")
    parser.add_argument("--latex", action="store_true", help="as --format latex")
    add_plot(parser, "its columns of numbers against its key")
    add_csv(parser, "the table with its provenance (as --format csv --output FILE)")
    parser.add_argument("--output", metavar="FILE", help="write it to a file, with its provenance")
    add_common(parser, MAX_DIGITS)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    if options.list:
        return Answer({"tables": {name: description(name) for name in names()}}, _listed(), options.json)
    # Also in ``cut_short``: there the options are as they were typed.
    options = _spelled_out(options)
    if options.name is None:
        raise InputError("NAME", "is missing", ", ".join(names()))
    if options.format not in FORMATS:
        raise InputError("--format", f"{options.format[:40]!r} is no format", ", ".join(FORMATS))
    require_mode(options.rounding)
    if options.format == "parquet" and options.output is None:
        raise InputError("--format", "parquet is not text", "--output FILE with it")
    target = _target(options)
    inputs = table_inputs(options.alpha, options.epsilon, options.law, options.rows)
    # --csv of a table is --output in CSV, with provenance, and not the file that ``write_files`` makes.
    drawn = read_files(argparse.Namespace(plot=options.plot))
    table = build(options.name, read_digits(options, MAX_DIGITS), inputs, options.rounding)
    return _answer(options, drawn, target, table)


def cut_short(options: argparse.Namespace, table: Table) -> Answer:
    """The rows that were done when the time was over."""
    options = _spelled_out(options)
    target, drawn = _target(options), read_files(argparse.Namespace(plot=options.plot))
    last = ", ".join(f"{key} = {table.rows[-1][table.columns.index(key)]}" for key in table.keys)
    return shortened(_answer(options, drawn, target, table), len(table.rows), f"what comes after {last}")


def _target(options: argparse.Namespace) -> Path | None:
    """The file of --output, or of --csv."""
    return None if options.output is None else target_file(options.output, "--csv" if options.csv else "--output")


def _answer(options: argparse.Namespace, drawn: dict[str, Path], target: Path | None, table: Table) -> Answer:
    """The answer that is printed, after its files are written."""
    pictures = write_files(drawn, {"--plot": picture_maker(options, lambda: [table])})
    if target is None:
        text = "\n".join([_printed(table, options.format), *pictures])
        return Answer(table.to_dict(), text, options.json)
    write_atomically(target, _content(table, options.format), "--output")
    return Answer({**table.to_dict(), "output": str(target)}, f"written: {target}", options.json)


def _spelled_out(options: argparse.Namespace) -> argparse.Namespace:
    """--latex and --csv FILE, the names these have in every command, as --format and --output."""
    asked = {"--latex": "latex" if options.latex else None, "--csv": None if options.csv is None else "csv"}
    asked = {name: form for name, form in asked.items() if form is not None}
    others = {"--format": options.format, "--output": options.output if options.csv is not None else None}
    clash = [name for name, value in others.items() if value is not None]
    # Two forms of one table: which of them was meant is not guessed.
    if len(asked) > 1 or asked and clash:
        other = clash[0] if clash else "--latex"
        raise InputError([*asked][-1], f"it stands next to {other}", "one form of the table")
    spelled = vars(options) | {"format": next(iter(asked.values()), options.format or "text")}
    return argparse.Namespace(**spelled | {"output": options.output if options.csv is None else options.csv})


def table_inputs(alpha: str | None, epsilon: str | None, laws: list[str] | None, rows: str | None) -> Inputs:
    """What a table is asked for, from the texts of the options; InputError as they say."""
    alphas = () if alpha is None else values(alpha, "--alpha")
    epsilons = () if epsilon is None else values(epsilon, "--epsilon")
    count = None if rows is None else parse_integer(rows, "--rows", 1, MAX_ROWS)
    if laws and (alphas or epsilons):
        raise InputError("--law", "it stands next to --alpha or --epsilon", "one or the other")
    law = read_law(argparse.Namespace(alpha=None, epsilon=None, law=laws), "epsilon") if laws else None
    return Inputs.of(alphas, law, epsilons, count)


def _printed(table: Table, form: str) -> str:
    printed = {"csv": Table.to_csv, "latex": Table.to_latex, "json": Table.to_json, "text": Table.to_text}[form](table)
    return printed.rstrip("\n")


def _content(table: Table, form: str) -> str | bytes:
    if form == "parquet":
        return table.to_parquet()
    if form == "csv":
        return table.to_csv_file()
    if form == "text":
        return table.to_text() + "\n\n" + "".join(f"{k}: {v}\n" for k, v in table.provenance.items() if k != "source")
    return _printed(table, form) + "\n"


def _listed() -> str:
    lines = []
    for name in names():
        found = description(name)
        units = (f"{c} [{u}]" if u else c for c, u in zip(found["columns"], found["units"]))
        options = " ".join(f"--{use}" for use in found["uses"].split()) or "none"
        lines += [
            f"{name}: {found['title']}", f"  columns: {', '.join(units)}", f"  route:   {found['source']}",
            f"  check:   {found['check']}", f"  cost:    {found['cost']}", f"  options: {options}", "",
        ]  # fmt: skip
    return "\n".join(lines).rstrip("\n")
