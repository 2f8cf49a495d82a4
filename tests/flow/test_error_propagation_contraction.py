"""How turning points draw together: by energy, and by viscous loss, each part where leaving it out would be refuted."""

import pytest
from flint import arb, ctx

from asymptotics.flow import error_propagation
from asymptotics.flow.error_propagation import contraction_by_energy
from asymptotics.flow.trajectory import half_swing_pieces
from asymptotics.flow.wells.even_well import EvenWell
from tests.flow.forces import FREE, in_a_well
from tests.flow.forces import WELLS as FORCES

LOSSY = in_a_well({1: "1/2"})


def orbit(force, p, bits=160):
    with ctx.workprec(bits):
        *_, last = half_swing_pieces(EvenWell(force), arb(p), arb(0))
        return last


TOP = FORCES["free pendulum"]


def test_the_time_outside_counts_both_ends_of_the_error():
    """The fall begins where the force is least, the loss counts where it is largest, the stop where it is weakest."""
    e = arb("0.25")
    found = error_propagation._outside(FREE, arb(1), e, arb(-1), arb(0), arb(0))
    assert found >= 2 * (e / (1 - e)).sqrt() * arb("0.999999")
    square = arb(2) ** -12
    found = error_propagation._outside(FREE, arb(1), arb(2) ** -30, arb(-1), e, square)
    assert found >= (2 * square).sqrt() / (1 - e) * arb("0.999999")
    assert not error_propagation._outside(LOSSY, arb(1), e, arb(-1), arb(0), arb(0)).is_finite()


@pytest.mark.parametrize(
    "name", ["free pendulum", "pendulum", "duffing", "soft, sqrt(2)", "place", "dry beside springs"]
)
def test_turning_points_draw_together_at_most_as_the_bound_says(name):
    force, p, e = FORCES[name], arb(1), arb(2) ** -30
    one, other = orbit(force, p), orbit(force, p + e)
    bound = contraction_by_energy(force, p, e, one.clock, arb(0), one.turn, arb(0))
    with ctx.workprec(160):
        truth = abs(other.turn - one.turn)
        assert truth <= bound and bound < 3 * e
        if name == "free pendulum":
            assert bound / 2 < truth


def test_viscous_loss_draws_them_together_and_the_bound_knows_how_fast():
    force, e = in_a_well({1: "1/2"}, "pendulum"), arb(2) ** -40
    one, other = orbit(force, 2), orbit(force, 2 + e)
    bound = contraction_by_energy(force, arb(2), e, one.clock, arb(0), one.turn, arb(0))
    with ctx.workprec(160):
        truth = abs(other.turn - one.turn)
        assert truth <= bound and bound / 2 < truth and truth < e / 2


@pytest.mark.parametrize(("p", "e"), [("0.25", "0.125"), ("1", "0.25")])
def test_contraction_counts_the_force_at_the_farther_start(p, e, monkeypatch):
    """The energy between the two starts: e times the force at the nearer one is less, at the farther hardly more."""
    monkeypatch.setattr(error_propagation, "turning_gap", lambda _force, _turn, square, _beyond: square)
    p, e = arb(p), arb(e)
    truth = p.cos() - (p + e).cos()
    square = contraction_by_energy(TOP, p, e, arb(3), arb(0), -p, arb(0))
    assert e * p.sin() < truth <= square < truth * arb("1.3")


def test_viscous_contraction_leaves_out_the_first_fall_and_the_last_stop(monkeypatch):
    """The time that the factor counts is shorter by at least the free fall through e, and not by much more."""
    monkeypatch.setattr(error_propagation, "turning_gap", lambda _force, _turn, square, _beyond=None: square)
    force, e, duration = in_a_well({1: "1/2"}), arb(2) ** -12, arb(3)
    square = contraction_by_energy(force, arb(1), e, duration, arb(0), -arb("0.45"), arb(0))
    common = -(square / (e * (1 + e))).log() * 2
    assert duration - 12 * (2 * e).sqrt() < common < duration - (2 * e).sqrt()


def test_viscous_contraction_counts_the_shorter_of_the_two_durations():
    """Whichever motion the later one is, and whatever the clock's own radius leaves open."""
    force, e, late = in_a_well({1: "1/2"}), arb(2) ** -12, arb("0.25")

    def bound(clock, late):
        return contraction_by_energy(force, arb(1), e, clock, late, -arb("0.45"), arb(0))

    shorter = bound(arb(3) - late, arb(0)) * arb("0.9999")
    assert bound(arb(3), late) >= shorter and bound(arb(3, late), arb(0)) >= shorter
    assert bound(arb(3), arb(0)) < shorter
    assert bound(arb(3), arb(9)) == bound(arb(0), arb(0))  # no time that is certain: nothing contracts


def test_viscous_contraction_counts_only_the_time_that_both_spend():
    """Linear loss beside a linear spring, exactly: both fall by the same factor, and the bound is above it."""
    force = in_a_well({1: "1/2"})
    with ctx.workprec(120):
        rate, omega = arb(1) / 4, (1 - arb(1) / 16).sqrt()
        duration, q = arb.pi() / omega, (-rate * arb.pi() / omega).exp()
        for e in (arb(2) ** -6, arb(2) ** -20):
            bound = contraction_by_energy(force, arb(1), e, duration, arb(0), -q.mid(), q.rad())
            assert q * e <= bound
        assert bound < q * e * arb("1.3")
        assert contraction_by_energy(
            force, arb(1), arb(2) ** -6, duration, arb(0), -q.mid(), q.rad()
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
