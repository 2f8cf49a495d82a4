"""Peaks of one side with times are turning points of even number; a sampled swing of that name is none."""

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.synthetic import exact
from asymptotics.decays.records.table import read_table
from asymptotics.errors import InputError

RUN = exact("1", [0.02], 60)
T, X = RUN.tau[::2], np.exp(RUN.a[::2])
NOISE = 1e-3 * np.random.default_rng(3).standard_normal(len(T))


def test_peaks_of_one_side_give_the_strength():
    answer = asy.identify({"t": T, "amplitude": X + NOISE}, laws=["1", "2", "1+2"])
    assert answer.verdict.text.startswith("identified: 1,") and answer.law("1").law.epsilon[0].contains(0.02)
    assert any("31 peaks of one side" in note for note in answer.notes)
    # Near miss: read as turning points of both sides they would have half the loss.
    both = asy.identify({"n": np.arange(31), "x": X + NOISE, "tau": T}, laws=["1"])
    assert not both.law("1").law.epsilon[0].contains(0.02)


def test_a_missed_peak_is_a_gap():
    table = read_table({"t": np.delete(T, 4), "peak (m)": np.delete(X, 4)})
    assert table.kind == "turning-points" and table.columns["n"][:6].tolist() == [0, 2, 4, 6, 10, 12]


def test_a_sampled_swing_stays_a_record_and_an_envelope_of_many_samples_is_one():
    t = np.arange(0, 60, 0.05)
    assert read_table({"t": t, "amplitude": np.exp(-0.05 * t) * np.cos(t)}).kind == "record"
    assert read_table({"t": t, "amplitude": 5 + np.exp(-0.05 * t) * np.cos(t)}).kind == "record"
    assert read_table({"t": t, "amplitude": np.exp(-0.05 * t)}).kind == "envelope"
    assert read_table({"t": T, "amplitude": X}, kind="record").kind == "record"


def test_peak_to_peak_is_halved():
    answer = asy.identify({"t": T, "peak-to-peak (m)": 2 * (X + NOISE)}, laws=["1"], bootstrap=False)
    assert abs(answer.runs[0].x[0]) < 1.01 and answer.law("1").law.epsilon[0].contains(0.02)
    assert any("half of it" in note for note in answer.notes)


def test_columns_of_errors_weigh_the_fit():
    # failed before: they were not used
    wild = NOISE.copy()
    wild[5] += 0.05
    error = np.full(len(T), 1e-3)
    error[5] = 0.05
    data = {"t": T, "amplitude": X + wild, "xerr": 0 * T + 0.01, "yerr": error}
    answer = asy.identify(data, laws=["1"], bootstrap=False)
    assert any("errors from 'xerr', 'yerr'" in note for note in answer.notes)
    (run,) = answer.runs
    assert run.sigma_x[5] == 0.05 and run.sigma_t[0] == 0.01
    law, plain = answer.law("1").law, asy.identify({"t": T, "amplitude": X + wild}, laws=["1"], bootstrap=False)
    assert law.epsilon[0].contains(0.02)
    # Near miss: without them the wild peak makes the interval many times as long.
    width = [e.high - e.low for e in (law.epsilon[0], plain.law("1").law.epsilon[0])]
    assert width[1] > 3 * width[0]


def test_errors_that_are_missing_or_zero_weigh_nothing():
    for bad in (0.0, np.nan):
        error = np.full(len(T), 1e-3)
        error[3] = bad
        table = read_table({"t": T, "amplitude": X, "yerr": error})
        assert "sigma_x" not in table.columns and len(table.columns["x"]) == len(T)


@pytest.mark.parametrize("count", ["cycle", "Cycles", "n"])
@pytest.mark.parametrize(("name", "share"), [("A (mm)", 1.0), ("peak-to-peak (mm)", 2.0), ("amplitude (mm)", 1.0)])
def test_a_table_of_counted_peaks_has_its_amplitudes_and_half_swings(count, name, share):
    """Two columns, in both orders; what lies between the peaks of both sides is twice the amplitude."""
    numbers, sizes = np.array([0, 3, 4, 7, 9]), np.array([5.0, 4.0, 3.5, 2.5, 1.7])
    for swap in (False, True):
        columns = {count: numbers, name: share * sizes}
        found = read_table(dict(reversed(columns.items())) if swap else columns)
        assert found.kind == "turning-points" and found.unit == "mm"
        assert np.array_equal(found.columns["n"], numbers * (1 if count == "n" else 2))
        assert np.array_equal(found.columns["x"], sizes)
        assert any("counts cycles" in note for note in found.notes) == (count != "n")
        assert any("are half of it" in note for note in found.notes) == (share == 2)


def test_an_acceleration_beside_a_count_is_no_amplitude():
    for name in ("A (m/s^2)", "acc", "a"):
        with pytest.raises(InputError, match="acceleration"):
            read_table({"n": [0, 1, 2, 3], name: [5.0, -4.0, 3.0, -2.0]})


def test_a_slow_decay_whose_peaks_rise_by_noise_and_are_found_twice_is_one_of_peaks():
    """Failed before: fitted as a motion of 30 samples a period."""
    t, random = 1.43 * np.arange(90), np.random.default_rng(8)
    size = 0.24 * np.exp(-t / 160) + 0.0013 * random.standard_normal(len(t))
    assert np.mean(np.diff(size) < 0) < 0.8
    twice = [20, 55]
    data = {"t": np.insert(t, twice, t[twice] - 0.06), "amplitude": np.insert(size, twice, size[twice] + 1e-5)}
    table = read_table({"t": np.sort(data["t"]), "amplitude": data["amplitude"]})
    assert table.kind == "turning-points" and np.array_equal(table.columns["n"], 2 * np.arange(90))
    assert any("90 peaks of one side" in note and "(2 found twice count once)" in note for note in table.notes)
    errors = {**data, "yerr": np.linspace(1, 2, 92)}
    assert len(read_table(errors).columns["sigma_x"]) == 90
    # Near miss: values that wander and do not fall are samples.
    assert read_table({"t": t, "amplitude": 0.3 + 0.1 * random.standard_normal(90)}).kind == "record"


def test_maxima_before_the_minima_are_sorted_by_time():
    """Failed before: a motion of 2 samples a period."""
    n = np.arange(19)
    t, x = 0.9 * n, np.exp(-0.03 * n) * (-1.0) ** n
    order = np.concatenate([n[::2], n[1::2]])
    table = read_table({"t": t[order], "theta (rad)": x[order]})
    assert table.kind == "turning-points" and np.array_equal(table.columns["x"], x)
    assert np.array_equal(table.columns["tau"], t) and any("sorted by time" in note for note in table.notes)


def test_a_voltage_that_falls_into_its_noise_is_an_envelope_until_there(tmp_path):
    """Its frequency says that it shows no swing; a few values below 0 made it a motion, which was refused as none."""
    t = np.arange(0, 30, 0.2)
    volts = 3.1 * np.exp(-t / 4.2) + 0.004 * np.random.default_rng(3).standard_normal(len(t))
    assert (volts < 0).any()
    path = tmp_path / "ringdown.txt"
    path.write_text("f0 = 1.204 MHz\nt/s\tU/mV\n" + "\n".join(f"{a:.3f}\t{b:.5f}" for a, b in zip(t, volts)))
    answer = asy.identify(path, laws=["1", "2"])
    assert answer.verdict.kind == "identified" and str(answer.best.law.candidate) == "1"
    true = np.pi * 1.204e6 * 4.2
    for row in answer.to_dict()["envelope"]["quality"]:
        assert float(row["low"]) < true < float(row["high"])
    assert any("0 or hidden by noise, left out" in note for note in answer.notes)
    # Near miss: without a frequency a voltage may swing.
    path.write_text(path.read_text().partition("\n")[2])
    with pytest.raises(InputError):
        asy.identify(path, laws=["1", "2"])


@pytest.mark.parametrize("per_period", [8, 13, 15, 40, 200])
@pytest.mark.parametrize("noise", [0.0, 0.01])
def test_a_motion_under_a_line_that_says_some_frequency_stays_a_motion(per_period, noise, tmp_path):
    """Failed before: an envelope of its first quarter swing, the other 19 periods "hidden by noise"."""
    t = np.arange(20 * per_period) / per_period
    x = 5 * np.exp(-0.05 * t) * np.cos(2 * np.pi * t) + noise * np.random.default_rng(1).standard_normal(len(t))
    path = tmp_path / "swings.csv"
    path.write_text("# Frequency [Hz]: 1000\nt (s),x (mm)\n" + "\n".join(f"{a:.6f},{b:.6f}" for a, b in zip(t, x)))
    envelope = asy.identify(path, laws=["1"]).to_dict()["envelope"]
    assert float(envelope["period"]["estimate"]) == pytest.approx(1, rel=1e-3)
    assert float(envelope["quality"][1]["estimate"]) == pytest.approx(2 * np.pi / (2 * 0.05), rel=0.02)


def test_a_frequency_that_is_said_tells_neighbouring_peaks_from_distant_amplitudes():
    """Failed before: peaks 30 s apart at 12 rad/s had a period of 30 s; two of them Q = 3.43 in place of 196."""
    t = 30.0 * np.arange(7)
    x = 5 * np.exp(-t / 170) * (1 + 1e-4 * np.random.default_rng(2).standard_normal(7))
    found = asy.identify({"t": t, "amplitude": x}, laws=["1"], omega_0=12).to_dict()["envelope"]
    assert float(found["period"]["estimate"]) == pytest.approx(2 * np.pi / 12)
    assert float(found["quality"][1]["estimate"]) == pytest.approx(12 * 170 / 2, rel=1e-2)
    for count in (2, 3, 4):
        few = asy.identify({"t": t[:count], "amplitude": x[:count]}, laws=["1", "2"], omega_0=12)
        assert isinstance(few, asy.DampingLaw)
        assert few.law("1").strengths[0].estimate == pytest.approx(2 / 170, rel=1e-2)
    # Near misses: neighbours at the frequency that is said, and nothing said.
    for said in (2 * np.pi / 30, None):
        near = asy.identify({"t": t, "amplitude": x}, laws=["1"], omega_0=said).to_dict()["envelope"]
        assert float(near["period"]["estimate"]) == pytest.approx(30, rel=1e-2)
