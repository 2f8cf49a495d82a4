"""Exported sweeps: the same in any order of completion, unfinished ones, and stores that are read only."""

import json
import os

import pytest
import tasks
from tasks import sweep

from asymptotics.errors import InputError
from asymptotics.sweeps.export import export, read_rows
from asymptotics.sweeps.shard import LockedShard


def test_the_exported_file_does_not_depend_on_the_order_of_completion(log, tmp_path):
    points = tasks.grid(log, 30)
    texts = []
    for name, order, workers in (("a", points, 2), ("b", list(reversed(list(points))), 1)):
        sweep(tasks.failing, "square", order, tmp_path / name, workers=workers)
        for suffix in ("csv", "json", "parquet"):
            assert export(tmp_path / f"{name}.{suffix}", "square", points, tmp_path / name) == 30
        texts.append([(tmp_path / f"{name}.{suffix}").read_bytes() for suffix in ("csv", "json", "parquet")])
    assert texts[0] == texts[1]
    rows = list(read_rows(tmp_path / "a.csv"))
    assert rows == list(read_rows(tmp_path / "a.parquet"))
    assert [row["square"] for row in rows[:6]] == [1, 4, 9, 16, None, 36]
    assert rows[4]["failed"].startswith("argument n")
    assert rows[0]["nested.0.nothing"] is None
    assert json.loads(texts[0][1])["rows"][2]["result"]["square"] == "9"


def test_an_export_of_an_unfinished_sweep_says_what_is_missing(log, folder, tmp_path):
    sweep(tasks.square, "square", tasks.grid(log, 3), folder, workers=1)
    export(tmp_path / "a.csv", "square", tasks.grid(log, 4), folder)
    assert [row["failed"] for row in read_rows(tmp_path / "a.csv")] == [None, None, None, "not in the store"]


def test_a_finished_sweep_on_a_read_only_disk_is_read_and_exported(tmp_path, log, folder, monkeypatch):
    points = tasks.grid(log, 12)
    sweep(tasks.square, "square", points, folder, workers=1)
    writable = os.access
    monkeypatch.setattr(os, "access", lambda path, mode: mode != os.W_OK and writable(path, mode))
    monkeypatch.setattr(LockedShard, "take", lambda *_: pytest.fail("a shard is opened for writing"))
    again = sweep(tasks.square, "square", points, folder, workers=1)
    assert (again.points, again.reused, again.computed, again.failed) == (12, 12, 0, 0)
    assert export(tmp_path / "out.json", "square", points, folder) == 12
    with pytest.raises(InputError, match="can only be read, and does not hold every point"):
        sweep(tasks.square, "square", tasks.grid(log, 13), folder, workers=1)
