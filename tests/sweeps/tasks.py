"""Tasks for the tests of sweeps, in a module of their own so that worker processes can import them.

Each task notes in a log what it computes: appending a short line is atomic, so the log tells what was computed twice.
"""

import os
import signal
import sys
import time
from functools import partial
from pathlib import Path

from asymptotics.errors import InputError
from asymptotics.sweeps import Grid, values
from asymptotics.sweeps import sweep as marked

sweep = partial(marked, version="")  # tasks that differ in how they end are filed together


def _note(point):
    handle = os.open(point["log"], os.O_WRONLY | os.O_APPEND | os.O_CREAT)
    os.write(handle, (point["n"] + "\n").encode())
    os.close(handle)


def square(point):
    _note(point)
    return {"square": str(int(point["n"]) ** 2), "nested": [{"n": point["n"], "nothing": None}], "yes": True}


def slow(point):
    time.sleep(0.02)
    return square(point)


def failing(point):
    if int(point["n"]) % 5 == 0:
        raise InputError("n", "it is a multiple of 5", "other numbers")
    return square(point)


def crashing(point):
    if point["n"] == "7":
        raise RuntimeError("an error\nnobody foresaw")
    return square(point)


def killing(point):
    """Point 7 kills its worker."""
    if point["n"] == "7":
        os.kill(os.getpid(), signal.SIGKILL)
    return square(point)


def killing_once(point):
    """Point 7 kills the worker that meets it first."""
    if point["n"] == "7":
        try:
            os.close(os.open(point["log"] + ".killed", os.O_CREAT | os.O_EXCL))
        except FileExistsError:
            return square(point)
        os.kill(os.getpid(), signal.SIGKILL)
    return square(point)


def grid(log, last):
    return Grid({"log": (str(log),), "n": values(f"1:{last}:1", "n")})


def computed(log):
    """The points that were computed, in order, with repetitions."""
    return [int(line) for line in Path(log).read_text().split()] if Path(log).exists() else []


if __name__ == "__main__":  # a driver of its own: log, store, last point, workers
    log, folder, last, workers = sys.argv[1:]
    print(sweep(slow, "square", grid(log, last), Path(folder), workers=int(workers)).computed)
