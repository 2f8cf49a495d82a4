"""Columns beside the law: what the fit absorbs is what least squares with those columns as unknowns gives."""

import numpy as np
import pytest
from scipy.optimize import least_squares

from asymptotics.decays.identification.fitting.least_squares import fit
from asymptotics.decays.identification.fitting.profile import coordinate, wald_interval
from asymptotics.decays.identification.fitting.waveform import WaveformModel
from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.decays.identification.measuring.observations import Observations, Samples

EPSILON, COUNT = 0.02, 9
T = np.arange(0, 90, 0.25)
COLUMNS = np.cos(np.pi * (T / T[-1])[:, None] * np.arange(1, COUNT + 1))
WAVE = np.sqrt(1 - EPSILON**2 / 4)
WHITE = 0.01 * np.random.default_rng(4).standard_normal(len(T))


def motion(epsilon, omega=1.0, size=1.0, start=0.0):
    """Law 1 from rest, exactly."""
    s = omega * (T - start)
    wave = np.sqrt(1 - epsilon**2 / 4)
    return size * np.exp(-epsilon / 2 * s) * (np.cos(wave * s) + epsilon / 2 / wave * np.sin(wave * s))


def fitted(x, slow, memory=0.0):
    n = np.arange(30)
    times = n * np.pi / WAVE
    values = (-1.0) ** n * np.exp(-EPSILON / 2 * times)
    seen = Observations.of(n, values, times, sigma_x=0.01 + 0 * times, sigma_t=0.01 + 0 * times)
    object.__setattr__(seen, "samples", Samples(T, x, 0.01, 300.0, memory, slow=slow))
    model = WaveformModel(read_candidate("1").swing(), seen)
    return fit(model, np.array([0.0, EPSILON, 0.0, 0.0, 0.0, 0.0]))


def test_it_is_least_squares_with_the_columns_as_unknowns():
    x = motion(EPSILON) + COLUMNS @ np.linspace(0.05, -0.02, COUNT) + WHITE
    found = fitted(x, COLUMNS)

    def left(at):
        whole = np.column_stack([np.ones(len(T)), T, COLUMNS])
        rest = x - motion(*at)
        return rest - whole @ np.linalg.lstsq(whole, rest, rcond=None)[0]

    other = least_squares(left, [EPSILON, 1.0, 1.0, 0.0], x_scale=[0.01, 0.01, 1, 1], xtol=1e-14, ftol=1e-14)
    assert found.theta[1] == pytest.approx(other.x[0], rel=2e-4)
    assert float((found.residuals**2).sum()) == pytest.approx(2 * other.cost, rel=1e-5)
    # Of the data, four numbers of the motion, offset and drift, and the columns.
    assert found.freedom == len(T) - 6 - COUNT
    assert found.freedoms["x"] == pytest.approx(len(T) - 6 - COUNT)
    error = np.sqrt(np.linalg.inv(other.jac.T @ other.jac)[0, 0] * 2 * other.cost / found.freedom)
    interval = wald_interval(found, coordinate(1))
    assert (interval.high - interval.low) / 2 == pytest.approx(1.97 * error, rel=0.01)


@pytest.mark.parametrize("memory", [0.0, 0.7])
def test_no_sum_of_the_columns_changes_the_fit(memory):
    x = motion(EPSILON) + WHITE
    with_line, without = (fitted(x + line, COLUMNS, memory) for line in (0.3 * COLUMNS[:, 4] - COLUMNS[:, 0], 0.0))
    assert with_line.theta == pytest.approx(without.theta, abs=1e-6)
    assert with_line.residuals == pytest.approx(without.residuals, abs=1e-6)
    # Without the columns the same line ruins the fit.
    assert np.std(fitted(x + 0.3 * COLUMNS[:, 4], None, memory).residuals) > 3 * np.std(without.residuals)
