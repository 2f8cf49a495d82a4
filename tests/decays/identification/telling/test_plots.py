"""The picture of an identification."""

from dataclasses import replace
from types import SimpleNamespace

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.collections import PolyCollection

import asymptotics as asy
from asymptotics.decays.identification.fitting.profile import quantile
from asymptotics.decays.identification.synthetic import observed
from asymptotics.decays.identification.telling import plots
from asymptotics.decays.identification.telling.plots import (
    _profile,
    decrement_band,
    draw_decrements,
    measured_decrements,
    measured_sizes,
    shown_laws,
)
from asymptotics.errors import InputError


def test_the_picture_is_drawn():
    answer = asy.identify(observed("1+2", [0.01, 0.02], 40, 1e-3, seed=1), laws=["1", "1+2"])
    svg = answer.picture("svg", panels=True)
    assert svg.startswith(b"<?xml")
    mean, decrement, band = decrement_band(answer.law("1+2").law.fit)
    first_order = np.pi / 2 * 0.01 * mean + 4 / 3 * 0.02 * mean**2
    assert (np.abs(decrement - first_order) < 3 * band + 0.02 * first_order).all()
    table = {"amplitude": [1.0, 0.8, 0.6], "decrement": [0.1, 0.06, 0.04], "resolution": [0.005] * 3}
    with pytest.raises(InputError, match="plot"):
        asy.identify(table, laws=["1"]).picture()


def test_pictures_have_the_quantile_of_the_intervals():
    # ten turning points leave so few freedoms that 1.96 would be far too short
    answer = asy.identify(observed("1", [0.05], 8, 1e-3, seed=4), laws=["1"], bootstrap=False)
    fit = answer.law("1").law.fit
    t = quantile(fit, 0.95, "x")
    assert t > 2.3
    # At amplitude a, half of e pi/(2 sqrt(1 - e^2/4)) in tanh: what the first amplitude is, the band does not know.
    mean, fall, band = decrement_band(fit)
    by_strength = np.zeros(fit.model.size)
    by_strength[1] = 1.0
    e, step = fit.theta[1], 1e-6
    decrement = lambda e: 2 * mean * np.tanh(np.pi * e / 4 / np.sqrt(1 - e * e / 4))  # noqa: E731
    by = (decrement(e + step) - decrement(e - step)) / (2 * step)
    assert fall == pytest.approx(decrement(e), rel=1e-6)
    assert band == pytest.approx(t * by * fit.directions.standard_error(by_strength), rel=1e-5)


def test_pictures_have_intervals_as_long_as_those_that_are_printed():
    """Residuals that remember stretch the intervals: three times, in a band and at the ends of a profile."""
    law = asy.identify(observed("1", [0.05], 20, 1e-3, seed=4), laws=["1"], bootstrap=False).law("1").law
    ends = replace(law.intervals, stretches=(3.0,), epsilon=(law.epsilon[0].stretched(3.0),))
    longer = replace(law, intervals=ends)
    heights, ends = [], []
    for each in (law, longer):
        figure, (band, profile) = plt.subplots(1, 2)
        draw_decrements(band, [each], "")
        _profile(profile, each)
        (outline,) = next(c for c in band.collections if isinstance(c, PolyCollection)).get_paths()
        x, y = outline.vertices.T
        heights.append(np.ptp(y[x == np.median(x)]))
        (marks,) = [line.get_xdata() for line in profile.lines if line.get_marker() == "|"]
        ends.append(np.array(marks))
        plt.close(figure)
    assert heights[1] == pytest.approx(3 * heights[0], rel=1e-6)
    assert ends[1] == pytest.approx(3 * ends[0], rel=1e-6) and ends[0][0] < 0 < ends[0][1]


def sampled(unit="s", memory=0.0, noise=5e-3):
    """Linear loss, 12 samples a period of 2 s, so that the samples are fitted, in a file with this unit of time."""
    t, random = np.arange(0.3, 40, 1 / 6), np.random.default_rng(3)
    drawn = random.standard_normal(len(t))
    for i in range(1, len(t)):
        drawn[i] = memory * drawn[i - 1] + np.sqrt(1 - memory**2) * drawn[i]
    x = np.exp(-0.05 * t) * np.cos(np.pi * t) + 0.1 + noise * drawn
    return {f"t ({unit})": t * {"s": 1, "ms": 1000}[unit], "x": x}


@pytest.mark.parametrize("memory", [0.0, 0.8])
def test_measured_amplitudes_are_those_of_the_motion_whichever_law_was_fitted(memory):
    answer = asy.identify(sampled(memory=memory), laws=["1", "0"], bootstrap=False)
    for law in ("1", "0"):
        fit = answer.law(law).law.fit
        n, size, error = measured_sizes(fit)
        true = np.exp(-0.05 * fit.model.turning_times(fit.theta)[n])
        assert np.sqrt(np.mean(((size - true) / error) ** 2)) < 1.6 and error.max() < 0.02
        mean, fall, spread = measured_decrements(fit)
        assert (np.abs(fall - 0.05 * mean) < 4.5 * spread + 0.002).all() and len(mean) > 30
    # The law that was fitted does not tell it: dry friction's own amplitudes are far from them.
    assert np.abs(fit.model.amplitudes(fit.theta)[0][n] - true).max() > 10 * error.max()


def test_the_whitened_samples_are_coloured_again():
    fit = asy.identify(sampled(memory=0.8), laws=["1"], bootstrap=False).law("1").law.fit
    model = fit.model
    assert model.samples.memory > 0.5
    assert model._coloured(model.data) == pytest.approx(model.samples.x, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("unit", ["s", "ms"])
def test_the_decay_is_drawn_over_time_in_the_unit_of_the_file(unit):
    answer = asy.identify(sampled(unit), laws=["1", "0"], bootstrap=False)
    figure, axes = plt.subplots()
    answer.plot(axes, panels=True)
    decay = figure.axes[0]
    samples, upper, lower, points = decay.lines
    size = {"s": 1.0, "ms": 1e3}[unit]
    assert decay.get_xlabel() == f"t ({unit})" and samples.get_xdata()[-1] == pytest.approx(39.97 * size, rel=1e-3)
    assert len(samples.get_xdata()) == len(answer.best.law.fit.model.samples.t)
    # The samples lie between the envelopes, about the base line.
    t = samples.get_xdata()
    above, below = (np.interp(t, line.get_xdata(), line.get_ydata()) for line in (upper, lower))
    assert (samples.get_ydata() < above + 0.03).all() and (samples.get_ydata() > below - 0.03).all()
    assert np.abs(points.get_ydata() - 0.1).max() == pytest.approx(np.exp(-0.05), rel=0.05)
    # Each profile tells its strength.
    (label,) = [line.get_label() for line in figure.axes[3].lines if "epsilon" in line.get_label()]
    assert label.startswith("epsilon of 1: 0.03") and "[" in label
    plt.close(figure)


def test_laws_that_coincide_are_one_band():
    data = observed("1", [0.02], 40, 1e-3, seed=1)
    answer = asy.identify(data, laws=["1", "free", "2"], bootstrap=False)
    one, free, other = (answer.law(name).law for name in ("1", "free", "2"))
    figure, axes = plt.subplots()
    draw_decrements(axes, [one, free, other], "")
    labels = axes.get_legend_handles_labels()[1]
    assert "1 and free (coincide)" in labels and "2" in labels and "free" not in labels
    plt.close(figure)
    assert [str(law.candidate) for law in shown_laws(answer)] == ["1"]


def test_an_envelope_is_drawn_over_time_with_errors_of_its_own_size():
    """failed before: over the number of an artificial swing, on both sides, without a single decrement."""
    t, random = np.arange(0, 60, 0.25), np.random.default_rng(5)
    size = np.exp(-t / 20) * (1 + 1e-3 * random.standard_normal(len(t)))
    levels = {"t (ms)": t, "level (dB)": 20 * np.log10(size)}
    answer = asy.identify(levels, kind="envelope", omega_0=2e6, laws=["1"], bootstrap=False)
    figure, axes = plt.subplots()
    answer.plot(axes, panels=True)
    line, points = figure.axes[0].lines
    assert figure.axes[0].get_xlabel() == "t (ms)" and points.get_xdata()[-1] == pytest.approx(59.75)
    assert points.get_ydata() == pytest.approx(size, rel=1e-3) and line.get_ydata()[-1] == pytest.approx(
        np.exp(-59.75 / 20), rel=1e-3
    )
    plt.close(figure)
    fit = answer.best.law.fit
    n, measured, error = measured_sizes(fit)
    assert error / measured == pytest.approx(np.full(len(n), 1e-3), rel=0.3)
    # A row is several artificial half-swings, and the decrement that of one.
    mean, fall, spread = measured_decrements(fit)
    assert len(mean) == len(t) - 1
    loss = 0.25 / 20 / np.diff(n)
    assert (np.abs(fall / mean - loss) < 4.5 * spread / mean).all() and (spread / mean < 2e-3).all()


def test_peaks_of_one_side_have_decrements_and_no_base_line():
    random = np.random.default_rng(6)
    n = 2 * np.arange(15)
    size = 20 * np.exp(-0.03 * n) + 0.02 * random.standard_normal(len(n))
    answer = asy.identify(
        {"t (s)": n * 0.8 + 1e-3 * random.standard_normal(len(n)), "amplitude (deg)": size}, laws=["1", "0+1"]
    )
    for law in ("1", "0+1"):  # failed before: dry friction of any sign and a rest position in place of it
        fit = answer.law(law).law.fit
        assert fit.rest == 0.0 and fit.model.amplitudes(fit.theta)[0][0] == pytest.approx(20, abs=0.1)
    mean, fall, spread = measured_decrements(answer.law("1").law.fit)
    assert len(mean) == len(n) - 1 and (np.abs(fall - 0.03 * mean) < 4.5 * spread).all()


@pytest.mark.parametrize("count", [0, 1])
def test_a_law_without_two_measured_turning_points_has_no_decrements(monkeypatch, count):
    """Failed before: "zero-size array", told as a wrong style of the plot, in the place of the whole answer."""
    fit = SimpleNamespace(model=SimpleNamespace(seen=SimpleNamespace(last=4)))
    few = np.arange(count), np.ones(count), np.ones(count)
    monkeypatch.setattr(plots, "measured_sizes", lambda _: few)
    assert [len(column) for column in measured_decrements(fit)] == [0, 0, 0]


def test_of_several_runs_the_first_is_drawn():
    """It was refused after all the work (exit code 2), and the answer was lost with the picture."""
    runs = [observed("1", [0.02], 40, 1e-3, seed=seed) for seed in (1, 2)]
    answer = asy.identify(runs, laws=["1", "2"], bootstrap=False)
    figure, axes = plt.subplots()
    plots.draw_panels(answer, axes)
    said = figure._suptitle.get_text()
    assert said.startswith("identified in 2 runs: 1") and "drawn: the first of 2 runs" in said
    dots = {line.get_label(): len(line.get_xdata()) for line in axes.lines}
    assert dots["turning points"] == len(answer.per_run[0].runs[0].n)
    plt.close(figure)
    assert answer.picture("svg").startswith(b"<?xml")
