"""Other users, other folders, other locales, little room and signals at random moments: whole files or the old ones."""

import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PROGRAM = [sys.executable, "-m", "asymptotics.shell.entry"]
MOTION = "motion --alpha 3/2 --damping 1/10 --x0 1 --time 20"
OVERRIDE = "-dac_override,-dac_read_search"
MORTAL = ["setpriv", f"--bounding-set={OVERRIDE}", f"--inh-caps={OVERRIDE}"]  # root without its power over permissions
IS_ROOT = os.geteuid() == 0


def as_others(*command: str) -> subprocess.CompletedProcess[str]:
    """Run where permissions count, for root as well."""
    if IS_ROOT and not shutil.which("setpriv"):
        pytest.skip("root writes everywhere, and setpriv of util-linux is missing")
    return subprocess.run([*(MORTAL if IS_ROOT else []), *command], capture_output=True, text=True, check=False)


def forbidden(folder: Path, kind: str) -> Path:
    """A name that may not be written, for one reason or another."""
    folder.mkdir()
    target = folder / "a.csv"
    if kind == "write-protected":
        target.write_text("old")
        target.chmod(0o444)
    elif kind == "read-only folder":
        folder.chmod(0o500)
    elif not IS_ROOT:
        pytest.skip("only root can give a file away")
    elif kind == "file of another user":
        target.write_text("old")
        os.chown(target, 65534, 65534)
    else:
        os.chown(folder, 65534, 65534)
    return target


@pytest.mark.parametrize(
    "kind", ["read-only folder", "folder of another user", "write-protected", "file of another user"]
)
def test_what_may_not_be_written_is_refused_before_the_work(tmp_path, kind):
    target = forbidden(tmp_path / "verschlossen ü", kind)
    before = target.read_text() if target.exists() else None
    done = as_others(
        *PROGRAM, *["turning-points", "--alpha", "2", "--epsilon", "1/10", "--count", "3", "--csv"], str(target)
    )
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (2, "", 1)
    assert "Permission denied" in done.stderr or "write-protected" in done.stderr
    assert [p.read_text() for p in target.parent.iterdir()] == ([] if before is None else [before])


FOLDERS = (
    "plain",
    "with  blanks ",
    "ünïcödé 漢字 \N{PILE OF POO}",
    "-dash",
    "quote'\"`$HOME`",
    "line\nbreak",
    "a" * 200,
)
LOCALES = (
    {},
    {"LC_ALL": "C"},
    {"LC_ALL": "tr_TR.UTF-8"},
    {"LC_ALL": "no_SUCH"},
    {"PYTHONUTF8": "0", "LC_ALL": "POSIX"},
)
COMMANDS = (
    f"{MOTION} --order 2 --csv a.csv --plot b.svg",
    f"{MOTION} --reference --csv a.csv --plot b.png",
    "turning-points --alpha 2 --epsilon 1/10 --count 300 --times --csv a.csv --plot b.svg",
    "envelope --alpha 2 --epsilon 1/10 --time 20 --csv a.csv --plot b.svg",
)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(60))
def test_at_random_in_a_hostile_world(tmp_path, seed):
    """The files are the old ones or the new ones, together; nothing else is left; at most one line is said.

    A table that was cut short is the exception: its rows that were done are kept, and the answer says so.
    """
    chance = random.Random(seed)
    folder = tmp_path / chance.choice(FOLDERS)
    folder.mkdir()
    command = chance.choice(COMMANDS).split()
    names = sorted(word for word in command if word[:2] in ("a.", "b."))
    for name in names:
        (folder / name).write_text("old")
    room = chance.choice([None, None, chance.randrange(30_000)])
    number = chance.choice([None, signal.SIGINT, signal.SIGTERM])
    surroundings = {**os.environ, "PYTHONPATH": str(ROOT), **chance.choice(LOCALES)}
    with subprocess.Popen(
        [*PROGRAM, *command], cwd=folder, env=surroundings, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        preexec_fn=lambda: room is not None and resource.setrlimit(resource.RLIMIT_FSIZE, (room, room)),
    ) as process:  # fmt: skip
        if number is not None:
            time.sleep(chance.uniform(0, 2.5))
            process.send_signal(number)
        answer, said = process.communicate(timeout=120)
    allowed = {0} | ({2} if room is not None else set()) | ({128 + number, -number} if number is not None else set())
    assert process.returncode in allowed, said
    assert b"Traceback" not in said and said.count(b"\n") <= (process.returncode != 0), said
    assert sorted(p.name for p in folder.iterdir()) == names
    kept = {(folder / name).read_bytes() == b"old" for name in names}
    if b"cut short: " in answer:
        assert number is not None and (folder / names[1]).read_bytes() == b"old"
        assert (folder / "a.csv").read_text().splitlines()[1].startswith("0.0,1.0,")
        return
    assert kept in ([{True}, {False}] if number is not None else [{process.returncode != 0}])
