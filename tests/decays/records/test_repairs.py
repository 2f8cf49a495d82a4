"""Spikes, holds, several releases and knocks in one record, and clocks that round: found, cut and told."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import asymptotics as asy
from asymptotics.decays.records.repairs import releases, spikes
from asymptotics.errors import InputError
from tests.worlds import RIVALS

TRUE = (0.1 / 6, 0.05)


def decay(start, seconds, seed, step=0.01):
    """x'' + 36 x + 0.1 x' + 0.05 x'|x'| = 0 from rest, with noise."""
    t = np.arange(0, seconds, step)
    force = lambda _, y: [y[1], -36 * y[0] - 0.1 * y[1] - 0.05 * y[1] * abs(y[1])]  # noqa: E731
    x = solve_ivp(force, (0, seconds), [start, 0.0], t_eval=t, method="DOP853", rtol=1e-10, atol=1e-12).y[0]
    return t, x, 0.003 * np.random.default_rng(seed).standard_normal(len(t))


def covered(answer):
    law = answer.law("1+2").law
    assert law.verdict == "consistent", law.reason
    assert all(e.stretched(1.5).contains(true) for e, true in zip(law.epsilon, TRUE))
    return law


def test_spikes_are_left_out_with_their_row():
    # failed before: "from t = 2.1 on, extremes do not alternate: left out", and two laws were consistent
    t, x, noise = decay(1.0, 30, 0)
    wild = [262, 904, 1369, 1431, 2755]
    x[wild] = 9.99
    assert np.flatnonzero(spikes(x + noise)).tolist() == wild
    answer = asy.identify({"t": t, "x": x + noise}, laws=RIVALS)
    assert any("5 samples far from their neighbours left out" in n and "row 262" in n for n in answer.notes)
    assert answer.verdict.text.startswith("identified: 1+2,")
    covered(answer)


@pytest.mark.parametrize("per_period", [3.2, 5, 8, 30, 100])
def test_a_decay_has_no_spikes(per_period):
    t = np.arange(0, 60, 2 * np.pi / per_period)
    assert not spikes(np.exp(-0.05 * t) * np.cos(t)).any()
    assert not spikes(np.maximum(1 - 0.03 * t, 0) * np.cos(t)).any()
    assert not spikes(np.round(np.exp(-0.05 * t) * np.cos(t), 2)).any()


def released_twice():
    first, second = decay(1.0, 20, 1)[1], decay(1.2, 30, 2)[1]
    x = np.concatenate([np.full(300, 1.0), first, np.linspace(first[-1], 1.2, 200), np.full(300, 1.2), second])
    return np.arange(len(x)) * 0.01, x + 0.003 * np.random.default_rng(3).standard_normal(len(x))


def test_two_releases_with_holds_are_two_runs():
    # failed before: "shows 0.14 periods (accepted: at least 1.5 periods of a free decay)"
    t, x = released_twice()
    answer = asy.identify({"t": t, "x": x}, laws=RIVALS)
    assert "identified in 2 runs: 1+2" in answer.verdict.text
    assert len(answer.per_run) == 2
    for run in answer.per_run:
        covered(run)
    told = [n for n in answer.notes if "released again: run" in n]
    assert len(told) == 2
    assert "held or touched between" in told[0]
    assert any("what comes before t = " in n and "not used" in n for n in answer.notes)


def test_a_knock_ends_one_decay_and_begins_another():
    # failed before: "none fits at the noise level"
    t, x, noise = decay(1.0, 30, 4)
    late = t > 22
    x[late] += 0.4 * np.sin(6 * (t[late] - 22)) * np.exp(-0.05 * (t[late] - 22))
    parts = releases(t, x + noise)
    assert [len(p) > 500 for p in parts] == [True, True]
    assert t[parts[0][-1]] < 23
    assert t[parts[1][0]] > 21.4
    assert t[parts[1][0]] < 24.5
    answer = asy.identify({"t": t, "x": x + noise}, laws=["1", "2", "1+2"])
    covered(answer.per_run[0])


@pytest.mark.parametrize("shape", ["decay", "growth", "beat", "noise", "short", "uneven", "gap"])
def test_what_is_one_decay_is_not_cut(shape):
    random = np.random.default_rng(5)
    t = np.arange(0, 60, 0.05)
    made = {
        "decay": np.exp(-0.05 * t), "growth": np.exp(0.05 * t), "beat": np.exp(-0.03 * t) * (1 + 0.3 * np.cos(0.5 * t)),
    }  # fmt: skip
    x = made.get(shape, np.exp(-0.15 * t)) * np.cos(5 * t) + 0.01 * random.standard_normal(len(t))
    if shape == "short":
        t, x = t[:100], x[:100]
    if shape == "uneven":
        keep = np.sort(random.choice(len(t), 500, replace=False))
        t, x = t[keep], x[keep]
    if shape == "gap":
        t, x = np.delete(t, slice(300, 500)), np.delete(x, slice(300, 500))
    assert [len(p) for p in releases(t, x)] == [len(t)]


def test_a_rounded_clock_is_taken_as_regular():
    t, x, noise = decay(1.0, 30, 6, step=0.0123)
    said = asy.identify({"t": np.round(t, 3), "x": x + noise}, laws=["1+2"])
    assert any("regular clock rounded to 0.001" in n for n in said.notes)
    covered(said)
    loose = asy.identify({"t": np.round(t, 2), "x": x + noise}, laws=["1+2"])
    assert any("regular clock rounded to 0.01" in n for n in loose.notes)
    covered(loose)


def test_a_file_of_touches_alone_is_refused_with_the_reason():
    t = np.arange(0, 20, 0.01)
    with pytest.raises(InputError, match="accepted"):
        asy.identify({"t": t, "x": np.where((t // 2) % 2, 1.0, 0.0) + 1e-3 * np.sin(40 * t)}, laws=["1"])


@pytest.mark.parametrize(
    ("unit", "size"), [("ms", 1000.0), ("mm,ms", 1000.0), ("ms,mm", 1000.0), ("min", 1 / 60), ("s,m", 1.0)]
)
def test_the_unit_of_time_can_be_said(unit, size):
    t, x, noise = decay(1.0, 30, 8)
    answer = asy.identify({"t": t * size, "x": x + noise}, unit=unit, laws=["1+2"])
    assert answer.units.omega_0 == pytest.approx(6.0, rel=1e-3)
    assert answer.units.unit == ("mm" if "mm" in unit else "m" if "m" in unit.split(",") else "")


@pytest.mark.parametrize("unit", ["ms,s", "mm,m", "mm,parsec", "mm;ms", ",ms"])
def test_units_that_are_not_clear_are_refused(unit):
    t, x, noise = decay(1.0, 10, 9)
    with pytest.raises(InputError, match="argument unit"):
        asy.identify({"t": t, "x": x}, unit=unit, laws=["1"])


def test_a_unit_of_time_that_contradicts_the_header_is_refused():
    t, x, noise = decay(1.0, 10, 9)
    with pytest.raises(InputError, match="argument unit: ms contradicts the column"):
        asy.identify({"t_s": t, "x": x}, unit="ms", laws=["1"])


def test_a_pause_is_no_coarse_clock():
    """Two kinds of steps, 0.01 and 5.01, are those of a clock that rounds to 5 only if all are its multiples."""
    t, x, noise = decay(1.0, 40, 4)
    kept = np.r_[0:1000, 1500 : len(t)]
    answer = asy.identify((t[kept], (x + noise)[kept]), laws=RIVALS)
    assert not [note for note in answer.notes if "regular clock" in note]
    covered(answer)


def test_cells_beyond_the_doubles_are_refused_in_words(tmp_path):
    file = tmp_path / "f.csv"
    file.write_text("\n0,1e400\n0,1e400")  # found by the fuzz: a warning of NumPy
    with pytest.raises(InputError, match="what is measured is not clear"):
        asy.identify(file, laws=["1"])


def let_go_again(phases, sizes, noise=0.0, rate=0.02, per_period=25):
    """Releases of 12 periods each that begin without a hold at any phase: x = size e^(-rate s) cos(s + phase)."""
    tau = np.arange(12 * per_period) * 2 * np.pi / per_period
    parts = [size * np.exp(-rate * tau) * np.cos(tau + phase) for phase, size in zip(phases, sizes, strict=True)]
    x = np.concatenate(parts) + noise * np.random.default_rng(1).standard_normal(len(tau) * len(parts))
    return np.arange(len(x)) * 2 * np.pi / per_period, x


@pytest.mark.parametrize("sizes", [(1.0, 0.22, 0.2), (1.0, 0.5, 0.4)])
@pytest.mark.parametrize("phase", [1.2, -1.2, 2.5])
def test_a_jump_of_the_phase_is_a_release_though_no_swing_grows(phase, sizes):
    t, x = let_go_again([0, phase, 0], sizes, noise=0.002)
    places = releases(t, x)
    assert len(places) == 3
    # Each lies within its release, and has two thirds of what swings by a tenth of the first at least.
    for k, part in enumerate(places):
        assert 300 * k <= part[0] <= 300 * k + 40 and 300 * k + 150 <= part[-1] <= 300 * (k + 1)


def test_a_phase_that_does_not_jump_and_a_small_knock_leave_one_decay():
    t, x = let_go_again([0, 0, 0], [1.0, np.exp(-0.02 * 24 * np.pi), np.exp(-0.02 * 48 * np.pi)], noise=0.002)
    assert [len(part) for part in releases(t, x)] == [len(t)]
    t, x = let_go_again([0, 0.3, 0.3], [1.0, np.exp(-0.02 * 24 * np.pi), np.exp(-0.02 * 48 * np.pi)], noise=0.002)
    assert [len(part) for part in releases(t, x)] == [len(t)]


@pytest.mark.parametrize("share", [0.3, 0.5])
def test_beats_have_jumps_of_the_phase_at_their_nodes_and_stay_one_record(share):
    t = np.arange(0, 400, 0.25)
    x = np.exp(-0.004 * t) * (np.cos(t) + share * np.cos(1.06 * t))
    assert [len(part) for part in releases(t, x)] == [len(t)]


def test_a_deep_pendulum_whose_frequency_runs_is_one_decay():
    t = np.arange(0, 150, 0.2)
    size = 2.8 * np.exp(-0.03 * t)
    x = size * np.cos(np.cumsum(1 - size**2 / 16 - size**4 / 3072) * 0.2)
    assert [len(part) for part in releases(t, x)] == [len(t)]
