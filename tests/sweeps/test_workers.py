"""Sweeps on a Dask scheduler and workers on loopback, started here; a worker is killed on the way."""

import os
import re
import subprocess
import sys
import time
from contextlib import contextmanager
from functools import partial
from importlib.util import find_spec
from pathlib import Path

import pytest
import tasks
from tasks import sweep

from asymptotics.errors import InputError
from asymptotics.shell.main import main
from asymptotics.sweeps import workers
from asymptotics.sweeps.export import records
from asymptotics.sweeps.store import Store
from asymptotics.sweeps.workers import dask_executor

pytestmark = pytest.mark.skipif(find_spec("distributed") is None, reason="the extra cluster is not installed")
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(Path(__file__).parent), "DASK_DISTRIBUTED__ADMIN__LOG_LENGTH": "0"}


@contextmanager
def scheduler():
    """The address of a scheduler of our own on loopback."""
    command = [sys.executable, "-m", "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0",
               "--no-dashboard"]  # fmt: skip
    process = subprocess.Popen(command, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True, env=ENVIRONMENT)
    try:
        for line in process.stderr:
            found = re.search(r"Scheduler at:\s+(tcp://\S+)", line)
            if found:
                yield found[1]
                break
        else:
            pytest.fail("the scheduler did not start")
    finally:
        process.kill()
        process.communicate()


def worker(address):
    command = [sys.executable, "-m", "distributed.cli.dask_worker", address, "--host", "127.0.0.1", "--nthreads", "1",
               "--nworkers", "1", "--no-nanny", "--no-dashboard"]  # fmt: skip
    return subprocess.Popen(command, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL, env=ENVIRONMENT)


@pytest.fixture
def cluster():
    with scheduler() as address:
        workers = [worker(address) for _ in range(2)]
        try:
            yield address, workers
        finally:
            for process in workers:
                process.kill()
                process.wait()


def all_right(log, folder, last):
    found = [record["result"]["square"] for _, record in records("square", tasks.grid(log, last), Store(folder))]
    assert found == [str(n * n) for n in range(1, last + 1)]


def test_a_worker_of_the_cluster_is_killed_on_the_way(cluster, tmp_path):
    address, workers = cluster
    log, folder, last = tmp_path / "log", tmp_path / "store", 150
    killed = []

    def kill_one(done, total):
        if done > 20 and not killed:
            workers[0].kill()
            killed.append(done)

    result = sweep(tasks.slow, "square", tasks.grid(log, last), folder,
                   crew=partial(dask_executor, address, None), progress=kill_one)  # fmt: skip
    assert killed
    assert killed[0] < last
    assert (result.computed, result.failed) == (last, 0)
    all_right(log, folder, last)
    again = sweep(tasks.slow, "square", tasks.grid(log, last), folder, workers=1)
    assert (again.reused, again.computed) == (last, 0)


def test_nothing_answers(tmp_path, monkeypatch):
    monkeypatch.setattr(workers, "_ANSWER", 0.5)
    with pytest.raises(InputError, match="argument dask"):
        sweep(tasks.square, "square", tasks.grid(tmp_path / "log", 3), tmp_path / "s",
              crew=partial(dask_executor, "tcp://127.0.0.1:1", None))  # fmt: skip
    assert not (tmp_path / "s").exists()  # nothing half-made is left


@pytest.mark.slow
def test_a_scheduler_without_workers_is_told(tmp_path, monkeypatch):
    assert workers._PATIENCE <= 30
    monkeypatch.setattr(workers, "_PATIENCE", 0.5)
    with scheduler() as address, pytest.raises(InputError, match="no worker has joined .* in 0.5 s"):
        sweep(tasks.square, "square", tasks.grid(tmp_path / "log", 3), tmp_path / "s",
              crew=partial(dask_executor, address, None))  # fmt: skip


@pytest.mark.slow
def test_a_local_cluster_from_the_command_line(tmp_path, capsys):
    command = ["sweep", "moment", "--p", "0:3:1/4", "--digits", "20", "--dask", "local", "--workers", "2"]
    assert main([*command, "--store", str(tmp_path / "a"), "--json"]) == 0
    assert '"computed": 13' in capsys.readouterr().out


@pytest.mark.slow
def test_two_workers_are_faster_than_one(tmp_path):
    """Points that wait, so that the measurement is of the machinery and not of a crowded machine."""
    seconds = []
    with scheduler() as address:
        processes = []
        try:
            for count in (1, 2):
                processes.append(worker(address))
                time.sleep(4)
                log, folder = tmp_path / f"log{count}", tmp_path / f"store{count}"
                crew = partial(dask_executor, address, None)
                seconds.append(float(sweep(tasks.slow, "square", tasks.grid(log, 400), folder, crew=crew).seconds))
        finally:
            for process in processes:
                process.kill()
                process.wait()
    assert seconds[1] < 0.75 * seconds[0]
