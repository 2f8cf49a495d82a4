"""From a file, an open file, a data frame, a mapping or two arrays to the columns of a table, and what was taken.

>>> import pathlib, tempfile
>>> path = pathlib.Path(tempfile.mkdtemp()) / "run.csv"
>>> _ = path.write_text("# Messung\\nZeit t / s;Winkel (deg);Bemerkung\\n0,00;1,5;a\\n0,01;1,25;b\\n0,02;oops;c\\n")
>>> table = read_table(path)
>>> table.kind, table.unit, table.columns["x"], table.notes[0]
('record', 'deg', array([1.5 , 1.25]), "time: 'Zeit t / s'; x: 'Winkel (deg)'; 1 other column not used: 'Bemerkung'")
>>> table.notes[2]
"1 row that cannot be read left out, the first is row 5: 'oops' in the column Winkel (deg)"
"""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from asymptotics.decays.records.body import Unread
from asymptotics.decays.records.cells import MARKS
from asymptotics.decays.records.choosing import chosen, read_as
from asymptotics.decays.records.clocked import clocked
from asymptotics.decays.records.columns import KINDS, OPTIONAL, Choice
from asymptotics.decays.records.error_names import errors_beside
from asymptotics.decays.records.levels import amplitudes, is_logarithmic
from asymptotics.decays.records.peaks import (
    LEAST,
    counts_cycles,
    found_twice,
    is_double,
    is_envelope,
    never_swings,
    peaks_of_one_side,
    periods_between,
    rows_above_noise,
    turns,
)
from asymptotics.decays.records.rows import RowPlaces
from asymptotics.decays.records.sources import How, Source, opened
from asymptotics.decays.records.uncertainties import errors_of
from asymptotics.decays.records.units import (
    GRAVITY,
    SECONDS,
    UNITS,
    is_unsaid,
    seconds,
    since,
    standard,
    suffix,
    unit_of,
)
from asymptotics.errors import InputError, require_choice
from asymptotics.present.counts import many

Array = NDArray[np.float64]
MAX_SIZE = 1e60
"""Beyond this, or below its inverse, the fifth power of an amplitude leaves the doubles: no measurement does."""
_FEW = 4
"""Turning points below which the errors that stand beside them are taken as they are."""
_TOLERATED = 0.1
"""The share of rows (and one more) that may be unreadable."""


@dataclass(frozen=True)
class RecordTable:
    """Columns of equal length, by their names in the contract; ``unit``: of x; ``rows``: where they stand; ``clock``:
    the unit of time in the file (the times themselves are in s); ``read_as``: a sentence on the columns of a file that
    has others too, for a refusal.  Of an envelope, ``frequency`` in Hz where the file says it, and whether the errors
    are ``relative`` to the amplitudes, as those of levels are.  ``written``: a unit of x that is none of those that are
    known, such as V: strengths refer to it."""

    kind: str
    columns: dict[str, Array]
    unit: str
    rows: RowPlaces
    notes: tuple[str, ...] = ()
    clock: str = "s"
    frequency: float | None = None
    relative: bool = False
    written: str = ""
    read_as: Callable[[], str] = field(default=str, compare=False)

    def kept(self, keep: NDArray[np.bool_] | NDArray[np.intp], *notes: str) -> "RecordTable":
        """Some of the rows, and why."""
        columns = {name: values[keep] for name, values in self.columns.items()}
        return replace(self, columns=columns, rows=self.rows.kept(keep), notes=(*self.notes, *notes))

    def whole(self) -> "RecordTable":
        """The rows in which no cell is missing, and a note that says which are not."""
        keep = ~np.any([np.isnan(values) for values in self.columns.values()], axis=0)
        if keep.all():
            return self
        first, missing = int(np.argmin(keep)), int((~keep).sum())
        left = f"{many(missing, 'row')} with a missing cell (empty, nan, n/a) left out"
        return self.kept(keep, f"{left}, the first is row {self.rows.row(first)}")


def read_table(
    source: Any, kind: str | None = None, unit: str = "", how: How | None = None, frequency: float | None = None
) -> RecordTable:
    """The table in a source; InputError says where and why not, and what would make it clear.

    ``kind``: what the rows are, found from the columns if not given; ``unit`` of x, where the header has none;
    ``frequency`` in Hz, where it is said: amplitudes further apart than its period are no neighbours.
    """
    if kind is not None:
        require_choice(kind, "kind", KINDS)
    unit, time = units_said(unit)
    how = how or How()
    given = clocked(opened(source, how), how)
    # A mark such as ± may stand behind each column.
    marks = errors_beside(given.names)
    named = [name for place, name in enumerate(given.names) if name and place not in marks]
    # Names that stand twice can still be told by their places.
    if len(set(named)) < len(named) and how.columns is None:
        raise InputError(
            "FILE", f"{given.name}: two columns have one name", "columns with different names, or --columns"
        )
    choice = chosen(given, kind, how)
    body = given.read(sorted(set(choice.places.values())))
    columns = {name: body.columns[place] for name, place in choice.places.items()}
    # An export has columns of what was not asked for, without a number.
    columns = {n: c for n, c in columns.items() if n not in OPTIONAL[choice.kind] or not len(c) or np.isfinite(c).any()}
    rows = RowPlaces(given.name, body.lines)
    table = RecordTable(choice.kind, columns, "", rows, (choice.note, *given.notes))
    # In this order: a row that cannot be read is told with its text, a mark as it stands in the file, and units come
    # last.
    found = _in_units(_unmarked(_readable(table, body.unread, given)), choice, given, unit, time)
    found = replace(found, read_as=lambda: read_as(given, choice))
    if found.kind in ("record", "envelope") and not (kind is not None and found.kind == "record"):
        found = _as_amplitudes(found, given.names[choice.places["x"]], frequency or given.frequency)
    elif found.kind == "turning-points":
        found = _as_counted(_halved(found, given.names[choice.places["x"]]), given.names[choice.places["n"]])
    return _with_errors(found, choice, given, time)


def _with_errors(table: RecordTable, choice: Choice, given: Source, time: str) -> RecordTable:
    """Turning points with the errors that stand beside them, as ``sigma_x`` and ``sigma_t``; of samples, that they are
    not used."""
    places = errors_of(given.names, choice.places)
    if table.kind != "turning-points":
        listed = ", ".join(repr(given.names[place]) for place in sorted(places.values()))
        unused = (f"errors not used: {listed}; the samples tell their own",) if listed else ()
        return replace(table, notes=(*table.notes, *unused))
    body = given.read(list(places.values()) or [choice.places["x"]])
    rows = np.searchsorted(body.lines, table.rows.lines) if table.rows.lines is not None else slice(None)
    errors = {f"sigma_{c}": body.columns[place][rows] for c, place in places.items()}
    # One that is 0, or missing, weighs nothing.
    errors = {c: values for c, values in errors.items() if (values > 0).all() and np.isfinite(values).all()}
    # dt and dx may be the steps of the rows, and no errors.
    errors = {c: values for c, values in errors.items() if not _are_steps(values, _column_of(table, c))}
    if "sigma_t" in errors:
        clock = given.names[places["t"]]
        errors["sigma_t"] = errors["sigma_t"] * (seconds(clock, given.name, time) if suffix(clock) in SECONDS else 1.0)
    if not errors:
        return table
    named = ", ".join(repr(given.names[places[c.removeprefix("sigma_")]]) for c in errors)
    few = len(table.columns["x"]) < _FEW
    found = "they make the interval of Q" if few else "their proportions weigh the fit, their size is found with it"
    said = f"errors from {named}: {found}"
    return replace(table, columns={**table.columns, **errors}, notes=(*table.notes, said))


def _column_of(table: RecordTable, errors: str) -> Array:
    return table.columns["tau" if errors == "sigma_t" and "tau" in table.columns else "x"]


def _are_steps(values: Array, of: Array) -> bool:
    """Whether a column holds what another one, or its size, changes by from row to row."""
    steps = np.abs(np.concatenate([np.diff(of)[None], np.diff(np.abs(of))[None]]))
    near = 1e-3 * np.abs(of).max()
    return any(np.allclose(part, row, rtol=0, atol=near) for row in steps for part in (values[1:], values[:-1]))


def _halved(table: RecordTable, name: str) -> RecordTable:
    """Amplitudes where the column holds what lies between the peaks of both sides."""
    if not is_double(name):
        return table
    halved = {**table.columns, "x": table.columns["x"] / 2}
    return replace(table, columns=halved, notes=(*table.notes, f"{name!r}: amplitudes are half of it"))


def _as_counted(table: RecordTable, name: str) -> RecordTable:
    """Half-swings where the column counts cycles."""
    if not counts_cycles(name):
        return table
    said = f"{name!r} counts cycles: n is twice that"
    return replace(table, columns={**table.columns, "n": 2 * table.columns["n"]}, notes=(*table.notes, said))


def _as_amplitudes(table: RecordTable, name: str, frequency: float | None) -> RecordTable:
    """A sampled envelope, or peaks of one side; a sampled motion as it is."""
    table = _halved(table, name)
    t, x = table.columns["t"], table.columns["x"]
    levels = table.kind == "envelope" or is_logarithmic(suffix(name))
    if levels or is_envelope(name, t, x, frequency):
        return _as_envelope(table, suffix(name), frequency)
    apart = periods_between(t, frequency)
    if apart is not None and len(x) < LEAST and (x > 0).all():
        # As neighbouring peaks they would have the period of their distance.
        reason = f"{table.rows.name}: {len(x)} amplitudes lie {apart:.3g} periods apart at the frequency that is said"
        loss = "--kind damping with --mass and --stiffness (1 and omega_0^2), for the strength of each law"
        raise InputError("FILE", reason, f"at least {LEAST} of them; or {loss}")
    return _as_peaks(table, name)


def _as_envelope(table: RecordTable, unit: str, frequency: float | None) -> RecordTable:
    """Levels or amplitudes at times, as the amplitudes of a ring-down."""
    relative, kept = is_logarithmic(unit), rows_above_noise(table.columns["x"])
    if not relative and kept < len(table.columns["x"]):
        hidden = len(table.columns["x"]) - kept
        table = table.kept(np.arange(kept), f"{many(hidden, 'row')} at the end, 0 or hidden by noise, left out")
    x = amplitudes(table.columns["x"], unit)
    said = (f"amplitudes 10^(L/20) of the levels L in {unit}",) if relative else ()
    notes = tuple(note for note in table.notes if not (relative and "strengths refer to" in note))
    columns = {"t": table.columns["t"], "x": x}
    # The root of a power, and what a level is the logarithm of, are in another unit than the column.
    written = table.written if np.array_equal(x, table.columns["x"], equal_nan=True) else ""
    return replace(
        table, kind="envelope", columns=columns, notes=(*notes, *said), frequency=frequency, relative=relative,
        written=written,
    )  # fmt: skip


def _as_peaks(table: RecordTable, name: str) -> RecordTable:
    """Peaks of one side as turning points; a sampled motion as it is."""
    t, x = table.columns["t"], table.columns["x"]
    keep = np.flatnonzero(~found_twice(t))
    n = peaks_of_one_side(name, t[keep], x[keep])
    said = "peaks of one side, a period apart (n = 0, 2, 4, ...)"
    said += f" ({len(t) - len(keep)} found twice count once)" if len(keep) < len(t) else ""
    if n is None:
        # A list of the maxima may stand before that of the minima.
        keep = np.argsort(t, kind="stable")
        n, said = turns(t[keep], x[keep]), "turning points of both sides, half a period apart"
        said += ", sorted by time" if np.any(np.diff(t) < 0) else ""
    if n is None:
        _require_swings(table, name)
        return table
    other = "two amplitudes that are no period apart: --kind damping" if len(n) == 2 else "--kind record overrules"
    told = table.kept(keep, f"{name!r}: {len(n)} {said}; {other}")
    return replace(told, kind="turning-points", columns={"n": n, "x": x[keep], "tau": t[keep]})


def _require_swings(table: RecordTable, name: str) -> None:
    """InputError where the values are amplitudes whose name does not say so: as samples of a motion they are none."""
    if table.kind == "record" and never_swings(table.columns["t"], table.columns["x"]):
        accepted = "amplitudes: --kind envelope with --omega0 (2 pi over the period), or peaks in a column 'amplitude'"
        raise InputError("FILE", f"{table.rows.name}: {name!r} falls and never swings", f"{accepted}; --kind record")


def units_said(unit: str) -> tuple[str, str]:
    """The unit of x and that of time in what is said of them, empty for none.

    >>> units_said("deg"), units_said("mm,ms"), units_said("min"), units_said("")
    (('deg', ''), ('mm', 'ms'), ('', 'min'), ('', ''))
    """
    if isinstance(unit, str) and not unit:
        return "", ""
    said = unit.split(",") if isinstance(unit, str) else [unit]
    for one in said:
        require_choice(one, "unit", (*UNITS, *SECONDS))
    of_x, of_time = ([u for u in said if u in known] for known in (UNITS, SECONDS))
    if len(of_x) > 1 or len(of_time) > 1:
        raise InputError("unit", f"{unit[:40]!r} names two units of one quantity", "one of x, one of time: mm,ms")
    return "".join(of_x), "".join(of_time)


def _unmarked(table: RecordTable) -> RecordTable:
    """Marks such as -999 where all other values are far smaller."""
    columns, notes = dict(table.columns), []
    for name, values in table.columns.items():
        marks = np.isin(values, MARKS)
        rest = values[~marks & ~np.isnan(values)]
        # Half of the smallest mark: values of that size make -999 a value.
        if marks.any() and len(rest) and float(np.abs(rest).max()) < 500:
            columns[name] = np.where(marks, np.nan, values)
            notes.append(f"{many(int(marks.sum()), 'value')} {values[marks][0]:g} of {name} taken as missing")
    return replace(table, columns=columns, notes=(*table.notes, *notes))


def _readable(table: RecordTable, unread: Unread, given: Source) -> RecordTable:
    """Without the rows that cannot be read; InputError if they are more than a tenth (and one), or than half at all."""
    first, bad = unread.first, set(unread.rows)
    named = f"the column {given.names[first[1]]}" if first else ""
    for name, values in table.columns.items():
        with np.errstate(invalid="ignore"):
            wild = np.flatnonzero((np.abs(values) > MAX_SIZE) | ((np.abs(values) < 1 / MAX_SIZE) & (values != 0)))
        bad |= set(wild.tolist())
        if len(wild) and (first is None or wild[0] < first[0]):
            first = (int(wild[0]), 0, f"{values[wild[0]]:g}")
            named = f"the column {name}: out of range (0, and absolute values from {1 / MAX_SIZE:g} to {MAX_SIZE:g})"
    if first is None:
        return table
    count = len(next(iter(table.columns.values())))
    # Unreadable rows at the end are a footer, and do not count against the file.
    footer = next(k for k in range(count + 1) if count - 1 - k not in bad)
    where = f"row {table.rows.row(first[0])}: {first[2][:30]!r} in {named}"
    # More than a tenth, and one: then the layout was read wrongly, and the remedy is named.
    if len(bad) - footer > 1 + _TOLERATED * count or len(bad) > 1 + 0.5 * count:
        reason = f"{table.rows.name}, {where} is not a number, and so in {len(bad)} of {count} rows"
        raise InputError("FILE", reason, "numbers; or say --decimal , or --decimal . or --skip LINES or --columns")
    keep = np.ones(count, dtype=bool)
    keep[sorted(bad)] = False
    return table.kept(keep, f"{many(len(bad), 'row')} that cannot be read left out, the first is {where}")


def _in_units(table: RecordTable, choice: Choice, given: Source, unit: str, time: str) -> RecordTable:
    columns, notes, clock = dict(table.columns), list(table.notes), "s"
    for column in ("t", "tau"):
        if column in columns:
            # Times become seconds; x keeps its unit, to which strengths refer.
            name = given.names[choice.places[column]]
            since_1970 = "" if time or suffix(name) else since(columns[column])
            notes += [f"{name!r}: {since_1970} since 1970"] if since_1970 else []
            if not (time or since_1970 or choice.places[column] in given.stamped) and is_unsaid(name, columns[column]):
                notes.append("times without a unit: read as s")
            size = seconds(name, given.name, time or since_1970)
            columns[column] = columns[column] * size
            clock = next(name for name, known in SECONDS.items() if known == size)
    measured = [
        given.names[choice.places[c]] for c in ("x", "v", "a", "amplitude", "decrement", "resolution") if c in columns
    ]
    if "a" in columns and suffix(measured[0]) == "g":
        columns["a"] = columns["a"] * GRAVITY
        notes.append(f"1 g taken as {GRAVITY} m/s^2")
    found, written = unit_of(measured, unit, given.name), ""
    for name in measured[:1]:
        other = standard(suffix(name))
        if other and not found:
            notes.append(f"the unit {other!r} of {name!r} is none of {', '.join(UNITS)}: strengths refer to 1 {other}")
            # What a velocity or an acceleration is written in is not the unit of x.
            written = "" if "v" in columns or "a" in columns else other
    return replace(table, columns=columns, unit=found, notes=tuple(notes), clock=clock, written=written)
