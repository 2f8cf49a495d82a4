"""Progress for people: on stderr, only when that is a terminal, and only after a second."""

import sys

from tqdm import tqdm


def progress_bar(total: int | None, *, unit: str, title: str = "") -> tqdm:
    """A tqdm bar that shows nothing in files, pipes and tests, and nothing for work of less than a second."""
    hidden = sys.stderr is None or not sys.stderr.isatty()
    return tqdm(total=total, unit=unit, desc=title or None, leave=False, disable=hidden, delay=1)
