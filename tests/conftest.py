"""Hypothesis profiles: dev (default), ci (deterministic), nightly (HYPOTHESIS_PROFILE selects)."""

import os
import signal

from hypothesis import settings

settings.register_profile("dev", max_examples=40, deadline=None)
settings.register_profile("ci", max_examples=80, deadline=None, derandomize=True, database=None, print_blob=True)
settings.register_profile("nightly", max_examples=2000, deadline=None, print_blob=True)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "dev"))

FIRST = (  # what imports the derivations or needs the report of the tests
    "tests/derivations/", "tests/envelopes/test_derivations", "tests/multiscale/test_derivations",
    "tests/paper_checks/test_report", "tests/paper_checks/test_font", "tests/paper_checks/test_browser",
)  # fmt: skip


def pytest_collection_modifyitems(items):
    """These tests first and together: pytest-xdist gives them to one worker, and what they share is made once."""
    items.sort(key=lambda item: not item.nodeid.startswith(FIRST))


if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # as in a background job: what the tests start would inherit it
    signal.signal(signal.SIGINT, signal.default_int_handler)
