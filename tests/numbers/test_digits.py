"""What digits say: the ends hold every number that rounds to them, and half of them would not."""

from fractions import Fraction

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from asymptotics.errors import InputError
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import rational_decimal
from asymptotics.numbers.digits import ball_of, ends, interval_of, outward, spread
from asymptotics.numbers.value import Coefficient, number_of
from asymptotics.turning.result import TurningPoint, proved_point


@given(st.fractions(), st.integers(1, 25))
def test_the_ends_hold_what_rounds_to_the_digits(q, digits):
    text = rational_decimal(q, digits)
    low, high = ends(text)
    assert low <= q <= high
    assert outward(low, -1) <= low and outward(high, 1) >= high
    ball = ball_of(text)
    with ctx.workprec(200 + q.numerator.bit_length() + q.denominator.bit_length()):  # the ball of q is next to none
        assert ball.contains(arb(q.numerator) / q.denominator) or not ball.is_finite()
    if q:  # nothing is wider than it must be
        assert high - low <= 10 * abs(q) / Fraction(10) ** (digits - 1)
        outer = high if q > 0 else low  # inward of a power of ten the digits are closer
        assert rational_decimal(outer - (outer - q) / 1000, digits) in (text, rational_decimal(outer, digits))


def test_the_ball_of_digits_reaches_its_ends():
    assert ball_of("0.5").contains(arb("0.45") * (1 + arb(10) ** -12)) and not ball_of("0.5").contains(arb("0.44"))
    assert ball_of("-2.5e3").contains(arb(-2549)) and not ball_of("-2.5e3").contains(arb(-2551))
    assert ball_of("0") == 0
    interval = interval_of("0.3333")
    assert interval.a <= mpmath.mpf("0.33326") and interval.b >= mpmath.mpf("0.33334")


def test_what_is_not_certified_has_no_interval():
    with pytest.raises(InputError, match="not certified"):
        TurningPoint(1, "0.33", None).number("x")
    with pytest.raises(InputError, match="no number"):
        proved_point(1, Fraction(1, 3), None, 4).number("tau")
    assert number_of(proved_point(1, Fraction(1, 3), None, 4), "x") == Coefficient("0.3333", None)
    assert spread("x", ["0.3"], certified=False) == {"x": [0.3], "x_low": [None], "x_high": [None], "x_digits": ["0.3"]}


def test_balls_of_decimals_hold_everything_that_rounds_to_them():
    assert ball_of("0.5").contains(ball_of("0.45")) is False
    assert ball_of("1.50").overlaps(ball_of("1.505"))
    assert not ball_of("1.50").overlaps(ball_of("1.5151"))
    assert ball_of("0").is_exact()
    assert float(ball_of("1.0e-5").rad()) == pytest.approx(5e-7, rel=1e-3)


@pytest.mark.parametrize(
    ("text", "middle", "half"),
    [("0.25", fmpq(1, 4), fmpq(1, 200)), ("-1.5e3", fmpq(-1500), fmpq(50)), ("7", 7, fmpq(1, 2))],
)
def test_a_decimal_is_every_number_that_rounds_to_it(text, middle, half):
    """Both ends of the interval are in the ball, and a number a thousandth farther out is not."""
    ball = ball_of(text)
    assert all(ball.contains(arb(middle + side * half)) for side in (-1, 0, 1))
    assert not any(ball.contains(arb(middle + side * half * fmpq(1001, 1000))) for side in (-1, 1))
    assert ball_of("0").is_zero()
