"""The programs and the world around them: signals, closed and full outputs, other encodings, other files."""

import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from asymptotics.shell.main import main
from paper_checks.__main__ import main as check

ROOT = Path(__file__).parents[2]
PROGRAMS = {
    "asymptotics": ["-m", "asymptotics.shell.entry", "smith", "f", "--n", "400"],
    "paper_checks": ["-m", "paper_checks", "lelas2024", "--id", "lelas2024:4"],
    "derivations": ["-m", "derivations"],
}
WRITERS = {
    **PROGRAMS,
    "tables": ["-m", "asymptotics.shell.standard_tables", "build/tables"],
    "benchmarks": ["-m", "benchmarks", "smith-rows", "--no-peers"],
}
ANSWERING = {**PROGRAMS, "benchmarks": ["-m", "benchmarks", "smith-rows", "--no-peers", "--size", "8"]}


def shell(line: str, **options: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        ["bash", "-c", f"set -o pipefail; {line}"],
        capture_output=True, text=True, errors="replace", check=False, cwd=ROOT, **options,
    )  # fmt: skip


def without_progress(told):
    """What the benchmarks say on the way: how long each part took."""
    return re.sub(r"^smith-rows: \d+ s\n", "", told)


def first(programs):
    """The command in `make test`, all programs in `make test-thorough`: one shell stands around each."""
    return [name if name == "asymptotics" else pytest.param(name, marks=pytest.mark.slow) for name in programs]


@pytest.mark.parametrize("name", first(ANSWERING))
def test_lost_output(name):
    command = " ".join([f"'{sys.executable}'", *ANSWERING[name]])
    head = shell(f"{command} | head -c 1")
    assert (head.returncode, without_progress(head.stderr)) == (0, "")
    closed = shell(f"{command} >&-")
    assert (closed.returncode, without_progress(closed.stderr)) == (0, "")
    full = shell(f"{command} > /dev/full")
    assert full.returncode == 2
    assert without_progress(full.stderr) == f"{name}: cannot write the answer: No space left on device\n"
    silent = shell(f"{command} > /dev/full 2>&-")
    assert (silent.returncode, silent.stderr) == (2, "")


@pytest.mark.parametrize("name", first(WRITERS))
def test_help_and_bad_options_on_a_full_disk(name):
    command = " ".join([f"'{sys.executable}'", *WRITERS[name][:2]])
    full = shell(f"{command} --help > /dev/full")
    assert full.returncode == 2
    assert full.stderr.count("\n") == 1
    assert "Traceback" not in shell(f"{command} --no-such-option > /dev/full").stderr


IN_THE_COLLECTOR = """
import gc, os, signal, sys, time
from asymptotics.shell.guarded import run_guarded

def slow(phase, _info):
    if phase == "start":
        os.kill(os.getpid(), signal.SIGINT)
        for _ in range(1000):
            pass

def body():
    gc.callbacks.append(slow)
    gc.collect()
    gc.callbacks.remove(slow)
    time.sleep(10)
    return 0

sys.exit(run_guarded("program", body))
"""


def test_a_signal_while_the_collector_runs_is_not_lost():
    """What is raised inside a call of the collector is swallowed, and printed."""
    found = subprocess.run(
        [sys.executable, "-c", IN_THE_COLLECTOR], cwd=ROOT, capture_output=True, text=True, timeout=60
    )
    assert (found.returncode, found.stdout) == (130, "")
    assert found.stderr == "program: interrupted; no file was left half-written\n"


@pytest.mark.parametrize("name", first(WRITERS))
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_while_the_libraries_load_is_one_line(name, number):
    """The shell stands as soon as the interpreter does; -X importtime tells when that is."""
    with subprocess.Popen(
        [sys.executable, "-X", "importtime", *WRITERS[name]],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, cwd=ROOT,
    ) as process:  # fmt: skip
        assert process.stderr is not None
        for line in process.stderr:
            if line.split("|")[-1].strip() in ("fractions", "flint", "argparse"):
                process.send_signal(number)
                break
        rest = [line for line in process.stderr if not line.startswith("import time:")]
        code = process.wait(timeout=30)
    assert rest == [f"{name}: interrupted; no file was left half-written\n"]
    assert code == 128 + number


AT_THE_END = """
import atexit, os, sys

class Late:
    kill, pid = os.kill, os.getpid()

    def __del__(self):
        self.kill(self.pid, {number})

sys.late = Late()  # goes when the interpreter has given the signals back
atexit.register(os.kill, os.getpid(), {number})
"""


@pytest.mark.parametrize("name", first(ANSWERING))
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_after_the_answer_changes_nothing(name, number, tmp_path):
    (tmp_path / "sitecustomize.py").write_text(AT_THE_END.format(number=int(number)))
    words = ["-m", "asymptotics.shell.entry", "smith", "f", "--n", "3"] if name == "asymptotics" else ANSWERING[name]
    done = subprocess.run(
        [sys.executable, *words], capture_output=True, text=True, check=False, cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(tmp_path)},
    )  # fmt: skip
    assert (done.returncode, without_progress(done.stderr)) == (0, "") and done.stdout


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_inside_exec_keeps_its_exit_code(tmp_path, number):
    """An exact KeyboardInterrupt through ``exec`` ends ``python -m`` by SIGINT, whatever the program returns."""
    inside = f"import os; os.kill(os.getpid(), {int(number)})\nwhile True: pass"
    (tmp_path / "program.py").write_text(
        "import sys\n"
        "from asymptotics.shell.guarded import run_guarded\n"
        f"sys.exit(run_guarded('program', lambda: exec({inside!r})))\n"
    )
    done = subprocess.run(
        [sys.executable, "-m", "program"],
        capture_output=True, text=True, check=False, cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (128 + number, "program: interrupted; no file was left half-written\n")


@pytest.mark.parametrize(
    "encoding", ["ascii", *(pytest.param(e, marks=pytest.mark.slow) for e in ("latin-1", "utf-8"))]
)
def test_any_encoding_of_the_terminal(encoding):
    environment = {**os.environ, "PYTHONIOENCODING": encoding, "LC_ALL": "C"}
    table = "smith f --n 5"
    done = shell(f"'{sys.executable}' -m asymptotics.shell.entry {table}", env=environment)
    assert done.returncode == 0, done.stderr
    odd = shell(f"'{sys.executable}' -m asymptotics.shell.entry moment --p 'ü漢\N{PILE OF POO}'", env=environment)
    assert odd.returncode == 2
    assert odd.stderr.count("\n") == 1


def test_messages_are_short_and_free_of_control_characters(capsys):
    nasty = "\x1b[2J\x07\r\n" + "\u202e" + "9" * 5000
    for line in (
        "moment --p {}", "expand --alpha 2 --gauge {}", "table {}", "{}", "moment --p 1 --{}",
        "motion --alpha 2 --damping 1 --x0 1 --time 1 --csv {}", "turning-points --alpha 2 --epsilon 1 --count {}",
    ):  # fmt: skip
        assert main([word.format(nasty) for word in line.split()]) == 2, line
        out, err = capsys.readouterr()
        assert out == ""
        assert err.endswith("\n")
        assert err[:-1].isprintable()
        assert len(err) < 900


def test_a_paper_and_an_id_that_contradict_each_other(capsys):
    assert check(["lelas2024", "--id", "smith2012:62b"]) == 2
    assert capsys.readouterr().err == (
        "paper_checks: argument --id: smith2012:62b is not a statement of lelas2024"
        " (accepted: an id that begins with lelas2024:)\n"
    )


def _parents() -> list[str]:
    return subprocess.run(["ps", "-eo", "ppid="], capture_output=True, text=True, check=True).stdout.split()


def _alive(group: int) -> bool:
    found = subprocess.run(["ps", "-eo", "pgid="], capture_output=True, text=True, check=True).stdout.split()
    return str(group) in found


POOL = """
import time
from paper_checks.runner import worker_pool
with worker_pool() as pool:
    for at_work in [pool.submit(time.sleep, 30) for _ in range(4)]:
        at_work.result()
"""
WHOLE = ["-m", "paper_checks", "smith2012"]


@pytest.mark.parametrize(
    ("words", "number"),
    [
        (["-c", POOL], signal.SIGKILL),
        pytest.param(WHOLE, signal.SIGKILL, marks=pytest.mark.slow),
        pytest.param(WHOLE, signal.SIGINT, marks=pytest.mark.slow),
    ],
    ids=["pool killed", "checks killed", "checks interrupted"],
)
def test_the_workers_of_the_checks_do_not_outlive_them(words, number):
    """Ctrl-C in a terminal reaches the whole group; SIGKILL the program alone, whose workers have to notice."""
    with subprocess.Popen(
        [sys.executable, *words],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, cwd=ROOT, start_new_session=True,
    ) as process:  # fmt: skip
        assert process.stderr is not None
        while _parents().count(str(process.pid)) < 2:  # until the workers are at work
            assert process.poll() is None
            time.sleep(0.05)
        time.sleep(0.5)
        start = time.monotonic()
        (os.killpg if number == signal.SIGINT else os.kill)(process.pid, number)
        code = process.wait(timeout=30)
        seconds = time.monotonic() - start
        while _alive(process.pid) and time.monotonic() - start < 20:
            time.sleep(0.1)
        if outlived := _alive(process.pid):  # they would keep the pipe open, and this test waiting
            os.killpg(process.pid, signal.SIGKILL)
        said = process.stderr.read()
    assert not outlived
    assert seconds < 5
    if number == signal.SIGINT:
        assert said == "paper_checks: interrupted; no file was left half-written\n"
        assert code == 130


@pytest.mark.slow
@pytest.mark.parametrize("delay", [0.1, 0.3, 0.6, 0.9, 1.2, 1.5, 2.0, 2.5])
def test_a_signal_at_any_moment_leaves_the_old_files_or_the_new_ones(tmp_path, delay):
    for name in ("a.csv", "a.svg"):
        (tmp_path / name).write_text("old")
    line = "motion --alpha 3/2 --damping 1/10 --x0 1 --time 20 --csv a.csv --plot a.svg"
    with subprocess.Popen(
        [sys.executable, "-m", "asymptotics.shell.entry", *line.split()],
        cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    ) as process:  # fmt: skip
        time.sleep(delay)
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=60)
    assert process.returncode in (0, 130, -signal.SIGINT)  # the last: before the interpreter itself stood
    if process.returncode == 130:
        assert said == "asymptotics: interrupted; no file was left half-written\n"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.csv", "a.svg"]
    old = [(tmp_path / name).read_text() == "old" for name in ("a.csv", "a.svg")]
    assert old in ([True, True], [False, False])
