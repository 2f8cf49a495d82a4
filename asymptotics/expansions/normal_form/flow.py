"""From the half-swing map to its flow: U = d ln A/d psi and W = d tau/d psi in the turning-point gauge.

The flow is the iterative logarithm of the return map, a formal embedding: it exists at every order.  A germ that is
tangent to the identity is embedded in an analytic flow only where its invariants vanish (Ecalle 1981, Voronin 1981);
``divergence`` encloses those of the half-swing.

The half-swing multiplies A by exp(L(delta)), takes the time T(delta), and moves delta_i to F_i(delta).  With the
composition operator C f = f o F, the flow d delta_i/d psi = V_i = (alpha_i - 1) delta_i U whose time-pi map is F has

    D = sum_i V_i d_i = (log C)/pi,       (exp(pi D) - 1)/D U = L,       (exp(pi D) - 1)/D W = T,

because ln A and tau grow by int_0^pi U d psi and int_0^pi W d psi on the half-swing.  Hence

    U = (1/pi) (log C)/(C - 1) L,    W = (1/pi) (log C)/(C - 1) T,    (log C)/(C - 1) = sum_k (-1)^k/(k + 1) (C - 1)^k,

finite at each order, since C - 1 raises the degree: C delta^n = delta^n exp(a_n L), a_n = sum_i n_i (alpha_i - 1).
At alpha = 1 all a_n vanish and U = L/pi, W = T/pi.  t -> -t with epsilon -> -epsilon makes
U odd and W even in the losses; springs keep their sign.

>>> from asymptotics.expansions.half_swings.exact import exact_half_swing
>>> flow = flow_of(exact_half_swing((0,), 6))
>>> flow.V[0], flow.W                                  # Coulomb: V = (2/pi) delta^2, W = 1 exactly
(2/pi*d^2 + O(7), 1 + O(7))
>>> flow_of(exact_half_swing((2,), 4)).W
1 + 1/6*d^2 + 19/432*d^4 + O(5)
"""

from dataclasses import dataclass
from typing import Any

from asymptotics.expansions.half_swings.grading import Grading
from asymptotics.expansions.half_swings.quarter import HalfSwing
from asymptotics.series import Key, Series, accumulate, is_exact_zero, monomials


@dataclass(frozen=True)
class Flow:
    """U = d ln A/d psi (odd) and W = d tau/d psi (even) as series in the delta_i of one gauge."""

    grading: Grading
    U: Series
    W: Series

    @property
    def order(self) -> int:
        """The order through which U and W are known."""
        return self.U.order

    @property
    def V(self) -> tuple[Series, ...]:
        """V_i = d delta_i/d psi = (alpha_i - 1) delta_i U."""
        shifted = (self.U.shift(i).truncate(self.order) for i in range(self.grading.variables))
        return tuple(without_zeros(s * w) for s, w in zip(shifted, self.grading.weights))

    @property
    def p(self) -> Series:
        """p(delta) = p_1 delta + p_3 delta^3 + ... in dA/d tau = -A p(delta)."""
        return -self.U / self.W

    @property
    def Omega(self) -> Series:
        """Omega(delta) = Omega_2 delta^2 + ... in d psi/d tau = 1 + Omega(delta)."""
        return self.W.inverse().without_constant()

    def derivative(self, f: Series) -> Series:
        """D f = sum_i V_i d f/d delta_i, the rate of change of f along the flow."""
        return self.U * self.grading.weighted(f)

    def half_swing(self, pi: Any) -> HalfSwing:
        """The time-pi map of the flow: L = sum_j pi^(j+1)/(j+1)! D^j U, T likewise, F = delta exp((alpha - 1) L).

        For a flow in the turning-point gauge this is the half-swing between turning points.
        """
        L, T = (self._accumulated(f, pi) for f in (self.U, self.W))
        return HalfSwing(self.grading, L, self.grading.strengths(L), T)

    def _accumulated(self, f: Series, pi: Any) -> Series:
        total, term, factor = Series({}, f.variables, f.order), f, pi
        # The Taylor series of exp(pi D): D raises the degree, so that it ends.
        for j in range(f.order + 1):
            total = total + term * factor
            term, factor = self.derivative(term), factor * pi / (j + 2)
        return total


def flow_of(half: HalfSwing) -> Flow:
    """The flow of a half-swing in the turning-point gauge; pi is the constant term of its duration.

    Raises UndecidedError if a coefficient that must vanish by reversibility is not an exact zero or a ball around 0.
    """
    pi = half.T.constant_term
    columns = _columns(half)
    U = _log_quotient(half.L, columns).map(lambda x: x / pi)
    # C leaves the constant pi as it is, so that (C - 1) pi = 0 and W begins with 1.
    W = _log_quotient(half.T.without_constant(), columns).map(lambda x: x / pi) + 1
    # Parity is checked, not assumed: a wrong quarter-swing shows here.
    return Flow(half.grading, half.grading.of_parity(U, 1), half.grading.of_parity(W, 0))


def _columns(half: HalfSwing) -> dict[Key, tuple[tuple[Key, Any], ...]]:
    """The matrix of C - 1 on monomials: delta^n -> delta^n (exp(a_n L) - 1) for every n of degree 1, ..., order - 1."""
    columns = {}
    for key in (k for d in range(1, half.order) for k in monomials(half.grading.variables, d)):
        # delta^n has its own degree: the exponential is wanted through what is left of the order.
        growth = (half.L.truncate(half.order - sum(key)) * half.grading.weight(key)).exp().without_constant()
        columns[key] = tuple((tuple(p + q for p, q in zip(key, k)), c) for k, c in growth.coefficients.items())
    return columns


def _log_quotient(f: Series, columns: dict[Key, tuple[tuple[Key, Any], ...]]) -> Series:
    """sum_k (-1)^k/(k + 1) (C - 1)^k f for a series f without constant term."""
    total, term, k = f, f, 0
    zero = (0,) * f.variables
    # C - 1 raises the degree, so that nothing is left after as many passes as there are orders.
    while term.coefficients:
        k += 1
        image: dict[Key, Any] = {}
        for key, c in term.coefficients.items():
            if sum(key) < f.order:
                accumulate(image, [(zero, c)], columns[key])
        term = without_zeros(Series(image, f.variables, f.order))
        total = total + term * (-1) ** k / (k + 1)
    return total


def without_zeros(series: Series) -> Series:
    """Drop the coefficients that are certainly zero."""
    return series.with_coefficients({k: c for k, c in series.coefficients.items() if not is_exact_zero(c)})
