"""What is told of a sensor: the step of its values, the scatter of its clock, and nothing where there is nothing."""

import numpy as np
import pytest

from asymptotics.decays.identification.measuring.sensors import quantum, sensor_notes

T = np.arange(600) * 0.02
X = np.exp(-T / 9) * np.cos(5 * T)


@pytest.mark.parametrize("step", [0.05, 0.1 * np.pi])
def test_a_step_is_found_and_a_finer_noise_hides_it(step):
    rounded = np.round(X * 7 / step) * step
    assert quantum(rounded) == pytest.approx(step, rel=1e-6)
    assert quantum(X) == 0.0
    assert quantum(rounded + 1e-3 * step * np.random.default_rng(0).standard_normal(600)) == 0.0


def test_an_even_clock_and_plain_values_have_no_note():
    assert sensor_notes(T, X) == []
    assert sensor_notes(np.sort(np.random.default_rng(1).uniform(0, 12, 600)), X) == []
    (said,) = sensor_notes(T + 0.002 * np.random.default_rng(2).standard_normal(600), X)
    assert said.startswith("time stamps scatter by 10 % of their spacing")
