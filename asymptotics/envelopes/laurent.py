"""One law, any order: time and phase as Laurent polynomials in the local strength delta, and delta(tau) by reversal.

From dA/dtau = -A p(delta), p = p_1 delta + p_3 delta^3 + ..., follows ddelta/dtau = -(alpha-1) delta p(delta).  Put

    p_1 delta/p(delta) = 1 + q_2 delta^2 + q_4 delta^4 + ...,     p_1 delta Omega/p = r_2 delta^2 + r_4 delta^4 + ...

Only even powers occur, hence 1/(delta p) has no term 1/delta and its integral no logarithm:

    (alpha-1) p_1 tau = G(delta) - G(delta_0),         G(delta) = 1/delta - sum_(k=2,4,..) q_k delta^(k-1)/(k-1),
    (alpha-1) p_1 phi = H(delta_0) - H(delta),         H(delta) = sum_(k=2,4,..) r_k delta^(k-1)/(k-1).

*Explicit.*  With sigma = 1/(G(delta_0) + (alpha-1) p_1 tau) the first line is sigma = 1/G(delta), and reversal of that
series (Lagrange's inversion; not the reversal of time) gives

    delta = sigma (1 + g_2 sigma^2 + g_4 sigma^4 + ...),     A = (delta/delta_0)^(1/(alpha-1)),

Lancaster (13) being its first term.  For alpha > 1, sigma <= sigma(0) = delta_0 + O(delta_0^3) for all tau >= 0: the
truncation is uniform in time.  In the turning-point gauge delta_0 = epsilon; in another one delta_0 =
epsilon |c(epsilon)|^(alpha-1).

The coefficients live in the ring of the expansion: exact, balls, or SymPy expressions.

>>> from asymptotics.expansions.normal_form.expansion import exact_expansion
>>> cubic = laurent_envelope(exact_expansion((3,), 5))
>>> cubic.q, cubic.r
(1 + -15/512*d^2 + 45171/655360*d^4 + O(5), -45/256*d^2 + 7371/262144*d^4 + O(6))
>>> cubic.reversal
1*d + 15/512*d^3 + -3483/163840*d^5 + O(6)
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from flint import arb, fmpq
from sympy import Symbol, latex

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.pi_ring import PiNumber
from asymptotics.expansions.normal_form.expansion import Expansion
from asymptotics.gauges import TURNING_POINT
from asymptotics.numbers.bridge import to_sympy
from asymptotics.series import Series, divided


@dataclass(frozen=True)
class LaurentEnvelope:
    """tau(delta), phi(delta) and delta(tau) through ``order``: p_k for odd k and Omega_k for even k up to it.

    ``q`` and ``r`` are even series in delta, ``reversal`` is delta as an odd series in sigma (module docstring).
    """

    alpha: Any
    gauge: str
    order: int
    p_1: Any
    q: Series
    r: Series
    reversal: Series

    def G(self, delta: Any) -> Any:
        """1/delta - sum q_k delta^(k-1)/(k-1), in the arithmetic of delta and the coefficients."""
        return divided(1, delta) - _integral(self.q, delta)

    def time(self, delta: Any, delta_0: Any) -> Any:
        """tau since delta_0: the truncated Laurent polynomial; no claim about what was cut off."""
        return (self.G(delta) - self.G(delta_0)) / ((self.alpha - 1) * self.p_1)

    def phase(self, delta: Any, delta_0: Any) -> Any:
        """The truncated phase phi(delta) - phi(delta_0)."""
        return (_integral(self.r, delta_0) - _integral(self.r, delta)) / ((self.alpha - 1) * self.p_1)

    def delta(self, tau: Any, delta_0: Any) -> Any:
        """delta(tau) by the truncated reversal.

        For alpha < 1 it is meaningful while sigma > 0, that is for tau < ``extinction_time(delta_0)``.
        """
        sigma = divided(1, self.G(delta_0) + (self.alpha - 1) * self.p_1 * tau)
        return self.reversal.at((sigma,))

    def extinction_time(self, delta_0: Any) -> Any:
        """alpha < 1: where sigma becomes infinite, G(delta_0)/((1-alpha) p_1), beyond which the expansion says nothing.

        Raises InputError for alpha > 1, where sigma decreases forever.
        """
        if bool(self.alpha > 1):
            raise InputError("alpha", f"{self.alpha} is above 1: the amplitude never vanishes", "alpha < 1")
        return self.G(delta_0) / ((1 - self.alpha) * self.p_1)

    def map(self, f: Callable[[Any], Any]) -> "LaurentEnvelope":
        """The same formulas with every number sent through the ring map ``f``."""
        q, r, reversal = (s.map(f) for s in (self.q, self.r, self.reversal))
        return LaurentEnvelope(f(self.alpha), self.gauge, self.order, f(self.p_1), q, r, reversal)

    def certified(self) -> "LaurentEnvelope":
        """With balls at the current precision as coefficients, for ball arguments."""
        return self.map(_ball)

    def numeric(self) -> "LaurentEnvelope":
        """With doubles as coefficients, for floats and NumPy arrays: heuristic, no enclosure.

        >>> from asymptotics.expansions.normal_form.expansion import exact_expansion
        >>> envelope = laurent_envelope(exact_expansion((2,), 3)).numeric()
        >>> round(envelope.time(0.05, 0.1), 9)
        23.560635905
        """
        return self.map(lambda c: float(_ball(c).mid()))

    def _repr_latex_(self) -> str:
        d, d_0 = Symbol("delta"), Symbol("delta_0")
        symbolic = self.map(_expression)
        return rf"$\tau = {latex(symbolic.time(d, d_0))},\quad \varphi = {latex(symbolic.phase(d, d_0))}$"


def laurent_envelope(expansion: Expansion) -> LaurentEnvelope:
    """The envelope of an exact or certified expansion of one law with alpha != 1, in its gauge.

    Raises InputError for a sum of laws, and for alpha = 1, where delta does not change: A = exp(-epsilon tau/2) and
    psi = tau sqrt(1 - epsilon^2/4) exactly.
    """
    if len(expansion.degrees) != 1:
        raise InputError("law", "a sum of laws has no single strength delta", "one law")
    return envelope_of_series(expansion.degrees[0], expansion.p, expansion.Omega, expansion.gauge)


def envelope_of_series(alpha: Any, p: Series, Omega: Series, gauge: str = TURNING_POINT) -> LaurentEnvelope:
    """The same from the series p (odd, with p_1 a unit) and Omega (even) of one law, over any coefficient ring."""
    if bool(alpha == 1):
        raise InputError("alpha", "at alpha = 1 delta is constant and A = exp(-epsilon tau/2) exactly", "alpha != 1")
    p_1 = p[1]
    q = (_lowered(p, 1) / p_1).inverse()
    # Omega begins with delta^2: lowered by two it meets q through all orders that both know, and loses none of its own.
    r = _raised(_lowered(Omega, 2) * q.truncate(max(Omega.order - 2, 0)), 2) if Omega.order >= 2 else Omega
    return LaurentEnvelope(alpha, gauge, max(p.order, Omega.order), p_1, q, r, _reversal(q))


def _reversal(q: Series) -> Series:
    """delta(sigma) from 1/sigma = G(delta), i.e. delta = sigma (1 - sum_k q_k delta^k/(k-1)): iterated to its order."""
    order = q.order + 1
    correction = q.without_constant().map_keys(lambda n, c: divided(-c, n[0] - 1))
    delta = Series.variable(0, 1, order)
    # Only even powers stand in the bracket: each pass of the fixed point makes two orders more right.
    for _ in range(order // 2):
        inner = correction.extend(order).compose((delta,)).truncate(q.order)
        delta = _raised(inner + 1, 1)
    return delta


def _integral(series: Series, delta: Any) -> Any:
    """sum_(k>=2) c_k delta^(k-1)/(k-1): the constant term of ``series`` belongs to 1/delta and is not included."""
    return _lowered(series.without_constant(), 1).map_keys(lambda n, c: divided(c, n[0])).at((delta,))


def _lowered(series: Series, by: int) -> Series:
    return Series({(n - by,): c for (n,), c in series.coefficients.items()}, 1, series.order - by)


def _raised(series: Series, by: int) -> Series:
    return Series({(n + by,): c for (n,), c in series.coefficients.items()}, 1, series.order + by)


def _ball(c: Any) -> arb:
    """A coefficient of the exact rings, or a ball, as a ball."""
    if isinstance(c, PiNumber):
        return c.ball()
    return arb(fmpq(c) if isinstance(c, int) else c)


def _expression(c: Any) -> Any:
    """A coefficient as something SymPy can print: exact numbers exactly, balls by six digits."""
    if isinstance(c, PiNumber):
        return c.to_sympy()
    # Six digits are for the eye; the ball itself stays in the series.
    return Symbol(c.str(6, radius=False)) if isinstance(c, arb) else _rational(c)


def _rational(c: Any) -> Any:
    return to_sympy(c) if isinstance(c, fmpq | int) else c
