"""The time a request of the command line may take: that of a public call, with its progress on stderr."""

import argparse
from collections.abc import Iterator
from contextlib import contextmanager

from asymptotics.numbers.context import alone
from asymptotics.running.progress import status_line
from asymptotics.running.public import limited
from asymptotics.shell.answer import read_max_seconds


@contextmanager
def timed(options: argparse.Namespace) -> Iterator[None]:
    """Everything inside has --max-seconds together; LimitError when they are over, wherever that is."""
    seconds = read_max_seconds(options)
    # The line is opened first and closed last, so that the error that ends the time is printed on a clean line.
    with status_line(seconds, quiet=getattr(options, "quiet", False)) as show, limited(seconds, show), alone:
        yield
