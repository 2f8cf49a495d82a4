"""Decimals of exact numbers and balls: the decimal module, exact end points, and the edges of the notation."""

from decimal import ROUND_HALF_EVEN, Context, Decimal
from fractions import Fraction

import pytest
from flint import arb, ctx, fmpq
from hypothesis import assume, example, given
from hypothesis import strategies as st

from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.numbers.decimals import (
    bits_for,
    certified_decimal,
    decimal_of_ball,
    directed_decimal,
    rational_decimal,
)
from asymptotics.numbers.rationals import bounds

digits_st = st.integers(1, 40)


def rounded(q: Fraction, digits: int) -> Decimal:
    return Context(prec=digits, rounding=ROUND_HALF_EVEN).divide(Decimal(q.numerator), Decimal(q.denominator))


def dyadic(mantissa: int, exponent: int) -> Fraction:
    return mantissa * Fraction(2) ** exponent


mantissas = st.integers(-(2**40), 2**40)
shifts = st.integers(-80, 40)


@given(st.fractions(), digits_st)
def test_rationals_round_as_the_decimal_module_does(q: Fraction, digits: int):
    # An independent implementation of round-half-even of a quotient.
    expected = Context(prec=digits, rounding=ROUND_HALF_EVEN).divide(Decimal(q.numerator), Decimal(q.denominator))
    assert Decimal(rational_decimal(q, digits)) == expected


@given(st.fractions(), digits_st)
def test_a_ball_prints_only_what_all_its_numbers_round_to(q: Fraction, digits: int):
    assume(q != 0)
    with ctx.workprec(60):
        ball = arb(fmpq(q.numerator, q.denominator))
    ends = {rational_decimal(end, digits) for end in bounds(ball)}
    text = decimal_of_ball(ball, digits)
    assert text == (rational_decimal(q, digits) if len(ends) == 1 else None)


def test_wide_balls_are_not_printed():
    assert decimal_of_ball(arb(1, 0.5), 1) is None
    assert decimal_of_ball(arb(0, 1), 1) is None
    assert decimal_of_ball(arb("nan"), 1) is None
    assert decimal_of_ball(arb(1, 1e-12), 10) == "1.000000000"  # both ends round to 1.000000000


def test_hard_to_round_values():
    # 0.5 + 10^-40 rounds up at no digits but must be told from the tie 0.5 of "1 digit of 0.25": 0.25 -> 0.2 (even).
    assert rational_decimal(Fraction(25, 100), 1) == "0.2"
    assert rational_decimal(Fraction(25, 100) + Fraction(1, 10**40), 1) == "0.3"
    assert certified_decimal(lambda: arb(fmpq(25, 100)) + arb(10) ** -40, 1) == "0.3"
    assert rational_decimal(Fraction(99999, 10000), 3) == "10.0"


def test_undecided_is_an_error_and_not_a_guess():
    with pytest.raises(UndecidedError, match="2000 bits"):
        certified_decimal(lambda: arb(2).sqrt() ** 2 - 2, 5, max_bits=2000)
    # A value on a decimal tie that no ball can recognise: 0.25 as (sqrt(2)/2)^2 / 2, rounded to one digit.
    with pytest.raises(UndecidedError):
        certified_decimal(lambda: (arb(2).sqrt() / 2) ** 2 / 2, 1, max_bits=2000)


@pytest.mark.parametrize("digits", [0, 300_001, True, 2.0])
def test_every_printer_has_the_same_contract_for_digits(digits):
    ball, q = arb(1) / 3, Fraction(1, 3)
    for printed in (
        lambda: decimal_of_ball(ball, digits),
        lambda: certified_decimal(lambda: ball, digits),
        lambda: rational_decimal(q, digits),
        lambda: directed_decimal(q, digits, 1),
    ):
        with pytest.raises(InputError, match="argument digits: .*an integer from 1 to 300000"):
            printed()


def test_ten_thousand_digits():
    text = certified_decimal(lambda: arb(2).sqrt(), 10_000)
    assert len(text) == 10_001
    n = int(Fraction(Decimal(text[:3000])) * 10**2998)  # int(str) is limited to 4300 digits
    assert n * n <= 2 * 10 ** (2 * 2998) < (n + 1) ** 2


def test_magnitudes_that_would_fill_the_memory_are_refused():
    with pytest.raises(LimitError, match="magnitude"):
        decimal_of_ball((-(arb(10) ** 12)).exp(), 10)
    assert decimal_of_ball(arb(0, 1) * arb(10).exp().exp().exp(), 5) is None


@pytest.mark.parametrize("exponent", [-(10**7), -(10**12), -(10**30)])
def test_a_radius_out_of_sight_costs_no_memory(exponent):
    # The ends of 1/3 +- 2^-10^12 would have 10^12 bits.
    tiny = (1, exponent)
    assert decimal_of_ball(arb((-3, -1), tiny), 5) == "-1.5000"
    assert decimal_of_ball(arb(0, tiny), 5) is None is decimal_of_ball(arb((1, -2), tiny), 1)  # 0.25: on both sides


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


def test_a_ball_about_0_is_asked_again_however_small_its_middle():
    """Its middle alone would be refused by its magnitude."""
    assert decimal_of_ball(arb(2) ** -192359348 + arb(0, 22), 5) is None
    with pytest.raises(LimitError, match="magnitude"):
        decimal_of_ball(arb(2) ** -192359348, 5)
