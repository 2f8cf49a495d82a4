"""How far two motions part beside any spring: each part of the bounds, where leaving it out would be refuted."""

from dataclasses import dataclass, replace

import mpmath
import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.flow import dense, error_propagation, trajectory
from asymptotics.flow.error_propagation import (
    CarriedErrors,
    contraction_by_energy,
    growth,
    state_gap,
    turning_delay,
    turning_gap,
)
from asymptotics.flow.sequence import after_arrival, first_from, next_turning, sticks, turning_after_start
from asymptotics.flow.times import at_time
from asymptotics.flow.trajectory import ArrivalPiece, Step, half_swing_pieces
from asymptotics.flow.turning import TurningState, at_rest
from asymptotics.flow.wells import even_well as wells
from asymptotics.flow.wells.even_well import EvenWell
from asymptotics.flow.wells.expansion import WellExpansion
from asymptotics.flow.wells.trapping_regions import _held, trap
from tests.flow.forces import WELLS as FORCES
from tests.flow.forces import in_a_well
from tests.flow.wells.test_bounds import FREE

TOP = FORCES["free pendulum"]


@dataclass(frozen=True)
class Sloped:
    """dG/du = 1 + 2 ``inside`` within 0.4 of u = 0, 1 + 2 ``outside`` beyond: the distance grows at these rates."""

    inside: float
    outside: float

    nonexpansive: bool = False

    def slopes(self, u, _w):
        return arb(1) + 2 * arb(self.inside if abs(u).upper() <= 0.45 else self.outside), arb(0)


def test_the_growth_counts_what_the_distance_itself_reaches():
    """At the rate 1 up to four times the error and at a higher one beyond, after t it is 4 e^(rate (t - ln 4))."""
    t, e = arb("1.6"), arb("0.1")
    for rate in (1, 2, 10):
        found = growth(Sloped(1, rate), arb(1), arb(0), arb(1), t, e)
        assert 4 * (rate * (t - arb(4).log())).exp() <= found * (1 + arb(1e-9)) and found <= (rate * t).exp() * arb(
            "1.001"
        )


def test_the_growth_counts_the_places_within_the_error():
    """Beside a hard spring: two orbits of x + 30 x^3 that begin 0.1 apart, the wider one where the slope is larger."""
    hard = in_a_well({2: 0}, {3: 30})
    with ctx.workprec(80):
        u, t, e = arb("0.05"), arb("0.1"), arb("0.1")
        factor = growth(hard, arb(1), u, arb(0).union(arb(1)), t, e)
        slope = abs(hard.slope(u + 4 * e, arb(0)) - 1) / 2
        assert factor >= (t * slope).exp()
        assert factor < (t * slope).exp() * arb("1.5")


def energy(place):
    return 1 - mpmath.cos(place)


@pytest.mark.parametrize(("turn", "beyond", "square"), [(-3.0, 0.0, 0.004), (-2.9, 0.05, 0.002), (-1.0, 0.0, 0.1)])
def test_the_gap_of_a_pendulum_is_that_of_its_energy(turn, beyond, square):
    """Near the top the force falls on the way: the gap is larger than square/|s_0| at the turning point."""
    first = turn - beyond
    truth = -float(mpmath.acos(mpmath.cos(first) - square)) - first if first < 0 else 0.0
    found = float(turning_gap(TOP, arb(turn), arb(square), arb(beyond)))
    assert abs(truth) <= found < 2.2 * abs(truth) + 1e-9
    if turn < -2:
        assert square / float(abs(mpmath.sin(turn))) < abs(truth)


@dataclass(frozen=True)
class Braking:
    """A force that is -1 at u = -1 and ``farther`` beyond: what is read within a ball is the weaker one."""

    farther: float

    def restoring(self, u):
        return arb(-1) if u.is_exact() else arb(self.farther)


def test_the_room_of_a_gap_must_hold_it():
    """Twice square/|s_0| is tried: a brake of more than half suffices there, a weaker one may let go."""
    assert turning_gap(Braking(-0.6), arb(-1), arb("0.01")) < arb("0.017")
    with pytest.raises(UndecidedError, match="place of rest"):
        turning_gap(Braking(-0.4), arb(-1), arb("0.01"))


def test_a_late_motion_near_the_top_is_later():
    """It passes at the speed d where the brake is weaker than at the turning point, by the gap and by its own way."""
    turn, gap, d = arb(-3), arb("0.05"), arb("0.03")
    with ctx.workprec(80):
        found = turning_delay(TOP, arb(1), turn, gap, d)
        weakest = (arb(3) + gap + 2 * d).sin()
        assert d / weakest <= found < d / weakest * arb("1.001")
        assert d / (arb(3) + gap + d).sin() < found and d / (arb(3) + d).sin() * arb("1.3") < found
    with pytest.raises(UndecidedError, match="place of rest"):  # in that time it would move farther than that
        turning_delay(TOP, arb(20), arb(-2), arb(0), arb("0.05"))


@pytest.mark.parametrize(("p", "e"), [("0.25", "0.125"), ("1", "0.25")])
def test_contraction_counts_the_force_at_the_farther_start(p, e, monkeypatch):
    """The energy between the two starts: e times the force at the nearer one is less, at the farther hardly more."""
    monkeypatch.setattr(error_propagation, "turning_gap", lambda _force, _turn, square, _beyond: square)
    p, e = arb(p), arb(e)
    truth = p.cos() - (p + e).cos()
    square = contraction_by_energy(TOP, p, e, arb(3), -p, arb(0))
    assert e * p.sin() < truth <= square < truth * arb("1.3")


def test_viscous_contraction_leaves_out_the_first_fall_and_the_last_stop(monkeypatch):
    """The time that the factor counts is shorter by at least the free fall through e, and not by much more."""
    monkeypatch.setattr(error_propagation, "turning_gap", lambda _force, _turn, square, _beyond=None: square)
    force, e, duration = in_a_well({1: "1/2"}), arb(2) ** -12, arb(3)
    square = contraction_by_energy(force, arb(1), e, duration, -arb("0.45"), arb(0))
    common = -(square / (e * (1 + e))).log() * 2
    assert duration - 12 * (2 * e).sqrt() < common < duration - (2 * e).sqrt()


def test_viscous_contraction_counts_only_the_time_that_both_spend():
    """Linear loss beside a linear spring, exactly: both fall by the same factor, and the bound is above it."""
    force = in_a_well({1: "1/2"})
    with ctx.workprec(120):
        rate, omega = arb(1) / 4, (1 - arb(1) / 16).sqrt()
        duration, q = arb.pi() / omega, (-rate * arb.pi() / omega).exp()
        for e in (arb(2) ** -6, arb(2) ** -20):
            bound = contraction_by_energy(force, arb(1), e, duration.lower(), -q.mid(), q.rad())
            assert q * e <= bound
        assert bound < q * e * arb("1.3")
        assert contraction_by_energy(
            force, arb(1), arb(2) ** -6, duration.lower(), -q.mid(), q.rad()
        ) > bound * 2**14 * arb("1.02")


def test_outside_the_common_places_the_time_is_that_of_free_fall():
    """sqrt(2 e/s_0) from rest, at most twice with the loss; |w|/|s_0| at the end."""
    e, square = arb(2) ** -10, arb(2) ** -10
    found = float(error_propagation._outside(FREE, arb(1), e, arb(-1), arb(0), square))
    fall, stop = 2 * float((e / (1 - e)).sqrt()), float((2 * square).sqrt())
    assert fall + stop <= found < 1.02 * (fall + stop)
    assert stop > 0.3 * found
    steep = in_a_well({"1/10": 20})  # the loss may hold the faster one back at once
    assert not error_propagation._outside(steep, arb(1), e, arb(-1), arb(0), square).is_finite()


@pytest.mark.parametrize("given", [arb(0), arb(2) ** -14])
def test_errors_of_pieces_grow_and_add_up(given):
    """Each piece has at least the error of the one before, grown, its residual, and the rounding of the restart."""
    force = FORCES["pendulum"]
    with ctx.workprec(24):
        first, *steps, last = half_swing_pieces(EvenWell(force), arb(2), arb(0), given)
        unit = first.unit
        place, tau = first.expansion.state(first.expansion.reach)
        assert first.errors.local >= tau.rad() * first.expansion.speed(unit) * arb("0.9999") > 0
        factor = growth(force, unit, arb(2).union(place), arb(0).union(first.expansion.reach), tau, given)
        assert factor > arb("1.001") or given == 0
        assert first.error >= (factor * given + first.errors.local) * arb("0.9999")
        begun = first.error + unit * place.rad()
        assert first.error >= given and first.errors.local <= first.error
        for step in steps:
            factor = growth(force, unit, *step.taylor.box, step.taylor.length, begun + step.taylor.residual)
            assert factor > 1 and step.error >= begun * arb("0.9999") + step.taylor.residual
            assert step.error >= (begun + step.taylor.residual) * factor * arb("0.9999")
            u, w = step.taylor.state(step.taylor.length)
            begun = step.error + unit * u.rad() + w.rad()
        assert isinstance(last, ArrivalPiece) and last.error >= begun
    assert max(s.error for s in steps) > given * arb("1.05")


def shifted(force, p, e, bits=120):
    """The landing from p within e, its gap and lateness, and the landings from both ends exactly."""
    with ctx.workprec(bits):
        unit = EvenWell(force).unit(p, arb(0))
        *_, wide = half_swing_pieces(EvenWell(force), p, arb(0), unit * e)
        return (
            wide,
            wide.gap(unit * e),
            wide.late(unit * e),
            [list(half_swing_pieces(EvenWell(force), p + side * e, arb(0)))[-1] for side in (-1, 1)],
        )


@pytest.mark.parametrize("name", ["pendulum", "duffing", "place"])
def test_a_landing_holds_the_orbits_of_both_ends(name):
    """In place by its gap and in time by its lateness; both are within a factor of twenty of what is seen."""
    wide, gap, late, ends = shifted(FORCES[name], arb("1.5"), arb(2) ** -24)
    with ctx.workprec(120):
        apart = max((abs(end.turn - wide.turn) for end in ends), key=float)
        later = max((abs(end.clock - wide.clock) for end in ends), key=float)
        assert apart <= gap < 20 * apart and later <= late < 20 * later
        assert gap > wide.miss


@pytest.mark.parametrize("share", ["0", "0.3", "0.9"])
def test_the_gap_of_a_state_counts_place_and_speed(share):
    """A free linear oscillator: states within e of (u, w), as far in place and as fast as the share says."""
    u, w, e = arb("-0.8"), arb("0.6"), arb(2) ** -12
    with ctx.workprec(100):
        bound = state_gap(FREE, arb(1), u, w, arb(-1), e)
        du, dw = e * arb(share), e * (1 - arb(share) ** 2).sqrt()
        truth = ((u - du) ** 2 + (w + dw) ** 2).sqrt() - 1
        assert truth <= bound < 3 * e
    if share == "0.9":
        best = ((u - e * arb("0.8")) ** 2 + (w + e * arb("0.6")) ** 2).sqrt() - 1
        assert bound / 2 < best


def test_a_state_that_may_be_at_rest_has_no_gap():
    with pytest.raises(UndecidedError, match="too wide"):
        state_gap(FREE, arb(1), arb("-0.8"), arb(2) ** -12, arb("-0.8") - arb(2) ** -25, arb(2) ** -13)
    with pytest.raises(UndecidedError, match="force ahead"):  # the centre lies within the error
        state_gap(TOP, arb(1), -(arb(2) ** -6), arb("0.5"), arb("-0.5"), arb(2) ** -7)


def test_what_a_turning_point_carries(monkeypatch):
    """Made-up pieces: the gap, the miss, the lateness, the radius of the clock and what was carried all count."""
    force, e = FORCES["free pendulum"], arb(2) ** -10
    with ctx.workprec(80):
        *_, real = half_swing_pieces(EvenWell(force), arb(1), arb(0))
        piece = replace(real, miss=e, clock=arb(real.clock.mid(), e))
        monkeypatch.setattr(ArrivalPiece, "gap", lambda _, given: given)
        monkeypatch.setattr(ArrivalPiece, "late", lambda _, given: e + given)
        kicked = turning_after_start(piece, 1, 4 * e)
        assert kicked.amplitude_error >= 4 * e and kicked.time_error >= 5 * e
        here = TurningState(3, 1, arb(1), arb(20), e, 5 * e)
        there = after_arrival(here, piece)
        assert there.time_error >= 8 * e and there.time_error < 9 * e
        assert there.amplitude_error >= 2 * e and there.amplitude_error < 4 * e
        viscous = in_a_well({1: "1/2"}, "pendulum")
        long = after_arrival(here, replace(piece, flow=EvenWell(viscous))).amplitude_error - piece.miss
        again = contraction_by_energy(viscous, arb(1), e, (piece.clock - 2 * e).lower(), piece.turn, piece.miss)
        assert long >= again * arb("0.9999")


@pytest.mark.parametrize("name", ["pendulum", "duffing", "place"])
def test_the_error_of_a_time_only_adds(name):
    """A motion that is late at one turning point is as late at the next: seen exactly, and not counted twice."""
    e = arb(2) ** -20
    with ctx.workprec(80):
        there = dense._swing(
            EvenWell(FORCES[name]),
            TurningState(0, 1, arb(1), arb(0), arb(0), e),
            dense._Wanted(EvenWell(FORCES[name]), [arb(9)]),
        )
        exactly = dense._swing(EvenWell(FORCES[name]), at_rest(arb(1)), dense._Wanted(EvenWell(FORCES[name]), [arb(9)]))
        assert exactly.time_error + e * arb("0.999") < there.time_error < e * arb("1.001")


def test_dry_friction_at_an_uncertain_amplitude():
    force = in_a_well({0: "1/4"}, {3: "1/2"})
    held = TurningState(1, 1, arb("0.2"), arb(3), arb("0.01"), arb(0))
    assert sticks(EvenWell(force), held) and not sticks(EvenWell(force), replace(held, amplitude=arb("0.3")))
    for amplitude in ("0.23", "0.25"):
        with pytest.raises(UndecidedError, match="undecided"):
            sticks(EvenWell(force), replace(held, amplitude=arb(amplitude), amplitude_error=arb("0.05")))


def test_the_place_of_rest_under_an_uncertain_friction_has_two_ends():
    """u - g = 0 for a friction g between 1/5 and 2/5: every such g is held, in the last place that was halved."""
    force = replace(FREE, grips=((arb("0.3", "0.1"), 0),))
    held = _held(force, arb(1))
    assert held.contains(arb("0.21")) and held.contains(arb("0.39")) and held.rad() < arb("0.26")


def test_an_uncertain_time_moves_a_state():
    """A free linear oscillator at (0.6, 0.8) within the time e: 0.8 e in place and 0.6 e in speed, and hardly more."""
    e = arb(2) ** -12
    du, dw = dense._moved(EvenWell(FREE), arb("0.6"), arb("0.8"), e)
    for moved, truth in ((du, arb("0.8") * e), (dw, arb("0.6") * e)):
        assert truth <= moved and moved / 2 < truth
    wide, _ = dense._moved(EvenWell(FREE), arb("0.6"), arb("0.8"), arb("0.5"))
    assert wide >= arb("0.8") * arb("0.5").sin() + arb("0.6") * (1 - arb("0.5").cos())
    with pytest.raises(UndecidedError, match="too uncertain"):
        dense._moved(EvenWell(in_a_well({2: 0}, {3: 1000})), arb(1), arb(1), arb(1))


def test_a_time_counts_from_its_lower_to_its_upper_end():
    """A free linear oscillator at rest at 1, asked at r +- r: -sin(2 r) at the latest, which r alone does not reach."""
    r = arb(2) ** -8
    ((x, v),) = dense.states(EvenWell(FREE), arb(1), arb(0), [arb(r, r)])
    assert x.contains((2 * r).cos()) and v.contains(-(2 * r).sin()) and v.rad() < 3 * r


def test_a_state_holds_its_neighbours_in_place_speed_and_time():
    """From X +- e, V +- e, at a time +- e: every corner is inside, and the ball is at most some times as wide."""
    force, e = FORCES["pendulum"], arb(2) ** -16
    with ctx.workprec(90):
        (wide,) = dense.states(EvenWell(force), arb("0.5", e), arb("0.25", e), [arb(3, e)])
        farthest = [arb(0), arb(0)]
        for sides in ((1, 1, 1), (1, -1, 1), (-1, 1, 1), (1, 1, -1), (-1, -1, -1), (1, -1, -1)):
            a, b, c = (side * e for side in sides)
            (state,) = dense.states(EvenWell(force), arb("0.5") + a, arb("0.25") + b, [arb(3) + c])
            for k, (ball, x) in enumerate(zip(wide, state, strict=True)):
                assert ball.contains(x.mid())
                farthest[k] = max(farthest[k], abs(x - ball.mid()).mid(), key=float)
        assert all(ball.rad() < 12 * far for ball, far in zip(wide, farthest, strict=True))


@pytest.mark.parametrize(("place", "speed"), [(1, 0), (0, 1)])
def test_a_start_that_is_uncertain_in_place_or_speed_alone(place, speed):
    force, e = FORCES["pendulum"], arb(2) ** -16
    with ctx.workprec(90):
        (wide,) = dense.states(EvenWell(force), arb("0.5", place * e), arb("0.25", speed * e), [arb(3)])
        for side in (1, -1):
            start = arb("0.5") + side * place * e, arb("0.25") + side * speed * e
            (state,) = dense.states(EvenWell(force), *start, [arb(3)])
            assert all(ball.contains(x.mid()) and ball.rad() < 8 * e for ball, x in zip(wide, state, strict=True))


class Falling:
    """The force 1 everywhere."""

    def strongest(self, _u, _w):
        return arb(1)


def test_a_late_fall_is_off_in_place_too(monkeypatch):
    """Speed t and way t^2/2 under the force 1, the distance counting places tenfold: the speed alone is less."""
    monkeypatch.setattr(EvenWell, "unit", lambda *_: arb(10))
    t = arb(1) / 8
    truth = ((10 * t**2 / 2) ** 2 + t**2).sqrt()
    found = dense._distance(EvenWell(Falling()), TurningState(1, 1, arb(1), arb(3), arb(0), t))
    assert t * arb("1.1") < truth <= found < 2 * truth


def test_what_is_uncertain_about_a_turning_point_is_a_distance():
    """The error of the amplitude, the speed that the time allows and the way it allows, in the unit of the distance."""
    force, e = FORCES["free pendulum"], arb(2) ** -10
    unit = EvenWell(force).unit(arb(1), arb(0))
    for amplitude, time in ((e, arb(0)), (arb(0), e), (e, e), (arb(0), arb(1) / 8)):
        found = dense._distance(EvenWell(force), TurningState(1, 1, arb(1), arb(3), amplitude, time))
        speed, way = arb(1).sin() * time, arb(1).sin() * time**2 / 2
        truth = ((unit * (amplitude + way)) ** 2 + speed**2).sqrt()
        assert truth <= found < 2.5 * truth


def test_the_piece_before_a_kink_ends_at_it_within_its_error():
    force = FORCES["place"]
    with ctx.workprec(40):
        pieces = [p for p in half_swing_pieces(EvenWell(force), arb(1), arb(0)) if isinstance(p, Step)]
        before, after = next((a, b) for a, b in zip(pieces, pieces[1:]) if b.taylor.us[0] == 0)
        left = before.taylor.state(before.taylor.length)[0]
        assert left > 0 and after.error - after.taylor.residual >= before.error + before.unit * left.lower()


@pytest.mark.parametrize("error", [arb(0), arb(2) ** -13])
@pytest.mark.parametrize("name", ["pendulum", "duffing"])
def test_the_parts_of_a_landing(name, error):
    """The miss of the guess joins both errors; they grow on the way, and the radius of the clock is added."""
    force, u, w, local, grown = FORCES[name], arb("-0.875"), arb("0.25"), error / 4, arb("1.5")
    flow = EvenWell(force)
    with ctx.workprec(24):
        unit = EvenWell(force).unit(arb(1), arb(0))
        found = trajectory._arrival(flow, unit, trajectory.FlowState(arb(1), u, w, CarriedErrors(local, error, grown)))
        place, time = found.expansion.state(w)
        slack = unit * abs(place - u).upper()
        factor = growth(force, unit, found.turn.union(place), arb(0).union(w), -time, error + slack)
        own = found.clock.rad() * found.expansion.speed(unit)
        assert slack > 0 and own > 0 and (factor > arb("1.0001") or error == 0)
        less = 1 - arb(2) ** -16
        given, whole = (error - local) / grown, (error + slack) * less
        gap = state_gap(force, unit, u, w, found.turn, whole)
        assert found.gap(given) >= gap
        assert found.miss >= state_gap(force, unit, u, w, found.turn, (local + slack) * less)
        assert found.late(given) >= turning_delay(force, unit, found.turn, gap, factor * whole)
        assert found.error >= (factor * (error + slack) + own) * less
        assert found.errors.local >= (factor * (local + slack) + own) * less


@pytest.mark.parametrize("name", ["free pendulum", "duffing", "dry beside springs"])
def test_a_wide_time_near_a_turning_point(name):
    """Both ends of the time are contained; the place moves at the speed reached there, half is less."""
    with ctx.workprec(90):
        expansion = WellExpansion.at(FORCES[name], arb(1))
        middle, width = (expansion.state(expansion.reach)[1] * arb("0.96")).mid(), arb(2) ** -18
        u, w = at_time(expansion, middle + arb(0, width))
        moved = []
        for end in (middle - width, middle + width):
            exact_u, exact_w = at_time(expansion, end.mid())
            assert u.contains(exact_u) and w.contains(exact_w)
            moved.append((abs(exact_u - u.mid()), abs(exact_w - w.mid())))
        assert u.rad() / 2 < moved[0][0] and w.rad() < 8 * moved[0][1]


def test_traps_and_edges_are_asked_about_the_whole_error(monkeypatch):
    force, seen, given = in_a_well({"1/2": "1/9"}, "pendulum"), [], arb(2) ** -12
    monkeypatch.setattr(wells, "trap", lambda _force, u, w: seen.append((u.rad(), w.rad())))
    monkeypatch.setattr(wells, "beyond", lambda _force, u: seen.append((u.rad(), arb(1))))
    with ctx.workprec(60):
        pieces = list(half_swing_pieces(EvenWell(force), arb(1), arb(0), given))
        unit = pieces[0].unit
    assert len(seen) >= 4 and all(u >= given / unit * arb("0.999") and w >= given for u, w in seen)


def test_turning_points_hold_those_of_every_start():
    """At rest within e of 1, and in motion within e in place and speed: x and tau of the next ones."""
    force, e = FORCES["pendulum"], arb(2) ** -16
    assert at_rest(arb(-1, e)).amplitude_error >= e
    with ctx.workprec(80):
        wide = next_turning(EvenWell(force), at_rest(arb(1, e)))
        kicked = first_from(EvenWell(force), arb("0.5", e), arb("0.25", e))
        for a in (1, -1):
            there = next_turning(EvenWell(force), at_rest(1 + a * e))
            assert wide.x.contains(there.x) and wide.tau.contains(there.tau)
            for b in (1, -1):
                corner = first_from(EvenWell(force), arb("0.5") + a * e, arb("0.25") + b * e)
                assert kicked.x.contains(corner.x) and kicked.tau.contains(corner.tau)
        assert max(wide.amplitude_error, kicked.amplitude_error, key=float) < 16 * e
    with pytest.raises(UndecidedError, match="holds the mass here"):  # beyond the top it falls to the other side
        next_turning(EvenWell(TOP), at_rest(arb("3.1", "0.05")))


def test_the_trap_of_creep_has_its_boundary():
    """(w/c)^(1/2) <= K y/epsilon with c^(1/2) = 4/3 and the largest slope K = 1 of a spring that softens."""
    soft, y = in_a_well({"1/2": 1}, {3: "-1/2"}), arb("0.05")
    edge = (arb(4) / 3 * y) ** 2
    assert trap(soft, y, edge * arb("0.9")) == "creeps" and trap(soft, y, edge * arb("1.05")) is None
    steep = (arb(1) / 6).sqrt() * 9 / 16  # c^2 y^2 < 1/6 with c = 16/9
    assert trap(soft, steep * arb("0.9"), arb(0)) == "creeps" and trap(soft, steep * arb("1.05"), arb(0)) is None
