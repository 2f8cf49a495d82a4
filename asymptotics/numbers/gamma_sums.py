"""Sums of rational multiples of products of Gamma(x)^n, x > 0 rational: the closed forms of moments, without SymPy.

Gamma of a whole number is rational, of half an odd number a rational times the root of pi, so that Q[pi, 1/pi] is
among them.  Nothing else is reduced: two sums that are equal as written are equal, others may be (Gamma has more
relations).

>>> x = gamma(fmpq(7, 4)) / (gamma(HALF) * gamma(fmpq(9, 4)))
>>> x, 2 * x**2 - gamma(fmpq(5, 2)) * gamma(HALF)
(gamma(7/4)/(sqrt(pi)*gamma(9/4)), -3*pi/4 + 2*gamma(7/4)**2/(pi*gamma(9/4)**2))
>>> x.ball().str(10), x.to_sympy()
('[0.4576558581 +/- ...]', gamma(7/4)/(sqrt(pi)*gamma(9/4)))
"""

from collections.abc import Iterable
from dataclasses import dataclass
from math import factorial
from typing import TYPE_CHECKING, Any

from flint import arb, fmpq

from asymptotics.numbers import gamma_text
from asymptotics.numbers.gamma_text import HALF, Monomial, Term

if TYPE_CHECKING:
    from sympy import Expr


@dataclass(frozen=True, repr=False)
class GammaSum:
    """The sum of ``terms``: factors that are not 0, each before a monomial of its own."""

    terms: tuple[Term, ...] = ()

    @classmethod
    def of(cls, terms: Iterable[Term]) -> "GammaSum":
        """The sum of terms that may have a monomial in common, or a factor 0."""
        found: dict[Monomial, fmpq] = {}
        for q, monomial in terms:
            found[monomial] = found.get(monomial, fmpq(0)) + q
        return cls(tuple((q, monomial) for monomial, q in sorted(found.items()) if q != 0))

    @classmethod
    def rational(cls, q: fmpq | int) -> "GammaSum":
        """A rational number."""
        return cls.of([(fmpq(q), ())])

    @property
    def is_sum(self) -> bool:
        """Whether there are two terms or more."""
        return len(self.terms) > 1

    @property
    def as_rational(self) -> fmpq | None:
        """The number where nothing but a rational is written; None elsewhere."""
        return sum((q for q, _ in self.terms), start=fmpq(0)) if all(not m for _, m in self.terms) else None

    def ball(self) -> arb:
        """An enclosure at the current working precision."""
        return sum(map(gamma_text.value, self.terms), start=arb(0))

    def latex(self) -> str:
        """The sum as SymPy writes it in LaTeX."""
        return gamma_text.latex(self.terms)

    def to_sympy(self) -> "Expr":
        """The sum as a SymPy expression, which is loaded here."""
        import sympy  # noqa: PLC0415 (it takes longer to load than the sum takes to be computed and written)

        from asymptotics.numbers.bridge import to_sympy  # noqa: PLC0415 (as above)

        products = ([to_sympy(q), *(sympy.gamma(to_sympy(x)) ** n for x, n in powers)] for q, powers in self.terms)
        return sympy.Add(*(sympy.Mul(*product) for product in products))

    def __add__(self, other: Any) -> "GammaSum":
        return GammaSum.of(self.terms + _read(other).terms)

    def __mul__(self, other: Any) -> "GammaSum":
        return GammaSum.of((p * q, _product(x, y)) for p, x in self.terms for q, y in _read(other).terms)

    def __truediv__(self, other: Any) -> "GammaSum":
        """By a rational, or by one term; ValueError for a sum."""
        [(q, monomial)] = _read(other).terms
        return self * GammaSum(((1 / q, tuple((x, -n) for x, n in monomial)),))

    def __pow__(self, n: int) -> "GammaSum":
        found = GammaSum.rational(1)
        for _ in range(n):
            found *= self
        return found

    def __neg__(self) -> "GammaSum":
        return self * -1

    def __sub__(self, other: Any) -> "GammaSum":
        return self + -_read(other)

    __radd__, __rmul__ = __add__, __mul__

    def __repr__(self) -> str:
        return gamma_text.text(self.terms)


def gamma(x: fmpq) -> GammaSum:
    """Gamma(x), x > 0."""
    if x.q > 2:
        return GammaSum(((fmpq(1), ((x, 1),)),))
    if x.q == 1:
        return GammaSum.rational(factorial(int(x) - 1))
    # Gamma(n + 1/2) = (2n)!/(4^n n!) sqrt(pi).
    n = int(x - HALF)
    return GammaSum(((fmpq(factorial(2 * n), 4**n * factorial(n)), ((HALF, 1),)),))


def _read(x: Any) -> GammaSum:
    return x if isinstance(x, GammaSum) else GammaSum.rational(x)


def _product(x: Monomial, y: Monomial) -> Monomial:
    found = dict(x)
    for argument, n in y:
        found[argument] = found.get(argument, 0) + n
    powers = [(argument, n) for argument, n in found.items() if n]
    return tuple(sorted(powers, key=lambda power: (power[0] != HALF, power[0])))
