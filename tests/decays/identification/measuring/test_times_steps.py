"""Turning times on one curve, and the frequency of a record, step by step: weights, clips, degrees, lines that fall."""

import numpy as np
import pytest

from asymptotics.decays.identification.measuring import main_frequency as frequency
from asymptotics.decays.identification.measuring import quiet_times as quiet
from asymptotics.decays.identification.measuring.main_frequency import dominant_period, main_frequency
from asymptotics.decays.identification.measuring.quiet_times import _fitted, _smooth_size, quiet_times

N = np.arange(30.0)


def random(count=30, seed=1):
    return np.random.default_rng(seed).standard_normal(count)


@pytest.mark.parametrize("degree", [1, 2, 3])
def test_a_curve_is_weighted_least_squares_with_a_line_more_for_the_passages(degree):
    u, late = np.concatenate([N, N]) / 15 - 1, np.repeat([0.0, 1.0], 30)
    weights = np.where(late > 0, 4.0, 1.0)
    data = 3 + 50 * u + late * (0.2 + 0.1 * u) + 1e-3 * random(60) / weights
    V = np.stack([*(u**k for k in range(degree + 1)), late, late * u], axis=1)
    c = np.linalg.lstsq(V * weights[:, None], data * weights, rcond=None)[0]
    misfit = (data - V @ c) * weights
    value, curve = _fitted(degree, u, late, data, weights)
    clip = 4 * 1.4826 * np.median(np.abs(misfit))
    assert (np.abs(misfit) < clip).all() and curve == pytest.approx(V @ c, abs=1e-9)
    assert value == pytest.approx(60 * np.log((misfit**2).sum()) + (degree + 3) * np.log(60), rel=1e-6)


def test_without_passages_the_curve_has_no_second_line():
    value, curve = _fitted(1, N / 15 - 1, np.zeros(30), 2 * N + 1e-3 * random(), np.ones(30))
    assert curve == pytest.approx(np.polyval(np.polyfit(N, 2 * N + 1e-3 * random(), 1), N), abs=1e-9)
    assert np.isfinite(value)


def test_a_wild_time_bends_no_curve_and_counts_as_the_clip():
    data = 2 * N + 1e-3 * random()
    wild = data.copy()
    wild[12] += 1.0
    keep = np.arange(30) != 12
    line = np.polyval(np.polyfit(N[keep], data[keep], 1), N)
    value, curve = _fitted(1, N / 15 - 1, np.zeros(30), wild, np.ones(30))
    assert curve == pytest.approx(line, abs=1e-6)
    misfit = np.abs(wild - line)
    rss = (np.minimum(misfit, 4 * 1.4826 * np.median(misfit)) ** 2).sum()
    assert value == pytest.approx(30 * np.log(rss) + 2 * np.log(30), rel=1e-3)


def test_where_too_many_times_miss_none_is_left_out():
    data = np.where(np.arange(30) % 3 == 0, 50.0, 0.0) + 1e-3 * random()
    _, curve = _fitted(1, N / 15 - 1, np.zeros(30), data, np.ones(30))
    assert curve == pytest.approx(np.polyval(np.polyfit(N, data, 1), N), abs=1e-6)


def test_sizes_lie_on_a_parabola_of_the_logarithm():
    x = np.exp(1 - 0.1 * N + 1e-3 * N**2) * (-1.0) ** np.arange(30)
    assert _smooth_size(N, x) == pytest.approx(np.abs(x))
    noisy = x * np.exp(0.1 * random())
    assert _smooth_size(N, noisy) == pytest.approx(np.exp(np.polyval(np.polyfit(N, np.log(np.abs(noisy)), 2), N)))


def record(noise=0.02, period=np.pi, steps=None, seed=1):
    steps = np.ones(29) if steps is None else steps
    n = np.concatenate([[0.0], np.cumsum(steps)])
    x, sigma = np.exp(-n / 15), noise * np.exp(n / 15)
    t = period * n + sigma * random(30, seed)
    passages = period * (n[:-1] + 0.5) + 0.25 * sigma[:-1] * random(29, seed + 1)
    return t, x, sigma, passages, steps, period * n


def test_all_times_together_know_each_better():
    t, x, sigma, passages, steps, true = record()
    found = quiet_times(t, x, sigma, passages, steps)
    assert np.abs(found - true).max() < np.abs(t - true).max() / 5
    t, x, sigma, passages, steps, true = record(steps=np.where(np.arange(29) == 11, 4.0, 1.0))  # a gap
    assert np.abs(quiet_times(t, x, sigma, passages, steps) - true).max() < np.abs(t - true).max() / 5


def test_few_times_or_one_without_an_error_have_no_curve():
    t, x, sigma, passages, steps, _ = record()
    assert quiet_times(t[:11], x[:11], sigma[:11], passages[:10], steps[:10]) is None
    assert quiet_times(t[:12], x[:12], sigma[:12], passages[:11], steps[:11]) is not None
    assert quiet_times(t, x, np.where(N == 4, 0.0, sigma), passages, steps) is None


def test_where_no_curve_goes_through_the_times_there_is_none():
    t, x, sigma, passages, steps, true = record()
    sawtooth = true + 0.4 * (-1.0) ** np.arange(30) / x  # far beyond the errors, whatever the degree
    assert quiet_times(sawtooth, x, sigma / 50, passages, steps) is None


def test_where_the_curve_misses_its_neighbourhood_the_times_stay():
    t, x, sigma, passages, steps, true = record(noise=1e-4)
    bent = t + np.where(N < 4, 0.02 * (4 - N), 0.0)
    found = quiet_times(bent, x, sigma, passages[4:], steps)
    assert np.array_equal(found[:3], bent[:3]) and not np.array_equal(found[15:], bent[15:])
    one = t.copy()
    one[15] += 0.01  # a single time may miss its curve by chance
    assert quiet_times(one, x, sigma, passages, steps)[15] == pytest.approx(true[15], abs=1e-3)


@pytest.mark.parametrize("beyond", [1.0, 0.0])
def test_passages_outside_the_extremes_or_at_their_ends_do_not_count(monkeypatch, beyond):
    t, x, sigma, passages, steps, _ = record()
    inside, fitted, counts = quiet_times(t, x, sigma, passages, steps), quiet._fitted, set()
    monkeypatch.setattr(quiet, "_fitted", lambda *given: (counts.add(len(given[3])), fitted(*given))[1])
    more = quiet_times(t, x, sigma, np.concatenate([[t[0] - beyond], passages, [t[-1] + beyond]]), steps)
    assert np.array_equal(inside, more) and counts == {len(t) + len(passages)}


# The frequency of the motion.

T = np.arange(0, 60, 0.1)


@pytest.mark.parametrize("omega", [0.5, 2.0, 7.0])
def test_the_frequency_is_that_of_a_decay_to_a_quarter_of_a_line(omega):
    x = 3 + 0.01 * T + np.exp(-0.03 * T) * np.cos(omega * T + 0.3)
    assert main_frequency(T, x) == pytest.approx(omega, abs=0.3 * 2 * np.pi / 60)
    assert dominant_period(T, x) == pytest.approx(2 * np.pi / omega, rel=0.6 * 2 * np.pi / 60 / omega)
    uneven = T + 0.04 * np.sin(17 * T)
    x = np.exp(-0.03 * uneven) * np.cos(omega * uneven)
    assert main_frequency(uneven, x) == pytest.approx(omega, abs=0.3 * 2 * np.pi / 60)


def test_many_samples_are_asked_by_the_fast_transform(monkeypatch):
    monkeypatch.setattr(frequency, "dominant_period", lambda t, x: 2.0)
    t = np.linspace(0, 60, 1501)
    assert main_frequency(t, np.cos(t)) == pytest.approx(np.pi)
    assert main_frequency(t[:1500], np.cos(t[:1500])) == pytest.approx(1.0, abs=0.03)


def test_a_strong_decay_over_a_slow_tail_is_the_motion():
    x = np.exp(-0.3 * T) * np.cos(3 * T) + 0.4 * np.sin(2 * np.pi * 2.2 * T / 60)
    assert main_frequency(T, x) == pytest.approx(3.0, abs=0.1) and dominant_period(T, x) == pytest.approx(2.09, abs=0.1)


def test_less_than_three_cycles_of_a_falling_line_are_a_drift():
    x = np.cos(2 * np.pi * 8 * T / 60) * 0.2 + np.exp(-T / 10) * np.cos(2 * np.pi * 2 * T / 60)
    assert main_frequency(T, x) == pytest.approx(2 * np.pi * 8 / 60, rel=0.1)


def test_envelopes_fall_by_their_powers_of_e():
    found = frequency._falling(np.array([0.0, 0.5, 1.0]))
    assert found == pytest.approx(np.exp(-np.outer([3, 6, 12, 24], [0, 0.5, 1.0])))


def test_a_record_under_an_envelope_stands_about_the_line_with_its_weights():
    falling = frequency._falling(T / 60)
    x = 1 + 0.1 * T + np.cos(T)
    found = frequency._weighted(falling, T, x)
    for w, row in zip(falling, found, strict=True):
        line = np.polyval(np.polyfit(T, x, 1, w=w), T)
        assert row == pytest.approx(w * (x - line), abs=1e-9)


@pytest.mark.parametrize(("falling", "chosen"), [(1.19, 1.0), (0.81, 1.0), (1.21, 1.21), (0.79, 0.79), (1.0, 1.0)])
def test_the_steady_line_counts_where_both_are_alike(falling, chosen):
    assert frequency._chosen(1.0, falling) == chosen
    assert frequency._chosen(10.0, 10 * falling) == pytest.approx(10 * chosen)


def test_lines_that_fall_are_judged_by_the_energy_they_explain():
    """|sum x w e^(-i w t)|^2/sum w^2 is largest for the fall of the motion: a strong one counts against a weak tone."""
    strong = np.exp(-0.4 * T) * np.cos(4 * T)
    assert main_frequency(T, strong + 0.05 * np.cos(1.5 * T)) == pytest.approx(4.0, abs=0.1)
    assert main_frequency(T, 0.05 * strong + np.cos(1.5 * T)) == pytest.approx(1.5, abs=0.05)
