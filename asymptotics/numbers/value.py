"""One number that was computed: correctly rounded digits, and its exact form where one is known.

It is handed out by name, so that nothing is lost without a word: as text, as an mpmath number, as an mpmath interval
that contains the true value, as SymPy, as Fraction, as float.

>>> c = Coefficient("0.424413181578", sympy.Rational(4, 3) / sympy.pi)
>>> str(c), float(c), c.exact
('0.424413181578', 0.424413181578, '4/(3*pi)')
>>> c.interval()                                        # half a unit of the last digit to either side
mpi('0.4244131815775', '0.4244131815785')
>>> c.fraction()
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument coefficient: 4/(3*pi) is not rational (accepted: a rational number)
"""

from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

import mpmath
import sympy
from sympy import Expr

from asymptotics.errors import InputError, shown
from asymptotics.numbers.bridge import from_sympy
from asymptotics.numbers.decimals import rational_decimal


@dataclass(frozen=True)
class Coefficient:
    """Correctly rounded digits ``value`` (None for a symbolic exponent) and the exact form (None if none is known)."""

    value: str | None
    expression: Expr | None
    notes: tuple[str, ...] = field(default=(), compare=False, repr=False)

    def __post_init__(self) -> None:
        if self.value is not None and not isinstance(self.value, str):
            raise InputError("value", f"{shown(self.value)} is no text", "decimal digits, or None")
        if self.expression is not None and not isinstance(self.expression, Expr):
            raise InputError("expression", f"{shown(self.expression)} is not SymPy's", "a SymPy expression, or None")

    @property
    def exact(self) -> str | None:
        """The exact form as text that SymPy reads."""
        return None if self.expression is None else str(self.expression)

    @property
    def is_zero(self) -> bool:
        """Whether the number is 0 by theorem."""
        return self.value == "0" or (self.value is None and self.expression == 0)

    def text(self) -> str:
        """The digits; InputError for a symbolic exponent, which has none."""
        if self.value is None:
            raise InputError("coefficient", f"{self.exact} depends on the exponent", "a number for alpha")
        return self.value

    def mpf(self) -> Any:
        """The digits as an mpmath number of enough precision to hold them."""
        with mpmath.workdps(len(self.text()) + 2):
            return mpmath.mpf(self.text())

    def interval(self) -> Any:
        """An mpmath interval that contains the true value: the digits, half a unit in the last place either way."""
        digits, half = self.text(), self._half_unit()
        low, high = Fraction(digits) - half, Fraction(digits) + half
        precision = mpmath.iv.prec
        try:
            mpmath.iv.prec = 4 * len(digits) + 32
            ends = [mpmath.iv.mpf(q.numerator) / q.denominator for q in (low, high)]
            return mpmath.iv.mpf([ends[0].a, ends[1].b])
        finally:
            mpmath.iv.prec = precision

    def sympy(self) -> Expr:
        """The exact form where one is known, else a SymPy Float with the digits."""
        if self.expression is not None:
            return self.expression
        return sympy.Float(self.text(), len(self.text().lstrip("-0.").replace(".", "").partition("e")[0]))

    def fraction(self) -> Fraction:
        """The number as a Fraction; InputError where it is not known to be rational."""
        if self.expression is None or not self.expression.is_Rational:
            raise InputError("coefficient", f"{self.exact or self.value} is not rational", "a rational number")
        return from_sympy(self.expression)

    def __float__(self) -> float:
        return float(self.text())

    def __str__(self) -> str:
        return self.value or str(self.expression)

    def to_dict(self) -> dict[str, str | None]:
        """Digits and exact form as text."""
        return {"value": self.value, "exact": self.exact}

    def _repr_latex_(self) -> str:
        return f"${self.value if self.expression is None else sympy.latex(self.expression)}$"

    def _half_unit(self) -> Fraction:
        if self.is_zero:
            return Fraction(0)
        mantissa, _, exponent = self.text().lower().partition("e")
        return Fraction(10) ** (int(exponent or 0) - len(mantissa.partition(".")[2])) / 2


def rounded(value: str, digits: int) -> str:
    """A decimal text cut down to ``digits`` significant digits, ties to even; for showing, never for claiming.

    >>> rounded("0.45765585810108791284", 6), rounded("-1.5e-30", 6), rounded("0", 3)
    ('0.457656', '-1.5e-30', '0')
    """
    return rational_decimal(Fraction(value), digits) if len(value) > digits + 2 else value
