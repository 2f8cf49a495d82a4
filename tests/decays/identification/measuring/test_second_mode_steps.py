"""A second mode step by step: where its peak is seen, the chirp of the motion, its columns, frequency and worth."""

import numpy as np
import pytest

from asymptotics.decays.identification.measuring import second_mode
from asymptotics.decays.identification.measuring.demodulation import SpectralLine

T = 3.0 + np.arange(0, 100, 0.1)


def waves(*parts, t=T):
    """Sums of (size, frequency, fall)."""
    return sum(size * np.exp(-fall * (t - t[0])) * np.cos(frequency * t) for size, frequency, fall in parts)


BIN = 2 * np.pi / (T[-1] - T[0])


@pytest.mark.parametrize("frequency", [0.5, 2.2, 4.3, 7.4])
def test_a_line_beside_the_motion_is_seen_to_a_bin(frequency):
    found = second_mode._peak(T, waves((1, 1.0, 0.01), (0.05, frequency, 0.0)))
    assert found == pytest.approx((1.0, frequency), abs=BIN)


@pytest.mark.parametrize("frequency", [0.2, 8.6, 1.03, 3.05, 5.1])
def test_too_slow_too_fast_or_an_overtone_is_no_line(frequency):
    """Below 0.3 and above 8 of the motion; within 3 bins or 3 % of an odd overtone."""
    assert second_mode._peak(T, waves((1, 1.0, 0.01), (0.05, frequency, 0.0))) is None


def test_lines_are_sought_up_to_a_fixed_share_of_the_samples():
    t = np.arange(0, 400, 0.4)
    fast = lambda frequency: second_mode._peak(t, waves((1, 1.0, 0.002), (0.1, frequency, 0.0), t=t))  # noqa: E731
    assert fast(6.0) == pytest.approx((1.0, 6.0), abs=0.03)
    assert fast(6.4)[1] < 0.4 * 2 * np.pi / 0.4  # what is seen is an image of it, made by the samples


@pytest.mark.parametrize(("size", "seen"), [(6e-4, False), (3e-3, True)])
def test_a_line_below_a_thousandth_of_the_motion_is_not_looked_at(size, seen):
    found = second_mode._peak(T, waves((1, 1.0, 0.0), (size, 4.3, 0.0)))
    assert (found is not None) == seen


def test_of_two_lines_the_higher_one_is_named():
    assert second_mode._peak(T, waves((1, 1.0, 0.01), (0.05, 2.2, 0.0), (0.1, 4.3, 0.0)))[1] == pytest.approx(
        4.3, abs=BIN
    )
    assert second_mode._peak(T, waves((1, 1.0, 0.01), (0.1, 2.2, 0.0), (0.05, 4.3, 0.0)))[1] == pytest.approx(
        2.2, abs=BIN
    )


def test_records_too_short_or_too_coarse_have_no_second_mode():
    x = waves((1, 1.0, 0.0), (0.3, 4.3, 0.0))
    assert second_mode._peak(T, x) is not None
    assert second_mode._peak(T[:199], x[:199]) is None  # 200 samples
    short = T[: int(4.4 * 2 * np.pi / 0.1)]  # below five periods
    assert second_mode._peak(short, x[: len(short)]) is None
    coarse = np.arange(0, 300, 0.6)  # ten samples a period
    assert second_mode._peak(coarse, waves((1, 1.0, 0.0), (0.3, 2.3, 0.0), t=coarse)) is None
    fine = np.arange(0, 300, 0.5)  # twelve and a half
    assert second_mode._peak(fine, waves((1, 1.0, 0.0), (0.3, 2.3, 0.0), t=fine)) is not None


def test_noise_about_the_motion_is_no_line():
    noise = 0.02 * np.random.default_rng(1).standard_normal(len(T))
    assert second_mode._peak(T, waves((1, 1.0, 0.01)) + noise) is None


@pytest.mark.parametrize("chirp", [0.0, 0.02, -0.05])
def test_the_chirp_is_the_change_of_the_frequency_between_both_halves(chirp):
    """Phase w t (1 + chirp t/(2 T)): the mean frequencies of the halves differ by chirp/2 of w."""
    t = np.arange(0, 200, 0.05)
    x = 0.7 + np.cos(1.3 * t * (1 + chirp * t / 400))
    assert second_mode._chirp(t, x, 1.3) == pytest.approx(abs(chirp) / 2, abs=1e-3)
    assert second_mode._chirp(5.0 + t, x, 1.3) == pytest.approx(abs(chirp) / 2, abs=1e-3)


def test_of_fewer_than_six_means_the_chirp_is_not_told():
    t = np.arange(0, 60, 0.05)
    x = np.cos(t * (1 + 0.05 * t / 60))
    means = lambda end: second_mode._chirp(t[t < end], x[t < end], 1.0)  # noqa: E731  (each lasts 4 pi)
    assert means(4.9 * 4 * np.pi - 4 * np.pi) == 0.0 and means(5.9 * 4 * np.pi - 4 * np.pi) == 0.0
    long = np.arange(0, 6.5 * 4 * np.pi, 0.05)
    assert second_mode._chirp(long, np.cos(long * (1 + 0.05 * long / 60)), 1.0) > 0.01


def test_the_columns_of_a_line_are_polynomials_times_its_waves():
    found = second_mode._line(T, 2.5, 2)
    u = 2 * (T - T[0]) / (T[-1] - T[0]) - 1
    for k, polynomial in enumerate((np.ones(len(T)), u, 2 * u**2 - 1)):
        assert found[:, 2 * k] == pytest.approx(polynomial * np.cos(2.5 * T), abs=1e-12)
        assert found[:, 2 * k + 1] == pytest.approx(polynomial * np.sin(2.5 * T), abs=1e-12)
    assert found.shape == (len(T), 6) and second_mode._line(T, 2.5).shape == (len(T), 14)
    assert second_mode._places(T) == pytest.approx(u, abs=1e-15)


@pytest.mark.parametrize(("third", "columns"), [(1, 2 + 6), (3, 2 + 12)])
def test_the_columns_of_the_motion_are_base_drift_the_line_and_its_overtone(third, columns):
    line = SpectralLine(T, 1.5, np.zeros(3), np.zeros(third), 0.0, 0.0, 0.0)
    found = second_mode.motion_columns(line, T)
    assert found.shape == (len(T), columns)
    assert (found[:, 0] == 1).all() and found[:, 1] == pytest.approx(second_mode._places(T))
    assert np.array_equal(found[:, 2:8], second_mode._line(T, 1.5, 2))
    if third > 1:
        assert np.array_equal(found[:, 8:], second_mode._line(T, 4.5, 2))


def test_coefficients_are_those_of_least_squares():
    main, line = second_mode._line(T, 1.0, 1), second_mode._line(T, 2.5, 1)
    x = np.random.default_rng(3).standard_normal(len(T))
    both = np.concatenate([main, line], axis=1)
    assert second_mode.solved(main, line, x) == pytest.approx(np.linalg.lstsq(both, x, rcond=None)[0], abs=1e-10)


@pytest.mark.parametrize("off", [-1.2, -0.4, 0.0, 0.35, 1.3])
def test_the_frequency_is_refined_to_a_twentieth_of_a_bin(off):
    x = np.cos(2.5 * T + 0.3)
    assert second_mode._refined(T, x, 2.5 + off * BIN) == pytest.approx(2.5, abs=0.026 * BIN)
    # Not beyond a bin and a half.
    assert second_mode._refined(T, x, 2.5 + 3 * BIN) == pytest.approx(2.5 + 1.5 * BIN, abs=1e-9)


def fitted(other, noise=1e-3, guess=None):
    x = waves((1, 1.0, 0.01)) + 0.2 + noise * np.random.default_rng(4).standard_normal(len(T))
    size, frequency, fall = other
    line = size * np.exp(-fall * (T - T[0])) * np.cos(frequency * T)
    return line, second_mode.line_beside(T, x + line, 1.0, frequency if guess is None else guess)


def test_a_line_is_fitted_beside_the_motion_and_told_by_its_size_at_the_beginning():
    line, (taken, said, at) = fitted((0.05, 2.7, 0.005), guess=2.7 + 0.4 * BIN)
    assert np.abs(taken - line).max() < 1.5e-3
    assert said.startswith("a second mode at 2.7") and "rad/s, 5 % of the first at the beginning" in said
    assert said.endswith(", measured and taken off")
    assert abs(float(said.split()[4]) - 2.7) < 0.03 * BIN and abs(at - 2.7) < 0.03 * BIN


def test_a_line_that_is_not_worth_its_coefficients_stays():
    """ln of the sum of squares, times the samples, must fall by 60 more than 2 for each coefficient."""
    assert fitted((2.2e-4, 2.7, 0.0))[1] is None and fitted((6e-4, 2.7, 0.0))[1] is not None
    assert fitted((0.0, 2.7, 0.0))[1] is None


def test_a_line_larger_than_the_record_is_one_of_two_that_cancel(monkeypatch):
    real = second_mode.solved
    monkeypatch.setattr(second_mode, "solved", lambda main, line, x: real(main, line, x) * 30)
    assert fitted((0.05, 2.7, 0.005))[1] is None  # 1.5 of a range of about 2


def test_each_line_is_sought_in_what_the_ones_before_left_and_two_at_most(monkeypatch):
    asked = []

    def fitted_line(t, x, omega, other):
        asked.append((omega, other, float(x[0])))
        return np.ones(len(t)), f"line {len(asked)}", other

    monkeypatch.setattr(second_mode, "_peak", lambda t, x: (1.0, 2.0 + x[0]))
    monkeypatch.setattr(second_mode, "line_beside", fitted_line)
    rest, notes = second_mode.without_second_modes(T, np.full(len(T), 5.0))
    assert notes == ("line 1", "line 2") and (rest == 3.0).all()
    assert asked == [(1.0, 7.0, 5.0), (1.0, 6.0, 4.0)]
    monkeypatch.setattr(second_mode, "line_beside", lambda *_: None)
    x = np.ones(len(T))
    assert second_mode.without_second_modes(T, x) == (x, ()) and second_mode.without_second_modes(T, x)[0] is x
