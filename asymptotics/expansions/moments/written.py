"""M_p of a rational p exactly, without SymPy: whole p as a rational or a rational over pi, others as text.

The text is the one SymPy writes for ``moments.symbolic.moment``, which takes longer to load than the answer takes.

>>> [written(Fraction(p)) for p in (4, 3, 1)], written(Fraction(1, 2))
(['3/8', '4/(3*pi)', '2/pi'], 'gamma(3/4)/(sqrt(pi)*gamma(5/4))')
"""

from fractions import Fraction

from flint import fmpq

from asymptotics.errors import InputError


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


def written(p: Fraction) -> str:
    """M_p, p > -1, as SymPy writes it."""
    if p.denominator > 1:
        # (p+1)/2 and p/2 + 1 are neither whole nor halves of odd numbers, where SymPy would find roots of pi.
        return f"gamma({(p + 1) / 2})/(sqrt(pi)*gamma({p / 2 + 1}))"
    q, over_pi = integer_moment(p.numerator)
    if not over_pi:
        return str(q)
    return f"{q.numerator}/pi" if q.denominator == 1 else f"{q.numerator}/({q.denominator}*pi)"
