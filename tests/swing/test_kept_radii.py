"""What a half-swing drops is kept: each rounding and each part of an error, evaluated a second time."""

from dataclasses import replace

import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.swing import arrival as arrivals
from asymptotics.swing import dense
from asymptotics.swing.arrival import arrive
from asymptotics.swing.course import course, delay
from asymptotics.swing.ends import _together, trap
from asymptotics.swing.expansion import Expansion
from asymptotics.swing.keys import Plan
from asymptotics.swing.passage import Passage, integrated, of_landing
from asymptotics.swing.sequence import Turning, after_landing, first_from, following
from asymptotics.swing.slow import solve
from tests.swing.test_bounds import NOTHING, damping


@pytest.mark.parametrize("law", [NOTHING, (("3/2", "1/2"),), (("0", "1/10"), ("2", "1"))])
def test_the_speed_beside_a_turning_point(law):
    """|(y', w')| on both sides: P doubles at most, friction counts twice where its sign turns; evaluated again."""
    with ctx.workprec(60):
        found = Expansion.at(damping(*law), arb("0.75"))
        y, _ = found.state(found.reach)
        across = y + 2 * found.damping.friction + found.damping.resistance(found.reach)
        assert (across**2 + found.reach**2).sqrt() <= found.speed()
        again = 2 * arb("0.75") + 2 * found.damping.friction + found.reach
        assert again <= found.speed() * (1 + arb(1e-9)) and found.speed() <= again * (1 + arb(1e-9))
    with ctx.workprec(30):
        short = Expansion._short(damping(("1/1000", "0.3")), arb("0.75"), arb(2) ** -8, Plan(-8.0, 1, (), 1))
        again = 2 * arb("0.75") + short.reach + short.damping.resistance(short.reach)
        assert again <= short.speed() * (1 + arb(1e-6)) and short.speed() < again * (1 + arb(1e-6))


def test_a_guess_that_is_far_off_is_paid_for_at_the_nearer_orbit(monkeypatch):
    """e w/y^2 with the smaller |y| of the two orbits: a guess off by a fifth, in doubles."""
    law, w = damping(("3/2", "1/5")), arb(2) ** -6
    with ctx.workprec(80):
        y, _ = Expansion.at(law, arb(-1), w).state(w)
        monkeypatch.setattr(arrivals, "_guess", lambda *_: arb("-0.8"))
        found = arrive(law, y.mid(), w)
        e, size = float(found.miss), abs(float(y))
    assert 0.19 < e < 0.21
    assert float(found.duration.rad()) == pytest.approx(e * float(w) / (size - e) ** 2, rel=1e-6)


def test_every_rounding_of_a_course_is_in_its_errors():
    """At 20 bits: the time of the departure, the restarts, the clock and the place of the landing, each recomputed."""
    law = damping(("0", "1/30"), ("3/2", "1/5"))
    with ctx.workprec(20):
        first, *steps, last = course(law, arb(1), arb(0))
        y, tau = first.expansion.state(first.expansion.reach)
        less = 1 - arb(2) ** -10
        assert first.error >= tau.rad() * first.expansion.speed() * less > 0
        begun = first.error + y.rad()
        for step in steps:
            assert step.error >= (begun + step.taylor.residual) * less
            y, w = step.taylor.state(step.taylor.length)
            begun = step.error + y.rad() + w.rad()
        at = last.arrival.turning + law.friction
        slack = at.rad() + last.arrival.miss
        assert min(at.rad(), last.clock.rad()) > 0 and last.miss >= (begun + slack) * less
        assert last.error >= (begun + slack + last.clock.rad() * last.arrival.expansion.speed()) * less
        late = delay(last.turn, (begun + slack) * less, law.friction)
        assert last.time.rad() >= (last.arrival.duration.rad() + late) * less
        assert last.late(arb(2) ** -10) >= delay(last.turn, (arb(2) ** -10 + last.miss) * less, law.friction)


@pytest.mark.parametrize("distance", ["0.01", "0.2"])
def test_the_delay_is_counted_at_the_smaller_amplitude(distance):
    """distance/(amplitude - 2 distance + friction), in doubles."""
    d = float(arb(distance))
    assert float(delay(arb(1), arb(distance), arb("0.1"))) == pytest.approx(d / (1 - 2 * d + 0.1), rel=1e-9)


def test_the_closed_form_keeps_its_radii():
    """Of the place at which it turns, and of the friction whose sign is wrong while its time is uncertain."""
    with ctx.workprec(20):
        law = damping(("0", "1/7"), ("1", "1/3"))
        (swing,) = course(law, arb(1), arb(0))
        time, y = swing.orbit.turning()
        assert swing.miss >= (y + law.friction).rad() > 0
        assert swing.error >= 4 * law.friction * time.rad() * (1 - arb(2) ** -10) > 0


def test_what_is_uncertain_at_a_time_is_a_distance():
    """The piece's error and the way that the width of the time allows, both recomputed; the first also without it."""
    law, e = damping(("3/2", "1/5"), ("0", "1/30")), arb(2) ** -12
    with ctx.workprec(80):
        wanted = dense._Wanted(law, [arb(2, e)])
        piece = next(p for p in course(law, arb(1), arb(0), e) if p.end > 2)
        wanted.take(piece, 1, arb(0), arb(1))
        ((x, v),) = wanted.found
        wide = 1 + piece.error
        moved = dense._moved(law, wide, wide, 2 * e)
        assert min(x.rad(), v.rad()) >= (piece.error + moved) * (1 - arb(2) ** -20)
    fastest = 1.5 + 2.5 * 2.0**-12
    resistance = float(law.resistance(arb(fastest)))
    again = 2.0**-12 * (2.5 + fastest + float(law.friction) + resistance)
    assert float(dense._moved(law, arb(1), arb("1.5"), e)) == pytest.approx(again, rel=1e-6)


def test_the_distance_of_a_turning_point_has_both_of_its_parts():
    law, e = damping(("0", "1/10"), ("2", "1")), arb(2) ** -8
    size = 0.5 + 2.0**-8 + 0.1
    speed = 2 * 2.0**-8 * size
    again = 2.0**-8 + 2.0**-8 * (speed + size + speed**2)
    found = dense._distance(law, Turning(1, -1, arb("0.5"), arb(3), e, e))
    assert float(found) == pytest.approx(again, rel=1e-6)
    assert dense._distance(law, Turning(1, -1, arb("0.5"), arb(3), e, arb(0))) >= e


def test_a_start_keeps_its_radii():
    """At rest and in motion, in place and in speed: the first turning point holds those from all corners."""
    law, e = damping(("3/2", "1/5")), arb(2) ** -16
    with ctx.workprec(80):
        rest = dense._first(law, arb(1, e), arb(0), dense._Wanted(law, [arb(5)]))
        assert rest.amplitude_error >= e
        wide = [dense._first(law, arb("0.5", e), arb("0.25", e), dense._Wanted(law, [arb(5)])),
                first_from(law, arb("0.5", e), arb("0.25", e))]  # fmt: skip
        for a, b in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
            corner = first_from(law, arb("0.5") + a * e, arb("0.25") + b * e)
            assert all(one.x.contains(corner.x) and one.tau.contains(corner.tau) for one in wide)
        assert all(one.amplitude_error < 4 * e and one.time_error < 8 * e for one in wide)


def test_the_end_of_a_course_that_began_in_motion_keeps_its_parts():
    """Made-up radii: the miss of the course and what was given add up, and so do the clock's radius and the delay."""
    law, e = damping(("3/2", "1/5")), arb(2) ** -10
    with ctx.workprec(80):
        *_, real = course(law, arb("0.5"), arb("0.25"))
        piece = replace(real, miss=e, time=arb(real.time.mid(), e))
        found = after_landing(piece, 1, 2 * e)
        late = delay(piece.turn, 3 * e, law.friction)
        assert 3 * e <= found.amplitude_error < arb("3.01") * e
        assert (e + late) * (1 - arb(2) ** -20) <= found.time_error < (e + late) * arb("1.01")


def test_a_passage_keeps_what_its_landing_misses():
    with ctx.workprec(40):
        *_, last = course(damping(("3/2", "1/5")), arb("0.5"), arb(0))
        found = of_landing(arb("0.5"), arb(0), last, 3)
        assert found.amplitude.rad() * arb("0.5") >= last.miss * (1 - arb(2) ** -20)
    law = damping(("1/2", "1"))
    edge, e = (arb(1) / 6).sqrt() * 9 / 16, arb(2) ** -6
    assert integrated(law, edge * arb("0.98"), arb(2) ** -20).ended == "creeps"
    assert trap(law, edge * arb("0.999") + arb(0, e), arb(0)) is None


def test_times_and_places_of_a_turning_point_add_up():
    """Made-up radii: what is carried, that of q, that of T, the delay, and the times before."""
    law, e = damping(("3/2", "1/5"), ("0", "1/20")), arb(2) ** -10
    found = Passage(arb("0.75", e), arb(3, e), "", 1, arb(0))
    there = following(law, Turning(2, 1, arb(1), arb(9), 3 * e, 5 * e), found)
    late = delay(arb("0.75"), 4 * e, law.friction)
    assert there.amplitude_error >= 4 * e and there.amplitude_error < arb("4.1") * e
    assert there.time_error >= (6 * e + late) * (1 - arb(2) ** -20) and there.time_error < (6 * e + late) * arb("1.01")


def test_only_terms_up_to_alpha_help_to_trap():
    """At small speeds w^3 is nothing beside w^(1/2); w^(1/4) is more, by fastest^(-1/4) at least."""
    law = damping(("1/4", "1/5"), ("1/2", "1/5"), ("3", "10"))
    found = float(_together(law, law.alphas[1], law.exponents[1], arb("0.0625")))
    assert found == pytest.approx(0.2 + 0.2 * 2, rel=1e-9)


def test_newton_claims_no_root_where_there_is_none():
    """x^2 + 1 has none, and no box about any x holds its own Newton step."""
    with ctx.workprec(60), pytest.raises(UndecidedError):
        solve(lambda x: (x * x + 1, 2 * x), arb(0), arb("0.7"))
