"""Numbers with a unit, where they are met: a mass in g, a stiffness in N/mm; elsewhere the unit is named and refused.

A mass and a stiffness, the rate of samples and omega_0 of a record are in SI wherever they are given, so that their
unit has one meaning.  A place, a speed or a
time is a plain number where the law has no units: what "5 cm" is there nobody can say.

>>> in_si("200 g", "--mass"), in_si("1/2 N/mm", "stiffness"), in_si("200", "mass"), in_si("5 cm", "x0")
(Fraction(1, 5), Fraction(500, 1), None, None)
>>> in_si("1.5 kHz", "--rate"), in_si("4 rad/s", "--omega0"), in_si("4 Hz", "omega_0")
(Fraction(1500, 1), Fraction(4, 1), None)
>>> unit_behind("5 cm"), unit_behind("0,2kg"), unit_behind("5"), unit_behind("1e5"), unit_behind("sqrt(2)")
('cm', 'kg', '', '', '')
"""

import re
from fractions import Fraction
from typing import Any

_KILO, _MILLI = Fraction(1000), Fraction(1, 1000)
SIZES = {
    "mass": {"kg": Fraction(1), "g": _MILLI, "mg": _MILLI**2, "t": _KILO, "lb": Fraction("0.45359237")},
    "stiffness": {"N/m": Fraction(1), "N/cm": Fraction(100), "N/mm": _KILO, "kN/m": _KILO, "mN/m": _MILLI},
    "rate": {"Hz": Fraction(1), "1/s": Fraction(1), "kHz": _KILO, "MHz": _KILO**2},
    "omega_0": {"rad/s": Fraction(1), "1/s": Fraction(1)},
}
"""The units of what is in SI wherever it stands, with their sizes; the pound of 1959."""
OTHERS = (
    "m", "cm", "mm", "um", "km", "in", "ft", "rad", "deg", "\u00b0", "mrad", "arcmin", "s", "ms", "us", "min", "h",
    "m/s", "cm/s", "mm/s", "rad/s", "deg/s", "N", "kN", "%",
)  # fmt: skip
_WRITTEN = re.compile(
    r"(?P<number>[+-]?[\d.,]+(?:[eE][+-]?\d{1,3})?(?:/\d+)?)\s*(?P<unit>[^\W\d_%\u00b0][\w/]*|[%\u00b0])"
)
_KNOWN = {*OTHERS, *(unit for units in SIZES.values() for unit in units)}


def unit_behind(text: str) -> str:
    """The known unit behind a number; empty for another text."""
    found = _WRITTEN.fullmatch(text.strip())
    return found["unit"] if found and found["unit"] in _KNOWN else ""


def _sizes(argument: str) -> dict[str, Fraction]:
    return SIZES.get({"omega0": "omega_0"}.get(name := argument.lstrip("-"), name), {})


def in_si(text: str, argument: str) -> Fraction | None:
    """The number in SI of a text with a unit of this argument; None for any other text."""
    sizes, found = _sizes(argument), _WRITTEN.fullmatch(text.strip())
    if not found or found["unit"] not in sizes or "," in found["number"]:
        return None
    try:
        return Fraction(found["number"]) * sizes[found["unit"]]
    except (ValueError, ZeroDivisionError):  # 1.2.3, 1/0: told by the reader of numbers
        return None


def magnitude(value: Any, argument: str) -> Any:
    """The number of a quantity of pint or its like in the SI unit of this argument; None where that has none.

    >>> class Grams:
    ...     def to(self, unit): return Kilograms() if unit == "kg" else None
    >>> class Kilograms:
    ...     magnitude = 0.2
    >>> magnitude(Grams(), "mass"), magnitude(Grams(), "x0")
    (0.2, None)
    """
    sizes = _sizes(argument)
    # The first unit of each is that of SI.
    return None if not sizes else value.to(next(iter(sizes))).magnitude
