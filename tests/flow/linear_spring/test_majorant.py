"""The majorant of the expansion at a turning point: attained without damping and without inertia, up to its edge."""

import pytest
from flint import arb

from asymptotics.flow.linear_spring.majorant import majorant


@pytest.mark.parametrize("w", ["0.1", "0.5", "0.9"])
def test_the_majorant_is_attained_without_damping(w):
    """y = sqrt(1 - w^2): r = 1 - sqrt(1 - w^2) = S(w^2/2, 0)."""
    truth = 1 - (1 - arb(w) ** 2).sqrt()
    bound = majorant(arb(w) ** 2 / 2, arb(0))
    assert truth <= bound * (1 + arb(1e-12)) and bound / 2 < truth


@pytest.mark.parametrize("b", ["0.05", "0.5", "0.95"])
def test_the_majorant_is_attained_without_inertia(b):
    """With a -> 0, P = P_0 (1 - b) exactly."""
    bound = majorant(arb(2) ** -40, arb(b))
    assert arb(b) <= bound and bound / 2 < arb(b) and bound < arb(b) * arb(1.001)


def test_the_majorant_knows_its_edge():
    assert majorant(arb("0.1"), arb("0.36")) is not None  # 2 sqrt(a) + b = 0.992
    assert majorant(arb("0.1"), arb("0.41")) is None
    assert majorant(arb("0.49"), arb(0)) is not None and majorant(arb("0.51"), arb(0)) is None
