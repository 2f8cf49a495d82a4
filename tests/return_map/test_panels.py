"""Half-swings by interpolation: the pieces at many bits are contained at few, on every kind of coordinate."""

import random
from types import SimpleNamespace

import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.flow.damping import Damping
from asymptotics.law import Law
from asymptotics.return_map import half_swings, panels
from asymptotics.return_map.half_swing_map import integrated
from asymptotics.return_map.panel_plan import PanelPlan, planned, verified
from asymptotics.return_map.panels import Panel, Panels, laid_out
from tests.return_map.laws import LAWS, by_pieces, coordinate


@pytest.mark.parametrize(("pairs", "low", "high", "stretch"), LAWS, ids=str)
def test_a_ladder_of_panels(pairs, low, high, stretch):
    places = [arb(low + (high - low) * share).mid() for share in (0.01, 0.993)]
    truth = [by_pieces(pairs, p, 90) for p in places]
    for bits in (12, 36):
        panel = laid_out(coordinate(pairs), PanelPlan(low, high, stretch, 0, 0, 0), bits)
        for p, sharp in zip(places, truth, strict=True):
            with ctx.workprec(bits):
                found = panel.half_swing(p)
            assert found.amplitude.contains(sharp.amplitude) and found.duration.contains(sharp.duration), bits
            assert found.amplitude.rad() < arb(2) ** (14 - bits) and found.duration.rad() < arb(2) ** (15 - bits)
            assert found.tail >= panel.ratio.error


@pytest.mark.parametrize(("pairs", "low", "high", "stretch"), LAWS[:5:2], ids=str)
def test_the_duration_is_that_of_all_amplitudes_nearby(pairs, low, high, stretch):
    panel = laid_out(coordinate(pairs), PanelPlan(low, high, stretch, 0, 0, 0), 30)
    p, error = arb((low + high) / 2).mid(), arb(2) ** -10
    with ctx.workprec(30):
        found, narrow = panel.half_swing(p, error), panel.half_swing(p)
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


def test_a_panel_that_is_not_proved_is_not_handed_out(monkeypatch):
    """By pieces instead, and without another attempt for smaller amplitudes."""
    tried = []

    def refused(*given):
        tried.append(given)
        raise UndecidedError("no")

    monkeypatch.setattr("asymptotics.return_map.panels.laid_out", refused)
    made = Panels(Law({2: "1/5"}), 60)
    assert [made.serving(arb(size), arb(0), 100) for size in (1, 0.5)] == [None, None] and len(tried) == 1


def check(seed):
    draw = random.Random(seed)
    exponents = draw.sample(("0", "1/3", "1/2", "1", "3/2", "sqrt(2)", "2", "5/2", "3", "7"), draw.choice((1, 1, 2, 3)))
    pairs = tuple((a, f"{draw.randint(1, 60)}/3000") for a in exponents)
    low = draw.choice((0.25, 0.5, 0.75))
    panel = laid_out(coordinate(pairs), PanelPlan(low, 1.0, 2.0, 0, 0, 0), 40)
    for _ in range(3):
        p = arb(draw.uniform(low, 1)).mid()
        with ctx.workprec(40):
            found = panel.half_swing(p)
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


def test_a_plan_that_does_not_come_true_is_made_anew(monkeypatch):
    made = Panels(Law({3: "1/10"}), 60)
    monkeypatch.setattr(panels, "planned", lambda *_: PanelPlan(0.0, 1e-4, 1e6, 5, 400, 2))
    assert made.serving(arb(1), arb(0), 500) is None and made.serving(arb("0.9"), arb(0), 490) is None
    monkeypatch.setattr(panels, "planned", planned)
    assert made.serving(arb("0.9"), arb(0), 488) is None and made.planned_for == (1.0, 500)  # 12 have passed: not yet
    assert made.serving(arb("0.9"), arb(0), 487) is not None


def test_a_panel_holds_no_amplitude_that_may_be_0():
    panel = SimpleNamespace(unit=arb(1), low=arb(-1), high=arb(2))
    assert Panel.holds(panel, arb("0.5"), arb("0.25")) and not Panel.holds(panel, arb("0.5"), arb("0.75"))


def test_where_quarters_do_not_serve_the_pieces_do(monkeypatch):
    def refused(laws, bits):
        raise UndecidedError("no")

    law, plan = coordinate((("2", "1/5"),)), PanelPlan(0.0, 0.25, 20.0, 0, 0, 0)
    found = [panels.laid_out(law, plan, 40)]
    monkeypatch.setattr(half_swings, "quarter_swings", refused)
    found.append(panels.laid_out(law, plan, 40))
    with ctx.workprec(40):
        one, other = (panel.half_swing(arb("0.125")) for panel in found)
    assert one.amplitude.overlaps(other.amplitude) and one.duration.overlaps(other.duration)
    assert found[0].ratio.error != found[1].ratio.error


def test_amplitudes_that_no_double_holds_have_panels():
    """1 +- 10^-20 at 2^-1500: a panel in units of 2^-1024 holds what a step at twice the precision finds."""
    law, p = Law({f"1.{'0' * 19}1": "1/20", f"0.{'9' * 20}": "1/20"}), arb(2) ** -1500
    pairs = [(t.velocity, t.strength) for t in law.terms]
    made = Panels(law, 60)
    with ctx.workprec(60):
        panel = made.serving(p, arb(0), 200)
        assert panel is not None and panel.unit == arb(2) ** -1024 and made.serving(p / 2, arb(0), 1) is panel
        assert made.serving(arb(2) ** -1490, arb(0), 1) is None
        found = panel.half_swing(p)
    with ctx.workprec(160):
        sharp = integrated(Damping.of([(e.ball() * p ** (a - 1).ball(), a) for a, e in pairs]), arb(1))
    assert found.amplitude.contains(sharp.amplitude) and found.duration.contains(sharp.duration)
    assert found.amplitude.rad() < 1e-15
    assert made.pieces(100_000) < 5000  # each half-swing takes a seventh: 22,000 bits, in 44 units
