"""Hypothesis profiles: dev (default), ci (deterministic), nightly (HYPOTHESIS_PROFILE selects)."""

import atexit
import gc
import linecache
import os
import signal
import zlib
from pathlib import Path

import pytest
from hypothesis import settings
from xdist.scheduler import LoadScopeScheduling

# One thread of BLAS in each process, before NumPy is loaded: matrices here are small, and threads of several processes
# that wait for each other make a decomposition a hundred times as long.
os.environ |= {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
# Derivations and statements ask SymPy for the same again: more of its answers are kept than the usual 1,000.
os.environ.setdefault("SYMPY_CACHE_SIZE", "50000")

settings.register_profile("dev", max_examples=25, deadline=None)
settings.register_profile("ci", max_examples=80, deadline=None, derandomize=True, database=None, print_blob=True)
settings.register_profile("nightly", max_examples=2000, deadline=None, print_blob=True)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "dev"))

collect_ignore = ["notebook.py", "docs_drawn.py", "docs_searched.py"]  # of `make docs`, with libraries of their own

FIRST = (  # what imports derivations, each of which is proved once in a process, or needs the report of the tests
    "tests/derivations/", "tests/expansions/multiple_scales/test_derivations",
    "tests/envelopes/test_large", "tests/expansions/straightening/", "tests/paper_checks/test_every_statement",
    "tests/paper_checks/test_links", "tests/paper_checks/test_methods",
    "tests/paper_checks/test_report", "tests/paper_checks/test_font", "tests/paper_checks/test_browser",
    "tests/paper_checks/test_play", "tests/paper_checks/test_errata", "tests/paper_checks/test_found",
    "tests/test_readme",
)  # fmt: skip


WALKS = (  # over the syntax trees of all sources, which a process parses once
    "tests/test_structure", "tests/test_safety", "tests/test_iterations", "tests/test_reached",
    "tests/test_chosen_in_doubles", "tests/numbers/test_context", "tests/numbers/test_one_loop",
    "tests/paper_checks/test_three_valued", "tests/ladders/",
)  # fmt: skip


RESULTS = ("tests/ask/test_hostile_objects", "tests/present/test_shown", "tests/test_same_again")
"""Tests of one of each type of result, which a process makes once."""


CERTIFIED = (
    "tests/certificates/test_certificate", "tests/testing/test_check_certificate",
    "tests/testing/test_second_checker", "tests/testing/test_hostile_certificates",
)  # fmt: skip
"""Tests of the same certificates, each of which a process makes once."""


LONGEST = (  # minutes each: what begins last ends last, on one core
    "tests/decays/identification/test_coverage.py::test_coverage_on_a_thousand_records",
    "tests/derivations/test_alterations.py::test_every_line_with_a_side_altered_stops[multiple-scales-quadratic]",
)

SLOW = 5400
"""Seconds after which a slow test is ended: the longest, a thousand synthetic records, needs a third of it."""


SHARES = 4
"""Of the slow tests; `make test-share` runs that of the week, so that none is left alone for longer than a month."""


COLLECTED = pytest.StashKey[set[str]]()
QUICK = pytest.StashKey[set[str]]()


@pytest.fixture
def collected(request):
    """The names of all tests of the files that were asked for, also of those that are left out of this run."""
    return request.config.stash[COLLECTED]


@pytest.fixture
def quick(request):
    """Those of them that `make test` runs."""
    return request.config.stash[QUICK]


def share(name):
    """In which share of the slow tests one is: that of its name, whatever others there are."""
    return zlib.crc32(name.encode()) % SHARES


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config, items):
    """The first tests before all others; a slow one has a longer limit, and its share (``SHARE``, the week).

    ``thorough.txt`` names dear cases, for ``make test-thorough``: found redundant by ``benchmarks.suite_costs``, but
    for those that count coverage or compare two routes, or chosen from the durations of a run. The rule there: what
    takes some hundredths of a second or more of an idle core goes there if two cheaper cases of the same test, or a
    cheaper test of the same claim, stay in ``make test``, but for the walks over all questions, statements and
    derivations; of a test that a list of weakened bounds names, a case stays that notices (``test_time_limits.py``).
    """
    config.stash[COLLECTED] = {item.nodeid for item in items}
    thorough = {*Path(__file__).with_name("thorough.txt").read_text().splitlines()}
    for item in items:
        if item.nodeid in thorough:
            item.add_marker(pytest.mark.slow)
        if item.get_closest_marker("slow"):
            item.add_marker(pytest.mark.timeout(SLOW))
    config.stash[QUICK] = {item.nodeid for item in items if not item.get_closest_marker("slow")}
    if week := os.environ.get("SHARE"):
        left_out = [i for i in items if i.get_closest_marker("slow") and share(i.nodeid) != int(week) % SHARES]
        config.hook.pytest_deselected(items=left_out)
        items[:] = [item for item in items if item not in {*left_out}]
    items.sort(key=lambda item: (item.nodeid not in LONGEST, not item.nodeid.startswith(FIRST)))


class ByFile(LoadScopeScheduling):
    """What a file needs is made in one worker, and what is proved once in a process in that of the first tests."""

    def _split_scope(self, nodeid):
        if nodeid.startswith(FIRST):
            return "first"
        if nodeid.startswith(RESULTS):
            return "results"
        if nodeid.startswith(CERTIFIED):
            return "certified"
        return "walks" if nodeid.startswith(WALKS) else nodeid.split("::")[0]

    def _pending_of(self, workload):
        for scope in [scope for scope, tests in workload.items() if all(tests.values())]:
            del workload[scope]  # done: it is not counted again after each test to come
        return super()._pending_of(workload)


@pytest.hookimpl(optionalhook=True)  # not without pytest-xdist
def pytest_xdist_make_scheduler(config, log):
    """Instead of pytest-xdist's own ``load``, in the order above."""
    if config.getvalue("dist") == "load":
        config.option.loadscopereorder = False
        return ByFile(config, log)
    return None


def pytest_collection_finish(session):
    """What was collected stays to the end: the garbage collector need not search it again and again."""
    gc.collect()
    gc.freeze()
    gc.set_threshold(20_000, 20, 20)


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item):
    """The debugger that stands by for each doctest looks at all files whose lines were read: there are none."""
    if isinstance(item, pytest.DoctestItem):
        linecache.clearcache()


def pytest_configure(config):
    """A worker that is done has said all: to free a gigabyte, object by object, takes seconds."""
    if hasattr(config, "workerinput"):  # not a pytest that a test starts, whose exit code counts
        atexit.register(os._exit, 0)
        if config.option.durations is None:
            _says_what_is_shown(next(one for one in config.pluginmanager.get_plugins() if hasattr(one, "sendevent")))


def _says_what_is_shown(worker):
    """Of six messages for each of ten thousand tests the three that the other side shows nothing of are not sent."""
    send = worker.sendevent

    def sendevent(name, **what):
        around = name == "testreport" and what["data"]["when"] != "call" and what["data"]["outcome"] == "passed"
        if name != "logstart" and not around:
            send(name, **what)

    worker.sendevent = sendevent


def pytest_sessionfinish():
    """What is left is searched once, not at each of the collections by which pytest ends."""
    gc.collect()
    gc.freeze()


if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # as in a background job: what the tests start would inherit it
    signal.signal(signal.SIGINT, signal.default_int_handler)
