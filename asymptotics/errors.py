"""The errors a user can meet; every message names the argument, the reason and what is accepted.

>>> raise InputError("--digits", "0 is not positive", "an integer from 1 to 10000")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument --digits: 0 is not positive (accepted: an integer from 1 to 10000)
"""


class InputError(ValueError):
    """A value that cannot be used: ``argument`` names it, ``reason`` says why, ``accepted`` says what can be used."""

    def __init__(self, argument: str, reason: str, accepted: str) -> None:
        super().__init__(argument, reason, accepted)
        self.argument, self.reason, self.accepted = argument, reason, accepted

    def __str__(self) -> str:
        return f"argument {self.argument}: {self.reason} (accepted: {self.accepted})"


class LimitError(InputError):
    """A value that could be used but asks for more work than the stated limit; the reason carries the estimate."""


class UndecidedError(ArithmeticError):
    """A certified computation could not decide within its precision limit; nothing is claimed."""
