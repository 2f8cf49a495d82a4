"""No test can hang: each has a limit of time, and one that runs into it fails and is named."""

import subprocess
import sys
from pathlib import Path

import pytest

HANGS = "def test_without_end():\n    while True:\n        pass\n"


def test_a_test_without_end_is_ended_and_named(tmp_path):
    (tmp_path / "test_hangs.py").write_text(HANGS)
    command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "--timeout", "1", "--timeout-method", "thread"]
    run = subprocess.run([*command, "test_hangs.py"], cwd=tmp_path, capture_output=True, text=True, timeout=60)
    assert run.returncode == 1 and "Timeout" in run.stdout and "test_without_end" in run.stdout


def test_the_limit_is_on(request):
    assert 0 < float(request.config.getini("timeout")) <= 300


def test_what_moved_to_the_thorough_tests_exists():
    names = (Path(__file__).with_name("thorough.txt")).read_text().splitlines()
    assert names == sorted({*names})
    for name in names:
        file, function = name.split("[")[0].split("::", 1)
        path = Path(__file__).parents[1] / file
        assert path.exists() and (not file.startswith("tests") or f"def {function}(" in path.read_text()), name


@pytest.mark.slow
def test_a_slow_test_has_a_longer_limit(request):
    assert request.node.get_closest_marker("timeout").args[0] > float(request.config.getini("timeout"))
