"""Exact numbers of Q[pi, 1/pi]: the coefficients of every expansion at integer exponents.

pi is transcendental, so the representation is unique and equality is decided by comparing coefficients.

>>> x = PiNumber.rational(fmpq(4, 3)) / PI
>>> x, x * PI, (1 + x) * (1 - x)
(4/(3*pi), 4/3, 1 - 16/(9*pi**2))
>>> 1 / (1 + PI)
Traceback (most recent call last):
    ...
ZeroDivisionError: 1 + pi is not a unit of Q[pi, 1/pi]
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from flint import arb, fmpq, fmpq_poly

from asymptotics.numbers.gamma_sums import GammaSum
from asymptotics.numbers.gamma_text import HALF

if TYPE_CHECKING:
    from sympy import Expr


@dataclass(frozen=True, repr=False, eq=False)
class PiNumber:
    """pi^shift * polynomial(pi), with a nonzero constant term of the polynomial unless the number is 0."""

    polynomial: fmpq_poly
    shift: int = 0

    @classmethod
    def rational(cls, q: Any) -> "PiNumber":
        """A rational number (int or fmpq)."""
        return cls(fmpq_poly([q]))

    @classmethod
    def normal(cls, polynomial: fmpq_poly, shift: int) -> "PiNumber":
        """The unique representation: powers of pi are moved from the polynomial to the shift."""
        low = 0
        while low < polynomial.length() and polynomial[low] == 0:
            low += 1
        if low == polynomial.length():
            return cls(fmpq_poly([]))
        return cls(polynomial if low == 0 else polynomial.right_shift(low), shift + low)

    @property
    def terms(self) -> dict[int, fmpq]:
        """Exponent of pi -> rational coefficient, without zeros."""
        return {self.shift + n: c for n, c in enumerate(self.polynomial.coeffs()) if c != 0}

    @property
    def is_rational(self) -> bool:
        """Whether no power of pi remains."""
        return not self.terms or (self.shift == 0 and self.polynomial.length() == 1)

    def as_rational(self) -> fmpq:
        """The number as fmpq; ValueError if it is irrational."""
        if not self.is_rational:
            raise ValueError(f"{self} is irrational")
        return self.polynomial[0]

    def ball(self) -> arb:
        """An enclosure at the current working precision."""
        pi = arb.pi()
        return sum((arb(c) * pi**n for n, c in self.terms.items()), start=arb(0))

    def closed(self) -> GammaSum:
        """The number as a closed form, which writes itself."""
        return GammaSum.of((c, ((HALF, 2 * n),) if n else ()) for n, c in self.terms.items())

    def to_sympy(self) -> "Expr":
        """The number as a SymPy expression."""
        return self.closed().to_sympy()

    def __add__(self, other: Any) -> "PiNumber":
        b = _lift(other)
        if b is None:
            return NotImplemented
        if self.shift == b.shift:
            return PiNumber.normal(self.polynomial + b.polynomial, self.shift)
        low, high = (self, b) if self.shift < b.shift else (b, self)
        return PiNumber.normal(low.polynomial + high.polynomial.left_shift(high.shift - low.shift), low.shift)

    __radd__ = __add__

    def __neg__(self) -> "PiNumber":
        return PiNumber(-self.polynomial, self.shift)

    def __sub__(self, other: Any) -> "PiNumber":
        b = _lift(other)
        if b is None:
            return NotImplemented
        return self + (-b)

    def __rsub__(self, other: Any) -> "PiNumber":
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> "PiNumber":
        if isinstance(other, PiNumber):
            # Already the unique form: the product of two constant terms that are not 0 is not 0.
            product = self.polynomial * other.polynomial
            return PiNumber(product, self.shift + other.shift if product.length() else 0)
        b = _lift(other)
        if b is None:
            return NotImplemented
        return self * b

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> "PiNumber":
        b = _lift(other)
        if b is None:
            return NotImplemented
        return self * b.inverse()

    def __rtruediv__(self, other: Any) -> "PiNumber":
        return self.inverse().__mul__(other)

    def inverse(self) -> "PiNumber":
        """1/self for a single term; ZeroDivisionError otherwise."""
        # The units of Q[pi, 1/pi] are the q pi^n, for pi is transcendental (Lindemann).
        if self.polynomial.length() != 1:
            raise ZeroDivisionError(f"{self} is not a unit of Q[pi, 1/pi]")
        return PiNumber(fmpq_poly([1 / self.polynomial[0]]), -self.shift)

    def __eq__(self, other: object) -> bool:
        b = _lift(other)
        return b is not None and self.shift == b.shift and bool(self.polynomial == b.polynomial)

    def __hash__(self) -> int:
        return hash((self.shift, tuple(str(c) for c in self.polynomial.coeffs())))

    def __repr__(self) -> str:
        return repr(self.closed())


def _lift(x: Any) -> PiNumber | None:
    if isinstance(x, PiNumber):
        return x
    return PiNumber(fmpq_poly([x])) if isinstance(x, int | fmpq) else None


PI = PiNumber(fmpq_poly([1]), 1)
