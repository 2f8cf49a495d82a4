"""An exported sweep beside itself: each row again at its own parameters, and the rows that are done kept.

What no route certifies is not judged; a motion is held against the certified motion instead.

>>> rows = [(2, ["2", "0.50000", "1/2", "", ""])]
>>> found = compared_sweep("moment", ["p"], ["p", "value", "exact", "failed", "code"], rows, 12)
>>> [(row.key, row.column, row.marked, row.certified) for row in found.rows]
[('2', 'value', '0.50000', '0.500000000000'), ('2', 'exact', '1/2', '1/2')]
"""

from typing import Any

from asymptotics.cli.swept import EXCLUDED, SWEPT, point_options, run_point, takes_no_value
from asymptotics.comparison.cells import Cells, cells_so_far, compared_cells, same
from asymptotics.comparison.run import Comparison
from asymptotics.cut_short import changed
from asymptotics.errors import InputError, shown
from asymptotics.sweeps.export import flat
from asymptotics.sweeps.grid import Point

Rows = list[tuple[int, list[str]]]
_TOLD = frozenset((  # parts of a sweep's results that are bounds, provenance or pictures of numbers
    "latex", "method", "route", "error", "tail", "radius", "digits", "terms", "notes", "enclosures", "certified",
    "low", "high", "units", "x_unit", "what", "files", "gauge", "order", "stable",
))  # fmt: skip
# Words of ``arithmetic``, where an answer has no field ``certified``.
_CERTIFIED = ("exact", "certified")
_EXACT_COMMANDS = ("smith", "moment")  # rational arithmetic; a quotient of Gamma functions in balls


def swept_names(words: list[str], header: list[str]) -> tuple[str, list[str]]:
    """The command of a sweep and its parameters; InputError, by name, for any other word."""
    command, names = words[1], words[2:]
    if command not in SWEPT:
        raise InputError("FILE", f"its header names no command that is swept: {shown(command)}", ", ".join(SWEPT))
    for name in names:
        if name not in header or name.partition(".")[0] in EXCLUDED:
            raise InputError("FILE", f"its header names {shown(name)}, no parameter of it", "the columns of parameters")
    return command, names


def compared_sweep(command: str, names: list[str], header: list[str], rows: Rows, digits: int) -> Comparison:
    """Each row again; a row that failed, or that no route certifies, holds estimates.

    An error that cuts the work short carries the rows that are done.
    """
    # A motion of order N is an expansion: x and v are held against the certified motion, and its amplitude and phase,
    # which depend on gauge and order, against nothing.
    motion = command == "motion"
    kept = {"x", "v"} if motion else set(header)
    apart = {n for n in header if n not in names and (n not in kept or set(n.split(".")) & _TOLD or n == "failed")}
    apart |= {"code"}
    route = "the certified motion at each row" if motion else f"{command} again at each row, at {digits} digits"
    found, unsure = list[tuple[str, ...]](), set[tuple[str, ...]]()

    def right() -> Cells:
        return Cells(tuple(header), tuple(found), tuple(names), frozenset(apart), frozenset(unsure), route)

    def so_far() -> Comparison | None:
        return cells_so_far(rows, header, right(), digits)

    with changed(lambda _: so_far(), otherwise=so_far):  # what is done of one row is no row of the comparison
        for line, cells in rows:
            if len(cells) != len(header):
                raise InputError("FILE", f"line {line} has {len(cells)} cells", f"{len(header)} cells in each row")
            row = dict(zip(header, cells))
            # A row that failed then may succeed now, for want of time or memory: there is nothing in it to judge.
            result = _of_row(command, {name: row[name] for name in names}, digits) if not row.get("failed") else None
            if result is None:
                unsure.add(tuple(same(row[name].strip()) for name in names))
            found.append(tuple(row[name] if name in names else (result or {}).get(name, "") for name in header))
    return compared_cells(rows, header, right(), digits)


def _of_row(command: str, row: dict[str, str], digits: int) -> dict[str, str] | None:
    """What the command says at the parameters of a row, flat; None where that is not certified."""
    data = run_point(command, _again(command, row, digits))
    return flat(data) if is_certified(command, data) else None


def _again(command: str, row: dict[str, str], digits: int) -> Point:
    """The point of a row: flags stand in empty cells, numbers are proved to be such."""
    flags = {name: "" for name in row if name and takes_no_value(command, name.partition(".")[0])}
    point = {**point_options(command, {name: cell for name, cell in row.items() if name not in flags}), **flags}
    if command == "motion":
        # These say of which expansion the row is; the reference has none of them.
        point = {name: value for name, value in point.items() if name not in ("order", "gauge", "best-order")}
        point["reference"] = ""
    # Exact fractions: ``smith`` refuses --digits there.
    if command == "smith" and point.get("") in ("f", "c", "g"):
        return point
    return {**point, "digits": str(digits)}


def is_certified(command: str, data: dict[str, Any]) -> bool:
    """What the answer itself says; exact arithmetic is."""
    said = data.get("certified")
    return said is True or (said is None and (data.get("arithmetic") in _CERTIFIED or command in _EXACT_COMMANDS))
