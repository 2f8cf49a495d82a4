"""Little address space: an answer or one line and exit code 2, in time; a signal ends it."""

import os
import resource
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from asymptotics.running.memory import NO_MEMORY

ROOT = Path(__file__).parents[2]
PROGRAM = [sys.executable, "-m", "asymptotics.shell.entry"]
LINES = ["motion --alpha 2 --epsilon 1/10 --time 3", "identify {data} --laws 1 --no-bootstrap", "smith c --n 5 --i 2"]


def limited(megabytes):
    size = megabytes << 20
    return lambda: resource.setrlimit(resource.RLIMIT_AS, (size, size))


def asked(line, megabytes, tmp_path):
    data = tmp_path / "data.csv"
    data.write_text("n,x\n" + "".join(f"{n},{(-0.9) ** n}\n" for n in range(12)))
    return subprocess.run([*PROGRAM, *line.format(data=data).split()], cwd=ROOT, preexec_fn=limited(megabytes),
                          capture_output=True, text=True, check=False, timeout=120)  # fmt: skip


@pytest.mark.parametrize("megabytes", [250, *(pytest.param(size, marks=pytest.mark.slow) for size in (300, 400))])
@pytest.mark.parametrize("line", LINES)
def test_an_answer_or_one_line(line, megabytes, tmp_path):
    done = asked(line, megabytes, tmp_path)
    if done.returncode:
        assert (done.returncode, done.stdout, done.stderr) == (2, "", f"asymptotics: {NO_MEMORY}\n")
    else:
        assert done.stdout and not done.stderr


def test_errors_and_enough_memory_are_as_ever(tmp_path):
    bad = asked("moment --p x", 2000, tmp_path)
    assert bad.returncode == 2 and "argument --p: " in bad.stderr and bad.stderr.count("\n") == 1
    assert asked("moment --p 2", 2000, tmp_path).stdout.startswith("M_2 = 0.5")


@pytest.mark.slow
def test_a_request_that_outgrows_its_memory_is_one_line(tmp_path):
    done = asked("turning-points --alpha 2 --epsilon 1 --count 100000 --digits 1000 --max-seconds 100", 300, tmp_path)
    assert done.returncode == 2 and done.stderr.count("\n") == 1


@pytest.mark.parametrize("number", [signal.SIGTERM, pytest.param(signal.SIGINT, marks=pytest.mark.slow)])
def test_a_signal_ends_it(number):
    line = "turning-points --alpha 3/2 --epsilon 1 --count 50000 --digits 200 --max-seconds 600"
    with subprocess.Popen([*PROGRAM, *line.split()], cwd=ROOT, preexec_fn=limited(400), stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, env={**os.environ}) as process:  # fmt: skip
        time.sleep(4)
        process.send_signal(number)
        start = time.monotonic()
        out, err = process.communicate(timeout=60)
    assert time.monotonic() - start < 10
    assert (process.returncode, out) == (128 + number, "")
    assert err == "asymptotics: interrupted; no file was left half-written\n"
