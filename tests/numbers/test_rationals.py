"""Rational bounds of balls."""

from fractions import Fraction

from flint import ctx
from hypothesis import given
from hypothesis import strategies as st

from asymptotics.numbers import ExactReal
from asymptotics.numbers.rationals import bounds


@given(st.fractions(min_value=Fraction(1, 1000), max_value=1000), st.integers(20, 300))
def test_bounds_enclose(q: Fraction, bits: int):
    with ctx.workprec(bits):
        low, high = bounds(ExactReal(q).ball())
    assert low <= q <= high
    assert high - low <= q * Fraction(2) ** (2 - bits)
