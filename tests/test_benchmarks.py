"""Every benchmark runs at a tiny size and returns rows; nothing is asserted about time."""

import doctest
import json
import os
import re
import subprocess
import sys
from fractions import Fraction
from importlib import import_module
from pathlib import Path

import pytest

from asymptotics.errors import InputError
from asymptotics.expansions.normal_form.expansion import exact_expansion
from asymptotics.motions.invariants.exact import coefficients
from benchmarks import cubic_damping, fit_programs, fits, peers, promises
from benchmarks.__main__ import BENCHMARKS, BESIDE, QUICK, WHOLE, main
from benchmarks.cubic_damping import expand_by_hand, process_seconds
from benchmarks.decays import Decay
from benchmarks.report import markdown, write
from benchmarks.smith_rows import rational_rows
from benchmarks.table import Table, measured, with_ratios
from benchmarks.turning_point_tables import wrong_digits

TINY = {
    "smith-rows": 16, "cubic-damping": 2, "cost-against-order": 4, "turning-points": 5,
    "certified-orbits": 20, "integrators": 2, "certified-motion": 20, "hypergeometric": 20, "start-up": 1,
    "comparing": 200, "promises": 2, "multiple-scales": 1, "costs": 2,
    "identified": 1, "fits": 1, "certificates": 1, "double-errors": 1,
}  # fmt: skip
MODULES = sorted(path.stem for path in (Path(__file__).parents[1] / "benchmarks").glob("*.py"))


@pytest.mark.parametrize("name", BENCHMARKS)
def test_runs_and_returns_rows(name, capsys, monkeypatch):
    monkeypatch.setattr(cubic_damping, "TIMEOUT", 0.01)
    assert main([name, "--size", str(TINY[name]), "--json", "--no-peers"]) == 0  # they have their own make target
    table = json.loads(capsys.readouterr().out)[name]
    assert table["rows"]
    assert all(len(row) == len(table["columns"]) and all(isinstance(x, str) for x in row) for row in table["rows"])


def test_the_report_names_the_machine(tmp_path):
    write(tmp_path, {"x": Table("Title", ("what", "ratio"), (("a", "1.0"), ("b", "-"), ("c", "30")))})
    found = json.loads((tmp_path / "benchmarks.json").read_text())
    assert "python-flint" in found["machine"]["package"]
    assert "| c | 30 |" in (tmp_path / "benchmarks.md").read_text()
    assert "<svg" in (tmp_path / "benchmarks.svg").read_text()


def test_text_and_bad_input(capsys):
    assert main(["turning-points", "--size", "3", "--no-peers"]) == 0
    assert "certified balls" in capsys.readouterr().out
    assert main(["no-such"]) == 2
    assert main(["smith-rows", "--size", "0"]) == 2
    errors = capsys.readouterr().err.splitlines()
    assert len(errors) == 2
    assert "argument name" in errors[0]
    assert "argument --size" in errors[1]


@pytest.mark.parametrize("module", [name for name in MODULES if name != "__main__"])
def test_examples_in_docstrings(module):
    name = "benchmarks" if module == "__init__" else f"benchmarks.{module}"
    assert doctest.testmod(import_module(name), optionflags=doctest.NORMALIZE_WHITESPACE).failed == 0


def test_a_peer_that_is_wanted_and_missing_ends_the_run(capsys, monkeypatch):
    """Found before anything is measured, with what Python says of it: nothing is called a result without the peers."""
    monkeypatch.setattr(peers, "PYTHON", Path("no/peers/here"))
    assert main(["hypergeometric", "--size", "5"]) == 2
    said = capsys.readouterr()
    assert not said.out
    assert "mpmath, gmpy2, cypari" in said.err
    monkeypatch.setattr(peers, "PYTHON", Path(sys.executable))
    peers.require(["mpmath"])
    with pytest.raises(InputError, match="no_such_peer: ModuleNotFoundError"):
        peers.require(["mpmath", "no_such_peer"])
    assert main(["turning-points", "--size", "3"]) == 0  # asks none
    assert main(["hypergeometric", "--size", "5", "--no-peers"]) == 0
    assert "not installed" in capsys.readouterr().out
    assert Path(sys.executable) == peers.PYTHON


def test_the_peers_that_are_asked_are_those_of_the_lock():
    """Each module that asks a peer names it; the lock installs these, and no others."""
    asking = {name: import_module(f"benchmarks.{name}") for name in BENCHMARKS.values()}
    for name, module in asking.items():
        assert hasattr(module, "ask") == hasattr(module, "PEERS"), name
    lines = (Path(__file__).parents[1] / "requirements/peers.in").read_text().splitlines()
    locked = {re.split("[<>=]", line)[0] for line in lines if not line.startswith("#")}
    asked = {peer for module in asking.values() for peer in getattr(module, "PEERS", ())}
    assert asked == locked >= set(peers.IN_PAGES)


def test_the_peers_of_which_pages_have_numbers_stand_there_and_in_the_lock_with_their_versions():
    root = Path(__file__).parents[1]
    lock = (root / "requirements/peers.txt").read_text()
    for name, (version, pages) in peers.IN_PAGES.items():
        assert f"\n{name}=={version} " in lock
        assert pages and all(f"{name} {version}" in (root / page).read_text(encoding="utf-8") for page in pages)


def test_a_run_of_all_has_the_tables_in_their_order(monkeypatch, capsys):
    assert measured.__module__ != "benchmarks.__main__"  # which a second process does not have under python -m
    some = {"fits": "fits", "smith-rows": "smith_rows", "hypergeometric": "hypergeometric"}
    monkeypatch.setattr("benchmarks.__main__.BENCHMARKS", some)
    monkeypatch.setattr("benchmarks.__main__.QUICK", {"fits": 1, "smith-rows": 5, "hypergeometric": 10})
    assert main(["--quick", "--no-peers", "--json"]) == 0
    said = capsys.readouterr()
    assert list(json.loads(said.out)) == list(some) and some.keys() & set(BESIDE) == {"fits"}
    assert json.loads(said.out)["fits"]["rows"][1][-1] == "not installed"  # the second process asks no peer either
    assert re.search(r"^hypergeometric: \d+ s$", said.err, re.M)


def test_a_promise_that_is_not_kept_is_called_so(monkeypatch):
    given = {"slow": (lambda: sum(range(10**5)), 1e-9), "quick": (lambda: None, 9)}
    monkeypatch.setattr(promises, "promises", lambda _size: given)
    (*_, slow), (*_, quick) = promises.run(1).rows
    assert slow.endswith(": not kept") and quick == "0.00"


def test_only_times_of_the_same_work_are_called_faster():
    """A ratio below 1 is; an estimate by a time, or a share of a promise, is not."""
    rows = (("ours", "1.0"), ("other", "0.5"))
    assert "Faster: other." in markdown({"x": Table("Title", ("what", "ratio"), rows)}, {})
    assert "Faster" not in markdown({"x": Table("Title", ("what", "said/taken"), rows)}, {})


def test_every_benchmark_has_a_quick_size(capsys):
    assert set(QUICK) == set(TINY) == set(BENCHMARKS) > set(WHOLE)
    assert main(["turning-points", "--quick", "--size", "9"]) == 2
    assert "argument --size" in capsys.readouterr().err


def test_what_is_compared_is_the_same_result():
    assert {i: c for i, c in enumerate(rational_rows(20, Fraction)) if c} == coefficients(20)
    ours = exact_expansion((3,), 5, "no-first-harmonic")
    by_hand = expand_by_hand(5)
    for k in range(1, 6):
        coefficient = (ours.p if k % 2 else ours.Omega)[k]
        assert coefficient.to_sympy() == by_hand[k - 1]


def test_a_record_that_a_program_fails_on_is_counted_and_an_interval_that_misses_too():
    """One of three records raises in the program's process; of the others one interval holds Q = 50, one misses it."""
    work = "lambda record: {'quality': [[float(record['x']), 51.0, float(1 / record['t'])]]}"
    code = f"{fit_programs._EACH}answer = all_records({work})"
    records = [{"t": t, "x": x} for t, x in ((0.01, 40.0), (0.01, 51.0), (None, 40.0))]
    said = peers.ask(code, python=sys.executable, records=records)["found"]
    assert ["failed" in one for one in said] == [False, False, True]
    made = [Decay("plain", "1", (0.02,), {})] * 3
    ours = [{"at": [1.0]}] * 3
    said[1]["wrong"] = True
    row = fits._row("program", made, said, ours)
    assert row[:6] == ("program", "2 of 3", "2 % / 2 %", "1 of 2", "-", "1")
    said[0]["quality"][0][1] = 55.0
    assert fits._row("program", made, said, ours)[2] == "6 % / 9.2 %"


def test_a_peer_is_told_more_than_an_argument_of_a_command_can_hold():
    told = peers.ask("answer = {'seconds': len(x)}", python=sys.executable, x=[0.123456789] * 40_000)
    assert told == {"seconds": 40_000}


def test_a_missing_tool_is_named():
    assert with_ratios([("a", 2.0), ("b", None)])[1] == ("b", "not installed", "-")


def test_a_tool_that_fails_or_hangs_gets_no_time():
    python = [sys.executable, "-c"]
    failed = process_seconds([*python, "print('-- an error. To debug this try')"], "")
    stopped = process_seconds([*python, "import time; time.sleep(9)"], "", timeout=0.2)
    rows = with_ratios([("a", 2.0), ("b", failed), ("c", stopped)])
    assert rows[1:] == (("b", "failed", "-"), ("c", "stopped", "-"))


def test_wrong_digits_are_counted():
    assert wrong_digits(["0.12345"], ["0.12345"]) == 0
    assert wrong_digits(["0.12399"], ["0.12345"]) >= 1


def test_peers_that_cannot_be_installed_stop_make(tmp_path):
    """A pip that fails leaves no stamp behind, so that the next run does not take the peers for installed."""
    peers_there, maker = tmp_path / "peers", tmp_path / "python"
    venv = 'mkdir -p "$4/bin" && printf "#!/bin/sh\\nexit $FAILS\\n" > "$4/bin/python" && chmod +x "$4/bin/python"'
    maker.write_text(f"#!/bin/sh\n{venv}\n")
    maker.chmod(0o755)
    command = ["make", f"PYTHON={maker}", f"PEERS={peers_there}", f"{peers_there}/.ready"]
    for fails, stamped in (("1", False), ("0", True)):
        run = subprocess.run(
            command, cwd=Path(__file__).parents[1], env=os.environ | {"FAILS": fails}, capture_output=True, check=False
        )
        assert (run.returncode == 0, (peers_there / ".ready").exists()) == (stamped, stamped)
