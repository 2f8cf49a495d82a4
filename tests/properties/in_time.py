"""A limit of time for each example of a property, so that a law that takes too long is a failure with its name."""

from contextlib import contextmanager

from hypothesis import assume, note

from asymptotics.errors import LimitError, UndecidedError
from asymptotics.running.budget import DEFAULT_SECONDS, budget

SECONDS = DEFAULT_SECONDS  # what a public call has; almost all examples need less than half a second


@contextmanager
def answered_in_time(law):
    """What is refused or undecided is no example; what takes too long is a failure that names its law."""
    note(f"law: {law}")
    try:
        with budget(SECONDS):
            yield
    except (LimitError, UndecidedError) as refused:
        if f"{SECONDS:g} s are over" in str(refused):
            raise AssertionError(f"{law}: {refused}") from refused
        assume(False)
        raise
