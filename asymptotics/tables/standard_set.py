"""The standard set: every table at 30 digits as CSV, JSON and LaTeX, certificates of turning points, and an index."""

import sys
from dataclasses import replace
from pathlib import Path

from tqdm import tqdm

from asymptotics.certificates.certificate import CHECKER
from asymptotics.present.files import require_writable, write_all
from asymptotics.tables.certified import CLAIMS
from asymptotics.tables.registry import build, description, names
from asymptotics.tables.table import Table
from asymptotics.tables.validation import ROUTES

DIGITS = 30


def standard_set(folder: Path, digits: int = DIGITS) -> list[Table]:
    """Write all tables and the index into ``folder``, or nothing; returns the tables."""
    # Proved before the tables are computed.
    require_writable(folder, "FOLDER")
    tables, contents = [], {}
    for name in tqdm(names(), unit="table", disable=not sys.stderr.isatty()):
        table = with_validation(build(name, digits))
        contents[folder / f"{name}.csv"] = table.to_csv_file()
        contents[folder / f"{name}.json"] = table.to_json()
        contents[folder / f"{name}.tex"] = table.to_latex() + "\n"
        if name in CLAIMS:
            contents[folder / f"{name}.certificate.json"] = table.certificate().to_json() + "\n"
            contents[folder / CHECKER.name] = CHECKER.read_text(encoding="utf-8")
        tables.append(table)
    # All or none: an index whose digests are those of another run would be worse than an old one.
    write_all({**contents, folder / "index.md": _index(tables)}, "FOLDER")
    return tables


def with_validation(table: Table) -> Table:
    """The table whose provenance says that mpmath alone has recomputed it, or which route the tests compare it with.

    >>> with_validation(build("phase-lags", 5)).provenance["validation"]
    'recomputed by mpmath ... to 60 digits: equal'
    """
    return replace(table, origin={**table.origin, "validation": validated(table)})


def validated(table: Table) -> str:
    """What is under a reference table."""
    if table.name in ROUTES:
        return str(table.validate())
    return f"not by mpmath alone; the tests obtain it again by this route: {description(table.name)['check']}"


def _index(tables: list[Table]) -> str:
    lines = ["# Reference tables", "", "| table | what | rows | certified | mpmath alone | SHA-256 |",
             "|---|---|---|---|---|---|"]  # fmt: skip
    for t in tables:
        more = ("certificate.json",) if t.name in CLAIMS else ()
        files = " ".join(f"[{suffix}]({t.name}.{suffix})" for suffix in ("csv", "json", "tex", *more))
        sha = t.provenance["sha256"][:16]
        cells = (f"`{t.name}` {files}", t.title, len(t.rows), str(t.certified).lower(), _found(t), f"{sha}…")
        lines.append(f"| {' | '.join(map(str, cells))} |")
    lines += ["", f"A certificate is proved by `python {CHECKER.name} FILE`, with nothing but Python."]
    return "\n".join(lines) + "\n"


def _found(table: Table) -> str:
    return str(table.provenance["validation"]).partition(" by ")[2] if table.name in ROUTES else "no"
