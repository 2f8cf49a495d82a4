"""Amplitudes as instruments show them: decibels, volts, powers; and the frequency that the lines above them say.

A level of L dB stands for the amplitude 10^(L/20), and so does a power of L dBm; a power in W is the square of one.

>>> amplitudes(np.array([0.0, 20.0]), "dBm"), amplitudes(np.array([4.0]), "mW"), amplitudes(np.array([4.0]), "V")
(array([ 1., 10.]), array([2.]), array([4.]))
>>> [frequency_in([line]) for line in ("% Frequency [Hz]: 151234.5", "f0 = 2,5 kHz", "sampling frequency: 50 Hz")]
[151234.5, 2500.0, None]
"""

import re
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from asymptotics.decays.records.cells import number
from asymptotics.decays.records.rates import HERTZ

Array = NDArray[np.float64]
DECIBELS = ("db", "dbm", "dbv", "dbmv", "dbu", "dbuv", "dbfs", "dbc", "dbw", "dbr")
"""Logarithmic units; what they refer to is a factor, which only the unit of x knows."""
POWERS = ("w", "mw", "uw", "nw", "pw", "kw")
_SAID = re.compile(
    r"\b(?P<name>f_?0|f_?res|frequency|frequenz|freq|fr\u00e9quence)\b\s*[\[(]?(?P<unit>[\w/]*)[\])]?\s*[:=,;\t ]\s*"
    r"(?P<value>\d[\d.,]*(?:[eE][+-]?\d+)?)\s*(?P<after>[\w/]*)",
    re.IGNORECASE,
)


def is_logarithmic(unit: str) -> bool:
    """Whether a unit is a level: equal steps are equal ratios."""
    return unit.lower() in DECIBELS


def amplitudes(values: Array, unit: str) -> Array:
    """The amplitudes behind the values of a column with this unit."""
    if is_logarithmic(unit):
        return np.asarray(10 ** (values / 20))
    return np.asarray(np.sqrt(np.maximum(values, 0.0))) if unit.lower() in POWERS else values


def frequency_in(lines: Sequence[str]) -> float | None:
    """Hertz, where a line says the frequency of what is measured, and not that of the samples."""
    for line in lines:
        found = _SAID.search(line)
        if not found or "sampl" in line[: found.start("name")].lower():
            continue
        text = found["value"].rstrip(".,")
        value = number(text, ".") or number(text, ",")
        size = HERTZ.get((found["unit"] or found["after"] or "hz").lower())
        if value and size:
            return value * size
    return None
