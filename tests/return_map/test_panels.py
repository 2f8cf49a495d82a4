"""Half-swings by interpolation: the pieces at many bits are contained at few, on every kind of coordinate."""

import random

import pytest
from flint import arb, ctx

from asymptotics.errors import LimitError, UndecidedError
from asymptotics.flow.damping import Damping
from asymptotics.law import Law
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.powers import exact_power
from asymptotics.return_map import half_swings, panels
from asymptotics.return_map.half_swing_map import ROUTE, integrated
from asymptotics.return_map.panel_plan import PanelPlan, between, from_zero, verified
from asymptotics.return_map.panels import Panels, ReturnMap, laid_out, map_of, panels_of
from asymptotics.return_map.ray import ray_of
from asymptotics.running.budget import budget
from asymptotics.turning.choose import turning_points
from tests.return_map.laws import by_pieces, coordinate, placed_worlds


class Placed:
    """A panel laid out for amplitudes, and its half-swings from them."""

    def __init__(self, pairs, low, high, stretch, bits):
        self.z = coordinate(pairs)
        ends = [0.0 if low == 0 else float(self.z(arb(low))), float(self.z(arb(high)))]
        first, last = sorted(ends)
        spare = 0.001 * (last - first)
        plan = PanelPlan(0.0 if first == 0 else first - spare, last + spare, stretch, 0)
        self.panel = laid_out(self.z, plan, bits)

    def half_swing(self, p, error=None):
        return self.panel.half_swing(self.z(p), self.z(p if error is None else arb(p, error)))


@pytest.mark.parametrize(("pairs", "low", "high", "stretch"), placed_worlds())
def test_a_ladder_of_panels(pairs, low, high, stretch):
    places = [arb(low + (high - low) * share).mid() for share in (0.01, 0.993)]
    truth = [by_pieces(pairs, p, 90) for p in places]
    for bits in (12, 36):
        placed = Placed(pairs, low, high, stretch, bits)
        for p, sharp in zip(places, truth, strict=True):
            with ctx.workprec(bits):
                found = placed.half_swing(p)
            assert found.amplitude.contains(sharp.amplitude) and found.duration.contains(sharp.duration), bits
            assert found.amplitude.rad() < arb(2) ** (14 - bits) and found.duration.rad() < arb(2) ** (15 - bits)
            assert found.tail >= placed.panel.ratio.error


@pytest.mark.parametrize(
    ("pairs", "low", "high", "stretch"),
    placed_worlds("another rational power", "two powers above one", "three weak powers"),
)
def test_the_duration_is_that_of_all_amplitudes_nearby(pairs, low, high, stretch):
    placed = Placed(pairs, low, high, stretch, 30)
    p, error = arb((low + high) / 2).mid(), arb(2) ** -10
    with ctx.workprec(30):
        found, narrow = placed.half_swing(p, error), placed.half_swing(p)
    for other in (p - error, p + error):
        assert found.duration.contains(by_pieces(pairs, other.mid(), 60).duration)
    gap = abs(by_pieces(pairs, (p + error).mid(), 60).duration - narrow.duration).upper()
    assert found.duration.rad() < 20 * gap + arb(2) ** -26 and found.amplitude.overlaps(narrow.amplitude)


def test_only_the_places_of_the_panel_are_served():
    panel = laid_out(coordinate((("1/2", "1/100"),)), PanelPlan(0.25, 1.0, 8.0, 0), 30)
    assert panel.holds(arb(1)) and panel.holds(arb("0.25")) and panel.holds(arb("0.625", "0.374"))
    assert not panel.holds(arb("0.625", "0.376")) and not panel.holds(arb("0.2499")) and not panel.holds(arb("1.001"))


@pytest.mark.parametrize("quartered", [True, False])
def test_an_amplitude_that_may_be_0_has_no_half_swing(quartered):
    panels = Panels.alone(Law({2: "1/10"}), 30)
    panels.map.quartered = quartered
    assert panels.half_swing(arb(2) ** -400, arb(0), 1000) is not None
    assert panels.half_swing(arb("0.125"), arb("0.0625"), 1000) is not None
    assert panels.half_swing(arb("0.125"), arb("0.125"), 1000) is None
    # So uncertain that the ends of the half-swings may lie outside the interval of the quarters: by pieces.
    assert (panels.half_swing(arb("0.125"), arb("0.124"), 1000) is None) == quartered


@pytest.mark.parametrize("exponents", [{"1/2": "1/500"}, {"2": "1/5"}, {"1/2": "1/500", 1: "1/500"}])
def test_a_panel_that_is_not_proved_is_not_handed_out(monkeypatch, exponents):
    """By pieces instead, and without another attempt for the same places."""
    tried = []

    def refused(*given):
        tried.append(given)
        raise UndecidedError("no")

    monkeypatch.setattr(panels, "laid_out", refused)
    monkeypatch.setattr(half_swings.HalfSwings, "up_to", refused)
    made = Panels.alone(Law(exponents), 60)
    assert made.half_swing(arb(1), arb(0), 1000) is None
    first = len(tried)
    assert first == 1 and made.half_swing(arb(1), arb(0), 1000) is None
    # Where quarters do not serve, panels by pieces are tried, once.
    assert len(tried) == 1 + made.collocated and made.half_swing(arb(1), arb(0), 1000) is None
    assert len(tried) == 1 + made.collocated


def check(seed):
    draw = random.Random(seed)
    exponents = draw.sample(("0", "1/3", "1/2", "1", "3/2", "sqrt(2)", "2", "5/2", "3", "7"), draw.choice((1, 1, 2, 3)))
    pairs = tuple((a, f"{draw.randint(1, 60)}/3000") for a in exponents)
    low = draw.choice((0.25, 0.5, 0.75))
    placed = Placed(pairs, low, 1.0, 2.0, 40)
    for _ in range(3):
        p = arb(draw.uniform(low, 1)).mid()
        with ctx.workprec(40):
            found = placed.half_swing(p)
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


def served(panels, bits, sizes, remaining=1000, error=0):
    """Half-swings at amplitudes by a map, at a precision."""
    with ctx.workprec(bits):
        return [panels.half_swing(arb(size).mid(), arb(error), remaining) for size in sizes]


@pytest.mark.parametrize(
    "law",
    [{"3/2": "1/5"}, {"3/2": "1/7"}, {1: "1/20", 3: "1/6"}, {"3/2": "1/5", 2: "1/10"}, {"1/2": "1/900"}],
    ids=str,
)
def test_half_swings_of_a_map_contain_the_pieces_of_every_law_of_its_ray(law):
    """One map for the law and for those in other units of amplitude: at a few bits, against pieces at many."""
    kept = ReturnMap(ray_of(Law(law))[0], 48)
    for other in (Law(law), grown(Law(law))):
        panels = Panels(other, kept)
        pairs = [(str(t.velocity), str(t.strength)) for t in other.terms]
        found = served(panels, 40, (0.9, 0.3, 1e-3))
        for size, swing in zip((0.9, 0.3, 1e-3), found, strict=True):
            sharp = by_pieces(pairs, arb(size).mid(), 80)
            assert swing is not None and swing.route == ROUTE
            assert swing.amplitude.contains(sharp.amplitude) and swing.duration.contains(sharp.duration)
            assert swing.amplitude.rad() < arb(2) ** -30 and swing.duration.rad() < arb(2) ** -28
    assert len(kept.made) == 1


def grown(law):
    """The law in nine times its unit of amplitude: epsilon_i 9^(1 - alpha_i), exact for multiples of 1/2."""
    return Law({t.velocity: t.strength * exact_power(ExactReal(9), 1 - t.velocity) for t in law.terms})


def test_strengths_of_one_exponent_have_one_map_and_other_exponents_another():
    one, other = panels_of(Law({"3/2": "1/5"}), 60), panels_of(Law({"3/2": "1/9"}), 62)
    assert one.map is other.map and one.map is not panels_of(Law({"3/2": "1/5"}), 90).map
    assert one.map is not panels_of(Law({"8/5": "1/5"}), 60).map and panels_of(Law({1: "1/5"}), 60).map is None


def test_a_map_is_made_when_what_it_missed_repays_it():
    """Two half-swings of one law do not, those of many laws do; what is there serves a single half-swing."""
    made = Panels.alone(Law({"3/2": "1/5"}), 60)
    work = from_zero(made.map.coordinate, 0.2, made.map.bits, quartered=True).work(True)
    found = [served(made, 60, [1], 2)[0] for _ in range(work)]
    assert work > 4 and [swing is None for swing in found].index(False) == (work - 2) // 2
    assert served(made, 60, [0.5], 1)[0] is not None and len(made.map.made) == 1


@pytest.mark.parametrize(("count", "held"), [(1000, True), (40, False)])
def test_who_asks_much_pays_for_stronger_laws_to_come(count, held):
    """The panel of a first strength holds one 1.3 times as large as it must, but not where little is asked for."""
    made = Panels.alone(Law({"9/7": "1/10"}), 60)
    short, long = (from_zero(made.map.coordinate, 0.1, made.map.bits, quartered=True, long=long) for long in (0, 1))
    with ctx.workprec(60):
        assert made.half_swing(arb(1), arb(0), count) is not None
    assert 0.1 < 1.3 * short.last < long.last
    (panel,) = made.map.made
    assert panel.holds(arb(short.last)) and panel.holds(arb(1.3 * short.last)) is held


def test_a_map_is_bounded():
    made = Panels.alone(Law({0: "1/900", 2: "1/100"}), 30).map
    assert made.made.maxlen == panels._PANELS and map_of.cache_info().maxsize == panels._MAPS
    assert panels_of.cache_info().maxsize == panels._LAWS


@pytest.mark.parametrize("order", [1, -1])
@pytest.mark.parametrize(
    "law", [{"3/2": "1/4"}, {"1/2": "1/80"}, {1: "1/20", 2: "1/9"}, {0: "1/900", 2: "1/50"}], ids=str
)
def test_the_answer_does_not_depend_on_what_was_asked_before(law, order):
    """Digits, words and the end: of a process that has no map, and of one that other questions have filled."""
    asked = [(Law(law), 3, 12), (Law(law), 60, 12), (Law(law), 4, 20)]
    fresh = []
    for question in asked[::order]:
        map_of.cache_clear(), panels_of.cache_clear()
        fresh.append(turning_points(*question, times=True))
    for _ in range(2):
        again = [turning_points(*question, times=True) for question in asked[::order]]
        assert [table.to_dict() for table in again] == [table.to_dict() for table in fresh]


def test_where_the_time_is_over_the_map_is_not_to_blame():
    made = Panels.alone(Law({"3/2": "1/5"}), 60)
    with pytest.raises(LimitError, match="max_seconds"), budget(0):
        served(made, 60, [1])
    assert made.map.quartered and not made.map.refused and served(made, 60, [1])[0] is not None


def test_the_bounds_of_a_panel_are_those_of_its_ellipse(monkeypatch):
    """e^G - 1 for q/p - 1 and the excess for T - pi, with the majorant of the ellipse that is verified."""
    seen, honest = [], panels.interpolant
    monkeypatch.setattr(panels, "interpolant", lambda v, M, *more: seen.append(M) or honest(v, M, *more))
    z = coordinate((("2", "1/5"),))
    laid_out(z, PanelPlan(0.0, 1.0, 3.0, 0), 20)
    with ctx.workprec(52):
        ellipse = verified(z, arb(0.5), arb(0.5), 3.0)
    G, excess = ellipse.majorant.growth, ellipse.majorant.excess
    assert all(a >= b * arb("0.98") for a, b in zip(seen, (G.expm1(), excess), strict=True))
    assert ellipse.ratio_bound >= G.expm1() and ellipse.ratio_bound <= G.expm1() * arb("1.001")
    assert G.expm1() > G * arb("1.15")


def test_a_plan_that_does_not_come_true_is_made_anew(monkeypatch):
    made = Panels.alone(Law({0: "1/900", 3: "1/10"}), 60).map
    monkeypatch.setattr(panels, "between", lambda *_: PanelPlan(1.0, 2.0, 1e6, 5, 400, 2))
    assert made.panel(arb(6), 500) is None and made.panel(arb("5.9"), 490) is None
    monkeypatch.setattr(panels, "between", between)
    assert made.panel(arb("5.9"), 488) is None and made.planned_for == (6.0, 500)  # 12 have passed: not yet
    assert made.panel(arb("5.9"), 487) is not None


def test_where_quarters_do_not_serve_the_pieces_do(monkeypatch):
    def refused(laws, bits):
        raise UndecidedError("no")

    law = Law({"3/2": "1/50", "sqrt(2)": "1/50"})
    plan = PanelPlan(-1.5, -1.25, 20.0, 0)
    z = coordinate([(str(t.velocity), str(t.strength)) for t in law.terms])
    found = [laid_out(z, plan, 40)]
    monkeypatch.setattr(half_swings, "quarter_swings", refused)
    found.append(laid_out(z, plan, 40))
    with ctx.workprec(40):
        one, other = (panel.half_swing(arb("-1.375"), arb("-1.375")) for panel in found)
    assert one.amplitude.overlaps(other.amplitude) and one.duration.overlaps(other.duration)
    assert found[0].ratio.error != found[1].ratio.error


def test_amplitudes_that_no_double_holds_have_panels():
    """1 +- 10^-20 at 2^-1500: a panel holds what a step at twice the precision finds."""
    law, p = Law({f"1.{'0' * 19}1": "1/20", f"0.{'9' * 20}": "1/20"}), arb(2) ** -1500
    pairs = [(t.velocity, t.strength) for t in law.terms]
    made = Panels.alone(law, 60)
    with ctx.workprec(60):
        found = made.half_swing(p, arb(0), 200)
        assert found is not None and made.half_swing(p / 2, arb(0), 1) is not None
        assert made.half_swing(arb(2) ** -1490, arb(0), 1) is None
    with ctx.workprec(160):
        sharp = integrated(Damping.of([(e.ball() * p ** (a - 1).ball(), a) for a, e in pairs]), arb(1))
    assert found.amplitude.contains(sharp.amplitude) and found.duration.contains(sharp.duration)
    assert found.amplitude.rad() < 1e-15
    assert made.pieces(100_000) < 5000  # each half-swing takes a seventh: 22,000 bits


def test_what_half_swings_are_worth_holds_the_nodes():
    short, long = (Panels.alone(Law({"1/2": "1/500"}), 40).pieces(n) for n in (5, 60))
    assert short == 5 and 10 < long < 60 and Panels.alone(Law({1: 3}), 40).pieces(7) == 7


def test_the_panel_next_to_the_reach_is_made_for_what_no_other_holds():
    """A strong start alone does not repay it, however many half-swings follow: those have a cheaper one."""
    made = Panels.alone(Law({"3/2": "4/5"}), 60)
    assert served(made, 60, [1], 1000) == [None] and served(made, 60, [0.4], 1000)[0] is not None
    while served(made, 60, [1], 1000)[0] is None:
        assert made.map.missed[max(made.map.missed, key=lambda plan: plan.last)] < 100
    assert len(made.map.made) == 2
    sharp = by_pieces((("3/2", "4/5"),), arb(1), 90)
    found = served(made, 60, [1])[0]
    assert found.amplitude.contains(sharp.amplitude) and found.duration.contains(sharp.duration)
    assert found.amplitude.rad() < arb(2) ** -45


def test_the_durations_of_a_map_are_those_of_every_amplitude_within_the_error():
    """And not those of half of it: the times of both ends lie inside, and outside the ball of half the error."""
    made, e = Panels.alone(Law({2: "1/5"}), 60), arb(2) ** -12
    with ctx.workprec(60):
        found = made.half_swing(arb(1), e, 1000)
        half = made.half_swing(arb(1), e / 2, 1000)
        alone = made.half_swing(arb(1), arb(0), 1000)
    assert found.amplitude.mid() == alone.amplitude.mid() and found.amplitude.rad() == alone.amplitude.rad()
    for end in (1 - e, 1 + e):
        assert found.duration.contains(by_pieces((("2", "1/5"),), end, 80).duration)
    # The two quarters change their times against each other, and the ball adds both changes: that of one quarter.
    z, step = made.place(arb(1)), made.place(1 + e) - made.place(arb(1))
    quarter = made.map.made[0].forwards
    with ctx.workprec(60):
        change = abs(quarter.duration(quarter.place(z + step)) - quarter.duration(quarter.place(z))).mid()
    assert half.duration.rad() < 1.2 * change < found.duration.rad()
