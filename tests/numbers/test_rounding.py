"""Directed roundings against the decimal module, signs and whole decimals included."""

from decimal import ROUND_CEILING, ROUND_DOWN, ROUND_FLOOR, ROUND_HALF_EVEN, ROUND_UP, Context, Decimal
from fractions import Fraction

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from asymptotics.errors import InputError
from asymptotics.numbers.decimals import directed_decimal
from asymptotics.numbers.rounding import MODES, half_unit, require_mode, rounded_decimal, rounded_rational

DIRECTIONS = {"nearest": ROUND_HALF_EVEN, "down": ROUND_DOWN, "up": ROUND_UP, "floor": ROUND_FLOOR,
              "ceil": ROUND_CEILING}  # fmt: skip


@given(st.fractions(), st.integers(1, 12))
@example(Fraction(1, 1000), 1)  # a decimal already: every direction keeps it
@example(Fraction(-999999, 1000), 3)  # away from zero into a new digit
@example(Fraction(10**6), 6)
def test_every_direction_is_that_of_the_decimal_module(q: Fraction, digits: int):
    for mode, direction in DIRECTIONS.items():
        expected = Context(prec=digits, rounding=direction).divide(Decimal(q.numerator), Decimal(q.denominator))
        assert Decimal(rounded_rational(q, digits, mode)) == expected
    floor, ceil = (rounded_rational(q, digits, mode) for mode in ("floor", "ceil"))
    assert rounded_rational(q, digits, "interval") == (f"[{floor}, {ceil}]" if q else "0")


@given(st.fractions(), st.integers(1, 12))
@example(Fraction(1, 3), 2)
@example(Fraction(-1, 3), 2)
@example(Fraction(1, 4), 1)
def test_directed_decimals_lie_on_their_side(q: Fraction, digits: int):
    above, below = (Fraction(directed_decimal(q, digits, side)) for side in (1, -1))
    nearest = Fraction(rounded_rational(q, digits, "nearest"))
    assert below <= q <= above and nearest in (below, above)
    assert (below == above) == (nearest == q)


def test_a_decimal_decides_what_lies_within_half_a_unit():
    # "0.1234" stands for [0.12335, 0.12345]; three digits down: 0.123 at both ends, nearest: too.
    assert [rounded_decimal("0.1234", 3, m) for m in MODES] == ["0.123", "0.123", "0.124", "0.123", "0.124",
                                                                "[0.123, 0.124]"]  # fmt: skip
    # "0.1235" stands for [0.12345, 0.12355]: on both sides of the tie; "0.1230" for both sides of 0.123.
    assert [rounded_decimal("0.1235", 3, m) for m in ("nearest", "floor")] == [None, "0.123"]
    assert [rounded_decimal("0.1230", 3, m) for m in ("nearest", "floor", "ceil")] == ["0.123", None, None]
    assert rounded_decimal("0", 3, "ceil") == "0"
    assert [half_unit(t) for t in ("7", "0.5", "1.25e-3", "3E2")] == [
        Fraction(1, 2), Fraction(1, 20), Fraction(1, 200000), Fraction(50)]  # fmt: skip


def test_modes_have_names():
    for mode in MODES:
        require_mode(mode)
    with pytest.raises(InputError, match="'sideways' is unknown"):
        rounded_rational(Fraction(1), 3, "sideways")


def test_numbers_longer_than_python_reads_are_rounded():
    assert rounded_decimal("2.53e-17372", 2, "floor") == "2.5e-17372"
    assert rounded_decimal("0." + 5000 * "3", 4500, "ceil") == "0." + 4499 * "3" + "4"
