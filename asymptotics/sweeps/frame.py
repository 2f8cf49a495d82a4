"""A finished sweep as columns of numbers, and as curves: what the store holds, in the order of the sweep.

>>> numbers(["1/2", "0.25", ""]), numbers(["true", "false"]), numbers(["averaging", "1"]), numbers(["", ""])
([0.5, 0.25, None], [True, False], None, None)
"""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from asymptotics.errors import InputError, LimitError
from asymptotics.numbers.exact import parse_real
from asymptotics.sweeps.export import rows_of
from asymptotics.sweeps.grid import Point
from asymptotics.sweeps.store import Store

# A table is made in memory; more lines than twelve are told apart by no eye.
MAX_ROWS, MAX_LINES = 1_000_000, 12


def columns(command: str, points: Sequence[Point], folder: Path) -> dict[str, list[Any]]:
    """Every parameter and result by name; a column of numbers is doubles, with its text beside it as NAME_digits.

    LimitError for more than a million points, InputError for a store that is none.
    """
    if len(points) > MAX_ROWS:
        accepted = f"at most {MAX_ROWS}; sweeps.export writes any number"
        raise LimitError("points", f"{len(points)} are too many for a table in memory", accepted)
    rows = list(rows_of(command, points, Store(folder)))
    names = dict.fromkeys(name for row in [*points, *rows] for name in row)
    found: dict[str, list[Any]] = {}
    for name in names:
        cells = [row.get(name, "") for row in rows]
        # A reason or a mark that happened to look like a number would lose its text.
        read = None if name in ("failed", "code") else numbers(cells)
        found[name] = cells if read is None else read
        if read is not None and any("." in cell or "/" in cell or "sqrt" in cell for cell in cells):
            found[f"{name}_digits"] = cells
    return found


def numbers(cells: Sequence[str]) -> list[Any] | None:
    """The cells as doubles or truth values, None for an empty one; None where they are words, or all are empty."""
    filled = [cell for cell in cells if cell]
    if not filled:
        return None
    if set(filled) <= {"true", "false"}:
        return [cell == "true" if cell else None for cell in cells]
    try:
        return [float(parse_real(cell, "cell").ball().mid()) if cell else None for cell in cells]
    except InputError:
        return None


def draw(axes: Any, points: Sequence[Point], table: Mapping[str, list[Any]], style: dict[str, Any]) -> None:
    """A result against the first parameter that varies, a line for each value of the others.

    Options: ``x`` and ``y``, names of columns.  InputError where there is nothing to draw against, or to draw.
    """
    parameters = list(dict.fromkeys(name for point in points for name in point))
    # The order of the parameters is that in which they were typed: the first that varies is the abscissa.
    varied = [name for name in parameters if len(set(table[name])) > 1]
    numeric = [name for name, cells in table.items() if any(isinstance(c, float) for c in cells)]
    x = style.pop("x", next((name for name in varied if name in numeric), None))
    results = [name for name in numeric if name not in parameters and len(set(table[name])) > 1]
    y = style.pop("y", results[0] if results else None)
    for axis, name, known in (("x", x, numeric), ("y", y, numeric)):
        if name not in known:
            raise InputError(axis, f"there is no column of numbers {name!r:.40}", ", ".join(known)[:200] or "none")
    others = [name for name in varied if name != x]
    lines: dict[str, tuple[list[float], list[float]]] = {}
    for i, (place, value) in enumerate(zip(table[x], table[y])):
        if place is not None and value is not None:
            name = ", ".join(f"{other} = {points[i].get(other, '')}" for other in others)
            xs, ys = lines.setdefault(name, ([], []))
            xs.append(place)
            ys.append(value)
    if len(lines) > MAX_LINES:
        raise InputError("x", f"{len(lines)} lines are no picture", f"x, one of {', '.join(varied)}, or fewer points")
    for name, curve in lines.items():
        axes.plot(*curve, **{"marker": "o", "markersize": 3, "linewidth": 0.8, "label": name or None, **style})
    axes.set(xlabel=x, ylabel=y)
