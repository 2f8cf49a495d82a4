"""Sweeps that are killed, crowded and starved of disk: nothing is done twice, nothing finished is lost."""

import os
import resource
import shutil
import signal
import subprocess
import sys
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import nullcontext
from multiprocessing import get_context
from pathlib import Path

import pytest
import tasks
from tasks import sweep

from asymptotics.errors import InputError, LimitError
from asymptotics.sweeps.export import records
from asymptotics.sweeps.store import Store
from asymptotics.sweeps.workers import Crew, SerialExecutor

LAST = 60


def stored(folder, points):
    """What the store says of each point: its n, its square; a failed or missing point is left out."""
    found = {}
    for point, record in records("square", points, Store(folder)):
        if record is not None and "result" in record:
            assert record["task"]["point"] == point
            found[int(point["n"])] = int(record["result"]["square"])
    return found


def all_right(folder, points):
    found = stored(folder, points)
    assert found == {n: n * n for n in range(1, len(points) + 1)}


def driver(log, folder, last=LAST, workers=2, **more):
    script = str(Path(tasks.__file__))
    return subprocess.Popen([sys.executable, script, str(log), str(folder), str(last), str(workers)],
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **more)  # fmt: skip


def wait_until(condition, seconds=30.0):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.02)


def test_a_pool_computes_each_point_once_and_a_rerun_none(log, folder):
    points = tasks.grid(log, LAST)
    first = sweep(tasks.square, "square", points, folder, workers=2)
    assert (first.points, first.reused, first.computed, first.failed) == (LAST, 0, LAST, 0)
    second = sweep(tasks.square, "square", points, folder, workers=2)
    assert (second.points, second.reused, second.computed) == (LAST, LAST, 0)
    larger = sweep(tasks.square, "square", tasks.grid(log, LAST + 5), folder, workers=1)
    assert (larger.reused, larger.computed) == (LAST, 5)
    assert sorted(tasks.computed(log)) == list(range(1, LAST + 6))
    all_right(folder, tasks.grid(log, LAST + 5))


@pytest.mark.parametrize("pool", [ThreadPoolExecutor, ProcessPoolExecutor])
def test_any_executor_serves_and_stays_open(log, folder, pool):
    context = {} if pool is ThreadPoolExecutor else {"mp_context": get_context("spawn")}
    with pool(2, **context) as executor:
        assert sweep(tasks.square, "square", tasks.grid(log, 8), folder, executor=executor).computed == 8
        assert executor.submit(int, "3").result() == 3
    all_right(folder, tasks.grid(log, 8))


def test_a_failed_point_is_reported_and_ends_nothing(log, folder):
    points = tasks.grid(log, 20)
    result = sweep(tasks.failing, "square", points, folder, workers=1)
    assert (result.computed, result.failed) == (20, 4)
    assert [f["point"]["n"] for f in result.failures] == ["5", "10", "15", "20"]
    assert result.failures[0]["reason"] == "argument n: it is a multiple of 5 (accepted: other numbers)"
    again = sweep(tasks.failing, "square", points, folder, workers=1)
    assert (again.reused, again.failed, again.failures) == (20, 4, result.failures)


def test_an_error_nobody_foresaw_is_the_record_of_its_point(log, folder):
    result = sweep(tasks.crashing, "square", tasks.grid(log, 9), folder, workers=1)
    assert (result.computed, result.failed) == (9, 1)
    assert result.failures[0]["reason"] == "RuntimeError: an error nobody foresaw"


def test_a_time_that_was_over_is_tried_again_and_a_limit_is_kept(folder):
    left = ["max_seconds", "digits"]

    def task(point):
        if point["n"] in left:
            raise LimitError(point["n"], "60 s are over", "a larger limit")
        return {"right": True}

    points = [{"n": name} for name in left]
    assert sweep(task, "task", points, folder, workers=1).failed == 2
    left.clear()
    again = sweep(task, "task", points, folder, workers=1)
    assert (again.computed, again.reused, again.failed) == (1, 1, 1)


def test_a_worker_killed_once_costs_nothing(log, folder):
    points = tasks.grid(log, LAST)
    result = sweep(tasks.killing_once, "square", points, folder, workers=2)
    assert (result.computed, result.failed) == (LAST, 0)
    all_right(folder, points)


def test_a_point_that_kills_every_worker_is_given_up_alone(log, folder):
    result = sweep(tasks.killing, "square", tasks.grid(log, 12), folder, workers=2)
    assert (result.points, result.failed) == (12, 1)
    assert result.failures[0]["point"]["n"] == "7"
    assert "the worker died" in result.failures[0]["reason"]
    assert len(stored(folder, tasks.grid(log, 12))) == 11
    # it is not on record: another day it may succeed
    assert sweep(tasks.square, "square", tasks.grid(log, 12), folder, workers=1).computed == 1


class _Refusing(SerialExecutor):
    """Some calls are refused by the system, as by a pool of which a worker dies while the next one is started."""

    def __init__(self, refused):
        self.refused = set(refused)
        self.calls = 0

    def submit(self, *call):
        self.calls += 1
        if self.calls in self.refused:
            raise OSError("handle is closed")
        return super().submit(*call)


def test_a_worker_that_could_not_be_started_costs_nothing(log, folder):
    executor = _Refusing({1, 3, 9})
    result = sweep(tasks.square, "square", tasks.grid(log, 12), folder, crew=lambda: nullcontext(Crew(executor, 2)))
    assert (result.computed, result.failed) == (12, 0)
    assert executor.calls > 9
    assert sorted(tasks.computed(log)) == list(range(1, 13))
    all_right(folder, tasks.grid(log, 12))


def test_an_executor_that_refuses_every_batch_ends_the_sweep(log, folder):
    with pytest.raises(OSError, match="handle is closed"):
        sweep(tasks.square, "square", tasks.grid(log, 12), folder, executor=_Refusing(range(1, 99, 2)))
    assert not log.exists()


def test_a_driver_killed_on_the_way_loses_nothing_finished(log, folder):
    points = tasks.grid(log, LAST)
    process = driver(log, folder, workers=2)
    wait_until(lambda: len(tasks.computed(log)) > 12)
    process.kill()
    process.communicate()
    finished = stored(folder, points)
    assert finished
    assert all(finished[n] == n * n for n in finished)
    wait_until(lambda: _settled(log))  # orphaned workers end with their driver
    before = tasks.computed(log)
    result = sweep(tasks.square, "square", points, folder, workers=1)
    assert result.reused == len(finished)
    assert result.computed == LAST - len(finished)
    assert not set(tasks.computed(log)[len(before) :]) & set(finished)  # nothing finished is computed twice
    all_right(folder, points)


def _settled(log):
    size = log.stat().st_size
    time.sleep(0.2)
    return log.stat().st_size == size


def test_ctrl_c_keeps_what_is_finished(log, folder):
    process = driver(log, folder, workers=1)
    wait_until(lambda: len(tasks.computed(log)) > 5)
    process.send_signal(signal.SIGINT)
    process.communicate()
    assert process.returncode != 0
    finished = stored(folder, tasks.grid(log, LAST))
    assert len(finished) >= len(set(tasks.computed(log))) - 13  # at most the batch under way is lost
    assert sweep(tasks.square, "square", tasks.grid(log, LAST), folder, workers=1).reused == len(finished)


def test_two_drivers_on_one_store_share_the_work(log, folder):
    sweep(tasks.square, "square", tasks.grid(log, 1), folder, workers=1)
    both = [driver(log, folder, workers=1) for _ in range(2)]
    outputs = [process.communicate() for process in both]
    assert [process.returncode for process in both] == [0, 0], outputs
    shares = [int(out) for out, _ in outputs]
    assert sum(shares) == LAST - 1
    assert sorted(tasks.computed(log)) == list(range(1, LAST + 1))
    all_right(folder, tasks.grid(log, LAST))


def _small_files():
    resource.setrlimit(resource.RLIMIT_FSIZE, (1500, 1500))


def test_a_full_disk_loses_nothing_finished(log, folder):
    """Files may not grow beyond 1500 bytes: what a full disk does to a shard."""
    log.write_bytes(b"")
    points = tasks.grid(log, 200)
    process = driver(log, folder, last=200, workers=1, preexec_fn=_small_files)
    _, errors = process.communicate()
    assert process.returncode != 0
    assert "InputError: argument folder: cannot write to" in errors
    assert "the same command continues" in errors
    finished = stored(folder, points)
    assert finished
    assert sweep(tasks.square, "square", points, folder, workers=1).reused == len(finished)
    all_right(folder, points)


@pytest.mark.skipif(os.geteuid() != 0, reason="mounting a small file system needs root")
def test_a_small_file_system_fills_up(tmp_path, log):
    disk = tmp_path / "disk"
    disk.mkdir()
    mount = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", str(disk)], capture_output=True)
    if mount.returncode:
        pytest.skip("this machine does not let a test mount a file system; RLIMIT_FSIZE is tested instead")
    try:
        points = tasks.grid(log, 400)
        with pytest.raises(InputError, match="No space left on device"):
            sweep(tasks.square, "square", points, disk / "store", workers=1)
        finished = stored(disk / "store", points)
        assert 50 < len(finished) < 400
        assert all(value == n * n for n, value in finished.items())
        shutil.copytree(disk / "store", tmp_path / "larger")
        result = sweep(tasks.square, "square", points, tmp_path / "larger", workers=1)
        assert result.reused == len(finished)
        all_right(tmp_path / "larger", points)
    finally:
        subprocess.run(["umount", str(disk)], check=True)
