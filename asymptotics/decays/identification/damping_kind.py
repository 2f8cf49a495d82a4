"""A table of damping or of a resonance among the data of ``identify``: a kind of its own, with a judge of its own.

What is measured there is the loss at an amplitude, and no decay: the reader is that of all tables, the grades are those
of all laws, and between them stands the linear inverse (``inverse_damping``) in the place of half-swings.

>>> table = {"A": ["0.1", "0.2", "0.4", "0.8"], "zeta": [0.0120, 0.0141, 0.0178, 0.0261]}
>>> law_of_damping(opened(table, How()), {"noise": 2e-4, "laws": ["1", "1+2"]}).best.name
'1+2'
"""

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from asymptotics.decays.identification.damping_columns import is_of_damping, roles
from asymptotics.decays.identification.damping_table import law_of_table
from asymptotics.decays.identification.found_law import DampingLaw
from asymptotics.decays.records.peaks import LEAST, periods_between
from asymptotics.decays.records.sources import How, Source, opened
from asymptotics.decays.records.units import SECONDS, seconds, suffix
from asymptotics.errors import InputError, LimitError
from asymptotics.numbers.policy import exact_number

DAMPING = "damping"
COLUMNS = "A and zeta, Q or decrement (perhaps resolution), or A and force, perhaps omega, phase"
_OF_DECAYS = ("x", "columns", "rate", "springs", "amplitudes", "amplitudes_only")
_NAMES = {"table": "FILE", "resolution": "noise"}
"""Arguments of the judge -> those of ``identify``."""


def opened_once(data: Any, how: How) -> Any:
    """One file, data frame or mapping as a source that can be asked for its names; other data as they are."""
    of_columns = isinstance(data, str | Path | Mapping) or hasattr(data, "read") or hasattr(data, "columns")
    return opened(data, how) if of_columns else data


def is_damping(data: Any, kind: str | None, columns: str | None, omega_0: Any = None) -> bool:
    """Whether it is asked for, or the names of an open source say so where ``columns`` do not say otherwise."""
    said = kind is None and columns is None and isinstance(data, Source)
    return kind == DAMPING or said and (is_of_damping(data.names) or _are_distant(data, omega_0))


def _are_distant(data: Source, omega_0: Any) -> bool:
    """Whether rows are too few amplitudes at times for a decay, and nobody takes them for neighbouring peaks: two
    under the letter A, or a few further apart than the period that is said."""
    found = roles(data.names)
    if sorted(what or "" for what in found) != ["amplitude", "t"]:
        return False
    places = [found.index(what) for what in ("t", "amplitude")]
    some = data.sample(places)
    t, x = (some[place] for place in places)
    if not 2 <= len(x) < LEAST or not (np.diff(x) < 0).all() or not (np.diff(t) > 0).all() or not (x > 0).all():
        return False
    name = data.names[places[0]]
    # In a unit that is not known the reader of tables says what is wrong.
    second = seconds(name, data.name) if suffix(name) in SECONDS else 1.0
    said = None if omega_0 is None else float(omega_0) / (2 * np.pi)
    lettered = re.match(r"A\b", data.names[places[1]].strip()) is not None
    return periods_between(t * second, said) is not None or (len(x) == 2 and lettered and said is None)


def law_of_damping(data: Any, asked: Mapping[str, Any]) -> DampingLaw:
    """The law behind an open table; InputError by name for an option that only a decay has."""
    for name in _OF_DECAYS:
        value = asked.get(name)
        if value is not None and not (isinstance(value, bool | str | tuple | list) and not value):
            raise InputError(
                name, "means nothing for a table of damping", "laws, noise, unit, mass, stiffness, omega_0"
            )
    if asked.get("modes", 1) != 1:
        raise InputError("modes", "a table of damping shows no second mode", "1, or the samples of a motion")
    if not isinstance(data, Source):
        raise InputError("FILE", "several runs are no table of damping", f"one table with columns {COLUMNS}")
    given = {
        n: None if (v := asked.get(n)) is None else exact_number(v, n)
        for n in ("noise", "mass", "stiffness", "omega_0")
    }
    try:
        return law_of_table(
            data, resolution=given["noise"], laws=asked.get("laws"), mass=given["mass"], stiffness=given["stiffness"],
            omega_0=given["omega_0"], unit=asked.get("unit", ""),
        )  # fmt: skip
    except (InputError, LimitError) as error:
        if error.argument not in _NAMES:
            raise
        raise type(error)(_NAMES[error.argument], error.reason, error.accepted) from error
