"""The displacement at a fixed time: against exact motion, short series against long ones, bounds that are attained."""

import pytest
from flint import arb, arb_poly

from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.certified_displacement import RADIUS, DisplacementSeries, displacement_series
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.numbers.context import ctx
from asymptotics.terms import Term


def geometric(terms):
    """sum_i (t/3)^i, cut: the coefficients are as large as a bound 1 on |t| < 3 allows."""
    kept = arb_poly([arb(RADIUS) ** -i for i in range(terms)])
    return DisplacementSeries({(1,): arb(0)}, {(1,): kept}, {(1,): arb(1)}, terms)


@pytest.mark.parametrize("tau", ["1/2", "3/2"])
def test_the_tail_of_a_displacement_is_attained_and_half_of_it_would_not_do(tau):
    with ctx.workprec(200):
        tau = arb(1) / 2 if tau == "1/2" else arb(3) / 2
        t = (2 * tau / arb.pi()) ** 2
        value = tau**2 / (1 - t / RADIUS)
        slope = tau**2 * (2 / (1 - t / RADIUS) + 2 * t / RADIUS / (1 - t / RADIUS) ** 2)
        for terms in (4, 12):
            found = geometric(terms).slopes((1,), tau, 2)
            for ball, true in zip(found, (value, slope)):
                miss = abs(true - ball.mid())
                assert ball.contains(true.mid()) and 2 * miss > ball.rad() * (1 if ball is found[0] else arb(1) / 2)


def test_a_displacement_beyond_its_circle_is_refused():
    with pytest.raises(UndecidedError, match="displacement"):
        geometric(4).slopes((1,), arb(3), 1)


@pytest.mark.parametrize("law", [("2",), ("3/2",), ("1/3", "2")])
def test_few_terms_are_enclosed_by_many(law):
    """Balls of short series overlap those of long ones; without their tails they do not."""
    forces = Forces.of([Term(1, a) for a in law], 3)
    short, long = (displacement_series(forces, 3, bits) for bits in (4, 120))
    with ctx.workprec(150):
        tau, missed = arb(3) / 2, 0
        for key in long.series:
            for a, b in zip(short.slopes(key, tau, 3), long.slopes(key, tau, 3)):
                assert a.overlaps(b) and b.rad() < 1e-30
                missed += not (a.mid() + arb(0)).overlaps(b)
        assert missed


def test_linear_friction_is_known():
    """exp(-eps tau/2)(cos w tau + eps/(2 w) sin w tau), w^2 = 1 - eps^2/4: its second order."""
    with ctx.workprec(120):
        tau = arb(1)
        found = displacement_series(Forces.losses((1,)), 2, 100)
        first = (tau.sin() - tau * tau.cos()) / 2
        assert found.slopes((1,), tau, 1)[0].overlaps(first)
        second = tau**2 * tau.cos() / 8 - tau * tau.sin() / 8
        assert found.slopes((2,), tau, 1)[0].overlaps(second)
