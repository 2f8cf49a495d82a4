"""The limit cycle of x'' + x + mu sum_i E_i x^m_i x'^alpha_i = 0 as series in mu: rational for van der Pol, Rayleigh.

The method of Lindstedt and Poincare: the frequency is expanded with the orbit, so that no secular term is left.

The laws are polynomials (m_i even, alpha_i odd) of degrees d_i = m_i + alpha_i.  At mu = 0 every amplitude closes; the
energy balance sum_i E_i <c^m_i s^(alpha_i+1)> A^(d_i-1) = 0, a polynomial in A^2, picks A_0.  With x = A_0 y, psi the
phase and omega = d psi/d tau, order by order in mu

    omega^2 y'' + y + mu sum_i e_i y^m_i (omega y')^alpha_i = 0,      e_i = E_i A_0^(d_i-1),    y'(0) = 0.

t -> -t with mu -> -mu maps the cycle to itself: y_k is a cosine series for even k and a sine series for odd k, so
amplitude and frequency are even in mu.  With mu = i eta and q = e^(i psi) all coefficients are real:

    yhat - omega^2 theta^2 yhat + eta sum_i (-1)^((alpha_i+1)/2) e_i yhat^m_i (omega theta yhat)^alpha_i = 0,
    theta = q d/dq.

At even k the first harmonic fixes (omega^2)_k.  At odd k it fixes the first harmonic a of y_(k-1): y -> (1 + a) y
multiplies a force of degree d by 1 + d a, so that a = R_1/sum_i d_i (force_i)_1.  At odd k the turning point,
y'(0) = 0, fixes the first harmonic of y_k.  A small departure from the cycle is multiplied, in one period, by the
exponential of -mu int sum_i E_i alpha_i x^m_i x'^(alpha_i-1) d tau (Liouville), an odd series: ``log_multiplier``, in
units of pi.

yhat_k has the odd harmonics |h| <= 1 + k (D - 1), D the largest degree, and is stored as q^(1 + k (D-1)) yhat_k, a
polynomial in q^2.

>>> van_der_pol = limit_cycle_series(Law({1: -1, (1, 2): 1}), 4)
>>> van_der_pol.amplitude, van_der_pol.frequency                # 2 (1 + mu^2/192 ...), 1 - mu^2/16 + 17 mu^4/3072
({0: 1, 2: 1/192, 4: -1033/1105920}, {0: 1, 2: -1/16, 4: 17/3072})
>>> van_der_pol.square, van_der_pol.log_multiplier              # A_0^2, and -2 pi mu + ...
(4, {1: -2, 3: -1/4})
"""

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import arb, arb_poly, fmpq, fmpq_poly

from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.law import Law
from asymptotics.numbers.context import cached_property
from asymptotics.numbers.rationals import to_fmpq
from asymptotics.running.budget import tick
from asymptotics.terms import Term

# A limit of work: the number of harmonics grows with the order, and the fractions with them.
MAX_ORDER = 60


@dataclass(frozen=True)
class LimitCycleSeries:
    """Even series in mu of A/A_0 and omega, the odd one of the logarithm of the multiplier over pi, and A_0^2.

    Coefficients are fmpq when the strengths and A_0^2 are rational (``is_exact``), else balls.
    """

    order: int
    square: Any
    amplitude: dict[int, Any]
    frequency: dict[int, Any]
    log_multiplier: dict[int, Any]

    @property
    def is_exact(self) -> bool:
        """Whether the coefficients are rational numbers."""
        return isinstance(self.square, fmpq)


def limit_cycle_series(law: Law, order: int, near: float | None = None) -> LimitCycleSeries:
    """The series through mu^order of the cycle whose A_0 is nearest to ``near``; without it there must be one cycle.

    Raises InputError for springs, laws that are no polynomials in x and v, or no balance; LimitError for the order.
    """
    if order > MAX_ORDER:
        raise LimitError("order", f"{order} is above the limit", f"an integer from 0 to {MAX_ORDER}")
    terms = require_polynomial(law)
    square = balanced_square(terms, near)
    solver = _Solver(terms, square, order + 1)
    return solver.result(order)


def require_polynomial(law: Law, *, springs: bool = False) -> tuple[Term, ...]:
    """The terms, if all are losses or gains x^m x'^alpha with m even and alpha odd; InputError else.

    With ``springs`` also x^p x'^q with p odd and q even: at a number mu, not in the series.
    """
    for t in law.terms:
        if t.sign > 0:
            if not springs:
                known = "laws only, or a number mu"
                raise InputError("spring", f"{t.shape()}: the series in mu are those of the linear spring", known)
            odd = t.velocity.is_integer and int(t.velocity.rational) % 2 == 0 and t.position % 2
            if t.family or not odd:
                raise InputError("spring", f"{t.shape()} is no odd polynomial in x", "x^P x'^Q with P odd and Q even")
            continue
        if not t.velocity.is_integer or int(t.velocity.rational) % 2 == 0 or t.position % 2:
            raise InputError("law", f"{t.shape()} is no polynomial in x and x'", "x^M x'^A with M even and A odd")
    return law.terms


def balanced_square(terms: tuple[Term, ...], near: float | None = None) -> Any:
    """A_0^2 > 0 with sum_i E_i <c^m s^(alpha+1)> A^(d-1) = 0: fmpq if rational, else a ball.

    >>> balanced_square(Law({1: -1, 3: 1}).terms)                  # Rayleigh: <s^2> = <s^4> A^2
    4/3
    """
    top = max((_degree(t) - 1) // 2 for t in terms)
    rational = all(t.strength.is_rational for t in terms)
    if not rational:
        raise InputError("law", "a strength is irrational", "rational strengths: the common factor is mu")
    coefficients = [fmpq(0)] * (top + 1)
    for t in terms:
        coefficients[(_degree(t) - 1) // 2] += _rational(t) * circle_mean(t.position, int(t.velocity.rational) + 1)
    balance = fmpq_poly(coefficients)
    found = _positive_roots(balance)
    if not found:
        raise InputError("law", "gains and losses balance at no amplitude: there is no limit cycle", "both signs")
    # The nearest of the balances, in doubles: which cycle is meant, and not where it is.
    if near is not None:
        return min(found, key=lambda z: abs(float(arb(z).sqrt().mid()) - near))
    if len(found) > 1:
        shown = ", ".join(f"{float(arb(z).sqrt().mid()):.4g}" for z in found)
        raise InputError("law", f"there are {len(found)} limit cycles, near A = {shown}", "one of them by near")
    return found[0]


def _positive_roots(balance: fmpq_poly) -> list[Any]:
    """The positive roots: rational ones as fmpq, others as balls; UndecidedError for a multiple one."""
    found: list[Any] = []
    _, factors = balance.numer().factor()
    for factor, multiplicity in factors:
        if factor.degree() == 1:
            roots: list[Any] = [-fmpq(factor[0], factor[1])]
        else:
            pairs: Any = factor.complex_roots()
            # FLINT isolates the roots of an irreducible factor, the real ones with an imaginary part that is exactly 0.
            roots = [z.real for z, _ in pairs if z.imag.contains(0) and z.imag.is_exact()]
        positive = [z for z in roots if z > 0]
        # Where the balance does not change its sign the first order does not decide whether there is a cycle.
        if positive and multiplicity > 1:
            raise UndecidedError("a double root of the energy balance: the cycle has no series in mu")
        found += positive
    return sorted(found, key=lambda z: float(arb(z).mid()))


def circle_mean(m: int, n: int) -> fmpq:
    """<c^m s^n> for even m and n: (m-1)!! (n-1)!!/(m+n)!!."""
    value = fmpq(1)
    for k in range(1, m // 2 + 1):
        value *= fmpq(2 * k - 1, n + 2 * k)
    for k in range(1, n // 2 + 1):
        value *= fmpq(2 * k - 1, 2 * k)
    return value


def _degree(t: Term) -> int:
    return int(t.velocity.rational) + t.position


def _rational(t: Term) -> fmpq:
    return to_fmpq(Fraction(t.b.rational))


class _Solver:
    """The recurrence of the module docstring; ``y``, ``w``: yhat_k and (omega^2)_k in eta."""

    def __init__(self, terms: tuple[Term, ...], square: Any, order: int) -> None:
        self.terms, self.square, self.order = terms, square, order
        self.exact = isinstance(square, fmpq)
        self.poly: Any = fmpq_poly if self.exact else arb_poly
        self.one: Any = fmpq(1) if self.exact else arb(1)
        self.spread = max(map(_degree, terms)) - 1
        self.strengths = [
            _rational(t) * square ** ((_degree(t) - 1) // 2) * (-1) ** ((int(t.velocity.rational) + 1) // 2)
            for t in terms
        ]
        half: Any = self.one / 2
        self.y: list[Any] = [self.poly([half, half])]
        self.w: list[Any] = [self.one]
        self.omega: list[Any] = [self.one]
        self.X = self._powers(self.y[0], max(t.position for t in terms))
        self.V = self._powers(self.poly([-half, half]), max(int(t.velocity.rational) for t in terms))
        # ``order`` is one more than asked for: only there is the first harmonic of the order before fixed.
        for k in range(1, order + 1):
            tick(f"power {k} of {order} of mu")
            self._advance(k)

    def _powers(self, base: Any, top: int) -> list[list[Any]]:
        return [[base**e] for e in range(max(top, 1) + 1)]

    def _advance(self, k: int) -> None:
        """Order k: the right side, the first harmonic, and y_k with its powers."""
        h = 1 + k * self.spread
        first = (h + 1) // 2
        R = self._right_side(k)
        if k % 2:
            a = self._correction(R[first]) if k > 1 else 0 * self.one
            R = R - self._degree_zero(a)
            self._enlarge(k - 1, a)
            self.w.append(0 * self.one)
        else:
            self.w.append(-2 * R[first])
            R = R + (self.w[k] * self.y[0]).left_shift(k * self.spread // 2)
        harmonics = [2 * i - h for i in range(h + 1)]
        # y'' + y on the harmonic m is 1 - m^2; the first harmonic resonates, and what it asks for has been met above.
        values = [R[i] / (1 - m * m) if abs(m) != 1 else 0 * self.one for i, m in enumerate(harmonics)]
        if k % 2:
            # y'(0) = 0: the phase counts from a turning point, which fixes the sine part of the first harmonic.
            b = sum((m * v for m, v in zip(harmonics, values)), start=0 * self.one) / 2
            values[first], values[first - 1] = -b, b
        self.y.append(self.poly(values))
        self._extend(k)

    def _right_side(self, k: int) -> Any:
        """-F_(k-1) + sum_(0<j<k) w_j theta^2 y_(k-j)."""
        total = -self._force(k - 1)
        for j in range(2, k, 2):
            part = self.w[j] * self._turned(self._turned(self.y[k - j], k - j), k - j)
            total = total + part.left_shift(j * self.spread // 2)
        return total

    def _force(self, n: int) -> Any:
        """F_n = sum_i e_i X^m V^alpha at degree n, with the shift of order n + 1."""
        total = self.poly([])
        for t, e in zip(self.terms, self.strengths):
            product = self._product(t.position, int(t.velocity.rational), n)
            total = total + (product * e).left_shift((self.spread + 1 - _degree(t)) // 2)
        return total

    def _product(self, m: int, alpha: int, n: int) -> Any:
        """Degree n of X^m V^alpha."""
        X, V = self.X[m], self.V[alpha]
        if not m:
            return V[n]
        return sum((X[j] * V[n - j] for j in range(n + 1)), start=self.poly([]))

    def _degree_zero(self, a: Any) -> Any:
        """a sum_i d_i force_i at degree 0, with the shift of the present order: what y_(k-1) + a y_0 adds."""
        k = len(self.y)
        total = self.poly([])
        for t, e in zip(self.terms, self.strengths):
            part = self.X[t.position][0] * self.V[int(t.velocity.rational)][0] * (e * a * _degree(t))
            total = total + part.left_shift((self.spread + 1 - _degree(t) + (k - 1) * self.spread) // 2)
        return total

    def _correction(self, R_1: Any) -> Any:
        """a with R_1 = a sum_i d_i (force_i)_1."""
        k = len(self.y)
        return R_1 / self._degree_zero(self.one)[(2 + k * self.spread) // 2]

    def _enlarge(self, k: int, a: Any) -> None:
        """y_k += a y_0, in y and in all powers, whose degree 0 scales with it."""
        # A_0 is the amplitude of y_0 by the energy balance; only later orders are corrected.
        if k < 1:
            return
        shift = k * self.spread // 2
        self.y[k] = self.y[k] + (a * self.y[0]).left_shift(shift)
        for powers in (self.X, self.V):
            for e in range(1, len(powers)):
                powers[e][k] = powers[e][k] + (e * a * powers[e][0]).left_shift(shift)

    def _extend(self, k: int) -> None:
        """omega_k, the velocity omega theta y at degree k, and degree k of all powers."""
        known = sum((self.omega[j] * self.omega[k - j] for j in range(1, k)), start=0 * self.one)
        self.omega.append((self.w[k] - known) / 2)
        velocity = self.poly([])
        for j in range(0, k + 1, 2):
            part = self.omega[j] * self._turned(self.y[k - j], k - j)
            velocity = velocity + part.left_shift(j * self.spread // 2)
        for powers, first in ((self.X, self.y[k]), (self.V, velocity)):
            powers[0].append(self.poly([]))
            powers[1].append(first)
            for e in range(2, len(powers)):
                below, base = powers[e - 1], powers[1]
                powers[e].append(sum((below[j] * base[k - j] for j in range(k + 1)), start=self.poly([])))

    def _turned(self, p: Any, k: int) -> Any:
        """q d_q of the stored y_k."""
        return 2 * p.derivative().left_shift(1) - (1 + k * self.spread) * p

    def result(self, order: int) -> LimitCycleSeries:
        """Back to mu: eta^k = (-1)^(k/2) mu^k for even k; the logarithm from Liouville's formula."""
        amplitude, frequency, rate = {}, {}, []
        for k in range(order + 1):
            if k % 2 == 0:
                sign = (-1) ** (k // 2)
                amplitude[k] = sign * self.y[k](self.one)
                frequency[k] = sign * self.omega[k]
            rate.append(self._divergence(k))
        log = {}
        inverse = self._inverse_frequency
        for k in range(1, order + 1, 2):  # -2 pi mu <div>/omega, both even in mu
            total = sum((rate[j] * inverse[k - 1 - j] for j in range(0, k, 2)), start=0 * self.one)
            log[k] = -2 * total * (-1) ** ((k - 1) // 2)
        return LimitCycleSeries(order, self.square, amplitude, frequency, log)

    def _divergence(self, n: int) -> Any:
        """<sum_i E_i alpha_i x^m x'^(alpha-1)> at degree n in eta: V = i Vhat, and e_i has the sign of i^(alpha+1)."""
        total = 0 * self.one
        for t, e in zip(self.terms, self.strengths):
            alpha = int(t.velocity.rational)
            middle = (_degree(t) - 1 + n * self.spread) // 2
            total = total - e * alpha * self._product(t.position, alpha - 1, n)[middle]  # i^(alpha-1) = -i^(alpha+1)
        return total

    @cached_property
    def _inverse_frequency(self) -> list[Any]:
        inverse = [self.one]
        for k in range(1, len(self.omega)):
            inverse.append(-sum((self.omega[j] * inverse[k - j] for j in range(1, k + 1)), start=0 * self.one))
        return inverse
