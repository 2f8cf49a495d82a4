"""From one turning point to the next: what each carries, and where it has none."""

from dataclasses import replace
from types import SimpleNamespace

import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.flow.error_propagation import contraction_by_energy
from asymptotics.flow.sequence import (
    after_arrival,
    first_from,
    next_turning,
    start_in_motion,
    sticks,
    turning_after_start,
)
from asymptotics.flow.trajectory import ArrivalPiece, half_swing_pieces
from asymptotics.flow.turning import TurningState, at_rest
from asymptotics.flow.wells.even_well import EvenWell
from tests.flow.forces import FREE, in_a_well
from tests.flow.forces import WELLS as FORCES


def orbit(force, p, bits=160):
    with ctx.workprec(bits):
        *_, last = half_swing_pieces(EvenWell(force), arb(p), arb(0))
        return last


TOP = FORCES["free pendulum"]


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
        again = contraction_by_energy(viscous, arb(1), e, piece.clock - 2 * e, arb(0), piece.turn, piece.miss)
        assert long >= again * arb("0.9999")


def test_dry_friction_at_an_uncertain_amplitude():
    force = in_a_well({0: "1/4"}, {3: "1/2"})
    held = TurningState(1, 1, arb("0.2"), arb(3), arb("0.01"), arb(0))
    assert sticks(EvenWell(force), held) and not sticks(EvenWell(force), replace(held, amplitude=arb("0.3")))
    for amplitude in ("0.23", "0.25"):
        with pytest.raises(UndecidedError, match="undecided"):
            sticks(EvenWell(force), replace(held, amplitude=arb(amplitude), amplitude_error=arb("0.05")))


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
