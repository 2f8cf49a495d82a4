"""The certificates of the telescoping sums of ``multiple_scales.harmonics``, and the sums that only they need."""

from sympy import Expr, Integer, Pow, gamma

from asymptotics.expansions.moments.symbolic import mean, moment
from asymptotics.expansions.multiple_scales.harmonics import harmonic


def harmonic_closed_form(alpha: Expr, n: Expr) -> Expr:
    """b_n as printed, for a symbolic odd n; (-1)^((n-1)/2) is kept as a power."""
    sign = Pow(Integer(-1), (n - 1) / 2)
    return sign * 2 ** (1 - alpha) * gamma(alpha + 1) / (gamma((alpha + n) / 2 + 1) * gamma((alpha - n) / 2 + 1))


def cosine_harmonic(p: Expr, n: int) -> Expr:
    """d_n of |cos|^p sgn cos for an odd n >= 1."""
    return harmonic(p, n) * (-1) ** ((n - 1) // 2)


def velocity_certificate(alpha: Expr, beta: Expr, n: Expr) -> Expr:
    """F(n)/(b_n c_n), a rational function: the telescoping certificate of ``velocity_sum``."""
    return -(n + alpha) * (n + beta) / (2 * (alpha + 1) * (beta + 1) * (n - 1))


def turning_certificate(alpha: Expr, n: Expr) -> Expr:
    """G(n)/b_n, a rational function: the telescoping certificate of ``turning_sum``."""
    return -(n + alpha) / (2 * (alpha + 1) * (n - 1))


def turning_sum(alpha: Expr) -> Expr:
    """sum over odd n >= 3 of n b_n/(n^2 - 1): minus the velocity of X_1 at psi = 0, in closed form."""
    return (1 - alpha) / (2 * (alpha + 1)) * moment(alpha + 1)


def cross_sum(alpha: Expr, p: Expr) -> Expr:
    """sum over odd n >= 3 of n b_n d_n/(n^2 - 1), b_n of a loss alpha and d_n of a spring p: in closed form.

    >>> cross_sum(Integer(3), Integer(3))                      # 3/8 b_3 d_3
    -3/128
    """
    products = (4 - (1 - alpha) * (1 - p)) * moment(alpha + 1) * moment(p + 1)
    return (products - 2 * p * mean(p - 1, alpha + 1)) / ((alpha + 1) * (p + 1))
