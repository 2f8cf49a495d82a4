"""What stands in a cell, and how it is rounded: the table maker's dilemma, met by more digits until all are decided.

A cell is an exact number (``Fraction``), a ``Nearest`` decimal (correctly rounded to the digits its recipe was asked
for), a ``Formula``, or other text (names, exact forms, integers), which is printed as it is.

>>> [printed(cell, 3, "floor") for cell in (Fraction(2, 3), Nearest("0.1239999"), "3/2", Formula("pi/2", r"\\pi/2"))]
['0.666', '0.123', '3/2', 'pi/2']
"""

from collections.abc import Callable
from fractions import Fraction

from asymptotics.errors import UndecidedError
from asymptotics.numbers.rounding import require_mode, rounded_decimal, rounded_rational

# Digits beyond those that are printed, for roundings other than to the nearest.  Six decide all but one value in a
# million, 40 and 200 those that are near a decimal by design; a number that is a decimal (1/4, say) is never decided by
# digits and must be an exact cell.  Fewer cost another pass, and at the end an UndecidedError, never a wrong digit.
_GUARDS = (6, 40, 200)


class Nearest(str):
    """A decimal that is the correct rounding of a number (ties to even); "0" is exactly zero."""

    __slots__ = ()


class Formula(str):
    """A formula that SymPy reads, and its LaTeX."""

    __slots__ = ("latex",)
    latex: str

    def __new__(cls, text: str, latex: str) -> "Formula":
        """The text carries its LaTeX along."""
        made = super().__new__(cls, text)
        made.latex = latex
        return made


Cell = Fraction | str
Rows = list[tuple[Cell, ...]]


def printed(cell: Cell, digits: int, mode: str) -> str | None:
    """The cell as text; None where a decimal does not decide its rounding."""
    if isinstance(cell, Fraction):
        return rounded_rational(cell, digits, mode)
    if isinstance(cell, Nearest):
        # A second rounding to the nearest could go wrong at a half: the recipe's own is printed as it is.
        return str(cell) if mode == "nearest" else rounded_decimal(cell, digits, mode)
    return cell


def round_rows(compute: Callable[[int], Rows], digits: int, mode: str) -> tuple[tuple[str, ...], ...]:
    """All rows of a recipe in the rounding wanted: with more digits inside until every cell is decided.

    UndecidedError for a number that two hundred more digits do not tell from a decimal.
    """
    require_mode(mode)
    # To the nearest the recipe has proved its rounding to these very digits.
    for guard in (0,) if mode == "nearest" else _GUARDS:
        rows = [[printed(cell, digits, mode) for cell in row] for row in compute(digits + guard)]
        near = next((row for row in rows if None in row), None)
        if near is None:
            return tuple(tuple(map(_text, row)) for row in rows)
    before = ", ".join(map(_text, near[: near.index(None)])) if near else ""
    reason = f"too near to a decimal of {digits} digits to be rounded by {mode!r}"
    raise UndecidedError(f"the value after {before} is {reason}" if before else f"a value is {reason}")


def rounded_so_far(rows: Rows, digits: int, mode: str) -> tuple[tuple[str, ...], ...]:
    """The rows up to the first that these digits do not decide.

    >>> rounded_so_far([("1", Fraction(1, 3)), ("2", Nearest("0.500"))], 3, "floor")
    (('1', '0.333'),)
    """
    made: list[tuple[str, ...]] = []
    for row in rows:
        cells = [printed(cell, digits, mode) for cell in row]
        # What follows would have the same right to stand there, but a table without one of its rows is another table.
        if None in cells:
            break
        made.append(tuple(map(_text, cells)))
    return tuple(made)


def _text(cell: str | None) -> str:
    return cell if isinstance(cell, Formula) else str(cell)
