"""The columns of a source: by their names, and where these leave several, by what stands in them.

A column that never changes is none.  Of several clocks the finest is taken if all tell one time.  Of the axes of one
sensor the one that carries the oscillation; of an angle and a place of the same swing the angle; of two tables beside
each other, each with a time of its own, the one that swings.  What was taken is said, and --columns overrules; where
two could be meant it is asked.

>>> from asymptotics.decays.records.sources import opened
>>> t = np.arange(0, 30, 0.02)
>>> swing = np.exp(-0.03 * t) * np.cos(4 * t)
>>> phone = {"Time (s)": t, "Gyroscope x (rad/s)": 0.1 * swing, "Gyroscope y (rad/s)": swing}
>>> chosen(opened(phone, How()), None, How()).places
{'t': 0, 'v': 2}
"""

import re
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from asymptotics.decays.records.body import Body
from asymptotics.decays.records.clocked import CLOCK, names_time
from asymptotics.decays.records.columns import COLUMNS, Choice, SeveralError, choose, quantity
from asymptotics.decays.records.main_axis import carrying, line_of
from asymptotics.decays.records.sources import How, Source
from asymptotics.decays.records.units import SECONDS, UNITS, suffix
from asymptotics.errors import InputError
from asymptotics.numbers.quantities import ANGLES

Array = NDArray[np.float64]
_DERIVED = re.compile(r"\b(absolute?|magnitude|norm|total|resultant|betrag)\b", re.IGNORECASE)
"""Columns that are made from the axes: |a| swings with each of them, and is none."""
_ANGLE = re.compile(r"\b(angle|theta|phi|winkel|roll|pitch)\b|[\u03b8\u03c6]", re.IGNORECASE)
_OTHERS = 20
"""Columns that a refusal looks at."""
_SECONDS = re.compile(r"seconds|sekunden", re.IGNORECASE)
_FILLED, _PURE, _SAME, _SHARE, _ALIKE, _EQUAL = 0.5, 0.5, 0.03, 0.9, 0.999, 1e-4
"""A column with fewer numbers than this share of the fullest holds results, no samples; a column swings if this share
of its power is near its line; lines are one if their frequencies agree so far; nine tenths of the power is enough to
be the swing of two tables; the correlation of two clocks that run alike; and the rounding of a column that is
written twice."""


def chosen(given: Source, kind: str | None, how: How) -> Choice:
    """The columns, and in the note how they were found; InputError with the option that says it, where it is asked."""
    names, said, notes = ordered(given, kind, how), how.columns, list[str]()
    if names and names[-1] == CLOCK and not names_time(said):
        said = ",".join([*([said] if said else []), f"t={len(names)}"])
    while True:  # each time round a column is settled: a time, and what is measured after it
        try:
            choice = choose(names, said, kind, given.name)
            return replace(choice, note="; ".join([choice.note, *notes]))
        except SeveralError as several:
            if several.column in ("t", "tau") and how.columns is None and (parts := _tables(names, several.found)):
                return _of_tables(given, names, parts, kind)
            place, note = _settled(given, names, several)
            if place is None:
                raise InputError("FILE", several.reason, several.accepted) from None
            said = ",".join([*([said] if said else []), f"{several.column}={place + 1}"])
            notes.append(note)


def ordered(given: Source, kind: str | None, how: How) -> list[str]:
    """The names; in a file without names, two columns of which one increases are a time and a position; the only column
    of dates is the time, whatever it is called, where no other is."""
    names = list(given.names)
    if given.headed and how.columns is None and len(given.stamped) == 1 and "time" not in map(quantity, names):
        place = next(iter(given.stamped))
        names[place] = f"{names[place]} time"
    live = [place for place, name in enumerate(names) if name]
    if given.headed or kind is not None or how.columns is not None or len(live) != 2:
        return names
    body = given.sample(live)
    with np.errstate(invalid="ignore"):  # two cells beyond the doubles: no step
        steps = [np.diff(body[i]) for i in live]
    rising = [len(step) > 3 and bool((step > 0).all()) for step in steps]
    counted = [bool(np.array_equal(step, np.ones(len(step)))) for step in steps]
    # 0, 1, 2, ... counts turning points or rows as well as seconds: that is asked.
    if (rising == [True, False] and not counted[0]) or (rising == [False, True] and not counted[1]):
        for name, place in (("t", live[rising.index(True)]), ("x", live[rising.index(False)])):
            unit = suffix(names[place])
            names[place] = f"{name} [{unit}]" if unit else name
    return names


def _settled(given: Source, names: Sequence[str], several: SeveralError) -> tuple[int | None, str]:
    """The column that is meant, and why; None where it must be asked."""
    columns = given.read(several.found).columns
    filled = {place: int(np.isfinite(values).sum()) for place, values in columns.items()}
    most = max(filled.values())
    live = {p: x for p, x in columns.items() if filled[p] >= _FILLED * most and most and np.nanmin(x) < np.nanmax(x)}
    axes = _different({p: x for p, x in live.items() if not _DERIVED.search(names[p])} or live, names)
    listed = ", ".join(repr(names[i][:30]) for i in several.found)
    if len(axes) == 1:
        return next(iter(axes)), f"of {listed} it is the only one that changes, or all are equal: --columns overrules"
    if several.column in ("t", "tau"):
        return _clock(axes, names), f"of {listed}, which tell one time, the finest: --columns overrules"
    if not axes or several.column not in ("x", "v", "a"):
        return None, ""
    if len({(quantity(names[i]), suffix(names[i]), bool(_ANGLE.search(names[i]))) for i in axes}) == 1:
        place = carrying(axes)
        place = place if _are_axes([names[i] for i in axes]) else _alone(place, axes)
        return place, f"of {listed} it carries the oscillation (nine tenths of the line): --columns overrules"
    return _angle(axes, names), f"of {listed} it carries the oscillation: --columns overrules"


def _are_axes(names: Sequence[str]) -> bool:
    """Whether names differ in one letter, x, y or z: axes of one body, on which another mode is no other oscillator.

    >>> _are_axes(["gx", "gy"]), _are_axes(["Acc x (g)", "Acc z (g)"]), _are_axes(["x1", "x2"]), _are_axes(["x", "xy"])
    (True, True, False, False)
    """
    first, *others = (name.lower() for name in names)
    differ = [[(a, b) for a, b in zip(first, other) if a != b] for other in others if len(other) == len(first)]
    return len(differ) == len(others) and all(len(d) == 1 and {*d[0]} <= {*"xyz"} for d in differ)


def _alone(place: int | None, axes: dict[int, Array]) -> int | None:
    """The place, unless another axis swings at a frequency of its own, as another oscillator does; None then."""
    lines = {p: line for p, values in axes.items() if (line := line_of(values)) is not None}
    if place is None or place not in lines:
        return place
    main = lines[place]
    for line in lines.values():
        # A tension, or a height, swings twice in a period.
        ratio = max(line.place, main.place) / min(line.place, main.place)
        apart = min(abs(ratio - 1), abs(ratio / 2 - 1)) > max(_SAME, 2 / min(line.place, main.place))
        if apart and line.share > _PURE and line.power > (1 - _SHARE) * main.power:
            return None
    return place


def _different(columns: dict[int, Array], names: Sequence[str]) -> dict[int, Array]:
    """Without columns that repeat an earlier one, perhaps in another unit."""
    found: dict[int, Array] = {}
    for place, values in columns.items():
        size = values * UNITS.get(suffix(names[place]), 1.0)
        known = (x * UNITS.get(suffix(names[p]), 1.0) for p, x in found.items())
        near = _EQUAL * float(np.nanmax(np.abs(size)))
        if not any(np.allclose(size, other, rtol=0, atol=near, equal_nan=True) for other in known):
            found[place] = values
    return found


def _clock(times: dict[int, Array], names: Sequence[str]) -> int | None:
    """Of clocks that run alike the one with the most different stamps, of equals one with a unit."""

    def worth(place: int) -> tuple[int, bool, bool]:
        name = names[place]
        return -len(np.unique(times[place])), suffix(name) not in SECONDS, not _SECONDS.search(name)

    place, *others = sorted(times, key=worth)
    finest, said = times[place], worth(place)
    for other in others:
        both = np.isfinite(finest) & np.isfinite(times[other])
        if both.sum() < 3 or not np.corrcoef(finest[both], times[other][both])[0, 1] > _ALIKE:
            return None
        # Of two clocks in different units, neither of which is named, nobody knows which is in seconds.
        spans = float(np.ptp(finest[both]) / np.ptp(times[other][both]))
        if said == worth(other) and not 0.5 < spans < 2:
            return None
    return place


def _angle(columns: dict[int, Array], names: Sequence[str]) -> int | None:
    """Of quantities of different units the only one that swings, or the angle of the swing that the others show too."""
    lines = {place: line_of(values) for place, values in columns.items()}
    swinging = {place: line.place for place, line in lines.items() if line is not None and line.share > _PURE}
    if len(swinging) == 1:
        return next(iter(swinging))
    angles = [p for p in swinging if suffix(names[p]) in ANGLES or _ANGLE.search(names[p])]
    if len(angles) != 1:
        return None
    main = swinging[angles[0]]
    # A height swings twice in a period.
    ratios = [line / main for line in swinging.values()]
    one = all(min(abs(r - 1), abs(r / 2 - 1)) < max(_SAME, 2 / main) for r in ratios)
    return angles[0] if one else None


def _tables(names: Sequence[str], times: Sequence[int]) -> list[list[int]]:
    """The places of tables beside each other, each with a time and something measured; none if times stand together."""
    parts = [list(range(start, end)) for start, end in zip(times, [*times[1:], len(names)])]
    return parts if times[0] == 0 and all(len(part) > 1 for part in parts) else []


def _of_tables(given: Source, names: Sequence[str], parts: Sequence[Sequence[int]], kind: str | None) -> Choice:
    """The one of several tables that swings; InputError where two do, or one cannot be read."""
    found = {k: _of_one(given, names, part, kind) for k, part in enumerate(parts)}
    measured = {k: c.places[COLUMNS[c.kind][1]] for k, c in found.items()}
    asked = "; or ".join("--columns " + ",".join(f"{c}={p + 1}" for c, p in f.places.items()) for f in found.values())
    listed = ", ".join(repr(names[place]) for place in measured.values())
    columns = given.read(list(measured.values())).columns
    # Each has a clock of its own, hence a line of its own.
    lines = {k: line_of(columns[place][np.isfinite(columns[place])]) for k, place in measured.items()}
    powers = {k: 0.0 if line is None else line.power for k, line in lines.items()}
    best = max(powers, key=lambda k: powers[k])
    alike = len({(c.kind, suffix(names[measured[k]])) for k, c in found.items()}) == 1
    if not alike or not powers[best] > _SHARE * sum(powers.values()) > 0:
        raise InputError("FILE", f"{given.name}: {listed} have a time each and may each be what is measured", asked)
    said = f"of {listed}, each with a time of its own, it carries the oscillation (nine tenths): --columns overrules"
    own = ",".join(f"{c}={p + 1}" for c, p in found[best].places.items())
    choice = choose(names, own, kind, given.name)
    return replace(choice, note=f"{choice.note}; {said}")


def _of_one(given: Source, names: Sequence[str], part: Sequence[int], kind: str | None) -> Choice:
    """The choice in one of the tables, with the places in the whole."""

    def read(wanted: Sequence[int]) -> Body:
        body = given.read([part[i] for i in wanted])
        return replace(body, columns={i: body.columns[part[i]] for i in wanted})

    own = replace(given, names=tuple(names[i] for i in part), headed=True, read=read)
    choice = chosen(own, kind, How())
    return replace(choice, places={c: part[i] for c, i in choice.places.items()})


def read_as(given: Source, choice: Choice) -> str:
    """Which columns were taken, and which of the others swing more; empty for a source that has no others.

    >>> from asymptotics.decays.records.sources import opened
    >>> given = opened({"t": np.arange(9.0), "x (m)": 0.1 * np.ones(9), "Pos": np.cos(np.arange(9))}, How())
    >>> read_as(given, choose(given.names, "t=1,x=2", None, "run.csv"))
    "read as time: 't'; x: 'x (m)'; more swings in 'Pos' (--columns says which is what)"
    """
    taken = set(choice.places.values())
    others = [i for i, name in enumerate(given.names) if i not in taken and quantity(name) not in ("time", "n")]
    if not others:
        return ""
    place = choice.places[COLUMNS[choice.kind][1]]
    columns = given.read([place, *others[:_OTHERS]]).columns
    spread = {i: float(np.nanstd(x)) if np.isfinite(x).any() else 0.0 for i, x in columns.items()}
    more = [repr(given.names[i]) for i in others[:_OTHERS] if spread[i] > 2 * spread[place]]
    names = "; ".join(f"{'time' if c in ('t', 'tau') else c}: {given.names[i]!r}" for c, i in choice.places.items())
    return f"read as {names}" + (f"; more swings in {', '.join(more)} (--columns says which is what)" if more else "")
