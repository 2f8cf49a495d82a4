"""How a motion comes to rest: the arc of friction alone, from a turning point or from the start."""

from decimal import Decimal
from fractions import Fraction
from math import hypot, pi
from types import SimpleNamespace

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.motions.stopping import LastSwing, _arc_from, arc

REACH = 0.3


def path(target, turns):
    """A motion from X - i X' = ``target`` whose turning points (number -> time, place) are known."""
    frame = SimpleNamespace(target=target)
    return SimpleNamespace(
        flow=SimpleNamespace(frame=frame),
        turn=lambda number: turns[number][0] if number in turns else None,
        hold=lambda number, tau: turns[number][1] if turns[number][0] == tau else None,
    )


@pytest.mark.parametrize("target", [0.9 - 0.4j, 0.9 + 0.4j, -0.9 - 0.4j, -0.9 + 0.4j])
def test_an_arc_before_the_first_turning_point_begins_at_the_start(target):
    """With the place and the speed of the start, X - i X' = target."""
    found = _arc_from(path(target, {0: (1.0, 0.9)}), -1, REACH)
    X, V = (part[0] for part in found.at(np.array([0.0])))
    assert (found.begin, found.turn) == (0.0, None) and complex(X, -V) == pytest.approx(target, rel=1e-14)


@pytest.mark.parametrize("place", [0.9, -0.9])
def test_an_arc_after_a_turning_point_begins_there_at_rest(place):
    found = _arc_from(path(1 + 0j, {2: (6.5, place)}), 2, REACH)
    X, V = (part[0] for part in found.at(np.array([6.5])))
    assert (found.begin, found.turn) == (6.5, 2) and pytest.approx((place, 0.0), abs=1e-14) == (X, V)
    assert found.end == pytest.approx(6.5 + pi, rel=1e-15) and found.hold == pytest.approx(
        -place + 2 * REACH * np.sign(place)
    )


@pytest.mark.parametrize(
    "state", [(0.9, 0.4), (0.9, -0.4), (-0.9, 0.4), (-0.9, -0.4), (0.1, -0.8), (0.8, 0.0), (-0.8, 0.0)]
)
def test_an_arc_passes_through_its_state_and_slides_against_friction(state):
    """X'' = -(X - centre on the side of the motion): the friction pulls against the speed, and it ends at rest."""
    side, radius, beta = arc(*state, REACH)
    assert radius == pytest.approx(hypot(side * state[0] - REACH, state[1]), rel=1e-15)
    assert side == (np.sign(state[0]) if state[1] == 0 else -np.sign(state[1]))
    assert -radius * np.sin(beta) * side == pytest.approx(state[1], abs=1e-15)
    swing = LastSwing.of(2.0, state, REACH)
    tau = np.linspace(2.0, swing.end - 1e-9, 9)
    X, V = swing.at(tau)
    assert (X[0], V[0]) == pytest.approx(state, abs=1e-15) and (side * V[1:] <= 1e-9).all()
    after, still = swing.at(np.array([swing.end, swing.end + 5]))
    assert after == pytest.approx([X[-1]] * 2, abs=1e-8) and still.tolist() == [0.0, 0.0]


@pytest.mark.parametrize("place", [0.3, -0.2, 0.0])
def test_at_rest_within_the_reach_of_friction_the_mass_stays(place):
    swing = LastSwing.of(2.0, (place, 0.0), REACH, 5)
    assert (swing.begin, swing.end, swing.hold, swing.radius, swing.turn) == (2.0, 2.0, place, 0.0, 5)


def test_notes_tell_times_in_the_frame_of_the_law():
    """A law alone has no seconds."""
    for law, seconds, bare in (
        ({0: "1/10", 2: "1/10"}, "mass from 12.5727 s on", "mass from tau = 12.5727 on"),
        ({"1/2": "1/5"}, "extinction time 17.9721 s of", "extinction time tau = 17.9721 of"),
    ):
        for given, told in ((asy.Oscillator(law), seconds), (law, bare)):
            motion = asy.motion(given, order=2)
            for notes in (motion.at(30).notes, motion.sample([30.0]).notes):
                assert any(told in note for note in notes), notes


@pytest.mark.parametrize("order", [1, 2, 4])
@pytest.mark.parametrize(("strength", "held"), [("1/7", 3), ("1/3", 1), ("1/5", 2), ("1/27", 13), ("1/51", 25)])
def test_a_tie_of_dry_friction_is_held_where_it_is(strength, held, order):
    """x_n = (-1)^n (1 - 2 n/7) is 1/7 = eps_0 at n = 3; the least bit less friction, and it swings once more."""
    for less, turn in ((Fraction(0), held), (Fraction(1, 10**10), held + 1)):
        b = Fraction(strength) - less
        motion = asy.motion({0: b}, order=order)
        exact = asy.reference({0: b})
        end = f"mass from tau = {turn * pi:.6g} on"
        assert any(end in note for note in motion.sample([200.0]).notes)
        point, truth = motion.at(200, digits=20), exact.at(200, digits=20)
        assert any(end in note for note in point.notes)
        if order > 1:
            assert abs(Decimal(point.x) - Decimal(truth.x)) <= Decimal(point.error)
