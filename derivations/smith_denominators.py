"""The denominators: (n+i)!! C_i^n / 2^i is an integer for all n and i, hence so is (2n-1)!! C_i^n.

Two proofs.  By induction: multiplied by (n+i)!!, the recurrence (62a) loses its denominators altogether,

    A_i^n = 2(n-1) A_{i-1}^{n-1} - (n-2) A_i^{n-2},   A_0^1 = 1,   C_i^n = A_i^n/(n+i)!!.

By an explicit formula: the time is int dw/D with 1/D = E a function of s = w^2/2, dE/ds = E^3 - 2E^2, so that C_i^n is
a coefficient of an integer polynomial over (n+i)!!.

>>> integer_rows(4)[4]
(0, -10, 0, 48)
>>> from fractions import Fraction
>>> Fraction(48, 7 * 5 * 3)                                   # C_3^4 = A_3^4/7!!
Fraction(16, 35)
"""

from fractions import Fraction
from math import factorial

import sympy
from flint import fmpq_poly

from derivations.steps import At, Derivation, Solution, defined

n, i, k = sympy.symbols("n i k", integer=True, positive=True)
C, B, D_below = sympy.symbols("C_i^n C_{i-1}^{n-1} C_i^{n-2}")
w, t, z = sympy.symbols("w t z", positive=True)
D, E = sympy.symbols("D E", positive=True)
ROWS = 100

derivation = Derivation(
    "smith-denominators",
    "The denominators of Smith's coefficients",
    source="Smith 2012, (62a); the lemma is not in the paper; smith2012:60h, 62a",
)
step = derivation.step


def integer_rows(last: int) -> dict[int, tuple[int, ...]]:
    """A_0^n, ..., A_(n-1)^n for n = 1 ... last: integers, no division."""
    rows = {0: (), 1: (1,)}
    for row in range(2, last + 1):
        before, twice = rows[row - 1], rows[row - 2]
        rows[row] = tuple(
            (2 * (row - 1) * before[j - 1] if j else 0) - ((row - 2) * twice[j] if j < row - 2 else 0)
            for j in range(row)
        )
    return rows


def rational_rows(last: int) -> dict[int, tuple[Fraction, ...]]:
    """C_0^n, ..., C_(n-1)^n by (62a) as printed."""
    rows = {0: (), 1: (Fraction(1),)}
    for row in range(2, last + 1):
        before, twice = rows[row - 1], rows[row - 2]
        rows[row] = tuple(
            ((2 * (row - 1) * before[j - 1] if j else 0) - ((row - 2) * twice[j] if j < row - 2 else 0))
            / Fraction(row + j)
            for j in range(row)
        )
    return rows


def double_factorial(N: int) -> int:
    """N!! = N (N-2) ..., down to 1 or 2."""
    return N * double_factorial(N - 2) if N > 1 else 1


# First proof: induction.
q = sympy.Symbol("(n+i-2)!!", positive=True)
step(
    "With (n+i)!! = (n+i)(n+i-2)!!, (62a) times (n+i)!!",
    (n + i) * q * Solution((n + i) * C, 2 * (n - 1) * B - (n - 2) * D_below, C),
    2 * (n - 1) * (q * B) - (n - 2) * (q * D_below),
)
step("and C_{i-1}^{n-1} has the same index sum n+i-2", At(n + i, {n: n - 1, i: i - 1}), n + i - 2)
step("as has C_i^{n-2}", At(n + i, {n: n - 2}), n + i - 2)
ratio = sympy.Rational
f_7 = (-ratio(1, 7), 0, ratio(272, 189), 0, -ratio(1856, 1155), 0, ratio(1024, 3003))
row_of = defined("A", lambda row: sympy.Tuple(*integer_rows(int(row))[int(row)]))
step(
    "So A_i^n = (n+i)!! C_i^n obeys A_i^n = 2(n-1) A_{i-1}^{n-1} - (n-2) A_i^{n-2} with A_0^1 = 1: an integer for all"
    " n, i, by induction on n; A(7), i = 0 ... 6, from this against Smith's f_7 times (7+i)!!",
    row_of(7),
    sympy.Tuple(*(double_factorial(7 + j) * x for j, x in enumerate(f_7))),
)
a_left, a_below, A_left, A_below = sympy.symbols("a_{i-1}^{n-1} a_i^{n-2} A_{i-1}^{n-1} A_i^{n-2}")
step(
    "and A_i^n = 2^i a_i^n with a_i^n = (n-1) a_{i-1}^{n-1} - (n-2) a_i^{n-2}, integer too",
    At(2 * (n - 1) * A_left - (n - 2) * A_below, {A_left: 2 ** (i - 1) * a_left, A_below: 2**i * a_below}),
    2**i * ((n - 1) * a_left - (n - 2) * a_below),
)
step(
    "C_i^n is 0 unless n+i is odd, and i <= n-1: n+i = 2n-1-2j, an odd number not above 2n-1, so (n+i)!!"
    " divides (2n-1)!!",
    At(n + i, {i: n - 1 - 2 * k}),
    2 * n - 1 - 2 * k,
)
rows, exact = integer_rows(ROWS), rational_rows(ROWS)


def violations(last: sympy.Expr) -> sympy.Expr:
    """How many C_i^n, n <= last, break one of the three statements of the next line."""
    return sympy.Integer(
        sum(
            a != double_factorial(row + j) * exact[row][j]
            or a % 2**j != 0
            or (double_factorial(2 * row - 1) * exact[row][j]).denominator != 1
            for row in range(1, int(last) + 1)
            for j, a in enumerate(rows[row])
        )
    )


step(
    "Checked against (62a) in rational arithmetic: C_i^n = A_i^n/(n+i)!!, 2^i divides A_i^n, and (2n-1)!! C_i^n is an"
    " integer; the number of failures up to n",
    defined("failures", violations)(ROWS),
    0,
)
last_of = defined("C", lambda row: sympy.Rational(*exact[int(row)][int(row) - 1].as_integer_ratio()))
step(
    "(2n-1)!! cannot be replaced by (2n-3)!!: C(n) = C_{n-1}^n = 2^{n-1} (n-1)!/(2n-1)!!, e.g. for n = 2, 3, 4, 6"
    " (2n-1 prime) (2n-3)!! C_{n-1}^n is",
    sympy.Tuple(*(double_factorial(2 * row - 3) * last_of(row) for row in (2, 3, 4, 6))),
    sympy.Tuple(*(ratio(2 ** (row - 1) * factorial(row - 1), 2 * row - 1) for row in (2, 3, 4, 6))),
)

# Second proof: an integral.
u, s = sympy.symbols("u s")
acceleration = w**2 - u
rate = w * sympy.Derivative(acceleration, u) + acceleration * sympy.Derivative(acceleration, w)
step("Along the motion the acceleration D = w^2 - u has dD/dtau = 2wD - w", rate, 2 * w * acceleration - w)
slope = sympy.Symbol("dD/ds", real=True)
step(
    "dw = D dtau, ds = w dw with s = w^2/2: D w dD/ds is dD/dtau, solved",
    Solution(D * w * slope, 2 * w * D - w, slope),
    2 - 1 / D,
)
step("so E = 1/D obeys dE/ds = E^3 - 2E^2", At(sympy.Derivative(1 / D, D) * (2 - 1 / D), {D: 1 / E}), E**3 - 2 * E**2)
b = sympy.Symbol("b", positive=True)
step(
    "I_k = int_0^1 b^k dt with b = 1-t^2: since d(t b^k)/dt = b^k - 2k t^2 b^{k-1} and t b^k vanishes at both ends,"
    " (2k+1) I_k = 2k I_{k-1}",
    At(sympy.Derivative(t * (1 - t**2) ** k, t), {t: sympy.sqrt(1 - b)}),
    (2 * k + 1) * b**k - 2 * k * b ** (k - 1),
)
top = defined("r", lambda k: 2**k * sympy.factorial(k))
step("which 2^k k!/(2k+1)!! obeys too, (2k+1)!! = (2k+1) (2k-1)!! and, for r(k) = 2^k k!,", top(k) / top(k - 1), 2 * k)
step(
    "so I_k = 2^k k!/(2k+1)!!, both 1 at k = 0; k = 0, 1, 2, 3, 4",
    sympy.Tuple(*(sympy.Integral((1 - t**2) ** power, (t, 0, 1)) for power in range(5))),
    sympy.Tuple(*(top(power) / double_factorial(2 * power + 1) for power in range(5))),
)
# E along the orbit is Taylor-expanded about its end point: s' - s = -(w^2/2)(1-t^2) with w' = tw.
field = fmpq_poly([0, 0, -2, 1])
polynomials = [fmpq_poly([0, 1])]
for _ in range(30):
    polynomials.append(field * polynomials[-1].derivative())
step(
    "tau = int_0^w E dw' with E(s') = sum_k p_k(E) (s'-s)^k/k!, p_0 = E, p_{k+1} = (E^3-2E^2) p_k' in"
    " Z[E], and w' = tw:"
    " the k-th term, with (s'-s)^k = (-w^2/2)^k (1-t^2)^k",
    At(s**k * w * top(k) / sympy.factorial(k), {s: -(w**2) / 2}),
    (-1) ** k * w ** (2 * k + 1),
)
step(
    "so tau = sum_k (-1)^k w^{2k+1} p_k(z/w)/(2k+1)!!; its monomial E^n = (z/w)^n gives z^n w^i with n+i = 2k+1",
    At(n + i, {i: 2 * k + 1 - n}),
    2 * k + 1,
)


def disagreements(last: sympy.Expr) -> sympy.Expr:
    """How many A_i^n with n + i <= last differ from (-1)^k [E^n] p_k(E), 2k+1 = n+i."""
    pairs = (
        (row, 2 * power + 1 - row, power) for power in range((int(last) + 1) // 2) for row in range(1, 2 * power + 2)
    )
    return sympy.Integer(sum(j < row and rows[row][j] != (-1) ** p * polynomials[p][row] for row, j, p in pairs))


step(
    "Hence A_i^n = (-1)^k [E^n] p_k(E), 2k+1 = n+i: the number of disagreements with the recurrence up to n+i",
    defined("disagreements", disagreements)(61),
    0,
)
