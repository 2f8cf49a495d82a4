"""What a command returns, and the options that all commands share."""

import argparse
import json
from dataclasses import dataclass, replace
from typing import Any

from asymptotics import __version__
from asymptotics.budget import DEFAULT_SECONDS
from asymptotics.cli.shell import emit
from asymptotics.errors import InputError
from asymptotics.made_by import made_by
from asymptotics.numbers.exact import parse_rational

DEFAULT_DIGITS = 30


@dataclass(frozen=True)
class Answer:
    """What a command found: ``data`` for JSON, ``text`` for people, and whether a check failed."""

    data: dict[str, Any]
    text: str
    as_json: bool
    failed: bool = False

    def show(self, command: str) -> int:
        """Print the answer and return the exit code."""
        if self.as_json:
            data = {"command": command, "version": __version__, **self.data, "made_by": made_by()}
            emit(json.dumps(data, indent=2, ensure_ascii=False))
        else:
            emit(self.text)
        return int(self.failed)


def shortened(answer: Answer, done: int, missing: str) -> Answer:
    """The same with a line that only ``done`` rows are there and what is ``missing``; the error itself says why."""
    data = {**answer.data, "missing": missing}
    return replace(answer, data=data, text=f"{answer.text}\ncut short: {done} rows are done; missing: {missing}")


def add_json(parser: argparse.ArgumentParser) -> None:
    """The options --json and --quiet."""
    parser.add_argument("--json", action="store_true", help="print JSON (numbers are strings, never floats)")
    parser.add_argument("--quiet", action="store_true", help="no progress on stderr")


def add_digits(parser: argparse.ArgumentParser, high: int, default: str = f"{DEFAULT_DIGITS}") -> None:
    """The option --digits, an integer from 1 to ``high``."""
    text = f"significant digits, correctly rounded (1 to {high}; default {default}); certified: whether that is proved"
    parser.add_argument("--digits", metavar="D", help=text)


def add_max_seconds(parser: argparse.ArgumentParser) -> None:
    """The option --max-seconds, the time that the whole request may take."""
    text = f"the time the request may take, over all its passes (default {DEFAULT_SECONDS:g})"
    parser.add_argument("--max-seconds", default=f"{DEFAULT_SECONDS:g}", metavar="S", help=text)


def add_common(parser: argparse.ArgumentParser, high: int = 0, default: str = f"{DEFAULT_DIGITS}") -> None:
    """What commands that compute have: --digits up to ``high`` if there are any, --max-seconds, --json, --quiet."""
    if high:
        add_digits(parser, high, default)
    add_max_seconds(parser)
    add_json(parser)


def read_max_seconds(options: argparse.Namespace) -> float:
    """The value of --max-seconds; InputError outside (0, 10^6]."""
    if options.max_seconds is None:
        return DEFAULT_SECONDS
    seconds = parse_rational(options.max_seconds, "--max-seconds")
    # Eleven days at most, a refusal of slips: the time of a request is a number of seconds, not a way to do without.
    if not 0 < seconds <= 10**6:
        raise InputError("--max-seconds", f"{seconds} is out of range", "a number of seconds > 0, at most 1000000")
    return float(seconds)
