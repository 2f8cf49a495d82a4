"""A half-swing node by node: the speed is the slope of the place, the acceleration that of the law."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from asymptotics.decays.identification.fitting.waveform import _STEP, WaveformModel, _between, _nodes
from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.forward.swing import HalfSwingModel
from asymptotics.decays.identification.measuring.observations import Observations, Samples

A = np.log([1.0, 0.6])
LAWS = [("1", [0.1]), ("2", [0.1]), ("1+2", [0.05, 0.05]), ("3", [0.1]), ("1,2:", [0.1]), ("1+s3", [0.05, 0.2])]


def nodes_of(text, strengths, well=0.0, a=A):
    candidate = read_candidate(text)
    return _nodes(HalfSwingModel(candidate.elements, candidate.free), a, np.array(strengths), well)


def slope(tau, values):
    """d values/d tau at inner nodes: both are smooth in the phase, in which the nodes are evenly spaced."""
    phase = np.linspace(0, np.pi, len(tau))
    by_phase = [np.polynomial.Polynomial.fit(phase, v, 14).deriv()(phase[3:-3]) for v in (values, tau)]
    return by_phase[0] / by_phase[1]


@pytest.mark.parametrize(("text", "strengths"), LAWS)
def test_speed_and_acceleration_are_slopes_and_the_acceleration_is_that_of_the_law(text, strengths):
    tau, x, v, a = nodes_of(text, strengths)
    for swing in (0, 1):
        t, place, speed, force = (part[:, 0, swing] for part in (tau, x, v, a))
        assert np.abs(slope(t, place) - speed[3:-3]).max() < 1e-4
        assert np.abs(slope(t, speed) - force[3:-3]).max() < 1e-4
        given = sum(
            s
            * (
                np.abs(place) ** e.position * speed * np.abs(speed) ** (e.velocity - 1)
                if e.kind == "loss"
                else place**3
            )
            for s, e in zip(strengths, read_candidate(text).elements, strict=True)
        )
        assert np.abs(force + place + given)[1:-1].max() < 1e-6
        assert t[0] == 0 and place[0] == pytest.approx(np.exp(A[swing]), rel=1e-15) and abs(speed[-1]) < 1e-12


@pytest.mark.parametrize("strength", [0.0, 0.1])
def test_beside_the_spring_of_a_pendulum_the_place_is_an_angle(strength):
    """phi'' + sin phi + e phi' = 0 with phi = 2 well x."""
    well = 0.6
    tau, x, v, a = nodes_of("1", [strength], well, np.array([0.0]))
    t, place, speed, force = (part[:, 0, 0] for part in (tau, x, v, a))
    assert 2 * well * place[0] == pytest.approx(2 * np.arcsin(well), rel=1e-15)
    assert np.abs(slope(t, place) - speed[3:-3]).max() < 2e-4
    assert np.abs(2 * well * force + np.sin(2 * well * place) + strength * 2 * well * speed).max() < 2e-4
    assert (t[-1] > np.pi) and np.abs(np.diff(np.sign(place))).sum() == 2


def test_the_columns_are_moved_by_one_step_each():
    """The amplitude, then each parameter of the law: as if it had been given so."""
    candidate = read_candidate("1+2")
    swing, law = HalfSwingModel(candidate.elements, candidate.free), np.array([0.05, 0.03])
    whole = _nodes(swing, A, law, 0.0)
    moved = [(A, law), (A + _STEP, law), (A, law + [_STEP, 0]), (A, law + [0, _STEP])]
    for column, given in enumerate(moved):
        for part, again in zip(whole, _nodes(swing, *given, 0.0), strict=True):
            assert part[:, column] == pytest.approx(again[:, 0], abs=1e-14)


def test_a_free_exponent_moves_its_own_power():
    free, fixed = read_candidate("free"), read_candidate("2")
    one = _nodes(HalfSwingModel(free.elements, free.free), A, np.array([0.1, 2.0]), 0.0)
    other = _nodes(HalfSwingModel(fixed.elements, fixed.free), A, np.array([0.1]), 0.0)
    since, n = np.linspace(0.01, 3.1, 60), np.ones(60, int)
    assert _between(*one, n, since, 0)[0][0] == pytest.approx(_between(*other, n, since, 0)[0][0], abs=1e-6)
    assert one[0][-1, 0] == pytest.approx(other[0][-1, 0], abs=1e-6)
    assert np.abs(one[1][:, 3] - one[1][:, 0]).max() > 1e-8


def test_a_loss_that_stops_the_motion_has_no_half_swing():
    with pytest.raises(TooStrongError):
        nodes_of("0", [1.01], a=np.array([0.0]))


@pytest.mark.parametrize("order", [0, 1, 2])
def test_between_the_nodes_a_polynomial_of_degree_five_is_met_with_all_its_derivatives(order):
    """Two half-swings, three nodes, two columns; times before, between and after the nodes."""
    rng = np.random.default_rng(4)
    polynomials = [[np.polynomial.Polynomial(rng.standard_normal(6)) for _ in range(2)] for _ in range(2)]
    times = np.array([[[0.0, 0.0]] * 2, [[0.7, 0.9]] * 2, [[1.5, 2.0]] * 2])  # (nodes, columns, swings)

    def at(derivative):
        return np.array(
            [[[polynomials[s][c].deriv(derivative)(t[c][s]) for s in range(2)] for c in range(2)] for t in times]
        )

    n, since = np.array([0, 0, 0, 1, 1, 1, 0, 1]), np.array([-0.1, 0.2, 0.7, 0.3, 0.9, 1.7, 1.6, 2.3])
    found, following = _between(times, at(0), at(1), at(2), n, since, order)
    for column in range(2):
        true = [polynomials[s][column].deriv(order)(t) for s, t in zip(n, since, strict=True)]
        assert found[column] == pytest.approx(true, rel=1e-9, abs=1e-9)
    true = [polynomials[s][0].deriv(order + 1)(t) for s, t in zip(n, since, strict=True)]
    assert following == pytest.approx(true, rel=1e-9, abs=1e-9)


def test_the_fit_of_the_motion_begins_with_that_of_its_turning_points():
    """(ln A, law, [rest], ln omega, t_0) becomes (ln A, law, rest, drift, ln omega, t_0)."""
    model = SimpleNamespace(size=7, after=3, samples=SimpleNamespace(mode=()))
    for given, rest in (([0.1, 0.2, 0.3, 1.0, 2.0], 0.0), ([0.1, 0.2, 0.3, 0.5, 1.0, 2.0], 0.5)):
        assert WaveformModel.start(model, np.array(given)).tolist() == [0.1, 0.2, 0.3, rest, 0.0, 1.0, 2.0]
    whole = np.arange(7.0)
    assert WaveformModel.start(model, whole) is whole


def test_innovations_are_white_and_of_one_size():
    """Of an AR(1) process in continuous time, at uneven times: what is left of each after its memory of the last."""
    memory, count = 0.6, 4000
    rng = np.random.default_rng(5)
    gaps = rng.choice([1.0, 2.0, 0.5], count - 1)
    rho = memory**gaps
    x = [rng.standard_normal()]
    for r in rho:
        x.append(r * x[-1] + np.sqrt(1 - r * r) * rng.standard_normal())
    model = SimpleNamespace(samples=SimpleNamespace(memory=memory), _rho=rho)
    values = np.array(x)
    left = WaveformModel._innovations(model, values)
    assert len(left) == count and np.std(left) == pytest.approx(np.sqrt(1 - memory**2), rel=0.04)
    assert abs(np.corrcoef(left[1:], left[:-1])[0, 1]) < 0.04 < np.corrcoef(values[1:], values[:-1])[0, 1]
    both = WaveformModel._innovations(model, np.column_stack([values, 2 * values]))
    assert both == pytest.approx(np.column_stack([left, 2 * left]))
    model.samples.memory = 0
    assert WaveformModel._innovations(model, values) is values


def test_the_memory_over_a_gap_is_that_of_a_process_in_continuous_time():
    """Over two usual gaps the square, over half of one the root: after a longer gap less is remembered."""
    gaps = 0.3 * np.array([1.0, 1.0, 2.0, 0.5, 1.0, 4.0, 1.0])
    n, t = np.arange(4), np.concatenate([[0.0], np.cumsum(gaps)])
    samples = Samples(t, np.cos(t), 1e-3, 10.0, memory=0.64)
    seen = replace(Observations.of(n, (-0.9) ** n, np.pi * n), samples=samples)
    found = WaveformModel(HalfSwingModel(read_candidate("1").elements, False), seen)._rho
    assert found == pytest.approx([0.64, 0.64, 0.4096, 0.8, 0.64, 0.16777216, 0.64])
