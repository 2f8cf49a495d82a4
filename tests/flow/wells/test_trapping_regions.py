"""Traps beside any spring, up to their edges, and what lies inside the well."""

from dataclasses import replace
from types import SimpleNamespace

import pytest
from flint import arb, ctx

from asymptotics.flow.trajectory import half_swing_pieces
from asymptotics.flow.wells import even_well as wells
from asymptotics.flow.wells.even_well import EvenWell
from asymptotics.flow.wells.trapping_regions import _critical, _held, inside, trap
from asymptotics.numbers.exact import parse_real
from tests.flow.forces import FREE, in_a_well
from tests.flow.forces import WELLS as FORCES


def test_what_may_be_held_or_lie_on_a_slope_that_turns_round_is_no_trap():
    with ctx.workprec(60):
        soft = in_a_well({0: "1/10", "1/2": 5}, {3: "-1/2"})
        assert trap(soft, arb("0.3"), arb(0)) == "creeps" and trap(soft, arb("1.2"), arb(0)) is None
        assert trap(in_a_well({"1/2": 1}), arb("0.01", "0.02"), arb(0)) is None
        assert _held(soft, arb("0.05")) is None and _held(soft, arb("0.3")) is not None


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


def test_the_place_of_rest_under_an_uncertain_friction_has_two_ends():
    """u - g = 0 for a friction g between 1/5 and 2/5: every such g is held, in the last place that was halved."""
    force = replace(FREE, grips=((arb("0.3", "0.1"), 0),))
    held = _held(force, arb(1))
    assert held.contains(arb("0.21")) and held.contains(arb("0.39")) and held.rad() < arb("0.26")


def test_the_trap_of_creep_has_its_boundary():
    """(w/c)^(1/2) <= K y/epsilon with c^(1/2) = 4/3 and the largest slope K = 1 of a spring that softens."""
    soft, y = in_a_well({"1/2": 1}, {3: "-1/2"}), arb("0.05")
    edge = (arb(4) / 3 * y) ** 2
    assert trap(soft, y, edge * arb("0.9")) == "creeps" and trap(soft, y, edge * arb("1.05")) is None
    steep = (arb(1) / 6).sqrt() * 9 / 16  # c^2 y^2 < 1/6 with c = 16/9
    assert trap(soft, steep * arb("0.9"), arb(0)) == "creeps" and trap(soft, steep * arb("1.05"), arb(0)) is None


def test_traps_and_edges_are_asked_about_the_whole_error(monkeypatch):
    force, seen, given = in_a_well({"1/2": "1/9"}, "pendulum"), [], arb(2) ** -12
    monkeypatch.setattr(wells, "trap", lambda _force, u, w: seen.append((u.rad(), w.rad())))
    monkeypatch.setattr(wells, "beyond", lambda _force, u: seen.append((u.rad(), arb(1))))
    with ctx.workprec(60):
        pieces = list(half_swing_pieces(EvenWell(force), arb(1), arb(0), given))
        unit = pieces[0].unit
    assert len(seen) >= 4 and all(u >= given / unit * arb("0.999") and w >= given for u, w in seen)
