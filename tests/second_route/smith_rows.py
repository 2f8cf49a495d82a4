"""Three other routes to Smith's coefficients C_i^n: nothing is shared with the kernel but the paper."""

from fractions import Fraction
from math import comb

from flint import fmpq_poly

from asymptotics.motions.invariants.exact import Row


def rows_by_rationals(last: int) -> list[Row]:
    """Rows 1 ... last by (62a) entry by entry in Fraction: the plainest route, and the slowest."""
    rows: list[Row] = [{}, {0: Fraction(1)}]
    for n in range(2, last + 1):
        rows.append({})
        for i in range((n + 1) % 2, n, 2):
            above, before = rows[n - 1].get(i - 1, 0), rows[n - 2].get(i, 0)
            rows[n][i] = (2 * (n - 1) * Fraction(above) - (n - 2) * Fraction(before)) / (n + i)
    return rows[1:]


def rows_by_integration(last: int) -> list[fmpq_poly]:
    """Polynomials f_1 ... f_last by (59d): (w^n f_n)' = 2(n-1) w^n f_(n-1) - (n-2) w^(n-1) f_(n-2), integrated."""
    w = fmpq_poly([0, 1])
    f = [fmpq_poly([0]), fmpq_poly([1])]
    for n in range(2, last + 1):
        right = (2 * (n - 1) * w * f[n - 1] - (n - 2) * f[n - 2]).left_shift(n - 1)
        f.append(right.integral().right_shift(n))
    return f[1:]


def coefficient_by_closed_sum(n: int, i: int) -> Fraction:
    """C_i^n by the sum (62b) with its sign corrected to (-1)^(k+1), from C_0^m = (-1)^((m-1)/2) / m.

    The printed (-1)^k makes the first term disagree with (62a).
    """
    if i >= n or (n - i) % 2 == 0:
        return Fraction(0)
    column = {m: Fraction((-1) ** ((m - 1) // 2), m) for m in range(1, n - i + 1, 2)}
    for k in range(1, i + 1):
        column = {m: _closed_sum(m, k, column) for m in range(k + 1, n - i + k + 1, 2)}
    return column[n]


def _closed_sum(n: int, i: int, column: dict[int, Fraction]) -> Fraction:
    total, factor = Fraction(0), Fraction(2, n + i)  # factor: 2 (n+i-2k)!! (n-2)!! / ((n+i)!! (n-2k)!!)
    for k in range(1, (n - i + 1) // 2 + 1):
        total += (-1) ** (k + 1) * factor * (n + 1 - 2 * k) * column[n + 1 - 2 * k]
        factor *= Fraction(n - 2 * k, n + i - 2 * k)
    return total


def leading_coefficient(n: int) -> Fraction:
    """C_(n-1)^n = prod_(k=2..n) 2(k-1)/(2k-1) = 2^(2n-1) / (n C(2n, n)), the highest power of f_n in closed form.

    >>> leading_coefficient(7)
    Fraction(1024, 3003)
    """
    return Fraction(2 ** (2 * n - 1), n * comb(2 * n, n))
