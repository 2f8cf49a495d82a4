"""The options that mean the same in every command, and why a command has none where it would mean nothing.

``--json --quiet`` are everywhere.  The others are in every command in which they make sense; elsewhere they are refused
with the reason, one line and exit code 2, instead of as unknown words.

>>> missing("moment", "gauge")
'an average has no gauge'
>>> missing("motion", "gauge") is None
True
"""

import argparse
from collections.abc import Mapping, Sequence
from typing import Any, NoReturn

from asymptotics.ask.registry import QUESTIONS, loaded

# The options that nearly every command has; a test holds each command to have them, or a reason below.
COMMON = ("csv", "digits", "gauge", "json", "latex", "plot", "points", "quiet")
_FLAGS = ("latex", "json", "quiet")

_OBSERVED = "what is observed is the same in every gauge"
_ONE_GAUGE = "U, V, W are in the turning-point gauge, L, F, T the same in all; `expand --gauge` has the others"
_OWN_GRID = "the points are those of FILE"

MISSING: dict[str, dict[str, str]] = {
    "compare": {
        "gauge": _OBSERVED,
        "latex": "the rows are text; `--csv` writes them",
        "points": _OWN_GRID,
    },
    "sweep": {
        **dict.fromkeys(("csv", "latex", "plot"), "`--export FILE.csv`, .json or .parquet writes the points"),
        "digits": "it is an option of COMMAND, and stands behind it",
        "gauge": "it is an option of COMMAND, and stands behind it",
        "points": "a range start:stop:step says how many",
    },
}


def lacks(command: str) -> Mapping[str, str]:
    """The common options that a command does not have, and why."""
    return loaded(command).offers.lacks if command in QUESTIONS else MISSING.get(command, {})


def missing(command: str, option: str) -> str | None:
    """Why ``command`` has no --``option``; None if it has it."""
    return lacks(command).get(option)


def add_missing(parser: argparse.ArgumentParser, command: str) -> None:
    """The common options that the command does not have, each of which says why; --help does not show them."""
    for option, reason in MISSING.get(command, {}).items():
        # As it would be read where it exists: a flag takes no word, the others take one, lest it be read as something
        # else.
        count: Any = 0 if option in _FLAGS else "?"
        parser.add_argument(f"--{option}", action=Refuse, nargs=count, const=reason, help=argparse.SUPPRESS)


class Refuse(argparse.Action):
    """An option that makes no sense here; ``const`` is the reason."""

    def __call__(
        self,
        parser: argparse.ArgumentParser,
        namespace: argparse.Namespace,
        values: str | Sequence[Any] | None,
        option_string: str | None = None,
    ) -> NoReturn:
        """Leave with the reason, exit code 2."""
        parser.error(f"argument {option_string}: not in this command: {self.const}")
