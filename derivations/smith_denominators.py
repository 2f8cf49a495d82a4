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

import sympy

from derivations.steps import At, Coefficient, Derivation, Solution, defined

n, i, k = sympy.symbols("n i k", integer=True, positive=True)
C, B, D_below = sympy.symbols("C_i^n C_{i-1}^{n-1} C_i^{n-2}")
t = sympy.Symbol("t", positive=True)
D, E = sympy.symbols("D E", positive=True)

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


def double_factorial(N: int) -> int:
    """N!! = N (N-2) ..., down to 1 or 2."""
    return N * double_factorial(N - 2) if N > 1 else 1


# First proof: induction.
F_7 = {
    0: sympy.Rational(-1, 7),
    2: sympy.Rational(272, 189),
    4: sympy.Rational(-1856, 1155),
    6: sympy.Rational(1024, 3003),
}
"""Smith's f_7 as printed: the coefficients of w^i."""
q = sympy.Symbol("(n+i-2)!!", positive=True)
step(
    "With (n+i)!! = (n+i)(n+i-2)!!, (62a) times (n+i)!!",
    (n + i) * q * Solution((n + i) * C, 2 * (n - 1) * B - (n - 2) * D_below, C),
    2 * (n - 1) * (q * B) - (n - 2) * (q * D_below),
)
step("and C_{i-1}^{n-1} has the same index sum n+i-2", At(n + i, {n: n - 1, i: i - 1}), n + i - 2)
step("as has C_i^{n-2}", At(n + i, {n: n - 2}), n + i - 2)
rows = integer_rows(7)
w = sympy.Symbol("w", positive=True)
A_6, A_5 = sympy.symbols("A^6 A^5")
row_5, row_6 = (sum(a * w**j for j, a in enumerate(rows[row])) for row in (5, 6))
step(
    "So A_i^n = (n+i)!! C_i^n obeys A_i^n = 2(n-1) A_{i-1}^{n-1} - (n-2) A_i^{n-2} with A_0^1 = 1: an integer for all"
    " n, i, by induction on n; the rows 6 and 5 as polynomials in w, sum_i A_i^n w^i, give Smith's f_7 with w^i times"
    " (7+i)!!",
    At(12 * w * A_6 - 5 * A_5, {A_6: row_6, A_5: row_5}),
    sum(double_factorial(7 + j) * c * w**j for j, c in F_7.items()),
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
below = sympy.Symbol("(2n-3)!!", positive=True)
step(
    "(2n-1)!! cannot be replaced by (2n-3)!!: (62a) at i = n-1 has no C_i^{n-2}, and with C_{n-2}^{n-1} = 2^{n-2}"
    " (n-2)!/(2n-3)!! (1 at n = 2) it gives (2n-3)!! C_{n-1}^n, where no factor cancels 2n-1 if that is a prime",
    below * At(Solution((2 * n - 1) * C, 2 * (n - 1) * B, C), {B: 2 ** (n - 2) * sympy.factorial(n - 2) / below}),
    2 ** (n - 1) * sympy.factorial(n - 1) / (2 * n - 1),
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
field = E**3 - 2 * E**2
c, d = sympy.symbols("c_{n-1} c_{n-2}")
step(
    "In p_{k+1} = (E^3-2E^2) p_k' the power E^n comes from E^{n-1} and E^{n-2} in p_k alone, c being its coefficients",
    Coefficient(field * sympy.Derivative(c * E ** (n - 1) + d * E ** (n - 2), E) / E**n, E, 0),
    (n - 2) * d - 2 * (n - 1) * c,
)
step(
    "so (-1)^k [E^n] p_k, 2k+1 = n+i, obeys the recurrence of A_i^n, and p_0 = E is A_0^1 = 1: they are equal",
    At((-1) ** (k + 1) * ((n - 2) * d - 2 * (n - 1) * c), {c: (-1) ** k * A_left, d: (-1) ** k * A_below}),
    2 * (n - 1) * A_left - (n - 2) * A_below,
)


def applied(f: sympy.Expr) -> sympy.Expr:
    """(E^3 - 2E^2) df/dE, not yet differentiated."""
    return field * sympy.Derivative(f, E)


step(
    "as in -p_3, by three derivatives, against the rows 4, 5, 6, 7, by the recurrence: the sum of A_{7-n}^n E^n; 100"
    " rows against (62a) and 30 polynomials in tests/derivations/test_smith_denominators.py",
    -applied(applied(applied(E))),
    sum(rows[row][7 - row] * E**row for row in range(4, 8)),
)
