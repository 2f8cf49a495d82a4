"""A sampled motion and what its record is cut to, step by step: thinning, errors, late beginnings, rest, and tails."""

import numpy as np
import pytest

from asymptotics.decays.identification import sources
from asymptotics.decays.identification.measuring import sampled
from asymptotics.decays.identification.measuring.at_rest import moving
from asymptotics.decays.identification.measuring.observations import Observations, Samples
from asymptotics.decays.identification.measuring.sampled import _begins_late, observations_of_motion
from asymptotics.decays.records.rows import RowPlaces
from asymptotics.decays.records.table import RecordTable
from asymptotics.errors import InputError

T = np.arange(0, 60, 0.3)


def motion(t=T, fall=0.02, omega=1.0, phase=0.4, noise=0.0):
    return np.exp(-fall * t) * np.cos(omega * t + phase) + noise * np.random.default_rng(2).standard_normal(len(t))


def of(t, x, **more):
    return observations_of_motion(t, x, **({"unit": "m", "name": "record"} | more))


def test_the_samples_stay_and_the_line_gives_the_turning_points():
    x = motion(noise=1e-3)
    seen = of(T, x, notes=("before",))
    assert np.array_equal(seen.samples.t, T) and np.array_equal(seen.samples.x, x)
    assert seen.samples.noise == pytest.approx(1e-3, rel=0.15) and seen.samples.derivative == 0
    assert (seen.unit, seen.name, seen.notes[0]) == ("m", "record", "before") and seen.n.tolist() == list(
        range(len(seen.n))
    )
    k = np.round((seen.t + 0.4) / np.pi)
    assert seen.t == pytest.approx(k * np.pi - 0.4 - np.arctan(0.02), abs=0.05)
    assert seen.x == pytest.approx(np.exp(-0.02 * seen.t) * (-1.0) ** k, rel=0.05)
    a_period = 2 * np.pi / 0.3
    assert seen.notes[1].startswith("all 200 samples of the motion fitted (21 a period); noise 0.00")
    inside = (seen.t >= T[0]) & (seen.t <= T[-1])
    error = np.hypot(seen.samples.noise * np.sqrt(4 / a_period), np.where(inside, 3e-4, 0.05) * np.abs(seen.x))
    assert seen.sigma_x == pytest.approx(error, rel=1e-2) and seen.sigma_t == pytest.approx(
        error / np.abs(seen.x), rel=1e-2
    )


@pytest.mark.parametrize(("derivative", "word"), [(1, "velocity"), (2, "acceleration")])
def test_of_a_derivative_the_turning_points_are_those_of_the_motion(derivative, word):
    rate = (-0.02 + 2j) ** derivative
    x = (rate * np.exp((-0.02 + 2j) * T + 0.4j)).real
    seen = of(T, x, derivative=derivative)
    k = np.round((2 * seen.t + 0.4) / np.pi)
    assert 2 * seen.t == pytest.approx(k * np.pi - 0.4 - 0.01, abs=0.1)
    assert seen.x == pytest.approx(np.exp(-0.02 * seen.t) * (-1.0) ** k, rel=0.06)
    assert seen.samples.derivative == derivative and f"samples of the {word} fitted" in seen.notes[-1]
    outside = (seen.t < T[0]) | (seen.t > T[-1])
    assert seen.sigma_x[outside] == pytest.approx(0.05 * np.abs(seen.x[outside]), rel=1e-2)


def test_a_memory_of_the_noise_is_told():
    rng, r = np.random.default_rng(1), [0.0]
    t = np.arange(0, 120, 0.2)
    for _ in t[1:]:
        r.append(0.8 * r[-1] + 0.6 * rng.standard_normal())
    seen = of(t, motion(t, 0.005) + 0.01 * np.array(r))
    assert seen.samples.memory == pytest.approx(0.8, abs=0.2)
    assert f", neighbours correlated by {seen.samples.memory:.2f}: allowed for" in seen.notes[-1]


def test_more_samples_than_enough_are_means(monkeypatch):
    monkeypatch.setattr(sampled, "ENOUGH", 300)
    monkeypatch.setattr(sampled, "MAX_SAMPLES", 1000)
    t = np.arange(0, 60, 0.05)
    seen = of(t, motion(t))
    assert len(seen.samples.t) == 300 and "the means of 4 samples each are fitted" in seen.notes
    assert seen.samples.x == pytest.approx(motion(seen.samples.t), abs=1e-3)
    assert "means" not in " ".join(of(T[:200], motion()[:200]).notes)


def test_what_is_forced_or_hidden_is_left_out_and_the_rest_fitted_again():
    x = motion(fall=0.15, noise=0.01)
    seen = of(T, x)
    last = seen.samples.t[-1]
    assert 0.15 * last == pytest.approx(np.log(1 / 0.015), rel=0.2) and len(seen.samples.t) < 200
    assert f"free decay from t = 0 to {last:.6g}: the rest is forced, held or hidden by noise" in seen.notes


@pytest.mark.parametrize(
    ("times", "late"),
    [
        ([-3.0, 0.05, 3.0, 6.0, 9.0], True), ([-3.0, 0.29, 3.2, 6.0, 9.0], True), ([-3.0, 0.31, 3.2, 6.0, 9.0], False),
        ([0.0, 0.05, 3.0, 6.0, 9.0], False), ([-3.0, 0.05, 3.0, 6.0], False), ([-3.0, -0.2, 3.0, 6.0, 9.0], True),
    ],
)  # fmt: skip
def test_a_record_begins_at_the_turning_point_within_a_tenth_of_a_half_swing(times, late):
    assert _begins_late(np.array(times), 0.0) == late


def test_a_feigned_turning_point_before_the_release_is_left_out():
    x = motion(phase=-0.1)  # turns at t = 0.08, of a half-swing of pi
    seen = of(T, x)
    assert seen.n[0] == 0 and seen.t[0] == pytest.approx(0.08, abs=0.05) and seen.x[0] > 0
    assert seen.samples.t[0] >= seen.t[0] - 0.02 * np.diff(seen.t)[0]


# Rest.

PERIOD = 2 * np.pi


def held(stop, t, noise=1e-3, place=0.02):
    x = np.where(t < stop, (1 - t / stop) * np.cos(t), place)
    return x + noise * np.random.default_rng(0).standard_normal(len(t))


def test_a_record_is_cut_half_a_period_before_its_rest():
    t = np.arange(0, 80, 0.2)
    kept = moving(t, held(40.0, t), PERIOD)
    assert kept.start is None and t[kept][-1] == pytest.approx(40 - PERIOD / 2, abs=2.0)


@pytest.mark.parametrize("change", ["coarse", "short rest", "no rest", "still", "two"])
def test_without_a_rest_all_samples_stay(change):
    t = np.arange(0, 80, 0.2)
    x, period = held(40.0, t), PERIOD
    if change == "coarse":  # fewer than eight samples a period
        period = 7.9 * 0.2
    if change == "short rest":  # shorter than a period
        t, x = t[t < 44.0], x[t < 44.0]
    if change == "no rest":
        x = np.exp(-0.01 * t) * np.cos(t)
    if change == "still":
        x = 1e-3 * np.random.default_rng(0).standard_normal(len(t))
    if change == "two":
        t, x = t[:1], x[:1]
    assert moving(t, x, period) == slice(None)


def test_a_rest_of_fewer_than_twelve_samples_is_none():
    t = np.arange(0, 80, 0.75)
    x = np.where(t < 80 - 11 * 0.75, np.cos(t), 0.0)
    assert moving(t, x, 6.0) == slice(None)
    longer = np.where(t < 80 - 14 * 0.75, np.cos(t), 0.0)
    assert moving(t, longer, 6.0) != slice(None)


def scattered(rest):
    """One sample in seven of a record with 60 a period: neighbours are up to a period apart; held still after 80."""
    t = np.arange(0, 100 if rest else 80, 0.1)
    random = np.random.default_rng(9)
    t = t[random.random(len(t)) < 0.15]
    x = np.where(t < 80, np.exp(-0.01 * t) * np.cos(t), 0.05)
    return t, x + 2e-3 * random.standard_normal(len(t))


def test_neighbours_across_a_gap_are_no_noise():
    """They differ as much as the tail swings: periods of an amplitude far above the noise were called a rest."""
    t, x = scattered(rest=False)
    assert moving(t, x, 2 * np.pi) == slice(None)
    t, x = scattered(rest=True)
    assert t[moving(t, x, 2 * np.pi)][-1] == pytest.approx(80 - np.pi, abs=2.0)


# Decays of a record.


def table(kind, columns):
    return RecordTable(kind, columns, "mm", RowPlaces("file", np.arange(len(T)) + 2), ())


@pytest.mark.parametrize(
    ("kind", "column", "order"), [("record", "x", 0), ("velocity", "v", 1), ("acceleration", "a", 2)]
)
def test_a_decay_is_read_by_its_kind(monkeypatch, kind, column, order):
    asked = []
    plain = Observations.of([0, 1, 2], [1.0, -0.9, 0.8], T[[0, 10, 20]], notes=("own",))

    def of_motion(t, x, **more):
        asked.append(more)
        assert np.array_equal(t, T[:150]) and np.array_equal(x, motion()[:150])
        return plain

    monkeypatch.setattr(sources, "observations_of_motion", of_motion)
    monkeypatch.setattr(sources, "observations_of_record", lambda t, x, **more: (asked.append(more), plain)[1])
    monkeypatch.setattr(sources, "without_second_modes", lambda t, x: (x, ("a line",)))
    monkeypatch.setattr(sources, "moving", lambda t, x, period: slice(0, 150))
    run = table(kind, {"t": T, column: motion()})
    assert sources._order(run) == order
    found = sources._decay(T, motion(), run, run.rows, ("before",), 1)
    if order:
        assert asked == [{"unit": "mm", "name": "file", "notes": ("before", "a line"), "derivative": order}]
        assert found.notes == ("own", "the last 8.9 periods, after t = 6, are not used")
    else:
        assert found.notes == ("before", "a line", "own", "the last 8.9 periods, after t = 6, are not used")
        assert asked[0]["unit"] == "mm" and asked[0]["rows"].row(149) == 151 and len(asked[0]["rows"].lines) == 150


def test_a_velocity_needs_samples_that_change():
    run = table("velocity", {"t": T, "v": motion()})
    with pytest.raises(InputError, match="file has 13 rows with numbers"):
        sources._decay(T[:13], motion()[:13], run, run.rows, (), 1)
    with pytest.raises(InputError, match="file, column v: all values are 1"):
        sources._decay(T[:14], np.ones(14), run, run.rows, (), 1)


@pytest.mark.parametrize(("end", "said"), [(8.0, []), (8.4, ["the last 1.1 periods, after t = 4, are not used"])])
def test_a_tail_of_more_than_a_period_is_told(end, said):
    """The period is twice the usual half-swing, also across a gap."""
    seen = Observations.of([0, 1, 4, 5], [1.0, -0.9, 0.8, -0.7], [0.0, 2.0, 8.0, 10.0])
    scaled = Observations.of([0, 1, 2], [1.0, -0.9, 0.8], [0.0, 2.0, 4.0])
    assert sources._tail(np.array([0.0, end]), scaled) == said
    assert sources._tail(np.array([0.0, 14.4]), seen) == ["the last 1.1 periods, after t = 10, are not used"]
    object.__setattr__(seen, "samples", Samples(np.array([0.0, 12.0]), np.zeros(2), 1.0, 1.0))
    assert sources._tail(np.array([0.0, 14.1]), seen) == []


def test_clean_decrements_and_observations_are_runs_of_their_own():
    found = sources.load({"amplitude": np.array([1.0, 0.5]), "decrement": np.array([0.2, 0.1])})[0]
    assert found.amplitude.tolist() == [1.0, 0.5] and found.resolution is None
    seen = Observations.of([0, 1], [1.0, -0.5])
    assert sources.load(seen) == [seen] and sources.load(found) == [found]
    assert found.decrement.tolist() == [0.2, 0.1]
