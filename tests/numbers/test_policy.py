"""The number policy and exact arithmetic with one root, against balls at another precision."""

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import sympy
from flint import arb, ctx, fmpq, fmpz
from hypothesis import given
from hypothesis import strategies as st

from asymptotics.errors import InputError
from asymptotics.numbers.arrays import real_array
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import exact_integer, exact_number, float_notes
from asymptotics.numbers.powers import exact_power

HALVES = ["3/2", "1.5", " 15e-1 ", 1.5, np.float64(1.5), np.float32(1.5), Fraction(3, 2), Decimal("1.50"), fmpq(3, 2),
          sympy.Rational(3, 2), ExactReal(Fraction(3, 2)), ExactReal(3, Fraction(1, 4))]  # fmt: skip


@pytest.mark.parametrize("value", HALVES, ids=repr)
def test_one_number_whoever_brings_it(value):
    assert exact_number(value, "x") == Fraction(3, 2)


def test_integers_and_roots_of_other_libraries():
    assert [exact_number(v, "n") for v in (7, np.int8(7), fmpz(7), sympy.Integer(7), 7.0)] == [7] * 5
    root = exact_number("sqrt(3/2)", "x")
    for value in (sympy.sqrt(sympy.Rational(3, 2)), sympy.sqrt(6) / 2, ExactReal(1, Fraction(3, 2))):
        assert exact_number(value, "x") == root
    assert exact_number(2 - sympy.sqrt(8), "x") == 2 - 2 * exact_number("sqrt(2)", "x")


def test_a_float_is_its_shortest_decimal_and_is_noted():
    assert exact_number(0.1, "b") == Fraction(1, 10) != Fraction(0.1)
    assert float_notes(b=0.1, alpha=2, mass="0.1", n=Decimal("0.1")) == ("b: the float 0.1 was read as 1/10",)
    assert float_notes(x0=np.float32(0.1)) == ("x0: the float 0.1 was read as 1/10",)


@pytest.mark.parametrize("bad", [2.5, "5/2", 0, 41, True, None, "x", [], float("inf")], ids=str)
def test_integers_out_of_range_are_refused(bad):
    with pytest.raises(InputError, match="argument order: .*an integer from 1 to 40"):
        exact_integer(bad, "order", 1, 40)


@pytest.mark.parametrize("bad", [(0.1,), (1, 0.5), (1, -2), (True,), ("1",), (1, 1, "2")])
def test_the_constructor_takes_only_exact_parts(bad):
    with pytest.raises(InputError, match=f"argument {('coefficient', 'radicand', 'offset')[len(bad) - 1]}: "):
        ExactReal(*bad)


def test_the_constructor_reduces():
    assert (ExactReal(1, 4).coefficient, ExactReal(1, 4).radicand) == (2, 1)
    assert ExactReal(0, 2).is_zero and ExactReal(0, 2).is_rational and ExactReal(3, 2, -1).sign == 1
    once, again = ExactReal(1, 2), ExactReal(Fraction(1, 2), 8)
    assert once == again and hash(once) == hash(again)
    assert ExactReal(2).is_integer and not ExactReal(1, 2).is_integer and hash(ExactReal(2)) == hash(2)


small = st.fractions(min_value=-9, max_value=9, max_denominator=6)
reals = st.builds(ExactReal, small, st.fractions(min_value=0, max_value=9, max_denominator=3), small)


@given(reals, reals)
def test_order_and_arithmetic_agree_with_balls(x, y):
    with ctx.workprec(200):
        gap = x.ball() - y.ball()
        assert (x > y, x < y, x == y) == (bool(gap > 0), bool(gap < 0), gap.contains(0))
        assert x.sign == (x > 0) - (x < 0)
        assert abs(x) == (x if x > 0 else -x) and abs(x).sign == abs(x.sign)
        for operation in (lambda a, b: a + b, lambda a, b: a - b, lambda a, b: a * b):
            try:
                value = operation(x, y)
            except InputError:  # two different roots
                assert not x.is_rational and not y.is_rational
                continue
            assert value.ball().overlaps(operation(x.ball(), y.ball()))
        if not x.is_zero:
            assert x / x == 1 and 1 / x * x == 1
            assert (x**-2).ball().overlaps(x.ball() ** -2) and x**0 == 1


def test_exact_power_is_exact_or_none():
    assert exact_power(ExactReal(Fraction(9, 4)), ExactReal(Fraction(-3, 2))) == Fraction(8, 27)
    assert exact_power(ExactReal(1, 2), ExactReal(4)) == 4 and exact_power(ExactReal(1), ExactReal(1, 3)) == 1
    assert exact_power(ExactReal(2), ExactReal(Fraction(1, 4))) is None is exact_power(ExactReal(2), ExactReal(1, 2))
    with ctx.workprec(100):
        assert exact_power(ExactReal(3), ExactReal(Fraction(3, 2))).ball().overlaps(arb(27).sqrt())


def test_powers_are_written_out_through_the_thousandth():
    two = ExactReal(2)
    assert exact_power(two, ExactReal(-1000)) == Fraction(1, 2**1000) and exact_power(two, ExactReal(1001)) is None
    assert exact_power(two, ExactReal(Fraction(999, 2))) == 2**499 * ExactReal(1, 2)
    assert exact_power(two, ExactReal(Fraction(1001, 2))) is None


def test_a_sympy_float_is_refused_as_binary():
    with pytest.raises(InputError, match="SymPy Float, a binary number"):
        exact_number(sympy.Float("0.5"), "x")
    for endless in (sympy.oo, sympy.nan, sympy.zoo):
        with pytest.raises(InputError, match="argument x"):
            exact_number(endless, "x")


def test_a_text_becomes_the_double_next_to_it():
    """Failed before: FLINT cuts off where it makes a double, and 0.1 was 0.09999999999999999."""
    texts = [f"{n / 1000}" for n in range(1, 300)]
    assert real_array(texts, "x").tolist() == [float(text) for text in texts]
    assert float(exact_number("0.1", "x").ball().mid()) != 0.1  # near miss: what was done before


@pytest.mark.parametrize("buffer", [b"1", bytearray(b"1"), memoryview(b"1")])
def test_a_buffer_of_bytes_is_no_array(buffer):
    """Failed before: bytearray(b"1") was the time 49."""
    with pytest.raises(InputError, match="argument time"):
        real_array(buffer, "time")
