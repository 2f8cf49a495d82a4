"""What a command returns, and the time that it may take."""

import argparse
import json
from dataclasses import dataclass, replace
from typing import Any

from asymptotics import __version__
from asymptotics.made_by import made_by
from asymptotics.numbers.policy import exact_seconds
from asymptotics.running.budget import DEFAULT_SECONDS
from asymptotics.shell.guarded import emit


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


def read_max_seconds(options: argparse.Namespace) -> float:
    """The value of --max-seconds; InputError outside (0, 10^6]."""
    given = options.max_seconds
    return DEFAULT_SECONDS if given is None else exact_seconds(given, "--max-seconds")
