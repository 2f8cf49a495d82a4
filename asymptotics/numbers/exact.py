"""What a user may type as a number, read exactly.

>>> parse_rational("-2.5e-3", "--epsilon")
Fraction(-1, 400)
>>> parse_real("sqrt(8/2)", "--alpha"), parse_real("sqrt(2)", "--alpha")
(ExactReal('2'), ExactReal('sqrt(2)'))
>>> parse_real("__import__('os')", "--alpha")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument --alpha: "__import__('os')" is not an exact number (accepted: ...)

The grammar is a regular expression: nothing that is typed is ever evaluated.  Exponents have at most three digits and
a number at most a thousand characters, so reading one cannot exhaust the machine.
"""

import re
from dataclasses import dataclass
from fractions import Fraction
from math import isqrt

from flint import arb, fmpq

from asymptotics.errors import InputError

_NUMBER = r"[+-]?(?:\d{1,400}(?:\.\d{0,400})?|\.\d{1,400})(?:[eE][+-]?\d{1,3})?(?:/\d{1,400})?"
_RATIONAL = re.compile(_NUMBER + r"\Z", re.ASCII)
_ROOT = re.compile(rf"(?P<sign>[+-]?)sqrt\((?P<radicand>{_NUMBER})\)\Z", re.ASCII)
_INTEGER = re.compile(r"[+-]?\d{1,40}\Z", re.ASCII)

RATIONAL_FORMS = "3, 3/2, 0.1, -2.5e-3"
REAL_FORMS = RATIONAL_FORMS + ", sqrt(2), sqrt(3/2)"


@dataclass(frozen=True, repr=False)
class ExactReal:
    """The real number ``coefficient * sqrt(radicand)``, exactly; ``radicand`` is 1 or not a rational square.

    >>> x = parse_real("sqrt(2)", "x")
    >>> str(x), x.is_rational, x > 1
    ('sqrt(2)', False, True)
    """

    coefficient: Fraction
    radicand: Fraction = Fraction(1)

    @property
    def is_rational(self) -> bool:
        """Whether the number is rational (then it equals ``coefficient``)."""
        return self.radicand == 1

    @property
    def rational(self) -> Fraction:
        """The number as a Fraction; ValueError if it is irrational."""
        if not self.is_rational:
            raise ValueError(f"{self} is irrational")
        return self.coefficient

    def ball(self) -> arb:
        """An enclosure at the current working precision."""
        q = arb(fmpq(self.coefficient.numerator, self.coefficient.denominator))
        if self.is_rational:
            return q
        return q * arb(fmpq(self.radicand.numerator, self.radicand.denominator)).sqrt()

    def _signed_square(self) -> Fraction:
        square = self.coefficient**2 * self.radicand
        return square if self.coefficient >= 0 else -square

    def __lt__(self, other: "int | Fraction | ExactReal") -> bool:
        return self._signed_square() < _exact(other)._signed_square()

    def __gt__(self, other: "int | Fraction | ExactReal") -> bool:
        return self._signed_square() > _exact(other)._signed_square()

    def __str__(self) -> str:
        if self.is_rational:
            return str(self.coefficient)
        factor = {"1": "", "-1": "-"}.get(str(self.coefficient), f"{self.coefficient}*")
        return f"{factor}sqrt({self.radicand})"

    def __repr__(self) -> str:
        return f"ExactReal({str(self)!r})"


def _exact(x: "int | Fraction | ExactReal") -> ExactReal:
    return x if isinstance(x, ExactReal) else ExactReal(Fraction(x))


def square_root(q: Fraction) -> ExactReal:
    """The square root of a rational q >= 0, reduced when q is a square.

    >>> square_root(Fraction(9, 4)), square_root(Fraction(3, 2))
    (ExactReal('3/2'), ExactReal('sqrt(3/2)'))
    """
    a, b = isqrt(q.numerator), isqrt(q.denominator)
    if a * a == q.numerator and b * b == q.denominator:
        return ExactReal(Fraction(a, b))
    return ExactReal(Fraction(1), q)


def parse_rational(text: str, argument: str, accepted: str = RATIONAL_FORMS) -> Fraction:
    """Read an integer, a fraction or a decimal (with exponent) exactly; InputError names ``argument`` otherwise."""
    stripped = text.strip()
    if len(stripped) > 1000 or not _RATIONAL.match(stripped):
        raise InputError(argument, f"{_shown(text)} is not an exact number", accepted)
    number, _, denominator = stripped.partition("/")
    if denominator and not int(denominator):
        raise InputError(argument, f"{_shown(text)} has a zero denominator", accepted)
    return Fraction(number) / (int(denominator) if denominator else 1)


def parse_real(text: str, argument: str) -> ExactReal:
    """Read a rational or ``sqrt(rational)`` exactly; InputError names ``argument`` otherwise."""
    root = _ROOT.match(text.strip()) if len(text) <= 1000 else None
    if not root:
        return ExactReal(parse_rational(text, argument, REAL_FORMS))
    radicand = parse_rational(root["radicand"], argument, REAL_FORMS)
    if radicand < 0:
        raise InputError(argument, f"{_shown(text)} is not real", REAL_FORMS)
    value = square_root(radicand)
    return ExactReal(-value.coefficient, value.radicand) if root["sign"] == "-" else value


def parse_integer(text: str, argument: str, low: int, high: int) -> int:
    """Read an integer in [low, high]; InputError names ``argument`` otherwise.

    >>> parse_integer("12", "--n", 1, 100)
    12
    """
    accepted = f"an integer from {low} to {high}"
    if not _INTEGER.match(text.strip()):
        raise InputError(argument, f"{_shown(text)} is not an integer", accepted)
    value = int(text)
    if not low <= value <= high:
        raise InputError(argument, f"{value} is out of range", accepted)
    return value


def _shown(text: str) -> str:
    """The offending text for a one-line message: quoted, and cut if long."""
    return repr(text if len(text) <= 60 else text[:57] + "...")
