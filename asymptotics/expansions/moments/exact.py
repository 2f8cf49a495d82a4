"""M_p of a rational p exactly, without SymPy: whole p as a rational or a rational over pi, others as Gamma quotients.

>>> [moment(fmpq(p)) for p in (4, 3, 1)], moment(fmpq(1, 2)), mean(2, fmpq(2))
([3/8, 4/(3*pi), 2/pi], gamma(3/4)/(sqrt(pi)*gamma(5/4)), 1/8)
"""

from fractions import Fraction

from flint import fmpq

from asymptotics.errors import InputError
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.gamma_sums import GammaSum, gamma
from asymptotics.numbers.gamma_text import HALF
from asymptotics.numbers.rationals import to_fmpq

PI = gamma(HALF) ** 2


def integer_moment(p: int) -> tuple[Fraction, bool]:
    """(q, over_pi): M_p = q for even p, q/pi for odd p, from M_p = (p-1)/p M_(p-2).

    >>> integer_moment(4), integer_moment(5)
    ((Fraction(3, 8), False), (Fraction(16, 15), True))
    """
    if p < 0:
        raise InputError("p", f"{p} is negative", "an integer p >= 0")
    # From M_0 = 1 or M_1 = 2/pi up (Wallis); fmpq, for these products reach large indices.
    value = fmpq(2 if p % 2 else 1)
    for k in range(2 + p % 2, p + 1, 2):
        value *= fmpq(k - 1, k)
    return Fraction(int(value.p), int(value.q)), p % 2 == 1


def number(q: ExactReal | fmpq | int) -> fmpq:
    """A rational number as these functions take it."""
    return to_fmpq(q.rational) if isinstance(q, ExactReal) else fmpq(q)


def moment(p: fmpq) -> GammaSum:
    """M_p = Gamma((p+1)/2)/(sqrt(pi) Gamma(p/2+1)), p > -1."""
    return gamma((p + 1) / 2) / (gamma(HALF) * gamma(p / 2 + 1))


def mean(a: int, b: fmpq) -> GammaSum:
    """<|c|^a |s|^b> for a >= 0, b > -1, by the formulas of ``moments.symbolic.mean``."""
    if a % 2:
        x, y = fmpq(a + 1, 2), (b + 1) / 2
        return gamma(x) * gamma(y) / (gamma(HALF) ** 2 * gamma(x + y))
    found = moment(b)
    for k in range(2, a + 1, 2):
        found *= fmpq(k - 1) / (k + b)
    return found
