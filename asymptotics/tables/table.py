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
from dataclasses import dataclass, field
from importlib import import_module
from typing import Any

from asymptotics.errors import InputError
from asymptotics.tables.cells import Formula

_ESCAPES = {"_": r"\_", "&": r"\&", "%": r"\%", "#": r"\#", "$": r"\$", "^": r"\^{}", "~": r"\~{}", "{": r"\{",
            "}": r"\}", "\\": r"\textbackslash{}", "<": r"$<$", ">": r"$>$", "|": r"$|$"}  # fmt: skip
_NUMBER = re.compile(r"-?[\d.]+(e-?\d+)?\Z")


@dataclass(frozen=True)
class Table:
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

    def to_json(self) -> str:
        """The same as text."""
        return json.dumps(self.to_dict(), indent=1, ensure_ascii=False) + "\n"

    def to_text(self) -> str:
        """For people."""
        widths = [max(map(len, column)) for column in zip(self.columns, *self.rows)]
        lines = ["  ".join(c.rjust(w) for c, w in zip(row, widths)).rstrip() for row in (self.columns, *self.rows)]
        return "\n".join([self.title, "", *lines, "", self.source, f"certified: {str(self.certified).lower()}"])

    def to_csv(self) -> str:
        """The table as CSV text."""
        text = io.StringIO()
        csv.writer(text, lineterminator="\n").writerows([self.columns, *self.rows])
        return text.getvalue()

    def to_csv_file(self) -> str:
        """CSV with its provenance above, in lines that start with #."""
        return "".join(f"# {line}\n" for line in self._origin_lines()) + self.to_csv()

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
        except ImportError as error:
            accepted = "an installation with the extra parquet: pip install 'power-law-oscillator[parquet]'"
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

    def _repr_latex_(self) -> str:
        rows = r" \\ ".join(" & ".join(map(str, row)) for row in self.rows)
        heads = " & ".join(rf"\text{{{c.replace('_', ' ')}}}" for c in self.columns)
        return rf"$\begin{{array}}{{{'r' * len(self.columns)}}} {heads} \\ \hline {rows} \end{{array}}$"


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
