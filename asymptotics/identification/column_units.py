"""Units in the names of columns: ``x_mm``, ``phi [deg]``, ``t_ms``; one that is not known is refused, never ignored.

>>> suffix("t_ms"), suffix("phi [deg]"), suffix("x (m/s)"), suffix("x_n"), suffix("x")
('ms', 'deg', 'm/s', '', '')
>>> unit_of(["x_kelvin"], "", "data.csv")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument FILE: data.csv, row 1, column x_kelvin: 'kelvin' is no unit of x ...
"""

import re
from collections.abc import Sequence

import numpy as np

from asymptotics.errors import InputError

UNITS = {"m": 1.0, "cm": 0.01, "mm": 0.001, "um": 1e-6, "rad": 1.0, "deg": float(np.pi / 180)}
"""Units of x, with their size in m or rad."""
SECONDS = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "min": 60.0, "h": 3600.0}
"""Units of time, with their size in s."""
_LENGTHS = ("m", "cm", "mm", "um")
_ALSO = {"degrees": "deg", "degree": "deg", "°": "deg", "radians": "rad", "metres": "m", "meters": "m",
         "µm": "um", "μm": "um", "sec": "s", "seconds": "s", "µs": "us", "μs": "us"}  # fmt: skip
_NONE = ("n", "-", "1", "")
"""No unit: the index in x_n, and the ways to write that a number has none."""


def suffix(column: str) -> str:
    """The unit in a column's name: in brackets at its end, or after its last underscore; empty if there is none."""
    found = re.fullmatch(r".*[\[(]([^\])]*)[\])]\s*", column) or re.fullmatch(r".*_([^_]+)", column)
    named = found.group(1).strip() if found else ""
    return "" if named in _NONE else _ALSO.get(named, named)


def seconds(column: str, name: str) -> float:
    """The size in seconds of the unit in the name of a column of times; 1 without one."""
    named = suffix(column)
    if named and named not in SECONDS:
        raise InputError("FILE", _unknown(column, named, "time", name), f"{', '.join(SECONDS)}, or no unit in the name")
    return SECONDS.get(named, 1.0)


def unit_of(columns: Sequence[str], unit: str, name: str) -> str:
    """The one unit of these columns and of the option --unit; InputError for one that is unknown, or for two."""
    found = unit
    for column in columns:
        named = suffix(column)
        if not named:
            continue
        if named not in UNITS:
            raise InputError("FILE", _unknown(column, named, "x", name), f"{', '.join(UNITS)}, or no unit in the name")
        if found and (found in _LENGTHS) != (named in _LENGTHS):
            raise InputError("unit", f"{found} does not fit the column {column} of {name}", named)
        if found and found != named:
            raise InputError("unit", f"{found} contradicts the column {column} of {name}", "one unit")
        found = named
    return found


def _unknown(column: str, named: str, kind: str, name: str) -> str:
    return f"{name}, row 1, column {column}: {named[:20]!r} is no unit of {kind}"
