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
_MISSING = frozenset(MISSING)
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


def number(cell: str, decimal: str, *, thousands: bool = False) -> float | None:
    """The number; nan for a missing one; None for a text that is none.

    ``1,234`` with the decimal point is a number only where ``thousands`` are known to be grouped by commas;
    ``1,234.5`` always is.
    """
    if _PLAIN[decimal].fullmatch(cell):  # as nearly all are
        return _plain(cell)
    # The minus sign of typography is what spreadsheets export in some languages.
    text = cell.strip().strip('"').strip().replace("\u2212", "-")
    if text in _MISSING:
        return nan
    if _PLAIN[decimal].fullmatch(text):
        return _plain(text)
    found = _GROUPS[decimal].fullmatch(text)
    # A point or comma that may be decimal groups thousands only if the file shows it, or the other mark stands behind
    # it; a space or an apostrophe is no decimal mark.
    if found and (thousands or found["rest"] or found["mark"] not in ",."):
        return float(text.replace(found["mark"], "").replace(",", "."))
    return None


def _plain(text: str) -> float:
    return float(text.replace(",", ".").replace("D", "e").replace("d", "e"))


def is_grouped(cell: str, decimal: str) -> bool:
    """Whether a cell is a number only if its point or comma groups thousands."""
    text = cell.strip().strip('"').strip()
    found = _GROUPS[decimal].fullmatch(text)
    return bool(found and found["mark"] in ",." and not found["rest"])
