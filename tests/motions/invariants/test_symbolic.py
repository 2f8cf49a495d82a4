from fractions import Fraction
from itertools import islice

import pytest
import sympy
from flint import arb, arb_series, ctx, fmpq, fmpq_poly

from asymptotics.motions.invariants.exact import coefficient
from asymptotics.motions.invariants.symbolic import THETA, Z, _solve, generating_function, generating_functions
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
    # H_i(pi)/pi against the level integral of turning.quadratic_series: no step in common.
    series = half_period_series(40)
    for g in islice(generating_functions(), 41):
        assert g.P(fmpq(-1)) == series[g.i] * 2**g.i


def test_parity_of_the_polynomials():
    for g in islice(generating_functions(), 30):
        assert not any(c for j, c in enumerate(g.P) if (j - g.i) % 2)
        assert not any(c for j, c in enumerate(g.R) if (j - g.i) % 2 == 0)


def test_the_equation_for_R_is_solved_whatever_the_parity():
    c, R = fmpq_poly([0, 1]), fmpq_poly([2, -3, 0, fmpq(5, 7), 1])
    for solution, constant in ((R, fmpq(3)), (fmpq_poly([]), fmpq(4)), (fmpq_poly([1]), fmpq(0))):
        right = constant + c * solution - (1 - c * c) * solution.derivative()
        assert _solve(right) == (solution, constant)


def test_the_scaled_form_is_finite_at_pi():
    for g in islice(generating_functions(), 8):
        value = g.scaled_at(arb.pi())
        assert value.overlaps(arb.pi() * arb(g.P(fmpq(-1))))


@pytest.mark.parametrize("i", range(6))
def test_every_printed_form_is_the_sum_of_its_series(i: int):
    # tan(3/10) < 0.31 and |C_i^n| < 2^i: the terms from n = i + 60 on are below 10^-25.
    theta = sympy.Rational(3, 10)
    z = sympy.tan(theta).evalf(40)
    total = sum(sympy.Rational(*coefficient(n, i).as_integer_ratio()) * z**n for n in range(max(1, i), i + 60))
    g = generating_function(i)
    read = {name: sympy.sympify(g.to_dict()[name]) for name in ("angle_expression", "expression")}
    assert abs(read["angle_expression"].subs(THETA, theta).evalf(40) - total) < 1e-25
    assert abs(read["expression"].subs(Z, z).evalf(40) - total) < 1e-25
    assert read["angle_expression"].free_symbols == {THETA} and read["expression"].free_symbols == {Z}
    if i > 1:  # over one power of the sine; expanded only where no sine is left to divide by
        assert sympy.fraction(g.in_angle())[1] == sympy.sin(THETA) ** i
    else:
        assert g.in_angle() == (THETA, sympy.expand(sympy.Rational(2, 3) * (1 - sympy.cos(THETA) ** 2)))[i]
    scaled = g.scaled_at(arb(fmpq(3, 10)))
    assert scaled.rad() < 1e-14 and scaled.overlaps(arb(str((total * sympy.sin(theta) ** i).evalf(30)) + " +/- 1e-25"))


@pytest.mark.parametrize("theta", [0.4, 1.5, 2.0, 3.0])
def test_beyond_a_quarter_turn_the_forms_are_the_integral(theta: float):
    # H_1 = 2 s^3/3, so the equation for H_2 is H_2' = 2 s^2 c (2 s^2 c) - 2 s c^2 (2 s^3/3) = (8/3) s^4 c^2,
    # and int s^4 c^2 = theta/16 - sin(4 theta)/64 - sin^3(2 theta)/48.
    x = arb(theta)
    H_2 = (x / 16 - (4 * x).sin() / 64 - (2 * x).sin() ** 3 / 48) * 8 / 3
    g = generating_function(2)
    assert g.scaled_at(x).overlaps(H_2) and H_2.rad() < 1e-14 and g.scaled_at(x).rad() < 1e-13
    assert abs(g.in_angle().subs(THETA, theta).evalf() - float((H_2 / x.sin() ** 2).mid())) < 1e-11


def test_a_result_shows_itself():
    g = generating_function(3)
    assert g.to_dict()["limit"] == "-2*pi/9"
    assert g._repr_latex_().startswith("$G_{3}(z) = ")
