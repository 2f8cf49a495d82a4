"""Parts of the bounds of a half-swing that no motion shows at full precision: each alone, at its least favourable."""

from dataclasses import dataclass, replace
from types import SimpleNamespace

import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.flow import dense, error_propagation, trajectory
from asymptotics.flow.damping import Damping
from asymptotics.flow.error_propagation import contraction_by_energy, contraction_by_ratio, points_forward, state_gap
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.sequence import start_in_motion, sticks, turning_after_start
from asymptotics.flow.trajectory import half_swing_pieces
from asymptotics.flow.turning import TurningState
from asymptotics.flow.wells.even_well import EvenWell
from asymptotics.flow.wells.trapping_regions import _held, trap
from asymptotics.law import Law
from tests.flow.forces import WELLS as FORCES
from tests.flow.forces import in_a_well
from tests.flow.wells.test_bounds import FREE

LAW = Law({1: "1/2"})
LOSSY = in_a_well({1: "1/2"})


@dataclass(frozen=True)
class Steep:
    """strongest = |u|^20 at the farthest place; rest = 0.3 - u."""

    def strongest(self, u, _w):
        return arb(abs(u).upper()) ** 20

    def restoring(self, u):
        return arb("0.3") - u


@dataclass(frozen=True)
class Gaining:
    """dG/du = 1 and dG/dw = 1: motions part as e^t."""

    nonexpansive: bool = False

    def slopes(self, _u, _w):
        return arb(1), arb(1)


def test_gains_part_motions_at_their_own_rate():
    found = error_propagation.distance_growth(Gaining(), arb(1), arb(0), arb(0), arb(2))
    assert arb(2).exp() <= found < arb(2).exp() * arb("1.001")


def test_a_force_must_point_forward_from_the_lower_to_the_upper_end():
    """Dry friction holds up to 1/2; 0.3 - u is below 0 from 0.3 on."""
    held = in_a_well({0: "1/2"})
    assert points_forward(held, arb(0), arb("0.4")) and not points_forward(held, arb(0), arb("0.4", "0.2"))
    assert points_forward(Steep(), arb("0.4"), arb("0.5")) and not points_forward(
        Steep(), arb("0.4", "0.2"), arb("0.5")
    )


def test_beside_a_linear_spring_the_turning_points_keep_their_ratio():
    """Linear damping: q e/p exactly."""
    with ctx.workprec(60):
        law = Damping.of_law(LAW)
        p, e, q = arb(1), arb(2) ** -10, arb("0.5")
        assert q * e / p <= contraction_by_energy(law, p, e, arb(3), -q, arb(0)) < q * e * arb("1.01")
        assert q * e / p <= contraction_by_ratio(law, p, e, q) < q * e * arb("1.01")
        assert (
            q * e / p <= contraction_by_energy(law, p, e, arb(3), -q / 2, q / 2) < q * e * arb("1.01")
        )  # q at the far end


def test_an_error_as_large_as_the_start_has_no_ratio():
    """Nothing is known of p - e <= 0: the distance is that of a nonexpansive flow."""
    law = Damping.of_law(LAW)
    assert [contraction_by_ratio(law, arb(1), arb(error), arb(1)) for error in (1, 2)] == [1, 2]


def test_the_time_outside_counts_both_ends_of_the_error():
    """The fall begins where the force is least, the loss counts where it is largest, the stop where it is weakest."""
    e = arb("0.25")
    found = error_propagation._outside(FREE, arb(1), e, arb(-1), arb(0), arb(0))
    assert found >= 2 * (e / (1 - e)).sqrt() * arb("0.999999")
    square = arb(2) ** -12
    found = error_propagation._outside(FREE, arb(1), arb(2) ** -30, arb(-1), e, square)
    assert found >= (2 * square).sqrt() / (1 - e) * arb("0.999999")
    assert not error_propagation._outside(LOSSY, arb(1), e, arb(-1), arb(0), arb(0)).is_finite()


def test_an_uncertain_time_moves_a_state_where_the_force_is_largest():
    flow = SimpleNamespace(force=Steep())
    du, dw = dense._moved(flow, arb(1), arb("0.8"), arb("0.01"))
    assert du >= arb("0.008") and dw >= arb("0.01") * (1 + arb("0.008")) ** 20


def test_the_distance_of_a_turning_point_counts_the_force_at_its_farther_place():
    flow = SimpleNamespace(force=Steep(), unit=lambda *_: arb(1))
    found = dense._distance(flow, TurningState(0, 1, arb(1), arb(0), arb("0.25"), arb("0.0001")))
    assert found >= arb("0.25") + arb("0.0001") * arb("1.25") ** 20


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


def expansion(turn, place):
    def state(w):
        return (turn if w == 0 else place), arb(1)

    return SimpleNamespace(state=state, reach=arb("0.1"), speed=lambda _unit: arb(1))


def test_an_expansion_that_reaches_a_kink_is_refused():
    kinked = EvenWell(in_a_well({2: "1/10"}, {2: "1/2"}))
    here = trajectory.FlowState(arb(0), arb("0.5"), arb(0), trajectory.CarriedErrors(arb(0), arb(0)))
    flow = replace_method(kinked, "expansion", lambda _place: expansion(arb("0.5"), arb("-0.1")))
    with pytest.raises(UndecidedError, match="reaches a kink"):
        trajectory._departure(flow, arb(1), here)
    flow = replace_method(kinked, "arrive", lambda _place, _w: expansion(arb("-0.5"), arb("0.1")))
    with pytest.raises(UndecidedError, match="reaches a kink"):
        trajectory._arrival(flow, arb(1), replace(here, u=arb("0.1"), w=arb("0.1")))


def replace_method(flow, name, method):
    """The flow with another method."""
    new = type("Changed", (type(flow),), {name: staticmethod(method)})
    return new(flow.force)


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


def test_a_first_motion_must_have_a_direction():
    with pytest.raises(UndecidedError, match="direction"):
        start_in_motion(EvenWell(FREE), arb(1), arb(0, "0.001"))


def test_a_first_turning_point_may_lie_outside_within_its_error():
    """A pendulum that turns at 3.1 +- 0.06 may have passed the top."""
    flow = EvenWell(FORCES["free pendulum"])
    piece = SimpleNamespace(
        flow=flow, turn=arb("-3.1"), clock=arb(1), late=lambda _: arb(0), gap=lambda _: arb("0.06")
    )  # fmt: skip
    with pytest.raises(UndecidedError, match="inside the well"):
        turning_after_start(piece, 1, arb(0))


def test_a_mass_beyond_its_place_of_rest_is_not_said_to_go_on():
    flow = EvenWell(in_a_well({0: "1/2"}))
    assert not sticks(flow, TurningState(0, 1, arb(2), arb(0), arb(0), arb(0)))
    with pytest.raises(UndecidedError, match="holds the mass"):
        sticks(flow, TurningState(0, 1, arb(-2), arb(0), arb(0), arb(0)))
    with pytest.raises(UndecidedError, match="holds the mass"):
        sticks(flow, TurningState(0, 1, arb("0.5"), arb(0), arb("0.01"), arb(0)))


def test_a_turning_point_is_not_near_while_the_place_may_be_on_this_side():
    spring = LinearSpring(Damping.of_law(LAW))
    with ctx.workprec(60):
        assert spring.turns_within(arb("-0.01"), arb("1e-6"), arb("1e-9"))
        assert not spring.turns_within(arb("-0.01"), arb("1e-6"), arb("0.02"))


def test_the_gap_of_a_state_counts_the_fall_through_its_error():
    """Energy beside the linear spring: a place farther by e turns farther by nearly as much."""
    with ctx.workprec(60):
        u, w, e = arb(-1), arb("0.05"), arb("0.001")
        turn = -(u * u + w * w).sqrt()
        found = state_gap(FREE, arb(1), u, w, turn.mid(), e)
        assert abs(-((u - e) ** 2 + w * w).sqrt() - turn) <= found < arb("0.0013")


def test_a_state_that_may_have_stopped_before_its_places_are_equal_has_no_gap():
    with pytest.raises(UndecidedError, match="too wide"):
        state_gap(FREE, arb(1), arb("-0.5"), arb("0.003"), arb("-0.50001"), arb("0.001"))


@dataclass(frozen=True)
class Gated:
    """-1, but about 0.4 anything."""

    nonexpansive: bool = False

    def restoring(self, u):
        return arb(0, 1) if u.overlaps(arb("0.4")) else arb(-1)

    def drag(self, _u, _w):
        return arb(0)


def test_the_force_ahead_is_asked_for_on_the_whole_way():
    """From the farther turning point, and from the place that the error allows: dry friction holds up to 1/2."""
    for force, u, w, turn, e in (
        (Gated(), "0.6", 1, "0.3", "0.001"),
        (in_a_well({0: "1/2"}), "0.45", 1, "-0.501", "0.06"),
    ):
        with pytest.raises(UndecidedError, match="force ahead"):
            state_gap(force, arb(1), arb(u), arb(w), arb(turn).mid(), arb(e))


def test_what_may_be_held_or_lie_on_a_slope_that_turns_round_is_no_trap():
    with ctx.workprec(60):
        soft = in_a_well({0: "1/10", "1/2": 5}, {3: "-1/2"})
        assert trap(soft, arb("0.3"), arb(0)) == "creeps" and trap(soft, arb("1.2"), arb(0)) is None
        assert trap(in_a_well({"1/2": 1}), arb("0.01", "0.02"), arb(0)) is None
        assert _held(soft, arb("0.05")) is None and _held(soft, arb("0.3")) is not None
