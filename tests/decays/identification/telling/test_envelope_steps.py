"""Period, Q and half-life before any law: on decays whose fall is known, and each step by its own formula."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import t as student

from asymptotics.decays.identification.measuring.observations import Observations, Samples
from asymptotics.decays.identification.telling import decline
from asymptotics.decays.identification.telling import envelope as module
from asymptotics.decays.identification.telling.averaged import averaged
from asymptotics.decays.identification.telling.backbone import TurningTimes
from asymptotics.decays.identification.telling.envelope import MeasuredEnvelope, envelope

N = np.arange(40)


def seen(size, t=None, n=N, **more):
    return Observations.of(n, (-1.0) ** n * size, () if t is None else t, **more)


def noisy(size, noise, seed=1):
    return size + noise * np.random.default_rng(seed).standard_normal(len(size))


def ends(found):
    return [found[k] for k in ("low", "estimate", "high")]


@pytest.mark.parametrize(
    ("size", "fall"),
    [
        (2 * np.exp(-0.04 * N), lambda A: 0.04 + 0 * A),
        (2 / (1 + 0.05 * N), lambda A: np.log1p(0.025 * A)),
        (2 - 0.03 * N, lambda A: -np.log(1 - 0.03 / A)),
    ],
)
def test_q_is_half_pi_over_what_a_half_swing_takes(size, fall):
    found = envelope(seen(size))
    amplitudes = [size[0], np.sqrt(size[0] * size[-1]), size[-1]]
    assert [q["amplitude"] for q in found.quality] == pytest.approx(amplitudes, rel=1e-4)
    assert [q["estimate"] for q in found.quality] == pytest.approx([np.pi / 2 / fall(a) for a in amplitudes], rel=0.03)
    assert found.period is None is found.half_life


def test_intervals_cover_the_truth_and_no_more_than_they_must():
    hits, count = 0, 30
    for seed in range(count):
        q = envelope(seen(noisy(2 * np.exp(-0.04 * N), 0.01, seed))).quality[1]
        hits += q["low"] <= np.pi / 2 / 0.04 <= q["high"]
    assert 0.93 <= hits / count <= 1.0
    q = envelope(seen(noisy(2 * np.exp(-0.04 * N), 0.01))).quality[1]
    assert 0.005 < (q["high"] - q["low"]) / q["estimate"] < 0.3


def test_the_fall_of_one_power_is_that_of_weighted_least_squares(monkeypatch):
    """A constant alone is tried: ln A = c - g n, weighted by the amplitudes of a first line; Student's quantile of what
    is left."""
    for name in ("_POWERS", "_ROUGHLY"):
        monkeypatch.setattr(decline, name, (0,))
    monkeypatch.setattr(decline, "_BESIDE", ())
    monkeypatch.setattr(decline, "_FOR_SCATTER", 1000)  # the mean of the logarithm as if there were no noise
    size = noisy(2 * np.exp(-0.04 * N), 0.01)
    falls = decline.decline_of(N, size, 0.0, 1.0)
    weight = size / size[0]
    for _ in range(2):
        V, y = np.stack([np.ones(40), -N], axis=1) * weight[:, None], weight * np.log(size)
        c = np.linalg.solve(V.T @ V, V.T @ y)
        last, weight = weight, np.exp(c[0] - c[1] * N) / size[0]
    assert not np.allclose(last, size / size[0], rtol=1e-3)
    variance = ((y - V @ c) ** 2).sum() / 38 * np.linalg.inv(V.T @ V)[1, 1]
    reach = student.ppf(0.975, 38) * np.sqrt(variance)
    assert ends(falls(1.3)) == pytest.approx([c[1] - reach, c[1], c[1] + reach], rel=1e-5)
    stated = decline.decline_of(N, size, 0.5, 1.0)  # what is stated counts where it is more than the scatter
    wide = student.ppf(0.975, 38) * np.sqrt(np.linalg.inv(V.T @ V)[1, 1]) * 0.5 / size[0]
    assert ends(stated(1.3)) == pytest.approx([c[1] - wide, c[1], c[1] + wide], rel=1e-3)


def test_noise_in_the_tail_does_not_lift_the_curve():
    """Failed before: weighed by what was measured, the falls of 200 such lay 0.8 errors too low on the average; without
    the mean of the logarithm 0.5 too high."""
    n, fall = np.arange(300), 0.0115
    z = []
    for seed in range(24):
        size = np.exp(-fall * n) + 0.004 * np.random.default_rng(seed).standard_normal(len(n))
        found = decline.decline_of(n, size, 0.0, 1.0)(0.18)
        z.append((found["estimate"] - fall) / ((found["high"] - found["low"]) / 3.92))
    assert abs(np.mean(z)) < 0.35


def test_each_choice_counts_by_the_weight_of_its_criterion(monkeypatch):
    size = noisy(2 * np.exp(-0.04 * N), 0.01)
    monkeypatch.setattr(decline, "_BESIDE", ())
    told = {}
    for powers in ((0,), (1,), (0, 1)):
        monkeypatch.setattr(decline, "_POWERS", powers)
        told[powers] = decline.decline_of(N, size, 0.0, 1.0)
    one, both = told[(0,)](1.3), told[(0, 1)](1.3)
    assert [fall.powers for fall in told[(0, 1)].falls] == [(0,), (0, 1), (1,)]
    wide = told[(0, 1)].falls[1].at(1.3 / size[0])
    assert both == averaged([fall.at(1.3 / size[0]) for fall in told[(0, 1)].falls])
    # Between the interval of the best and that of the two powers; 1 alone, far from the best, moves nothing.
    assert one["high"] - one["low"] < both["high"] - both["low"] < 1.2 * 2 * 2.03 * wide.error
    assert not both["low"] < told[(1,)](1.3)["estimate"] < both["high"]


def test_powers_of_a_fall_are_powers_of_the_amplitude():
    """2 sinh of half the fall is their sum; where the last power was fitted, its change counts in the error alone."""
    c, covariance = np.array([0.3, 0.05]), np.array([[0.04, 0.01], [0.01, 0.09]])
    told = decline._Fall((-1, 2), c, covariance).at(2.0)
    s, error = 0.3 / 2 + 0.05 * 4, np.sqrt(0.04 / 4 + 2 * 0.01 * 4 / 2 + 0.09 * 16)
    assert 2 * np.sinh(told.value / 2) == pytest.approx(s)
    assert told.error == pytest.approx(error / np.cosh(told.value / 2))
    free = decline._Fall((2,), np.array([0.05, 0.0]), covariance, free=True).at(2.0)
    by = np.array([4, 4 * np.log(2)])
    assert 2 * np.sinh(free.value / 2) == pytest.approx(0.2)
    assert free.error == pytest.approx(np.sqrt(by @ covariance @ by) / np.cosh(free.value / 2))


def test_a_gap_in_the_numbers_counts_as_its_half_swings():
    kept = np.array([0, 1, 2, 5, 6, 9, 10, 11, 12, 15, 20, 21])
    size = 2 * np.exp(-0.04 * kept)
    assert envelope(seen(size, n=kept)).quality[0]["estimate"] == pytest.approx(np.pi / 2 / 0.04, rel=1e-3)


def test_of_four_points_each_power_alone_is_believed():
    """Failed before: four turning points had no envelope, and their period no error."""
    hits, count = 0, 60
    for seed in range(count):
        q = envelope(seen(noisy(2 * np.exp(-0.3 * N[:4]), 0.02, seed), n=N[:4])).quality[1]
        hits += q["low"] <= np.pi / 2 / 0.3 <= q["high"]
    assert hits / count >= 0.93


def test_from_a_point_at_rest_on_there_is_no_swing(monkeypatch):
    """Failed before: one 0 among forty turning points, as a coarse sensor makes them, left no envelope."""
    size = 2 * np.exp(-0.04 * N)
    monkeypatch.setattr(module, "rest_position", lambda _: 0.0)
    found = envelope(seen(np.where(N == 17, 0.0, size), 0.5 * N))
    assert [q["amplitude"] for q in found.quality][::2] == pytest.approx([size[0], size[16]])
    assert found.quality[1]["estimate"] == pytest.approx(np.pi / 2 / 0.04, rel=1e-3)


def test_the_amplitudes_stand_about_the_rest_position():
    size = 2 * np.exp(-0.04 * N)
    run = seen(size)
    moved = replace(run, x=run.x + 0.3)
    assert envelope(moved).quality[0]["amplitude"] == pytest.approx(2.0, rel=1e-3)
    assert envelope(moved).quality[0]["estimate"] == pytest.approx(np.pi / 2 / 0.04, rel=0.02)


def test_of_samples_the_points_inside_count_about_their_own_line():
    size = 2 * np.exp(-0.04 * N)
    run = seen(size, 0.5 * N, sigma_x=np.full(40, 0.02))
    samples = Samples(np.array([0.5, 18.0]), np.zeros(2), 0.1, 2.0)
    found = envelope(replace(run, x=run.x + 0.0, samples=samples))
    assert [q["amplitude"] for q in found.quality][::2] == pytest.approx([size[1], size[36]])
    assert np.flatnonzero(replace(run, samples=samples).inside).tolist() == list(range(1, 37))


def test_q_has_no_limit_where_the_fall_may_vanish():
    found = module._quality(1.5, {"low": -0.01, "estimate": 0.02, "high": 0.05}, 3.0)
    assert found == {"amplitude": 1.5, "low": 3 * np.pi / 2 / 0.05, "estimate": 3 * np.pi / 2 / 0.02, "high": np.inf}


@pytest.mark.parametrize("count", [3, 5, 30])
def test_the_period_is_twice_the_slope_of_the_times(count):
    n = N[:count]
    t = 3.0 + 0.7 * n + 0.01 * np.random.default_rng(3).standard_normal(count)
    V = np.stack([n, np.ones(count)], axis=1)
    c = np.linalg.lstsq(V, t, rcond=None)[0]
    s2 = ((t - V @ c) ** 2).sum() / (count - 2)
    reach = 2 * student.ppf(0.975, count - 2) * np.sqrt(s2 * np.linalg.inv(V.T @ V)[0, 0])
    assert ends(module._period(TurningTimes(n, np.ones(count), t))) == pytest.approx(
        [2 * c[0] - reach, 2 * c[0], 2 * c[0] + reach]
    )


def test_a_half_swing_that_lasts_longer_is_rest():
    t = np.array([0.0, 0.17, 0.345, 0.52, 0.84, 1.07])
    assert module._last_swing(np.arange(6), t) == 3
    assert module._last_swing(np.array([0, 1, 2, 3, 5, 6]), t) == 5  # a gap, which the numbers know, is none


@pytest.mark.parametrize("power", [-1, 0, 1, 2])
def test_the_half_life_is_the_integral_of_the_inverse_fall(power):
    """ln A falls by g A^k in half a period: the time from A to A/2 is the integral of dA/(g A^(k+1)) T/2."""
    g, T, A = 0.04, 3.0, 2.0
    decline = lambda a: {"low": g * a**power / 2, "estimate": g * a**power, "high": g * a**power * 2}  # noqa: E731
    exact = np.log(2) / g if power == 0 else (1 / (A / 2) ** power - 1 / A**power) / (g * power)
    found = module._half_life(decline, np.array([A, 0.9]), lambda _: T / 2)
    assert ends(found) == pytest.approx([exact * T / 4, exact * T / 2, exact * T], rel=1e-4)


def test_below_the_last_amplitude_the_fall_is_that_at_it_and_none_is_no_half_life():
    decline = lambda a: {"low": -0.1, "estimate": 0.04 * a, "high": 0.05}  # noqa: E731
    found = module._half_life(decline, np.array([2.0, 1.5]), lambda _: 1.0)
    exact = (1 / 1.5 - 1 / 2.0) / 0.04 + np.log(1.5) / (0.04 * 1.5)  # from 2 to 1.5 by the fall, to 1 at that of 1.5
    assert found["estimate"] == pytest.approx(exact, rel=1e-3)
    assert found["high"] == np.inf and found["low"] == pytest.approx(np.log(2) / 0.05)


def test_a_whole_decay_has_its_period_and_its_half_life():
    found = envelope(seen(2 * np.exp(-0.04 * N), 10 + 0.7 * N))
    assert found.period["estimate"] == pytest.approx(1.4) and found.half_life["estimate"] == pytest.approx(
        np.log(2) / 0.04 * 0.7, rel=1e-4
    )


def test_numbers_are_texts_and_what_has_no_limit_is_null():
    ends_ = {"low": 1 / 3, "estimate": 1.0, "high": np.inf}
    found = MeasuredEnvelope(None, ({"amplitude": 2.0, **ends_},), ends_).to_dict(True)
    assert found == {
        "period": None, "quality": [{"amplitude": "2", "low": "0.333333", "estimate": "1", "high": None}],
        "half_life": {"low": "0.333333", "estimate": "1", "high": None}, "law_known": True,
        "backbone": [], "time_unit": "s", "decay_rate": [], "quality_untold": None,
        "intervals_untold": None,
    }  # fmt: skip
