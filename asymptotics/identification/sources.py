"""From a table to observations: each kind of file has its own way."""

from pathlib import Path
from typing import Any

import numpy as np

from asymptotics.errors import InputError
from asymptotics.identification.extraction import observations_of_record
from asymptotics.identification.observations import Observations
from asymptotics.identification.printed import Decrements
from asymptotics.identification.reading import Table, read_table, require_increasing

LEAST_POINTS = 4


def load(source: Any, kind: str | None = None, unit: str = "") -> "Observations | Decrements":
    """Observations of a record or of turning points, or printed decrements; InputError for what cannot be used."""
    if isinstance(source, Observations | Decrements):
        return source
    name = Path(source).name if isinstance(source, str | Path) else "the data"
    found, table, named = read_table(source, kind, unit)
    if found == "record":
        return observations_of_record(table["t"], table["x"], unit=named, name=name)
    if found == "turning-points":
        return _turning_points(table, named, name)
    return _decrements(table, named, name)


def _turning_points(table: Table, unit: str, name: str) -> Observations:
    n, x, tau = table["n"], table["x"], table.get("tau")
    whole = np.flatnonzero(~(np.isnan(n) | (n == np.round(n))))
    if len(whole):
        reason = f"{name}, row {whole[0] + 2}, column n: {n[whole[0]]:g} is not a whole number"
        raise InputError("FILE", reason, "0, 1, 2, ...")
    keep = ~(np.isnan(n) | np.isnan(x) | (np.isnan(tau) if tau is not None else False))
    notes = [f"{(~keep).sum()} rows with empty cells left out"] if not keep.all() else []
    n, x = n[keep], x[keep]
    _require_points(n, x, name)
    require_increasing(n, "n", name)
    times = np.array([]) if tau is None else tau[keep]
    if tau is not None:
        require_increasing(times, "tau", name)
    seen = Observations.of(n.astype(int), x, times, unit=unit, name=name, notes=notes)
    wrong = np.flatnonzero(seen.x * seen.sign < 0)
    if len(wrong) > max(2, len(x) // 3):
        reason = f"{name}, row {wrong[0] + 2}, column x: the signs do not alternate with n"
        raise InputError("FILE", reason, "x_n with alternating signs, or amplitudes of one sign")
    return seen


def _require_points(n: Any, x: Any, name: str) -> None:
    if len(n) < LEAST_POINTS:
        raise InputError("FILE", f"{name} has {len(n)} turning points", f"at least {LEAST_POINTS}")
    if not np.ptp(np.abs(x)) > 0:
        raise InputError("FILE", f"{name}, column x: all values are {abs(x[0]):g}", "amplitudes that change")
    if not abs(x[0]) > 0:
        raise InputError("FILE", f"{name}, row 2, column x: the first turning point is 0", "a number other than 0")


def _decrements(table: Table, unit: str, name: str) -> Decrements:
    columns = [table["amplitude"], table["decrement"], *([table["resolution"]] if "resolution" in table else [])]
    keep = ~np.isnan(np.stack(columns)).any(axis=0)
    notes = (f"{(~keep).sum()} rows with empty cells left out",) if not keep.all() else ()
    amplitude, decrement, *resolution = (c[keep] for c in columns)
    if len(amplitude) < 2:
        raise InputError("FILE", f"{name} has {len(amplitude)} rows with numbers", "at least 2")
    checks = [(amplitude <= 0, "amplitude", "is not positive"), (decrement >= 2 * amplitude, "decrement", "too large")]
    checks += [(r < 0, "resolution", "is negative") for r in resolution]
    for wrong, column, reason in checks:
        if wrong.any():
            row = int(np.argmax(wrong))
            shown = {"amplitude": amplitude, "decrement": decrement, "resolution": resolution and resolution[0]}[column]
            where = f"{name}, row {row + 2}, column {column}: {shown[row]:g} {reason}"
            raise InputError("FILE", where, "amplitude > 0, decrement < 2 amplitude, resolution >= 0")
    return Decrements(amplitude, decrement, resolution[0] if resolution else None, unit, name, notes)
