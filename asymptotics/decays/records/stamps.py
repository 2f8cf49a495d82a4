"""Times of day and dates as people and loggers write them: 59:50.5, 2024-03-01T11:59:50Z, 3/1/2024 1:02:03 PM.

Of a date with slashes the cells of the column say whether the day or the month stands first: the one that is above 12,
AM or PM, or the reading in which the column spans less.

>>> order_of(["01/03/2024 23:59:59", "02/03/2024 00:00:01"]), order_of(["3/1/2024 1:02:03 PM"]), order_of(["11:59:50"])
('dmy', 'mdy', '')
>>> seconds_of_stamp("1.3.2024 00:01:00", "dmy") - seconds_of_stamp("29.2.2024 23:59:00", "dmy")
120.0
>>> past_midnight(np.array([86399.0, 86399.5, 0.0, 0.5])).tolist()
[86399.0, 86399.5, 86400.0, 86400.5]
"""

import re
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from asymptotics.decays.records.cells import MISSING

_DATE = r"\d{4}[-/]\d{1,2}[-/]\d{1,2}|\d{1,2}\.\d{1,2}\.\d{4}|\d{1,2}/\d{1,2}/\d{4}"
_CLOCK = r"(?:(?P<hours>\d{1,2}):)?(?P<minutes>\d{1,2}):(?P<seconds>\d\d)(?:(?P<mark>[.,:])(?P<part>\d+))?"
_STAMP = re.compile(
    rf"(?:(?P<date>{_DATE})(?:[T ]|,\s?))?{_CLOCK}(?:\s?(?P<half>[AaPp])[Mm])?(?P<zone>Z|[+-]\d\d:?\d\d)?"
)
_DAY = 86_400.0


def _match(cell: str) -> re.Match[str] | None:
    if ":" not in cell:
        return None
    found = _STAMP.fullmatch(cell.strip().strip('"'))
    # Without hours 12:30 may be a time of day as well: only a part of a second says that it is minutes and seconds.
    if found is None or (found["hours"] is None and (found["date"] or found["mark"] not in (".", ","))):
        return None
    return None if found["mark"] == ":" and len(found["part"]) != 3 else found


def is_stamp(cell: str) -> bool:
    """Whether it is a time of day, or a date with one.

    >>> [is_stamp(c) for c in ("2024-05-01 12:00:00.25", "12:00:01", "59:50.5", "01/02/2024", "12:30")]
    [True, True, True, False, False]
    """
    return _match(cell) is not None


def order_of(cells: Sequence[str]) -> str:
    """``ymd``, ``dmy`` or ``mdy``; empty where there are no dates."""
    found = [m for cell in cells if (m := _match(cell)) and m["date"]]
    if not found:
        return ""
    slashed = [tuple(map(int, m["date"].split("/"))) for m in found if re.match(r"\d{1,2}/", m["date"])]
    if not slashed:
        return "dmy" if "." in found[0]["date"] else "ymd"
    if any(a > 12 for a, _, _ in slashed):
        return "dmy"
    if any(b > 12 for _, b, _ in slashed) or any(m["half"] for m in found):
        return "mdy"
    spans = {order: _span(slashed, order) for order in ("dmy", "mdy")}
    return min(spans, key=lambda order: spans[order])


def _span(dates: Sequence[tuple[int, ...]], order: str) -> int:
    days = [np.datetime64(_iso("/".join(map(str, d)), order)).astype(int) for d in {*dates}]
    return int(max(days) - min(days))


def _iso(date: str, order: str) -> str:
    one, two, three = re.split(r"[-/.]", date)
    year, month, day = {"dmy": (three, two, one), "mdy": (three, one, two)}.get(order, (one, two, three))
    return f"{year}-{int(month):02d}-{int(day):02d}"


def seconds_of_stamp(cell: str, order: str = "ymd") -> float | None:
    """Seconds since midnight, or since 1970 where there is a date; nan for a missing one, None for another text."""
    from datetime import datetime  # noqa: PLC0415 (only files with stamps)

    if cell.strip().strip('"') in MISSING:
        return float("nan")
    found = _match(cell)
    if found is None:
        return None
    start = 0.0
    if found["date"]:
        # A date without a zone is taken in universal time: only differences are used.
        shift = found["zone"] if found["zone"] and found["zone"] != "Z" else "+00:00"
        try:
            start = datetime.fromisoformat(f"{_iso(found['date'], order)}T00:00:00{shift}").timestamp()
        # Such as a thirteenth month: no stamp, though it looks like one.
        except ValueError:
            return None
    hours = int(found["hours"] or 0)
    if found["half"]:
        hours = hours % 12 + 12 * (found["half"] in "pP")
    return start + 3600 * hours + 60 * int(found["minutes"]) + float(f"{found['seconds']}.{found['part'] or 0}")


def past_midnight(times: NDArray[np.float64]) -> NDArray[np.float64]:
    """Times of day that go on where they fall by more than half a day."""
    known = np.isfinite(times)
    days = np.cumsum(np.concatenate([[0.0], np.diff(times[known]) < -_DAY / 2])) if known.any() else 0.0
    found = times.copy()
    found[known] += _DAY * days
    return found
