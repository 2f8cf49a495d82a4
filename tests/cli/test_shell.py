"""The three programs and the world around them: signals, closed and full outputs, other encodings, other files."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PROGRAMS = {
    "asymptotics": ["-m", "asymptotics.cli.entry", "smith", "f", "--n", "800"],
    "paper_checks": ["-m", "paper_checks", "lelas2024", "--id", "lelas2024:4"],
    "derivations": ["-m", "derivations"],
}


def shell(line: str, **options: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        ["bash", "-c", f"set -o pipefail; {line}"], capture_output=True, text=True, check=False, cwd=ROOT, **options
    )


def started(name: str, *, wait: float, group: bool = False) -> subprocess.Popen[str]:
    process = subprocess.Popen(
        [sys.executable, *PROGRAMS[name]],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=ROOT, start_new_session=group,
    )  # fmt: skip
    time.sleep(wait)
    return process


@pytest.mark.parametrize("name", PROGRAMS)
def test_lost_output(name):
    command = " ".join([f"'{sys.executable}'", *PROGRAMS[name]])
    head = shell(f"{command} | head -c 1")
    assert (head.returncode, head.stderr) == (0, "")
    closed = shell(f"{command} >&-")
    assert (closed.returncode, closed.stderr) == (0, "")
    full = shell(f"{command} > /dev/full")
    assert full.returncode == 2
    assert full.stderr == f"{name}: cannot write the answer: No space left on device\n"
    silent = shell(f"{command} > /dev/full 2>&-")
    assert (silent.returncode, silent.stderr) == (2, "")


@pytest.mark.parametrize("name", PROGRAMS)
def test_help_and_bad_options_on_a_full_disk(name):
    command = " ".join([f"'{sys.executable}'", *PROGRAMS[name][:2]])
    full = shell(f"{command} --help > /dev/full")
    assert full.returncode == 2
    assert full.stderr.count("\n") == 1
    assert "Traceback" not in shell(f"{command} --no-such-option > /dev/full").stderr


@pytest.mark.parametrize("name", PROGRAMS)
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_while_the_libraries_load_is_one_line(name, number):
    """The shell stands as soon as the interpreter does; -X importtime tells when that is."""
    process = subprocess.Popen(
        [sys.executable, "-X", "importtime", *PROGRAMS[name]],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, cwd=ROOT,
    )  # fmt: skip
    assert process.stderr is not None
    first = "asymptotics.errors" if name == "asymptotics" else "argparse"
    seen = []
    for line in process.stderr:
        seen.append(line)
        if line.split("|")[-1].strip() in (first, "flint", "tqdm"):
            process.send_signal(number)
            break
    rest = [line for line in process.stderr if not line.startswith("import time:")]
    assert process.wait(timeout=30) == 128 + number
    assert rest == [f"{name}: interrupted; no file was left half-written\n"]


@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "utf-8"])
def test_any_encoding_of_the_terminal(encoding):
    environment = {**os.environ, "PYTHONIOENCODING": encoding, "LC_ALL": "C"}
    table = "table smith2012.table1 --digits 5"
    done = shell(f"'{sys.executable}' -m asymptotics.cli.entry {table}", env=environment)
    assert done.returncode == 0, done.stderr
    odd = shell(f"'{sys.executable}' -m asymptotics.cli.entry moment --p 'ü漢\N{PILE OF POO}'", env=environment)
    assert odd.returncode == 2
    assert odd.stderr.count("\n") == 1


def test_messages_are_short_and_free_of_control_characters():
    nasty = "'\x1b[2J\x07\r\n" + "\u202e" + "9" * 5000 + "'"
    command = f"'{sys.executable}' -m asymptotics.cli.entry"
    for line in (
        f"moment --p {nasty}", f"expand --alpha 2 --gauge {nasty}", f"table {nasty}", f"{nasty}",
        f"motion --alpha 2 --damping 1 --x0 1 --time 1 --csv {nasty}", f"moment --p 1 --{nasty}",
        f"turning-points --alpha 2 --epsilon 1 --count {nasty}",
    ):  # fmt: skip
        done = shell(f"{command} {line}")
        assert done.returncode == 2, line[:40]
        assert done.stderr.count("\n") == 1
        assert done.stderr[:-1].isprintable()
        assert len(done.stderr) < 900


def test_a_paper_and_an_id_that_contradict_each_other():
    done = shell(f"'{sys.executable}' -m paper_checks lelas2024 --id smith2012:62b")
    assert done.returncode == 2
    assert done.stderr == (
        "paper_checks: argument --id: smith2012:62b is not a statement of lelas2024"
        " (accepted: an id that begins with lelas2024:)\n"
    )


def _alive(group: int) -> bool:
    found = subprocess.run(["ps", "-eo", "pgid="], capture_output=True, text=True, check=True).stdout.split()
    return str(group) in found


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGKILL])
def test_the_workers_of_the_checks_do_not_outlive_them(number):
    """Ctrl-C in a terminal reaches the whole group; SIGKILL the program alone, whose workers have to notice."""
    process = subprocess.Popen(
        [sys.executable, "-m", "paper_checks", "smith2012"],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, cwd=ROOT, start_new_session=True,
    )  # fmt: skip
    deadline = time.monotonic() + 60
    while time.monotonic() < deadline:  # until the workers are at work
        listed = subprocess.run(["ps", "-eo", "ppid="], capture_output=True, text=True, check=True).stdout.split()
        if listed.count(str(process.pid)) >= 2:
            break
        time.sleep(0.05)
    time.sleep(0.5)
    start = time.monotonic()
    if number == signal.SIGINT:
        os.killpg(process.pid, number)
    else:
        process.send_signal(number)
    code = process.wait(timeout=30)
    assert time.monotonic() - start < 3
    if number == signal.SIGINT:
        assert code == 130
        assert process.stderr is not None
        assert process.stderr.read() == "paper_checks: interrupted; no file was left half-written\n"
    while _alive(process.pid) and time.monotonic() - start < 20:
        time.sleep(0.1)
    assert not _alive(process.pid)
