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

Row n is one polynomial, so a row costs one line of FLINT.
"""

from collections.abc import Iterator
from fractions import Fraction
from math import prod

from flint import fmpz_poly

from asymptotics.numbers.integers import require_integer
from asymptotics.running.budget import tick

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
        # (n+i+2)!! of the next entry: only (n+i)!! is divided by, not the common denominator of the row.
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
    # In place: line[j] holds E_(k-1) of the same diagonal before, ``below`` E_k of the diagonal before.
    for k in range(1, i + 1):
        below = 0
        for j in range(len(line)):
            m = k + 2 * j + 1
            line[j] = below = 2 * (m - 1) * line[j] - (m - 2) * below
    return Fraction(line[-1], _odd_double_factorial(n + i))
