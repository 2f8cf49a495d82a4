"""The standard set: every table at 30 digits as CSV, JSON and LaTeX, certificates of turning points, and an index."""

import sys
from pathlib import Path

from tqdm import tqdm

from asymptotics.certificates.certificate import CHECKER
from asymptotics.present.files import require_writable, write_all
from asymptotics.tables.certified import CLAIMS
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
        if name in CLAIMS:
            contents[folder / f"{name}.certificate.json"] = table.certificate().to_json() + "\n"
            contents[folder / CHECKER.name] = CHECKER.read_text(encoding="utf-8")
        tables.append(table)
    # All or none: an index whose digests are those of another run would be worse than an old one.
    write_all({**contents, folder / "index.md": _index(tables)}, "FOLDER")
    return tables


def _index(tables: list[Table]) -> str:
    lines = ["# Reference tables", "", "| table | what | rows | certified | SHA-256 |", "|---|---|---|---|---|"]
    for t in tables:
        more = ("certificate.json",) if t.name in CLAIMS else ()
        files = " ".join(f"[{suffix}]({t.name}.{suffix})" for suffix in ("csv", "json", "tex", *more))
        sha = t.provenance["sha256"][:16]
        lines.append(f"| `{t.name}` {files} | {t.title} | {len(t.rows)} | {str(t.certified).lower()} | {sha}… |")
    lines += ["", f"A certificate is proved by `python {CHECKER.name} FILE`, with nothing but Python."]
    return "\n".join(lines) + "\n"
