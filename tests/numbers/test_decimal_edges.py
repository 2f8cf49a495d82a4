"""Balls against exact end points, and the edges of the notation: what a shift by one in the code would break."""

from decimal import ROUND_HALF_EVEN, Context, Decimal
from fractions import Fraction

import pytest
from flint import arb
from hypothesis import example, given
from hypothesis import strategies as st

from asymptotics.numbers.decimals import bits_for, certified_decimal, decimal_of_ball, rational_decimal
from asymptotics.numbers.rationals import bounds


def rounded(q: Fraction, digits: int) -> Decimal:
    return Context(prec=digits, rounding=ROUND_HALF_EVEN).divide(Decimal(q.numerator), Decimal(q.denominator))


def dyadic(mantissa: int, exponent: int) -> Fraction:
    return mantissa * Fraction(2) ** exponent


mantissas = st.integers(-(2**40), 2**40)
shifts = st.integers(-80, 40)


@given(mantissas, shifts, st.integers(0, 2**29), st.integers(-120, 30), st.integers(1, 12))
@example(1, 0, 0, 0, 1)
@example(3, -1, 0, 0, 2)  # 1.5: the shift nearest to an integer
@example(3, -1, 1, -1, 1)  # [1, 2]
@example(3, -2, 1, -2, 1)  # [1/2, 1]: the ends round to different numbers
@example(1, 10, 1, -60, 3)  # the radius has the smaller exponent
@example(2**40, -40, 1, 0, 1)  # [0, 2]: the lower end is 0
def test_a_ball_is_printed_when_both_exact_ends_round_alike_and_only_then(m, e, r, f, digits):
    ball = arb((m, e), (r, f))
    low, high = dyadic(m, e) - dyadic(r, f), dyadic(m, e) + dyadic(r, f)
    assert bounds(ball) == (low, high)
    text = decimal_of_ball(ball, digits)
    if low == high == 0:
        assert text == "0"
    elif low <= 0 <= high:
        assert text is None
    elif rounded(low, digits) == rounded(high, digits):
        assert Decimal(text) == rounded(low, digits)
    else:
        assert text is None


@given(st.integers(-(10**6), 10**6), st.integers(0, 12), st.integers(1, 7))
def test_ties_go_to_the_even_digit(n: int, places: int, digits: int):
    tie = Fraction(2 * n + 1, 2 * 10**places)
    assert Decimal(rational_decimal(tie, digits)) == rounded(tie, digits)


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        ("1e-6", 3, "0.00000100"),  # the smallest in positional notation
        ("9.99e-7", 3, "9.99e-7"),
        ("999", 3, "999"),  # no point without a digit after it
        ("1000", 3, "1.00e3"),
        ("99.95", 3, "100"),  # ties to even carry into a new digit
        ("0.9995", 3, "1.00"),
        ("-7", 1, "-7"),
        ("-70", 1, "-7e1"),
        ("12", 1, "1e1"),
        ("1e-9", 1, "1e-9"),
        ("0", 5, "0"),
    ],
)
def test_notation(value: str, digits: int, text: str):
    assert rational_decimal(Fraction(value), digits) == text


def test_the_working_precision_grows_by_the_bits_of_a_digit():
    # 10^100 lies between 2^332 and 2^333.
    assert 332 + 32 <= bits_for(100) <= 333 + 32
    assert bits_for(100, 50) - bits_for(100, 20) == 30


def test_the_precision_is_doubled_until_the_rounding_is_decided():
    seen: list[int] = []

    def nearly_a_tie() -> arb:
        seen.append(1)
        return arb(1) / 4 + arb(10) ** -200

    assert certified_decimal(nearly_a_tie, 1) == "0.3"
    assert len(seen) > 2  # 10^-200 beside 1/4 takes more than 660 bits
