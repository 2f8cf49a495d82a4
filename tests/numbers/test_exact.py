from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from asymptotics.errors import InputError
from asymptotics.numbers.exact import ExactReal, parse_integer, parse_rational, parse_real, square_root


@given(st.fractions())
def test_fractions_are_read_back_exactly(q: Fraction):
    assert parse_rational(str(q), "--x") == q


@given(st.decimals(allow_nan=False, allow_infinity=False, min_value=-(10**20), max_value=10**20))
def test_decimals_are_read_exactly(d):
    assert parse_rational(str(d), "--x") == Fraction(d)


@pytest.mark.parametrize(
    "text",
    ["", "nan", "inf", "abc", "1e999999", "0x10", "1_000", "1/0", "١", "1//2", "1e", "--1", "1 2", "__import__('os')",
     "sqrt(-2)", "sqrt()", "sqrt(2", "sqrt(sqrt(2))", "2*sqrt(2)", "1" * 2000, "9**9**9", "x.__class__"],
)  # fmt: skip
def test_what_is_not_a_number_is_refused_by_name(text: str):
    with pytest.raises(InputError) as caught:
        parse_real(text, "--alpha")
    assert "--alpha" in str(caught.value)
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 250


def test_square_roots_of_squares_are_rational():
    assert square_root(Fraction(49, 9)) == ExactReal(Fraction(7, 3))
    assert not square_root(Fraction(2)).is_rational
    with pytest.raises(ValueError, match="irrational"):
        _ = square_root(Fraction(2)).rational


@given(st.fractions(min_value=0), st.fractions())
def test_order_agrees_with_the_ball(r: Fraction, q: Fraction):
    # For irrational sqrt(r) the ball of sqrt(r) - q decides the sign whenever it excludes zero.
    x = square_root(r)
    gap = x.ball() - ExactReal(q).ball()
    if gap > 0:
        assert x > q
    if gap < 0:
        assert x < q


def test_integers_have_bounds():
    assert parse_integer("7", "--n", 1, 7) == 7
    for text in ("8", "0", "1.0", "1e3", "-3", "x"):
        with pytest.raises(InputError, match=r"--n.*integer from 1 to 7"):
            parse_integer(text, "--n", 1, 7)
