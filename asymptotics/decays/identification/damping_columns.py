"""What the columns of a table of damping are, by their names, and their numbers in plain units.

>>> roles(["theta (deg)", "u(theta)", "zeta [%]", "u(zeta)", "remark"])
['amplitude', None, 'zeta', 'resolution', None]
>>> roles(["A", "sd A", "force", "phi"]), roles(["A", "damping [%]"]), roles(["A", "damping"])
(['amplitude', 'resolution', 'force', None], ['amplitude', 'zeta'], ['amplitude', None])
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from asymptotics.decays.identification.inverse_damping import QUANTITIES
from asymptotics.decays.records.error_names import errors_beside
from asymptotics.decays.records.peaks import numbers_peaks
from asymptotics.decays.records.sources import How, Source, opened
from asymptotics.decays.records.table import units_said
from asymptotics.decays.records.units import UNITS, seconds, suffix
from asymptotics.errors import InputError
from asymptotics.numbers.arrays import real_array
from asymptotics.numbers.quantities import ANGLES

_PERCENT = ("%", "percent", "per cent", "pct", "prozent")
_NAMES = {
    "amplitude": "a, amplitude, mean amplitude, a_mean",
    "zeta": "zeta, \u03b6, damping ratio, damping_ratio, daempfungsgrad, dämpfungsgrad",
    "Q": "q, quality factor, quality_factor, q factor",
    "decrement": "decrement, lambda, log decrement, log_decrement, logarithmic decrement, log dec",
    "resolution": "resolution, sigma, s, uncertainty, error",
    "force": "f, force",
    "omega": "omega, w",
    "phase": "phase, lag",
    "phase_resolution": "phase_resolution, phase resolution, sigma_phase",
    "n": "n",
    "cycles": "cycle, cycles, period, periods, count",
    "t": "t, time, tau",
}
_WORDS = {word: what for what, words in _NAMES.items() for word in words.split(", ")}
_IN_PER_CENT = ("damping", "daempfung", "dämpfung")
"""A damping that is told in per cent is zeta, in those of the critical one."""
_DEFLECTIONS = ("theta", "theta_a", "phi", "phi_a", "\u03b8", "\u03c6", "\u03d5", "angle", "roll", "heel", "x")
"""Amplitudes where a loss at each of them stands beside, and nothing else that is called an amplitude."""
_PER_CENT, _DEGREE = 0.01, UNITS["deg"]
PHASE = ("phase", "phase_resolution")
CLOCKS = ("n", "cycles", "t")
"""Half-swings, periods, or the time: what amplitudes alone stand beside."""


@dataclass(frozen=True)
class Columns:
    """The columns that are used, by what they are, which ``quantity`` there is, and the unit of the amplitudes.

    ``size``: of the unit in which the quantity whose resolution is told stands in the file.
    """

    values: dict[str, Any]
    quantity: str
    notes: tuple[str, ...]
    unit: str
    size: float


def roles(names: Sequence[str]) -> list[str | None]:
    """What each column is; a name of the errors of another one, u(x) or sd x, is the resolution of what is measured."""
    found = ["cycles" if numbers_peaks(name) else _WORDS.get(_plain(name), _in_per_cent(name)) for name in names]
    errors = {place: of for place, of in errors_beside(names).items() if found[place] is None}
    losses = {*QUANTITIES} & {*found}
    if losses and "amplitude" not in found:
        place = next((i for i, name in enumerate(names) if i not in errors and _is_deflection(name)), None)
        if place is not None:
            found[place] = "amplitude"
    measured = next(iter(losses), "amplitude")
    for place, of in errors.items():
        found[place] = {measured: "resolution", "phase": "phase_resolution"}.get(found[of] or "")
    return found


def _in_per_cent(name: str) -> str | None:
    return "zeta" if _plain(name) in _IN_PER_CENT and suffix(name).lower() in _PERCENT else None


def _is_deflection(name: str) -> bool:
    return _plain(name).removesuffix(" angle") in _DEFLECTIONS


def is_of_damping(names: Sequence[str]) -> bool:
    """Whether columns of these names are a table of damping or of a resonance, and can be nothing else.

    A decrement of which no more is said is that of ``identify``, A_n - A_(n+1), and none of ln(A_n/A_(n+2)); beside a
    time, or what has no name here, "a" may be an acceleration and "force" a sensor.

    >>> is_of_damping(["A [deg]", "zeta [%]"]), is_of_damping(["amplitude", "decrement"]), is_of_damping(["t", "A"])
    (True, False, False)
    >>> is_of_damping(["A", "log decrement"]), is_of_damping(["t", "a", "force"]), is_of_damping(["Zeit", "a", "force"])
    (True, False, False)
    """
    found, errors = roles(names), errors_beside(names)
    if "t" in found or any(what is None and place not in errors for place, what in enumerate(found)):
        return False
    logarithmic = any(what == "decrement" and name.strip().lower()[:3] != "dec" for name, what in zip(names, found))
    return "amplitude" in found and (logarithmic or not {"zeta", "Q", "force"}.isdisjoint(found))


def read_columns(table: Any, said: str = "") -> Columns:
    """Of a file, a data frame or a mapping; InputError where no loss stands at an amplitude.

    ``said``: the units of A and of the time, as ``units_said`` reads them, where the columns have none.
    """
    of_a, of_time = units_said(said)
    source = _opened(table)
    names, at = list(source.names), dict[str, int]()
    for place, what in enumerate(roles(names)):
        if what is not None:
            at.setdefault(what, place)
    quantities = [q for q in QUANTITIES if q in at]
    # Without any of them the amplitudes themselves tell the loss, by their numbers or times.
    quantities = quantities or (["force"] if "force" in at else [c for c in CLOCKS if c in at][:1])
    if "amplitude" not in at or len(quantities) != 1:
        reason = "no column A" if "amplitude" not in at else f"{len(quantities)} of the columns zeta, Q, decrement"
        raise InputError(
            "table",
            f"it has {reason}",
            "columns A and one of zeta, Q, decrement (or n, cycles, t of the amplitudes; or force), perhaps resolution",
        )
    kept = {"amplitude", "resolution", *quantities, *(("omega", *PHASE) if quantities == ["force"] else ())}
    at = {what: place for what, place in at.items() if what in kept}
    body = source.read(sorted(at.values()))
    if body.unread.first is not None:
        row, _, cell = body.unread.first
        raise InputError("table", f"{source.name}, row {row + 1}: {cell[:30]!r} is not a number", "numbers")
    columns = {what: body.columns[place] for what, place in at.items()}
    left = [name for place, name in enumerate(names) if place not in at.values()]
    notes = [f"not used: {', '.join(left)}"] if left else []
    name = names[at["amplitude"]]
    unit = suffix(name) or of_a
    if of_a and unit != of_a:
        raise InputError("unit", f"{of_a} contradicts the column {name[:40]}", unit)
    if unit and unit not in UNITS:
        raise InputError("table", f"the unit {unit[:20]!r} of {name[:40]!r} is not known", ", ".join(UNITS))
    if UNITS.get(unit, 1.0) != 1.0:
        notes.append(f"amplitudes in {unit} taken as {'rad' if unit in ANGLES else 'm'}")
    sizes = {what: _size(what, names[place], of_time) for what, place in at.items()}
    if sizes["amplitude"] is None:
        sizes["amplitude"] = UNITS.get(unit)
    measured = quantities[0] if quantities[0] in QUANTITIES else "amplitude"
    for what, of in (("resolution", measured), ("phase_resolution", "phase")):
        # Without a unit of its own an error has that of what it is the error of.
        if what in at and sizes[what] is None:
            sizes[what] = sizes.get(of)
    for what, size in sizes.items():
        if size is not None:
            columns[what] = columns[what] * size
    notes += [f"{names[at[w]]}: per cent" for w in ("zeta", "decrement") if sizes.get(w) == _PER_CENT]
    notes += [f"{names[at[what]]}: degrees" for what in PHASE if what in at and sizes[what] == _DEGREE]
    return Columns(columns, quantities[0], tuple(notes), unit, sizes[measured] or 1.0)


def _size(what: str, name: str, of_time: str = "") -> float | None:
    """The size of the unit in the name of a column; None without one."""
    unit = suffix(name)
    if (unit or name.rpartition("_")[2]).lower() in _PERCENT:
        return _PER_CENT if what in ("zeta", "decrement", "resolution") else None
    if what == "t":
        return seconds(name, "the table", of_time)
    if what in PHASE:
        return _DEGREE if unit in ("deg", "degree", "degrees", "°") else None
    return UNITS.get(unit) if what in ("amplitude", "resolution") else None


def _opened(table: Any) -> Source:
    """The table, named in a refusal by the parameter that gave it; a mapping may hold exact numbers of any kind."""
    if isinstance(table, Mapping):
        rows = {str(name): np.atleast_1d(np.asarray(v, dtype=object)) for name, v in table.items()}
        known = roles(list(rows))
        columns = {n: real_array(list(v), n) if what else v for what, (n, v) in zip(known, rows.items())}
        if len({np.size(values) for values in columns.values()}) > 1:
            raise InputError("table", "its columns differ in length", "columns of one length")
        table = columns
    try:
        return opened(table, How())
    except InputError as error:
        # The reader calls its argument FILE or data; here the caller has written table=.
        if not error.argument.startswith(("FILE", "data")):
            raise
        raise type(error)("table", error.reason, error.accepted) from error


def _plain(name: str) -> str:
    """The name without its unit, written as A [deg], A (mm), A / mm or A_deg, in small letters."""
    plain = re.sub(r"\s*[\[(].*|\s+/\s.*", "", name.strip())
    unit = re.fullmatch(r"(.*)_([^_]+)", plain)
    known = unit and (suffix(plain) or unit[2].lower() in _PERCENT)
    return (unit[1] if unit and known else plain).lower()
