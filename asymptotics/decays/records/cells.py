"""The number in a cell, strictly: a text that two conventions read as two numbers is none.

>>> number("1.5D-2", "."), number("-,5", ","), number("1,234.5", "."), number("1,234", ".")
(0.015, -0.5, 1234.5, None)
>>> number("1,234", ".", thousands=True), number("n/a", "."), number("oops", ".")
(1234.0, nan, None)
"""

import re
from math import nan

MISSING = ("", "-", "--", "nan", "NaN", "NAN", "na", "NA", "n/a", "N/A", "#N/A", "null", "NULL", "none", "None", "?")
"""Words for a value that is not there."""
MARKS = (-999.0, -9999.0, -99999.0, -999.25)
"""Numbers that stand for a missing value, where all others are well below them."""

# Fortran writes the exponent of a double with D.
_EXPONENT = r"(?:[eEdD][+-]?\d+)?"
_PLAIN = {
    ".": re.compile(rf"[+-]?(?:\d+\.?\d*|\.\d+){_EXPONENT}"),
    ",": re.compile(rf"[+-]?(?:\d+(?:,\d+)?|,\d+){_EXPONENT}"),
}
# Groups of three digits with one and the same mark between them; a number that begins with 0 has none.
_GROUPS = {
    ".": re.compile(r"[+-]?[1-9]\d{0,2}(?P<mark>[, '\u00a0\u202f])\d{3}(?:(?P=mark)\d{3})*(?P<rest>\.\d*)?"),
    ",": re.compile(r"[+-]?[1-9]\d{0,2}(?P<mark>[. '\u00a0\u202f])\d{3}(?:(?P=mark)\d{3})*(?P<rest>,\d*)?"),
}
_STAMP = re.compile(r"(?:\d{4}-\d\d-\d\d[T ])?\d{1,2}:\d\d:\d\d(?:[.,]\d+)?(?:Z|[+-]\d\d:?\d\d)?")


def number(cell: str, decimal: str, *, thousands: bool = False) -> float | None:
    """The number; nan for a missing one; None for a text that is none.

    ``1,234`` with the decimal point is a number only where ``thousands`` are known to be grouped by commas;
    ``1,234.5`` always is.
    """
    # The minus sign of typography is what spreadsheets export in some languages.
    text = cell.strip().strip('"').strip().replace("\u2212", "-")
    if text in MISSING:
        return nan
    if _PLAIN[decimal].fullmatch(text):
        return float(text.replace(",", ".").replace("D", "e").replace("d", "e"))
    found = _GROUPS[decimal].fullmatch(text)
    # A point or comma that may be decimal groups thousands only if the file shows it, or the other mark stands behind
    # it; a space or an apostrophe is no decimal mark.
    if found and (thousands or found["rest"] or found["mark"] not in ",."):
        return float(text.replace(found["mark"], "").replace(",", "."))
    return None


def is_grouped(cell: str, decimal: str) -> bool:
    """Whether a cell is a number only if its point or comma groups thousands."""
    text = cell.strip().strip('"').strip()
    found = _GROUPS[decimal].fullmatch(text)
    return bool(found and found["mark"] in ",." and not found["rest"])


def is_stamp(cell: str) -> bool:
    """Whether it is a time of day, or a date (the year first) with one.

    >>> is_stamp("2024-05-01 12:00:00.25"), is_stamp("12:00:01"), is_stamp("01/02/2024")
    (True, True, False)
    """
    return bool(_STAMP.fullmatch(cell.strip().strip('"')))


def seconds_of_stamp(cell: str) -> float | None:
    """Seconds since midnight, or since 1970 where there is a date; nan for a missing one, None for another text."""
    from datetime import datetime  # noqa: PLC0415 (only files with stamps)

    text = cell.strip().strip('"')
    if text in MISSING:
        return nan
    if not is_stamp(text):
        return None
    # Four digits of a year and a hyphen; a time of day alone begins with its hours.
    if "-" in text[:6]:
        day, _, clock = text.replace("T", " ").partition(" ")
        zone = re.search(r"(?:Z|[+-]\d\d:?\d\d)\Z", clock)
        # A date without a zone is taken in universal time: only differences are used.
        shift = zone.group() if zone and zone.group() != "Z" else "+00:00"
        clock = clock[: zone.start()] if zone else clock
        try:
            start = datetime.fromisoformat(f"{day}T00:00:00{shift}").timestamp()
        # Such as a thirteenth month: no stamp, though it looks like one.
        except ValueError:
            return None
    else:
        start, clock = 0.0, text
    hours, minutes, rest = clock.split(":")
    return start + 3600 * int(hours) + 60 * int(minutes) + float(rest.replace(",", "."))
