"""What a table may come from, opened: its names, its first rows, and a way to read the columns that are wanted."""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from itertools import islice
from math import inf
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from asymptotics.decays.records.body import Body, Unread, read_body
from asymptotics.decays.records.cells import number
from asymptotics.decays.records.exports import require_data
from asymptotics.decays.records.formats import FRAMES, SHEETS, frame_of, sheet_lines
from asymptotics.decays.records.header import names_in_rows
from asymptotics.decays.records.instruments import with_times
from asymptotics.decays.records.labview import with_clock
from asymptotics.decays.records.layout import Layout, layout_of
from asymptotics.decays.records.levels import frequency_in
from asymptotics.decays.records.lines import is_comment
from asymptotics.decays.records.rates import rate_in
from asymptotics.decays.records.stamps import is_stamp, order_of, past_midnight, seconds_of_stamp
from asymptotics.decays.records.text import lines_of, unpacked
from asymptotics.decays.records.units_in_cells import ROWS, named, number_before, unit_of, with_units_above
from asymptotics.errors import InputError, require_choice, shown

Array = NDArray[np.float64]
_NO_NAME = re.compile(r"column \d+( \[.*\])?|arr_\d+")
"""What a column is called for want of a name, here and by NumPy."""
_HEAD, _LONGEST, _HALF = 2_000, 100_000, 0.5
"""Lines that show the layout, the longest preamble that is searched for numbers, and the share of its cells that say
what a column holds: a few may be spoilt."""


@dataclass(frozen=True)
class How:
    """What is said of a file: ``columns`` such as ``t=Time (s),x=3``; ``decimal``: ``.`` or ``,``; ``skip``: lines
    before the table; ``sheet``: its name; ``rate``: samples a second, instead of a column of times."""

    columns: str | None = None
    decimal: str | None = None
    skip: int = 0
    sheet: str | None = None
    rate: float | None = None

    def __post_init__(self) -> None:
        if self.decimal is not None:
            require_choice(self.decimal, "decimal", (".", ","))
        if isinstance(self.skip, bool) or not isinstance(self.skip, int) or not 0 <= self.skip <= _LONGEST:
            raise InputError("skip", f"{shown(self.skip)} is no number of lines", f"0 to {_LONGEST}")
        if self.rate is not None and not (isinstance(self.rate, int | float) and 0 < self.rate < inf):
            raise InputError("rate", f"{shown(self.rate)} is no rate", "samples a second, a number > 0")


@dataclass(frozen=True)
class Source:
    """``headed``: whether the names stand in the file; ``read``: the columns at these places; ``sample``: some rows;
    ``rate``: samples a second, and ``frequency`` in Hz, where the file says them; ``stamped``: the columns of dates and
    times of day, which need no unit."""

    name: str
    names: tuple[str, ...]
    headed: bool
    read: Callable[[Sequence[int]], Body]
    sample: Callable[[Sequence[int]], dict[int, Array]]
    notes: tuple[str, ...] = ()
    rate: float | None = None
    frequency: float | None = None
    stamped: frozenset[int] = frozenset()


def opened(source: Any, how: How) -> Source:
    """A path, an open file, a data frame or a mapping of columns; a source that is open is itself."""
    if isinstance(source, Source):
        return source
    pandas = _pandas()
    if isinstance(source, pandas.DataFrame):
        return _of_frame(source, "the data", how)
    if isinstance(source, Mapping):
        try:
            frame = pandas.DataFrame({str(k): np.asarray(v) for k, v in source.items()})
        except ValueError as error:
            raise InputError("data", str(error), "columns of equal length") from error
        return _of_frame(frame, "the data", how)
    # Before paths: an open file has a name too. It is read whole, since it may be a pipe, which cannot be read twice.
    if hasattr(source, "read") and hasattr(source, "readline"):
        text = source.read()
        name = Path(str(getattr(source, "name", "the file"))).name
        return _of_text(text.encode() if isinstance(text, str) else bytes(text), name, how)
    if not isinstance(source, str | Path):
        raise InputError("data", f"{shown(source)} is no data", "a file, a data frame, a mapping of columns, (t, x)")
    path = Path(source)
    try:
        # A name with half a surrogate pair cannot be printed in a message either.
        str(path).encode()
    except UnicodeEncodeError as error:
        raise InputError("FILE", f"{str(path)!r} is no file name", "a file of data") from error
    if path.suffix.lower() in SHEETS + FRAMES and _is_file(path):
        if path.suffix.lower() in FRAMES:
            return _of_frame(frame_of(path), path.name, how)
        lines, told = sheet_lines(path, how.sheet)
        found = _of_text("\n".join(lines).encode(), path.stem + path.suffix + " (sheet)", how)
        return replace(found, notes=(*found.notes, *told))
    if "\0" in str(path):
        raise InputError("FILE", f"{str(path)!r} is no file name", "a file of data")
    return _of_text(path, path.name, how)


def _is_file(path: Path) -> bool:
    """Whether it is one; of a name that is too long for the system the reading says what is wrong with it."""
    try:
        return path.is_file()
    except OSError:
        return False


def _pandas() -> Any:
    try:
        import pandas  # noqa: PLC0415 (an extra: only tables need it)
    except ModuleNotFoundError as error:  # any other ImportError is a fault, or want of memory
        accepted = "an installation with the extra identify: pip install '.[identify]' in a clone"
        raise InputError("data", "tables are read by pandas, which is not installed", accepted) from error
    return pandas


@contextmanager
def _lines(source: Path | bytes, name: str) -> Iterator[Iterator[str]]:
    with unpacked(source, name) as stream:
        lines = lines_of(stream, name)
        try:
            yield with_units_above(with_times(with_clock(lines)), name)
        finally:
            lines.close()


def _of_text(source: Path | bytes, name: str, how: How) -> Source:
    head, layout = _layout(source, name, how)
    names = layout.header
    rows = [layout.cells(line) for line in head[layout.start :] if not is_comment(line)]
    rows = [row for row in rows if len(row) == layout.width]
    # A column of times of day may have a few spoilt cells.
    columns = [[row[i] for row in rows] for i in range(layout.width)]
    stamps = {i: order_of(cells) for i, cells in enumerate(columns) if _share(is_stamp(c) for c in cells) > _HALF}

    def read(wanted: Sequence[int]) -> Body:
        with _lines(source, name) as lines:
            body = read_body(lines, layout, wanted, stamps)
        # Times of day without a date go on at midnight.
        daily = {c: past_midnight(body.columns[c]) for c in wanted if stamps.get(c) == ""}
        return replace(body, columns={**body.columns, **daily})

    def value(cell: str, place: int) -> float:
        found = seconds_of_stamp(cell, stamps[place]) if place in stamps else number(cell, layout.mark(place))
        return np.nan if found is None else found

    def sample(wanted: Sequence[int]) -> dict[int, Array]:
        return {c: np.array([value(cell, c) for cell in columns[c]]) for c in wanted}

    if not names:
        # Beside the samples some oscilloscopes write their settings, in the first rows of columns that are empty else.
        known = [_share(value(cell, c) == value(cell, c) for cell in cells) > _HALF for c, cells in enumerate(columns)]
        names = names_in_rows(columns, known)

    require_data(names, name)
    # A reading that another program would not share is told.
    told = [f"decimal comma, cells separated by {layout.separator!r}"] if layout.decimal == "," else []
    above = head[: layout.start]
    told += ["the columns have different decimal marks"] if layout.others else []
    told += ["a comma or point groups thousands"] if layout.thousands else []
    headed = not all(_NO_NAME.fullmatch(n) for n in names if n)
    return Source(
        name, names, headed, read, sample, tuple(told), rate_in(above), frequency_in(above), frozenset(stamps)
    )


def _share(flags: Iterable[bool]) -> float:
    """How many of them hold, 0 of none."""
    held = list(flags)
    return sum(held) / len(held) if held else 0.0


def _layout(source: Path | bytes, name: str, how: How) -> tuple[list[str], Layout]:
    """The first lines and their layout; a preamble that is longer than them is passed."""
    with _lines(source, name) as lines:
        head = list(islice(lines, how.skip + _HEAD))
        while True:
            try:
                return head, layout_of(head, name, decimal=how.decimal, skip=how.skip)
            except InputError:
                # The refusal may be due to a long preamble: more lines are looked at, up to _LONGEST, and then the last
                # refusal stands.
                more = list(islice(lines, 10 * _HEAD))
                if not more or len(head) > _LONGEST or any("\0" in line for line in more):
                    raise
                head += more


def _with_index(frame: Any) -> Any:
    """An index that has a name or holds times is a column like others."""
    index = frame.index
    if index.name is None and index.dtype.kind not in "Mm":
        return frame
    named = frame.copy(deep=False)
    named.index.name = index.name if index.name is not None else "time"
    return frame if str(named.index.name) in map(str, frame.columns) else named.reset_index()


def _of_frame(frame: Any, name: str, how: How) -> Source:
    frame = _with_index(frame)
    names = tuple(str(c).strip() for c in frame.columns)
    # pandas numbers columns that have no names.
    headed = not all(isinstance(c, int) for c in frame.columns) and not all(_NO_NAME.fullmatch(n) for n in names)
    if not headed:
        names = tuple(f"column {i + 1}" for i in range(len(names)))
    units = {i: unit for i in range(len(names)) if (unit := _unit_in_cells(frame.iloc[:, i]))}
    names = tuple(named(names, units, name))

    def read(wanted: Sequence[int]) -> Body:
        unread = Unread()
        bare = {c: _bare(frame.iloc[:, c], units[c], name) if c in units else frame.iloc[:, c] for c in wanted}
        columns = {c: _numbers(column, c, unread, how.decimal or ".") for c, column in bare.items()}
        return Body(columns, np.arange(len(frame)), unread)

    rate = frame.attrs.get("rate") if isinstance(frame.attrs, dict) else None
    stamped = frozenset(i for i in range(len(names)) if _is_stamped(frame.iloc[:, i]))
    return Source(name, names, headed, read, lambda wanted: read(wanted).columns, rate=rate, stamped=stamped)


def _unit_in_cells(column: Any) -> str:
    """The unit in the cells of a column of text, as in "5 cm"."""
    return unit_of([cell for cell in column.head(ROWS).tolist() if isinstance(cell, str)])


def _bare(column: Any, unit: str, name: str) -> Any:
    """The numbers of such cells."""
    cells = [
        number_before(cell, unit, f"{name}, row {i}") if isinstance(cell, str) else cell
        for i, cell in enumerate(column.tolist())
    ]
    return _pandas().Series(cells, dtype=object)


def _is_stamped(column: Any) -> bool:
    """Whether a column of a frame holds dates, durations or times of day."""
    cells = [cell for cell in column.head(_HEAD).tolist() if isinstance(cell, str)] if column.dtype.kind == "O" else []
    return column.dtype.kind in "Mm" or _share(map(is_stamp, cells)) > _HALF


def _numbers(column: Any, place: int, unread: Unread, decimal: str) -> Array:
    kind = column.dtype.kind
    if kind in "fiu":
        return np.asarray(column.to_numpy(dtype=float, na_value=np.nan))
    # Dates as seconds since the first, for nanoseconds since 1970 have no room in a double.
    if kind in "Mm":
        pandas = _pandas()
        start = column.iloc[0] if len(column) else 0
        return np.asarray(
            (pandas.to_timedelta(column - start) if kind == "M" else column).dt.total_seconds(), dtype=float
        )
    found = np.full(len(column), np.nan)
    cells = column.tolist()
    order = order_of([cell for cell in cells if isinstance(cell, str)])
    for i, cell in enumerate(cells):
        if cell is None or cell != cell:
            continue
        if isinstance(cell, int | float | np.integer | np.floating) and not isinstance(cell, bool):
            found[i] = float(cell)
            continue
        value = number(cell, decimal) if isinstance(cell, str) else None
        if isinstance(cell, str) and is_stamp(cell):
            value = seconds_of_stamp(cell, order)
        if value is None:
            unread.add(i, place, str(cell)[:60])
        else:
            found[i] = value
    return found
