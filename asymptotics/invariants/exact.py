"""Smith's coefficients C_i^n, exactly: f_n(w) = sum_i C_i^n w^i in T = wt - sum_n f_n(w) z^n.

With w = gamma v / omega and z = w / (w^2 - u), the chain rule turns dT/dt = 0 into the recurrence (Smith (59d), (62a))

    (n + i) C_i^n = 2 (n - 1) C_(i-1)^(n-1) - (n - 2) C_i^(n-2),        C_0^1 = 1,

whose only nonzero entries have i < n and i, n of opposite parity.

>>> coefficients(7)
{0: Fraction(-1, 7), 2: Fraction(272, 189), 4: Fraction(-1856, 1155), 6: Fraction(1024, 3003)}
>>> coefficient(31, 10) == coefficients(31)[10]
True

The kernel works with the integers E_i^n = (n+i)!! C_i^n, for which the recurrence loses its division (derivation
``smith-denominators``; since n+i is odd and at most 2n-1, (2n-1)!! is a common denominator of row n):

    E_i^n = 2 (n-1) E_(i-1)^(n-1) - (n-2) E_i^(n-2).

Row n is one polynomial, so a row costs one line of FLINT.  Three other routes, sharing nothing with it but the paper,
stand below it, for the tests: no command asks them.
"""

from collections.abc import Iterator
from fractions import Fraction
from math import comb, prod

from flint import fmpq_poly, fmpz_poly

from asymptotics.budget import tick
from asymptotics.numbers.exact import require_integer

Row = dict[int, Fraction]
MAX_ROW, MAX_N = 10_000, 1_000_000


def integer_rows() -> Iterator[tuple[int, fmpz_poly]]:
    """Yield (n, row) for n = 1, 2, ...: coefficient j of the row is E_i^n = (n+i)!! C_i^n, i = 2j + (n+1) mod 2.

    Only two rows are kept.

    >>> [list(row) for (n, row), _ in zip(integer_rows(), range(5))]  # 384/9!! = 128/315, -104/7!! = -104/105, ...
    [[1], [2], [-1, 8], [-10, 48], [3, -104, 384]]
    """
    previous, row = fmpz_poly([]), fmpz_poly([1])
    n = 1
    while True:
        tick(f"row {n}")
        yield n, row
        n += 1
        upper = 2 * (n - 1) * row
        previous, row = row, (upper if n % 2 == 0 else upper.left_shift(1)) - (n - 2) * previous


def coefficients(n: int) -> Row:
    """The nonzero coefficients {i: C_i^n} of f_n, in the memory of two rows (Smith (60h), (62a))."""
    require_integer(n, "n", 1, MAX_ROW)
    row = next(row for m, row in integer_rows() if m == n)
    first = (n + 1) % 2
    scale, values = _odd_double_factorial(n + first), {}
    for i, e in zip(range(first, n, 2), row):
        values[i] = Fraction(int(e), scale)
        scale *= n + i + 2
    return values


def _odd_double_factorial(m: int) -> int:
    return prod(range(m, 0, -2))


def coefficient(n: int, i: int) -> Fraction:
    """C_i^n alone; 0 if i >= n or if i and n have the same parity.

    Along the diagonals j = (n - i - 1) / 2 the recurrence couples (i, j) to (i-1, j) and (i, j-1) only, so that one
    line of (n - i + 1) / 2 numbers is carried i times.

    >>> coefficient(5, 4), coefficient(5, 2), coefficient(5, 3)
    (Fraction(128, 315), Fraction(-104, 105), Fraction(0, 1))
    """
    require_integer(n, "n", 1, MAX_N)
    require_integer(i, "i", -MAX_N, MAX_N)
    if i < 0 or i >= n or (n - i) % 2 == 0:
        return Fraction(0)
    line = [(-1) ** j * _odd_double_factorial(2 * j - 1) for j in range((n - i + 1) // 2)]  # E_0^(2j+1)
    for k in range(1, i + 1):
        below = 0
        for j in range(len(line)):
            m = k + 2 * j + 1
            line[j] = below = 2 * (m - 1) * line[j] - (m - 2) * below
    return Fraction(line[-1], _odd_double_factorial(n + i))


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
