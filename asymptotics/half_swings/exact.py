"""The half-swing at integer exponents: every coefficient an exact number of Q[pi].

Three algebras, the smallest that is closed:

* all alpha_i even: ln r is a polynomial in c, so L and F are rational and T is in pi Q;
* all alpha_i odd: the vector field is smooth and pi-periodic in theta, so the flow (U, W) is rational
  (``fourier_flow``) and L = (exp(pi D) - 1)/D U, T = (exp(pi D) - 1)/D W with D = V d/d delta are in Q[pi];
* any integers, also mixed: polynomials in theta, s, c (``theta_algebra``), then the reversal identity.  This is also
  the independent route for the other two, and the only one that gives the quarter-swing and its waveform moments.

>>> half = exact_half_swing((2,), 3)
>>> half.L
-4/3*d + 8/9*d^2 + -416/405*d^3 + O(4)
>>> half.T
pi + pi/6*d^2 + -2*pi/9*d^3 + O(4)
>>> exact_half_swing((3,), 2).L, exact_half_swing((0,), 2).T
(-3*pi/8*d + 9*pi**2/64*d^2 + O(3), pi + O(3))
"""

from math import comb

from flint import fmpq, fmpq_poly

from asymptotics.errors import InputError
from asymptotics.half_swings.fourier_flow import fourier_flow
from asymptotics.half_swings.grading import Grading
from asymptotics.half_swings.orbit import Orbit
from asymptotics.half_swings.pi_ring import PI, PiNumber
from asymptotics.half_swings.quarter import HalfSwing, QuarterSwing, half_swing
from asymptotics.half_swings.theta_algebra import COSINE, ONE, SINE, THETA, ThetaTrig, sine_power
from asymptotics.series import Series


def exact_half_swing(alphas: tuple[int, ...], order: int) -> HalfSwing:
    """L, F, T through delta^order for integer exponents alpha_i >= 0; InputError for anything else."""
    _require_integers(alphas)
    if all(a % 2 == 0 for a in alphas):
        return even_half_swing(alphas, order)
    if all(a % 2 == 1 for a in alphas):
        return odd_half_swing(alphas, order)
    return half_swing(exact_quarter_swing(alphas, order))


def even_half_swing(alphas: tuple[int, ...], order: int) -> HalfSwing:
    """Even exponents: ln r is integrated in c from 1 to -1 as a polynomial; no reversal identity is used.

    >>> even_half_swing((0, 2), 1).L
    -4/3*d1 + -2*d0 + O(2)
    """
    c = fmpq_poly([0, 1])
    powers = tuple(fmpq_poly([1, 0, -1]) ** (a // 2) for a in alphas)
    orbit = Orbit.solve(_grading(alphas).weights, order, powers, c, _from_one)
    L = orbit.series(orbit.log_r, lambda p: PiNumber.rational(p(fmpq(-1))))
    T = orbit.series(orbit.m, lambda m: PI * _mean_of_cosines(c * m)) + PI
    return _assemble(_grading(alphas), L, T)


def _from_one(m: fmpq_poly) -> fmpq_poly:
    """int_1^c m dc, which is -int_0^theta s m d theta."""
    primitive = m.integral()
    return primitive - primitive(fmpq(1))


def _mean_of_cosines(p: fmpq_poly) -> fmpq:
    """(1/pi) int_0^pi p(cos theta) d theta: the mean of cos^(2k) is binomial(2k, k)/4^k."""
    return sum((p[2 * k] * fmpq(comb(2 * k, k), 4**k) for k in range((p.length() + 1) // 2)), start=fmpq(0))


def odd_half_swing(alphas: tuple[int, ...], order: int) -> HalfSwing:
    """Odd exponents: from the rational flow, L = sum_j pi^(j+1)/(j+1)! D^j U and T likewise from W."""
    flow = fourier_flow(alphas, order)
    return _assemble(flow.grading, *(_integrate_flow(flow.U, flow.grading, f) for f in (flow.U, flow.W)))


def _integrate_flow(U: Series, grading: Grading, f: Series) -> Series:
    """int_0^pi f(delta(psi)) d psi along d delta_i/d psi = (alpha_i - 1) delta_i U."""
    total, term, factor = Series({}, U.variables, U.order), f, PI
    for j in range(U.order + 1):
        total = total + term * factor
        term, factor = U * grading.weighted(term), factor * PI / (j + 2)
    return total


def _assemble(grading: Grading, L: Series, T: Series) -> HalfSwing:
    return HalfSwing(grading, L, grading.strengths(L), T)


def _grading(alphas: tuple[int, ...]) -> Grading:
    return Grading.of(fmpq(a) for a in alphas)


def exact_quarter_swing(alphas: tuple[int, ...], order: int, *, moments: bool = False) -> QuarterSwing:
    """R, T_q (and K_0, ..., K_order if ``moments``) for any integer exponents, in polynomials of theta, s and c.

    >>> exact_quarter_swing((2,), 2).T_q
    pi/2 + 1/3*d + (-2/9 + pi/12)*d^2 + O(3)
    """
    _require_integers(alphas)
    grading, powers = _grading(alphas), tuple(sine_power(a) for a in alphas)
    orbit = Orbit.solve(grading.weights, order, powers, COSINE, lambda m: -(SINE * m).integral())
    R = orbit.series(orbit.log_r, ThetaTrig.at_quarter)
    T_q = orbit.series(orbit.m, lambda m: (COSINE * m).integral().at_quarter()) + PI / 2
    return QuarterSwing(grading, R, T_q, _waveform_moments(orbit) if moments else ())


def _waveform_moments(orbit: Orbit) -> tuple[tuple[Series, Series], ...]:
    """K_k = int_0^(pi/2) tau^k (cos tau - i sin tau) r c (d tau/d theta) d theta through order N - k, k = 0, ..., N."""
    order = len(orbit.m) - 1
    rate = orbit.series(orbit.m, lambda m: COSINE * m)
    lag = rate.map(ThetaTrig.integral)  # tau - theta
    x = orbit.series(orbit.log_r, lambda f: f).exp().map(lambda f: COSINE * f)
    cosine, sine = lag.cos_sin()
    common = x * (rate + ONE)
    real = common * (cosine * COSINE - sine * SINE)
    imaginary = -(common * (sine * COSINE + cosine * SINE))
    moments = []
    for k in range(order + 1):
        pair = tuple(f.map(lambda g: (ONE * g).integral().at_quarter()) for f in (real, imaginary))
        moments.append((pair[0], pair[1]))
        if k < order:
            tau = lag.truncate(order - k - 1) + THETA
            real, imaginary = real * tau, imaginary * tau
    return tuple(moments)


def _require_integers(alphas: tuple[int, ...]) -> None:
    for alpha in alphas:
        if alpha != int(alpha) or alpha < 0:
            raise InputError("alpha", f"{alpha} has no exact half-swing", "integers >= 0; certified: any real")
