"""Polynomials in one variable over any coefficient ring, as coefficients of a series in delta.

>>> p = TauPolynomial((1, 2))
>>> (p * p - 1).coefficients, p.shift().coefficients
((0, 4, 4), (0, 1, 2))
"""

from dataclasses import dataclass
from typing import Any

from asymptotics.series import divided


@dataclass(frozen=True)
class TauPolynomial:
    """The polynomial sum_k coefficients[k] tau^k."""

    coefficients: tuple[Any, ...]

    @classmethod
    def lift(cls, x: Any) -> "TauPolynomial":
        """A number as a constant polynomial; a polynomial as itself."""
        return x if isinstance(x, TauPolynomial) else cls((x,))

    def coefficient(self, k: int) -> Any:
        """The coefficient of tau^k, 0 beyond the degree."""
        return self.coefficients[k] if k < len(self.coefficients) else 0

    def shift(self) -> "TauPolynomial":
        """The polynomial times tau."""
        return TauPolynomial((0, *self.coefficients))

    def __add__(self, other: Any) -> "TauPolynomial":
        a, b = self.coefficients, TauPolynomial.lift(other).coefficients
        if len(a) < len(b):
            a, b = b, a
        return TauPolynomial(tuple(x + y for x, y in zip(a, b)) + a[len(b) :])

    __radd__ = __add__

    def __neg__(self) -> "TauPolynomial":
        return TauPolynomial(tuple(-x for x in self.coefficients))

    def __sub__(self, other: Any) -> "TauPolynomial":
        return self + (-TauPolynomial.lift(other))

    def __mul__(self, other: Any) -> "TauPolynomial":
        b = TauPolynomial.lift(other).coefficients
        total: list[Any] = [0] * (len(self.coefficients) + len(b) - 1)
        for i, x in enumerate(self.coefficients):
            # Only the integer 0 that pads is skipped: a ball around 0 counts.
            if not (isinstance(x, int) and x == 0):
                for j, y in enumerate(b):
                    total[i + j] = total[i + j] + x * y
        return TauPolynomial(tuple(total))

    __rmul__ = __mul__

    def __truediv__(self, n: Any) -> "TauPolynomial":
        return TauPolynomial(tuple(divided(x, n) for x in self.coefficients))
