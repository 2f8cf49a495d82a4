"""Reference tables with provenance."""

import argparse
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Annotated, Any

from asymptotics.ask.answers import Offers, Request
from asymptotics.ask.forces import read_law
from asymptotics.ask.kinds import SECONDS, Kind, Option, choice, digits, whole
from asymptotics.ask.pairs import excludes, needs
from asymptotics.ask.question import question
from asymptotics.errors import InputError
from asymptotics.law import Law, LawLike
from asymptotics.law_given import law_of
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number, exact_number
from asymptotics.numbers.rounding import MODES
from asymptotics.present.files import target_file, write_atomically
from asymptotics.sweeps.grid import values
from asymptotics.tables import registry
from asymptotics.tables.inputs import MAX_ROWS, Inputs
from asymptotics.tables.table import Table

FORMATS = ("text", "csv", "json", "latex", "parquet")


def _name(value: Any, name: str) -> str:
    if not isinstance(value, str):
        raise InputError(name, f"a {type(value).__name__} is no name", ", ".join(registry.names()))
    return value


def _listed(value: Any, name: str) -> tuple[ExactReal, ...]:
    """One number or several: a list, or a text with commas and ranges start:stop:step."""
    several = values(value, name) if isinstance(value, str) else value if isinstance(value, list | tuple) else (value,)
    return tuple(exact_number(each, name) for each in several)


def _sum_of_options(options: argparse.Namespace) -> Law | None:
    if not options.law:
        return None
    return read_law(argparse.Namespace(alpha=None, epsilon=None, law=options.law), "epsilon")


NAME = Kind("NAME", _name, place=True, words=True)
NUMBERS = Kind("LIST", _listed, group="the law")
SUM = Kind(
    "A:E", lambda value, _: law_of(value), group="the law", assemble=_sum_of_options,
    options=(Option("law", "A:E", "one term of a sum; repeat it", "the law", repeated=True),),
    pairs=(excludes("law", "alpha epsilon", "it stands next to --alpha or --epsilon", "one or the other"),),
)  # fmt: skip


def _form(request: Request) -> tuple[str, Path | None]:
    """The form of the table and its file: --latex and --csv FILE are names of --format and --output."""
    latex, csv = request.typed("latex"), request.typed("csv")
    form, output = request.typed("format"), request.typed("output")
    form = "csv" if csv is not None else "latex" if latex is not None else form or "text"
    if form not in FORMATS:
        raise InputError("--format", f"{form[:40]!r} is no format", ", ".join(FORMATS))
    name = csv or output
    return form, None if name is None else target_file(name, "--csv" if csv else "--output")


def _show(request: Request) -> Callable[[Table], tuple[dict[str, Any], str]]:
    form, target = _form(request)

    def show(table: Table) -> tuple[dict[str, Any], str]:
        validation = table.validate() if request.typed("validate") is not None else None
        told = "" if validation is None else f"\n{validation.beside()}\n{validation}"
        more = {} if validation is None else {"validation": validation.to_dict()}
        if target is None:
            return table.to_dict() | more, _printed(table, form) + told
        write_atomically(target, _content(table, form), "--output")
        return {**table.to_dict(), "output": str(target)} | more, f"written: {target}{told}"

    return show


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


def _list(request: Request) -> tuple[dict[str, Any], str] | None:
    if request.typed("list") is None:
        if request["name"] == "":
            raise InputError("NAME", "is missing", ", ".join(registry.names()))
        return None
    lines = []
    for name in registry.names():
        found = registry.description(name)
        units = (f"{c} [{u}]" if u else c for c, u in zip(found["columns"], found["units"]))
        options = " ".join(f"--{use}" for use in found["uses"].split()) or "none"
        lines += [
            f"{name}: {found['title']}", f"  columns: {', '.join(units)}", f"  route:   {found['source']}",
            f"  check:   {found['check']}", f"  cost:    {found['cost']}", f"  options: {options}", "",
        ]  # fmt: skip
    return {"tables": {n: registry.description(n) for n in registry.names()}}, "\n".join(lines).rstrip("\n")


def _missing(table: Table, _: Request) -> tuple[int, str]:
    last = ", ".join(f"{key} = {table.rows[-1][table.columns.index(key)]}" for key in table.keys)
    return len(table.rows), f"what comes after {last}"


@question(
    Offers(
        latex="as --format latex",
        formula=lambda *_: "",
        picture="its columns of numbers against its key",
        table="the table with its provenance (as --format csv --output FILE)",
        more=(
            Option("list", "", "what each table is: columns, units, routes, cost, options"),
            Option("validate", "", "recomputed by mpmath alone, to 60 digits: which numbers are equal"),
            Option("format", "FORMAT", f"{', '.join(FORMATS)} (default: the first)", "output", words=FORMATS),
            Option("output", "FILE", "write it to a file, with its provenance", "output"),
        ),
        own_latex=True,
        failed=lambda table, request: request.typed("validate") is not None and not table.validate().equal,
        instead=_list,
        show=_show,
        certificate=lambda table, _: table.certificate(),
        missing=_missing,
        lacks={"gauge": "a table says in its title which gauge it is in", "points": "`--rows` says how many"},
    ),
    # Two forms of one table: which of them was meant is not guessed.
    pairs=(
        excludes("csv", "format output latex", "it stands next to {other}", "one form of the table"),
        excludes("latex", "format", "it stands next to {other}", "one form of the table"),
        needs("format=parquet", "output", "parquet is not text", "--output FILE with it"),
    ),
    example="moments --alpha 1 --digits 5",
    rests="what each table says of its route (`asymptotics table --list`)",
)
def table(
    name: Annotated[str, NAME] = "",
    *,
    alpha: Annotated[Number | Sequence[Number] | None, NUMBERS] = None,
    epsilon: Annotated[Number | Sequence[Number] | None, NUMBERS] = None,
    law: Annotated[LawLike | None, SUM] = None,
    rows: Annotated[int | None, whole(1, MAX_ROWS)] = None,
    rounding: Annotated[str, choice(*MODES, letter="MODE")] = "nearest",
    digits: Annotated[int, digits(registry.MAX_DIGITS)] = 30,
    max_seconds: Annotated[Number, SECONDS] = 60,
) -> Table:
    """Reference tables, exact or certified, with their provenance.

      asymptotics table --list
      asymptotics table smith2012.table1 --epsilon 1/2 --rows 20 --digits 40
      asymptotics table turning-points --law 0:1/20 --law 3/2:1/10 --rows 8 --format csv --output points.csv
      asymptotics table moments --alpha 0:4:1/4 --digits 12 --rounding interval --format latex

    --alpha and --epsilon take comma lists and ranges start:stop:step.  Roundings: nearest (ties to even), down (toward
    zero), up (away from zero), floor, ceil, interval (both ends).  Every file carries inputs, versions, commit and
    SHA-256.

    Parameters
    ----------
    name
        which table; --list (``table_names()``) shows them
    alpha
        exponents: 0,1/2,2 or 0:4:1/4
    epsilon
        strengths (u_0 for Smith's tables)
    law
        one sum, as a law or mapping exponent -> strength
    rows
        how many rows (of each law), or the order
    rounding
        how values are rounded
    digits
        significant digits, correctly rounded
    max_seconds
        the time the request may take, in seconds

    Raises
    ------
    InputError
        for a name that no table has, and for what changes nothing in the table
    LimitError
        with the estimate; the rows that were done are kept (``asymptotics.running.cut_short.done``)

    Examples
    --------
    >>> table("turning-points", law={0: "1/20", "3/2": "1/10"}, rows=2, digits=6).rows[1][2]
    '-0.779510'
    """
    return registry.build(name, digits, Inputs.read(alpha, epsilon, law, rows), rounding)
