"""One report for all tests of this folder, from recorded outcomes: what the checks find is tested elsewhere."""

import fcntl
import os

import pytest

from paper_checks.registry import Entry, expected_outcomes, load
from paper_checks.report import write_report


def recorded_entries() -> list[Entry]:
    return [Entry(entry, expected_outcomes(entry), 0.0) for entry in load().values()]


@pytest.fixture(scope="session")
def report(tmp_path_factory):
    """Written once: of the workers of pytest-xdist the first to come writes it, the others wait."""
    own = tmp_path_factory.getbasetemp()
    shared = own.parent if "PYTEST_XDIST_WORKER" in os.environ else own
    with (shared / "report.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        folder = shared / "report"
        folder.mkdir(exist_ok=True)
        if not (shared / "report.done").exists():
            write_report(folder, recorded_entries())
            (shared / "report.done").touch()
    return folder
