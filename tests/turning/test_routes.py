"""All routes to the turning points agree, and each says which it was."""

from itertools import islice

import pytest
from flint import arb, ctx

from asymptotics.half_swings.finite import finite_quarter
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_real
from asymptotics.turning.far import Point, series_points
from asymptotics.turning.general import turning_points
from asymptotics.turning.routes import Plan


def plan(law, *, count, interpolates, jump=False, start=0):
    return Plan(Law(law), start, count, jump, interpolates, 0.0, 64)


@pytest.mark.parametrize("law", [{"3/2": "1/4"}, {"1/2": "1/900"}, {3: "1/50"}, {1: "1/20", 2: "1/5"}])
def test_interpolation_and_the_pieces_agree(law):
    with ctx.workprec(80):
        routes = [plan(law, count=400, interpolates=chosen) for chosen in (False, True)]
        found = [list(islice(route.turnings(), 40)) for route in routes]
        assert len(found[0]) == len(found[1])
        for a, b in zip(*found, strict=True):
            assert (a.n, a.side, a.ended) == (b.n, b.side, b.ended)
            assert a.x.overlaps(b.x) and a.tau.overlaps(b.tau)
            assert b.amplitude_error < b.amplitude * 2.0**-50


@pytest.mark.parametrize("law", [{"1/2": "1/100"}, {0: "1/200", 2: "1/50"}])
def test_interpolation_follows_a_law_to_its_end(law):
    with ctx.workprec(60):
        ends = [list(plan(law, count=1000, interpolates=chosen).turnings())[-1] for chosen in (False, True)]
    assert ends[0].ended == ends[1].ended and ends[0].ended in ("creeps", "sticks")
    assert ends[0].n == ends[1].n and ends[0].x.overlaps(ends[1].x)


@pytest.mark.parametrize("start", [1500, 1501])
def test_a_jump_lands_where_the_half_swings_lead(start):
    with ctx.workprec(60):
        law = {"3/2": "1/5"}
        routes = [plan(law, start=start, count=2, interpolates=True, jump=jump) for jump in (True, False)]
        found = [list(islice((p for p in route.turnings() if p.n >= start), 2)) for route in routes]
        for jumped, passed, n in zip(*found, (start, start + 1), strict=True):
            assert jumped.n == passed.n == n and jumped.side == passed.side == (-1) ** n
            for ours, theirs in ((jumped.x, passed.x), (jumped.tau, passed.tau)):
                assert ours.overlaps(theirs) and ours.rad() < abs(ours) * arb(2) ** -44
            assert jumped.ended is None


def test_the_method_names_how_the_nodes_were_found():
    collocated = turning_points(Law({2: "1/10", 3: "1/10"}), 200, 10, start=190).method
    assert "Taylor steps, quarter-swings by collocation, Chebyshev interpolation" in collocated
    assert "collocation" not in turning_points(Law({"1/2": "1/1000"}), 300, 10, start=290).method


def test_a_wide_start_of_the_series_stays_wide():
    alpha, epsilon, width = parse_real("3", "alpha"), arb("0.02"), arb("1e-6")
    quarter = finite_quarter([alpha], [epsilon * 2], 50)
    wide, low, high = (
        list(islice(series_points(quarter, epsilon, Point(5, log, arb(7))), 4))
        for log in (arb(0, width), -width, width)
    )
    for whole, *ends in zip(wide, low, high, strict=True):
        assert all(whole.log.contains(end.log.mid()) and whole.tau.contains(end.tau.mid()) for end in ends)
    assert [p.n for p in wide] == [5, 6, 7, 8] and wide[0].tau == 7


@pytest.mark.slow
def test_a_far_start_is_certified_and_agrees_with_the_quadratic_route():
    far = turning_points(Law({"3/2": "1/5"}), 1, 50, start=10**9, times=True, max_seconds=600)
    assert far.certified
    assert far.points[0].x == "4.8375135770288450459451814859410988637559037236490e-17"
    general = plan({2: "1/5"}, start=10**6, count=1, interpolates=True, jump=True)
    with ctx.workprec(120):
        here = next(general.turnings())
    exact = turning_points(Law({2: "1/5"}), 1, 25, start=10**6, times=True).points[0]
    with ctx.workprec(200):
        assert abs(here.x - arb(exact.x)) < abs(arb(exact.x)) * arb("1e-24")
        assert abs(here.tau - arb(exact.tau)) < arb("1e-17")
