"""The matrices of ``identify`` are worked on by one thread on any machine, and the caller's number is kept."""

import numpy as np
import pytest
from threadpoolctl import threadpool_info, threadpool_limits

from asymptotics.decays.identification import identify


def _threads() -> set[int]:
    return {library["num_threads"] for library in threadpool_info() if library["user_api"] == "blas"}


def test_one_thread_inside_and_as_many_as_before_afterwards(monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[set[int]] = []
    original = identify.load
    monkeypatch.setattr(identify, "load", lambda *given: seen.append(_threads()) or original(*given))
    n = np.arange(12)
    with threadpool_limits(2, user_api="blas"):
        before = _threads()
        identify.identified({"n": n, "x": (-0.9) ** n}, laws=["1"], noise=1e-3)
        after = _threads()
    assert seen == [{1}]
    assert before == after == {2}
