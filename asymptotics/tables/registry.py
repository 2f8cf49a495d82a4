"""The tables by name, and the object they come as."""

import csv
import io
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from asymptotics.errors import InputError
from asymptotics.tables.envelope import lancaster_table_1
from asymptotics.tables.quadratic import smith_table_1, transit_time

MAX_DIGITS = 10_000


@dataclass(frozen=True)
class Table:
    """Rows of strings under named columns; ``provenance`` says how the numbers were obtained and proved."""

    name: str
    title: str
    columns: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    provenance: str

    def to_dict(self) -> dict[str, Any]:
        """The table as the JSON of the command line."""
        return {
            "table": self.name,
            "title": self.title,
            "columns": list(self.columns),
            "rows": [list(row) for row in self.rows],
            "provenance": self.provenance,
        }

    def to_csv(self) -> str:
        """The table as CSV text."""
        text = io.StringIO()
        csv.writer(text, lineterminator="\n").writerows([self.columns, *self.rows])
        return text.getvalue()

    def to_latex(self) -> str:
        """The table in LaTeX, with the rules of the booktabs package."""
        lines = [" & ".join(row) + r" \\" for row in (tuple(c.replace("_", r"\_") for c in self.columns), *self.rows)]
        body = "\n".join([lines[0], r"\midrule", *lines[1:]])
        return f"\\begin{{tabular}}{{{'r' * len(self.columns)}}}\n\\toprule\n{body}\n\\bottomrule\n\\end{{tabular}}"

    def _repr_latex_(self) -> str:
        rows = r" \\ ".join(" & ".join(row) for row in self.rows)
        heads = " & ".join(rf"\text{{{c.replace('_', ' ')}}}" for c in self.columns)
        return rf"$\begin{{array}}{{{'r' * len(self.columns)}}} {heads} \\ \hline {rows} \end{{array}}$"


@dataclass(frozen=True)
class _Recipe:
    title: str
    columns: tuple[str, ...]
    rows: Callable[[int], tuple[tuple[str, ...], ...]]
    provenance: str


_RECIPES = {
    "lancaster2020.table1": _Recipe(
        "Lancaster 2020, Table I: the first-order amplitude, and (13) for any alpha",
        ("alpha", "A"),
        lancaster_table_1,
        "exact: the averaged law dA/dtau = -M_(alpha+1) epsilon A^alpha solved in closed form and put into SI units",
    ),
    "smith2012.table1": _Recipe(
        "Smith 2012, Table I: the constants S_n and the turning points u_n for u_0 = 1",
        ("half_cycle", "S_hat", "u"),
        smith_table_1,
        "turning-point equation (43) by the Lambert W map in ball arithmetic; S_n = S - S^-(|u_n|) by (47); "
        "all digits certified",
    ),
    "smith2012.transit-time": _Recipe(
        "Transit time between turning points, omega T / pi = sum of c_i u^i",
        ("i", "c_i"),
        transit_time,
        "exact: c_i = H_i(pi)/pi from the closed forms of Smith's sums; equal to the series of the level integral",
    ),
}


def names() -> dict[str, str]:
    """The names of all tables with their titles."""
    return {name: recipe.title for name, recipe in _RECIPES.items()}


def build(name: str, digits: int = 30) -> Table:
    """Build a table; InputError for an unknown name or digits outside [1, 10000]."""
    if name not in _RECIPES:
        raise InputError("NAME", f"no table {name!r}", ", ".join(_RECIPES))
    if not 1 <= digits <= MAX_DIGITS:
        raise InputError("--digits", f"{digits} is out of range", f"an integer from 1 to {MAX_DIGITS}")
    recipe = _RECIPES[name]
    return Table(name, recipe.title, recipe.columns, recipe.rows(digits), recipe.provenance)
