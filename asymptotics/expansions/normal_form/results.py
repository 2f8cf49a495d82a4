"""What ``coefficients`` and ``closed_forms`` return: the rows of an expansion and of a half-swing.

>>> row = {"1": Coefficient("0.424413181578", None), "2": ZERO}
>>> row_to_dict(row)["2"]
{'value': '0', 'exact': '0'}
"""

from dataclasses import dataclass, field
from typing import Any

from asymptotics.errors import InputError
from asymptotics.expansions.normal_form.show import sum_latex
from asymptotics.numbers.gamma_sums import GammaSum
from asymptotics.numbers.value import Coefficient, coefficient_columns
from asymptotics.present.drawn import Drawn
from asymptotics.present.shown import Page, Rows

__all__ = ["ZERO", "Coefficient", "Coefficients", "HalfSwingCoefficients", "Row", "row_to_dict"]


# For a smooth line on the page: no number is read off it.
_POINTS = 401
ZERO = Coefficient("0", GammaSum())
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


@dataclass(frozen=True, repr=False)
class HalfSwingCoefficients(Rows, Drawn):
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
    forces: tuple[str, ...] = field(default=(), compare=False)

    def _named(self) -> list[tuple[str, str, Coefficient]]:
        rows = {"L": self.log_ratio, "T": self.duration, "U": self.U, "W": self.W}
        for name, several in (("F", self.map), ("V", self.V)):
            rows |= {name + (f"_{i}" if len(several) > 1 else ""): row for i, row in enumerate(several, start=1)}
        return [(name, key, c) for name, row in rows.items() for key, c in row.items()]

    def _page(self) -> Page:
        rows = tuple((name, key, c, c.exact or "") for name, key, c in self._named() if not c.is_zero)
        worth = f"{self.arithmetic} coefficients of powers of delta; no bound on the remainder"
        head = ("series", "power", "value", "exact")
        law = f" of {', '.join(self.forces)}" if self.forces else ""
        return Page(f"the half-swing{law} through order {self.order}", (worth, *self.notes), head, rows)

    def _curve(self, axes: Any, **style: Any) -> None:
        """A'/A against the local strength, the last two orders of ln(A'/A); for one law."""
        import numpy as np  # noqa: PLC0415 (a fifth of the time of a command that draws nothing)

        powers = {tuple(map(int, key.split(","))): float(c.text()) for key, c in self.log_ratio.items()}
        if any(len(key) > 1 for key in powers):
            raise InputError("plot", "a sum of laws has several local strengths", "one law")
        last = style.pop("until", 0.5)
        delta = np.linspace(0.0, float(last), _POINTS)
        # Two orders in one picture: where they part the truncated series tells nothing any more.
        for order in range(self.order, max(0, self.order - 2), -1):
            size = np.exp(sum((c * delta**k for (k,), c in powers.items() if k <= order), 0.0 * delta))
            own = style if order == self.order else {"linestyle": "--", "linewidth": 1.0}
            axes.plot(delta, size, **{"label": f"order {order}", **own})
        axes.set(xlabel=r"local strength $\delta$", ylabel="A'/A of one half-swing", ylim=(0, None))

    def _table(self) -> dict[str, list[Any]]:
        named = self._named()
        columns = {"series": [name for name, _, _ in named], "power": [key for _, key, _ in named]}
        return columns | coefficient_columns([c for _, _, c in named])

    def _formula(self) -> str:
        return rf"L = {_latex(self.log_ratio)},\quad T = {_latex(self.duration)}"

    def to_dict(self) -> dict[str, Any]:
        """The coefficients as the JSON of the command line; one law has its rows of map and V directly."""
        data: dict[str, Any] = {"order": self.order, "arithmetic": self.arithmetic}
        data |= {name: row_to_dict(getattr(self, name)) for name in ("log_ratio", "duration", "U", "W")}
        for name in ("map", "V"):
            rows = [row_to_dict(row) for row in getattr(self, name)]
            data[name] = rows[0] if len(rows) == 1 else rows
        return data


def _latex(row: Row) -> str:
    """The sum in LaTeX, in delta or in delta_1, delta_2, ..."""
    keyed = {tuple(map(int, key.split(","))): c for key, c in row.items()}
    count = max(map(len, keyed), default=1)
    return sum_latex(keyed, [r"\delta" if count == 1 else rf"\delta_{{{i}}}" for i in range(1, count + 1)])
