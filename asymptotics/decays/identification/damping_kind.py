"""A table of damping or of a resonance among the data of ``identify``: a kind of its own, with a judge of its own.

What is measured there is the loss at an amplitude, and no decay: the reader is that of all tables, the grades are those
of all laws, and between them stands the linear inverse (``inverse_damping``) in the place of half-swings.

>>> table = {"A": ["0.1", "0.2", "0.4", "0.8"], "zeta": [0.0120, 0.0141, 0.0178, 0.0261]}
>>> law_of_damping(opened(table, How()), {"noise": 2e-4, "laws": ["1", "1+2"]}).best.name
'1+2'
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from asymptotics.decays.identification.damping_columns import is_of_damping
from asymptotics.decays.identification.damping_table import law_of_table
from asymptotics.decays.identification.found_law import DampingLaw
from asymptotics.decays.records.sources import How, Source, opened
from asymptotics.errors import InputError, LimitError
from asymptotics.numbers.policy import exact_number

DAMPING = "damping"
COLUMNS = "A and zeta, Q or decrement (perhaps resolution), or A and force, perhaps omega, phase"
_OF_DECAYS = ("x", "unit", "columns", "rate", "springs", "amplitudes", "amplitudes_only", "omega_0")
_NAMES = {"table": "FILE", "resolution": "noise"}
"""Arguments of the judge -> those of ``identify``."""


def opened_once(data: Any, how: How) -> Any:
    """One file, data frame or mapping as a source that can be asked for its names; other data as they are."""
    of_columns = isinstance(data, str | Path | Mapping) or hasattr(data, "read") or hasattr(data, "columns")
    return opened(data, how) if of_columns else data


def is_damping(data: Any, kind: str | None, columns: str | None) -> bool:
    """Whether it is asked for, or the names of an open source say so where ``columns`` do not say otherwise."""
    said = kind is None and columns is None and isinstance(data, Source)
    return kind == DAMPING or said and is_of_damping(data.names)


def law_of_damping(data: Any, asked: Mapping[str, Any]) -> DampingLaw:
    """The law behind an open table; InputError by name for an option that only a decay has."""
    for name in _OF_DECAYS:
        value = asked.get(name)
        if value is not None and not (isinstance(value, bool | str | tuple | list) and not value):
            raise InputError(name, "means nothing for a table of damping", "laws, noise, mass, stiffness")
    if asked.get("modes", 1) != 1:
        raise InputError("modes", "a table of damping shows no second mode", "1, or the samples of a motion")
    if not isinstance(data, Source):
        raise InputError("FILE", "several runs are no table of damping", f"one table with columns {COLUMNS}")
    given = {n: None if (v := asked.get(n)) is None else exact_number(v, n) for n in ("noise", "mass", "stiffness")}
    try:
        return law_of_table(
            data, resolution=given["noise"], laws=asked.get("laws"), mass=given["mass"], stiffness=given["stiffness"]
        )
    except (InputError, LimitError) as error:
        if error.argument not in _NAMES:
            raise
        raise type(error)(_NAMES[error.argument], error.reason, error.accepted) from error
