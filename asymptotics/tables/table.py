"""A table and the forms it is written in; every number is text, and nothing is lost on the way.

======== =============================================================================================
text     aligned columns, title above, source below
csv      RFC 4180; in a file the provenance stands above in lines that start with #
json     the schema is ``schema.json`` beside this module
latex    a tabular that needs no package, provenance as comments
parquet  all columns strings, provenance in the metadata of the schema (needs the extra parquet)
======== =============================================================================================
"""

import csv
import io
import json
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from importlib import import_module
from typing import Any

from asymptotics.certificates.certificate import Certificate
from asymptotics.errors import InputError
from asymptotics.numbers.digits import spread
from asymptotics.numbers.policy import Number
from asymptotics.present.drawn import Drawn
from asymptotics.present.shown import Page, Rows
from asymptotics.running.public import public
from asymptotics.tables.cells import Formula
from asymptotics.tables.certified import of_rows
from asymptotics.tables.validation import Validation, validate

# TeX's ten special characters, and those that the usual text fonts do not have.
_ESCAPES = {"_": r"\_", "&": r"\&", "%": r"\%", "#": r"\#", "$": r"\$", "^": r"\^{}", "~": r"\~{}", "{": r"\{",
            "}": r"\}", "\\": r"\textbackslash{}", "<": r"$<$", ">": r"$>$", "|": r"$|$"}  # fmt: skip
_NUMBER = re.compile(r"-?[\d.]+(e-?\d+)?\Z")
_INTERVAL = re.compile(r"\[-?[\d.]+(e-?\d+)?, -?[\d.]+(e-?\d+)?\]\Z")


@dataclass(frozen=True, repr=False)
class Table(Rows, Drawn):
    """Rows of strings under named columns.

    ``keys`` are the columns that say which row it is, ``source`` is one sentence on the route, ``certified`` whether
    every digit is proved, and ``origin`` the provenance: inputs, versions, commit, SHA-256.
    """

    name: str
    title: str
    columns: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    source: str
    certified: bool
    keys: tuple[str, ...] = ()
    units: tuple[str, ...] = ()
    origin: dict[str, Any] = field(default_factory=dict)

    @property
    def provenance(self) -> dict[str, Any]:
        """Where the numbers come from and what proves them."""
        return self.origin

    def to_dict(self) -> dict[str, Any]:
        """The table as the JSON of the command line."""
        return {
            "table": self.name,
            "title": self.title,
            "columns": list(self.columns),
            "units": list(self.units),
            "keys": list(self.keys),
            "rows": [[str(cell) for cell in row] for row in self.rows],
            "certified": self.certified,
            "provenance": self.origin,
        }

    @public
    def validate(self, digits: int = 60, *, max_seconds: Number = 60) -> Validation:
        """The table recomputed by mpmath alone, beside ours; InputError where mpmath has no route of its own."""
        nearest = self.origin.get("inputs", {}).get("rounding", "nearest") == "nearest"
        return validate(self.name, self.columns, self.rows, digits, nearest=nearest)

    @public
    def certificate(self, *, max_seconds: Number = 60) -> Certificate:
        """A file from which ``check_certificate.py`` proves the rows that are turning points or times.

        InputError for a table without any, and for another rounding than to the nearest.
        """
        inputs = self.origin.get("inputs", {})
        if inputs.get("rounding", "nearest") != "nearest":
            raise InputError("certificate", "the checker proves numbers rounded to the nearest", "--rounding nearest")
        return of_rows(self.name, self.columns, self.rows, int(inputs["digits"]))

    def to_json(self) -> str:
        """The table as the text of a JSON file."""
        return json.dumps(self.to_dict(), indent=1, ensure_ascii=False) + "\n"

    def to_text(self) -> str:
        """The table as aligned text for people, with its source and its label."""
        widths = [max(map(len, column)) for column in zip(self.columns, *self.rows)]
        lines = ["  ".join(c.rjust(w) for c, w in zip(row, widths)).rstrip() for row in (self.columns, *self.rows)]
        return "\n".join([self.title, "", *lines, "", self.source, f"certified: {str(self.certified).lower()}"])

    def to_csv(self) -> str:
        """The table as CSV text."""
        text = io.StringIO()
        columns = [_ends(name, [row[i] for row in self.rows]) for i, name in enumerate(self.columns)]
        spread_out = [column for pair in columns for column in pair]
        csv.writer(text, lineterminator="\n").writerows(zip(*spread_out))
        return text.getvalue()

    def to_csv_file(self) -> str:
        """Provenance in lines that start with #, then CSV; ``pandas.read_csv(FILE, comment="#")`` reads it."""
        lines = (*self._origin_lines(), 'to read it: pandas.read_csv(FILE, comment="#")')
        return "".join(f"# {line}\n" for line in lines) + self.to_csv()

    def to_latex(self) -> str:
        """The table as a LaTeX tabular."""
        heads = [rf"\textbf{{{escaped(name)}}}" for name in self.columns]
        lines = [" & ".join(row) + r" \\" for row in (heads, *([_in_latex(cell) for cell in row] for row in self.rows))]
        comments = [f"% {line}" for line in self._origin_lines()]
        body = "\n".join([lines[0], r"\hline", *lines[1:]])
        return "\n".join([*comments, rf"\begin{{tabular}}{{{'r' * len(self.columns)}}}", r"\hline", body, r"\hline",
                          r"\end{tabular}"])  # fmt: skip

    def to_parquet(self) -> bytes:
        """The table as a Parquet file; InputError without the extra parquet."""
        try:
            arrow, parquet = import_module("pyarrow"), import_module("pyarrow.parquet")  # an extra, slow to import
        except ModuleNotFoundError as error:  # any other ImportError is a fault, or want of memory
            accepted = "an installation with the extra parquet: pip install '.[parquet]' in a clone"
            raise InputError("format", "parquet needs pyarrow, which is not installed", accepted) from error
        columns = {name: [str(row[i]) for row in self.rows] for i, name in enumerate(self.columns)}
        schema = arrow.schema([(name, arrow.string()) for name in self.columns])
        metadata = {"title": self.title, "provenance": json.dumps(self.origin)}
        stream = io.BytesIO()
        parquet.write_table(arrow.table(columns, schema=schema.with_metadata(metadata)), stream)
        return stream.getvalue()

    def _origin_lines(self) -> list[str]:
        texts = {name: value if isinstance(value, str) else json.dumps(value) for name, value in self.origin.items()}
        return [f"{self.name}: {self.title}", *(f"{name}: {text}" for name, text in texts.items())]

    def _page(self) -> Page:
        heads = tuple(f"{c} [{u}]" if u not in ("", "1") else c for c, u in zip(self.columns, self.units))
        worth = f"certified: {str(self.certified).lower()} ({self.source})"
        return Page(self.title, (worth,), heads or self.columns, self.rows)

    def _curve(self, axes: Any, **style: Any) -> None:
        """The columns of numbers against the last key that is a number, or against the row; ``columns`` chooses."""
        rows = {name: cells for name, cells in self._table().items() if not name.endswith(("_low", "_high", "_digits"))}
        numbers = {name: cells for name, cells in rows.items() if all(isinstance(c, int | float) for c in cells if c)}
        keys = [name for name in self.columns if name in self.keys and name in numbers]
        wanted = style.pop("columns", None) or [name for name in numbers if name not in self.keys]
        unknown = [name for name in wanted if name not in numbers]
        if unknown or not wanted:
            raise InputError("columns", f"there is no column of numbers {unknown[:1]}", ", ".join(numbers) or "none")
        place = numbers[keys[-1]] if keys else list(range(1, len(self.rows) + 1))
        for name in wanted:
            own = {"marker": "o", "markersize": 3, "linewidth": 0.8, "label": name}
            axes.plot(place, numbers[name], **{**own, **style})
        axes.set(xlabel=keys[-1] if keys else "row", ylabel=wanted[0] if len(wanted) == 1 else "value")

    def _table(self) -> dict[str, list[Any]]:
        found: dict[str, list[Any]] = {}
        # Half a unit to either side holds the value for correct rounding alone; rounded down or up it lies to one side,
        # and the ends would be wrong.
        rounded = self.certified and self.origin.get("inputs", {}).get("rounding") == "nearest"
        for i, name in enumerate(self.columns):
            found |= _numbers(name, [row[i] for row in self.rows], key=name in self.keys, certified=rounded)
        return found

    def _formula(self) -> str:
        rows = r" \\ ".join(" & ".join(map(str, row)) for row in self.rows)
        heads = " & ".join(rf"\text{{{c.replace('_', ' ')}}}" for c in self.columns)
        return rf"\begin{{array}}{{{'r' * len(self.columns)}}} {heads} \\ \hline {rows} \end{{array}}"


def _numbers(name: str, cells: Sequence[str], *, key: bool, certified: bool) -> dict[str, list[Any]]:
    """The columns of a data frame for one column: numbers with their ends, both ends of intervals, else text."""
    filled = [cell for cell in cells if cell]
    # Eighteen digits fit into 64 bits.  A column of values with gaps becomes one of doubles, as pandas would make of
    # it.
    if filled and all(re.fullmatch(r"-?\d{1,18}", cell) for cell in filled) and (key or len(filled) == len(cells)):
        return {name: [int(cell) if cell else None for cell in cells]}
    if key or not all(_NUMBER.match(cell) or _INTERVAL.match(cell) for cell in filled):
        return {name: [str(cell) for cell in cells]}
    if any(_INTERVAL.match(cell) for cell in filled):
        ends = [cell.strip("[]").split(", ") if cell else ["nan"] for cell in cells]
        return {f"{name}_low": [float(e[0]) for e in ends], f"{name}_high": [float(e[-1]) for e in ends]}
    return spread(name, [cell or None for cell in cells], certified=certified)


def _ends(name: str, cells: Sequence[str]) -> list[list[str]]:
    """A column with its name; intervals as two columns of numbers."""
    if not any(_INTERVAL.match(cell) for cell in cells):
        return [[name, *cells]]
    # A cell that is no interval stands in both columns: its ends are one number.
    pairs = [cell.strip("[]").split(", ") for cell in cells]
    return [[f"{name}_low", *(p[0] for p in pairs)], [f"{name}_high", *(p[-1] for p in pairs)]]


def escaped(text: str) -> str:
    """Text for LaTeX: every character that means something to TeX, escaped.

    >>> escaped("p_1 & 50%")
    'p\\\\_1 \\\\& 50\\\\%'
    """
    return "".join(_ESCAPES.get(c, c) for c in text)


def _in_latex(cell: str) -> str:
    if isinstance(cell, Formula):
        return f"${cell.latex}$"
    return f"${cell}$" if _NUMBER.match(cell) else escaped(cell)
