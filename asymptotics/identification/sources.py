"""From a table to observations: each kind of file has its own way."""

from typing import Any

import numpy as np

from asymptotics.errors import InputError
from asymptotics.identification.coefficients import Array
from asymptotics.identification.extraction import observations_of_record
from asymptotics.identification.observations import Observations
from asymptotics.identification.printed import Decrements
from asymptotics.identification.reading import Table, read_table, require_increasing
from asymptotics.identification.rows import Rows

LEAST_POINTS = 4


def load(source: Any, kind: str | None = None, unit: str = "") -> "Observations | Decrements":
    """Observations of a record or of turning points, or printed decrements; InputError for what cannot be used."""
    if isinstance(source, Observations | Decrements):
        return source
    table = read_table(source, kind, unit)
    if table.kind == "record":
        return observations_of_record(table.columns["t"], table.columns["x"], unit=table.unit, rows=table.rows)
    return _turning_points(table) if table.kind == "turning-points" else _decrements(table)


def _turning_points(table: Table) -> Observations:
    n = table.columns["n"]
    fraction = np.flatnonzero(~(np.isnan(n) | (n == np.round(n))))
    if len(fraction):
        reason = f"{table.rows.where(fraction[0], 'n')}: {n[fraction[0]]:g} is not a whole number"
        raise InputError("FILE", reason, "0, 1, 2, ...")
    table, notes = table.whole()
    rows, name, tau = table.rows, table.rows.name, table.columns.get("tau")
    n, x = table.columns["n"], table.columns["x"]
    _require_points(x, rows)
    require_increasing(n, "n", rows)
    if tau is not None:
        require_increasing(tau, "tau", rows)
    seen = Observations.of(n.astype(int), x, () if tau is None else tau, unit=table.unit, name=name, notes=notes)
    wrong = np.flatnonzero(seen.x * seen.sign < 0)
    if len(wrong) > max(2, len(x) // 3):
        reason = f"{rows.where(wrong[0], 'x')}: the signs do not alternate with n"
        raise InputError("FILE", reason, "x_n with alternating signs, or amplitudes of one sign")
    return seen


def _require_points(x: Array, rows: Rows) -> None:
    if len(x) < LEAST_POINTS:
        raise InputError("FILE", f"{rows.name} has {len(x)} turning points", f"at least {LEAST_POINTS}")
    if not np.ptp(np.abs(x)) > 0:
        raise InputError("FILE", f"{rows.name}, column x: all values are {abs(x[0]):g}", "amplitudes that change")
    if not abs(x[0]) > 0:
        raise InputError("FILE", f"{rows.where(0, 'x')}: the first turning point is 0", "a number other than 0")


def _decrements(table: Table) -> Decrements:
    table, notes = table.whole()
    rows, columns = table.rows, table.columns
    amplitude, decrement, resolution = columns["amplitude"], columns["decrement"], columns.get("resolution")
    if len(amplitude) < 2:
        raise InputError("FILE", f"{rows.name} has {len(amplitude)} rows with numbers", "at least 2")
    checks = [("amplitude", amplitude <= 0, "is not positive"), ("decrement", decrement >= 2 * amplitude, "too large")]
    if resolution is not None:
        wide = np.abs(decrement) + resolution >= 2 * amplitude
        checks += [("resolution", resolution < 0, "is negative"), ("resolution", wide, "leaves no limit in this row")]
    for column, wrong, reason in checks:
        if wrong.any():
            place = int(np.argmax(wrong))
            said = f"{rows.where(place, column)}: {columns[column][place]:g} {reason}"
            raise InputError("FILE", said, "amplitude > 0, resolution >= 0, decrement + resolution < 2 amplitude")
    return Decrements(amplitude, decrement, resolution, table.unit, rows.name, notes)
