"""All routes to the turning points agree, and each says which it was."""

from itertools import islice

import pytest
from flint import arb, ctx

from asymptotics.law import Law
from asymptotics.turning.general import turning_points
from asymptotics.turning.routes import Plan


@pytest.mark.parametrize(
    ("law", "order"),
    [({"3/2": "1/4"}, 12), ({"3/2": "3"}, 16), ({"1/2": "1/100"}, 12), ({3: "1/50"}, 24)],
)
def test_the_series_and_the_pieces_agree(law, order):
    law = Law(law)
    with ctx.workprec(80):
        pieces = Plan(law, 0, 0, False, 0.0)
        series = Plan(law, 0, order, False, 0.0)
        found = [list(islice(plan.turnings(), 40)) for plan in (pieces, series)]
        assert len(found[0]) == len(found[1])
        for a, b in zip(*found, strict=True):
            assert (a.n, a.side, a.ended) == (b.n, b.side, b.ended)
            assert a.x.overlaps(b.x)
            assert a.tau.overlaps(b.tau)
            assert b.amplitude_error < b.amplitude * 2.0**-50


def test_the_series_follow_a_law_to_its_end():
    law = Law({"1/2": "1/3"})
    with ctx.workprec(60):
        ends = [list(Plan(law, 0, order, False, 0.0).turnings())[-1] for order in (0, 12)]
    assert ends[0].ended == ends[1].ended == "creeps"
    assert ends[0].n == ends[1].n


@pytest.mark.slow
def test_a_far_start_is_certified_and_agrees_with_the_quadratic_route():
    far = turning_points(Law({"3/2": "1/5"}), 1, 50, start=10**9, times=True, max_seconds=600)
    assert far.certified
    assert far.points[0].x == "4.8375135770288450459451814859410988637559037236490e-17"
    general = Plan(Law({2: "1/5"}), 10**6, 48, True, 0.0)
    with ctx.workprec(120):
        here = next(general.turnings())
    exact = turning_points(Law({2: "1/5"}), 1, 25, start=10**6, times=True).points[0]
    with ctx.workprec(200):
        assert abs(here.x - arb(exact.x)) < abs(arb(exact.x)) * arb("1e-24")
        assert abs(here.tau - arb(exact.tau)) < arb("1e-17")
