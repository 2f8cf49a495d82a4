"""What ``coefficients`` and ``closed_forms`` return: the rows of an expansion and of a half-swing.

>>> row = {"1": Coefficient("0.424413181578", 4 / (3 * sympy.pi)), "2": ZERO}
>>> row_to_dict(row)["2"]
{'value': '0', 'exact': '0'}
"""

from dataclasses import dataclass, field
from typing import Any

import sympy

from asymptotics.numbers.value import Coefficient

__all__ = ["ZERO", "Coefficient", "Coefficients", "HalfSwingCoefficients", "Row", "row_to_dict"]


ZERO = Coefficient("0", sympy.Integer(0))
Row = dict[str, Coefficient]


def row_to_dict(row: Row) -> dict[str, dict[str, str | None]]:
    """A row of coefficients as JSON data."""
    return {key: c.to_dict() for key, c in row.items()}


@dataclass(frozen=True)
class Coefficients:
    """p_k (``amplitude``) and Omega_k (``frequency``) for k <= ``order``; keys "k", or "k1,k2" for sums of laws.

    ``arithmetic`` is "exact", "certified", or "symbolic" where the exponent is a symbol: then there are no digits, and
    ``W`` is the rate dtau/dpsi that they come from, ``integrals`` what is no moment.  ``Equations`` is made of them.
    """

    gauge: str
    order: int
    arithmetic: str
    amplitude: Row
    frequency: Row
    W: Row = field(default_factory=dict)
    integrals: dict[str, dict[str, Any]] = field(default_factory=dict)


@dataclass(frozen=True)
class HalfSwingCoefficients:
    """The half-swing map through delta^order: ``map`` and ``V`` have one row per law."""

    order: int
    arithmetic: str
    log_ratio: Row
    map: tuple[Row, ...]
    duration: Row
    U: Row
    V: tuple[Row, ...]
    W: Row
    notes: tuple[str, ...] = field(default=(), compare=False)

    def to_dict(self) -> dict[str, Any]:
        """The coefficients as the JSON of the command line; one law has its rows of map and V directly."""
        data: dict[str, Any] = {"order": self.order, "arithmetic": self.arithmetic}
        data |= {name: row_to_dict(getattr(self, name)) for name in ("log_ratio", "duration", "U", "W")}
        for name in ("map", "V"):
            rows = [row_to_dict(row) for row in getattr(self, name)]
            data[name] = rows[0] if len(rows) == 1 else rows
        return data
