"""What a turn adds to the contraction where a loss is steep at rest: against motions that turn, and near misses."""

from dataclasses import replace

import numpy as np
import pytest
from flint import arb
from scipy.integrate import quad

from asymptotics.driven import contraction, turn
from asymptotics.driven.drive import Balls, Drive
from asymptotics.driven.orbit import orbit
from asymptotics.driven.trial import Trial
from asymptotics.errors import UndecidedError
from asymptotics.law import Oscillator
from asymptotics.numbers.context import ctx


def trial_of(law, omega="3/2") -> Trial:
    with ctx.workprec(100):
        return orbit(Drive.read(Oscillator(law), 1, omega)).trial


@pytest.fixture(scope="module")
def weak() -> Trial:
    return trial_of({0: "1/100"})


@pytest.fixture(scope="module")
def rooty() -> Trial:
    return trial_of({"1/2": "1/10"})


def test_a_motion_whose_speed_is_off_turns_within_the_delay(weak):
    """With x as on the orbit at its turn and the speed off by the room, slowed by a pull that hardly changes."""
    room = arb("0.001")
    found = turn.turn(weak, room)
    off = float((room / weak.balls.mu.sqrt()).mid())
    pull, dry, mu = (float(v.mid()) for v in (found.pull, weak.balls.losses[0][0], weak.balls.mu))
    slow, fast = off * mu / (pull + dry), off * mu / (pull - dry)
    # It moves on, and turns late by the first; or it has turned early, by the second.
    assert fast < float(found.delay) < 2 * slow
    late = weak.pieces[0].state(2 * found.delay)[1] + room / weak.balls.mu.sqrt()
    assert not late.mid() > found.speed and late.mid() > found.speed / 2


def test_the_pull_is_that_at_every_place_and_angle_of_the_room():
    """At omega_0, where the force changes most as the motion turns."""
    trial = trial_of({0: "3/10", 1: "1/5"}, 1)
    room, share = arb("0.001"), arb("0.98")
    found, balls, sign = turn.turn(trial, room), trial.balls, trial.pieces[0].sign
    apart, late = room / balls.k.sqrt() + 2 * found.delay * found.speed, 2 * found.delay
    there = [sign * (balls.f * (trial.theta + share * s * late).cos() - balls.k * (trial.X + share * r * apart))
             for s in (-1, 1) for r in (-1, 1)]  # fmt: skip
    assert all(found.pull.contains(value.mid()) for value in there)


def parts(balls: Balls, P: float) -> tuple[float, float]:
    """Of two motions that turn under one pull, by their parabolas: mu V^2 and (2 c tau)^2/mu in what friction takes."""
    c, mu, v = (float(n.mid()) for n in (balls.losses[0][0], balls.mu, arb("0.001")))
    tau = v * mu / (P + c)  # one is at rest, the other has the speed v left
    taken = quad(lambda t: 2 * c * ((P - c) * t + (P + c) * (tau - t)) / mu, 0, tau)[0]
    return taken / (mu * v**2), (2 * c * tau) ** 2 / mu / taken


@pytest.mark.parametrize("room", ["1e-20", "0.001"])
def test_mass_and_high_are_those_of_two_parabolas(weak, room):
    found = turn.turn(weak, arb(room))
    for P in (float(found.pull.lower()), float(found.pull.upper())):
        mass, high = parts(weak.balls, P)
        assert float(found.mass.lower()) <= mass * (1 + 1e-12) and high <= float(found.high.upper()) * (1 + 1e-12)
    if room == "1e-20":
        assert float(found.mass) > 0.999 * mass and float(found.high) < 1.001 * high
        # The law of a turn: V leaves it (P - c)/(P + c) of what it was.
        c = float(weak.balls.losses[0][0].mid())
        assert mass == pytest.approx((1 - ((P - c) / (P + c)) ** 2) / 2)


@pytest.mark.parametrize(("strength", "omega"), [("1/100", "3/2"), ("1/100", "2/3"), ("1/100", "3"), ("3/10", "3/2")])
def test_the_factor_of_a_period_is_no_less_than_that_of_its_map(strength, omega, monkeypatch):
    """Friction alone: nearby motions turn freely between the turns, and each turn leaves (P - c)/(P + c) of V."""
    found = trial_of({0: strength}, omega)
    with ctx.workprec(100):
        here, q = turn.turn(found, arb("1e-20")), contraction.factor(found, arb("1e-20"))
    P, c, phase = (float(v.mid()) for v in (here.pull, found.balls.losses[0][0],
                                            (found.balls.k / found.balls.mu).sqrt() * arb.pi()))  # fmt: skip
    half = np.diag([1, (P - c) / (P + c)]) @ [[np.cos(phase), np.sin(phase)], [-np.sin(phase), np.cos(phase)]]
    true = np.linalg.norm(half @ half, 2)
    assert true * (1 - 1e-9) <= float(q) < 1
    # Near miss: a turn that takes twice as much, and adds nothing.
    wrong = replace(here, mass=2 * here.mass, high=arb(0))
    monkeypatch.setattr(contraction, "turn", lambda *_: wrong)
    with ctx.workprec(100):
        assert not float(contraction.factor(found, arb("1e-20"))) >= true


def test_the_integral_of_the_slopes_is_that_of_two_motions(rooty):
    """sqrt(v): a quotient of differences of the trial orbit and one that turns late, beside the turn."""
    room = arb("0.001")
    with ctx.workprec(100):
        found = turn.turn(rooty, room)
    off, first, last = room / rooty.balls.mu.sqrt(), rooty.pieces[0], rooty.pieces[-1]
    c, mu, apart = (float(n.mid()) for n in (rooty.balls.losses[0][0], rooty.balls.mu, off))

    def quotient(s):
        own = -float(first.state(arb(s))[1].mid()) if s > 0 else float(last.state(arb(-s))[1].mid())
        root, other = (np.sign(v) * abs(v) ** 0.5 for v in (own, own + apart))
        return c / mu * (other - root) / apart

    ends = -float(last.length.mid()), float(first.length.mid())
    delay = float(found.delay)
    true = quad(quotient, *ends, points=[-delay, 0, delay], limit=200)[0]
    assert true < float(found.high.upper()) < 8 * true


def test_where_motions_turn_is_decided_or_not(weak):
    def refused(trial, room, word):
        with pytest.raises(UndecidedError, match=word):
            turn.turn(trial, arb(room))

    slow = replace(weak, pieces=(weak.pieces[0], replace(weak.pieces[1], growth=arb("0.99999")), *weak.pieces[2:]))
    short = replace(weak, pieces=(replace(weak.pieces[0], length=arb("1e-9")), *weak.pieces[1:]))
    refused(slow, "0.001", "between its turns")
    refused(short, "0.001", "where the motions")
    near = trial_of({0: "3/10"}, "2/3")
    assert near.balls.losses[0][0] < turn.turn(near, arb("1e-9")).pull.lower()
    pulled = replace(near, balls=replace(near.balls, losses=((turn.turn(near, arb("1e-9")).pull.upper(), arb(0)),)))
    refused(pulled, "1e-9", "sticks")


def test_an_exponent_of_which_it_is_not_known_whether_it_is_below_1():
    assert not turn.is_steep(Balls(arb(1), arb(1), arb(1), ((arb(1), arb(1)),)))
    assert turn.is_steep(Balls(arb(1), arb(1), arb(1), ((arb(1), arb(2)), (arb(1), arb("0.9")))))
    with pytest.raises(UndecidedError, match="below 1"):
        turn.is_steep(Balls(arb(1), arb(1), arb(1), ((arb(1), arb(1, "1e-9")),)))
