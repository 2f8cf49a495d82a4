"""What the head of an exported file says: which table it is, and what it was asked for.

A table says it in lines that start with #; the other files in the last cell of their header, after the word ``code``,
as the options of the oscillator: ``n,x,tau,code [--alpha=2 --epsilon=1/10]``.

>>> import tempfile
>>> path = Path(tempfile.mkdtemp()) / "points.csv"
>>> head = '# turning-points: Turning points\\n# inputs: {"alpha": ["2"], "law": null, "epsilon": ["1/2"], "rows": 4}'
>>> _ = path.write_text(head + '\\nlaw,n,x\\n2:1/2,0,1\\n')
>>> stated(path)
Stated(table='turning-points', alphas=('2',), law=(), epsilons=('1/2',), rows=4)
"""

import csv
import io
import json
import re
import shlex
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Any

_LINES, _LONG = 20, 100_000
INPUTS = ("alpha", "epsilon", "law", "spring", "damping", "mass", "stiffness", "x0", "v0")
"""The options that make an oscillator."""


@dataclass(frozen=True)
class Stated:
    """A table with its inputs as text: exponents, strengths, the terms A:E of a law, rows; empty or None: defaults."""

    table: str
    alphas: tuple[str, ...] = ()
    law: tuple[str, ...] = ()
    epsilons: tuple[str, ...] = ()
    rows: int | None = None


def stated(path: Path) -> Stated | None:
    """What the lines that start with # say; None where they say nothing, or the file cannot be read."""
    if not path.is_file():
        return None
    try:
        with path.open(encoding="utf-8-sig") as stream:
            lines = [line[2:].strip() for line in islice(stream, _LINES) if line.startswith("# ") and len(line) < _LONG]
    except (OSError, ValueError):
        return None
    told = {name: text for name, _, text in (line.partition(": ") for line in lines)}
    name = re.match(r"[a-z0-9][a-z0-9.-]*(?=: )", lines[0]) if lines else None
    try:
        inputs = json.loads(told["inputs"])
    except (KeyError, ValueError):
        return None
    if name is None or not isinstance(inputs, dict):
        return None
    law, rows = inputs.get("law"), inputs.get("rows")
    terms = tuple(law.split(",")) if isinstance(law, str) else ()
    count = rows if isinstance(rows, int) else None
    return Stated(name[0], _texts(inputs.get("alpha")), terms, _texts(inputs.get("epsilon")), count)


def _texts(found: Any) -> tuple[str, ...]:
    return tuple(map(str, found)) if isinstance(found, list) else ()


def with_inputs(text: str, options: Mapping[str, Any]) -> str:
    """CSV text whose header ends in ``code``, with the options that are given beside that word.

    >>> with_inputs("n,x,code\\n0,1,sha256:12\\n", {"alpha": "2", "law": None, "epsilon": "1/10"})
    'n,x,code [--alpha=2 --epsilon=1/10]\\n0,1,sha256:12\\n'
    """
    pairs = [(name, value) for name, given in options.items() for value in _each(given)]
    head, _, rows = text.partition("\n")
    if not pairs or not head.endswith(",code"):
        return text
    stream = io.StringIO()
    said = shlex.join(f"--{name}={value}" for name, value in pairs)
    csv.writer(stream, lineterminator="\n").writerow([*next(csv.reader([head]))[:-1], f"code [{said}]"])
    return stream.getvalue() + rows


def _each(given: Any) -> list[str]:
    return given if isinstance(given, list) else [] if given is None else [given]


def stated_inputs(path: Path) -> dict[str, str | list[str]]:
    """The options of the oscillator that the header of a file says; empty where it says none.

    >>> import tempfile
    >>> path = Path(tempfile.mkdtemp()) / "points.csv"
    >>> _ = path.write_text('n,x,"code [--law=0:1 --law=1,2:1/5]"\\n0,1,a\\n')
    >>> stated_inputs(path)
    {'law': ['0:1', '1,2:1/5']}
    """
    try:
        with path.open(newline="", encoding="utf-8-sig") as stream:
            cells = next(csv.reader([stream.readline(_LONG)]), [])
        found = re.fullmatch(r"code \[(.*)\]", cells[-1]) if cells else None
        words = shlex.split(found[1]) if found else []
    except (OSError, ValueError, csv.Error):
        return {}
    inputs: dict[str, str | list[str]] = {}
    for name, equals, value in (word.removeprefix("--").partition("=") for word in words):
        if not equals or name not in INPUTS:
            return {}
        if name in ("law", "spring"):
            inputs[name] = [*inputs.get(name, []), value]
        else:
            inputs[name] = value
    return inputs
