"""A file with one number in each line: samples without times, whose clock ``rates`` finds or the caller says.

>>> one_column(["start, sample_rate", "90, 1000", *["31.5"] * 12])
OneColumn(rows=12, decimal='.', header=(), start=2, sure=True)
>>> one_column(["# angle (deg)", *["31,5"] * 12]).header, one_column(["t,x", "0,1", "1,2"]) is None
(('angle (deg)',), True)
>>> one_column(12 * ["0,05", "1,25"]).decimal                       # two columns of whole numbers have no 05
','
"""

import re
from collections.abc import Sequence
from typing import NamedTuple

from asymptotics.decays.records.cells import MISSING, number
from asymptotics.decays.records.lines import COMMENT, is_comment

_LEAST, _SHARE = 10, 0.9
"""Lines of one number that are a column; and the share of the lines from the first of them on."""
_TWO = re.compile(r"[+-]?\d*,0\d+")
_NAME = re.compile(r"[^,;:=\t|]*[^\W\d_][^,;:=\t|]*")


class OneColumn(NamedTuple):
    """How many lines hold one number, with which mark, the name above them and the line at which they begin; ``sure``:
    whether no two columns can be meant, as by 0,05."""

    rows: int
    decimal: str
    header: tuple[str, ...]
    start: int
    sure: bool = True


def one_column(lines: Sequence[str], decimal: str | None = None, skip: int = 0) -> OneColumn | None:
    """What the lines are, if nearly all of them from some line on hold one number each; None else."""
    found = []
    for mark in (decimal,) if decimal else (".", ","):
        places = [i for i, line in enumerate(lines) if i >= skip and _is_single(line, mark)]
        filled = [i for i in range(places[0], len(lines)) if not is_comment(lines[i])] if places else []
        if len(places) >= max(_LEAST, _SHARE * len(filled)):
            sure = mark in (".", decimal) or any(_TWO.fullmatch(lines[i].strip()) for i in places)
            found.append(OneColumn(len(places), mark, _header(lines[skip : places[0]]), places[0], sure))
    return max(found, key=lambda one: one.rows) if found else None


def _is_single(line: str, mark: str) -> bool:
    text = line.strip()
    return bool(text) and text not in MISSING and number(text, mark) is not None


def _header(above: Sequence[str]) -> tuple[str, ...]:
    last = next((line for line in reversed(above) if line.strip()), "")
    text = COMMENT.sub("", last, count=1).strip()
    return (text,) if _NAME.fullmatch(text) else ()
