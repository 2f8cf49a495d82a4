"""What friction stops is no base line that wanders; and a law whose base line is none of the record's is no result."""

import numpy as np
import pytest

from asymptotics.decays.identification.identify import identified
from asymptotics.decays.identification.measuring import slow_base_line as measured
from asymptotics.decays.identification.telling.plots import draw_panels
from tests.decays.identification.stopped import stopped


@pytest.fixture(scope="module")
def held():
    t = np.arange(0, 30, 0.01)
    return t, np.degrees(stopped(t, np.radians(60), 4.0, {0: 0.25, 1: 0.02}, np.sin)[0])


@pytest.mark.parametrize("seed", [0, 3, 6])
def test_a_pendulum_that_friction_stops_has_no_base_line(held, monkeypatch, seed):
    t, x = held
    x = x + 0.1 * np.random.default_rng(seed).standard_normal(len(t))
    assert measured.slow_base_line(t, x) is None
    # Cosines that cancel what a modulation could be: 16 degrees and more, of which nothing is there.
    monkeypatch.setattr(measured, "_OWN", 0.0)
    assert np.abs(measured.slow_base_line(t, x).values).max() > 15


def with_a_late_step(seed, at):
    """Law 1 with Q = 4.2 and a period of 15 s, whose base line rises by 0.012 when the swing is nearly gone."""
    t, rate = np.arange(0, 120, 0.15), 2 * np.pi / 15
    x = 0.2 * np.exp(-rate * t / 8.4) * np.cos(rate * t) + 0.012 / (1 + np.exp(at - t))
    return {"t": t, "x": x + 0.002 * np.random.default_rng(seed).standard_normal(len(t))}


@pytest.fixture(scope="module")
def stepped():
    return identified(with_a_late_step(0, 100), laws=["1", "2+s3"], bootstrap=False)


def test_a_law_whose_base_line_is_the_motion_is_no_result(stepped):
    """2+s3 was consistent, with half the amplitude: the cosines had taken up the other half."""
    found = stepped.law("2+s3").law
    assert found.verdict == "undetermined"
    assert found.reason.startswith("its base line, 0.08")
    assert stepped.law("1").law.verdict == "consistent"
    assert stepped.law("1").law.epsilon[0].contains(1 / 4.2)


def test_the_base_line_of_a_fit_is_what_its_motion_leaves_of_the_samples(stepped):
    fit = stepped.law("1").law.fit
    model, samples = fit.model, fit.model.samples
    base = model.base_line(fit.theta)
    # Offset and drift alone are arbitrary beside the cosines: 0.7 where the step is 0.012.
    line = fit.theta[model.after] + fit.theta[model.after + 1] * np.linspace(0, 1, len(base))
    assert np.abs(base).max() < 0.012 < 0.3 < np.abs(line).max()
    rate, since = 2 * np.pi / 15, samples.t - samples.t[0]
    shape = np.exp(-rate * since / 8.4)[:, None] * np.stack([np.cos(rate * since), np.sin(rate * since)], axis=1)
    left = samples.x - base
    left = left - shape @ np.linalg.lstsq(shape, left, rcond=None)[0]
    assert left.std() < 0.004


def test_the_picture_has_the_envelope_about_the_samples(stepped):
    plt = pytest.importorskip("matplotlib.pyplot")
    figure, axes = plt.subplots()
    draw_panels(stepped, axes)
    lines = {line.get_label(): line.get_ydata() for line in axes.lines}
    samples = next(y for name, y in lines.items() if name.endswith("samples"))
    assert np.abs(lines["turning points"]).max() < 1.1 * np.abs(samples).max()
    plt.close(figure)
