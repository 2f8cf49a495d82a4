"""What a half-swing drops is kept: each rounding and each part of an error, evaluated a second time."""

from dataclasses import replace

import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.flow import dense
from asymptotics.flow.error_propagation import CarriedErrors, turning_delay
from asymptotics.flow.linear_spring.expansion import TurningExpansion
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.linear_spring.trapping_regions import trap
from asymptotics.flow.sequence import after_arrival, first_from, turning_after_start, turning_by_pieces
from asymptotics.flow.trajectory import ArrivalPiece, FlowState, _arrival, half_swing_pieces
from asymptotics.flow.turning import TurningState
from asymptotics.return_map.half_swing_map import HalfSwingBalls, integrated, of_arrival
from asymptotics.return_map.sequence import following
from tests.flow.forces import NOTHING, damping_of


def late_by(law, amplitude, distance):
    """How much later an orbit turns that is that far from one that turns at -amplitude."""
    return turning_delay(law, arb(1), -amplitude - law.friction, distance, distance)


def test_every_rounding_of_a_half_swing_is_in_its_errors():
    """At 20 bits: the time of the departure, the restarts, the clock and the place of the landing, each recomputed."""
    law = damping_of(("0", "1/30"), ("3/2", "1/5"))
    with ctx.workprec(20):
        first, *steps, last = half_swing_pieces(LinearSpring(law), arb(1), arb(0))
        y, tau = first.expansion.state(first.expansion.reach)
        less = 1 - arb(2) ** -10
        assert first.error >= tau.rad() * first.expansion.speed(arb(1)) * less > 0
        begun = first.error + (y + law.friction).rad()
        for step in steps:
            assert step.error >= (begun + step.taylor.residual) * less
            y, w = step.taylor.state(step.taylor.length)
            begun = step.error + (y + law.friction).rad() + w.rad()
        turn, (start, w) = last.expansion.y0, last.beside
        at, off = turn + law.friction, last.expansion.state(w)[0] - start
        slack = at.rad() + abs(off).upper()
        assert min(at.rad(), last.clock.rad()) > 0 and last.miss >= (begun + slack) * less
        assert last.error >= (begun + slack + last.clock.rad() * last.expansion.speed(arb(1))) * less
        late = late_by(law, -last.turn, (begun + slack) * less)
        assert last.time.rad() >= (last.clock.rad() + late) * less
        assert last.late(arb(2) ** -10) >= late_by(law, -last.turn, (arb(2) ** -10 + last.miss) * less)


def test_what_is_uncertain_at_a_time_is_a_distance():
    """The piece's error and the way that the width of the time allows, both recomputed; the second in doubles."""
    law, e = damping_of(("3/2", "1/5"), ("0", "1/30")), arb(2) ** -12
    flow, x, w = LinearSpring(law), arb("0.75"), arb("1.5")
    with ctx.workprec(80):
        wanted = dense._Wanted(flow, [arb(2, e)])
        piece = next(p for p in half_swing_pieces(flow, arb(1), arb(0), e) if p.end > 2)
        wanted.take(piece, 1, arb(0))
        ((u, v),) = wanted.found
        moved = dense._moved(flow, u.mid() + arb(0, piece.error), abs(v.mid()) + arb(0, piece.error), 2 * e)
        assert u.rad() >= (piece.error + moved[0]) * (1 - arb(2) ** -9) > piece.error
        assert v.rad() >= (piece.error + moved[1]) * (1 - arb(2) ** -9) > piece.error
        place, speed = dense._moved(flow, x, w, e)
    fastest = 2 * 1.5 + 2.0**-12
    rate = 0.75 + 2.0**-12 + float(law.friction) + float(law.resistance(arb(fastest)))
    assert float(speed) == pytest.approx(2.0**-12 * rate, rel=1e-3)
    assert float(place) == pytest.approx(2.0**-12 * (1.5 + float(speed)), rel=1e-6)


def test_the_distance_of_a_turning_point_has_both_of_its_parts():
    law, e = damping_of(("0", "1/10"), ("2", "1")), arb(2) ** -8
    flow, truth = LinearSpring(law), 2.0**-8 + 2.0**-8 * (0.5 + 0.1)
    found = float(dense._distance(flow, TurningState(1, -1, arb("0.5"), arb(3), e, e)))
    assert truth <= found < 1.1 * truth
    assert dense._distance(flow, TurningState(1, -1, arb("0.5"), arb(3), e, arb(0))) >= e


def test_a_start_keeps_its_radii():
    """At rest and in motion, in place and in speed: the first turning point holds those from all corners."""
    flow, e = LinearSpring(damping_of(("3/2", "1/5"))), arb(2) ** -16
    with ctx.workprec(80):
        rest = dense._first(flow, arb(1, e), arb(0), dense._Wanted(flow, [arb(5)]))
        assert rest.amplitude_error >= e
        wide = [dense._first(flow, arb("0.5", e), arb("0.25", e), dense._Wanted(flow, [arb(5)])),
                first_from(flow, arb("0.5", e), arb("0.25", e))]  # fmt: skip
        for a, b in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
            corner = first_from(flow, arb("0.5") + a * e, arb("0.25") + b * e)
            assert all(one.x.contains(corner.x) and one.tau.contains(corner.tau) for one in wide)
        assert all(one.amplitude_error < 4 * e and one.time_error < 8 * e for one in wide)


def test_the_end_of_a_half_swing_that_began_in_motion_keeps_its_parts():
    """Made-up radii: the errors of the pieces and what was given add up, and so do the clock's radius and the delay."""
    law, e = damping_of(("3/2", "1/5")), arb(2) ** -10
    with ctx.workprec(80):
        *_, real = half_swing_pieces(LinearSpring(law), arb("0.5"), arb("0.25"))
        piece = replace(real, begun=CarriedErrors(e, e), miss=e, clock=arb(real.clock.mid(), e))
        found = turning_after_start(piece, 1, 2 * e)
        late = late_by(law, -piece.turn, 3 * e)
        assert 3 * e <= found.amplitude_error < arb("3.01") * e
        assert (e + late) * (1 - arb(2) ** -20) <= found.time_error < (e + late) * arb("1.01")


def test_a_half_swing_keeps_what_its_landing_misses():
    with ctx.workprec(40):
        *_, last = half_swing_pieces(LinearSpring(damping_of(("3/2", "1/5"))), arb("0.5"), arb(0))
        found = of_arrival(arb("0.5"), arb(0), last, 3)
        assert found.amplitude.rad() * arb("0.5") >= last.miss * (1 - arb(2) ** -20)
    law = damping_of(("1/2", "1"))
    edge, e = (arb(1) / 6).sqrt() * 9 / 16, arb(2) ** -6
    assert integrated(law, edge * arb("0.98"), arb(2) ** -20).ended == "creeps"
    assert trap(law, edge * arb("0.999") + arb(0, e), arb(0)) is None
    with ctx.workprec(60), pytest.raises(UndecidedError):  # from within e of the edge it may turn as well
        turning_by_pieces(LinearSpring(law), TurningState(0, 1, (edge * arb("0.999")).mid(), arb(0), e, arb(0)))


def test_times_and_places_of_a_turning_point_add_up():
    """Made-up radii: what is carried, that of q, that of T and the times before; by pieces the delay as well."""
    law, e = damping_of(("3/2", "1/5"), ("0", "1/20")), arb(2) ** -10
    found = HalfSwingBalls(arb("0.75", e), arb(3, e), "", 1, arb(0))
    there = following(law, TurningState(2, 1, arb(1), arb(9), 3 * e, 5 * e), found)
    assert there.amplitude_error >= 4 * e and there.amplitude_error < arb("4.1") * e
    assert there.time_error >= 6 * e * (1 - arb(2) ** -20) and there.time_error < arb("6.01") * e
    with ctx.workprec(80):
        *_, real = half_swing_pieces(LinearSpring(law), arb(1), arb(0), 3 * e)
        piece = replace(real, begun=CarriedErrors(e, 4 * e), miss=e, clock=arb(real.clock.mid(), e))
        there, late = (
            after_arrival(TurningState(2, 1, arb(1), arb(9), 3 * e, 5 * e), piece),
            late_by(law, -piece.turn, 4 * e),
        )
        assert there.amplitude_error >= 4 * e and there.amplitude_error < arb("4.1") * e
        assert (6 * e + late) * (1 - arb(2) ** -20) <= there.time_error < (6 * e + late) * arb("1.01")


@pytest.mark.parametrize("law", [NOTHING, (("3/2", "1/5"),), (("2", "3"),)])
def test_a_wrong_guess_of_the_turning_point_is_paid_for(law, monkeypatch):
    """|y_1 - guess| <= |Y - y| with a guess that is off: attained to a few per cent, and so is the time."""
    d, w, off = damping_of(*law), arb(2) ** -6, arb(2) ** -30
    with ctx.workprec(120):
        there = TurningExpansion.at(d, arb(-1), w)
        y, tau = there.state(w)
        monkeypatch.setattr("asymptotics.flow.secant.secant", lambda *given: arb(-1) + off)
        flow, friction = LinearSpring(d), d.friction
        here = FlowState(arb(0), (y + friction).mid(), w, CarriedErrors(arb(0), arb(0)))
        found = _arrival(flow, arb(1), here)
        assert off <= found.miss and found.miss / 2 < off and found.miss < off * arb(1.2)
        late = abs(found.clock + tau)
        assert found.time.contains(-tau.mid()) and late <= found.late(arb(0)) < off * arb(1.2)


def test_a_guess_beyond_the_place_of_rest_is_undecided(monkeypatch):
    law = damping_of(("2", "1/10"))
    monkeypatch.setattr("asymptotics.flow.secant.secant", lambda *_: arb(-1))
    found = _arrival(
        LinearSpring(law),
        arb(1),
        FlowState(arb(0), arb("-0.1").mid(), arb("0.01").mid(), CarriedErrors(arb(0), arb(0))),
    )
    with pytest.raises(UndecidedError, match="place of rest"):
        found.late(arb(0))


def test_errors_of_pieces_add_up():
    """Each piece has at least the error of the one before it and its own, rounding of the restart included."""
    with ctx.workprec(24):
        first, *steps, last = half_swing_pieces(LinearSpring(damping_of(("3/2", "1/5"))), arb(1), arb(0))
        off = last.expansion.state(last.beside[1])[0] - last.beside[0]
        dropped = [[c.rad() for c in step.taylor.state(step.taylor.length)] for step in steps]
    for step, following_step, (y, w) in zip(steps, steps[1:], dropped, strict=False):
        assert following_step.error >= step.error + following_step.taylor.residual + y + w
    assert last.error >= steps[-1].error + abs(off).lower() and steps[0].error > first.error


def test_the_error_of_a_start_reaches_the_turning_point():
    """The enclosure from a start with an error contains the orbits from both of its ends, and half of it does not."""
    law, d = damping_of(*NOTHING), arb(2) ** -20
    with ctx.workprec(80):
        *_, last = half_swing_pieces(LinearSpring(law), arb("0.5"), arb("0.5"), d)
        *_, high = half_swing_pieces(LinearSpring(law), arb("0.5") + d * arb(0.7), arb("0.5") + d * arb(0.7))
        assert isinstance(last, ArrivalPiece) and isinstance(high, ArrivalPiece)
        apart = abs(high.turn - last.turn)
        assert apart <= last.error and last.error / 2 < apart


def test_the_error_of_a_time_becomes_a_distance():
    """Near a turning point of amplitude a the state moves by a |t|."""
    law, late = damping_of(*NOTHING), arb(2) ** -20
    bound = dense._distance(LinearSpring(law), TurningState(1, -1, arb(2), arb(3), arb(0), late))
    truth = 2 * (2 * (late / 2).sin())
    assert truth <= bound and bound / 2 < truth


def test_an_uncertain_time_widens_the_state():
    law = damping_of(("2", "1/10"))
    with ctx.workprec(100):
        (low, _), (high, _) = dense.states(LinearSpring(law), arb(1), arb(0), [arb("1.5"), arb("1.5") + arb(2) ** -20])
        ((x, v),) = dense.states(
            LinearSpring(law), arb(1), arb(0), [arb("1.5") + arb(2) ** -21 + arb(0, arb(2) ** -21)]
        )
        assert x.contains(low) and x.contains(high) and x.rad() < 4 * abs(high - low)


def test_a_time_with_more_bits_than_the_work_is_not_rounded():
    law = damping_of(("2", "1/10"))
    with ctx.workprec(200):
        time = arb(10) ** 6 / 3
    with ctx.workprec(30):
        wanted = dense._Wanted(LinearSpring(law), [time])
        ((first, width),) = wanted.queue
    with ctx.workprec(300):
        assert first <= time and time <= first + width and width < arb(2) ** -170
