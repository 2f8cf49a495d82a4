"""Units in the names of columns: ``x_mm``, ``phi [deg]``, ``Zeit t / s``; and what they say is measured.

>>> suffix("t_ms"), suffix("phi [deg]"), suffix("x (m/s)"), suffix("x_n"), suffix("Zeit t / s"), suffix("x_raw")
('ms', 'deg', 'm/s', '', 's', '')
>>> unit_of(["x_deg"], "m", "data.csv")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument unit: m does not fit the column x_deg of data.csv (accepted: deg)
"""

import re
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from asymptotics.errors import InputError
from asymptotics.numbers.quantities import ANGLES, LENGTHS

Array = NDArray[np.float64]
UNITS = {name: float(size) for name, size in {**LENGTHS, **ANGLES}.items()}
"""Units of x, with their size in m or rad."""
SECONDS = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9, "min": 60.0, "h": 3600.0}
"""Units of time, with their size in s."""
SPEEDS = {f"{u}/s": u for u in UNITS}
"""Units of velocities, with the unit of x that belongs to them."""
ACCELERATIONS = {"g": "m"} | {f"{u}/s^2": u for u in UNITS}
GRAVITY = 9.80665
"""Standard gravity in m/s^2: what accelerometers call 1 g."""
_ALSO = {
    "degrees": "deg", "degree": "deg", "\u00b0": "deg", "grad": "deg", "radians": "rad", "radian": "rad",
    "metres": "m", "meters": "m", "metre": "m", "meter": "m", "centimeters": "cm", "millimeters": "mm",
    "sec": "s", "secs": "s", "seconds": "s", "second": "s", "sekunden": "s", "milliseconds": "ms", "minutes": "min",
    "hours": "h", "\u00b0/s": "deg/s", "1/s": "rad/s", "rad s^-1": "rad/s", "m s^-1": "m/s", "m*s^-1": "m/s",
    "g0": "g", "inch": "in", "inches": "in", "foot": "ft", "feet": "ft", "milliradians": "mrad", "arcminutes": "arcmin",
}  # fmt: skip
# Run #1, Lauf 2, Latest: what recorders put before or behind a name.
_RUN = re.compile(r"\b(?:run|lauf|latest|data set|set)\b\s*#?\s*\d*\s*:?", re.IGNORECASE)
_CLOCKS = {"millis": "ms", "micros": "us", "milliseconds": "ms"}
"""Names that are units: the clocks of small computers."""
_NONE = ("n", "-", "1", "")
"""No unit: the index in x_n, and the ways to write that a number has none."""


def standard(named: str) -> str:
    """A unit under its usual name.

    >>> standard("seconds"), standard("m/s\u00b2"), standard("(ms)")
    ('s', 'm/s^2', 'ms')
    """
    # The micro sign and the Greek letter look alike and are two characters.
    text = named.strip().strip("[]() ").replace("\u00b5", "u").replace("\N{GREEK SMALL LETTER MU}", "u")
    text = text.replace("\u00b2", "^2").replace("**", "^").replace("/s/s", "/s^2").replace("/s2", "/s^2")
    text = _ALSO.get(text.lower(), text)
    return "" if text in _NONE else text


def is_unit(cell: str) -> bool:
    """Whether a cell holds a unit and nothing else (or nothing at all)."""
    text = cell.strip()
    return not text or (text[0] in "[(" and text[-1] in ")]") or _is_known(standard(text)) or text in _NONE[1:]


def _is_known(unit: str) -> bool:
    return unit in UNITS or unit in SECONDS or unit in SPEEDS or unit in ACCELERATIONS


def without_run(column: str) -> str:
    """The name without the run that some exporters add.

    >>> without_run("Angle (rad) Run #1"), without_run("Latest: Time (s)")
    ('Angle (rad)', 'Time (s)')
    """
    return _RUN.sub(" ", column).strip() or column


def suffix(column: str) -> str:
    """The unit in a column's name: in brackets at its end, after a slash, or a known one after its last underscore,
    comma, ``in`` or space, or as its whole name.

    >>> suffix("x [in]"), suffix("x_inch"), suffix("x_in")              # x_in may be an input
    ('in', 'in', '')
    >>> [suffix(name) for name in ("t in ms", "Position, m", "Angle deg", "Height h", "ms", "x min", "gain in use")]
    ['ms', 'm', 'deg', '', 'ms', '', '']
    """
    column = without_run(column)
    if column.lower() in _CLOCKS:
        return _CLOCKS[column.lower()]
    found = re.fullmatch(r".*[\[(]([^\])]*)[\])]\s*", column)
    if found:
        return standard(found[1])
    found = re.fullmatch(r"(?:.*\S\s+/\s*|[^\s/]+/)(\S+)\s*", column)
    # m/s is a unit with a slash, not the quantity m in s.
    if found and not _is_known(standard(column)):
        return standard(found[1])
    found = re.fullmatch(r".*_([^_]+)", column)
    if found and found[1] != "in" and _is_known(standard(found[1])):
        return standard(found[1])
    found = re.fullmatch(r".*\S(?:,\s*|\s+in\s+)(\S+)\s*", column)
    if found and _is_known(standard(found[1])):
        return standard(found[1])
    # A word of one letter is the symbol of something, and min and in are words.
    last = standard(column.split()[-1]) if column.split() else ""
    sure = _is_known(last) and last not in ("in", "min") and (len(last) > 1 or column.split()[-1] != last)
    return last if sure else ""


def seconds(column: str, name: str, said: str = "") -> float:
    """The size in seconds of the unit in the name of a column of times, or of the one that is said; 1 without one."""
    named = suffix(column)
    after = re.fullmatch(r".*_([a-z]{2,})", column)
    # t_ms is a unit, t_raw a word: an ending that is no unit of time and no such word is refused, not taken as seconds.
    if not named and after and after[1] not in ("n", "time", "t", "raw", "elapsed", "stamp", "value"):
        named = after[1]
    if named and named not in SECONDS:
        reason = f"{name}, row 1, column {column}: {named[:20]!r} is no unit of time"
        raise InputError("FILE", reason, f"{', '.join(SECONDS)}, or no unit in the name")
    if said and named and SECONDS[said] != SECONDS[named]:
        raise InputError("unit", f"{said} contradicts the column {column} of {name}", named)
    return SECONDS.get(said or named, 1.0)


def is_unsaid(column: str, times: Array) -> bool:
    """Whether neither the name of a column of times says its unit nor the size of its values: seconds since 1970.

    >>> [is_unsaid(c, np.array([0.0, 20.0])) for c in ("t", "time", "t (s)", "t_ms", "seconds_elapsed")]
    [True, True, False, False, False]
    """
    named = suffix(column) or re.search(r"second|sekund|_(?:s|sec|ms|us|ns|min|h)\Z", column, re.IGNORECASE)
    known = times[np.isfinite(times)]
    return not named and not (len(known) > 0 and float(known.min()) > 1e9)


def since(times: Array) -> str:
    """The unit of a clock without one that counts from 1970, as those of computers do, by its size; empty for another.

    A count of seconds needs no unit; the years are 2001 to 2100.

    >>> since(np.array([1.7e12, 1.7e12 + 20])), since(np.array([1.7e9, 1.7e9 + 1])), since(np.array([0.0, 20.0]))
    ('ms', '', '')
    """
    known = times[np.isfinite(times)]
    first, last = (float(known.min()), float(known.max())) if len(known) else (0.0, 0.0)
    return next((u for u in ("ms", "us", "ns") if first * SECONDS[u] > 1e9 and last * SECONDS[u] < 4.1e9), "")


def unit_of(columns: Sequence[str], unit: str, name: str) -> str:
    """The one known unit of these columns and of the option --unit, empty for one that is unknown."""
    found = unit
    for column in columns:
        named = suffix(column)
        named = SPEEDS.get(named, ACCELERATIONS.get(named, named))
        if named not in UNITS:
            continue
        # Metres and degrees are no two units of one quantity, and deserve another sentence than mm and m.
        if found and (found in LENGTHS) != (named in LENGTHS):
            raise InputError("unit", f"{found} does not fit the column {column} of {name}", named)
        if found and found != named:
            raise InputError("unit", f"{found} contradicts the column {column} of {name}", "one unit")
        found = named
    return found
