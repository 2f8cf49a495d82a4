"""What a record shows at first sight: growth, constancy, plateaus, beats, gaps and steps, each at its border."""

import numpy as np
import pytest

from asymptotics.decays.identification.measuring.defects import (
    _is_cut,
    _is_sharp,
    _runs,
    is_constant,
    is_growing,
    shape_notes,
    usable,
)
from asymptotics.decays.identification.measuring.sensors import quantum, sensor_notes
from asymptotics.decays.records.rows import RowPlaces
from asymptotics.errors import InputError

ROWS = RowPlaces("file")


@pytest.mark.parametrize(
    ("size", "grows"),
    [([1, 1, 1.1], True), ([1, 5, 0.9], False), ([1, 1, 1], False), ([1, 2, 9, 9, 3, 1], True), ([1.0, -2.0], True)],
)
def test_growth_is_told_from_the_first_and_the_last_third(size, grows):
    assert is_growing(np.array(size)) == grows


def test_an_amplitude_is_constant_where_noise_hides_its_slope_and_its_shape():
    noise = np.tile([1.0, -1.0, -1.0, 1.0], 6)  # no slope, and neighbours as far apart as white noise has them
    n = np.linspace(-1, 1, 24)
    assert [is_constant((1 + 0.01 * noise)[:count]) for count in (24, 8, 7)] == [True, True, False]
    error = 0.01 * np.sqrt((np.diff(noise) ** 2).sum() / 46 / (n @ n))
    assert is_constant(1 + 0.01 * noise + 3.7 * error * n) and not is_constant(1 + 0.01 * noise + 4.4 * error * n)
    assert not is_constant(1 + 0.01 * noise + 0.05 * n**2)  # no slope, but a shape


def test_runs_are_pairs_of_start_and_stop():
    assert _runs(np.array([1, 1, 0, 1, 0, 0, 1], dtype=bool)) == [(0, 2), (3, 4), (6, 7)]
    assert _runs(np.zeros(3, dtype=bool)) == [] and _runs(np.ones(3, dtype=bool)) == [(0, 3)]


def clipped(level):
    t = np.linspace(0, 60, 1201)
    return t, np.clip(np.exp(-0.03 * t) * np.cos(t), -level, level)


def test_clipped_peaks_are_masked_and_whole_ones_are_not():
    t, x = clipped(0.6)
    whole = usable(t, x, ROWS)
    assert (~whole == (np.abs(x) == 0.6)).all() and not whole.all()
    t, x = clipped(2.0)
    assert usable(t, x, ROWS).all() and usable(t, np.round(x, 1), ROWS).all()
    with pytest.raises(InputError, match="of the samples are clipped at the"):
        usable(*clipped(0.01), ROWS)


def test_a_plateau_that_is_left_from_rest_is_no_clipped_peak():
    """a/2, 3a/2, 5a/2 ...: a hand that lets go; the same entered at speed is cut."""
    steps, fine = 0.01 * (np.arange(8) + 0.5), [0.0, 1e-3]  # the record resolves a thousandth somewhere
    rest = np.concatenate([1 - np.cumsum(steps)[::-1], np.ones(6), 1 - np.cumsum(steps), fine])
    fast = np.concatenate([1 - np.cumsum(steps + 0.05)[::-1], np.ones(6), 1 - np.cumsum(steps + 0.05), fine])
    half = np.concatenate([rest[:8], fast[8:]])
    assert not _is_sharp(rest, 8, 14) and _is_sharp(fast, 8, 14) and not _is_sharp(half, 8, 14)
    assert not _is_sharp(fast[5:], 3, 9)  # too few samples on one side to know
    runs = [(8, 14)] * 3
    assert _is_cut(fast, runs, 1.0) and not _is_cut(fast, [(8, 10)] * 3, 1.0) and not _is_cut(fast, [], 1.0)


def test_beats_growth_and_gaps_are_told():
    t, sigma = np.linspace(0, 10, 101), np.full(9, 1e-3)
    size = 0.9 ** np.arange(9)
    turning = size * (-1.0) ** np.arange(9)
    assert shape_notes(t, t, turning, sigma, 2.0) == []
    assert "grows" in shape_notes(t, t, turning[::-1], sigma, 2.0)[0]
    beat = turning.copy()
    beat[4] *= 1.5
    assert shape_notes(t, t, beat, sigma, 2.0) == []  # once: a knock
    beat[8] *= 1.5
    (said,) = shape_notes(t, t, beat, sigma, 2.0)
    assert said == "the amplitude rises 2 times: a second mode, forcing, or an unquiet base"
    holed = np.delete(t, slice(40, 44))
    assert shape_notes(holed, holed, turning, sigma, 2.0) == ["the longest gap between samples is 0.5, 0.25 periods"]
    assert shape_notes(holed, holed, turning, sigma, 2.6) == []


@pytest.mark.parametrize("step", [0.25, 0.1, 1.7])
def test_the_step_of_a_sensor_is_what_all_values_are_multiples_of(step):
    rng = np.random.default_rng(3)
    x = np.round(np.cos(np.linspace(0, 60, 900)) * 9) * step + 0.3
    assert quantum(x) == pytest.approx(step)
    assert quantum(np.sort(x)[[0, -1]]) == 0.0 and quantum(rng.standard_normal(900)) == 0.0
    off = x.copy()
    off[7] += 0.4137 * step  # one value between two steps
    assert quantum(off) == 0.0


def test_stamps_that_scatter_are_told_between_one_and_thirty_five_percent():
    rng, t = np.random.default_rng(3), np.arange(400) * 0.01
    x = rng.standard_normal(400)
    for scatter, told in ((0.002, False), (0.05, True), (0.6, False)):
        stamps = t + 0.01 * scatter * rng.standard_normal(400)
        assert any("time stamps scatter by" in note for note in sensor_notes(np.sort(stamps), x)) == told
    steps = sensor_notes(t, np.round(np.cos(t * 3) * 9) / 10)
    assert steps == ["values in steps of 0.1: at least 0.029 of noise (step/sqrt(12))"]


def test_growth_and_rises_are_told_beyond_the_errors_of_both_ends():
    """Five errors of both ends, six of two neighbours of one side; each with its own error."""
    t, few = np.arange(6.0), np.full(6, 1e-3)
    grown = lambda excess: shape_notes(t, t, np.array([1.0, -1, 1, -1, 1, -1 - excess]), few, 8.0)  # noqa: E731
    assert grown(0.0099) == [] and grown(0.0101) == ["the amplitude grows: this is not a decay"]
    sigma = np.array([1e-3, 1, 2e-3, 1, 3e-3, 1, 4e-3, 1, 5e-3])
    size = np.ones(9)

    def rises(first, second):
        size[[2, 4, 6, 8]] = np.cumsum([first, -0.5, second, -0.5]) + 1.0
        return [
            note
            for note in shape_notes(np.arange(9.0), size, size * (-1.0) ** np.arange(9), sigma, 8.0)
            if "rises" in note
        ]

    said = ["the amplitude rises 2 times: a second mode, forcing, or an unquiet base"]
    assert rises(0.0181, 0.0421) == said  # 6 (1 + 2)/1000 and 6 (3 + 4)/1000, and a millionth
    assert rises(0.0179, 0.0421) == [] == rises(0.0181, 0.0419)


def test_a_gap_of_a_fifth_of_a_period_is_told():
    t = np.array([0.0, 1.0, 2.0, 4.0])
    told = lambda period: shape_notes(t, t, np.array([1.0, -0.9]), np.zeros(2), period)  # noqa: E731
    assert told(10.0) == [] and told(9.9) == ["the longest gap between samples is 2, 0.2 periods"]
