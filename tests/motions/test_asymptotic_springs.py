"""The asymptotic motion with springs and position-dependent losses against SciPy's DOP853."""

from math import pi

import numpy as np
import pytest
from flint import arb, ctx
from scipy.integrate import solve_ivp

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.normal_form.expansion import expansion_of
from asymptotics.law import Oscillator
from asymptotics.motions.asymptotic import AsymptoticMotion
from asymptotics.motions.waveform import waveform_at
from asymptotics.terms import Term


def truth(oscillator, times):
    """x at rising times by DOP853, restarted where x or v changes its sign: there the forces have their kinks."""
    k, m = float(oscillator.stiffness.ball()), float(oscillator.mass.ball())
    forces = [(float(t.b.ball()), float(t.velocity.ball()), t) for t in oscillator.law.terms]

    def slope(_, y):
        x, v = y
        force = k * x
        for b, power, t in forces:
            if t.family:
                force += k * (np.sin(x) - x)
            else:
                odd, even = (v, x) if t.sign < 0 else (x, v)
                powers = (power, t.position) if t.sign < 0 else (t.position, power)
                force += b * np.sign(odd) * abs(odd) ** powers[0] * abs(even) ** powers[1]
        return [v, -force / m]

    def x_vanishes(_, y):
        return y[0]

    def v_vanishes(_, y):
        return y[1]

    x_vanishes.terminal = v_vanishes.terminal = True
    now, state, found = 0.0, [float(oscillator.x0.ball()), float(oscillator.v0.ball())], {}
    while now < times[-1]:
        run = solve_ivp(slope, (now, times[-1]), state, method="DOP853", rtol=1e-12, atol=1e-14, dense_output=True,
                        events=(x_vanishes, v_vanishes))  # fmt: skip
        found |= {t: float(run.sol(t)[0]) for t in times if now <= t <= run.t[-1]}
        now, state = float(run.t[-1]), run.y[:, -1]
        if now < times[-1]:  # step off the event, by less than the tolerance sees
            state, now = state + 1e-9 * np.array(slope(now, state)), now + 1e-9
    return [found[t] for t in times]


CASES = {
    "duffing": ({2: "1/10"}, {"spring": {3: "1/2"}}),
    "duffing, weak": ({2: "1/10"}, {"spring": {3: "1/50"}}),
    "softening": ({"3/2": "1/20"}, {"spring": {3: "-2/5"}}),
    "square root loss": ({"1/2": "1/20"}, {"spring": {3: "1/5"}}),
    "pendulum": ({2: "1/20"}, {"spring": "pendulum", "x0": "3/2"}),
    "velocity in the spring": ({1: "1/20"}, {"spring": {(3, "1/2"): "1/3"}}),
    "position in the loss": ({("3/2", 2): "1/5", 1: "1/50"}, {}),
    "kinked spring": ({1: "1/10"}, {"spring": {2: "1/5"}}),
    "no loss": ({1: 0}, {"spring": {3: "1/5"}}),
    "units and a velocity": (
        {1: "1/20"},
        {"spring": {3: "1/3"}, "mass": "3/2", "stiffness": 7, "x0": "-1/2", "v0": "2/3"},
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_the_estimate_covers_the_error(name):
    law, rest = CASES[name]
    oscillator, times = Oscillator(law, **rest), [3.0, 13.0]
    reference = truth(oscillator, times)
    for order in (1, 3):
        motion = AsymptoticMotion.of(oscillator, order)
        for t, x in zip(times, reference):
            point = motion.at(str(t), 12)
            assert abs(float(point.x) - x) < float(point.error) + 1e-9
            assert abs(motion.sample([t]).x[0] - float(point.x)) < 1e-10


@pytest.mark.parametrize("order", [1, 2, 3])
def test_the_error_falls_like_the_order(order):
    """sup |x_N - x| over a fixed time: a spring in the phase at first order leaves delta^N, as losses do."""
    times = [float(t) for t in np.linspace(0.5, 8, 16)]
    sizes = []
    for e in ("1/20", "1/40"):
        oscillator = Oscillator({2: e}, spring={3: e})
        found = AsymptoticMotion.of(oscillator, order).sample(times).x
        sizes.append(np.max(np.abs(found - np.array(truth(oscillator, times)))))
    assert order - 0.3 < np.log2(sizes[0] / sizes[1]) < order + 1.3


def test_a_spring_with_the_sign_of_a_loss_is_seen():
    """Near misses: the spring that pulls the other way, and a loss in its place, miss by far more."""
    oscillator = Oscillator({2: "1/10"}, spring={3: "1/20"})
    x = truth(oscillator, [7.0])[0]
    right = AsymptoticMotion.of(oscillator).at(7, 12)
    assert abs(float(right.x) - x) < float(right.error) < 1e-3
    for wrong in (Oscillator({2: "1/10"}, spring={3: "-1/20"}), Oscillator({2: "1/10", 3: "1/20"})):
        assert abs(float(AsymptoticMotion.of(wrong).at(7, 12).x) - x) > 20 * float(right.error)


def test_reversal_counts_the_losses():
    """P vanishes at pi/2 for an odd number of losses, Q for an even one; by total degree it is wrong."""
    terms = [Term(1, "3/2"), Term(1, 0, 3, "position")]
    with ctx.workprec(100):
        flow = expansion_of(quarter_swing(terms, 4), arithmetic="certified").flow
        found = waveform_at(flow, Forces.of(terms, 3), (arb.pi() / 2).mid(), 3)
        for key, (p, q) in found.items():
            assert abs(p if key[0] % 2 else q) < arb(10) ** -24
        assert abs(found[0, 1][0]) > arb("0.01")


def test_without_losses_the_phase_turns_steadily():
    """x'' + x + x^3/10: the period of the series against DOP853 at one full turn, and the amplitude stays."""
    oscillator = Oscillator({1: 0}, spring={3: "1/10"})
    point = AsymptoticMotion.of(oscillator, 4).at("20", 12)
    assert float(point.amplitude) == 1
    assert float(point.phase) / 20 == pytest.approx(3 / 80 - 21 / 25600, abs=1e-4)


@pytest.mark.parametrize(
    ("law", "rest", "order", "name"),
    [
        ({2: "1/10"}, {"spring": {3: "-3/2"}}, 3, "spring"),
        ({2: "1/10"}, {"spring": "pendulum", "x0": "16/5"}, 3, "spring"),
        ({2: "1/10"}, {"spring": {3: "-1/5"}, "v0": 1}, 3, "v0"),
        ({2: "1/10"}, {"spring": "pendulum", "v0": 1}, 3, "v0"),
        ({2: "1/10"}, {"spring": {(3, 2): "-1/5"}}, 3, "spring"),
        ({0: "1/10"}, {"spring": {3: "1/5"}}, 3, "law"),
        ({(1, 1): "1/10"}, {}, 3, "order"),
        ({1: "1/10"}, {"spring": {2: "1/10"}}, 4, "order"),
    ],
)
def test_what_is_not_known_is_refused_by_name(law, rest, order, name):
    with pytest.raises(InputError, match=f"argument {name}: "):
        AsymptoticMotion.of(Oscillator(law, **rest), order)


def test_a_strong_spring_is_said_to_be_so():
    point = AsymptoticMotion.of(Oscillator({2: "1/10"}, spring={3: 5})).at(7, 12)
    assert "not small" in point.notes[0] and float(point.error) >= 1
    assert AsymptoticMotion.of(Oscillator({2: "1/10"}, spring={3: 5})).sample([0.0, pi]).x.shape == (2,)
