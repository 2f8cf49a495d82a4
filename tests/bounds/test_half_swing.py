"""The series of a half-swing cut after delta^N: the motion is within the bound, and half of it would be too little."""

import pytest
from flint import arb, ctx

from asymptotics.bounds.half_swing import disc, half_swing_series
from asymptotics.errors import UndecidedError
from asymptotics.flow.damping import Damping
from asymptotics.numbers.exact import parse_real
from asymptotics.return_map.half_swing_map import integrated

EXPONENTS = [("2",), ("3/2",), ("0",), ("1/2",), ("3",), ("sqrt(2)",)]


def reals(*texts):
    return tuple(parse_real(text, "alpha") for text in texts)


def true_L(alphas, deltas):
    with ctx.workprec(100):
        return integrated(Damping.of(list(zip(deltas, alphas))), arb(1)).amplitude.log()


@pytest.mark.parametrize("alphas", EXPONENTS, ids=str)
@pytest.mark.parametrize("order", [1, 2, 4])
def test_the_motion_is_within_the_bound_and_not_within_half_of_it(alphas, order):
    series = half_swing_series(reals(*alphas), order)
    delta = arb("0.05")
    truth = true_L(reals(*alphas), [delta])
    with ctx.workprec(100):
        assert series.at((delta,)).contains(truth)
        assert series.rest(delta) < 2 * abs(series.L.at((delta,)) - truth)


@pytest.mark.parametrize("split", ["0.1", "0.5", "0.9"])
@pytest.mark.parametrize("alphas", [("1", "2"), ("0", "3/2")], ids=str)
def test_every_mixture_is_within_the_bound(alphas, split):
    series, part = half_swing_series(reals(*alphas), 2), arb(split)
    deltas = [arb("0.06") * part, arb("0.06") * (1 - part)]
    assert series.at(deltas).overlaps(true_L(reals(*alphas), deltas))


def test_the_disc_is_where_the_motion_is_bounded():
    growth, radius = disc(reals("2"))
    with ctx.workprec(100):
        for share in ("0.5", "0.99"):
            assert abs(true_L(reals("2"), [radius * arb(share)])) < growth
    with pytest.raises(UndecidedError, match="outside the polydisc"):
        half_swing_series(reals("2"), 2).at((radius * 2,))
