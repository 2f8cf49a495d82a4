"""Numbers with a unit, where they are met: a mass in g, a start in cm; elsewhere the unit is named and refused.

A mass, a stiffness, the rate of samples and omega_0 of a record are in SI wherever they are given, so that their unit
has one meaning.  A start has one beside them: metres, or radians of a pendulum.  Sizes are exact, those of angles too
(pi to 130 digits), so that "5 cm" is 1/20.

>>> in_si("200 g", "--mass"), in_si("1/2 N/mm", "stiffness"), in_si("200", "mass"), in_si("5 cm", "x0", "m")
(Fraction(1, 5), Fraction(500, 1), None, Fraction(1, 20))
>>> in_si("5 kg", "--x0", "m")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument --x0: '5 kg' is not an exact number: it has the unit kg, and m is meant ...
>>> unit_behind("5 cm"), unit_behind("0,2kg"), unit_behind("5"), unit_behind("1e5"), unit_behind("sqrt(2)")
('cm', 'kg', '', '', '')
"""

import re
from fractions import Fraction
from typing import Any

from asymptotics.errors import InputError
from asymptotics.numbers.integers import shown_text

_KILO, _MILLI = Fraction(1000), Fraction(1, 1000)
_PI = Fraction(
    "3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803482534211706798214808651"
    "328230664709384460955058"
)
LENGTHS = {
    "m": Fraction(1), "cm": Fraction(1, 100), "mm": Fraction(1, 1000), "um": Fraction(1, 10**6),
    "in": Fraction(254, 10_000), "ft": Fraction(3048, 10_000),
}  # fmt: skip
"""Units of length, with their size in m; the inch of 1959."""
ANGLES = {"rad": Fraction(1), "deg": _PI / 180, "mrad": Fraction(1, 1000), "arcmin": _PI / 10_800}
"""Units of angles, with their size in rad: pi to 130 digits, 30 more than are ever asked for."""
SIZES = {
    "kg": {"kg": Fraction(1), "g": _MILLI, "mg": _MILLI**2, "t": _KILO, "lb": Fraction("0.45359237")},
    "N/m": {"N/m": Fraction(1), "N/cm": Fraction(100), "N/mm": _KILO, "kN/m": _KILO, "mN/m": _MILLI},
    "Hz": {"Hz": Fraction(1), "1/s": Fraction(1), "kHz": _KILO, "MHz": _KILO**2},
    "m": LENGTHS,
    "m/s": {**{f"{name}/s": size for name, size in LENGTHS.items()}, "km/h": Fraction(5, 18)},
    "rad": {**ANGLES, "\u00b0": ANGLES["deg"]},
    "rad/s": {**{f"{name}/s": size for name, size in ANGLES.items()}, "1/s": Fraction(1)},
    "s": {"s": Fraction(1), "ms": _MILLI, "us": _MILLI**2, "min": Fraction(60), "h": Fraction(3600)},
}
"""The units of each quantity under that of SI, with their sizes; the pound of 1959."""
_OF_ARGUMENT = {"mass": "kg", "stiffness": "N/m", "rate": "Hz", "omega0": "rad/s", "omega_0": "rad/s"}
"""What is in SI wherever it stands."""
_WRITTEN = re.compile(
    r"(?P<number>[+-]?[\d.,]+(?:[eE][+-]?\d{1,3})?(?:/\d+)?)\s*(?P<unit>[^\W\d_%\u00b0][\w/]*|[%\u00b0])"
)
_KNOWN = {"km", "N", "kN", "%", *(unit for units in SIZES.values() for unit in units)}


def unit_behind(text: str) -> str:
    """The known unit behind a number; empty for another text."""
    found = _WRITTEN.fullmatch(text.strip())
    return found["unit"] if found and found["unit"] in _KNOWN else ""


def in_si(text: str, argument: str, si: str = "") -> Fraction | None:
    """The number in ``si``, or in the unit of this argument, of a text with such a unit; None for any other text.

    InputError for another unit, and for a decimal comma before it.
    """
    si = si or _OF_ARGUMENT.get(argument.lstrip("-"), "")
    found = _WRITTEN.fullmatch(text.strip())
    if not si or not found or found["unit"] not in _KNOWN:
        return None
    sizes, name = SIZES[si], f"{shown_text(text)} is not an exact number: it has"
    if found["unit"] not in sizes:
        raise InputError(argument, f"{name} the unit {found['unit']}, and {si} is meant", told_units(si))
    if "," in found["number"]:
        raise InputError(argument, f"{name} a comma, and decimals have a point", told_units(si))
    try:
        return Fraction(found["number"]) * sizes[found["unit"]]
    except (ValueError, ZeroDivisionError):  # 1.2.3, 1/0: told by the reader of numbers
        return None


def told_units(si: str) -> str:
    """What is accepted as a number in this unit of SI."""
    return f"a number in {si}, or with its unit: {', '.join(SIZES[si])}"


def magnitude(value: Any, argument: str, si: str = "") -> tuple[Any, Fraction] | None:
    """The number of a quantity of pint or its like, and the size of its unit in that of SI; None where it has none.

    Exact for the units of ``SIZES``, by the quantity's own conversion for others; InputError where it has none.

    >>> class Grams:
    ...     magnitude, units = 200, "g"
    >>> magnitude(Grams(), "mass"), magnitude(Grams(), "p")
    ((200, Fraction(1, 1000)), None)
    """
    si = si or _OF_ARGUMENT.get(argument.lstrip("-"), "")
    if not si:
        return None
    size = SIZES[si].get(_short(value))
    if size is not None:
        return value.magnitude, size
    try:
        return value.to(si).magnitude, Fraction(1)
    except Exception:  # of a foreign library: there is no such conversion
        named = f"a quantity in {_short(value)[:40] or 'another unit'}"
        raise InputError(argument, f"{named}, and {si} is meant", told_units(si)) from None


def _short(value: Any) -> str:
    """The short name of a quantity's unit; empty where it has none."""
    try:
        return format(value.units, "" if isinstance(value.units, str) else "~").replace(" ", "")
    except Exception:  # a foreign object may fail in any way
        return ""
