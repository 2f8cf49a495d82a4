"""What one law predicts of one run: turning points, their times and the passages, about an offset, with derivatives."""

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from asymptotics.decays.identification.fitting.model import Model
from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.decays.identification.forward.swing import HalfSwingModel
from asymptotics.decays.identification.measuring.observations import Observations

E1, E2, OMEGA, T0, OFFSET = 0.05, 0.04, 3.0, 0.7, 2e-3


@cache
def motion(start, offset, count=9):
    """(n, x, t, passage_t) of x'' + omega^2 (x - offset) + ... from rest at ``start`` about the offset, by SciPy."""
    law = lambda _, y: [y[1], -y[0] - E1 * y[1] - E2 * y[1] * abs(y[1])]  # noqa: E731
    turns, passes = (lambda _, y: y[1]), (lambda _, y: y[0] + offset)
    found = solve_ivp(
        law, (0, 3.3 * count), [start, 0.0], events=[turns, passes], method="DOP853", rtol=1e-11, atol=1e-13
    )
    n, later = np.arange(count), found.t_events[0] > 0.1
    x = np.array([start, *found.y_events[0][later, 0]])[:count] + offset
    times = np.array([0.0, *found.t_events[0][later]])[:count]
    return n, x, T0 + times / OMEGA, T0 + found.t_events[1][: count - 1] / OMEGA


def model_of(start, offset, text="1+2", shift=0):
    n, x, t, p = motion(start, offset)
    first = slice(shift, None)
    seen = Observations.of(n[first], x[first], t[first], passage_n=n[:-1][first], passage_t=p[first])
    candidate = read_candidate(text)
    return Model(HalfSwingModel(candidate.elements, candidate.free), seen), seen


def theta_of(model, seen, offset, strengths=(E1, E2), weights=(0, 1)):
    size = abs(seen.x[0] - offset)
    law = [s * model.reference**w for s, w in zip(strengths, weights, strict=True)]
    return np.array([np.log(size / model.reference), *law, offset, np.log(OMEGA), seen.t[0]])


@pytest.mark.parametrize("offset", [OFFSET, -OFFSET])
@pytest.mark.parametrize("start", [1.0, -1.0])
@pytest.mark.parametrize("shift", [0, 1])
def test_turning_points_times_and_passages_are_those_of_the_motion_about_its_offset(start, offset, shift):
    """On both sides, from an even and from an odd turning point; passages to first order in the offset."""
    model, seen = model_of(start, offset, shift=shift)
    predicted, _ = model.predict(theta_of(model, seen, offset))
    x, t, p = (predicted[group] for group in model.groups)
    assert x == pytest.approx(seen.x, abs=1e-7) and t == pytest.approx(seen.t, abs=1e-7)
    late = np.abs(p - seen.passage_t)
    assert len(p) == 8 - shift and late.max() < 4 * OFFSET**2
    plain = model.predict(theta_of(model, seen, 0.0))[0][model.groups[2]]
    assert (np.abs(plain - seen.passage_t) > OFFSET / 6).all()  # without the offset they are off by it


@pytest.mark.parametrize("text", ["1+2", "1+s3", "free"])
def test_the_derivatives_are_those_of_what_is_predicted(text):
    model, seen = model_of(1.0, OFFSET, text)
    strengths = {"1+2": [0.05, 0.04], "1+s3": [0.05, 0.1], "free": [0.05, 1.4]}[text]
    theta = np.array([0.02, *strengths, 0.03, np.log(OMEGA), T0])
    predicted, slopes = model.predict(theta)
    assert slopes.shape == (len(seen.x) + len(seen.t) + len(seen.passage_t), len(theta)) == (len(predicted), 6)
    for i, step in enumerate(np.eye(len(theta)) * 1e-5):
        numeric = (model.predict(theta + step)[0] - model.predict(theta - step)[0]) / 2e-5
        assert slopes[:, i] == pytest.approx(numeric, abs=1e-6 + 1e-5 * np.abs(numeric).max())


@pytest.mark.parametrize(("count", "offset"), [(7, False), (8, True)])
def test_an_offset_needs_eight_turning_points(count, offset):
    candidate = read_candidate("1")
    n = np.arange(count)
    model = Model(HalfSwingModel(candidate.elements, candidate.free), Observations.of(n, 0.9**n * (-1.0) ** n))
    assert model.offset == offset and model.size == 2 + offset


def test_weights_within_a_kind_are_those_of_its_known_errors():
    """Their common size is found with the fit; each datum has its share."""
    n, candidate = np.arange(9), read_candidate("1")
    seen = Observations.of(
        n, 0.9**n * (-1.0) ** n, n + 0.5, passage_n=n[:-1], passage_t=n[:-1] + 1.0, sigma_x=np.where(n < 4, 1.0, 3.0)
    )
    model = Model(HalfSwingModel(candidate.elements, candidate.free), seen)
    sigma = model.scale_vector({"x": 2.0, "t": 5.0, "passage": 7.0})
    mean = np.sqrt((4 * 1 + 5 * 9) / 9)
    assert sigma[model.groups[0]] == pytest.approx(2.0 * np.where(n < 4, 1.0, 3.0) / mean)
    assert (sigma[model.groups[1]] == 5.0).all() and (sigma[model.groups[2]] == 7.0).all() and len(sigma) == 26
    assert model.kinds == ["x", "t", "passage"]


@pytest.mark.parametrize(("text", "unit"), [("1+2", ""), ("1+2+pendulum", "rad"), ("1+2+pendulum", "deg")])
def test_the_derivatives_of_the_amplitudes_are_those_of_their_values(text, unit):
    """Of a pendulum the angle grows faster than its coordinate 2 sin(x/2): at 120 degrees twice as fast."""
    candidate, first = read_candidate(text), {"": 1.0, "rad": 2.0944, "deg": 120.0}[unit]
    n = np.arange(12)
    seen = Observations.of(n, first * (-0.9) ** n, 3.0 * n, unit=unit)
    model = Model(HalfSwingModel(candidate.elements, candidate.free), seen, pendulum=candidate.pendulum)
    law = np.array([-0.01, 0.05, 0.04])
    theta = np.array([*law, 0.0, 0.0, 0.0])
    found = model.amplitudes(theta)[1]
    for i, step in enumerate(np.eye(len(theta))[: len(law)] * 1e-5):
        higher, lower = (model.amplitudes(theta + sign * step)[0] for sign in (1, -1))
        assert found[i] == pytest.approx((higher - lower) / 2e-5, rel=1e-5, abs=1e-7 * first)
