"""A second mode on demand: seen where nothing is taken off unasked, fitted beside the motion with its own intervals."""

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.fitting.waveform import WaveformModel
from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.decays.identification.measuring.mode_beside import beginning, strongest_line
from asymptotics.decays.identification.sources import load
from asymptotics.errors import InputError

EPSILON = 0.04 / np.sqrt(1 + 0.02**2)
"""Of e^(-0.02 t) cos(t), in the time omega_0 t."""


def two_modes(size=0.01, omega=2.7, rate=0.05, column="x", per_period=15, noise=1e-3, seed=0):
    t = np.arange(0, 150, 2 * np.pi / per_period)
    x = np.exp(-0.02 * t) * np.cos(t) + size * np.exp(-rate * t) * np.cos(omega * t + 0.7)
    return {"t": t, column: x + noise * np.random.default_rng(seed).standard_normal(len(t))}


def test_what_no_law_fits_is_the_law_with_a_second_mode():
    laws = ["1", "2"]
    alone = asy.identify(two_modes(), laws=laws, bootstrap=False)
    assert alone.verdict.kind == "none fits" and not any("second mode" in note for note in alone.notes)
    both = asy.identify(two_modes(), laws=laws, modes=2, bootstrap=False)
    assert both.verdict.text.startswith("identified: 1,") and both.law("1").law.epsilon[0].contains(EPSILON)
    fit = both.law("1").law.fit
    cosine, sine, omega, rate = fit.theta[fit.model.mode]
    assert omega == pytest.approx(2.7, abs=0.01) and rate == pytest.approx(0.05, abs=0.012)
    assert np.hypot(cosine, sine) == pytest.approx(0.01, rel=0.15)
    assert any(note.startswith("second mode: 2.7") for note in both.notes)


def test_intervals_hold_the_truth_beside_a_second_mode():
    hits = []
    for seed in range(12):
        data = two_modes(0.03, omega=[1.6, 2.7, 4.4][seed % 3], seed=seed)
        hits.append(asy.identify(data, laws=["1"], modes=2, bootstrap=False).law("1").law.epsilon[0].contains(EPSILON))
    assert sum(hits) >= 10


def test_the_derivatives_by_the_second_mode_are_those_of_the_prediction():
    (seen,) = load(two_modes(), modes=2)
    model = WaveformModel(read_candidate("1").swing(), seen)
    theta = np.array([0.01, 0.04, 0.0, 0.0, 0.02, -0.01, 2.7, 0.05, 0.0, 0.0])
    assert model.size == len(theta) and len(seen.samples.mode) == 4
    values, slopes = model.predict(theta)
    for k in range(model.mode.start, model.mode.stop):
        moved = theta.copy()
        moved[k] += 1e-6
        assert slopes[:, k] == pytest.approx((model.predict(moved)[0] - values) / 1e-6, abs=1e-4)


def test_the_beginning_is_the_nearest_decaying_wave():
    data = two_modes(noise=0.0, size=0.1)
    omega, line = strongest_line(data["t"], data["x"])
    cosine, sine, _, rate = beginning(data["t"], line, omega)
    assert omega == pytest.approx(2.7, abs=0.02) and rate == pytest.approx(0.05, rel=0.4)
    assert np.arctan2(-sine, cosine) == pytest.approx(0.7, abs=0.3)
    # Near miss: a record of one mode has its noise at most.
    alone = strongest_line(data["t"], np.exp(-0.02 * data["t"]) * np.cos(data["t"]))
    assert alone is None or np.abs(alone[1]).max() < 1e-2


@pytest.mark.parametrize(
    "data", [{"n": range(9), "x": (-0.9) ** np.arange(9)}, {"amplitude": [1, 2], "decrement": [0.1, 0.2]}]
)
def test_turning_points_and_tables_have_no_second_mode(data):
    with pytest.raises(InputError, match="modes"):
        asy.identify(data, modes=2)
    with pytest.raises(InputError, match="modes"):
        asy.identify(two_modes(), modes=3)
