"""What digits say: the ends hold every number that rounds to them, and half of them would not."""

from fractions import Fraction

import mpmath
import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st

from asymptotics.errors import InputError
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
    assert ball_of(text).contains(arb(q.numerator) / q.denominator) or not ball_of(text).is_finite()
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
