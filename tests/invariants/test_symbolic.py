from fractions import Fraction
from itertools import islice

import pytest
import sympy
from flint import arb, arb_series, ctx, fmpq

from asymptotics.invariants.exact import coefficient
from asymptotics.invariants.symbolic import Z, generating_function, generating_functions
from asymptotics.numbers.rationals import to_fmpq
from asymptotics.turning.quadratic_series import half_period_series


@pytest.mark.parametrize("i", range(9))
def test_the_closed_form_generates_the_coefficients(i: int):
    series = sympy.series(generating_function(i).in_z(), Z, 0, i + 8).removeO()
    for n in range(i + 8):
        c = coefficient(n, i) if n else Fraction(0)
        assert series.coeff(Z, n) == sympy.Rational(c.numerator, c.denominator)


@pytest.mark.parametrize("i", [10, 24, 40])
def test_the_angle_form_generates_the_coefficients_for_large_i(i: int):
    # An independent expansion: theta P(c) + sin(theta) R(c) as a power series of balls in theta, against
    # sin^i(theta) sum_n C_i^n tan^n(theta), whose first nonzero terms are n = i+1, i+3, i+5.
    order = 2 * i + 8
    cap, ctx.cap = ctx.cap, order
    try:
        with ctx.workprec(600):
            theta = arb_series([0, 1], prec=order)
            s, c = theta.sin(), theta.cos()
            z = s / c
            g = generating_function(i)
            ours = theta * _horner(g.P, c) + s * _horner(g.R, c)
            sums = [arb(to_fmpq(coefficient(n, i))) * z**n for n in (i + 1, i + 3, i + 5)]
            theirs = s**i * (sums[0] + sums[1] + sums[2])
            for k in range(order - 1):
                assert ours[k].overlaps(theirs[k])
                assert ours[k].rad() < arb(10) ** -20
    finally:
        ctx.cap = cap


def _horner(p, x):
    total = arb_series([0], prec=x.prec)
    for a in reversed(list(p)):
        total = total * x + arb_series([arb(a)], prec=x.prec)
    return total


def test_the_limits_are_the_series_of_the_transit_time():
    # H_i(pi)/pi against the level integral of turning_points.quadratic_series: no step in common.
    series = half_period_series(40)
    for g in islice(generating_functions(), 41):
        assert g.P(fmpq(-1)) == series[g.i] * 2**g.i


def test_parity_of_the_polynomials():
    for g in islice(generating_functions(), 30):
        assert not any(c for j, c in enumerate(g.P) if (j - g.i) % 2)
        assert not any(c for j, c in enumerate(g.R) if (j - g.i) % 2 == 0)


def test_the_scaled_form_is_finite_at_pi():
    for g in islice(generating_functions(), 8):
        value = g.scaled_at(arb.pi())
        assert value.overlaps(arb.pi() * arb(g.P(fmpq(-1))))


def test_a_result_shows_itself():
    g = generating_function(3)
    assert g.to_dict()["limit"] == "-2*pi/9"
    assert g._repr_latex_().startswith("$G_{3}(z) = ")
