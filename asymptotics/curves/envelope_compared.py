"""An exported envelope beside the averaged law itself, certified at the times of its rows.

>>> header = ["tau", "amplitude", "phase", "code"]
>>> rows = [(2, ["0.0", "1.0", "0.0", ""]), (3, ["3.0", "0.8870541", "0.1924054", ""])]
>>> from asymptotics.curves.slow import envelope
>>> from asymptotics.law import Law
>>> found = envelope(Law({2: "1/10"}, {3: "1/5"}))
>>> [(row.key, row.marked, row.certified) for row in compared_envelope(found, [0.0, 3.0], header, rows, 9).rows[2:]]
[('3', '0.8870541', '0.887054138'), ('3', '0.1924054', '0.192405434')]
"""

from collections.abc import Mapping, Sequence
from types import MappingProxyType

from asymptotics.curves.envelope_table import certified_row, table_head
from asymptotics.curves.large import MAX_DIGITS as MAX_SPRING_DIGITS
from asymptotics.curves.large import SpringEnvelope
from asymptotics.curves.slow import Envelope
from asymptotics.decays.comparison.cells import Cells, cells_so_far, compared_cells
from asymptotics.decays.comparison.run import Comparison
from asymptotics.numbers.double_error import DoubleError
from asymptotics.running.cut_short import changed

_METHOD = "the averaged law of first order (not the motion), at {} digits"


def compared_envelope(
    found: Envelope | SpringEnvelope,
    times: Sequence[float],
    header: list[str],
    rows: list[tuple[int, list[str]]],
    digits: int,
    doubles: Mapping[str, DoubleError] = MappingProxyType({}),
) -> Comparison:
    """A and phi at the times; an error that cuts the work short carries the rows that are done.

    ``doubles``: the errors that the columns may have.
    """
    if isinstance(found, SpringEnvelope):
        digits = min(digits, MAX_SPRING_DIGITS)
    names, made = table_head(found), list[tuple[str, ...]]()

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
