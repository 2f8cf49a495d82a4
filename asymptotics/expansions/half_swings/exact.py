"""The half-swing at integer exponents: every coefficient an exact number of Q[pi].

Three algebras, the smallest that is closed (losses |x|^m v|v|^(alpha-1), springs x|x|^(p-1) |v|^q):

* all powers of v even, m even, p odd: ln r is a polynomial in c, so L and F are rational and T is in pi Q;
* alpha odd, q even, m even, p odd: the vector field is smooth and pi-periodic in theta, so the flow (U, W) is rational
  (``fourier_flow``) and L = (exp(pi D) - 1)/D U, T = (exp(pi D) - 1)/D W with D = V d/d delta are in Q[pi];
* any integers, also mixed, also |x| and x|x|: polynomials in theta, s, c on the first quarter (``theta_algebra``), then
  the reversal identity.  This is also the independent route for the other two, and the only one that gives the
  quarter-swing and its waveform moments.

Terms in the place of forces are written out as far as needed; numbers are the exponents of plain losses.

>>> half = exact_half_swing((2,), 3)
>>> half.L
-4/3*d + 8/9*d^2 + -416/405*d^3 + O(4)
>>> half.T
pi + pi/6*d^2 + -2*pi/9*d^3 + O(4)
>>> exact_half_swing((3,), 2).L, exact_half_swing((0,), 2).T
(-3*pi/8*d + 9*pi**2/64*d^2 + O(3), pi + O(3))
>>> pendulum = Term(1, 0, 3, "position", "pendulum")
>>> exact_half_swing([pendulum], 3).T                           # half a period 2 K(k^2), in powers of A^2
pi + pi/16*d + 11*pi/3072*d^2 + 173*pi/737280*d^3 + O(4)
"""

from math import comb
from typing import Any

from flint import fmpq, fmpq_poly

from asymptotics.expansions.half_swings.forces import Forces, Given, Member
from asymptotics.expansions.half_swings.formal_solution import FormalSolution
from asymptotics.expansions.half_swings.fourier_flow import fourier_flow
from asymptotics.expansions.half_swings.grading import Grading
from asymptotics.expansions.half_swings.pi_ring import PI, PiNumber
from asymptotics.expansions.half_swings.quarter import HalfSwing, QuarterSwing, half_swing
from asymptotics.expansions.half_swings.theta_algebra import COSINE, ONE, SINE, THETA, ThetaTrig, power_product
from asymptotics.series import Key, Series
from asymptotics.terms import Term as Term  # for the examples


def exact_half_swing(given: Given, order: int) -> HalfSwing:
    """L, F, T through total degree ``order`` for integer exponents; InputError for anything else."""
    forces = Forces.read(given, order)
    # The smallest algebra that is closed comes first: polynomials of one variable cost least, those of theta most.
    if forces.is_even:
        return even_half_swing(forces, order)
    if forces.is_smooth:
        return odd_half_swing(forces, order)
    return half_swing(exact_quarter_swing(forces, order))


def even_half_swing(given: Given, order: int) -> HalfSwing:
    """Polynomials in c: ln r is integrated from c = 1 to -1; no reversal identity is used.

    >>> even_half_swing((0, 2), 1).L
    -4/3*d1 + -2*d0 + O(2)
    """
    forces = Forces.read(given, order)
    c, sine_squared = fmpq_poly([0, 1]), fmpq_poly([1, 0, -1])
    shapes = [
        (m.key, m.ratio * m.side * sine_squared ** (m.integer_velocity // 2) * c**m.position)
        for m in forces.through(order)
    ]
    orbit = FormalSolution.solve(forces.exact_grading(), order, shapes, c, _from_one)
    L = orbit.series(orbit.log_r, lambda p: PiNumber.rational(p(fmpq(-1))))
    # d tau = (1 + c m) d theta: pi for the 1, and the mean of c m.
    T = orbit.series(orbit.m, lambda m: PI * _mean_of_cosines(c * m)) + PI
    return _assemble(forces.exact_grading(), L, T)


def _from_one(m: fmpq_poly) -> fmpq_poly:
    """int_1^c m dc, which is -int_0^theta s m d theta."""
    primitive = m.integral()
    return primitive - primitive(fmpq(1))


def _mean_of_cosines(p: fmpq_poly) -> fmpq:
    """(1/pi) int_0^pi p(cos theta) d theta: the mean of cos^(2k) is binomial(2k, k)/4^k."""
    return sum((p[2 * k] * fmpq(comb(2 * k, k), 4**k) for k in range((p.length() + 1) // 2)), start=fmpq(0))


def odd_half_swing(given: Given, order: int) -> HalfSwing:
    """Smooth forces: from the rational flow, L = sum_j pi^(j+1)/(j+1)! D^j U and T likewise from W."""
    flow = fourier_flow(given, order)
    return _assemble(flow.grading, *(_integrate_flow(flow.U, flow.grading, f) for f in (flow.U, flow.W)))


def _integrate_flow(U: Series, grading: Grading, f: Series) -> Series:
    """int_0^pi f(delta(psi)) d psi along d delta_i/d psi = (alpha_i - 1) delta_i U."""
    total, term, factor = Series({}, U.variables, U.order), f, PI
    for j in range(U.order + 1):
        total = total + term * factor
        # d/d psi raises the degree, as U has no term of degree 0: the Taylor series of the flow ends by itself.
        term, factor = U * grading.weighted(term), factor * PI / (j + 2)
    return total


def _assemble(grading: Grading, L: Series, T: Series) -> HalfSwing:
    return HalfSwing(grading, L, grading.strengths(L), T)


def exact_quarter_swing(given: Given, order: int, *, moments: bool = False) -> QuarterSwing:
    """R, T_q (and K_0, ..., K_order if ``moments``) for any integer exponents, in polynomials of theta, s and c.

    >>> exact_quarter_swing((2,), 2).T_q
    pi/2 + 1/3*d + (-2/9 + pi/12)*d^2 + O(3)
    """
    forces = Forces.read(given, order)
    grading, shapes = forces.exact_grading(), [_on_the_quarter(m) for m in forces.through(order)]
    orbit = FormalSolution.solve(grading, order, shapes, COSINE, lambda m: -(SINE * m).integral())
    R = orbit.series(orbit.log_r, ThetaTrig.at_quarter)
    T_q = orbit.series(orbit.m, lambda m: (COSINE * m).integral().at_quarter()) + PI / 2
    return QuarterSwing(grading, R, T_q, _waveform_moments(orbit) if moments else ())


def _on_the_quarter(member: Member) -> tuple[Key, Any]:
    return member.key, power_product(member.integer_velocity, member.position) * (member.ratio * member.side)


def _waveform_moments(orbit: FormalSolution) -> tuple[tuple[Series, Series], ...]:
    """K_k = int_0^(pi/2) tau^k (cos tau - i sin tau) r c (d tau/d theta) d theta through order N - k, k = 0, ..., N."""
    order = len(orbit.m) - 1
    rate = orbit.series(orbit.m, lambda m: COSINE * m)
    lag = rate.map(ThetaTrig.integral)  # tau - theta
    x = orbit.series(orbit.log_r, lambda f: f).exp().map(lambda f: COSINE * f)
    # e^(-i tau) = e^(-i theta) e^(-i lag): only the lag, a series
    # without constant term, is put into a cosine and a sine.
    cosine, sine = lag.cos_sin()
    common = x * (rate + ONE)
    real = common * (cosine * COSINE - sine * SINE)
    imaginary = -(common * (sine * COSINE + cosine * SINE))
    moments = []
    for k in range(order + 1):
        pair = tuple(f.map(lambda g: (ONE * g).integral().at_quarter()) for f in (real, imaginary))
        moments.append((pair[0], pair[1]))
        if k < order:
            # The next moment is wanted through one order less.
            tau = lag.truncate(order - k - 1) + THETA
            real, imaginary = real * tau, imaginary * tau
    return tuple(moments)
