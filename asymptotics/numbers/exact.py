"""What a user may type as a number, read exactly, and the numbers that come of it.

>>> parse_rational("-2.5e-3", "--epsilon")
Fraction(-1, 400)
>>> parse_real("sqrt(8/2)", "--alpha"), parse_real("sqrt(2)", "--alpha")
(ExactReal('2'), ExactReal('sqrt(2)'))
>>> parse_real("__import__('os')", "--alpha")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument --alpha: "__import__('os')" is not an exact number (accepted: ...)

The grammar is a regular expression: nothing that is typed is ever evaluated.  Exponents have at most three digits and
a number at most a thousand characters, so reading one cannot exhaust the machine.  What other libraries call a number
is read by ``numbers.policy``.
"""

import re
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from functools import reduce
from math import isqrt
from numbers import Rational
from operator import mul
from typing import Any

from flint import arb, fmpq

from asymptotics.errors import AbsentError, InputError, shown
from asymptotics.numbers.context import ctx, inside
from asymptotics.numbers.integers import require_integer, shown_text
from asymptotics.numbers.quantities import unit_behind
from asymptotics.present.shown import Page, Shown

# Long enough for any number that is typed, far beyond the doubles, and short enough to be read at once; no repetition
# stands within another, so that no text takes the expression long.
_NUMBER = r"[+-]?(?:\d{1,400}(?:\.\d{0,400})?|\.\d{1,400})(?:[eE][+-]?\d{1,3})?(?:/\d{1,400})?"
_RATIONAL = re.compile(_NUMBER + r"\Z", re.ASCII)
_PRINTED = re.compile(_NUMBER.replace(r"\d{1,3})?(?:/", r"\d{1,5})?(?:/") + r"\Z", re.ASCII)
# A root as it is typed, sqrt(2), and as a number with one is written: 2/3*sqrt(2) - 1.
_ROOT = re.compile(
    rf"(?P<factor>[+-]?|{_NUMBER}\*)sqrt\((?P<radicand>{_NUMBER})\)(?: (?P<offset>[+-] {_NUMBER[5:]}))?\Z", re.ASCII
)

# A limit of memory: such a power of a fraction has a hundred thousand times its digits.
MAX_POWER = 100_000
MAX_ORDER = 100_000
"""No series is that long; what an order costs is estimated where it is computed."""
RATIONAL_FORMS = "3, 3/2, 0.1, -2.5e-3"
REAL_FORMS = RATIONAL_FORMS + ", sqrt(2), sqrt(3/2)"
_ZERO, _ONE, _PLAIN = Fraction(0), Fraction(1), (int, Fraction)


@dataclass(frozen=True, init=False, repr=False, eq=False)
class ExactReal(Shown):
    """The real number ``coefficient * sqrt(radicand) + offset``, exactly; a rational number is its ``coefficient``.

    Equality and order are those of the numbers, decided by signs and squares, so no integer is ever factored.  Sums and
    products stay exact as long as one root suffices; InputError otherwise.

    >>> x = parse_real("sqrt(2)", "x")
    >>> str(x), x.is_rational, x > 1, x * x == 2, x + parse_real("sqrt(8)", "y") == 3 * x
    ('sqrt(2)', False, True, True, True)
    >>> ExactReal(Fraction(1), Fraction(4)), x - 1, 1 / (x - 1) == x + 1
    (ExactReal('2'), ExactReal('sqrt(2) - 1'), True)
    >>> x + parse_real("sqrt(3)", "y")
    Traceback (most recent call last):
        ...
    asymptotics.errors.InputError: argument sum: sqrt(2) + sqrt(3) needs two roots (accepted: ...)
    """

    coefficient: Fraction
    radicand: Fraction
    offset: Fraction

    def __init__(self, coefficient: Fraction | int, radicand: Fraction | int = 1, offset: Fraction | int = 0) -> None:
        for name, value in (("coefficient", coefficient), ("radicand", radicand), ("offset", offset)):
            if isinstance(value, bool) or not isinstance(value, int | Fraction):
                raise InputError(name, f"{shown(value)} is no rational number", "a Fraction or an int")
        if radicand < 0:
            raise InputError("radicand", "it is negative: its root is not real", "a number >= 0")
        parts: tuple[Fraction | int, ...]
        # Rationals come often, and need no test for squares.
        if radicand == 1:
            parts = (coefficient + offset if offset else coefficient, _ONE, _ZERO)
        else:
            # A rational root is taken, so that a root is left exactly where
            # the number is irrational: sign, equality and hash rest on that.
            root = _rational_root(Fraction(radicand)) if coefficient else _ZERO
            parts = (coefficient, radicand, offset) if root is None else (coefficient * root + offset, _ONE, _ZERO)
        for name, value in zip(("coefficient", "radicand", "offset"), parts):
            object.__setattr__(self, name, value if type(value) is Fraction else Fraction(value))

    @property
    def is_rational(self) -> bool:
        """Whether the number is rational (then it equals ``coefficient``)."""
        return self.radicand is _ONE or self.radicand == 1  # a copy from another process has a 1 of its own

    @property
    def is_integer(self) -> bool:
        """Whether the number is an integer."""
        return self.is_rational and self.coefficient.denominator == 1

    @property
    def is_zero(self) -> bool:
        """Whether the number is 0."""
        return not self.coefficient

    @property
    def sign(self) -> int:
        """-1, 0 or 1: of the greater in size of the two parts, root and offset."""
        # Where a root is left the two parts are not of one size,
        # else the root were rational: the larger one has the sign.
        root, square = _sign(self.coefficient), self.coefficient**2 * self.radicand
        return root if square > self.offset**2 else _sign(self.offset)

    @property
    def rational(self) -> Fraction:
        """The number as a Fraction; AbsentError if it is irrational."""
        if not self.is_rational:
            raise AbsentError("number", f"{self} is irrational", "a rational number")
        return self.coefficient

    @inside
    def ball(self) -> arb:
        """An enclosure at the current working precision; it holds 0 for 0 alone, however much cancels.

        The precision doubles until it does, without a limit as in ``precision``: a number that is not rational is not
        0, so that this ends.
        """
        q = arb(fmpq(self.coefficient.numerator, self.coefficient.denominator))
        if self.is_rational:
            return q
        root = arb(fmpq(self.radicand.numerator, self.radicand.denominator)).sqrt()
        found = q * root + fmpq(self.offset.numerator, self.offset.denominator)
        if found.contains(0):
            with ctx.workprec(2 * ctx.prec):
                return self.ball()
        return found

    def _compared(self, other: Any) -> int:
        """The sign of self - other, whatever the two roots."""
        # Most numbers that are compared are rational, and one of them plain: no difference has to be made.
        plain = self.is_rational and type(other) in _PLAIN
        y = self if plain else _exact(other)
        if y.is_rational:
            a, b = self.coefficient, other if plain else y.coefficient
            if not self.is_rational:
                return (self - y).sign
            difference = a.numerator * b.denominator - b.numerator * a.denominator
            return (difference > 0) - (difference < 0)
        rest = self - y.offset  # against the root of y: by signs, else by squares
        root = _sign(y.coefficient)
        # The signs are -1, 0, 1 and that of y's root is not 0: their difference has the sign of self - other.
        if rest.sign != root:
            return rest.sign - root
        # Of one sign: the squares tell, the other way round where both are negative. They hold the root of self alone.
        return root * (rest * rest - y.coefficient**2 * y.radicand).sign

    def __eq__(self, other: object) -> bool:
        comparable = isinstance(other, Rational | ExactReal) and not isinstance(other, bool)
        return self._compared(other) == 0 if comparable else NotImplemented

    def __hash__(self) -> int:
        if self.is_rational:
            return hash(self.coefficient)
        # 2 sqrt(2) and sqrt(8) are equal: equal numbers have equal
        # offsets and equal squares of what stands beside them.
        return hash((self.offset, _sign(self.coefficient), self.coefficient**2 * self.radicand))

    def __lt__(self, other: "int | Fraction | ExactReal") -> bool:
        return self._compared(other) < 0

    def __gt__(self, other: "int | Fraction | ExactReal") -> bool:
        return self._compared(other) > 0

    def __le__(self, other: "int | Fraction | ExactReal") -> bool:
        return self._compared(other) <= 0

    def __ge__(self, other: "int | Fraction | ExactReal") -> bool:
        return self._compared(other) >= 0

    def __neg__(self) -> "ExactReal":
        return ExactReal(-self.coefficient, self.radicand, -self.offset)

    def __abs__(self) -> "ExactReal":
        return -self if self.sign < 0 else self

    def __add__(self, other: "int | Fraction | ExactReal") -> "ExactReal":
        a, b, root, c, d = _over_one_root(self, _exact(other), "+")
        return ExactReal(a + c, root, b + d)

    def __mul__(self, other: "int | Fraction | ExactReal") -> "ExactReal":
        y = _exact(other)
        if not self.offset and not y.offset:
            return ExactReal(self.coefficient * y.coefficient, self.radicand * y.radicand)
        a, b, root, c, d = _over_one_root(self, y, "*")
        return ExactReal(a * d + b * c, root, a * c * root + b * d)

    def _inverse(self) -> "ExactReal":
        """By the conjugate; InputError for 0."""
        if self.is_zero:
            raise InputError("divisor", "it is 0", "a number other than 0")
        if self.is_rational:
            return ExactReal(1 / self.coefficient)
        # Not 0, as the number is irrational.
        norm = self.offset**2 - self.coefficient**2 * self.radicand
        return ExactReal(-self.coefficient / norm, self.radicand, self.offset / norm)

    def __sub__(self, other: "int | Fraction | ExactReal") -> "ExactReal":
        return self + -_exact(other)

    def __rsub__(self, other: "int | Fraction") -> "ExactReal":
        return _exact(other) + -self

    def __truediv__(self, other: "int | Fraction | ExactReal") -> "ExactReal":
        return self * _exact(other)._inverse()

    def __rtruediv__(self, other: "int | Fraction") -> "ExactReal":
        return _exact(other) * self._inverse()

    def __pow__(self, n: int) -> "ExactReal":
        require_integer(n, "exponent", -MAX_POWER, MAX_POWER)
        base = self if n >= 0 else self._inverse()
        if not base.offset:
            half, odd = divmod(abs(n), 2)
            return ExactReal(base.coefficient ** abs(n) * base.radicand**half, base.radicand if odd else Fraction(1))
        return reduce(mul, [base] * abs(n), ExactReal(Fraction(1)))

    __radd__, __rmul__ = __add__, __mul__

    def __str__(self) -> str:
        coefficient = _text(self.coefficient)
        if self.is_rational:
            return coefficient
        factor = {"1": "", "-1": "-"}.get(coefficient, f"{coefficient}*")
        rest = f" {'-' if self.offset < 0 else '+'} {_text(abs(self.offset))}" if self.offset else ""
        return f"{factor}sqrt({_text(self.radicand)}){rest}"

    def __repr__(self) -> str:
        return f"ExactReal({str(self)!r})"

    def _page(self) -> Page:
        return Page(str(self), ("exact",))

    def _formula(self) -> str:
        text, root = _latex(self.coefficient), "" if self.is_rational else rf"\sqrt{{{_latex(self.radicand)}}}"
        factor = {"1": "", "-1": "-"}.get(text, text + r"\,") if root else text
        rest = f" {'-' if self.offset < 0 else '+'} {_latex(abs(self.offset))}" if root and self.offset else ""
        return f"{factor}{root}{rest}"


def _exact(x: object) -> ExactReal:
    """An operand as an exact number; InputError for a float, whose binary value is not what was typed."""
    if isinstance(x, ExactReal):
        return x
    if isinstance(x, bool) or not isinstance(x, Rational):  # the rationals of NumPy and SymPy are registered as such
        raise InputError("operand", f"{shown(x)} is no exact number", "an int, a Fraction or an ExactReal")
    try:
        return ExactReal(Fraction(int(x.numerator), int(x.denominator)))
    except Exception:  # a foreign class may call itself rational and raise anything when it is asked for its value
        raise InputError("operand", f"{shown(x)} has no value", "an int, a Fraction or an ExactReal") from None


def _latex(q: Fraction) -> str:
    top, _, bottom = _text(abs(q)).partition("/")
    return ("-" if q < 0 else "") + (rf"\frac{{{top}}}{{{bottom}}}" if bottom else top)


def _text(q: Fraction) -> str:
    """p or p/q, of any size: Python refuses to print an integer of more than 4300 digits."""
    return str(fmpq(q.numerator, q.denominator))


def _sign(q: Fraction) -> int:
    return (q > 0) - (q < 0)


def _over_one_root(
    x: ExactReal, y: ExactReal, operation: str
) -> tuple[Fraction, Fraction, Fraction, Fraction, Fraction]:
    """(a, b, r, c, d) with x = a sqrt(r) + b and y = c sqrt(r) + d; InputError when there is no such r."""
    if y.is_rational:
        parts = (x.coefficient, x.offset) if not x.is_rational else (Fraction(0), x.coefficient)
        return *parts, x.radicand, Fraction(0), y.coefficient
    if x.is_rational:
        return Fraction(0), x.coefficient, y.radicand, y.coefficient, y.offset
    # sqrt(r')/sqrt(r) is rational exactly where r'/r is the square of a rational.
    ratio = _rational_root(y.radicand / x.radicand)
    if ratio is None:
        name = "sum" if operation == "+" else "product"
        raise InputError(name, f"{x} {operation} {y} needs two roots", "numbers with one square root between them")
    return x.coefficient, x.offset, x.radicand, y.coefficient * ratio, y.offset


def _rational_root(q: Fraction) -> Fraction | None:
    """The square root of q >= 0 when it is rational, else None."""
    # A fraction in lowest terms is a square exactly where both its terms are.
    a, b = isqrt(q.numerator), isqrt(q.denominator)
    return Fraction(a, b) if a * a == q.numerator and b * b == q.denominator else None


def square_root(q: Fraction) -> ExactReal:
    """The square root of a rational q >= 0, reduced when q is a square.

    >>> square_root(Fraction(9, 4)), square_root(Fraction(3, 2))
    (ExactReal('3/2'), ExactReal('sqrt(3/2)'))
    """
    return ExactReal(Fraction(1), q)


def parse_rational(text: str, argument: str, accepted: str = RATIONAL_FORMS) -> Fraction:
    """Read an integer, a fraction or a decimal (with exponent) exactly; InputError names ``argument`` otherwise."""
    return _fraction(text, argument, accepted, _RATIONAL)


def parse_printed(text: str, argument: str) -> Fraction:
    """A number that this package printed: its exponent may be longer than one that is typed (an amplitude of e^-40000).

    >>> parse_printed("2.5e-17372", "x") * 10**17373
    Fraction(25, 1)
    """
    return _fraction(text, argument, RATIONAL_FORMS, _PRINTED)


def _fraction(text: str, argument: str, accepted: str, form: re.Pattern[str]) -> Fraction:
    stripped = text.strip()
    if len(stripped) > 1000 or not form.match(stripped):
        why = ": it has a comma, and decimals have a point" if "," in stripped else ""
        unit = unit_behind(stripped) if len(stripped) <= 100 else ""
        why += f": it has the unit {unit}, which is no part of this number" if unit else ""
        raise InputError(argument, f"{shown_text(text)} is not an exact number{why}", accepted)
    number, _, denominator = stripped.partition("/")
    if denominator and not int(denominator):
        raise InputError(argument, f"{shown_text(text)} has a zero denominator", accepted)
    # The constructor of Decimal keeps every digit, whatever the context of decimals is.
    found = Fraction(*Decimal(number).as_integer_ratio())
    return found / int(denominator) if denominator else found


def parse_real(text: str, argument: str) -> ExactReal:
    """Read a rational, ``sqrt(rational)`` or the text of an ``ExactReal`` exactly; InputError names ``argument``.

    >>> x = ExactReal(Fraction(2, 3), 2, -1)
    >>> str(x), parse_real(str(x), "x") == x
    ('2/3*sqrt(2) - 1', True)
    """
    root = _ROOT.match(text.strip()) if len(text) <= 1000 else None
    if not root:
        return ExactReal(parse_rational(text, argument, REAL_FORMS))
    # A sign alone stands for the factor of that sign.
    factor, radicand, offset = (
        parse_rational(part, argument, REAL_FORMS)
        for part in (
            root["factor"][:-1] if root["factor"].endswith("*") else root["factor"] + "1",
            root["radicand"],
            (root["offset"] or "0").replace(" ", ""),
        )
    )
    if radicand < 0:
        raise InputError(argument, f"{shown_text(text)} is not real", REAL_FORMS)
    return ExactReal(factor, radicand, offset)
