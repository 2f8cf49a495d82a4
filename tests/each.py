"""One test for many small cases: each is tried, and a failure names every one that fails.

A test of its own costs pytest some two milliseconds, more than what is asked of such a case.
"""

import inspect
from collections.abc import Callable, Iterable
from typing import Any

import pytest


def each(names: str | tuple[str, ...], cases: Iterable[Any]) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """As ``pytest.mark.parametrize``, with all cases in one test; fixtures are made once for all of them."""
    single = isinstance(names, str)
    kept = [(case,) if single else tuple(case) for case in cases]
    own = (names,) if isinstance(names, str) else names

    def together(test: Callable[..., None]) -> Callable[..., None]:
        signature = inspect.signature(test)

        def all_of_them(**fixtures: Any) -> None:
            failed = []
            for case in kept:
                try:
                    test(**dict(zip(own, case, strict=True)), **fixtures)
                except (Exception, pytest.fail.Exception) as error:
                    failed.append(f"{', '.join(map(str, case))}: {type(error).__name__}: {error}")
            assert kept and not failed, f"{len(failed)} of {len(kept)} cases:\n" + "\n".join(failed)

        others = [p for p in signature.parameters.values() if p.name not in own]
        all_of_them.__signature__ = signature.replace(parameters=others)  # type: ignore[attr-defined]
        all_of_them.__name__, all_of_them.__doc__ = test.__name__, test.__doc__
        all_of_them.__module__, all_of_them.__qualname__ = test.__module__, test.__qualname__
        return all_of_them

    return together
