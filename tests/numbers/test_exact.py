from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from asymptotics.errors import InputError
from asymptotics.numbers.exact import ExactReal, parse_rational, parse_real, square_root
from asymptotics.numbers.integers import parse_integer, require_integer
from tests.each import each


@given(st.fractions())
def test_fractions_are_read_back_exactly(q: Fraction):
    assert parse_rational(str(q), "--x") == q


@given(st.decimals(allow_nan=False, allow_infinity=False, min_value=-(10**20), max_value=10**20))
def test_decimals_are_read_exactly(d):
    assert parse_rational(str(d), "--x") == Fraction(d)


@given(st.fractions(), st.fractions(min_value=0), st.fractions())
def test_a_number_is_read_back_from_its_text(a: Fraction, r: Fraction, b: Fraction):
    x = ExactReal(a, r, b)
    again = parse_real(str(x), "--x")
    assert again == x and str(again) == str(x)


@each(
    "text",
    ["", "nan", "inf", "abc", "1e999999", "0x10", "1_000", "1/0", "١", "1//2", "1e", "--1", "1 2", "__import__('os')",
     "sqrt(-2)", "sqrt(1/0)", "sqrt()", "sqrt(2", "sqrt(sqrt(2))", "2*sqrt(2)*3", "sqrt(2) -1",
     "sqrt(2) - ", "sqrt(2) - -1", "sqrt(2)-1e",
     "+-sqrt(2)", "*sqrt(2)", "1/0*sqrt(2)", "1" * 2000, "9**9**9", "x.__class__"],
)  # fmt: skip
def test_what_is_not_a_number_is_refused_by_name(text: str):
    with pytest.raises(InputError) as caught:
        parse_real(text, "--alpha")
    assert "--alpha" in str(caught.value)
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 250


@pytest.mark.parametrize(("length", "quoted"), [(60, "x" * 60), (61, "x" * 57 + "...")])
def test_sixty_characters_of_what_was_typed_are_quoted(length: int, quoted: str):
    with pytest.raises(InputError, match=f"argument --alpha: '{quoted}' is not an exact number"):
        parse_real("x" * length, "--alpha")


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
    assert parse_integer("1.0", "--n", 1, 7) == 1  # as numpy.savetxt writes it
    for text in ("8", "0", "1.5", "1e3", "-3", "x"):
        with pytest.raises(InputError, match=r"--n.*integer from 1 to 7"):
            parse_integer(text, "--n", 1, 7)


def test_equal_numbers_are_neither_above_nor_below():
    # sqrt(8)/2 = sqrt(2) with different parts; 99/70 > sqrt(2) since 99^2 = 2 * 70^2 + 1.
    x, y, near = square_root(Fraction(2)), ExactReal(Fraction(1, 2), 8), Fraction(99, 70)
    assert x >= y and x <= y and not x > y and not x < y
    assert near >= x and x <= near and not x >= near and x < near


def test_a_text_has_at_most_a_thousand_characters():
    assert parse_real("sqrt(2)".ljust(1000), "--x") == square_root(Fraction(2))
    assert parse_rational("1".ljust(1200), "--x") == 1  # only what remains without the blanks is counted
    with pytest.raises(InputError, match="--x"):
        parse_real("sqrt(2)".ljust(1001), "--x")


@pytest.mark.parametrize(
    ("value", "shown"),
    [(6, "6 is out"), (0, "0 is out"), (10**40 - 1, "9" * 40 + " is out"), (10**40, "of 133 bits"),
     (10**5000, "of 16610 bits"), (-(10**5000), "of 16610 bits"), (True, "True is a bool"),
     (2.0, "2.0 .float. is not an"),
     ("2", "'2' is not an")],
    ids=range(9),
)  # fmt: skip
def test_integers_of_any_size_are_refused_in_one_line(value, shown: str):
    # 10^40 has floor(40 log2 10) + 1 = 133 bits; Python prints no integer of more than 4300 digits.
    with pytest.raises(InputError, match=f"argument n: .*{shown}.*an integer from 1 to 5"):
        require_integer(value, "n", 1, 5)
    assert require_integer(1, "n", 1, 5) == 1 and require_integer(5, "n", 1, 5) == 5
