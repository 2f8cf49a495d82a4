"""A record becomes runs: which release is which, what is told of each, and which row a refusal names."""

import numpy as np
import pytest

from asymptotics.decays.identification import sources
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.decays.identification.sources import MAX_SWINGS, _decays, _require_few, load, require_increasing
from asymptotics.decays.records.rows import RowPlaces
from asymptotics.decays.records.table import RecordTable
from asymptotics.errors import InputError, LimitError

T = np.linspace(0.0, 10.0, 101)


def decays(monkeypatch, parts, *, short=(), wild=()):
    """The releases of a record, of which some are too short; what was asked of each."""
    asked = []

    def decay(t, x, run, rows, notes, modes):
        del x, run
        assert modes == 2
        asked.append((len(t), rows, notes))
        if len(asked) in short:
            raise InputError("FILE", f"{len(t)} samples", "more")
        return len(asked)

    spikes = np.zeros(len(T), dtype=bool)
    spikes[list(wild)] = True
    monkeypatch.setattr(sources, "spikes", lambda _: spikes)
    monkeypatch.setattr(sources, "sensor_notes", lambda *_: ("of the sensor",))
    monkeypatch.setattr(sources, "releases", lambda *_: [np.arange(*p) for p in parts])
    monkeypatch.setattr(sources, "_decay", decay)
    columns = {"t": T, "x": np.cos(T)}
    run = RecordTable("record", columns, "m", RowPlaces("file", np.arange(101) + 2), ("read",))
    return _decays(run, 2), asked


def test_one_decay_of_a_whole_record_is_the_record(monkeypatch):
    found, [(count, rows, notes)] = decays(monkeypatch, [(0, 101)])
    assert found == [1] and count == 101 and rows.name == "file" and notes == ("read", "of the sensor")


def test_one_decay_of_a_part_says_which(monkeypatch):
    _, [(count, rows, notes)] = decays(monkeypatch, [(20, 61)])
    assert count == 41 and rows.name == "file" and rows.row(0) == 22
    assert notes[2:] == ("free decay from t = 2 to 6: the rest is held or touched",)


def test_releases_are_numbered_from_one_with_their_own_rows(monkeypatch):
    found, asked = decays(monkeypatch, [(0, 41), (50, 101)])
    assert found == [1, 2]
    for number, (first, last), (count, rows, notes) in zip((1, 2), ((0, 4), (5, 10)), asked, strict=True):
        assert rows.name == f"file (release {number})" and rows.row(0) == 2 + 10 * first and count == len(rows.lines)
        assert notes[-1].startswith(f"released again: run {number} of 2, free decay from t = {first} to {last};")
        assert len([n for n in notes if n.startswith("released again")]) == 1


def test_a_release_that_is_too_short_is_left_out_and_told_of_the_others(monkeypatch):
    found, asked = decays(monkeypatch, [(0, 20), (30, 60), (70, 101)], short=[1])
    assert found == [2, 3] and all("release 1 of 3 left out: 20 samples" in notes for *_, notes in asked[1:])
    with pytest.raises(InputError, match="release 1 of 2 left out: 20 samples; release 2 of 2 left out: 31 samples"):
        decays(monkeypatch, [(0, 20), (70, 101)], short=[1, 2])
    with pytest.raises(InputError, match="^argument FILE: 20 samples"):
        decays(monkeypatch, [(0, 20)], short=[1])


def test_spikes_are_gone_before_anything_else_is_asked_and_the_first_is_named(monkeypatch):
    _, [(count, rows, notes)] = decays(monkeypatch, [(0, 98)], wild=[7, 8, 30])
    assert count == 98 and [rows.row(k) for k in (6, 7, 27, 28)] == [8, 11, 31, 33]
    assert notes[1].startswith("3 samples far from their neighbours left out, the first is") and "row 9" in notes[1]


def test_a_clock_that_starts_again_begins_a_run(monkeypatch):
    t = np.concatenate([T, T])
    seen = []
    monkeypatch.setattr(sources, "_decays", lambda run, modes: seen.append(run) or [run])
    table = RecordTable("record", {"t": t, "x": np.cos(t)}, "m", RowPlaces("file", np.arange(202) + 2))
    runs = sources._motions(table, 1)
    assert [r.rows.name for r in runs] == ["file (run 1)", "file (run 2)"]
    assert [r.notes[-1] for r in runs] == [
        f"the clock starts again: run {k} of 2, from row {row}" for k, row in ((1, 2), (2, 103))
    ]
    assert [len(r.columns["t"]) for r in runs] == [101, 101]


def test_a_value_that_does_not_increase_is_named_by_its_row():
    rows = RowPlaces("file", np.array([2, 3, 5]))
    require_increasing(np.array([0.0, 1.0, 2.0]), "n", rows)
    for values in ([0.0, 1.0, 1.0], [0.0, 1.0, 0.5]):
        with pytest.raises(InputError, match=f"row 5.*: {values[2]:g} after 1"):
            require_increasing(np.array(values), "n", rows)


def test_more_half_swings_than_the_memory_has_room_for_are_refused():
    _require_few(MAX_SWINGS, "n")
    with pytest.raises(LimitError, match=r"1e\+06 half-swings.*0.5 GB"):
        _require_few(MAX_SWINGS + 1, "n")
    with pytest.raises(LimitError):
        load(Observations.of([0, MAX_SWINGS + 1], [1.0, -0.5]))


def points(x, n=None):
    return load({"n": np.arange(len(x)) if n is None else n, "x": np.array(x)}, "turning-points")[0]


def test_signs_may_be_lost_by_a_third_of_the_points():
    x = 0.9 ** np.arange(9) * (-1.0) ** np.arange(9)
    for wrong in ([7], [5, 7]):
        assert len(points(np.where(np.isin(np.arange(9), wrong), -x, x)).x) == 9
    with pytest.raises(InputError, match="signs do not alternate"):
        points(np.where(np.isin(np.arange(9), [5, 6, 7, 8]), -x, x))
    few = (0.9 ** np.arange(4) * (-1.0) ** np.arange(4)) * [1, 1, -1, -1]  # of few points two
    assert len(points(few).x) == 4


@pytest.mark.parametrize(("wrong", "left"), [([8], 8), ([6, 7, 8], 6), ([5, 8], 8)])
def test_points_at_the_end_on_the_wrong_side_are_those_of_a_rest(wrong, left):
    """Else a law is bent until its amplitude vanishes there: 1.7e-109 was told, and a Q of 1e-5."""
    x = 0.9 ** np.arange(9) * (-1.0) ** np.arange(9)
    found = points(np.where(np.isin(np.arange(9), wrong), -x, x))
    assert len(found.x) == left and f"what follows turning point {left - 1} is on the same side" in found.notes[-1]


@pytest.mark.parametrize(
    ("x", "reason"),
    [([1.0], "1 turning point "), ([1.0, -1.0, 1.0, -1.0], "all values are 1"), ([0.0, -1, 1, -1], "is 0")],
)
def test_turning_points_that_tell_nothing_are_refused(x, reason):
    with pytest.raises(InputError, match=reason):
        points(x)


@pytest.mark.parametrize(
    ("rows", "reason"),
    [
        ([(1.0, 0.1, 0.01)], "1 row"),
        ([(1.0, 0.1, 0.01), (0.0, 0.1, 0.01)], "0 is not positive"),
        ([(1.0, 2.0, 0.01), (0.9, 0.1, 0.01)], "2 too large"),
        ([(1.0, 0.1, -0.01), (0.9, 0.1, 0.01)], "-0.01 is negative"),
        ([(1.0, 0.1, 1.9), (0.9, 0.1, 0.01)], "1.9 leaves no limit"),
        ([(1.0, -0.5, 1.5), (0.9, 0.1, 0.01)], "1.5 leaves no limit"),
    ],
)
def test_decrements_that_cannot_be_are_refused(rows, reason):
    columns = dict(zip(("amplitude", "decrement", "resolution"), np.array(rows).T))
    with pytest.raises(InputError, match=reason):
        load(columns)
    assert len(load({k: np.array([v, v]) for k, v in (("amplitude", 1.0), ("decrement", 0.1))})[0].amplitude) == 2


def test_turning_points_keep_their_name_their_unit_their_times_and_what_was_told():
    table = RecordTable(
        "turning-points", {"n": np.arange(5.0), "x": (-0.9) ** np.arange(5.0), "tau": np.arange(5.0) * 2},
        "mm", RowPlaces("file", np.arange(5) + 2), ("read",),
    )  # fmt: skip
    seen = sources._turning_points(table)
    assert (seen.name, seen.unit) == ("file", "mm") and "read" in seen.notes and seen.t.tolist() == [0, 2, 4, 6, 8]
    assert seen.n.tolist() == [0, 1, 2, 3, 4] and seen.x[1] == -0.9
