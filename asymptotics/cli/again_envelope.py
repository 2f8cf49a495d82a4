"""An exported envelope beside the averaged law itself, certified at the times of its rows.

>>> header = ["tau", "amplitude", "phase", "code"]
>>> rows = [(2, ["0.0", "1.0", "0.0", ""]), (3, ["3.0", "0.8870541", "0.1924054", ""])]
>>> request = {"law": "2:1/10", "spring": "3:1/5", "time": "3", "points": "1"}
>>> [(row.key, row.marked, row.certified) for row in compared_envelope(request, header, rows, 9).rows[2:]]
[('3', '0.8870541', '0.887054138'), ('3', '0.1924054', '0.192405434')]
"""

from collections.abc import Mapping
from importlib import import_module
from types import MappingProxyType

from asymptotics.api.envelope_table import certified_row, table_head, table_times
from asymptotics.api.large import MAX_DIGITS as MAX_SPRING_DIGITS
from asymptotics.api.large import SpringEnvelope
from asymptotics.ask.answers import read_points
from asymptotics.ask.registry import loaded
from asymptotics.cli.swept import typed_options
from asymptotics.comparison.cells import Cells, cells_so_far, compared_cells
from asymptotics.comparison.run import Comparison
from asymptotics.cut_short import changed
from asymptotics.errors import InputError
from asymptotics.numbers.double_error import DoubleError
from asymptotics.sweeps.grid import Point

_METHOD = "the averaged law of first order (not the motion), at {} digits"


def compared_envelope(
    request: Point,
    header: list[str],
    rows: list[tuple[int, list[str]]],
    digits: int,
    doubles: Mapping[str, DoubleError] = MappingProxyType({}),
) -> Comparison:
    """A and phi of the request at its own times; an error that cuts the work short carries the rows that are done.

    InputError for an order above the first, which is formal.
    """
    if "order" in request:
        raise InputError("FILE", "no route certifies an envelope of higher order: formal series", "the first order")
    options = typed_options("envelope", request)
    asked = loaded("envelope").of_options(options)
    time = asked["time"]
    if time is None or not time > 0:
        raise InputError("--time", "there is no stretch of time", "a time > 0")
    found = import_module("asymptotics.ask.questions.envelope").curve_of(asked["law"], asked["squaring"])
    if isinstance(found, SpringEnvelope):
        digits = min(digits, MAX_SPRING_DIGITS)
    names, times = table_head(found), table_times(time, read_points(options))
    made = list[tuple[str, ...]]()

    def right() -> Cells:
        return Cells((*names, "code"), tuple(made), names[:1], frozenset({"code"}), method=_METHOD.format(digits))

    def so_far() -> Comparison | None:
        return cells_so_far(rows, header, right(), digits, doubles)

    # What an inner computation has done of one row is no row; the rows before it are.
    with changed(lambda _: so_far(), otherwise=so_far):
        for t in times:
            # At the shortest decimal of the double, which is what the file has in its first column and what a reader of
            # it means.
            made.append((repr(float(t)), *certified_row(found, repr(float(t)), digits), ""))
    return compared_cells(rows, header, right(), digits, doubles=doubles)
