"""The oscillator in the header of a CSV file: after the word ``code`` of the last cell, as options.

``n,x,tau,code [--alpha=2 --epsilon=1/10]``: what ``--csv`` writes, and ``compare`` reads without being told the law.
Where the oscillator alone does not say what was asked for, the command and its options stand there:
``k,c_k,d_k,code [stokes --alpha=2 --count=2]``.  What columns of doubles are good to stands beside either
(``double_errors``), and is no word of the request.
"""

import csv
import io
import re
import shlex
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from asymptotics.made_by import mark

INPUTS = ("alpha", "epsilon", "law", "spring", "damping", "mass", "stiffness", "x0", "v0")
"""The options that make an oscillator."""
MOVED_BY = (*INPUTS, "static")
"""Those that make a motion: a static friction belongs to no oscillator, and holds the mass where it turns."""
OF_EXPANSION = ("order", "gauge")
"""Those of an expansion: its amplitude and phase are told by them, and no motion is moved by them."""
DOUBLE_ERROR = "--double-error="
# Characters of a first line that are read: a header is shorter, and a file without line ends must not fill the memory.
_LONG = 100_000


def csv_text(header: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """CSV with a header that carries the units; the last column says what code made it.

    >>> csv_text(["n", "x [m]"], [(0, "0.2"), (1, None)]).replace(mark(), "sha256:...")
    'n,x [m],code\\n0,0.2,sha256:...\\n1,,sha256:...\\n'
    """
    stream, made = io.StringIO(), mark()
    csv.writer(stream, lineterminator="\n").writerows([[*header, "code"], *([*row, made] for row in rows)])
    return stream.getvalue()


def with_inputs(text: str, options: Mapping[str, Any]) -> str:
    """CSV text whose header ends in ``code``, with the options that are given beside that word.

    >>> with_inputs("n,x,code\\n0,1,sha256:12\\n", {"alpha": "2", "law": None, "epsilon": "1/10"})
    'n,x,code [--alpha=2 --epsilon=1/10]\\n0,1,sha256:12\\n'
    """
    return with_words(text, option_words(options))


def with_words(text: str, words: Sequence[str]) -> str:
    """The same with words as they are, before those that stand there."""
    head, _, rows = text.partition("\n")
    cells = next(csv.reader([head]), [""])
    # Text that has no such column, or nothing to say, stays as it is.
    if not words or not (cells[-1] == "code" or _words_of(cells)):
        return text
    stream = io.StringIO()
    row = [*cells[:-1], f"code [{shlex.join([*words, *_words_of(cells)])}]"]
    csv.writer(stream, lineterminator="\n").writerow(row)
    return stream.getvalue() + rows


def option_words(options: Mapping[str, Any]) -> list[str]:
    """The options that are given, as words: a list is an option that was repeated."""
    return [_word(name, value) for name, given in options.items() for value in _each(given)]


def _word(name: str, value: Any) -> str:
    """An option with its value; a flag alone."""
    # With =, since a value may begin with a minus.
    return f"--{name}" if value is True else f"--{name}={value}"


def _each(given: Any) -> list[str]:
    return given if isinstance(given, list) else [] if given is None or given is False else [given]


def stated_words(path: Path) -> list[str]:
    """The words of the request beside ``code`` in the header of a file."""
    return [word for word in header_words(path) if not word.startswith(DOUBLE_ERROR)]


def header_words(path: Path) -> list[str]:
    """All words beside ``code`` in the header of a file; none where there are none, or the file cannot be read."""
    try:
        with path.open(newline="", encoding="utf-8-sig") as stream:
            return _words_of(next(csv.reader([stream.readline(_LONG)]), []))
    except (OSError, ValueError, csv.Error):
        return []


def _words_of(header: Sequence[str]) -> list[str]:
    # In the last cell, where programs that read CSV see a column with a unit in brackets.
    found = re.fullmatch(r"code \[(.*)\]", header[-1]) if header else None
    return shlex.split(found[1]) if found else []


def stated_inputs(path: Path) -> dict[str, str | list[str]]:
    """The options of the motion that the header of a file says; empty where it says none.

    >>> import tempfile
    >>> path = Path(tempfile.mkdtemp()) / "points.csv"
    >>> _ = path.write_text('n,x,"code [--law=0:1 --law=1,2:1/5]"\\n0,1,a\\n')
    >>> stated_inputs(path)
    {'law': ['0:1', '1,2:1/5']}
    """
    inputs: dict[str, str | list[str]] = {}
    for name, equals, value in (word.removeprefix("--").partition("=") for word in stated_words(path)):
        # One word from outside the list, and the header is that of a request or of another program: none of it is used.
        if not equals or name not in (*MOVED_BY, *OF_EXPANSION):
            return {}
        if name in OF_EXPANSION:
            continue
        if name in ("law", "spring"):
            inputs[name] = [*inputs.get(name, []), value]
        else:
            inputs[name] = value
    return inputs
