"""The one number policy: what every public entry accepts as an exact number, and what it refuses by name.

Accepted: text (``"3/2"``, ``"0.1"``, ``"sqrt(2)"``), int, Fraction, Decimal, SymPy rationals and their square roots,
NumPy integers, FLINT integers and rationals, ``ExactReal``.  A float is read as its shortest decimal, because 0.1 is
what was typed and 3602879701896397/2^55 is not; whoever reads one says so in the notes of the result (``float_notes``).

>>> import sympy
>>> [str(exact_number(x, "alpha")) for x in ("3/2", Decimal("1.5"), 1.5, sympy.Rational(3, 2), Fraction(3, 2), 2)]
['3/2', '3/2', '3/2', '3/2', '3/2', '2']
>>> exact_number(2 * sympy.sqrt(3), "alpha"), float_notes(alpha=0.1, b="0.1")
(ExactReal('2*sqrt(3)'), ('alpha: the float 0.1 was read as 1/10',))
>>> exact_number(float("nan"), "alpha")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument alpha: nan is not a finite number (accepted: 3, 3/2, 0.1, ...)
"""

import math
import numbers
import sys
from decimal import Decimal
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from flint import fmpq, fmpz

from asymptotics.errors import InputError, shown
from asymptotics.numbers.exact import REAL_FORMS, ExactReal, parse_rational, parse_real
from asymptotics.numbers.quantities import in_si, magnitude

if TYPE_CHECKING:
    import sympy

    Number = str | int | float | Fraction | Decimal | ExactReal | sympy.Expr | numbers.Integral
else:  # whoever has a SymPy number has loaded SymPy, which takes a quarter of a second
    Number = str | int | float | Fraction | Decimal | ExactReal | numbers.Integral
# Eleven days: nothing rests on it.
_MAX_SECONDS = 10**6
_TOO_LONG = 10**40  # to be told in a message of one line
_MAX_DIGITS = 1000  # as for text: reading a number must not exhaust the machine
_TOO_LARGE = 10**_MAX_DIGITS


def exact_number(value: Any, argument: str, unit: str = "") -> ExactReal:
    """``value`` as an exact real number; InputError names ``argument`` for everything that is not one.

    ``unit``: that of SI in which it is, so that "5 cm" is a number too; some names have one always (``quantities``).
    The one gate for foreign objects: what calls itself a number may fail in any way when it is asked for its value.
    """
    try:
        return _read(value, argument, unit)
    # A LimitError of the time is an InputError, and a lack of memory says nothing about the value: both go through.
    except (InputError, MemoryError):
        raise
    except Exception:
        raise InputError(argument, f"{shown(value)} is not an exact number", REAL_FORMS) from None


def require_one(value: Any, argument: str, many: str) -> None:
    """InputError for an array, a list or a series where one number is asked for; ``many``: the call that takes them.

    >>> require_one([0.0, 1.0], "t", "sample(t)")
    Traceback (most recent call last):
        ...
    asymptotics.errors.InputError: argument t: a list is not one number (accepted: one number; for many: .sample(t))
    """
    if not isinstance(value, str) and (hasattr(value, "__len__") or getattr(value, "ndim", 0) != 0):
        raise InputError(argument, f"{shown(value)} is not one number", f"one number; for many: .{many}")


def exact_double(value: Any, argument: str) -> float:
    """``value`` as the double next to it, where a double will do; InputError where that or its square is none.

    >>> exact_double("1/4", "noise")
    0.25
    >>> exact_double("1e400", "noise")
    Traceback (most recent call last):
        ...
    asymptotics.errors.InputError: argument noise: it is out of the range of doubles (accepted: ...)
    """
    number = exact_number(value, argument)
    try:
        found = double_of(number)
    except OverflowError:
        found = math.inf
    # The squares of such numbers are formed later (variances, energies): neither infinite, nor 0 for what is not 0.
    if not math.isfinite(found * found) or (found * found == 0) != number.is_zero:
        raise InputError(argument, "it is out of the range of doubles", f"about 1e-150 to 1e150 in size: {REAL_FORMS}")
    return found


def double_of(number: ExactReal) -> float:
    """The double next to a rational number, and one of the two beside another; OverflowError where there is none.

    FLINT's own conversion cuts off: it makes 0.09999999999999999 of 1/10.

    >>> double_of(exact_number("0.1", "x")) == 0.1
    True
    """
    return float(number.rational if number.is_rational else number.ball().mid())


def _read(value: Any, argument: str, unit: str) -> ExactReal:
    if isinstance(value, ExactReal):
        return value
    if isinstance(value, str):
        known = in_si(value, argument, unit) if len(value) <= 100 else None
        return parse_real(value, argument) if known is None else ExactReal(known)
    if hasattr(value, "magnitude") and hasattr(value, "to"):
        found = magnitude(value, argument, unit)
        if found is None:
            said = "a quantity with a unit, which is no part of this number"
            raise InputError(argument, said, "its magnitude in the unit that is asked for")
        number, size = found
        return _read(number, argument, unit) * ExactReal(size)
    # Before the integers, among which Python counts True and False.
    if isinstance(value, bool):
        raise InputError(argument, f"{value} is a bool, not a number", REAL_FORMS)
    if isinstance(value, Decimal):
        return ExactReal(_decimal(value, argument))
    if isinstance(value, fmpq | fmpz):
        q = fmpq(value)
        return _sized(Fraction(int(q.p), int(q.q)), argument)
    if isinstance(value, numbers.Rational):  # int, Fraction, SymPy and NumPy integers
        return _sized(Fraction(int(value.numerator), int(value.denominator)), argument)
    if "sympy" in sys.modules and isinstance(value, sys.modules["sympy"].Expr):
        return _from_sympy(value, argument)
    if isinstance(value, numbers.Real):  # float, numpy.float64, numpy.float32
        if not math.isfinite(value):
            raise InputError(argument, f"{value} is not a finite number", REAL_FORMS)
        # The shortest decimal that reads back as this float (of a numpy.float32, as a float32) is what was typed.
        return ExactReal(parse_rational(str(value), argument))
    raise InputError(argument, f"{shown(value)} is not an exact number", REAL_FORMS)


def exact_integer(value: Any, argument: str, low: int, high: int) -> int:
    """``value`` as an int in [low, high]; InputError names ``argument`` otherwise (2.0 is 2, True is refused).

    >>> exact_integer(4.0, "order", 1, 40)
    4
    """
    accepted = f"an integer from {low} to {high}"
    try:
        number = exact_number(value, argument)
    except InputError as error:
        raise InputError(argument, error.reason.replace("an exact number", "an integer"), accepted) from None
    if not number.is_integer:
        written = shown(value) if isinstance(value, str) else str(number)
        raise InputError(argument, f"{written} is not an integer", accepted)
    if not low <= number <= high:
        told = str(number) if abs(number) < _TOO_LONG else f"an integer of {len(str(abs(number)))} digits"
        raise InputError(argument, f"{told} is out of range", accepted)
    return int(number.rational)


def exact_seconds(value: Any, argument: str = "max_seconds") -> float:
    """``value`` as the time that a request may take; InputError outside (0, 10^6].

    >>> exact_seconds("1/2")
    0.5
    """
    number, accepted = exact_number(value, argument), f"a number of seconds > 0, at most {_MAX_SECONDS}"
    if not number.is_rational:  # its size is a matter of balls, which may have to wait for another thread
        raise InputError(argument, f"{number} is not rational", accepted)
    if not 0 < number.rational <= _MAX_SECONDS:
        raise InputError(argument, f"{number} is out of range", accepted)
    return float(number.rational)


def float_notes(**values: Any) -> tuple[str, ...]:
    """One note for each keyword whose value is a float: what it was read as."""
    return tuple(
        f"{name}: the float {value!s} was read as {exact_number(value, name)}"
        for name, value in values.items()
        if isinstance(value, numbers.Real) and not isinstance(value, numbers.Rational | Decimal)
    )


def _sized(q: Fraction, argument: str) -> ExactReal:
    if max(abs(q.numerator), q.denominator) >= _TOO_LARGE:
        raise InputError(argument, f"it has more than {_MAX_DIGITS} digits", REAL_FORMS)
    return ExactReal(q)


def _decimal(value: Decimal, argument: str) -> Fraction:
    if not value.is_finite():
        raise InputError(argument, f"{value} is not a finite number", REAL_FORMS)
    # The size is asked before the Fraction is made: that of Decimal("1e999999") would fill the memory.
    exponent = value.as_tuple().exponent
    if abs(int(exponent)) > _MAX_DIGITS or len(value.as_tuple().digits) > _MAX_DIGITS:
        raise InputError(argument, f"it has more than {_MAX_DIGITS} digits", REAL_FORMS)
    return Fraction(value)


def _from_sympy(value: "sympy.Expr", argument: str) -> ExactReal:
    """A SymPy rational, or a rational times a square root plus a rational."""
    if value.is_Float:
        if not value.is_finite:
            raise InputError(argument, f"{value} is not a finite number", REAL_FORMS)
        raise InputError(argument, f"{value} is a SymPy Float, a binary number", REAL_FORMS)
    offset, rest = value.as_coeff_Add()
    coefficient, root = rest.as_coeff_Mul()
    square = root**2
    # The root is written as sqrt(square), so it must be the positive one; a sign stands in the coefficient.
    if all(part.is_Rational for part in (offset, coefficient, square)) and root.is_positive:
        parts = (Fraction(int(part.p), int(part.q)) for part in (coefficient, square, offset))
        return ExactReal(*parts)
    raise InputError(argument, f"{shown(value)} is not made of rationals and one square root", REAL_FORMS)
