"""One number that was computed: correctly rounded digits, and its exact form where one is known.

It is handed out by name, so that nothing is lost without a word: as text, as an mpmath number, as an mpmath interval
that contains the true value, as SymPy, as Fraction, as float.  An exact form that is given as a ``GammaSum`` writes
itself, and becomes SymPy's expression when that is asked for.

>>> import sympy
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

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from operator import add, mul, sub
from typing import TYPE_CHECKING, Any

from flint import arb, fmpq

from asymptotics.errors import InputError, shown
from asymptotics.numbers.decimals import rational_decimal
from asymptotics.numbers.digits import ball_of, interval_of, spread
from asymptotics.numbers.gamma_sums import GammaSum
from asymptotics.numbers.policy import exact_integer, exact_number
from asymptotics.numbers.rationals import decimal_fraction
from asymptotics.present.shown import Page, Shown

if TYPE_CHECKING:
    from sympy import Expr

_MAX_POWER = 1000  # a choice: more leaves no digit of most numbers
# SymPy and mpmath are loaded by who asks for them: a table of digits takes less time than either.


@dataclass(frozen=True)
class Coefficient(Shown):
    """Correctly rounded digits ``value`` (None for a symbolic exponent) and the exact form (None if none is known).

    >>> from asymptotics.numbers.gamma_sums import GammaSum
    >>> c = Coefficient("0.25", GammaSum.rational(1) / 4)
    >>> c.exact, "expression" in vars(c), c.expression, "expression" in vars(c)
    ('1/4', False, 1/4, True)
    """

    value: str | None
    expression: "Expr | None"
    notes: tuple[str, ...] = field(default=(), compare=False, repr=False)

    def __post_init__(self) -> None:
        if self.value is not None and not isinstance(self.value, str):
            raise InputError("value", f"{shown(self.value)} is no text", "decimal digits, or None")
        form: Any = self.expression
        if isinstance(form, GammaSum):
            # Kept beside it: the field itself is made when it is asked for.
            self.__dict__["_form"] = form
            del self.__dict__["expression"]
        elif form is not None and not _is_expression(form):
            raise InputError("expression", f"{shown(self.expression)} is not SymPy's", "a SymPy expression, or None")

    def __getattr__(self, name: str) -> Any:
        form = self.__dict__.get("_form") if name == "expression" else None
        if form is None:
            raise AttributeError(f"a Coefficient has no {name}")
        # Kept, as any field is.
        self.__dict__["expression"] = found = form.to_sympy()
        return found

    @property
    def _exact_form(self) -> Any:
        """The exact form as it was given, or None."""
        return self.__dict__.get("_form") or self.expression

    @property
    def exact(self) -> str | None:
        """The exact form as text that SymPy reads."""
        return None if self._exact_form is None else str(self._exact_form)

    @property
    def is_sum(self) -> bool:
        """Whether the exact form is a sum, which needs brackets before a power."""
        form = self._exact_form
        return form.is_sum if isinstance(form, GammaSum) else form is not None and bool(form.is_Add)

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
        from asymptotics.numbers.decimal_context import mpf_of  # noqa: PLC0415 (mpmath)

        return mpf_of(decimal_fraction(self.text()), len(self.text()) + 2)

    def interval(self) -> Any:
        """An mpmath interval that contains the true value: the digits, half a unit in the last place either way."""
        return interval_of(self.text())

    def ball(self) -> arb:
        """The same as a ball of python-flint, at the precision in force."""
        return ball_of(self.text())

    def sympy(self) -> "Expr":
        """The exact form where one is known, else a SymPy Float with the digits."""
        if self.expression is not None:
            return self.expression
        # As many digits as are written: the mantissa without sign, point and the zeros in front.
        digits = len(self.text().lstrip("-0.").replace(".", "").partition("e")[0])
        from asymptotics.numbers.bridge import to_float  # noqa: PLC0415 (SymPy)

        return to_float(decimal_fraction(self.text()), digits)

    def fraction(self) -> Fraction:
        """The number as a Fraction; InputError where it is not known to be rational."""
        if self.expression is None or not self.expression.is_Rational:
            raise InputError("coefficient", f"{self.exact or self.value} is not rational", "a rational number")
        from asymptotics.numbers.bridge import from_sympy  # noqa: PLC0415 (SymPy)

        return from_sympy(self.expression)

    def _combined(self, other: Any, operation: Callable[[Any, Any], Any]) -> Any:
        """An mpmath interval that contains the true result; a number beside it is read by the number policy."""
        from asymptotics.numbers.decimal_context import interval, intervals  # noqa: PLC0415 (mpmath)

        digits = len(self.text())
        if isinstance(other, Coefficient):
            digits = max(digits, len(other.text()))
        # Four bits are more than a decimal: what the digits leave is the width, and not the arithmetic.
        with intervals(4 * digits + 32):
            beside = other.interval() if isinstance(other, Coefficient) else interval(exact_number(other, "operand"))
            return operation(self.interval(), beside)

    def __add__(self, other: Any) -> Any:
        """Sums, differences, products and quotients are mpmath intervals: no digit of theirs is claimed.

        >>> found = 1 - 3 * Coefficient("0.3333", None)
        >>> found.a < 0 < found.b, found.b < 0.0003
        (True, True)
        """
        return self._combined(other, add)

    def __sub__(self, other: Any) -> Any:
        return self._combined(other, sub)

    def __mul__(self, other: Any) -> Any:
        return self._combined(other, mul)

    def __truediv__(self, other: Any) -> Any:
        return self._combined(other, _quotient)

    def __rsub__(self, other: Any) -> Any:
        return self._combined(other, lambda a, b: b - a)

    def __rtruediv__(self, other: Any) -> Any:
        return self._combined(other, lambda a, b: _quotient(b, a))

    def __neg__(self) -> Any:
        return 0 - self

    def __pow__(self, n: int) -> Any:
        power = exact_integer(n, "power", -_MAX_POWER, _MAX_POWER)
        return self._combined(1, lambda a, one: a**power if power >= 0 else _quotient(one, a**-power))

    def __abs__(self) -> Any:
        return self._combined(0, lambda a, _: abs(a))

    __radd__, __rmul__ = __add__, __mul__

    def __float__(self) -> float:
        return float(self.text())

    def __str__(self) -> str:
        return self.value or str(self.exact)

    def to_dict(self) -> dict[str, str | None]:
        """Digits and exact form as text."""
        return {"value": self.value, "exact": self.exact}

    def _page(self) -> Page:
        claim = "correctly rounded" if self.value is not None else "a function of the exponent"
        exact = () if self.exact is None or self.value is None else (f"= {self.exact}",)
        return Page(str(self), (*exact, claim, *self.notes))

    def _formula(self) -> str:
        form = self._exact_form
        if form is None:
            return str(self.value)
        if isinstance(form, GammaSum):
            return form.latex()
        from sympy import latex  # noqa: PLC0415 (SymPy)

        return str(latex(form))


def _is_expression(value: object) -> bool:
    from sympy import Expr  # noqa: PLC0415 (SymPy, which is loaded where there is an expression)

    return isinstance(value, Expr)


def _quotient(a: Any, b: Any) -> Any:
    if 0 in b:
        raise InputError("divisor", "it may be 0", "a number that its digits tell from 0")
    return a / b


def number_of(found: Any, name: str) -> Coefficient:
    """A field of correctly rounded digits of a certified result as a number: mpf, interval, ball, float.

    InputError for a result that is not certified (its digits are an estimate), and for a field that holds no number.
    """
    if not isinstance(name, str) or not isinstance(getattr(found, name, None), str):
        raise InputError("name", f"{shown(name)} is no number of a {type(found).__name__}", "the name of a field")
    if not found.certified:
        raise InputError("name", f"{name} is not certified: no interval is known to hold it", "a certified result")
    return Coefficient(getattr(found, name), None)


def as_rational(form: Any) -> fmpq | None:
    """The rational that an exact form is, of a ``GammaSum`` or an expression of SymPy; None where none is known."""
    if isinstance(form, GammaSum):
        return form.as_rational
    return fmpq(int(form.p), int(form.q)) if form is not None and form.is_Rational else None


def coefficient_columns(found: Sequence[Coefficient]) -> dict[str, list[Any]]:
    """Columns of a data frame: doubles, both ends of the interval that holds the number, all digits, the exact form.

    >>> import sympy
    >>> columns = coefficient_columns([Coefficient("0.333", sympy.Rational(1, 3))])
    >>> columns["value"], columns["value_low"][0] <= 0.3325, columns["exact"]
    ([0.333], True, ['1/3'])
    """
    return spread("value", [c.value for c in found]) | {"exact": [c.exact for c in found]}


def rounded(value: str, digits: int) -> str:
    """A decimal text cut down to ``digits`` significant digits, ties to even; for showing, never for claiming.

    >>> rounded("0.45765585810108791284", 6), rounded("-1.5e-30", 6), rounded("0", 3)
    ('0.457656', '-1.5e-30', '0')
    """
    return rational_decimal(decimal_fraction(value), digits) if len(value) > digits + 2 else value
