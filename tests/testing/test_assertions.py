from fractions import Fraction

import pytest

from asymptotics.errors import InputError
from asymptotics.testing.assertions import assert_digits, assert_order, right_digits


def test_the_edge_of_a_digit():
    # |1.001/1 - 1| = 10^-3 exactly: three digits are right, and not one more.
    assert_digits("1.001", "1.00000", 3)
    with pytest.raises(AssertionError, match=r"has 3\.0 right digits, 4 are wanted"):
        assert_digits("1.001", "1.00000", 4)


@pytest.mark.parametrize("value", ["-1", 0.0, float("nan"), float("inf"), "text", None, "2"])
def test_what_is_no_approximation_has_no_digits(value):
    with pytest.raises(AssertionError):
        assert_digits(value, "1.0000", 1)


def test_numbers_of_any_length_are_read_and_none_that_nobody_could_write_out():
    third = "0." + "3" * 6000
    assert right_digits(third[:5002], third) == pytest.approx(5000, abs=1)
    assert right_digits(Fraction(10**5000, 3 * 10**5000 + 1), third) == pytest.approx(5000, abs=1)
    assert right_digits("1e999999999", "1.000") == right_digits("1/0", "1.000") == float("-inf")
    assert right_digits("1/0.5", "2.000") == float("-inf")


def test_zero_is_met_by_zero_only():
    assert_digits(0, "0", 10)
    with pytest.raises(AssertionError):
        assert_digits(1e-300, "0", 10)


def test_a_certified_value_with_too_few_digits_cannot_judge():
    with pytest.raises(InputError, match="cannot be told"):
        assert_digits("1.23", "1.23", 3)
    # 1.000 may stand for 1.0005: one digit more is half of the tolerance, two are a twentieth.
    with pytest.raises(InputError, match="two fewer"):
        assert_digits("1.001", "1.000", 3)
    assert_digits("1.001", "1.0000", 3)
    assert right_digits("1.23", "1.23") == float("inf")


@pytest.mark.parametrize(("power", "claimed", "passes"), [(2, 2, True), (2, 3, False), (3, 2, False), (4, 4, True)])
def test_orders(power, claimed, passes):
    def error(strength: Fraction) -> float:
        return float(5 * strength**power * (1 + strength))

    if passes:
        assert_order(error, claimed)
    else:
        with pytest.raises(AssertionError, match=f"not {claimed}"):
            assert_order(error, claimed)


@pytest.mark.parametrize("value", [0.0, float("nan"), -1.0])
def test_no_order_is_read_from_errors_that_are_none(value):
    with pytest.raises(AssertionError, match="no order"):
        assert_order(lambda strength: value, 2)


def test_strengths_are_halved():
    with pytest.raises(InputError, match="halved"):
        assert_order(float, 1, [Fraction(1), Fraction(1, 3)])
