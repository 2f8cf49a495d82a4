from fractions import Fraction

import mpmath
import pytest
import sympy
from flint import arb, ctx, fmpq

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.exact import exact_half_swing
from asymptotics.expansions.half_swings.symbolic import (
    I_4,
    RADIUS,
    _integrate,
    _product,
    _sinc_power,
    alpha,
    cauchy_bounds,
    field_half_swing,
    nested_integral,
    nested_integral_definition,
    nested_integral_exact,
    symbolic_half_swing,
)
from asymptotics.expansions.moments.certified import moment


@pytest.mark.parametrize("n", range(5))
def test_symbolic_half_swing_is_the_exact_one_at_integers(n):
    symbolic, exact = symbolic_half_swing(), exact_half_swing((n,), 4)
    value = nested_integral_exact(n).to_sympy()
    for ours, theirs in ((symbolic.L, exact.L), (symbolic.T, exact.T)):
        for k in range(5):
            at_n = sympy.sympify(ours[k]).subs(I_4(alpha), value).subs(alpha, n)
            other = theirs[k] if isinstance(theirs[k], int) else theirs[k].to_sympy()
            assert sympy.simplify(at_n - other) == 0


@pytest.mark.parametrize("n", range(7))
def test_nested_integral_ball_meets_the_exact_value(n):
    with ctx.workprec(200):
        ball = nested_integral(arb(n))
        assert ball.overlaps(nested_integral_exact(n).ball()) and ball.rad() < arb(10) ** -40
        assert not ball.overlaps(nested_integral_exact(n).ball() + arb(10) ** -30)


@pytest.mark.parametrize("p", ["0", "1/2", "1"])
def test_the_bounds_of_cauchy_on_the_circle_hold_and_are_near(p):
    """On theta = 3 i all terms have one sign: sum |c_j| 9^j is attained; a third (a sixth) of its bound would fail."""
    with ctx.workprec(100):
        a = arb(fmpq(*Fraction(p).as_integer_ratio()))
        sigma = [c / (a + 2 + 2 * j) for j, c in enumerate(_sinc_power(a + 1, 60))]
        linear = _product(_sinc_power(2 * a, 60), sigma)
        for terms, bound, near in zip((linear, _product(linear, sigma)), cauchy_bounds(a), (3, 6), strict=True):
            attained = sum((abs(c) * 9**j for j, c in enumerate(terms)), arb(0))
            assert attained < bound < near * attained


@pytest.mark.parametrize("p", ["1/3", "7/5"])
def test_nested_integral_against_quadrature(p):
    q = Fraction(p)
    a = mpmath.mpf(q.numerator) / q.denominator

    def power(e):
        return lambda t: mpmath.sin(t) ** e

    M = mpmath.quad(power(a + 1), [0, mpmath.pi]) / mpmath.pi

    def integrand(t):
        inner = mpmath.quad(power(a + 1), [mpmath.pi / 2, t])
        return mpmath.sin(t) ** (2 * a) * (inner**2 - (mpmath.pi * M) ** 2 / 12)

    with mpmath.workdps(12):
        value = mpmath.quad(integrand, [0, mpmath.pi / 2], maxdegree=5) * 2 / mpmath.pi
    assert abs(float(value) - float(nested_integral(arb(fmpq(q.numerator, q.denominator))).mid())) < 1e-7


def test_closed_form_at_one_half():
    # int sin = -cos, twice by parts: J = pi^2 M^2 M_1/4 - (8/(5 pi)) int_0^(pi/2) sin^4 = pi^2 M^2 M_1/4 - 3/10
    with ctx.workprec(200):
        M, M_1 = moment(arb(fmpq(3, 2))), moment(arb(1))
        closed = (arb.pi() * M) ** 2 * M_1 / 6 - arb(fmpq(3, 10))
        assert nested_integral(arb(fmpq(1, 2))).overlaps(closed)


def test_one_twelfth_at_odd_integers_and_one_fourth_at_half_integers():
    """What the irreducibility proof rests on: rational at odd n; J - pi^2 M^2 M_(2 alpha)/4 rational at n + 1/2."""
    assert all(nested_integral_exact(n).is_rational for n in (1, 3, 5, 7))
    with ctx.workprec(400):
        a = arb(fmpq(3, 2))
        rest = nested_integral(a) - (arb.pi() * moment(a + 1)) ** 2 * moment(2 * a) / 6
        assert rest.overlaps(arb(fmpq(-375, 2464))) and rest.rad() < arb(10) ** -80


def test_definition_and_refusal():
    assert nested_integral_definition().has(sympy.Integral)
    with pytest.raises(InputError):
        nested_integral(arb(-1))
    with pytest.raises(InputError):
        nested_integral_exact(-1)


@pytest.mark.parametrize("terms", [1, 2, 5])
def test_the_tail_of_an_integral_is_needed(terms):
    """y_j = R^(-2 j) attains Cauchy's bound with B = 1; for a large power of theta the bound is nearly attained."""
    y, e = [arb(RADIUS) ** (-2 * j) for j in range(400)], arb(60)
    with ctx.workprec(200):
        value, found = _integrate(y, e, arb(1)), _integrate(y[:terms], e, arb(1))
        assert found.contains(value.mid())
        assert not (found.mid() + arb(0, found.rad() / 2)).overlaps(value)
        assert _integrate(y[:terms], e, arb(2)).rad() > found.rad() * arb("1.99")


@pytest.mark.parametrize("n", [1])
def test_the_integral_that_defines_i_4_is_i_4(n):
    shown = nested_integral_definition().subs(alpha, n).doit()
    with mpmath.workdps(20):
        assert (
            abs(mpmath.mpmathify(shown.evalf(20)) - mpmath.mpf(nested_integral_exact(n).ball().str(20, radius=False)))
            < 1e-15
        )


def test_the_symbolic_half_swing_is_what_it_was_computed_to_be():
    cached, anew = field_half_swing(), field_half_swing.__wrapped__()
    assert [cached.T[k] for k in range(5)] == [anew.T[k] for k in range(5)]
    assert [cached.L[k] for k in range(5)] == [anew.L[k] for k in range(5)]
