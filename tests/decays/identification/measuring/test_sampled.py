"""Samples that are thinned, cut and required, step by step."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.stats import f as f_distribution

from asymptotics.decays.identification.measuring import sampled
from asymptotics.decays.identification.measuring.sampled import (
    _free,
    _is_no_line,
    _require_samples,
    _thinned,
    _thinning,
)
from asymptotics.errors import InputError


@pytest.mark.parametrize("step", [2, 5, 9])
def test_means_of_groups_keep_the_wave_they_average(step):
    """|sin(w)/w| of a group is divided out: about the level, at the middle of the group; what is over is dropped."""
    omega, t = 1.3, np.arange(0, 60, 0.1)[: 60 * step + step // 2]
    x = 7.0 + np.cos(omega * t + 0.4)
    times, values = _thinned(t, x, omega, step)
    assert len(times) == len(t) // step and times == pytest.approx(
        t[: len(times) * step].reshape(-1, step).mean(axis=1)
    )
    level = np.median(x[: len(times) * step])
    smaller = np.abs(np.sin(omega * step * 0.05) / np.sin(omega * 0.05) / step)
    assert values == pytest.approx(level + (7.0 - level) / smaller + np.cos(omega * times + 0.4), abs=1e-12)


def test_a_group_that_averages_its_wave_away_is_divided_by_a_tenth():
    t = np.arange(40) * np.pi / 2
    _, values = _thinned(t, np.ones(40) + (np.arange(40) % 4 == 0), 1.0, 4)
    assert values == pytest.approx(np.full(10, 1 + 0.25 / 0.1))


@pytest.mark.parametrize(
    ("count", "per_period", "step"),
    [
        (12_000, 47, 1),
        (12_000, 48, 2),
        (17_999, 100, 2),
        (54_000, 40, 3),
        (54_000, 1000, 9),
        (5_999, 1000, 1),
        (180_000, 20, 9),
    ],
)
def test_so_many_samples_are_one_mean_as_leave_enough(count, per_period, step):
    """6000 samples, 24 of a period; in the end 20000 at most."""
    assert (sampled.ENOUGH, sampled._A_PERIOD, sampled.MAX_SAMPLES) == (6_000, 24, 20_000)
    assert _thinning(np.arange(float(count)), per_period + 1e-6) == step


def line(size, noise=0.0, omega=1.0):
    at = lambda _: (np.asarray(size, dtype=float),)  # noqa: E731
    return SimpleNamespace(at=at, noise=noise, omega=omega, freedom=180.0, memory=0.0)


T = np.arange(10.0)


@pytest.mark.parametrize(
    ("first", "cut"), [([1.0, 1.04, 1.0], 0), ([1.0, 1.06, 1.0], 1), ([0.2, 0.5, 0.9, 2.0], 3), ([0.1] * 5 + [2.0], 0)]
)
def test_a_free_decay_begins_with_its_largest_swing_if_that_is_early_and_larger(first, cut):
    size = np.array([*first, *np.linspace(0.9, 0.5, 10 - len(first))])
    assert _free(line(size), T).tolist() == [k >= cut for k in range(10)]


def test_a_free_decay_ends_where_noise_hides_it():
    size = np.linspace(1.0, 0.1, 10)
    for hidden in (4, 7):
        noise = (size[hidden] + size[hidden - 1]) / 2 / sampled._HIDDEN
        assert _free(line(size, noise), T).tolist() == [k < hidden for k in range(10)]
    assert _free(line(size, 0.09 / sampled._HIDDEN), T).all()


def test_a_line_needs_samples():
    t = np.linspace(0, 40, 200)
    _require_samples(line(np.ones(200), 0.01), t, "r")
    few = np.linspace(0, 40, sampled.LEAST_SAMPLES - 1)
    for given, reason in (
        ((line(np.ones(9), 0.01), few), f"{len(few)} samples"),
        ((line(np.ones(200), 0.01, omega=40.0), t), "a period"),
    ):
        with pytest.raises(InputError, match=reason):
            _require_samples(*given, "r")


def test_a_line_has_periods_and_a_size_and_is_no_noise():
    t = np.linspace(0, 40, 200)
    x = np.cos(t)
    for omega, loud, none in ((1.49, 0.01, True), (1.51, 0.01, False), (9.0, 1.01, True), (9.0, 0.99, False)):
        noise = 0.01 if loud < 0.1 else loud * sampled._LOUD
        given = line(np.ones(200), noise, omega=2 * np.pi * omega / 40)
        assert _is_no_line(given, t, x) == none
    # Eighteen coefficients on white noise: their F has one chance in a thousand for each frequency.
    noise = np.random.default_rng(1).standard_normal(200)
    left = float(((noise - np.polynomial.Polynomial.fit(t, noise, 1)(t)) ** 2).sum())
    for ratio, none in ((0.98, False), (1.02, True)):
        limit = ratio_of(18, 180, 1e-3 / 200) / ratio
        given = line(np.full(200, 9.0), np.sqrt(left / (180 + 18 * limit)))
        assert _is_no_line(given, t, noise) == none


def test_a_smooth_error_a_thousandth_of_a_line_makes_it_no_noise():
    """Failed before a release: neighbours correlated by 0.995 left two and a half data of 500."""
    t = np.linspace(0, 40, 600)
    given = line(np.ones(600), 1e-3, omega=2.0)
    given.memory, given.freedom = 0.995, 550.0
    assert not _is_no_line(given, t, np.cos(2 * t))


def ratio_of(count, freedom, p):
    return float(f_distribution.isf(p, count, freedom))
