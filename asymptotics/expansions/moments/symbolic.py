"""M_p = <|sin|^p> in closed form, and the power mean that Lelas' squaring trick puts in its place.

    M_p = (1/pi) int_0^pi sin^p = Gamma((p+1)/2)/(sqrt(pi) Gamma(p/2+1)),
    M_p = (p-1)/p M_(p-2),  M_0 = 1,  M_1 = 2/pi.

>>> from sympy import Symbol
>>> moment(4), moment(3), moment(Rational(1, 2))
(3/8, 4/(3*pi), gamma(3/4)/(sqrt(pi)*gamma(5/4)))
>>> alpha = Symbol("alpha", nonnegative=True)
>>> moment(alpha + 1)
gamma(alpha/2 + 1)/(sqrt(pi)*gamma(alpha/2 + 3/2))

*Lelas' replacement* (Lelas 2024: the mean of a square root replaced by the root of a mean).  Where the first-order
amplitude law has p_1 = M_(alpha+1), the trick has 2^(-(alpha+1)/2) = (M_2)^((alpha+1)/2).  Both are powers of power
means of |sin|: with m_q = M_q^(1/q), the law has m_(alpha+1)^(alpha+1) and the trick m_2^(alpha+1).  Power means grow
strictly with q (Jensen; |sin| is not constant), so the trick

    overestimates the damping for alpha < 1,   is exact at alpha = 1,   underestimates it for alpha > 1,

and the ratio 2^(-(alpha+1)/2)/M_(alpha+1), independent of epsilon, is a relative error of the rate that does not vanish
with epsilon.

>>> squaring_ratio(Integer(0)), squaring_ratio(Integer(1)), squaring_ratio(Integer(2))
(sqrt(2)*pi/4, 1, 3*sqrt(2)*pi/16)
"""

from math import prod

from sympy import Add, Expr, Integer, Pow, Rational, gamma, pi, sqrt

from asymptotics.errors import InputError
from asymptotics.expansions.moments.exact import integer_moment
from asymptotics.numbers.bridge import to_sympy as number

__all__ = ["PI", "mean", "moment", "number", "squaring_moment", "squaring_ratio"]

PI = pi


def moment(p: Expr | int) -> Expr:
    """M_p as a SymPy expression: rational or rational/pi for an integer p >= 0, Gamma quotient otherwise.

    Raises InputError for a number p <= -1, where the integral diverges.
    """
    p = Integer(p) if isinstance(p, int) else p
    if p.is_Integer and p >= 0:
        coefficient, over_pi = integer_moment(int(p))
        value = Rational(coefficient.numerator, coefficient.denominator)
        return value / pi if over_pi else value
    if p.is_number and not p.is_real:
        raise InputError("p", f"{p} is not real", "real p > -1")
    if p.is_number and (p + 1).is_positive is not True:
        raise InputError("p", f"M_p diverges at p = {p}", "p > -1")
    return gamma((p + 1) / 2) / (sqrt(pi) * gamma(p / 2 + 1))


def mean(a: Expr | int, b: Expr | int) -> Expr:
    """<|c|^a |s|^b> = Gamma((a+1)/2) Gamma((b+1)/2)/(pi Gamma((a+b)/2 + 1)), for a, b > -1.

    For an even a it is a rational multiple of M_b: <|c|^a |s|^b> = (a-1)/(a+b) <|c|^(a-2) |s|^b>.

    >>> mean(2, 2), mean(0, 3), mean(1, 3)
    (1/8, 4/(3*pi), 1/(2*pi))
    """
    a, b = Add(a, 0), Add(b, 0)
    # By parts, two powers of the cosine at a time: no Gamma functions where a rational factor does.
    if a.is_even and a >= 0:
        return prod((Rational(k - 1) / (k + b) for k in range(2, int(a) + 1, 2)), start=moment(b))
    x, y = (a + 1) / 2, (b + 1) / 2
    return gamma(x) * gamma(y) / (pi * gamma(x + y))


def squaring_moment(alpha: Expr) -> Expr:
    """2^(-(alpha+1)/2), what the squaring trick puts in the place of M_(alpha+1)."""
    return Pow(2, -(alpha + 1) / 2)


def squaring_ratio(alpha: Expr) -> Expr:
    """2^(-(alpha+1)/2)/M_(alpha+1): the damping of the squaring trick over the first-order damping."""
    return squaring_moment(alpha) / moment(alpha + 1)
