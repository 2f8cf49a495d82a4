"""What the head of an exported file says: which table it is, and what it was asked for.

>>> import tempfile
>>> path = Path(tempfile.mkdtemp()) / "points.csv"
>>> head = '# turning-points: Turning points\\n# inputs: {"alpha": ["2"], "law": null, "epsilon": ["1/2"], "rows": 4}'
>>> _ = path.write_text(head + '\\nlaw,n,x\\n2:1/2,0,1\\n')
>>> stated(path)
Stated(table='turning-points', alphas=('2',), law=(), epsilons=('1/2',), rows=4)
"""

import json
import re
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Any

from asymptotics.tables.inputs import terms_of_label

_LINES, _LONG = 20, 100_000
"""Lines of a head, and characters of one, that are read: heads of our own are a handful of short lines."""


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
    try:
        if not path.is_file():
            return None
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
    terms = terms_of_label(law) if isinstance(law, str) else ()
    count = rows if isinstance(rows, int) else None
    return Stated(name[0], _texts(inputs.get("alpha")), terms, _texts(inputs.get("epsilon")), count)


def _texts(found: Any) -> tuple[str, ...]:
    return tuple(map(str, found)) if isinstance(found, list) else ()
