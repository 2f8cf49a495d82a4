"""Random wells, losses and starts: few bits contain what many bits know, and are not silly."""

import random

import pytest
from flint import arb, ctx

from asymptotics.errors import InputError, UndecidedError
from asymptotics.flow.dense import states
from asymptotics.flow.taylor import GUARD
from asymptotics.flow.wells.even_well import EvenWell
from asymptotics.flow.wells.force import WellForce
from asymptotics.flow.wells.trapping_regions import inside
from asymptotics.law import Law

EXPONENTS = ("0", "1/3", "1/2", "1", "3/2", "2", "5/2", "3", "7")


def found(law, X, V, times, bits):
    with ctx.workprec(bits + GUARD):
        force = WellForce.of(law.terms)
    with ctx.workprec(bits):
        return states(EvenWell(force), arb(X) / 16, arb(V) / 16, [arb(t) / 8 for t in times])


def check(seed):
    """Whether the motion was followed at both precisions."""
    draw = random.Random(seed)
    losses = {
        (a, draw.choice((0, 0, 1, 2, 3))): f"{draw.randint(1, 60)}/100"
        for a in draw.sample(EXPONENTS, draw.choice((1, 2)))
    }
    spring = {draw.choice((2, 3, 4, 5)): f"{draw.randint(-30, 200)}/100"} if draw.random() < 0.6 else "pendulum"
    law = Law(losses, spring=spring)
    X, V = draw.randint(-32, 32) or 1, draw.choice((0, draw.randint(1, 24), -draw.randint(1, 24)))
    times = sorted(draw.randint(0, 100) for _ in range(5))
    with ctx.workprec(60):
        if inside(WellForce.of(law.terms), arb(X) / 16) is not True:
            return False
    try:
        low, high = (found(law, X, V, times, bits) for bits in (50, 90))
    except InputError as left:
        assert "leaves its well" in str(left)
        return False
    except UndecidedError:
        return False
    for a, b in zip(low, high, strict=True):
        for small, large in zip(a, b, strict=True):
            assert small.contains(large), (seed, law)
            assert small.rad() < arb(2) ** -16, (seed, law)
    return True


def test_few_bits_contain_many():
    assert sum(check(seed) for seed in range(2)) >= 1


@pytest.mark.slow
def test_few_bits_contain_many_at_length():
    assert sum(check(seed) for seed in range(10, 130)) >= 90
