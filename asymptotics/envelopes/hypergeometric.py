"""Two laws, first order: tau(A) by 2F1, in the printed form of Lancaster's footnote 22 and in its companion.

    int dx/(c x^alpha + c' x^alpha'),   d = alpha' - alpha > 0,   F(a; z) = 2F1(1, a; a+1; z) = sum_k a z^k/(a+k):

    printed:    x^(1-alpha')/(c' (1-alpha')) F(a; -(c/c') x^(-d)),        a = (alpha'-1)/d,
    companion:  x^(1-alpha)/(c (1-alpha)) F(b; -(c'/c) x^d),              b = (1-alpha)/d = 1 - a.

Both follow from z F' + a F = a/(1-z).  F(a; z) has a pole at each a = 0, -1, -2, ... (the lower parameter, and for
a = 0 the factor 1 - alpha'), and

* the printed form breaks down exactly where (alpha'-1)/(alpha'-alpha) = -n, n = 0, 1, 2, ...: alpha' = 1 - n d and
  alpha = 1 - (n+1) d.  That needs alpha < alpha' <= 1: (0,1), (0,1/2), (1/3,2/3), (0,1/3), ...;
* the companion breaks down exactly where (1-alpha)/(alpha'-alpha) = -n: alpha = 1 + n d, alpha' = 1 + (n+1) d, which
  needs 1 <= alpha: (1,2), (1,3), (2,3), (3/2,2), ...

The two never fail together, since a + b = 1.  Where one fails the integral has a logarithm.  For alpha < 1 the
companion vanishes at x = 0, and its value at 1 is the extinction time; for alpha >= 1 the printed form has a > 0.

*Elementary.*  With z = -y^q, a = p/q in lowest terms, F(a; z) = p y^(-p) I_p and I_p = int_0^y u^(p-1)/(1+u^q) du,

    I_p = y^(p-q)/(p-q) - I_(p-q) for p > q,    I_p = -(1/q) sum_j w_j^p ln(1 - y/w_j), w_j^q = -1, for p <= q,

so that every pair of rational exponents closes: logarithms for integer a, arctan for half-integers, both in general.

>>> from sympy import symbols
>>> breaks_printed(S(0), S(1) / 2), breaks_companion(S(0), S(1) / 2)
(True, False)
>>> breaks_printed(S(2), S(3)), breaks_companion(S(2), S(3))
(False, True)
>>> k0, k2 = symbols("kappa_0 kappa_2", positive=True)
>>> two_law_time((S(0), k0), (S(2), k2))
-A*hyper((1/2, 1), (3/2,), -A**2*kappa_2/kappa_0)/kappa_0 + hyper((1/2, 1), (3/2,), -kappa_2/kappa_0)/kappa_0
>>> elementary_time((S(0), k0), (S(2), k2), S.Zero)                  # the extinction time
atan(sqrt(kappa_2)/sqrt(kappa_0))/(sqrt(kappa_0)*sqrt(kappa_2))
"""

from collections.abc import Mapping

from sympy import Expr, Rational, S, atan, atan2, cos, exp, expand_mul, hyper, log, pi, sin

from asymptotics.envelopes.symbolic import amplitude_symbol, held_power
from asymptotics.errors import InputError

Law = tuple[Expr, Expr]  # (exponent, kappa)
MAX_POWER, MAX_ROOT = 8, 4  # a = p/q with p and q up to these: beyond them 2F1 is the shorter form


def breaks_printed(alpha: Expr, alpha_prime: Expr) -> bool:
    """Whether (alpha'-1)/(alpha'-alpha) is 0, -1, -2, ...: footnote 22 as printed is then not defined."""
    index = (alpha_prime - 1) / (alpha_prime - alpha)
    return bool(index.is_integer and index.is_nonpositive)


def breaks_companion(alpha: Expr, alpha_prime: Expr) -> bool:
    """Whether (1-alpha)/(alpha'-alpha) is 0, -1, -2, ...: the companion form is then not defined."""
    index = (1 - alpha) / (alpha_prime - alpha)
    return bool(index.is_integer and index.is_nonpositive)


def printed_antiderivative(low: Law, high: Law, x: Expr) -> Expr:
    """Footnote 22 of Lancaster 2020 as printed; InputError where it breaks down."""
    (alpha, c), (alpha_prime, c_prime) = low, high
    if breaks_printed(alpha, alpha_prime):
        raise InputError("alpha", _broken("printed", alpha, alpha_prime), "the companion form for these exponents")
    index = (alpha_prime - 1) / (alpha_prime - alpha)
    z = -c / c_prime * x ** (alpha - alpha_prime)
    return x ** (1 - alpha_prime) / (c_prime * (1 - alpha_prime)) * hyper((1, index), (index + 1,), z)


def companion_antiderivative(low: Law, high: Law, x: Expr) -> Expr:
    """The form with the two laws exchanged; InputError where it breaks down."""
    (alpha, c), (alpha_prime, c_prime) = low, high
    if breaks_companion(alpha, alpha_prime):
        raise InputError("alpha", _broken("companion", alpha, alpha_prime), "the printed form for these exponents")
    index = (1 - alpha) / (alpha_prime - alpha)
    z = -c_prime / c * x ** (alpha_prime - alpha)
    return x ** (1 - alpha) / (c * (1 - alpha)) * hyper((1, index), (index + 1,), z)


def two_law_time(low: Law, high: Law, A: Expr = amplitude_symbol) -> Expr:
    """tau(A), 0 < A <= 1: the companion form for alpha < 1, the printed one otherwise; exponents alpha < alpha'."""
    _require_order(low, high)
    antiderivative = companion_antiderivative if low[0] < 1 else printed_antiderivative
    return antiderivative(low, high, S.One) - antiderivative(low, high, A)


def elementary_time(low: Law, high: Law, A: Expr = amplitude_symbol) -> Expr:
    """tau(A) in logarithms, arctangents and powers, for rational exponents alpha < alpha'; InputError otherwise.

    A = 0 gives the extinction time when alpha < 1, and infinity else.
    """
    _require_order(low, high)
    (alpha, c), (alpha_prime, c_prime) = low, high
    if not (alpha.is_Rational and alpha_prime.is_Rational):
        raise InputError("alpha", f"{alpha}, {alpha_prime} are not both rational", "rational exponents")
    d = alpha_prime - alpha

    def below(x: Expr) -> Expr:
        return x ** (1 - alpha) / (c * (1 - alpha)) * elementary_F((1 - alpha) / d, c_prime / c * x**d)

    def above(x: Expr) -> Expr:
        factor = x ** (1 - alpha_prime) / (c_prime * (1 - alpha_prime))
        return factor * elementary_F((alpha_prime - 1) / d, c / c_prime * x**-d)

    antiderivative = below if alpha < 1 else above
    if A == 0:
        return antiderivative(S.One) if alpha < 1 else S.Infinity
    return antiderivative(S.One) - antiderivative(A)


def time_of_amplitude(laws: Mapping[Expr, Expr]) -> Expr | None:
    """tau(A) for {exponent: kappa}, one law or two: elementary where that is short, else by 2F1; None for other sums.

    >>> from sympy import expand, symbols
    >>> k, c = symbols("kappa_1 kappa_2", positive=True)
    >>> time_of_amplitude({S(1): k})
    -log(A)/kappa_1
    >>> expand(2 * k * time_of_amplitude({S(1): k, S(3): c}) - log(1 + k / (c * amplitude_symbol**2)) + log(1 + k / c))
    0
    """
    pairs = sorted(laws.items(), key=lambda law: law[0])
    if len(pairs) == 1:
        alpha, kappa = pairs[0]
        A = amplitude_symbol
        return -log(A) / kappa if alpha == 1 else (A ** (1 - alpha) - 1) / ((alpha - 1) * kappa)
    if len(pairs) != 2:
        return None
    low, high = pairs
    d = high[0] - low[0]
    index = (1 - low[0]) / d if low[0] < 1 else (high[0] - 1) / d
    rational = low[0].is_Rational and high[0].is_Rational
    # The elementary form has about q logarithms and p/q powers: where that is more than a line, 2F1 says it better.
    if rational and index.p <= MAX_POWER and index.q <= MAX_ROOT:
        return expand_mul(elementary_time(low, high))
    return two_law_time(low, high)


def extinction_time(low: Law, high: Law) -> Expr | None:
    """tau(0) = companion(1) for alpha < 1; None for alpha >= 1, where A vanishes only in the limit."""
    _require_order(low, high)
    return companion_antiderivative(low, high, S.One) if low[0] < 1 else None


def long_time_amplitude(low: Law, high: Law, tau: Expr) -> Expr:
    """The leading A(tau) for tau -> infinity, the smallest exponent alpha >= 1 ruling (Lancaster (22) generalised).

    alpha > 1: [(alpha-1) kappa tau]^(-1/(alpha-1)), independent of the start, of kappa' and of alpha'.
    alpha = 1: (1 + kappa'/kappa)^(-1/(alpha'-1)) exp(-kappa tau): the start is forgotten when kappa' >> kappa.
    alpha < 1: the motion of the averaged law ends at tau_e, with [(1-alpha) kappa (tau_e - tau)]^(1/(1-alpha)).

    >>> from sympy import symbols
    >>> k, k_prime, tau = symbols("kappa kappa_prime tau", positive=True)
    >>> long_time_amplitude((S(1), k), (S(3), k_prime), tau)
    exp(-kappa*tau)/sqrt(1 + kappa_prime/kappa)
    """
    _require_order(low, high)
    (alpha, kappa), (alpha_prime, kappa_prime) = low, high
    if alpha == 1:
        return (1 + kappa_prime / kappa) ** (-1 / (alpha_prime - 1)) * exp(-kappa * tau)
    if alpha > 1:
        return held_power((alpha - 1) * kappa * tau, -1 / (alpha - 1))
    return held_power((1 - alpha) * kappa * (companion_antiderivative(low, high, S.One) - tau), 1 / (1 - alpha))


def elementary_F(a: Expr, w: Expr) -> Expr:
    """2F1(1, a; a+1; -w) for rational a > 0 and w > 0, elementary (module docstring).

    >>> from sympy import Symbol
    >>> w = Symbol("w", positive=True)
    >>> elementary_F(S(2), w), elementary_F(Rational(1, 2), w)
    ((2*w - 2*log(w + 1))/w**2, atan(sqrt(w))/sqrt(w))
    """
    if not (a.is_Rational and a.is_positive):
        raise InputError("a", f"{a} is not a positive rational number", "a = p/q > 0")
    p, q = int(a.p), int(a.q)
    y = w ** Rational(1, q)
    return p * _integral(p, q, y) / y**p


def _integral(p: int, q: int, y: Expr) -> Expr:
    """int_0^y u^(p-1)/(1+u^q) du, real form: each conjugate pair w = exp(+-i theta) of roots of w^q = -1 together."""
    if p > q:
        return y ** (p - q) / (p - q) - _integral(p - q, q, y)
    total: Expr = S.Zero
    for j in range(q // 2):
        theta = pi * Rational(2 * j + 1, q)
        # w^p ln(1 - y/w) and its conjugate together: 2 Re = cos(p theta) ln|1 - y/w|^2 - 2 sin(p theta) arg(1 - y/w).
        angle = atan(y) if q == 2 else atan2(y * sin(theta), 1 - y * cos(theta))
        size = log(1 - 2 * y * cos(theta) + y**2)
        total += 2 * sin(p * theta) * angle - cos(p * theta) * size
    # An odd q has the root w = -1, which is its own conjugate.
    if q % 2:
        total -= (-1) ** p * log(1 + y)
    return total / q


def _require_order(low: Law, high: Law) -> None:
    if not (low[0].is_number and high[0].is_number and bool(low[0] < high[0]) and low[0].is_nonnegative):
        raise InputError("alpha", f"{low[0]}, {high[0]} are not in order", "numbers 0 <= alpha < alpha'")


def _broken(form: str, alpha: Expr, alpha_prime: Expr) -> str:
    return f"the {form} form breaks down at alpha = {alpha}, alpha' = {alpha_prime}"
