"""Columns in units that are a power of ten of the metre, the second or both: their cells in m, s and m/s, as exactly.

>>> in_si("-3.210", -2), in_si("1.5e-3", -3), in_si("7/2", -2), in_si("5", 0)
('-0.03210', '0.0000015', '7/200', '5')
>>> power_of("x", "cm"), power_of("v", "mm/s"), power_of("t", "ms"), power_of("x", "in"), power_of("phase", "cm")
(-2, -3, -3, None, None)
"""

import re
from collections.abc import Sequence
from decimal import Context, Decimal
from fractions import Fraction

from asymptotics.decays.records.units import SECONDS, SPEEDS, UNITS, standard
from asymptotics.numbers.exact import parse_printed
from asymptotics.numbers.quantities import LENGTHS

_BRACKETS = re.compile(r"\s*[\[(](?P<unit>[^\])]*)[\])]\s*\Z")
_BEHIND = re.compile(r"(?:_|\s*/\s*|,\s*|\s+in\s+|\s+)(?P<unit>[^\s_]+)\s*\Z")
_LONGEST = 100_000
"""Digits of a decimal."""


def parted(cell: str, known: Sequence[str]) -> tuple[str, str]:
    """The name of a column without its unit, and the unit: in brackets, or behind a name that is known.

    >>> [parted(cell, ("x", "t")) for cell in ("x [m]", "x_mm", "t / s", "t in ms", "x_raw", "pos (left)", "x")]
    [('x', 'm'), ('x', 'mm'), ('t', 's'), ('t', 'ms'), ('x_raw', ''), ('pos', 'left'), ('x', '')]
    """
    if cell.strip() in known:
        return cell.strip(), ""
    found = _BRACKETS.search(cell)
    if not found:
        found = _BEHIND.search(cell)
        unit = standard(found["unit"]) if found else ""
        if not found or cell[: found.start()].strip() not in known or unit not in {*UNITS, *SECONDS, *SPEEDS}:
            return cell.strip(), ""
    return cell[: found.start()].strip(), found["unit"].strip()


def power_of(name: str, unit: str) -> int | None:
    """The power of ten of a unit in m, s or m/s, for a place, a time or a velocity; None for another one."""
    word = standard(unit)
    if name == "v":
        word = SPEEDS.get(word, "")
    sizes = {"t": SECONDS}.get(name, LENGTHS if name in ("x", "amplitude", "v") else {})
    size = sizes.get(word)
    if size is None:
        return None
    power = round(Decimal(float(size)).log10())
    return power if Fraction(str(size)) == Fraction(10) ** power else None


def in_si(cell: str, power: int) -> str:
    """The cell times 10^power, with as many digits as it has."""
    if not power:
        return cell
    if "/" in cell:
        return str(parse_printed(cell, "cell") * Fraction(10) ** power)
    return f"{Decimal(cell.strip()).scaleb(power, Context(prec=_LONGEST)):f}"
