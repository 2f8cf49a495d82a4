"""One law, any order, explicit in the slow time: A(tau) and phi(tau) as A_0 and polynomials in D = A_0^(alpha-1).

With A_0 = [1 + (alpha-1) p_1 epsilon tau]^(-1/(alpha-1)) (Lancaster (13)) and D = A_0^(alpha-1), the Laurent
polynomials of ``laurent`` give 1/sigma = G(epsilon) + (alpha-1) p_1 tau = 1/(epsilon D) + sum_n G_n epsilon^n, hence

    delta = epsilon D y,     y = z (1 + g_2 (epsilon D z)^2 + ...),     z = 1/(1 + D sum_n G_n epsilon^(n+1)),
    A = A_0 y^(1/(alpha-1)) = A_0 (1 + sum_k epsilon^(2k) P_k(D)),
    phi = sum_k h_k epsilon^k (1 - (D y)^k) = sum_k epsilon^(2k-1) Q_k(D),      h_k = r_(k+1)/(k (alpha-1) p_1).

G, H have odd powers only, because p is odd and Omega even: so no logarithm occurs, at any order.  For alpha > 1, D -> 0
and phi tends to -(h_1 epsilon + ...) with a minus: a finite lag.  Through order N (p_k, Omega_k with k <= N) the sums
stop before epsilon^N, and that is the error at fixed slow time epsilon tau.

alpha = 1: delta = epsilon for all time, A = exp(-epsilon tau/2) and phi = Omega(epsilon) tau.

>>> from asymptotics.expansions.multiple_scales.turning import turning_hierarchy
>>> air = turning_hierarchy((2,), 4)
>>> found = slow_time(fmpq(2), air.p, air.Omega)
>>> amplitude, phase = expressions(found)
>>> amplitude
epsilon**2*(D**2/90 - D/90) + 1
>>> phase
epsilon**3*(43*pi*D**3/8640 - pi*D**2/720 - 31*pi/8640) + epsilon*(pi*D/8 - pi/8)
"""

from collections.abc import Callable, Iterable, Iterator
from math import inf
from typing import Any, NamedTuple

import numpy as np
import sympy
from flint import arb, fmpq
from sympy import Add, Expr, Float, Pow, Symbol

from asymptotics.envelopes.laurent import LaurentEnvelope, envelope_of_series
from asymptotics.expansions.half_swings.pi_ring import PiNumber
from asymptotics.expansions.normal_form.digits import expansions
from asymptotics.expansions.normal_form.tau_polynomial import TauPolynomial
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.decimals import MAX_DIGITS, bits_for, decimal_of_ball
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.integers import require_integer
from asymptotics.numbers.precision import at_growing_precision
from asymptotics.series import Key, Series, divided, is_exact_zero
from asymptotics.terms import Term

# What a ball is shown with; digits that are claimed come from ``certified_slow_time``.
_DIGITS = 30
# A root of doubles is taken for real; of a pair that is nearly double, which this may miss, A touches 0.
_REAL = 1e-9
D, epsilon = Symbol("D", positive=True), Symbol("epsilon", positive=True)


class SlowTime(NamedTuple):
    """A/A_0 and phi as series in epsilon, coefficients polynomials in D."""

    amplitude: Series
    phase: Series


def slow_time(alpha: Any, p: Series, Omega: Series) -> SlowTime:
    """The two series through the order N of ``p`` and ``Omega``, without epsilon^N; InputError for alpha = 1.

    ``alpha`` and the coefficients live in one ring: exact numbers, or SymPy expressions.
    """
    return explicit(envelope_of_series(alpha, p, Omega), p.order - 1)


def explicit(envelope: LaurentEnvelope, last: int, weight: Any = None) -> SlowTime:
    """The same from the Laurent polynomials, through epsilon^``last``; ``weight``: 1/(alpha-1) in their ring."""
    rows = [{n[0]: c for n, c in s.coefficients.items()} for s in (envelope.q, envelope.r, envelope.reversal)]
    q, r, reversal = rows
    # What the denominator of z has beside 1: G_n = -q_(n+1)/n, each power with one factor D.
    lagging: dict[Key, Any] = {(k,): TauPolynomial((0, divided(-c, k - 1))) for k, c in q.items() if 2 <= k <= last}
    z = (Series(lagging, 1, last) + 1).inverse() if lagging else Series.constant(1, 1, last)
    # The reversal of ``laurent`` at sigma = epsilon D z, divided by epsilon D.
    y = z
    for k, c in sorted(reversal.items()):
        if 3 <= k <= last + 1:
            y = y + _monomial(k - 1, k - 1, last) * c * z**k
    weight = 1 / (envelope.alpha - 1) if weight is None else weight
    # The power by logarithm and exponential, for its exponent may be a symbol; the logarithm wants a constant term that
    # is exactly 1, which it is, whatever the ring has made of it.
    amplitude = ((y.without_constant() + 1).log() * weight).exp()
    phase, powers = Series({}, 1, last), y
    for k in range(1, last + 1):
        if not is_exact_zero(r.get(k + 1, 0)):
            h = divided(r[k + 1], k) * weight / envelope.p_1
            phase = phase + _monomial(k, 0, last) * h - _monomial(k, k, last) * h * powers
        powers = powers * y
    return SlowTime(amplitude, phase)


def certified_slow_time(alpha: ExactReal, order: int, digits: int, *, above: int = 0) -> tuple[Expr, Expr]:
    """A/A_0 and phi in epsilon and D beyond epsilon^``above``, each coefficient rounded correctly to ``digits`` digits.

    From the balls of the half-swing, for any exponent but 1.  A coefficient whose ball holds 0 is left out once the
    ball is below 10^(-2 digits).

    >>> from asymptotics.numbers.exact import parse_real
    >>> certified_slow_time(parse_real("3/2", "alpha"), 4, 12, above=2)[1]
    epsilon**3*(0.0306942677964*D**3 - 0.00235589785089*D**2 - 0.0283383699455)
    """

    require_integer(digits, "digits", 1, MAX_DIGITS)

    def attempt(bits: int) -> list[Expr] | None:
        rates = expansions([Term(1, alpha)], order)
        found = slow_time(alpha.ball(), rates["p"], rates["Omega"])
        rows = [[(n, i, x) for n, i, x in _coefficients(series) if n > above] for series in found]
        texts = [[(n, i, _rounded(x, digits)) for n, i, x in row] for row in rows]
        if any(text is None for row in texts for *_, text in row):
            return None
        return [_sum((n, i, Float(text, digits)) for n, i, text in row if text != "0") for row in texts]

    # Four bits an order are a first guess of what the recursions cancel: too few cost another pass, and no digit.
    amplitude, phase = at_growing_precision(attempt, digits, bits_for(digits, 4 * order + 64))
    return amplitude, phase


def _rounded(x: Any, digits: int) -> str | None:
    """The decimal of a ball, "0" where it is that small and holds 0, None if that is not decided."""
    x = arb(x)
    # A zero by theorem is in its ball at every precision; a coefficient that is not zero leaves its ball in the end,
    # unless it is below 10^(-2 digits), where it is left out.
    if x.contains(0):
        return "0" if abs(x) < arb(10) ** (-2 * digits) else None
    return decimal_of_ball(x, digits)


def _coefficients(series: Series) -> Iterator[tuple[int, int, Any]]:
    """(n, i, x) of x epsilon^n D^i."""
    for (n,), c in sorted(series.coefficients.items()):
        for i, x in enumerate(TauPolynomial.lift(c).coefficients):
            if not is_exact_zero(x):
                yield n, i, x


def _monomial(n: int, power: int, order: int) -> Series:
    """The monomial epsilon^n D^power."""
    return Series({(n,): TauPolynomial((0,) * power + (1,))}, 1, order)


def expressions(found: SlowTime) -> tuple[Expr, Expr]:
    """A/A_0 and phi as SymPy expressions in epsilon and D."""
    amplitude, phase = (expression(series, _number) for series in found)
    return amplitude, phase


def expression(series: Series, written: Callable[[Any], Expr]) -> Expr:
    """One series in epsilon and D, each coefficient as it is ``written``."""
    return _sum((n, i, written(x)) for n, i, x in _coefficients(series))


def _sum(rows: Iterable[tuple[int, int, Expr]]) -> Expr:
    """sum_n epsilon^n (sum_i x D^i)."""
    parts: dict[int, list[Expr]] = {}
    for n, i, x in rows:
        parts.setdefault(n, []).append(x * D**i)
    return Add(*[epsilon**n * Add(*part) for n, part in parts.items()])


def end_of_amplitude(relative: Expr, alpha: Expr, p_1: Expr) -> Callable[[float], float]:
    """tau where A = A_0 ``relative``(D, epsilon) first vanishes, as a function of epsilon; infinity for alpha >= 1.

    In doubles, no bound.

    >>> round(end_of_amplitude(sympy.Integer(1), sympy.Integer(0), 2 / sympy.pi)(0.02), 6)
    78.539816
    """
    if not (alpha.is_number and alpha < 1):
        return lambda _: inf
    # D = 1/(1 + (alpha-1) p_1 epsilon tau) grows from 1 to infinity, where A_0 is 0; beyond, its powers are complex.
    coefficients = sympy.lambdify([epsilon], sympy.Poly(relative, D).all_coeffs(), "numpy")
    rate = float((1 - alpha) * p_1)

    def end(strength: float) -> float:
        roots = np.roots([float(c) for c in coefficients(strength)])
        first = min((float(r.real) for r in roots if abs(r.imag) <= _REAL * abs(r) and r.real > 1), default=inf)
        return (1 - 1 / first) / (rate * strength) if strength else inf

    return end


def leading_amplitude(alpha: Expr, p_1: Expr, strength: Expr, tau: Expr) -> tuple[Expr, Expr]:
    """(A_0, D) of Lancaster (13) for alpha != 1."""
    growth = 1 + (alpha - 1) * p_1 * strength * tau
    return Pow(growth, -1 / (alpha - 1)), 1 / growth


def _number(c: Any) -> Expr:
    if isinstance(c, PiNumber):
        return c.to_sympy()
    if isinstance(c, arb):
        return Float(c.mid().str(_DIGITS, radius=False), _DIGITS)
    return to_sympy(c) if isinstance(c, fmpq | int) else c
