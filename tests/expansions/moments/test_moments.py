from fractions import Fraction
from math import comb

import mpmath
import pytest
import sympy
from flint import arb, fmpq

from asymptotics.errors import InputError
from asymptotics.expansions.moments import certified, symbolic
from asymptotics.expansions.moments.exact import integer_moment, moment
from asymptotics.numbers.bridge import closed_form_ball
from asymptotics.numbers.exact import parse_real
from asymptotics.numbers.rationals import to_fmpq
from tests.each import each


@pytest.mark.parametrize("p", range(9))
def test_integer_moments_by_two_routes(p):
    q, over_pi = integer_moment(p)
    if p % 2 == 0:  # mean of sin^(2k) is binomial(2k, k)/4^k
        assert (q, over_pi) == (Fraction(comb(p, p // 2), 2**p), False)
    ball = certified.moment(arb(p))
    assert ball.overlaps(closed_form_ball(symbolic.moment(p)))
    assert not ball.overlaps(closed_form_ball(symbolic.moment(p + 1)))


@each(
    "p", [Fraction(n, d) for d in (1, 2, 3, 7, 30) for n in (-1, 1, 5, 12, 61) if Fraction(n, d) > -1] + [Fraction(999)]
)
def test_a_moment_is_written_as_sympy_writes_it(p):
    """Character by character; of the next exponent it writes something else."""
    text = str(symbolic.moment(sympy.Rational(p.numerator, p.denominator)))
    assert str(moment(to_fmpq(p))) == text != str(moment(to_fmpq(p + 1)))


@pytest.mark.parametrize("p", ["1/2", "5/2", "7/3", "-1/2", "sqrt(2)"])
def test_moment_ball_against_quadrature(p):
    ball = certified.moment(parse_real(p, "p").ball())
    exponent = float(parse_real(p, "p").ball().mid())
    value = mpmath.quad(lambda t: mpmath.sin(t) ** exponent, [0, mpmath.pi / 4, mpmath.pi / 2]) * 2 / mpmath.pi
    assert abs(float(value) - float(ball.mid())) < 1e-6


@pytest.mark.parametrize("p", [-1, -3, sympy.Rational(-3, 2), sympy.I])
def test_divergent_moments_are_refused(p):
    with pytest.raises(InputError):
        symbolic.moment(p)


def test_ball_moment_says_nothing_of_what_it_cannot_decide():
    with pytest.raises(InputError):
        certified.moment(arb(-2))
    assert not certified.moment(arb(-1, 0.1)).is_finite()


@pytest.mark.parametrize(
    ("alpha", "verdict"),
    [("0", "overestimates"), ("0.99", "overestimates"), ("1", "exact"), ("1.01", "underestimates")],
)
def test_lelas_replacement_lies_on_the_stated_side(alpha, verdict):
    number = parse_real(alpha, "alpha")
    ratio = certified.squaring_ratio(number.ball())
    sign = {"overestimates": ratio > 1, "exact": ratio.overlaps(arb(1)), "underestimates": ratio < 1}
    assert sign[verdict]


def test_lelas_ratio_closed_form_at_coulomb_and_quadratic():
    # alpha = 0: 2^(-1/2) pi/2; alpha = 2: 2^(-3/2) 3 pi/4
    assert symbolic.squaring_ratio(sympy.Integer(0)) == sympy.sqrt(2) * sympy.pi / 4
    assert symbolic.squaring_ratio(sympy.Integer(2)) == 3 * sympy.sqrt(2) * sympy.pi / 16
    assert certified.squaring_ratio(arb(fmpq(1, 2))) > 1
