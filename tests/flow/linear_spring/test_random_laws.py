"""Random laws, strengths and starts: few bits contain what many bits know, and are not silly."""

import random

import pytest
from flint import arb, ctx

from asymptotics.flow.damping import Damping
from asymptotics.flow.dense import states
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.taylor import GUARD
from asymptotics.law import Law

EXPONENTS = ("0", "1/3", "1/2", "1", "3/2", "sqrt(2)", "2", "5/2", "3", "7")


def found(law, X, V, times, bits):
    with ctx.workprec(bits + GUARD):
        damping = Damping.of_law(law)
    with ctx.workprec(bits):
        return states(LinearSpring(damping), arb(X) / 16, arb(V) / 16, [arb(t) / 8 for t in times])


def check(seed):
    draw = random.Random(seed)
    exponents = draw.sample(EXPONENTS, draw.choice((1, 1, 2)))
    law = Law({a: f"{draw.randint(1, 60)}/100" for a in exponents})
    X, V = draw.randint(-32, 32) or 1, draw.choice((0, draw.randint(1, 32), -draw.randint(1, 32)))
    times = sorted(draw.randint(0, 120) for _ in range(6))
    low, high = (found(law, X, V, times, bits) for bits in (45, 90))
    for a, b in zip(low, high, strict=True):
        for small, large in zip(a, b, strict=True):
            assert small.contains(large), (seed, law)
            assert small.rad() < arb(2) ** -22, (seed, law)


@pytest.mark.parametrize("seed", [*range(6), 158])  # 158: on the slow curve a power of w integrates to ln w
def test_few_bits_contain_many(seed):
    check(seed)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(100, 300))
def test_many_random_motions(seed):
    check(seed)
