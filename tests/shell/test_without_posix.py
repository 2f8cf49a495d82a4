"""A system without fcntl, resource, fork and alarms, as Windows is: every command answers, or says what it lacks."""

import subprocess
import sys
from pathlib import Path

import pytest

from asymptotics.ask.registry import QUESTIONS
from tests.every_question import example

ROOT = Path(__file__).parents[2]
HIDING = """
import os, signal, sys

class Hidden:
    def find_spec(self, name, path=None, target=None):
        if name in ("fcntl", "resource", "pwd", "termios"):
            raise ModuleNotFoundError("no module named " + name, name=name)

for name in ("fcntl", "resource", "pwd", "termios"):
    sys.modules.pop(name, None)
sys.meta_path.insert(0, Hidden())
for name in ("SIGALRM", "setitimer", "SIGPIPE", "ITIMER_REAL", "SIGXCPU", "SIGKILL", "sigtimedwait"):
    delattr(signal, name)
for name in ("fork", "register_at_fork", "pread", "pwrite", "mkfifo", "O_NOFOLLOW", "O_NONBLOCK", "O_CLOEXEC"):
    delattr(os, name)

from asymptotics.shell.entry import main

for line in sys.stdin.read().splitlines():
    print("==", main(line.split()), line, file=sys.stderr)
"""


@pytest.mark.parametrize(
    "names",
    [("table", "sweep"), pytest.param(tuple(QUESTIONS), marks=pytest.mark.slow)],
    ids=["few", "all"],
)
def test_every_command_runs_once_without_what_only_posix_has(tmp_path, names):
    """Failed before: ``table`` and ``sweep`` ended in ModuleNotFoundError: No module named 'fcntl'."""
    lines = [" ".join(example(name, tmp_path)) for name in names] + ["papers smith2012:48 --check"]
    done = subprocess.run(
        [sys.executable, "-c", HIDING], input="\n".join(lines), capture_output=True, text=True, cwd=ROOT, timeout=200
    )
    codes = [int(line.split()[1]) for line in done.stderr.splitlines() if line.startswith("==")]
    assert "fault" not in done.stderr and "Traceback" not in done.stderr, done.stderr
    assert codes == [2 * line.startswith("sweep ") for line in lines], done.stderr
    assert "this system has no such locks of files" in done.stderr
