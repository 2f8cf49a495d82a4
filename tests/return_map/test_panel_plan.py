"""The plan of a panel: in doubles what the majorant says in balls, and no larger than what is verified."""

from types import SimpleNamespace

import mpmath
import numpy as np
import pytest
from flint import arb
from scipy.integrate import solve_ivp

from asymptotics.expansions.moments.certified import moment
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_real
from asymptotics.return_map import panel_plan
from asymptotics.return_map.chebyshev import cut
from asymptotics.return_map.panel_plan import between, farthest, from_zero, path, pieces_from_zero, verified, widest
from asymptotics.return_map.panels import Panels
from tests.return_map.laws import PLACES, by_pieces, coordinate
from tests.worlds import WORLDS


def complex_half_swing(c, z):
    """(L, T) at a complex z by an ordinary integrator."""
    laws = [
        (float(e) * (np.exp(float(k) * z) if c.root is None else z ** float(k)), float(a))
        for e, k, a in zip(c.epsilons, c.powers, c.exponents, strict=True)
    ]

    def slope(t, state):
        s, co = np.sin(t), np.cos(t)
        load = sum(d * np.exp((a - 1) * state[0]) * s**a for d, a in laws)
        return [-load * s / (1 - load * co), 1 / (1 - load * co)]

    return solve_ivp(slope, (0, np.pi), [0j, 0j], rtol=1e-8, atol=1e-9).y[:, -1]


@pytest.mark.parametrize(("name", "middle", "half"), [("a sum of powers", 0.5, 1.0), ("three weak powers", -1.0, 1.2)])
def test_the_half_swing_at_complex_strengths_obeys_the_bounds(name, middle, half):
    """|q/p - 1| and |T - pi| on the ellipse by an ordinary integrator in complex numbers: below, and not far below."""
    c = coordinate(WORLDS[name].pairs)
    ellipse = verified(c, arb(middle), arb(half), 1.0001)
    largest = [0.0, 0.0]
    for angle in np.linspace(0, 2 * np.pi, 13):
        L, T = complex_half_swing(c, middle + half * (np.cos(angle) + 0.3j * np.sin(angle)))
        largest = [max(pair) for pair in zip(largest, (abs(np.exp(L) - 1), abs(T - np.pi)), strict=True)]
    for seen, bound in zip(largest, (ellipse.ratio_bound, ellipse.majorant.excess), strict=True):
        assert seen <= float(bound) <= 40 * seen


def test_no_panel_is_planned_where_no_ellipse_is_wide_enough():
    assert from_zero(coordinate((("1", "1999/1000"), ("2", "1/10"))), 1.0, 190, quartered=True) is None
    assert between(coordinate((("1", "1999/1000"), ("sqrt(2)", "1/10"), ("2", "1/10"))), 0.0, 200, 190) is None


def test_an_ellipse_that_reaches_too_far_is_made_smaller():
    c = coordinate((("2", "1/5"),))
    assert c.bounds(arb(1), arb(5)) is None and c.bounds(arb(-1), arb("0.1")) is None
    found = verified(c, arb("0.5"), arb("0.5"), 100.0)
    assert found.R > 5 and found.R < 12
    assert mpmath.almosteq(float(found.R + 1 / found.R) / 2 * 0.5 + 0.5, float(found.majorant.radii[0]) * 5, 1e-9)


def test_a_plan_saves_half_swings_or_is_none():
    c = coordinate((("sqrt(2)", "1/20"), ("2", "1/20")))
    short, long = between(c, 0.0, 12, 120), between(c, 0.0, 1000, 120)
    assert short is None and long is not None and long.nodes + long.wait < 150
    more = between(c, 0.0, 1000, 400)
    assert more is not None and more.nodes > 2 * long.nodes
    half = coordinate((("0", "1/1000"), ("1/2", "1/1000")))
    for count in (20, 60):  # all of them on one panel, the last place included
        places = list(path(half, 0.0, count))
        plan = between(half, 0.0, count, count)
        assert plan.served == count == len(places) and places[-1] - 0.05 < plan.first < places[-1]
        assert places[0] < plan.last < places[0] + 0.01


def test_a_panel_from_zero_holds_the_place_and_is_one_of_a_row():
    """The longest that is cheap, whatever place is asked for; a shorter one first, and where that is dear."""
    c = coordinate((("3/2", "1"),))
    places = panel_plan.places_of(c, quartered=True)
    first = [from_zero(c, z, 80, quartered=True) for z in (1e-6, 0.1)]
    assert first[0] == first[1] and 0.1 < first[0].last < 0.3 * places
    plans = [from_zero(c, z, 80, quartered=True, long=True) for z in (1e-6, 0.1, 0.45 * places, 0.55 * places)]
    assert plans[:2] == [plans[2]] * 2 and plans[2].last == 0.5 * places and plans[3] is None
    assert farthest(c, 80, quartered=True).last == 0.9 * places
    dear = [from_zero(c, z, 1000, quartered=True) for z in (1e-6, 0.1, 0.4 * places)]
    assert dear[0].last < dear[1].last < dear[2].last and all(p.last > z for p, z in zip(dear, (1e-6, 0.1, 0.4)))
    row = [panel_plan._up_to(c, share, 1000, True) for share in panel_plan._OF_REACH]
    assert 22 < dear[0].work(True) <= 1.1 * min(p.work(True) for p in row if p.last >= 1e-6)


def test_what_half_swings_are_worth_counts_those_before_the_panel():
    c = coordinate((("3/2", "1"),))
    nodes = from_zero(c, 0.1, 80, quartered=True).work(True)
    low, high = (pieces_from_zero(c, 2 * np.log(z), 500, 80) for z in (0.1, 2.0))
    assert (
        low == nodes < high <= from_zero(c, 0.5, 80, quartered=True).work(True) + 3
        and pieces_from_zero(c, 0.0, 7, 80) == 7
    )


@pytest.mark.parametrize("name", [*list(PLACES)[:4], "weak dry friction"])
def test_the_reach_in_doubles_is_that_of_the_majorant(name):
    c = coordinate(WORLDS[name].pairs)
    reach = panel_plan.reach_of(c)
    assert c.bounds(arb(0), arb(0.95 * reach)) is not None and c.bounds(arb(0), arb(1.05 * reach)) is None


@pytest.mark.parametrize("alphas", ["1001/1000", f"{10**20 + 1}/{10**20}", "6/5", "2", "3", "6", "40", "1 2", "3/2 2"])
def test_the_reach_of_quarter_swings_in_doubles_is_about_that_in_balls(alphas):
    """Panels end well inside, so that there is room for an ellipse."""
    c = coordinate([(a, "1/4") for a in alphas.split()])
    reach, places = panel_plan.reach_of(c, whole=False), panel_plan.places_of(c, quartered=True)
    assert c.bounds(arb(0), arb(0.85 * reach), whole=False) is not None
    assert c.bounds(arb(0), arb(1.15 * reach), whole=False) is None
    assert 0 < places <= 0.8 * reach and farthest(c, 80, quartered=True).stretch > 1.3


@pytest.mark.parametrize("name", ["three weak powers", "a sum with an irrational power"])
def test_the_stretch_in_doubles_is_that_of_the_majorant(name):
    low, high, _ = PLACES[name]
    c = coordinate(WORLDS[name].pairs)
    first, last = sorted(float(c(arb(p))) for p in (low, high))
    axis = widest(c, (first + last) / 2, (last - first) / 2) * (last - first) / 2
    middle = arb((first + last) / 2)
    assert c.bounds(middle, arb(0.94 * axis)) is not None and c.bounds(middle, arb(1.06 * axis)) is None


@pytest.mark.parametrize(("growth", "excess"), [("0.5", "1e-6"), ("1e-9", "0.25"), ("1e-30", "1e-30")])
def test_the_nodes_are_the_fewest_for_both_cuts(growth, excess):
    ellipse = panel_plan.Ellipse(arb(3), SimpleNamespace(growth=arb(growth), excess=arb(excess)))
    count, fine = ellipse.nodes_for(50), arb(2) ** -50
    largest = ellipse.ratio_bound.max(arb(excess))
    assert cut(largest, ellipse.R, count) <= fine and (count == 1 or cut(largest, ellipse.R, count - 1) > fine)


@pytest.mark.parametrize("p", ["0", "1/2", "3", "17/2"])
def test_the_moment_in_doubles(p):
    power = parse_real(p, "p").ball()
    assert panel_plan._moment(float(power)) == pytest.approx(float(moment(power)), rel=1e-12)


def test_strong_drag_fades_as_the_averaged_law_says():
    """25 x'^3 takes 7/8 in the first half-swing, not all but 10^-13: the panel begins where its amplitudes are."""
    places = list(path(coordinate((("3", "25"),)), 0.0, 40))
    assert np.exp(places[1:]) == pytest.approx(
        [(1 + 2 * n * np.pi * 25 * 3 / 8) ** -0.5 for n in range(1, 40)], rel=1e-12
    )
    made = Panels.alone(Law({3: 25}), 60)
    p, n = arb(1), 0
    while made.half_swing(p, arb(0), 500 - n) is None and n < 9:
        p, n = (p * by_pieces((("3", "25"),), p, 60).amplitude).mid(), n + 1
    assert 0 < n < 9
