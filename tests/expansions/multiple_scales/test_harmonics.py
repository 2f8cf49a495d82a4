"""Fourier coefficients against quadrature, and the two sums against their telescoping certificates and summation."""

import mpmath
import pytest
import sympy
from sympy import Integer, Rational, Symbol, cancel, gammasimp

from asymptotics.expansions.multiple_scales.harmonics import harmonic, velocity_sum
from tests.second_route.harmonic_sums import (
    harmonic_closed_form,
    turning_certificate,
    turning_sum,
    velocity_certificate,
)

alpha, beta = Symbol("alpha", nonnegative=True), Symbol("beta", nonnegative=True)
n = Symbol("n", positive=True)
EXPONENTS = [Integer(0), Rational(1, 2), Integer(1), Rational(3, 2), Integer(2), Rational(5, 2), Integer(3)]


def ratio(x):
    return (n - x) / (n + x + 2)


@pytest.mark.parametrize("x", EXPONENTS)
def test_against_quadrature(x):
    for m in (1, 3, 5):
        integral = mpmath.quad(lambda t, m=m: mpmath.sin(t) ** float(x) * mpmath.sin(m * t), [0, 1, 2, mpmath.pi])
        assert abs(2 / mpmath.pi * integral - float(harmonic(x, m))) < 1e-8
        assert abs(harmonic_closed_form(x, Integer(m)) - harmonic(x, m)).evalf(30) < 1e-20


def test_recurrence_and_closed_form_are_one_for_every_exponent():
    for m in (1, 3, 5, 7):
        assert gammasimp(harmonic_closed_form(alpha, Integer(m)) / harmonic(alpha, m)) == 1


def test_certificates_telescope():
    weight = (alpha + beta + 1) / ((alpha + 1) * (beta + 1))
    F, G = velocity_certificate(alpha, beta, n), turning_certificate(alpha, n)
    assert cancel(ratio(alpha) * ratio(beta) * F.subs(n, n + 2) - F - 1 / (n**2 - 1) - weight) == 0
    assert cancel(ratio(alpha) * G.subs(n, n + 2) - G - n / (n**2 - 1)) == 0
    # near miss: without the Parseval term nothing telescopes with this F
    assert cancel(ratio(alpha) * ratio(beta) * F.subs(n, n + 2) - F - 1 / (n**2 - 1)) != 0


@pytest.mark.parametrize("x", [Integer(1), Integer(3), Integer(5), Integer(7)])
def test_finite_sums_for_odd_exponents(x):
    odd = range(3, int(x) + 1, 2)
    assert velocity_sum(x, x) == sum(m**2 * harmonic(x, m) ** 2 / (m**2 - 1) for m in odd)
    assert turning_sum(x) == sum(m * harmonic(x, m) / (m**2 - 1) for m in odd)


@pytest.mark.parametrize(("x", "y"), [(0, 0), (0.5, 0.5), (1.5, 1.5), (2, 2), (2.5, 2.5), (0, 2), (0.5, 1.5)])
def test_infinite_sums_heuristically(x, y):
    """The series by direct summation with Richardson's extrapolation of the tail (mpmath): no telescoping used."""
    exact_x, exact_y = (Rational(mpmath.nstr(v)) for v in (x, y))
    limit = 20000

    def tail_corrected(summand, decay):
        total = mpmath.fsum(summand(m) for m in range(3, limit, 2))
        half = mpmath.fsum(summand(m) for m in range(3, limit // 2, 2))
        return total + (total - half) / (2**decay - 1)

    b, c = fourier(x, limit), fourier(y, limit)
    found = tail_corrected(lambda m: m * m * b[m] * c[m] / (m * m - 1), x + y + 1)
    assert abs(found - velocity_sum(exact_x, exact_y).evalf(20)) < 1e-7


def fourier(x, limit):
    """b_n in doubles by the ratio of neighbours, from b_1 by quadrature."""
    values = {1: float(2 / mpmath.pi * mpmath.quad(lambda t: mpmath.sin(t) ** (x + 1), [0, mpmath.pi / 2]) * 2)}
    for m in range(1, limit, 2):
        values[m + 2] = values[m] * (m - x) / (m + x + 2)
    return values


def test_square_wave():
    # alpha = 0: b_n = 4/(pi n), and sum 16/pi^2/(n^2-1) over n = 3, 5, ... is 4/pi^2
    assert harmonic(Integer(0), 7) == 4 / (7 * sympy.pi)
    assert velocity_sum(Integer(0), Integer(0)) == 4 / sympy.pi**2
