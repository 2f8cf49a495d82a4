"""Hypothesis profiles: dev (default), ci (deterministic), nightly (HYPOTHESIS_PROFILE selects)."""

import os
import signal

from hypothesis import settings

settings.register_profile("dev", max_examples=40, deadline=None)
settings.register_profile("ci", max_examples=80, deadline=None, derandomize=True, database=None, print_blob=True)
settings.register_profile("nightly", max_examples=2000, deadline=None, print_blob=True)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "dev"))

if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # as in a background job: what the tests start would inherit it
    signal.signal(signal.SIGINT, signal.default_int_handler)
