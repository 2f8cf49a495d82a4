"""Reference tables, exact or certified, with their provenance.

asymptotics table --list
asymptotics table smith2012.table1 --digits 40 [--format text|csv|latex]
"""

import argparse

from asymptotics.cli.answer import Answer, add_digits, add_json, read_digits
from asymptotics.errors import InputError
from asymptotics.tables import Table, build, names
from asymptotics.tables.registry import MAX_DIGITS


def configure(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("name", nargs="?", metavar="NAME", help="which table; --list shows them")
    parser.add_argument("--list", action="store_true", help="list the tables")
    parser.add_argument("--format", choices=("text", "csv", "latex"), default="text", help="how to print it")
    add_digits(parser, MAX_DIGITS)
    add_json(parser)


def run(options: argparse.Namespace) -> Answer:
    """Run the command."""
    digits = read_digits(options, MAX_DIGITS)
    if options.list:
        if options.name is not None:
            raise InputError("NAME", "--list shows all tables", "--list alone, or a name without it")
        width = max(map(len, names())) + 2
        text = "\n".join(f"{name:{width}}{title}" for name, title in names().items())
        return Answer({"tables": names()}, text, options.json)
    if options.name is None:
        raise InputError("NAME", "is missing", ", ".join(names()))
    table = build(options.name, digits)
    printed = {"csv": Table.to_csv, "latex": Table.to_latex, "text": _text}[options.format](table)
    return Answer(table.to_dict(), printed.rstrip("\n"), options.json)


def _text(table: Table) -> str:
    widths = [max(map(len, column)) for column in zip(table.columns, *table.rows)]
    lines = ["  ".join(c.rjust(w) for c, w in zip(row, widths)) for row in (table.columns, *table.rows)]
    return "\n".join([table.title, "", *lines, "", table.provenance])
