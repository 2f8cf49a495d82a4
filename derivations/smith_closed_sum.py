"""From the recurrence (62a) to the closed sum (62b), with its sign: (-1)^(k-1), not the printed (-1)^k.

A double factorial N!! is 2^(N/2) Gamma(N/2+1) times a constant that depends on the parity of N only; it cancels here.

>>> bool(abs(term(1).subs({n: 2, i: 1}) - sympy.Rational(2, 3)) < 1e-12)
True
"""

import sympy

from derivations.steps import At, Derivation, Solution, defined

n, i, k = sympy.symbols("n i k", integer=True, positive=True)
A, B, D = sympy.symbols("C_i^n C_{i-1}^{n-1} C_i^{n-2}")
w = sympy.Symbol("w", positive=True)

derivation = Derivation(
    "smith-closed-sum",
    "The closed sum of the coefficients",
    source="Smith 2012, (62a), (62b); smith2012:62a, 62b",
)
step = derivation.step


def double_factorial(N: sympy.Expr) -> sympy.Expr:
    """N!! up to the constant of its parity."""
    return 2 ** (N / 2) * sympy.gamma(N / 2 + 1)


def term(k: sympy.Expr | int, n: sympy.Expr = n) -> sympy.Expr:
    """The factor of C_(i-1)^(n+1-2k) in the sum for C_i^n."""
    top = double_factorial(n + i - 2 * k) * double_factorial(n - 2) * (n + 1 - 2 * k)
    return 2 * (-1) ** (k - 1) * top / (double_factorial(n + i) * double_factorial(n - 2 * k))


step(
    "(59d), the coefficient of w^i: f_n, f_{n-1}, f_{n-2} by one term A w^i, B w^{i-1}, D w^i each, over w^i",
    (w * sympy.Derivative(A * w**i, w) + n * A * w**i - 2 * (n - 1) * w * B * w ** (i - 1) + (n - 2) * D * w**i) / w**i,
    (n + i) * A - 2 * (n - 1) * B + (n - 2) * D,
)
recurrence = 2 * (n - 1) * B / (n + i) - (n - 2) * D / (n + i)
step(
    "(62a): it vanishes",
    Solution((n + i) * A - 2 * (n - 1) * B + (n - 2) * D, 0, A),
    recurrence,
    proves=("smith2012:62a",),
)
closed = (-1) ** ((n - 1) / 2) / n
step(
    "(63): (62a) at i = 0, where C_{-1} = 0, is obeyed by C_0^n = (-1)^{(n-1)/2}/n, which is 1 at n = 1",
    At(recurrence, {i: 0, B: 0, D: At(closed, {n: n - 2})}),
    closed,
    proves=("smith2012:63",),
)
step(
    "(65): (62a) at i = 1 with (63) at n - 1",
    At(recurrence, {i: 1, B: At(closed, {n: n - 1})}),
    2 * (-1) ** ((n - 2) / 2) / (n + 1) - (n - 2) / (n + 1) * D,
    proves=("smith2012:65",),
)
step(
    "n - i keeps its parity from C_i^n to C_{i-1}^{n-1} and to C_i^{n-2}; from C_0^1 on it is odd: else C = 0",
    At(n - i, {n: n - 1, i: i - 1}),
    n - i,
)
whole, column = sympy.symbols("n i", integer=True, positive=True)
sign = (-1) ** (whole - column)
step(
    "(62a) where both coefficients on the right have the factor 1 - (-1)^{n-i}: times 1 + (-1)^{n-i} it is 0",
    At(recurrence, {n: whole, i: column, B: B * (1 - sign), D: D * (1 - sign)}) * (1 + sign),
    0,
    proves=("smith2012:claim.opposite-parity",),
)
t = defined("t", term)
step(
    "Let t_k(n) be the factor of C_{i-1}^{n+1-2k} in the sum. t_1 is the first factor of (62a), so its sign is +",
    t(1, n),
    2 * (n - 1) / (n + i),
)
step("t_{k+1}(n) = -(n-2)/(n+i) t_k(n-2): (62a) unrolled once more", t(k + 1, n) / t(k, n - 2), -(n - 2) / (n + i))
step(
    "with the same coefficient, C_{i-1}^{(n-2)+1-2k} = C_{i-1}^{n+1-2(k+1)}",
    At(n + 1 - 2 * k, {n: n - 2}),
    At(n + 1 - 2 * k, {k: k + 1}),
)
step(
    "The last k is (n-i+1)/2, where the coefficient is C_{i-1}^i; beyond, C_{i-1}^m with m < i is 0",
    At(n + 1 - 2 * k, {k: (n - i + 1) / 2}),
    i,
)
step(
    "and what remains of (62a) is C_i^{i-1} = 0",
    At(n - 2 * k, {k: (n - i + 1) / 2}),
    i - 1,
)
c_1, c_next = sympy.symbols("c_1 c_{k+1}")  # C_{i-1}^{n+1-2k} for k = 1 and for k + 1
step("so at n = i + 1 the sum has its first term alone", At(recurrence, {D: 0, B: c_1}), t(1, n) * c_1)
step(
    "and from n - 2 to n it gains one: (62a) is linear in C_i^{n-2}, and of its sum, c_k = C_{i-1}^{n+1-2k}, the term"
    " t_k(n-2) c_{k+1}, whatever k, becomes the term k + 1 of the sum for n, after the first, which is new:",
    At(recurrence, {B: c_1, D: t(k, n - 2) * c_next}),
    t(1, n) * c_1 + t(k + 1, n) * c_next,
    proves=("smith2012:62b",),
)
step(
    "The first term of the sum gives C_1^2 = +2/3, as (60b); the printed sign would give -2/3",
    At(t(1, n), {n: 2, i: 1}),
    sympy.Rational(2, 3),
)
