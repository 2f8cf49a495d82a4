"""Half-swings by interpolation: the pieces at many bits are contained at few, on every kind of coordinate."""

import random
from types import SimpleNamespace

import mpmath
import numpy as np
import pytest
from flint import arb, ctx
from scipy.integrate import solve_ivp

from asymptotics.errors import UndecidedError
from asymptotics.expansions.moments.certified import moment
from asymptotics.flow.damping import Damping
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_real
from asymptotics.return_map import panel_plan, panels
from asymptotics.return_map.chebyshev import cut
from asymptotics.return_map.coordinate import Coordinate
from asymptotics.return_map.half_swing_map import integrated
from asymptotics.return_map.panel_plan import PanelPlan, planned, verified
from asymptotics.return_map.panels import Panels, laid_out


def coordinate(pairs):
    with ctx.workprec(300):
        return Coordinate.of([(parse_real(e, "e").ball(), parse_real(a, "a")) for a, e in pairs])


def by_pieces(pairs, p, bits):
    with ctx.workprec(bits + 40):
        law = Damping.of([(parse_real(e, "e").ball(), parse_real(a, "a")) for a, e in pairs])
    with ctx.workprec(bits):
        return integrated(law, p)


LAWS = [
    ((("3/2", "1/5"),), 0.0, 0.75, 3.0),
    ((("1", "1/20"), ("2", "1/5")), 0.0, 0.5, 4.0),
    ((("2", "1/10"), ("3", "1/30")), 0.0, 0.5, 3.0),
    ((("1/2", "1/100"),), 0.25, 1.0, 8.0),
    ((("0", "1/500"), ("1", "1/50"), ("2", "1/10")), 0.25, 0.5, 2.5),
    ((("sqrt(2)", "1/20"), ("2", "1/20")), 0.25, 0.5, 3.0),
    ((("0", "1/1000"),), 0.5, 1.0, 8.0),
    ((("1", "1/7"),), 0.0, 1.0, 1e6),
]


@pytest.mark.parametrize(("pairs", "low", "high", "stretch"), LAWS, ids=str)
def test_a_ladder_of_panels(pairs, low, high, stretch):
    places = [arb(low + (high - low) * share).mid() for share in (0.01, 0.993)]
    truth = [by_pieces(pairs, p, 90) for p in places]
    for bits in (12, 36):
        panel = laid_out(coordinate(pairs), PanelPlan(low, high, stretch, 0, 0, 0), bits)
        for p, sharp in zip(places, truth, strict=True):
            with ctx.workprec(bits):
                found = panel.passage(p)
            assert found.amplitude.contains(sharp.amplitude) and found.duration.contains(sharp.duration), bits
            assert found.amplitude.rad() < arb(2) ** (14 - bits) and found.duration.rad() < arb(2) ** (15 - bits)
            assert found.tail >= panel.ratio.error


@pytest.mark.parametrize(("pairs", "low", "high", "stretch"), LAWS[:5:2], ids=str)
def test_the_duration_is_that_of_all_amplitudes_nearby(pairs, low, high, stretch):
    panel = laid_out(coordinate(pairs), PanelPlan(low, high, stretch, 0, 0, 0), 30)
    p, error = arb((low + high) / 2).mid(), arb(2) ** -10
    with ctx.workprec(30):
        found, narrow = panel.passage(p, error), panel.passage(p)
    for other in (p - error, p + error):
        assert found.duration.contains(by_pieces(pairs, other.mid(), 60).duration)
    gap = abs(by_pieces(pairs, (p + error).mid(), 60).duration - narrow.duration).upper()
    assert found.duration.rad() < 20 * gap + arb(2) ** -26 and found.amplitude.overlaps(narrow.amplitude)


def test_only_the_amplitudes_of_the_panel_are_served():
    panel = laid_out(coordinate((("1/2", "1/100"),)), PanelPlan(0.25, 1.0, 8.0, 0, 0, 0), 30)
    none = arb(0)
    assert panel.holds(arb(1), none) and panel.holds(arb("0.25"), none) and panel.holds(arb("0.5"), arb("0.25"))
    assert not panel.holds(arb("0.5"), arb("0.2501")) and not panel.holds(arb("0.2499"), none)
    assert not panel.holds(arb("1.001"), none) and not panel.holds(arb("1.0005"), arb("0.001"))
    from_zero = laid_out(coordinate((("2", "1/10"),)), PanelPlan(0.0, 1.0, 3.0, 0, 0, 0), 30)
    assert from_zero.holds(arb(2) ** -400, none) and not from_zero.holds(arb("0.1"), arb("0.1"))


@pytest.mark.parametrize(
    ("exponents", "root", "powers"),
    [
        (("3/2",), "1/2", ("1",)),
        (("1/2",), "-1/2", ("1",)),
        (("sqrt(2)",), "sqrt(2)", ("1",)),
        (("1",), "1", ("0",)),
        (("1", "2"), "1", ("0", "1")),
        (("2", "5/2", "1"), "1/2", ("2", "3", "0")),
        (("1/2", "1/4"), "-1/4", ("2", "3")),
        (("0", "2"), None, ("-1", "1")),
        (("sqrt(2)", "2"), None, ("sqrt(2)", "1")),
        (("1.01", "2"), None, ("0.01", "1")),
    ],
)
def test_the_coordinate_of_a_law(exponents, root, powers):
    found = coordinate(tuple((a, "1/10") for a in exponents))
    for value, text in zip((found.root, *found.powers), (root, *powers), strict=True):
        wanted = None if text is None else parse_real(text, "w").ball()
        if text is not None and text.startswith("sqrt"):
            wanted = wanted - 1
        assert (value is None) == (text is None) and (text is None or abs(value - wanted) < 1e-12)


@pytest.mark.parametrize(
    ("pairs", "middle", "half"), [(LAWS[1][0], 0.25, 0.6), (LAWS[4][0], -1.0, 0.9), (LAWS[5][0], -1, 0.5)]
)
def test_the_radii_hold_on_the_ellipse_and_no_less(pairs, middle, half):
    """|delta_i| at points of the ellipse, in complex doubles: the largest is the radius."""
    c = coordinate(pairs)
    bound = c.bounds(arb(middle), arb(half))
    angles = np.linspace(0, 2 * np.pi, 721)
    z = middle + half * np.cos(angles) + 1j * 0.8 * half * np.sin(angles)
    for radius, e, k in zip(bound.radii, c.epsilons, c.powers, strict=True):
        sizes = abs(float(e) * (np.exp(float(k) * z) if c.root is None else z ** float(k)))
        assert max(sizes) <= float(radius) * (1 + 1e-12) and float(radius) <= max(sizes) * (1 + 1e-9)


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


@pytest.mark.parametrize(("pairs", "middle", "half"), [(LAWS[1][0], 0.5, 1.0), (LAWS[4][0], -1.0, 1.2)])
def test_the_half_swing_at_complex_strengths_obeys_the_bounds(pairs, middle, half):
    """|q/p - 1| and |T - pi| on the ellipse by an ordinary integrator in complex numbers: below, and not far below."""
    c = coordinate(pairs)
    ellipse = verified(c, arb(middle), arb(half), 1.0001)
    largest = [0.0, 0.0]
    for angle in np.linspace(0, 2 * np.pi, 13):
        L, T = complex_half_swing(c, middle + half * (np.cos(angle) + 0.3j * np.sin(angle)))
        largest = [max(pair) for pair in zip(largest, (abs(np.exp(L) - 1), abs(T - np.pi)), strict=True)]
    for seen, bound in zip(largest, (ellipse.ratio_bound, ellipse.majorant.excess), strict=True):
        assert seen <= float(bound) <= 40 * seen


def test_a_panel_that_is_not_proved_is_not_handed_out(monkeypatch):
    """By pieces instead, and without another attempt for smaller amplitudes."""
    tried = []

    def refused(*given):
        tried.append(given)
        raise UndecidedError("no")

    monkeypatch.setattr("asymptotics.return_map.panels.laid_out", refused)
    made = Panels(Law({2: "1/5"}), 60)
    assert [made.serving(arb(size), arb(0), 100) for size in (1, 0.5)] == [None, None] and len(tried) == 1


def test_no_panel_is_planned_where_no_ellipse_is_wide_enough():
    assert planned(coordinate((("1", "1999/1000"), ("2", "1/10"))), 1.0, 200, 190) is None


def test_an_ellipse_that_reaches_too_far_is_made_smaller():
    c = coordinate((("2", "1/5"),))
    assert c.bounds(arb(1), arb(5)) is None and c.bounds(arb(-1), arb("0.1")) is None
    found = verified(c, arb("0.5"), arb("0.5"), 100.0)
    assert found.R > 5 and found.R < 12
    assert mpmath.almosteq(float(found.R + 1 / found.R) / 2 * 0.5 + 0.5, float(found.majorant.radii[0]) * 5, 1e-9)


def test_a_plan_saves_half_swings_or_is_none():
    c = coordinate((("1", "1/20"), ("2", "1/5")))
    short, long = planned(c, 1.0, 12, 120), planned(c, 1.0, 1000, 120)
    assert short is None and long is not None and long.nodes + long.wait < 100
    more = planned(c, 1.0, 1000, 400)
    assert more is not None and more.nodes > 2 * long.nodes
    half = coordinate((("1/2", "1/100"),))
    for count in (10, 60):  # all of them on one panel, the last amplitude included
        path = list(panel_plan._path(half, 1.0, count))
        plan = planned(half, 1.0, count, count)
        assert plan.served == count == len(path) and path[-1] * 0.95 < plan.low < path[-1] < path[0] == plan.high
    strong = planned(coordinate((("1", "3"),)), 1.0, 1000, 120)
    assert strong is None


@pytest.mark.parametrize("case", [0, 1, 2, 3, 6])
def test_the_reach_in_doubles_is_that_of_the_majorant(case):
    c = coordinate(LAWS[case][0])
    reach = panel_plan.reach_of(c)
    assert c.bounds(arb(0), arb(0.95 * reach)) is not None and c.bounds(arb(0), arb(1.05 * reach)) is None


@pytest.mark.parametrize("case", [4, 5])
def test_the_stretch_in_doubles_is_that_of_the_majorant(case):
    pairs, low, high, _ = LAWS[case]
    c = coordinate(pairs)
    first, last = sorted(float(c(arb(p))) for p in (low, high))
    axis = panel_plan._stretch(c, low, high) * (last - first) / 2
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


def check(seed):
    draw = random.Random(seed)
    exponents = draw.sample(("0", "1/3", "1/2", "1", "3/2", "sqrt(2)", "2", "5/2", "3", "7"), draw.choice((1, 1, 2, 3)))
    pairs = tuple((a, f"{draw.randint(1, 60)}/3000") for a in exponents)
    low = draw.choice((0.25, 0.5, 0.75))
    panel = laid_out(coordinate(pairs), PanelPlan(low, 1.0, 2.0, 0, 0, 0), 40)
    for _ in range(3):
        p = arb(draw.uniform(low, 1)).mid()
        with ctx.workprec(40):
            found = panel.passage(p)
        sharp = by_pieces(pairs, p, 80)
        assert found.amplitude.contains(sharp.amplitude) and found.duration.contains(sharp.duration), (seed, pairs)
        assert found.amplitude.rad() < arb(2) ** -24, (seed, pairs)


@pytest.mark.parametrize("seed", range(3))
def test_random_laws_at_twice_the_precision(seed):
    check(seed)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(100, 160))
def test_many_random_laws_at_twice_the_precision(seed):
    check(seed)


def test_the_panels_of_a_law_are_kept_and_extended():
    panels = Panels(Law({"1/2": "1/50"}), 40)
    with ctx.workprec(40):
        assert panels.serving(arb(1), arb(0), 3) is None and not panels.made
        first = panels.serving(arb(1), arb(0), 100)
        assert first is not None and panels.serving(arb(1), arb(0), 1) is first
        assert panels.serving(arb("0.0625"), arb("0.25"), 1) is None
    assert panels.pieces(100) < 100 and Panels(Law({1: 3}), 40).pieces(7) == 7


def test_a_disc_below_zero_is_no_polydisc():
    """|z| <= c + a holds for c >= 0 only: about a negative centre the far end is the other one."""
    z = coordinate((("2", "1/10"),))
    assert z.bounds(arb(-1), arb("0.5")) is None
    found = z.bounds(arb(1), arb("0.5"))
    assert found is not None and arb("0.15") <= found.radii[0] * arb("1.000001") and found.radii[0] < arb("0.151")


def test_the_bounds_of_a_panel_are_those_of_its_ellipse(monkeypatch):
    """e^G - 1 for q/p - 1 and the excess for T - pi, with the majorant of the ellipse that is verified."""
    seen, honest = [], panels.interpolant
    monkeypatch.setattr(panels, "interpolant", lambda v, M, *more: seen.append(M) or honest(v, M, *more))
    z = coordinate((("2", "1/5"),))
    laid_out(z, PanelPlan(0.0, 1.0, 3.0, 0, 0, 0), 20)
    with ctx.workprec(52):
        ellipse = verified(z, arb(0.5), arb(0.5), 3.0)
    G, excess = ellipse.majorant.growth, ellipse.majorant.excess
    assert all(a >= b * arb("0.98") for a, b in zip(seen, (G.expm1(), excess), strict=True))
    assert ellipse.ratio_bound >= G.expm1() and ellipse.ratio_bound <= G.expm1() * arb("1.001")
    assert G.expm1() > G * arb("1.15")


@pytest.mark.parametrize("pairs", [(("sqrt(3)", "1/10"),), (("1/2", "1/100"),), (("sqrt(2)", "1/20"), ("2", "1/20"))])
def test_the_ends_of_a_panel_enclose_the_images(pairs):
    """53 bits, rounded outwards: none of its amplitudes falls outside [-1, 1]."""
    z = coordinate(pairs)
    first, last = panels._outwards(z, arb(1) / 3, arb(6) / 7)
    with ctx.workprec(200):
        ends = sorted((coordinate(pairs)(p) for p in (arb(1) / 3, arb(6) / 7)), key=float)
        assert first < ends[0] and ends[1] < last and first > ends[0] - arb(2) ** -50 and last < ends[1] + arb(2) ** -50


def test_strong_drag_fades_as_the_averaged_law_says():
    """25 x'^3 takes 7/8 in the first half-swing, not all but 10^-13: the panel begins where its amplitudes are."""
    path = list(panel_plan._path(coordinate((("3", "25"),)), 1.0, 40))
    assert path[1:] == pytest.approx([(1 + 2 * n * np.pi * 25 * 3 / 8) ** -0.5 for n in range(1, 40)], rel=1e-12)
    made = Panels(Law({3: 25}), 60)
    p, n = arb(1), 0
    while made.serving(p, arb(0), 500 - n) is None and n < 9:
        p, n = (p * by_pieces((("3", "25"),), p, 60).amplitude).mid(), n + 1
    assert n < 9 and made.made[0].high > 0.05


def test_a_plan_that_does_not_come_true_is_made_anew(monkeypatch):
    made = Panels(Law({3: "1/10"}), 60)
    monkeypatch.setattr(panels, "planned", lambda *_: PanelPlan(0.0, 1e-4, 1e6, 5, 400, 2))
    assert made.serving(arb(1), arb(0), 500) is None and made.serving(arb("0.9"), arb(0), 490) is None
    monkeypatch.setattr(panels, "planned", planned)
    assert made.serving(arb("0.9"), arb(0), 488) is None and made.planned_for == (1.0, 500)  # 12 have passed: not yet
    assert made.serving(arb("0.9"), arb(0), 487) is not None
