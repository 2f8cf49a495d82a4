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

import sympy
from flint import fmpq_poly

from derivations.steps import At, Derivation, named

n, i, k = sympy.symbols("n i k", integer=True, positive=True)
B, D_below = sympy.symbols("C_{i-1}^{n-1} C_i^{n-2}")
w, t, z = sympy.symbols("w t z", positive=True)
D, E = sympy.symbols("D E", positive=True)
ROWS = 100

derivation = Derivation(
    "smith-denominators",
    "The denominators of Smith's coefficients",
    source="Smith 2012, (62a); the lemma is not in the paper; smith2012:60h, 62a",
)
step, holds = derivation.step, derivation.holds


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
    sympy.expand((n + i) * q * (2 * (n - 1) * B - (n - 2) * D_below) / (n + i)),
    2 * (n - 1) * (q * B) - (n - 2) * (q * D_below),
)
step("and C_{i-1}^{n-1} has the same index sum n+i-2", At(n + i, {n: n - 1, i: i - 1}), n + i - 2)
step("as has C_i^{n-2}", At(n + i, {n: n - 2}), n + i - 2)
holds(
    "So A_i^n = (n+i)!! C_i^n obeys A_i^n = 2(n-1) A_{i-1}^{n-1} - (n-2) A_i^{n-2} with A_0^1 = 1: an"
    " integer for all n, i,"
    " by induction on n",
    all(isinstance(a, int) for a in integer_rows(12)[12]),
    sympy.Tuple(*integer_rows(12)[12]),
)
a_left, a_below = sympy.symbols("a_{i-1}^{n-1} a_i^{n-2}")
step(
    "and A_i^n = 2^i a_i^n with a_i^n = (n-1) a_{i-1}^{n-1} - (n-2) a_i^{n-2}, integer too",
    2 * (n - 1) * 2 ** (i - 1) * a_left - (n - 2) * 2**i * a_below,
    2**i * ((n - 1) * a_left - (n - 2) * a_below),
)
step(
    "C_i^n is 0 unless n+i is odd, and i <= n-1: n+i = 2n-1-2j, an odd number not above 2n-1, so (n+i)!!"
    " divides (2n-1)!!",
    At(n + i, {i: n - 1 - 2 * k}),
    2 * n - 1 - 2 * k,
)
rows, exact = integer_rows(ROWS), rational_rows(ROWS)
holds(
    f"Checked against (62a) in rational arithmetic, all n <= {ROWS}: C_i^n = A_i^n/(n+i)!!, 2^i divides"
    f" A_i^n, and (2n-1)!! C_i^n"
    " is an integer",
    all(
        a == double_factorial(row + j) * exact[row][j]
        and a % 2**j == 0
        and (double_factorial(2 * row - 1) * exact[row][j]).denominator == 1
        for row in range(1, ROWS + 1)
        for j, a in enumerate(rows[row])
    ),
    sympy.Tuple(*rows[7]),
)
holds(
    "(2n-1)!! cannot be replaced by (2n-3)!!: C_{n-1}^n = 2^{n-1} (n-1)!/(2n-1)!!, e.g. for n = 2, 3, 4,"
    " 6 (2n-1 prime)",
    all((double_factorial(2 * row - 3) * exact[row][row - 1]).denominator != 1 for row in (2, 3, 4, 6))
    and all(
        exact[row][row - 1] * double_factorial(2 * row - 1) == 2 ** (row - 1) * sympy.factorial(row - 1)
        for row in range(1, 21)
    ),
    sympy.Rational(2, 3),
)

# Second proof: an integral.
u, s = sympy.symbols("u s")
acceleration = w**2 - u
rate = w * sympy.Derivative(acceleration, u) + acceleration * sympy.Derivative(acceleration, w)
step("Along the motion the acceleration D = w^2 - u has dD/dtau = 2wD - w", rate, 2 * w * acceleration - w)
step("dw = D dtau, ds = w dw with s = w^2/2: dD/ds = 2 - 1/D", (2 * w * D - w) / (D * w), 2 - 1 / D)
step("so E = 1/D obeys dE/ds = E^3 - 2E^2", (-(2 - 1 / D) / D**2).subs(D, 1 / E), E**3 - 2 * E**2)
integrals = [sympy.integrate(sympy.expand((1 - t**2) ** power), (t, 0, 1)) for power in range(8)]
b = sympy.Symbol("b", positive=True)
step(
    "I_k = int_0^1 b^k dt with b = 1-t^2: since d(t b^k)/dt = b^k - 2k t^2 b^{k-1} and t b^k vanishes at both ends,"
    " (2k+1) I_k = 2k I_{k-1}",
    b**k - 2 * k * (1 - b) * b ** (k - 1),
    (2 * k + 1) * b**k - 2 * k * b ** (k - 1),
)
whole = sympy.Symbol("k", integer=True, positive=True)
step(
    "which 2^k k!/(2k+1)!! obeys too, (2k+1)!! = (2k+1) (2k-1)!!,",
    named("r_k", sympy.gammasimp(2**whole * sympy.factorial(whole) / (2 ** (whole - 1) * sympy.factorial(whole - 1)))),
    2 * whole,
)
holds(
    "so I_k = 2^k k!/(2k+1)!!, both 1 at k = 0; for instance",
    all(
        value == sympy.Rational(2**power * sympy.factorial(power), double_factorial(2 * power + 1))
        for power, value in enumerate(integrals)
    ),
    sympy.Tuple(*integrals),
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
    sympy.powsimp((-(w**2) / 2) ** k * w * (2**k * sympy.factorial(k)) / sympy.factorial(k)),
    (-1) ** k * w ** (2 * k + 1),
)
step(
    "so tau = sum_k (-1)^k w^{2k+1} p_k(z/w)/(2k+1)!!; its monomial E^n = (z/w)^n gives z^n w^i with n+i = 2k+1",
    At(n + i, {i: 2 * k + 1 - n}),
    2 * k + 1,
)
holds(
    "Hence A_i^n = (-1)^k [E^n] p_k(E), 2k+1 = n+i: equal to the recurrence for all n+i <= 61",
    all(
        sum((row + j) == 2 * power + 1 and rows[row][j] != (-1) ** power * polynomials[power][row] for j in range(row))
        == 0
        for power in range(31)
        for row in range(1, min(2 * power + 1, ROWS) + 1)
    ),
    sympy.Tuple(*(int(coefficient.p) for coefficient in polynomials[3].coeffs())),
)
