"""Upper bounds are bounds at any precision, and short."""

import pytest
from flint import arb, ctx

from asymptotics.flow.balls import upper


@pytest.mark.parametrize("bits", [20, 53, 128, 129, 1000])
def test_an_upper_bound_is_one_at_few_and_many_bits(bits):
    with ctx.workprec(bits):
        x = -arb(2).sqrt() - arb(0, "0.125")
        found = upper(x)
    with ctx.workprec(4000):
        largest = arb(2).sqrt() + arb("0.125")
        assert found.rad() == 0 and largest < found < largest + arb(2) ** -18 and found.bits() <= 128
