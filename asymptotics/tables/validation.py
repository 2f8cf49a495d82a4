"""A table recomputed by mpmath alone: its Gamma function, its 2F1, its Lambert W, and nothing of ours.

=================  ===============================================================================================
moments            M_p = Gamma((p+1)/2)/(sqrt(pi) Gamma(p/2+1))
lelas-ratios       2^(-(alpha+1)/2)/M_(alpha+1)
phase-lags         (alpha/(alpha+1))^2 M_(2 alpha) epsilon/((alpha-1) M_(alpha+1))
extinction-times   1/((1-alpha) M_(alpha+1) epsilon)
two-law-times      A^(1-alpha)/(kappa (1-alpha)) 2F1(1, a; a+1; -kappa'/kappa A^gap), a = (1-alpha)/gap, at its ends
smith2012.table1   2 |u_(n+1)| = 1 + W_0(-y e^(-y)), y = 1 + 2 |u_n|, and Newton's method on (43), one after the other
=================  ===============================================================================================

>>> from asymptotics.tables.registry import build
>>> found = build("smith2012.table1", digits=40).validate()
>>> found.equal, found.values
(True, 12)
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import mpmath

from asymptotics.errors import InputError
from asymptotics.numbers.decimal_context import workdps
from asymptotics.numbers.integers import require_integer
from asymptotics.present.shown import Page, Rows

GUARD = 30
"""Digits beyond those asked for: an iteration of Table I loses about two a step, and has its own besides."""


@dataclass(frozen=True, repr=False)
class Validation(Rows):
    """What mpmath found: for each value the row, the column, the digits of the table and those of mpmath."""

    table: str
    digits: int
    version: str
    pairs: tuple[tuple[int, str, str, str, bool], ...]

    @property
    def equal(self) -> bool:
        """Whether every digit of the table is that of mpmath, rounded."""
        return all(pair[-1] for pair in self.pairs)

    @property
    def values(self) -> int:
        """How many numbers were recomputed."""
        return len(self.pairs)

    def _page(self) -> Page:
        worth = "heuristic: mpmath alone, beside certified digits"
        return Page(str(self), (worth,), ("row", "column", "ours", "mpmath"), tuple(pair[:4] for pair in self.pairs))

    def _table(self) -> dict[str, list[Any]]:
        names = ("row", "column", "ours", "mpmath", "equal")
        return {name: [pair[i] for pair in self.pairs] for i, name in enumerate(names)}

    def __str__(self) -> str:
        """One line for under the table."""
        wrong = [f"row {row}, {column}" for row, column, _, _, same in self.pairs if not same]
        verdict = "equal" if not wrong else f"{len(wrong)} of {self.values} differ: {'; '.join(wrong[:3])}"
        return f"recomputed by mpmath {self.version} to {self.digits} digits: {verdict}"

    def beside(self) -> str:
        """Each number of the table beside that of mpmath."""
        heads = ("row", "column", "ours", "mpmath")
        cells = [heads, *((str(row), column, ours, theirs) for row, column, ours, theirs, _ in self.pairs)]
        widths = [max(len(row[i]) for row in cells) for i in range(len(heads))]
        lines = ("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in cells)
        return "\n".join(lines)

    def to_dict(self) -> dict[str, Any]:
        """For JSON; numbers are strings."""
        names = ("row", "column", "ours", "mpmath", "equal")
        pairs = [dict(zip(names, pair)) for pair in self.pairs]
        return {"by": f"mpmath {self.version}", "digits": self.digits, "equal": self.equal, "values": pairs}


def validate(
    name: str, columns: tuple[str, ...], rows: tuple[tuple[str, ...], ...], digits: int = 60, *, nearest: bool = True
) -> Validation:
    """Recompute a table to ``digits`` digits, or to those that it has; ``nearest``: how its numbers are rounded.

    InputError for a table that mpmath alone does not give, and for digits outside [1, 1000].
    """
    require_integer(digits, "digits", 1, 1000)
    if name not in ROUTES:
        raise InputError("name", f"{name} is not recomputed by mpmath alone", ", ".join(ROUTES))
    digits = max(digits, *(len(_digits(cell)) for row in rows for cell in row))
    pairs = []
    with workdps(digits + GUARD + 3 * len(rows)):
        given = [dict(zip(columns, row)) for row in rows]
        for number, (row, values) in enumerate(zip(given, ROUTES[name](given), strict=True), 1):
            for column, value in values.items():
                shown = mpmath.nstr(value, digits, strip_zeros=False)
                pairs.append((number, column, row[column], shown, _same(row[column], value, nearest)))
    return Validation(name, digits, mpmath.__version__, tuple(pairs))


def _digits(cell: str) -> str:
    """The significant digits of a decimal."""
    return "".join(c for c in cell.split("e")[0] if c.isdigit()).lstrip("0")


def _same(cell: str, value: Any, nearest: bool) -> bool:
    """Whether the value is within half a unit of the last place of a decimal, or a whole one, or in an interval."""
    slack = mpmath.mpf(10) ** (8 - mpmath.mp.dps)  # what mpmath itself may have lost, far below a unit
    if cell.startswith("["):
        low, high = (mpmath.mpf(end) for end in cell.strip("[]").split(", "))
        return bool(low - slack <= value <= high + slack)
    mantissa, _, exponent = cell.partition("e")
    places = len(mantissa.partition(".")[2]) - int(exponent or 0)
    unit = mpmath.mpf(10) ** -places if cell != "0" else mpmath.mpf(0)
    return bool(abs(value - mpmath.mpf(cell)) <= (unit / 2 if nearest else unit) + slack)


Row = dict[str, str]
Values = Iterator[dict[str, Any]]


def _number(text: str) -> Any:
    """An exact real as it is written: 3/2, 0.1, sqrt(2)."""
    if text.startswith("sqrt("):
        return mpmath.sqrt(_number(text[5:-1]))
    exact = Fraction(text)
    return mpmath.mpf(exact.numerator) / exact.denominator


def _moment(p: Any) -> Any:
    return mpmath.gamma((p + 1) / 2) / (mpmath.sqrt(mpmath.pi) * mpmath.gamma(p / 2 + 1))


def _by_alpha(values: Callable[..., dict[str, Any]]) -> Callable[[list[Row]], Values]:
    """A route that takes alpha and the row."""
    return lambda rows: (values(_number(row["alpha"]), row) for row in rows)


def _moments(a: Any, _row: Row) -> dict[str, Any]:
    orders = {"M_(alpha+1)": a + 1, "M_(2 alpha)": 2 * a, "M_(3 alpha+1)": 3 * a + 1}
    return {column: _moment(p) for column, p in orders.items()}


def _ratio(a: Any, _row: Row) -> dict[str, Any]:
    return {"ratio": 2 ** (-(a + 1) / 2) / _moment(a + 1)}


def _lag(a: Any, row: Row) -> dict[str, Any]:
    w_2 = (a / (a + 1)) ** 2 * _moment(2 * a)
    return {"lag": w_2 * _number(row["epsilon"]) / ((a - 1) * _moment(a + 1))}


def _extinction(a: Any, row: Row) -> dict[str, Any]:
    return {"tau_e": 1 / ((1 - a) * _moment(a + 1) * _number(row["epsilon"]))}


def _two_laws(rows: list[Row]) -> Values:
    """The integral of dA/(kappa A^alpha + kappa' A^beta) from A to 1, at the two ends of its primitive."""
    for row in rows:
        pairs = sorted([_number(x) for x in term.split(":")] for term in row["law"].split(","))
        (a, kappa), (b, other) = ((x, e * _moment(x + 1)) for x, e in pairs)
        end = _number(row["A"])
        yield {"tau": _primitive(a, kappa, b, other, mpmath.mpf(1)) - _primitive(a, kappa, b, other, end)}


def _primitive(a: Any, kappa: Any, b: Any, other: Any, A: Any) -> Any:
    """By 2F1; by logarithms at alpha = 1; from the other end, B = 1/A, where its third parameter is 0, -1, ..."""
    gap = b - a
    if a == 1:
        return (mpmath.log(A) - mpmath.log(kappa + other * A**gap) / gap) / kappa
    index = (1 - a) / gap
    if mpmath.isint(index) and index < 0:
        return -mpmath.quad(lambda x: x ** (a - 2) / (kappa + other * x**-gap), [1, 1 / A])
    return A ** (1 - a) / (kappa * (1 - a)) * mpmath.hyp2f1(1, index, index + 1, -other / kappa * A**gap)


def _smith(rows: list[Row]) -> Values:
    """Each sequence from its u_0, by Lambert's W; Newton's method on (43) begins at its double and must agree."""
    for row in rows:
        if row["half_cycle"] == "1":
            size = start = _number(row.get("u_0", "1"))
        else:
            size = _next(size)
        level = mpmath.exp(-2 * size) * (size / 2 + mpmath.mpf(1) / 4)
        first = mpmath.exp(-2 * start) * (start / 2 + mpmath.mpf(1) / 4)
        yield {"S_hat": level - first, "u": size if int(row["half_cycle"]) % 2 else -size}


def _next(size: Any) -> Any:
    y = 1 + 2 * size
    found = (1 + mpmath.lambertw(-y * mpmath.exp(-y)).real) / 2
    level = y * mpmath.exp(-y)  # (43): (1 - r) e^(r - 1) = y e^(-y), r = 2 |u_(n+1)|
    newton = mpmath.findroot(lambda r: (1 - r) * mpmath.exp(r - 1) - level, float(2 * found), solver="newton") / 2
    if abs(newton - found) > mpmath.mpf(10) ** (-mpmath.mp.dps // 2):
        raise ArithmeticError(f"mpmath's Lambert W and its Newton method disagree after |u| = {mpmath.nstr(size, 15)}")
    return found


ROUTES: dict[str, Callable[[list[Row]], Values]] = {
    "moments": _by_alpha(_moments),
    "lelas-ratios": _by_alpha(_ratio),
    "phase-lags": _by_alpha(_lag),
    "extinction-times": _by_alpha(_extinction),
    "two-law-times": _two_laws,
    "smith2012.table1": _smith,
}
"""The tables that mpmath alone recomputes."""
