"""Where a table comes from: its inputs, the program and its libraries, the code and its commit, and a SHA-256.

The SHA-256 is that of the columns and rows as JSON without spaces; ``checksum`` computes it again from any file.

>>> checksum(("n", "x"), [("1", "0.5")])[:16]
'68ee74e1ccbbccd8'
"""

import hashlib
import json
from collections.abc import Iterable, Sequence
from typing import Any

from asymptotics.made_by import made_by


def checksum(columns: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """The SHA-256 of a table's columns and rows."""
    # Of the rows alone: the same numbers have the same digest whatever the file format, the commit and the machine.
    content = json.dumps([list(columns), *map(list, rows)], separators=(",", ":"), ensure_ascii=False)
    return hashlib.sha256(content.encode()).hexdigest()


def provenance(inputs: dict[str, Any], source: str, certified: bool, sha256: str) -> dict[str, Any]:
    """Everything a file says about its origin; numbers are strings."""
    return {
        "source": source,
        "certified": certified,
        "inputs": inputs,
        **made_by(),
        "sha256": sha256,
    }
