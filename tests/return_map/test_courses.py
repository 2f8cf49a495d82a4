"""States within half-swings off their quarters: they contain the pieces, and each bound is held to its constant."""

from dataclasses import replace

import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.flow.damping import Damping
from asymptotics.flow.dense import states
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.trajectory import half_swing_pieces
from asymptotics.law import Law, Oscillator
from asymptotics.motions.reference import reference_states
from asymptotics.numbers.exact import ExactReal
from asymptotics.return_map import courses as module
from asymptotics.return_map import hand_overs
from asymptotics.return_map import panels as panels_module
from asymptotics.return_map import sequence as sequence_module
from asymptotics.return_map.chebyshev import cut, nodes
from asymptotics.return_map.course import Course
from asymptotics.return_map.courses import Along, Courses
from asymptotics.return_map.half_swings import HalfSwings
from asymptotics.return_map.hand_overs import HAND_OVERS, Bundle, _Start
from asymptotics.return_map.panel_plan import verified, widest
from asymptotics.return_map.panels import panels_of
from asymptotics.return_map.quarters import Path
from asymptotics.return_map.sequence import Interpolated
from tests.return_map.laws import coordinate

PLACE = arb("0.46875")


def course(law, place, bits):
    """The half-swing from X = 1."""
    courses, swings = Courses.up_to(law, arb("0.5"), bits), HalfSwings.up_to(law, arb("0.5"), bits)
    ratio, duration = swings(place)
    after = courses.quarter(-place * ratio**law.root)
    return Course.of(courses.quarter(place), after, arb(1), ratio, duration, law.damping(place))


def stated(law, place, times, bits):
    """The true states, by pieces at more bits."""
    found = []
    with ctx.workprec(bits):
        for piece in half_swing_pieces(LinearSpring(law.damping(place)), arb(1), arb(0)):
            for t in times[len(found) :]:
                if t <= piece.end:
                    found.append([x + arb(0, piece.error) for x in piece.own(t)])
    return found


@pytest.mark.parametrize("pairs", [(("3/2", "1/5"),), (("2", "1/5"),), (("3", "1/20"), ("7", "1/4"))])
def test_states_contain_the_pieces(pairs):
    law = coordinate(pairs)
    times = [arb(k) / 16 for k in range(3, 48)]
    truth = stated(law, PLACE, times, 130)
    for bits in (10, 40, 70):
        with ctx.workprec(bits + 20):
            swing = course(law, PLACE, bits)
            assert swing.begin < times[0] and times[-1] < swing.end
            for t, (u, w), (place, speed) in zip(times, truth, swing.states(times), strict=True):
                assert place.contains(u) and speed.contains(w), (bits, t)
                assert max(place.rad(), speed.rad()) < arb(2) ** (9 - bits)


def test_a_quarter_at_an_uncertain_place_contains_both_ends():
    courses = Courses.up_to(coordinate((("2", "1/5"),)), arb("0.5"), 40)
    with ctx.workprec(60):
        wide, ends = courses.quarter(arb("0.25", "0.001")), [courses.quarter(arb(z)) for z in ("0.249", "0.251")]
        for t in (arb(-1), arb("0.25"), arb(1)):
            for one in ends:
                assert wide.ln_r(t).contains(one.ln_r(t).mid()) and wide.time(t).contains(one.time(t).mid())


def test_coefficients_that_are_dropped_count():
    """A single T_3(z) T_2(t), smaller than what matters: it is dropped, in either direction, and all of it counts."""
    c = arb(2) ** -30
    with ctx.workprec(100):
        for rows, fine in (([[arb(0), arb(0), c * (4 * z**3 - 3 * z)] for z in nodes(6)], 2 * c),
                           ([[arb(1), arb(0), c] for _ in nodes(6)], 2 * c)):  # fmt: skip
            along = Along.of(rows, arb(0), fine)
            assert c <= along.error < arb("1.001") * c and along.table.nrows() == 1
            assert Along.of(rows, arb(0), c / 2).error < c / 1000
            assert Along.of(rows, 5 * c, fine).error >= 6 * c


@pytest.mark.parametrize("degree", [1, 4, 9])
def test_an_uncertain_place_counts_by_markovs_inequality(degree):
    """|T_l'| = l^2 at the end of the interval: it is attained there."""
    with ctx.workprec(100):
        polynomial = [arb(0)] * degree + [arb(1)]
        T = lambda z: arb.chebyshev_t(z, degree)  # noqa: E731
        along = Along.of([[T(z)] for z in nodes(len(polynomial) + 2)], arb(0), arb(2) ** -90)
        r = arb(2) ** -20
        value, error = along.at(arb(1 - r, r))
        missed = abs(T(arb(1)) - value(arb(0)))
        assert missed <= error and error / 2 < missed


def test_the_errors_are_made_of_their_parts(monkeypatch):
    """The cut of the nodes of z, and sqrt(2m - 1) times what the ways are off by at a node."""
    law, last, apart, late = coordinate((("2", "1/5"),)), arb("0.5"), arb(2) ** -22, arb(2) ** -24
    monkeypatch.setattr(Path, "errors", lambda *_: (apart, late))
    with ctx.workprec(64):
        found = Courses.up_to(law, last, 40)
        ellipse = verified(law, arb(0), last, module._SHARE * widest(law, 0.0, 0.5, whole=False), whole=False)
        m = ellipse.nodes_for(40)
        m += m % 2
        for one, off, bound in (
            (found.growth, apart, ellipse.majorant.growth),
            (found.clock, late, ellipse.majorant.excess),
        ):
            expected = cut(bound, ellipse.R, m) + arb(2 * m - 1).sqrt() * off
            assert expected <= one.error < arb("1.001") * expected
        # Few nodes: the cut is what is seen.
        monkeypatch.setattr(Path, "errors", lambda *_: (arb(0), arb(0)))
        monkeypatch.setattr(type(ellipse), "nodes_for", lambda *_: 4)
        few = Courses.up_to(law, last, 40)
        assert cut(ellipse.majorant.growth, ellipse.R, 4) <= few.growth.error
        assert cut(ellipse.majorant.excess, ellipse.R, 4) <= few.clock.error
        assert few.growth.error < arb("1.001") * cut(ellipse.majorant.growth, ellipse.R, 4)
        assert few.clock.error < arb("1.001") * cut(ellipse.majorant.excess, ellipse.R, 4)


def test_hand_overs_at_one_angle_and_what_is_missed_counts(monkeypatch):
    law = coordinate((("2", "1/5"),))
    with ctx.workprec(84):
        laws = [(law.damping(arb(z)), side) for z in ("0.5", "0.25") for side in (1, -1)]
        exact = Bundle.together(laws)
        assert all(h == exact.h[0] and h.rad() == 0 for h in exact.h) and exact.dz < arb(2) ** -76
        monkeypatch.setattr("asymptotics.return_map.hand_overs._SECANTS", 0)
        rough = Bundle.together(laws)
        assert rough.h == exact.h and rough.dz > arb(2) ** -20
        w = (hand_overs._hand_over(laws) / hand_overs._LATER * arb(-0.25).exp()).mid()
        missed = max((abs(_Start.of(*one, arb(HAND_OVERS[0])).at(w)[0] - exact.h[0]) for one in laws), key=float)
        assert 2 * missed <= rough.dz < arb("2.001") * missed


def poor(honest, e):
    """A course whose first quarter is read off at times that are e too early."""
    first = honest.before.near

    class Poor:
        time = honest.before.time
        near = staticmethod(lambda times: first([s - e for s in times]))

    return replace(honest, before=Poor())


def test_a_poor_place_on_a_quarter_is_paid_for():
    """A t that is off by a time e: what the rates change in it, e^2/2 of them, is held, and half of that refuted."""
    law, e = coordinate((("2", "1/5"),)), arb(2) ** -12
    with ctx.workprec(84):
        honest = course(law, PLACE, 60)
        # Next to rest the place is off by most, at the centre the speed.
        for part, t in enumerate(((honest.begin + 2 * e).mid(), (honest.centre - e).mid())):
            (true,), (wrong,) = honest.states([t]), poor(honest, e).states([t])
            assert wrong[0].contains(true[0]) and wrong[1].contains(true[1])
            missed, radius = abs(wrong[part].mid() - true[part].mid()), wrong[part].rad()
            assert radius / 2 < missed and radius < e**2


def test_where_the_speed_may_vanish_on_the_way_the_largest_rate_serves():
    """A t so poor that w - |d| f < 0: the power of w has no value there."""
    law = coordinate((("2", "1/100"),))
    with ctx.workprec(84):
        honest = course(law, PLACE, 60)
        e = (honest.begin * 2).mid()
        t = (honest.begin * 3).mid()
        ((true, speed),), ((place, w),) = honest.states([t]), poor(honest, e).states([t])
        assert place.contains(true) and w.contains(speed) and w.rad() < 2 * e


def test_an_uncertain_time_moves_a_state_by_its_width():
    """At the centre by nearly p times half the width: both ends are held, and half of the radius is refuted."""
    law, e = coordinate((("2", "1/100"),)), arb(2) ** -20
    with ctx.workprec(84):
        swing = course(law, PLACE, 60)
        t = (swing.centre - arb(2) ** -10).mid()
        ((wide, w),) = swing.states([arb(t, e)])
        for end in ((t - e).mid(), (t + e).mid()):
            ((place, speed),) = swing.states([end])
            assert wide.contains(place) and w.contains(speed) and wide.rad() / 2 < abs(wide.mid() - place)


def test_what_a_way_is_off_by_is_in_what_is_read_off():
    """Polynomials that are off by nearly their error: it is paid for, and half of that is refuted."""
    e, t = arb(2) ** -20, arb("0.25")
    with ctx.workprec(84):
        honest = Courses.up_to(coordinate((("2", "1/5"),)), arb("0.5"), 60).quarter(PLACE)
        (growth, _), (clock, _) = honest.growth, honest.clock
        wrong = replace(honest, growth=(growth + e, e * arb("1.001")), clock=(clock + e, e * arb("1.001")))
        assert wrong.ln_r(t).contains(honest.ln_r(t).mid()) and wrong.time(t).contains(honest.time(t).mid())
        s = honest.time(t).mid()
        ((x, y, time),) = wrong.near([s])  # at the t whose true time is s - e
        ((true_x, true_y, _),) = honest.near([(s - e).mid()])
        assert time.contains(s - e) and x.contains(true_x) and y.contains(true_y)
        assert max(wrong.ln_r(t).rad(), wrong.time(t).rad(), time.rad(), x.rad(), y.rad()) < 2 * e


def test_the_radii_of_what_is_kept_count():
    with ctx.workprec(100):
        assert Along.of([[arb(1, arb(2) ** -20)]], arb(0), arb(2) ** -60).error >= arb(2) ** -20


def test_a_course_begins_where_the_local_expansion_still_reaches(monkeypatch):
    law = Law({"3/2": "1/10"})
    with ctx.workprec(90):
        flow = Interpolated(Damping.of_law(law), panels_of(law, 90), within=100)
        nearest, found = flow.read_off(arb(1), arb(0))
        assert found.begin < arb("0.2") and arb("2.8") < found.end
        assert found.begin < nearest.state(nearest.reach)[1] < found.begin * arb("1.01")
        assert len(nearest.rows[0][1]) < len(flow.expansion(arb(1)).rows[0][1]) / 2  # no farther than it must
        monkeypatch.setattr(sequence_module, "_FASTER", arb("0.99"))
        assert flow.read_off(arb(1), arb(0)) is None


def test_states_at_uncertain_times_hold_both_ends():
    """Of a course that is read off, at t +- e near the centre: the place moves by nearly e either way."""
    law, e, t = Law({"3/2": "1/10"}), arb(2) ** -30, arb(1501) / 1000
    with ctx.workprec(90):
        flow = Interpolated(Damping.of_law(law), panels_of(law, 90), within=100)
        ((wide, _),) = states(flow, arb(1), arb(0), [arb(t.mid(), e)])
        ends = [states(flow, arb(1), arb(0), [time])[0][0] for time in ((t - e).mid(), (t + e).mid())]
        assert all(wide.contains(end) for end in ends) and abs(ends[0] - ends[1]) > wide.rad()


def test_what_a_start_is_off_by_is_in_a_course():
    """The orbits from 1 and 1 + e: at the hand-over they are still nearly e apart."""
    law, e = Law({"3/2": "1/10"}), arb(2) ** -30
    with ctx.workprec(90):
        flow = Interpolated(Damping.of_law(law), panels_of(law, 90), within=100)
        (_, one), (_, other) = (flow.read_off(p, e) for p in (arb(1), 1 - e))
        for t in (arb("0.125"), arb(1)):
            ((u, w),), (place, speed) = one.all_at([t]), other.own(t)
            assert u.contains(place) and w.contains(speed) and u.rad() < e * arb("1.001")
        assert abs(one.own(arb("0.125"))[0] - other.own(arb("0.125"))[0]) > e / 2


def test_half_swings_from_the_ends_of_courses_are_those_of_a_map_of_their_own():
    law = coordinate((("3/2", "1/5"),))
    for bits in (10, 40):
        swings = Courses.up_to(law, arb("0.5"), bits).swings
        assert swings.holds(arb("0.4999")) and not swings.holds(arb("0.5"))
        with ctx.workprec(110):
            for z in (PLACE, arb("0.125")):
                sharp = HalfSwings.up_to(law, arb("0.5"), 90)(z)
                for rough, fine in zip(swings(z), sharp, strict=True):
                    assert rough.contains(fine) and rough.rad() < arb(2) ** (6 - max(bits, 30))


def test_an_amplitude_beyond_the_courses_is_refused():
    courses = Courses.up_to(coordinate((("2", "1/5"),)), arb("0.5"), 30)
    with pytest.raises(UndecidedError, match="outside the interval"):
        courses.quarter(arb("0.51"))


@pytest.mark.parametrize("pairs", [(("3", "1/20"), ("5", "1/4")), (("1", "1/20"), ("2", "1/4")), (("1/2", "1/20"),)])
def test_a_law_without_a_mirrored_quarter_has_no_courses(pairs):
    with pytest.raises(ValueError, match="backwards in time"):
        Courses.up_to(coordinate(pairs), arb("0.5"), 30)


@pytest.mark.parametrize(
    ("law", "v0"),
    [pytest.param({"3/2": "1/10"}, 0, marks=pytest.mark.slow), ({3: "1/2"}, 1),
     pytest.param({2: 5}, 0, marks=pytest.mark.slow)],
    ids=["three halves", "cubic, in motion", "strong"],
)  # fmt: skip
def test_states_in_many_half_swings_are_those_by_pieces(law, v0, monkeypatch):
    """Asked in 50 half-swings, from rest and in motion: the same motion, and the course is what serves."""
    seen, honest = [], Course.states
    monkeypatch.setattr(Course, "states", lambda self, times: seen.extend(times) or honest(self, times))
    system = Oscillator(Law(law), v0=v0)
    times = [ExactReal(k) for k in range(160)]
    by_courses = reference_states(system, times, 15)
    count = len(seen)
    monkeypatch.setattr(panels_module, "_COURSES", 10**9)
    by_pieces = reference_states(system, times, 15)
    assert count > 100 and len(seen) == count
    for one, other in zip(by_courses.x + by_courses.v, by_pieces.x + by_pieces.v, strict=True):
        assert one.overlaps(other) and one.rad() < 2 * other.rad() + arb(10) ** -20


def test_few_half_swings_have_no_courses(monkeypatch):
    monkeypatch.setattr(Courses, "up_to", None)
    assert len(reference_states(Oscillator(Law({"7/4": "1/10"})), [ExactReal(k) for k in range(90)], 10).x) == 90


def test_a_place_without_courses_is_not_tried_again(monkeypatch):
    tried = []

    def refused(*given):
        tried.append(given)
        raise UndecidedError("no")

    monkeypatch.setattr(Courses, "up_to", refused)
    times = [ExactReal(k) for k in range(160)]
    found = reference_states(Oscillator(Law({"9/5": "1/10"})), times, 10)
    assert len(found.x) == 160 and 1 <= len(tried) <= 4
