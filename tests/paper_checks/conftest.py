"""One report for all tests of this folder, from recorded outcomes: what the checks find is tested elsewhere."""

import pytest

from paper_checks.registry import Entry, expected_outcomes, load
from paper_checks.report import write_report


def recorded_entries() -> list[Entry]:
    return [Entry(entry, expected_outcomes(entry), 0.0) for entry in load().values()]


@pytest.fixture(scope="session")
def report(tmp_path_factory):
    folder = tmp_path_factory.mktemp("report")
    write_report(folder, recorded_entries())
    return folder
