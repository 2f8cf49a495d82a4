"""A decay that ends in an unquiet tail keeps its frequency: slow noise, a kink or a step of the base, a second mode."""

from itertools import product

import numpy as np
import pytest
from scipy.signal import lfilter

from asymptotics.decays.identification.measuring.demodulation import demodulated
from asymptotics.decays.identification.measuring.main_frequency import main_frequency
from asymptotics.decays.identification.sources import load

TAILS = ("slow noise", "kink", "mode", "step")
GRID = list(product((4, 8, 12), (6, 9, 12), (30, 75, 150), (1, 2)))


def record(tail, Q, periods, per_period, seed):
    """A decay of period 1, amplitude 1 and quality Q at its beginning, with half a percent of noise and a tail."""
    random = np.random.default_rng(seed)
    t = np.arange(int(periods * per_period) + 1) / per_period
    fall, u, white = np.pi / Q, t / t[-1], random.standard_normal(len(t))
    if tail == "slow noise":
        beyond, memory = np.zeros(len(t)), np.exp(-1 / (1.5 * per_period))
        for i in range(1, len(t)):
            beyond[i] = memory * beyond[i - 1] + 0.02 * np.sqrt(1 - memory**2) * white[i]
    else:
        beyond = {
            "kink": 0.05 * np.maximum(u - 0.6, 0),
            "mode": 0.1 * np.exp(-0.6 * fall * t) * np.cos(2.37 * 2 * np.pi * t + 1),
            "step": np.where(u > 0.7, 0.03, 0.0),
        }[tail]
    return t, np.exp(-fall * t) * np.cos(2 * np.pi * t) + beyond + 0.005 * random.standard_normal(len(t))


def check(tail, case):
    t, x = record(tail, *case)
    (seen,) = load({"t": t, "x": x})
    period = 2 * np.median(np.diff(seen.t) / np.diff(seen.n))
    assert 0.95 < period < 1.05, (tail, case)
    assert (np.diff(seen.t) > 0).all() and np.abs(seen.x[seen.inside]).max() < 1.1, (tail, case)
    used = seen.t[-1] if seen.samples is None else seen.samples.t[-1]
    # More than a period of the record that is not used is told: a period itself is not more.
    assert used >= t[-1] - period - 1e-9 or "are not used" in seen.notes[-1], case


@pytest.mark.parametrize("tail", TAILS)
def test_the_frequency_does_not_run_away(tail):
    for case in [(4, 6, 75, 1), (4, 9, 150, 2), (8, 6, 150, 2), (12, 6, 30, 2)]:
        check(tail, case)


@pytest.mark.slow
@pytest.mark.parametrize("tail", TAILS)
def test_none_of_the_grid_runs_away(tail):
    for case in GRID:
        t, x = record(tail, *case)
        assert 0.9 < demodulated(t, x).omega / (2 * np.pi) < 1.1, (tail, case)
        check(tail, case)


@pytest.mark.parametrize("at", [3.2, 3.5, 4.5])
def test_polynomials_that_cancel_one_another_are_no_line(at):
    """A base line that steps in a short record: they would follow it, three times as large as the motion."""
    t = np.arange(900) / 150
    fall = np.pi / 4 / np.sqrt(1 - 1 / 64)
    decay = np.exp(-fall * t) * np.cos(2 * np.pi * t)
    noise = 4e-4 * np.random.default_rng(1).standard_normal(len(t))
    late, height = -np.arcsin(1 / 8) / 2 / np.pi, np.sqrt(1 - 1 / 64)
    for step, off in ((0.0, 0.005), (0.05, 0.1)):
        (seen,) = load({"t": t, "x": decay + step * (t > at) + noise})
        inside = seen.inside & (np.abs(seen.x) > 0.1)
        n = np.round(2 * seen.t[inside])
        assert len(n) >= 4 and np.abs(2 * seen.t[inside] - n).max() < 0.1
        assert np.abs(np.abs(seen.x[inside]) * np.exp(fall * (n / 2 + late)) / height - 1).max() < off


def test_an_extreme_is_that_of_its_own_half_swing():
    """Where the modulation is that of noise, the nearest extreme of the line may be far from where its phase says."""
    random, t = np.random.default_rng(2333400502), np.arange(360) / 30
    omega, fall = 2 * np.pi * np.sqrt(1 - 1 / 64), np.pi / 4
    decay = np.exp(-fall * t) * (np.cos(omega * t) + np.sin(omega * t) / 8 / np.sqrt(1 - 1 / 64))
    white = 2e-3 * random.standard_normal(360)
    slow = lfilter([1], [1, -1 + 0.5 / 30], random.standard_normal(2360))[2000:]
    (seen,) = load({"t": t, "x": decay + white + 0.012 * slow / slow.std()})
    # One lay at 3.8 between those at 5.1 and 5.9.
    assert seen.inside.sum() > 10 and np.abs(np.diff(seen.t) - 0.5).max() < 0.15


def test_a_slow_tail_of_more_energy_under_a_window_is_not_the_motion():
    t = np.arange(0, 12, 0.02)
    x = np.exp(-0.8 * t) * np.cos(2 * np.pi * t) + 0.2 * np.sin(2 * np.pi * t / 9)
    assert main_frequency(t, x) == pytest.approx(2 * np.pi, rel=0.1)
    # Near miss: a wave that is as large as the motion all along is the motion.
    assert main_frequency(t, x + 2 * np.sin(2 * np.pi * t / 3)) == pytest.approx(2 * np.pi / 3, rel=0.1)
