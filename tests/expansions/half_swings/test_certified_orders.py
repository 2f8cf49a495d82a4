"""The orders of the quarter swing as power series: each coefficient below its bound, which is attained."""

from fractions import Fraction

import mpmath
import pytest
from flint import arb, arb_poly, ctx, fmpq

from asymptotics.expansions.half_swings.certified_orders import (
    bound_ring,
    indices,
    integrate_series,
    order_series,
    power_series_ring,
    sine_ratio_power,
)
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.numbers.exact import ExactReal, parse_real


def real(text):
    return parse_real(text, "alpha")


@pytest.mark.parametrize("exponent", ["1/2", "3/2", "3"])
def test_the_bound_of_an_integral_is_attained_and_the_second_order_uses_it(exponent):
    """I_n t = t/(n·alpha + 2), the largest of all t^j; y_2 by hand: p_1 = |alpha - 1| g y_1/(alpha + 2)."""
    a, pi = real(exponent).ball(), arb.pi()
    ring = bound_ring(Forces.losses([real(exponent)]), 4)
    for n in (0, 1, 2):
        bound = ring.integrate(arb(1), n * a)
        first, *more = (abs(integrate_series(arb_poly([0] * j + [arb(1)]), n * a)(arb(1))) for j in (1, 2, 5))
        assert first * (1 - arb(1e-12)) <= bound <= first * (1 + arb(1e-12)) and all(m < bound for m in more)
    y = (pi.sinh() / pi) ** a
    second = y * abs(a - 1) * pi * pi.sinh() * y / (a + 2) + pi.cosh() * y * y
    found = order_series(ring, indices(1, 2))[(2,)]
    assert second * (1 - arb(1e-12)) < found < second * (1 + arb(1e-12))


@pytest.mark.parametrize("alphas", [[fmpq(1, 2)], [fmpq(2)], [fmpq(0), fmpq(7, 3)]])
def test_every_coefficient_obeys_its_bound(alphas: list[fmpq]) -> None:
    """|y_n,j| <= |y_n| ϱ^(−j) for each ϱ, and the bound is no wild overestimate at j = 0 and ϱ = 1."""
    with ctx.workprec(200):
        forces = Forces.losses([ExactReal(Fraction(int(a.p), int(a.q))) for a in alphas])
        orders = indices(len(alphas), 4)
        y = order_series(power_series_ring(forces, 40), orders)
        for radius in (1, 2, 3, 4):
            bound = order_series(bound_ring(forces, radius), orders)
            for n, f in y.items():
                assert all(
                    abs(c) * arb(radius) ** j <= bound[n] * (1 + arb(2) ** -150) for j, c in enumerate(f.coeffs())
                )
                assert radius > 1 or bound[n] < 10 ** (2 * sum(n))


@pytest.mark.parametrize("alpha", ["1/2", "1", "7/3"])
@pytest.mark.parametrize("terms", [1, 2, 5])
def test_a_power_of_the_sine_has_the_coefficients_of_its_logarithm(alpha, terms):
    """(sin theta/theta)^alpha in t = (2 theta/pi)^2, by mpmath: as many as were asked for, and each of them."""
    a, theta = mpmath.mpf(Fraction(alpha).numerator) / Fraction(alpha).denominator, mpmath.pi / 2
    with mpmath.workdps(40):
        wanted = mpmath.taylor(lambda t: mpmath.sinc(theta * mpmath.sqrt(t)) ** a if t else mpmath.mpf(1), 0, 6)
    found = sine_ratio_power(real(alpha).ball(), terms).coeffs()
    assert len(found) == terms
    assert [float(c.mid()) for c in found] == pytest.approx([float(mpmath.re(c)) for c in wanted[:terms]], rel=1e-8)
