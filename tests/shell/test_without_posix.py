"""A system without fcntl, resource, fork and alarms, as Windows is: every command answers, or says what it lacks."""

import subprocess
import sys
from pathlib import Path

from asymptotics.ask.registry import QUESTIONS

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
LINES = {
    "compare": "compare {} --alpha 2 --epsilon 1",
    "damping": "damping --alpha 2 --epsilon 1/10 --amplitudes 1 --digits 5",
    "derive": "derive",
    "envelope": "envelope --alpha 2 --epsilon 1/10",
    "expand": "expand --alpha 2 --order 2",
    "half-swing": "half-swing --alpha 2 --order 2",
    "identify": "identify {} --laws 1 --no-bootstrap",
    "limit-cycle": "limit-cycle --law 1:-1 --law 1,2:1 --order 2",
    "moment": "moment --p 2",
    "motion": "motion --alpha 2 --epsilon 1/10 --time 3",
    "multiple-scales": "multiple-scales --alpha 3 --order 2",
    "papers": "papers smith2012:48 --check",
    "solution": "solution --alpha 2 --order 1",
    "smith": "smith f --n 3",
    "stokes": "stokes --alpha 2 --digits 5",
    "sweep": "sweep moment --p 1 --store {}.store --workers 1",
    "table": "table smith2012.table1 --digits 5 --rows 2",
    "turning-points": "turning-points --alpha 2 --epsilon 1 --count 2 --digits 5",
}


def test_every_command_runs_once_without_what_only_posix_has(tmp_path):
    """Failed before: ``table`` and ``sweep`` ended in ModuleNotFoundError: No module named 'fcntl'."""
    assert set(LINES) == set(QUESTIONS)
    path = tmp_path / "points.csv"
    path.write_text("n,x\n" + "".join(f"{n},{(-0.9) ** n:.6f}\n" for n in range(12)))
    lines = "\n".join(line.format(path) for line in LINES.values())
    done = subprocess.run(
        [sys.executable, "-c", HIDING], input=lines, capture_output=True, text=True, cwd=ROOT, timeout=200
    )
    codes = [int(line.split()[1]) for line in done.stderr.splitlines() if line.startswith("==")]
    assert "fault" not in done.stderr and "Traceback" not in done.stderr, done.stderr
    assert dict(zip(LINES, codes, strict=True)) == {name: 2 if name == "sweep" else 0 for name in LINES}, done.stderr
    assert "this system has no such locks of files" in done.stderr
