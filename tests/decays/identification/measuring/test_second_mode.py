"""A second mode in the record: found, measured, taken off and told; a motion alone is left as it is."""

import re

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.measuring.second_mode import without_second_modes
from benchmarks.decays import decay, motion

T = np.arange(0.3, 45 * np.pi, 0.1)
NOISE = 3e-3 * np.random.default_rng(11).standard_normal(len(T))


def ringing(frequency, size, losses=((1.0, 0.012), (2.0, 0.012))):
    """A decay by the losses with a damped line of another frequency on it."""
    pure = motion(lambda x: x, losses, 1.0, T)[0]
    return pure, pure + size * np.exp(-0.008 * T) * np.cos(frequency * T + 1.0)


def told(note):
    """(frequency, percent) of a note."""
    return [float(number) for number in re.findall(r"at (\S+) rad/s, (\S+) %", note)[0]]


@pytest.mark.parametrize(("frequency", "size"), [(0.45, 0.05), (1.7, 0.1), (2.1, 0.06), (4.3, 0.02), (6.2, 0.1)])
def test_a_second_mode_is_measured_to_the_noise(frequency, size):
    pure, x = ringing(frequency, size)
    rest, notes = without_second_modes(T, x + NOISE)
    assert len(notes) == 1 and told(notes[0]) == pytest.approx((frequency, 100 * size), rel=0.1)
    wrong = rest - NOISE - pure
    assert np.sqrt(np.mean(wrong**2)) < 0.12 * 3e-3  # sqrt(14 coefficients/1400 samples) of the noise, and a little
    assert np.abs(wrong).max() < 0.05 * size + 3e-3


def test_two_lines_are_taken_off_one_after_the_other():
    pure, x = ringing(2.4, 0.05)
    rest, notes = without_second_modes(T, x + 0.02 * np.cos(5.7 * T) + NOISE)
    assert len(notes) == 2
    assert np.sqrt(np.mean((rest - NOISE - pure) ** 2)) < 0.2 * 3e-3


@pytest.mark.parametrize(
    "kind", ["plain", "cubic spring", "pendulum", "quantised", "coloured", "uneven", "acceleration"]
)
def test_a_motion_alone_keeps_its_samples(kind):
    for index in range(5):
        data = decay(kind, index, seed=4711).data
        x = data["a" if kind == "acceleration" else "x"]
        rest, notes = without_second_modes(data["t"], x)
        assert notes == () and rest is x


def test_the_law_under_a_second_mode_is_found_and_the_mode_is_told():
    pure, x = ringing(1.7, 0.06)
    answer = asy.identify({"t": T, "x": x + NOISE}, laws=["1", "2", "1+2", "0+1"])
    law = answer.law("1+2").law
    assert law.verdict == "consistent"
    assert [e.contains(v) for e, v in zip(law.epsilon, (0.012, 0.012), strict=True)] == [True, True]
    (note,) = (note for note in answer.notes if "second mode" in note)
    assert told(note) == pytest.approx((1.7, 6.0), rel=0.05)
