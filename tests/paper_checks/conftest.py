"""One report for all tests of this folder, from recorded outcomes: what the checks find is tested elsewhere.

Its page on the engine has tables and pictures of every kind, with fewer laws than the one that is published, one figure
stands in the place of all figures of the papers (each is drawn by tests of its own), and beside it stand certificates
of every kind: all others are made by a slow test (test_report.py).
"""

import fcntl
import os
import sys
from functools import cache, partial
from pathlib import Path

import pytest

from asymptotics.present.figures import renderings
from paper_checks.lelas2024.figures import FIGURES
from paper_checks.registry import Entry, expected_outcomes, load
from paper_checks.report import build, certificates, engine, regimes, validity_map, write_report
from paper_checks.report.measured_errors import KAPPAS, measured_errors

sys.path.insert(0, str(Path(__file__).parent))  # the module beside this one


KINDS = (  # of certificates: of a law, with 30 digits, with a stop, in m and s with a stop, of a table
    "smith2012-table1", "three-halves", "lancaster2020-fig1", "lelas2024-fig1a", "lelas2024-fig1b",
    "table-smith2012.table1",
)  # fmt: skip
EVERY = certificates.PROVED


def recorded_entries() -> list[Entry]:
    return [Entry(entry, expected_outcomes(entry), 0.0) for entry in load().values()]


@pytest.fixture(scope="session", autouse=True)
def few_laws():
    """Every kind of law in each table: one, a sum, an exponent below 1."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(engine, "EXPONENTS", ("0", "1/2", "1", "3/2", "2", "sqrt(2)"))
        patch.setattr(engine, "LAWS", (["1/2"], ["1", "2"]))
        patch.setattr(engine, "BOUNDED", [(["1/2"], range(1, 4)), (["1", "2"], range(1, 2))])
        patch.setattr(validity_map, "EPSILONS", ("1/100", "1/5", "1"))
        patch.setattr(validity_map, "ALPHAS", ("2",))
        patch.setattr(validity_map, "ORDERS", (1,))
        patch.setattr(validity_map, "TAU_MAX", 15.0)
        patch.setattr(regimes, "CASES", regimes.CASES[1::2])  # one on each side of linear damping
        patch.setattr(engine, "measured_errors", partial(measured_errors, kappas=KAPPAS[:2]))
        first = cache(partial(renderings, dpi=40))
        patch.setattr(build, "renderings", lambda draw, kinds: first(FIGURES["fig1a"][1], kinds))
        patch.setattr(certificates, "TABLE_DIGITS", 8)
        few = tuple(each for each in EVERY if each.file in {f"certificate-{kind}.json" for kind in KINDS})
        patch.setattr(certificates, "PROVED", few)
        yield


@pytest.fixture(scope="session")
def other_certificates():
    """Those that the report of the tests leaves out."""
    return [each for each in EVERY if each not in certificates.PROVED]


@pytest.fixture(scope="session")
def report(tmp_path_factory, few_laws):
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


@pytest.fixture(scope="session")
def browser(tmp_path_factory):
    """One Chromium for all tests that read a page."""
    from drawing import start  # noqa: PLC0415 (selenium: only for those)

    driver = start("chromium", tmp_path_factory.mktemp("profile"))
    yield driver
    driver.quit()
