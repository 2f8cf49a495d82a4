"""The columns of a JSON file: named lists, rows with names, a list of pairs, or one object in each line.

>>> def columns(text: str) -> dict[str, object]: return _columns(_parsed(text), "")
>>> columns('{"meta": {"fs": 50}, "t": [0, 1], "x": [1, 0.5]}')
{'meta/fs': 50, 't': [0, 1], 'x': [1, 0.5]}
>>> columns('[{"t": 0, "x": 1}, {"t": 1, "x": null}]') == columns('{"t": 0, "x": 1}\\n{"t": 1}')
True
>>> columns('{"columns": ["t", "x"], "data": [[0, 1], [1, 0.5]]}')
{'t': [0, 1], 'x': [1, 0.5]}
"""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from asymptotics.decays.records.exports import require_no_answer
from asymptotics.decays.records.stamps import is_stamp, order_of, past_midnight, seconds_of_stamp
from asymptotics.errors import LimitError

MOST_BYTES = 200_000_000
"""Of a file that is held as Python objects, several times as large."""


def arrays_of_json(path: Path) -> dict[str, Any]:
    """Columns as arrays and single numbers as they are; None for what is neither."""
    if path.stat().st_size > MOST_BYTES:
        raise LimitError("FILE", f"{path.name} has {path.stat().st_size} bytes of JSON", f"at most {MOST_BYTES}")
    found = _parsed(path.read_text(encoding="utf-8-sig"))
    require_no_answer(found, path.name)
    return {name: _array(value) for name, value in _columns(found, "").items()}


def _array(value: Any) -> Any:
    if not isinstance(value, list):
        return value if _is_number(value) else None
    # A number that is not there is null.
    numbers = [np.nan if cell is None else cell for cell in value]
    return np.array(numbers, dtype=float) if all(map(_is_number, numbers)) else _times(value)


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _times(value: list[Any]) -> Any:
    """Stamps of time as seconds; None for other texts."""
    if not all(isinstance(cell, str) and is_stamp(cell) for cell in value):
        return None
    order = order_of(value)
    times = np.array([seconds_of_stamp(cell, order) for cell in value], dtype=float)
    return times if order else past_midnight(times)


def _parsed(text: str) -> Any:
    """What it holds; ValueError for what is no JSON."""
    try:
        return json.loads(text)
    except json.JSONDecodeError:
        return [json.loads(line) for line in text.splitlines() if line.strip()]


def _columns(found: Any, path: str) -> dict[str, Any]:
    """Columns and other values by the path of their names."""
    if isinstance(found, Mapping):
        names: Any = found.get("columns")
        rows: Any = found.get("data")
        if _is_table(rows) and isinstance(names, Sequence) and len(names) == len(rows[0]):
            return {str(name): list(column) for name, column in zip(names, zip(*rows, strict=True))}
        columns: dict[str, Any] = {}
        for name, value in found.items():
            columns |= _columns(value, f"{path}/{name}" if path else str(name))
        return columns
    if isinstance(found, list) and found and all(isinstance(row, Mapping) for row in found):
        names = list(dict.fromkeys(name for row in found for name in row))
        return {f"{path}/{name}" if path else str(name): [row.get(name) for row in found] for name in names}
    if _is_table(found):
        return {f"column {i + 1}": list(column) for i, column in enumerate(zip(*found, strict=True))}
    return {path or "column 1": found}


def _is_table(rows: Any) -> bool:
    return isinstance(rows, list) and len(rows) > 1 and all(isinstance(row, list) and row for row in rows)
