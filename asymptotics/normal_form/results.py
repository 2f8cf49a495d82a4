"""The results of ``coefficients``: one coefficient, an expansion and a half-swing, as text, JSON and LaTeX.

>>> row = {"1": Coefficient("0.424413181578", 4 / (3 * sympy.pi)), "2": ZERO}
>>> found = ExpansionCoefficients("turning-point", 2, "exact", row, {"2": Coefficient("-0.16", None)})
>>> found.amplitude["1"].exact, found.to_dict()["amplitude"]["2"]
('4/(3*pi)', {'value': '0', 'exact': '0'})
"""

from dataclasses import dataclass, field
from typing import Any

import sympy

from asymptotics.numbers.value import Coefficient

__all__ = ["ZERO", "Coefficient", "ExpansionCoefficients", "HalfSwingCoefficients", "Row", "row_to_dict"]


ZERO = Coefficient("0", sympy.Integer(0))
Row = dict[str, Coefficient]


def row_to_dict(row: Row) -> dict[str, dict[str, str | None]]:
    """A row of coefficients as JSON data."""
    return {key: c.to_dict() for key, c in row.items()}


@dataclass(frozen=True)
class ExpansionCoefficients:
    """p_k (``amplitude``) and Omega_k (``frequency``) for k <= ``order``; keys "k", or "k1,k2" for sums of laws."""

    gauge: str
    order: int
    arithmetic: str
    amplitude: Row
    frequency: Row

    def to_dict(self) -> dict[str, Any]:
        """The coefficients as the JSON of the command line."""
        head = {"gauge": self.gauge, "order": self.order, "arithmetic": self.arithmetic}
        return {**head, "amplitude": row_to_dict(self.amplitude), "frequency": row_to_dict(self.frequency)}

    def latex(self) -> str:
        """The two equations in LaTeX; exact coefficients where known, else their digits."""
        p, Omega = (_latex_sum(row) for row in (self.amplitude, self.frequency))
        return rf"\frac{{dA}}{{d\tau}} = -A\left({p}\right),\quad \frac{{d\psi}}{{d\tau}} = 1 + {Omega}"

    def _repr_latex_(self) -> str:
        return f"${self.latex()}$"


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


def _latex_sum(row: Row) -> str:
    terms = []
    for key, c in row.items():
        powers = [int(k) for k in key.split(",")]
        names = [r"\delta"] if len(powers) == 1 else [rf"\delta_{{{i}}}" for i in range(1, len(powers) + 1)]
        monomial = " ".join(n + (f"^{{{k}}}" if k > 1 else "") for n, k in zip(names, powers) if k)
        number = c.value if c.expression is None else sympy.latex(c.expression)
        terms.append(rf"\left({number}\right) {monomial}")
    return " + ".join(terms) or "0"
