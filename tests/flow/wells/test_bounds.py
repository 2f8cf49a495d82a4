"""Every bound of a half-swing in a well bites: where it is nearly attained, half of it is refuted by the truth.

Where a bound keeps a stated slack, its constant is evaluated a second time, without balls.
"""

from dataclasses import replace
from types import SimpleNamespace

import mpmath
import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.flow import dense, trajectory
from asymptotics.flow.error_propagation import contraction_by_energy, growth, points_forward, turning_delay, turning_gap
from asymptotics.flow.sequence import after_arrival
from asymptotics.flow.trajectory import ArrivalPiece, half_swing_pieces
from asymptotics.flow.turning import TurningState, at_rest
from asymptotics.flow.wells import expansion as expansions
from asymptotics.flow.wells.even_well import EvenWell
from asymptotics.flow.wells.expansion import WellExpansion
from asymptotics.flow.wells.force import WellForce
from asymptotics.flow.wells.trapping_regions import _critical, inside, trap
from asymptotics.numbers.exact import parse_real
from tests.flow.forces import WELLS as FORCES
from tests.flow.forces import in_a_well

FREE = in_a_well({2: 0})
AIR = FORCES["pendulum"]


@pytest.mark.parametrize("name", FORCES)
@pytest.mark.parametrize("u0", [1, -1])
def test_the_majorant_bounds_the_coefficients_and_is_nearly_attained(name, u0):
    """Sum of |coefficients| at the edge of what is kept is below H; a small piece of the range attains it."""
    force = FORCES[name]
    with ctx.workprec(60):
        few = WellExpansion.at(force, arb(u0))
    with ctx.workprec(200):
        full = WellExpansion.at(force, arb(u0))
        w = min(few.reach, full.reach)
        (u, tau), (low_u, low_tau) = full.state(w), few.state(w)
        assert low_u.contains(u.mid()) and low_tau.contains(tau.mid())
        tiny = w * arb(2) ** -12
        fallen = abs(full.u0 - full.state(tiny)[0])
        bound = tiny**2 / (2 * abs(full.brake))
        assert fallen > bound / 2 and fallen < bound * 2  # H -> a


def test_the_tail_is_the_factor_times_the_majorant():
    """2^-G H* for the free pendulum, from the plan and the two equations of the majorant in floats."""
    force, sine, cosine = FORCES["free pendulum"], mpmath.sin(1), mpmath.cos(1)
    with ctx.workprec(40):
        few = WellExpansion.at(force, arb(1))
        plan, _ = expansions._plan(force, arb(1), force.restoring(arb(1)), None, 1.0)
    stretch, H = plan.stretch[0], mpmath.mpf(0)
    a = float(few.reach) ** 2 * 4**stretch / 2 / sine
    for _ in range(200):
        H = a / (1 - (sine * (mpmath.cosh(H) - 1) + cosine * mpmath.sinh(H)) / sine)
    again = 2 ** (-stretch * few.u.length() * float(few.step)) * H
    assert again <= float(few.tail) <= 1.15 * again
    with ctx.workprec(300):
        fine = WellExpansion.at(force, arb(1), few.reach).state(few.reach)[0]
        kept = few.u(few.reach**few.step.numerator)
        assert abs(kept.mid() - fine) <= few.tail + kept.rad()


@pytest.mark.parametrize("k", ["1/2", "2", "5"])
def test_growth_is_attained_in_the_worst_direction(k):
    """The linear spring, seen in the distance with another unit: (U, W) with k U = +-W grows at the full rate."""
    with ctx.workprec(120):
        unit = parse_real(k, "k").ball()
        t, e = arb(2) ** -10, arb(2) ** -40
        factor = growth(FREE, unit, arb(0), arb(1), t, e)
        best = arb(0)
        for W in (arb(1), arb(-1)):
            u, w = t.cos() / unit - W * t.sin(), W * t.cos() + t.sin() / unit
            best = max(best, (((unit * u) ** 2 + w**2) / 2).sqrt().mid())
        assert best <= factor and best - 1 > (factor - 1) / 2


def test_nothing_parts_in_the_own_unit():
    assert growth(FREE, arb(1), arb(0), arb(1), arb(3), arb(1e-9)) < 1 + arb(1e-9)


def orbit(force, p, bits=160):
    with ctx.workprec(bits):
        *_, last = half_swing_pieces(EvenWell(force), arb(p), arb(0))
        return last


@pytest.mark.parametrize(
    "name", ["free pendulum", "pendulum", "duffing", "soft, sqrt(2)", "place", "dry beside springs"]
)
def test_turning_points_draw_together_at_most_as_the_bound_says(name):
    force, p, e = FORCES[name], arb(1), arb(2) ** -30
    one, other = orbit(force, p), orbit(force, p + e)
    bound = contraction_by_energy(force, p, e, one.clock.lower(), one.turn, arb(0))
    with ctx.workprec(160):
        truth = abs(other.turn - one.turn)
        assert truth <= bound and bound < 3 * e
        if name == "free pendulum":
            assert bound / 2 < truth


def test_viscous_loss_draws_them_together_and_the_bound_knows_how_fast():
    force, e = in_a_well({1: "1/2"}, "pendulum"), arb(2) ** -40
    one, other = orbit(force, 2), orbit(force, 2 + e)
    bound = contraction_by_energy(force, arb(2), e, one.clock.lower(), one.turn, arb(0))
    with ctx.workprec(160):
        truth = abs(other.turn - one.turn)
        assert truth <= bound and bound / 2 < truth and truth < e / 2


def test_the_gap_and_the_lateness_are_attained_by_free_fall():
    """A mass that passes the turning point with the speed d turns d^2/2/|s_0| farther, d/|s_0| later."""
    d, turn = arb(2) ** -20, arb(-1)
    with ctx.workprec(160):
        radius = (1 + d * d).sqrt()
        farther, later = radius - 1, d.atan()
        gap = turning_gap(FREE, turn, (d * d / 2).upper())
        late = turning_delay(FREE, arb(1), turn, arb(0), d)
        assert farther <= gap and gap / 2 < farther
        assert later <= late and late / 2 < later


def test_a_turning_point_near_the_place_of_rest_is_undecided():
    for call in (
        lambda: turning_gap(FREE, arb(-1), arb(2)),
        lambda: turning_delay(FREE, arb(1), arb(-1), arb(0), arb(1)),
        lambda: growth(FORCES["duffing"], arb(1), arb(0), arb(1), arb(10), arb(1)),
    ):
        with pytest.raises(Exception, match=r"place of rest|part too fast"):
            call()


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


def test_the_window_about_a_turning_point_is_attained():
    """Within the time e the speed grows to e s_0."""
    here = TurningState(3, 1, arb(1), arb(10), arb(0), arb(2) ** -20)
    distance = dense._distance(EvenWell(FREE), here)
    with ctx.workprec(100):
        e = arb(2) ** -20
        truth = ((1 - e.cos()) ** 2 + e.sin() ** 2).sqrt()
        assert truth <= distance and distance / 2 < truth


def test_the_next_turning_point_carries_the_error_of_the_last():
    """An error of the start is neither forgotten nor doubled."""
    with ctx.workprec(120):
        e = arb(2) ** -30
        pieces = list(half_swing_pieces(EvenWell(FORCES["free pendulum"]), arb(1), arb(0), e))
        assert isinstance(pieces[-1], ArrivalPiece)
        there = after_arrival(TurningState(0, 1, arb(1), arb(0), e, arb(0)), pieces[-1])
        exactly = after_arrival(at_rest(arb(1)), orbit(FORCES["free pendulum"], 1, 120))
        shifted = orbit(FORCES["free pendulum"], 1 + e, 120)
        assert abs(shifted.turn + exactly.amplitude) <= there.amplitude_error < 2 * e
        assert abs(shifted.clock - exactly.time) <= there.time_error < 20 * e


@pytest.mark.parametrize("epsilon", ["2", "5/2", "7"])
def test_the_trap_of_linear_loss_has_its_boundary(epsilon):
    """Beside a softening spring w <= y (epsilon + sqrt(epsilon^2 - 4))/2 is a trap; nothing is claimed of the rest."""
    force = in_a_well({1: epsilon}, {3: "-1/4"})
    with ctx.workprec(100):
        e = arb(parse_real(epsilon, "e").ball())
        edge = (e + (e * e - 4).nonnegative_part().sqrt()) / 2 * arb("0.01")
        assert trap(force, arb("0.01"), edge * arb("0.999")) == "overdamped"
        assert trap(force, arb("0.01"), edge * arb("1.001")) is None
        assert trap(in_a_well({1: epsilon}, {3: "1/4"}), arb("0.5"), arb("1.9") * arb("0.5")) != "creeps"


def test_a_stiffer_chord_needs_more_loss():
    """K = 4 beside x + x^3 at x = 1: epsilon = 3 is no trap there, though it is one at the centre."""
    force = in_a_well({1: 3}, {3: 1})
    assert trap(force, arb(1), arb("0.1")) is None and trap(force, arb("0.1"), arb("0.1")) == "overdamped"


def test_creep_beside_springs_and_dry_friction():
    soft = in_a_well({"1/2": 1}, {3: "-1/2"})
    dry = in_a_well({"1/2": 1, 0: "1/10"}, {3: "1/2"})
    assert trap(soft, arb("0.05"), arb("0.001")) == trap(dry, arb("0.15"), arb("0.0001")) == "creeps"
    assert trap(dry, arb("0.09"), arb("0.0001")) is None  # held, not creeping
    assert trap(soft, arb("0.05"), arb("0.5")) is None


def test_what_lies_inside_the_well():
    pendulum, soft = FORCES["free pendulum"], in_a_well({2: 0}, {3: -1, 5: "1/3"})
    assert inside(pendulum, arb("3.14159")) is True and inside(pendulum, arb("3.1416")) is False
    assert inside(soft, arb(50)) is True  # 1 - y + y^2/3 has no zero
    assert inside(in_a_well({2: 0}, {3: -1, 5: "1/4"}), arb(3)) is not True  # a double zero at y = 2
    assert inside(in_a_well({2: 0}, {3: -1}), arb(1)) is False


def test_a_place_uncertain_beyond_the_edge_is_not_said_to_lie_outside():
    """The edge of a pendulum's well is pi = 3.14159...: [3.04, 3.16] has it inside, [3.15, 3.17] is beyond."""
    pendulum = FORCES["free pendulum"]
    assert inside(pendulum, arb("3.1", "0.06")) is None and inside(pendulum, arb("-3.1", "0.06")) is None
    assert inside(pendulum, arb("1.65", "1.55")) is None
    assert inside(pendulum, arb("3.16", "0.01")) is False and inside(pendulum, arb(2, "0.1")) is True


def test_the_force_ahead_must_point_forward():
    pendulum = FORCES["free pendulum"]
    assert points_forward(pendulum, arb(-3), arb("-0.01"))
    assert not points_forward(pendulum, arb("-3.2"), arb(-1))
    assert not points_forward(pendulum, arb(-1), arb("0.01"))


def test_a_force_that_turns_round_between_two_places_is_seen():
    """1 - 5 y + 5 y^2 < 0 for u^2 = y between (5 -+ sqrt 5)/10, 0.276 and 0.724, and not at the ends."""
    hump = in_a_well({2: 0}, {3: -5, 5: 5})
    assert all(hump.restoring(arb(end)) < 0 for end in ("-1", "-0.2"))
    assert not points_forward(hump, arb(-1), arb("-0.2"))
    assert points_forward(hump, arb(-1), arb("-0.86")) and points_forward(hump, arb("-0.52"), arb("-0.2"))


def test_critical_damping_holds_under_a_spring_that_only_softens():
    def spring(*strengths, rate=None):
        return SimpleNamespace(springs=[(arb(c), 3) for c in strengths], grips=False, rate=rate)

    assert _critical(spring(-1), arb(2)) and _critical(spring(rate=arb(1)), arb(2))
    for other in (spring(-1, 1), spring(rate=arb(0, 1))):
        assert not _critical(other, arb(2))


def test_no_exponent_from_1_on_creeps_beside_a_spring():
    """As beside the linear spring: the condition of the trap alone would hold at alpha = 3/2."""
    assert trap(in_a_well({"3/2": 10}, spring={3: "1/10"}), arb(1), arb(0)) is None
    assert trap(in_a_well({"1/2": 10}, spring={3: "1/10"}), arb(1), arb(0)) is not None


def test_where_dry_friction_may_hold_there_is_no_expansion():
    with pytest.raises(UndecidedError, match="holds the mass here"):
        WellExpansion.at(SimpleNamespace(restoring=lambda _: arb(0, 1)), arb(1))
