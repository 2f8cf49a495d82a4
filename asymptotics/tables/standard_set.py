"""The standard set: every table at 30 digits as CSV, JSON and LaTeX, and an index."""

import sys
from pathlib import Path

from tqdm import tqdm

from asymptotics.present.files import require_writable, write_all
from asymptotics.tables.registry import build, names
from asymptotics.tables.table import Table

DIGITS = 30


def standard_set(folder: Path, digits: int = DIGITS) -> list[Table]:
    """Write all tables and the index into ``folder``, or nothing; returns the tables."""
    # Proved before the tables are computed.
    require_writable(folder, "FOLDER")
    tables, contents = [], {}
    for name in tqdm(names(), unit="table", disable=not sys.stderr.isatty()):
        table = build(name, digits)
        contents[folder / f"{name}.csv"] = table.to_csv_file()
        contents[folder / f"{name}.json"] = table.to_json()
        contents[folder / f"{name}.tex"] = table.to_latex() + "\n"
        tables.append(table)
    # All or none: an index whose digests are those of another run would be worse than an old one.
    write_all({**contents, folder / "index.md": _index(tables)}, "FOLDER")
    return tables


def _index(tables: list[Table]) -> str:
    lines = ["# Reference tables", "", "| table | what | rows | certified | SHA-256 |", "|---|---|---|---|---|"]
    for t in tables:
        files = " ".join(f"[{suffix}]({t.name}.{suffix})" for suffix in ("csv", "json", "tex"))
        sha = t.provenance["sha256"][:16]
        lines.append(f"| `{t.name}` {files} | {t.title} | {len(t.rows)} | {str(t.certified).lower()} | {sha}… |")
    return "\n".join(lines) + "\n"
