"""The three gauges of the normal form, and the exact maps between them (theory page ``gauges``).

z = X - i X' = A e^(i psi) Z(psi, delta) leaves one freedom: A e^(i psi) -> A e^(i psi) c(delta) with c(0) = 1.

=====================  ==============================================================================================
``turning-point``      Z(0, delta) = 1: A is the turning amplitude, psi = n pi at the n-th turning point
``averaging``          <Z> = 1: the e^(i psi) coefficient of X - i X' is exactly A
``no-first-harmonic``  <Z + conj(Z) e^(-2 i psi)> = 1: the e^(i psi) coefficient of X is exactly A/2
=====================  ==============================================================================================

The last condition is that of Krylov, Bogoliubov and Mitropolsky.

*The brackets from one family of integrals.*  Start an orbit at a turning point with amplitude 1 and strength delta_0.
Along it X(psi; delta_0) is exp(psi D_1) of the fixed-delta waveform, with D_1 = U + sum_i V_i d_i.  Undoing that, the
e^(i psi) coefficient of X, times 2, is, over the first quarter,

    c_q = (2/pi) sum_j ((-D_1)^j/j!) int_0^T_q Psi^j e^(-i Psi) X (d Psi/d tau) d tau,
    Psi(tau; delta_0) = sum_(j>=1) tau^j/j! G^(j-1) (1/W),    G = (1/W) sum_i V_i d_i,

and Psi^j e^(-i(Psi - tau)) d Psi/d tau is a power series in delta and tau: only the waveform moments
K_k = int tau^k e^(-i tau) X d tau of ``half_swings.quarter`` remain.  The second quarter is the first one reversed, so
c = c_q(delta) + conj(c_q)(-delta), the bracket of ``no-first-harmonic``.  Taking the e^(i psi) coefficient of
d X/d tau = X' gives that of X', and with it the bracket of ``averaging`` without further integrals:

    c_averaging = (1/2) [ c (1 + 1/W) - (i/W) D_1 c ].

With delta = i eta, tau = i sigma every series is real; this is how it is computed.

*The conversion.*  With ln c = lambda + i chi (lambda even, chi odd in delta), A_g = A e^lambda, psi_g = psi + chi,
delta_g = delta e^((alpha - 1) lambda), U_g = (U + D lambda)/(1 + D chi), W_g = W/(1 + D chi).

>>> from asymptotics.expansions.half_swings.exact import exact_quarter_swing
>>> from asymptotics.expansions.half_swings.quarter import half_swing
>>> from asymptotics.expansions.normal_form.flow import flow_of
>>> quarter = exact_quarter_swing((3,), 2, moments=True)
>>> flow = flow_of(half_swing(quarter))
>>> from asymptotics.gauges import GAUGES
>>> for gauge in GAUGES:                                        # Omega_2 of x'^3: right, all three of them
...     print(gauge, gauge_map(flow, quarter.K, gauge).apply(flow).Omega)
turning-point -45/256*d^2 + O(3)
averaging -27/256*d^2 + O(3)
no-first-harmonic 9/256*d^2 + O(3)
"""

from dataclasses import dataclass
from math import factorial

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.grading import Grading
from asymptotics.expansions.normal_form.flow import Flow
from asymptotics.expansions.normal_form.tau_polynomial import TauPolynomial
from asymptotics.gauges import AVERAGING, TURNING_POINT, require_gauge
from asymptotics.series import Series, divided, is_exact_zero


@dataclass(frozen=True)
class GaugeMap:
    """A e^(i psi) -> A e^(i psi) exp(lambda + i chi), with lambda and chi as series in the source gauge's delta."""

    source: str
    target: str
    grading: Grading
    log_modulus: Series
    argument: Series

    @property
    def strengths(self) -> tuple[Series, ...]:
        """delta_i of the target gauge as series in those of the source gauge."""
        return self.grading.strengths(self.log_modulus)

    def inverse(self) -> "GaugeMap":
        """The map back, as series in the target gauge's delta."""
        back = _inverse_log_modulus(self.grading, self.log_modulus)
        argument = -self.argument.compose(self.grading.strengths(back))
        return GaugeMap(self.target, self.source, self.grading, back, argument)

    def then(self, other: "GaugeMap") -> "GaugeMap":
        """First this map, then ``other``; InputError if the gauges do not meet."""
        if self.target != other.source:
            raise InputError("gauge", f"{other.source} is not the target of the first map", self.target)
        log_modulus = self.log_modulus + other.log_modulus.compose(self.strengths)
        argument = self.argument + other.argument.compose(self.strengths)
        return GaugeMap(self.source, other.target, self.grading, log_modulus, argument)

    def apply(self, flow: Flow) -> Flow:
        """The flow of the source gauge, written in the target gauge."""
        # d psi_g = (1 + D chi) d psi: the rates of the docstring, still as functions of the old strengths.
        rate = flow.derivative(self.argument) + 1
        U, W = (flow.U + flow.derivative(self.log_modulus)) / rate, flow.W / rate
        # Then the old strengths as series in the new ones.
        images = self.inverse().strengths
        return Flow(self.grading, U.compose(images), W.compose(images))


def identity_map(flow: Flow, gauge: str = TURNING_POINT) -> GaugeMap:
    """The map from a gauge to itself."""
    nothing = Series({}, flow.U.variables, flow.order)
    return GaugeMap(gauge, gauge, flow.grading, nothing, nothing)


def gauge_map(flow: Flow, K: tuple[tuple[Series, Series], ...], gauge: str) -> GaugeMap:
    """The map from the turning-point gauge to ``gauge``.

    ``flow`` is the turning-point flow through order N and ``K`` its waveform moments, K_k through order N - k
    (not needed for the turning-point gauge itself).
    """
    require_gauge(gauge)
    if gauge == TURNING_POINT:
        return identity_map(flow)
    # The bracket of no-first-harmonic in any case: that of averaging is made of it.
    c = _bracket_of_x(flow, K)
    if gauge == AVERAGING:
        W_inverse = _hat(flow.grading, flow.W, 0).inverse()
        # -(i/W) D_1 c with D_1 = i D_hat_1 at delta = i eta: all of it is real.
        c = (c * (W_inverse + 1) + _d1(flow, c).truncate(flow.order) * W_inverse) / 2
    return map_of_bracket(flow, c, gauge)


def map_of_bracket(flow: Flow, c: Series, gauge: str) -> GaugeMap:
    """The map from the turning-point gauge given c^(eta), the bracket at delta = i eta (real, constant term 1)."""
    l = flow.grading.loss_degree  # noqa: E741 (the letter of ``grading``)
    # eta = -i delta: a monomial of loss degree l gets (-i)^l, which is real for even l and -i times a sign for odd l.
    even = c.map_keys(lambda k, x: x * _sign(l(k)) if l(k) % 2 == 0 else 0 * x)
    odd = c.map_keys(lambda k, x: -x * _sign(l(k) - 1) if l(k) % 2 else 0 * x)
    return GaugeMap(TURNING_POINT, gauge, flow.grading, *_logarithm(even.without_constant() + 1, odd))


def _sign(n: int) -> int:
    """The real number i^n of an even n."""
    return -1 if n % 4 == 2 else 1


def _hat(grading: Grading, series: Series, parity: int) -> Series:
    """f_hat with f(i eta) = i^parity f_hat(eta), for a series of that parity."""
    return series.map_keys(lambda k, x: x * _sign(grading.loss_degree(k) - parity))


def _d1(flow: Flow, f: Series) -> Series:
    """D_hat_1 f = U_hat (1 + sum_i (alpha_i - 1) eta_i d_i) f, known through one order more than f."""
    raised = f.extend(min(f.order + 1, flow.order))
    return _hat(flow.grading, flow.U, 1) * (raised + flow.grading.weighted(raised))


def _bracket_of_x(flow: Flow, K: tuple[tuple[Series, Series], ...]) -> Series:
    """c_hat(eta) of the no-first-harmonic gauge: (4/pi) sum_j (D_hat_1^j/j!) sum_k a_jk K_hat_k."""
    order = flow.order
    if len(K) <= order:
        raise ValueError(f"{order + 1} waveform moments are needed, {len(K)} are given")
    # Without forces K_0 = int_0^(pi/2) e^(-i tau) cos(tau) d tau = pi/4 - i/2: pi comes from the ring itself.
    pi = K[0][0].constant_term * 4
    hatted = [_hat_moment(flow.grading, K[k], k) for k in range(order + 1)]
    ratio, kernel = _phase_kernel(flow)
    terms = []
    for j in range(order + 1):
        terms.append(_contract(kernel.truncate(order - j), hatted, j))
        kernel = kernel * ratio
    # Horner's rule in the operator: (4/pi) (t_0 + D_1 (t_1 + D_1 (t_2 + ...)/2)).
    total = terms[order]
    for j in range(order - 1, -1, -1):
        total = terms[j] + _d1(flow, total) / (j + 1)
    return total.map(lambda x: divided(x * 4, pi))


def _hat_moment(grading: Grading, K: tuple[Series, Series], k: int) -> Series:
    """K_hat_k: the coefficient of eta^m is Re(i^(l(m)-k) K_(k,m)): only that survives adding the second quarter."""
    real, imaginary = K
    sources = (real, -imaginary, -real, imaginary)
    keys = set(real.coefficients) | set(imaginary.coefficients)
    values = {key: sources[(grading.loss_degree(key) - k) % 4].coefficients.get(key, 0) for key in keys}
    return real.with_coefficients({key: x for key, x in values.items() if not is_exact_zero(x)})


def _phase_kernel(flow: Flow) -> tuple[Series, Series]:
    """Psi_hat/sigma and exp(Psi_hat - sigma) d Psi_hat/d sigma, as series whose coefficients are polynomials in
    sigma."""
    W_inverse, U = _hat(flow.grading, flow.W, 0).inverse(), _hat(flow.grading, flow.U, 1)
    ratio, rate, term = Series({}, U.variables, flow.order), Series({}, U.variables, flow.order), W_inverse
    for j in range(flow.order + 1):  # term = (-G_hat)^j (1/W_hat), the coefficient of sigma^(j+1)/(j+1)!
        ratio = ratio + _at_power(term, j, factorial(j + 1))
        rate = rate + _at_power(term, j, factorial(j))
        term = -(W_inverse * U * flow.grading.weighted(term))
    # Psi_hat - sigma = sigma (Psi_hat/sigma - 1).
    lag = ratio.without_constant().map(lambda p: p.shift())
    return ratio, lag.exp() * rate


def _at_power(series: Series, j: int, divisor: int) -> Series:
    return series.map(lambda x: TauPolynomial((0,) * j + (divided(x, divisor),)))


def _contract(kernel: Series, moments: list[Series], j: int) -> Series:
    """sum_k (coefficient of sigma^k in sigma^j kernel) K_hat_k through the order of ``kernel``.

    A power sigma^(j+k) comes with at least eta^k, so K_(j+k) is needed through order N - j - k only.
    """
    total = Series({}, kernel.variables, kernel.order)
    for k in range(kernel.order + 1):
        factor = {key: p.coefficient(k) for key, p in kernel.map(TauPolynomial.lift).coefficients.items()}
        known = kernel.with_coefficients({key: x for key, x in factor.items() if not is_exact_zero(x)})
        total = total + known * moments[j + k].extend(kernel.order)
    return total


def _logarithm(even: Series, odd: Series) -> tuple[Series, Series]:
    """(lambda, chi) with exp(lambda + i chi) = even + i odd: E chi = (even E odd - odd E even)/(even^2 + odd^2)."""
    # ln |c| is half the logarithm of the modulus; the argument
    # by its Euler derivative, so that no arctangent is expanded.
    modulus = even * even + odd * odd
    ones = (1,) * even.variables
    turn = (even * odd.weighted(ones) - odd * even.weighted(ones)) / modulus
    return modulus.log() / 2, turn.without_constant().map_keys(lambda k, x: divided(x, sum(k)))


def _inverse_log_modulus(grading: Grading, log_modulus: Series) -> Series:
    """mu with mu(delta_g) = -lambda(delta_g exp((d - 1) mu)); each pass gains the lowest degree of lambda."""
    degrees = [sum(k) for k, c in log_modulus.coefficients.items() if not is_exact_zero(c)]
    mu = -log_modulus
    for _ in range(log_modulus.order // min(degrees, default=log_modulus.order + 1)):
        mu = -log_modulus.compose(grading.strengths(mu))
    return mu
