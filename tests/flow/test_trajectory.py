"""The pieces of a half-swing: each part of their errors, where leaving it out would be refuted, and kinks."""

from dataclasses import replace
from types import SimpleNamespace

import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.flow import trajectory
from asymptotics.flow.error_propagation import CarriedErrors, growth, state_gap, turning_delay
from asymptotics.flow.trajectory import ArrivalPiece, Step, half_swing_pieces
from asymptotics.flow.wells.even_well import EvenWell
from asymptotics.flow.wells.force import WellForce
from tests.flow.forces import FREE, in_a_well
from tests.flow.forces import WELLS as FORCES


def expansion(turn, place):
    def state(w):
        return (turn if w == 0 else place), arb(1)

    return SimpleNamespace(state=state, reach=arb("0.1"), speed=lambda _unit: arb(1))


def replace_method(flow, name, method):
    """The flow with another method."""
    new = type("Changed", (type(flow),), {name: staticmethod(method)})
    return new(flow.force)


AIR = FORCES["pendulum"]


def orbit(force, p, bits=160):
    with ctx.workprec(bits):
        *_, last = half_swing_pieces(EvenWell(force), arb(p), arb(0))
        return last


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


def test_the_growth_along_a_piece_is_that_of_all_its_places_and_speeds(monkeypatch):
    """At both ends the box reaches from one state to the other."""
    seen = []

    def growth(_force, _unit, u, w, _duration, _error):
        seen.append((u, w))
        return arb(1)

    monkeypatch.setattr(trajectory, "growth", growth)
    with ctx.workprec(60):
        first, *_, last = half_swing_pieces(EvenWell(FREE), arb(1), arb(0), arb(2) ** -40)
        end, _ = first.expansion.state(first.expansion.reach)
        turn, place = (last.expansion.state(w)[0] for w in (arb(0), last.beside[1]))
        (u, w), (v, x) = seen[0], seen[-1]
        assert u.contains(arb(1)) and u.contains(end) and w.contains(arb(0)) and w.contains(first.expansion.reach)
        assert v.contains(turn) and v.contains(place) and x.contains(arb(0)) and x.contains(last.beside[1])


def test_the_rounding_of_the_time_of_a_landing_is_a_distance():
    with ctx.workprec(30):
        *_, last = half_swing_pieces(EvenWell(FREE), arb(1), arb(0), arb(0))
        own = last.errors.error - last.factor * last.begun.error
        wide = last.clock.rad() * last.expansion.speed(last.unit)
        assert own > 0 and own >= wide * arb("0.999")


@pytest.mark.parametrize("given", ["0.0015", "0.003"])
def test_dry_friction_may_hold_a_start_within_its_error(given):
    """Held up to 1/2: the start 0.501 is farther, by less than its error."""
    flow = EvenWell(in_a_well({0: "1/2"}))
    with ctx.workprec(60), pytest.raises(UndecidedError, match="holds the mass here"):
        next(iter(half_swing_pieces(flow, arb("0.501").mid(), arb(0), arb(given))))


def test_an_expansion_that_reaches_a_kink_is_refused():
    kinked = EvenWell(in_a_well({2: "1/10"}, {2: "1/2"}))
    here = trajectory.FlowState(arb(0), arb("0.5"), arb(0), trajectory.CarriedErrors(arb(0), arb(0)))
    flow = replace_method(kinked, "expansion", lambda _place: expansion(arb("0.5"), arb("-0.1")))
    with pytest.raises(UndecidedError, match="reaches a kink"):
        trajectory._departure(flow, arb(1), here)
    flow = replace_method(kinked, "arrive", lambda _place, _w: expansion(arb("-0.5"), arb("0.1")))
    with pytest.raises(UndecidedError, match="reaches a kink"):
        trajectory._arrival(flow, arb(1), replace(here, u=arb("0.1"), w=arb("0.1")))


@pytest.mark.parametrize(
    ("start", "speed", "length", "place"),
    [
        ("0.5", "1", "0.25", "3e8"),  # the step ends before the kink
        ("0.5", "1", "2", "-0.1"),  # it is behind the kink at any time
        ("0.5", "-1", "2", "0.1"),  # the time would be negative
    ],
)
def test_a_step_across_a_kink_must_end_before_it(start, speed, length, place):
    def state(t):
        return (arb("-0.1") if t == arb(length) else arb(place)), arb("1e9")

    step = SimpleNamespace(us=[arb(start)], ws=[arb(speed)], length=arb(length), state=state, shortened=lambda t: t)
    with pytest.raises(UndecidedError, match="passage of a kink"):
        trajectory._up_to_a_kink(SimpleNamespace(kinked=True), step)


def test_a_step_stops_before_a_kink():
    """The orbit of the kinked force passes u = 0 between pieces, and one with a smooth force does not care."""
    with ctx.workprec(90):
        places = [
            p.taylor.us[0]
            for p in half_swing_pieces(EvenWell(FORCES["place"]), arb(1), arb(0))
            if isinstance(p, trajectory.Step)
        ]
        smooth = [
            p.taylor.us[0] for p in half_swing_pieces(EvenWell(AIR), arb(1), arb(0)) if isinstance(p, trajectory.Step)
        ]
    assert any(u == 0 for u in places) and not any(u == 0 for u in smooth)


def test_ignoring_a_kink_is_seen(monkeypatch):
    """With the polynomial of one side used on the other the next turning point is another one."""
    right = orbit(FORCES["place"], 1, 90)
    with monkeypatch.context() as patch:
        patch.setattr(WellForce, "kinked", False)
        wrong = orbit(replace(FORCES["place"]), 1, 90)
    assert abs(right.turn - wrong.turn) > arb(1e-6) > right.miss


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


@pytest.mark.parametrize("name", ["pendulum", "duffing", "place"])
def test_a_landing_holds_the_orbits_of_both_ends(name):
    """In place by its gap and in time by its lateness; both are within a factor of twenty of what is seen."""
    wide, gap, late, ends = shifted(FORCES[name], arb("1.5"), arb(2) ** -24)
    with ctx.workprec(120):
        apart = max((abs(end.turn - wide.turn) for end in ends), key=float)
        later = max((abs(end.clock - wide.clock) for end in ends), key=float)
        assert apart <= gap < 20 * apart and later <= late < 20 * later
        assert gap > wide.miss


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
