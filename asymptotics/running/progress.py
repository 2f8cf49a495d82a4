"""Progress for people: on stderr, only when that is a terminal, and only after a second."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any


def progress_bar(total: int | None, *, unit: str, title: str = "", quiet: bool = False) -> Any:
    """A tqdm bar that shows nothing in files, pipes and tests, and nothing for work of less than a second."""
    from tqdm import tqdm  # noqa: PLC0415 (a tenth of the time of a short command, most of which show no bar)

    # Control characters of a bar would stand in files and pipes; stderr is None under pythonw.
    hidden = quiet or sys.stderr is None or not sys.stderr.isatty()
    return tqdm(total=total, unit=unit, desc=title or None, leave=False, disable=hidden, delay=1)


@contextmanager
def status_line(seconds: float, *, quiet: bool = False) -> Iterator[Callable[[str], None]]:
    """A line that is handed the stage of the work and shows it with the time gone, under the same conditions."""
    hidden = quiet or sys.stderr is None or not sys.stderr.isatty()
    if hidden:
        yield lambda _: None
        return
    from tqdm import tqdm  # noqa: PLC0415 (as above)

    form = f"{{desc}}, {{elapsed}} of {seconds:g} s"
    with tqdm(bar_format=form, leave=False, delay=1) as line:

        def show(stage: str) -> None:
            line.set_description_str(stage, refresh=False)
            line.update()

        yield show
