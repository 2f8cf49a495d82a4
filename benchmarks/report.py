"""Tables of ratios as JSON, Markdown and a picture, with the machine and the versions they were measured on."""

import io
import json
import os
import platform
from importlib.metadata import version
from pathlib import Path

from matplotlib.figure import Figure

from asymptotics.made_by import mark
from asymptotics.present.files import write_all
from benchmarks.peers import versions
from benchmarks.table import Table

OURS = ("numpy", "scipy", "sympy", "mpmath", "python-flint")
PEERS = ("heyoka", "oscilate", "asymptotic", "gmpy2", "cypari", "lmfit", "scipy", "mpmath", "sympy")


def write(folder: Path, tables: dict[str, Table], lessons: dict[str, str] | None = None) -> None:
    """``benchmarks.json``, ``.md`` and ``.svg`` in ``folder``, all or none; ``lessons``: a text for each table."""
    folder.mkdir(parents=True, exist_ok=True)
    where = machine()
    data = {"machine": where, "tables": {name: table.to_dict() for name, table in tables.items()}}
    drawn = io.StringIO()
    picture(tables).savefig(drawn, format="svg", metadata={"Date": None})
    contents = {
        "benchmarks.json": json.dumps(data, indent=2) + "\n",
        "benchmarks.md": markdown(tables, where, lessons),
        "benchmarks.svg": drawn.getvalue(),
    }
    write_all({folder / name: content for name, content in contents.items()}, "--report")


def machine() -> dict[str, str]:
    """Processor, system, Python and versions: what a ratio may depend on."""
    processor = platform.processor() or platform.machine()
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.exists():
        names = [line.partition(":")[2].strip() for line in cpuinfo.read_text().splitlines() if "model name" in line]
        processor = names[0] if names else processor
    ours = ", ".join(f"{name} {version(name)}" for name in OURS)
    peers = ", ".join(f"{name} {number}" for name, number in versions(*PEERS).items())
    return {
        "processor": f"{processor}, {os.cpu_count()} cores",
        "system": platform.platform(terse=True),
        "python": platform.python_version(),
        "package": ours,
        "code": mark(),
        "peers": peers or "none installed",
    }


def markdown(tables: dict[str, Table], where: dict[str, str], lessons: dict[str, str] | None = None) -> str:
    """The tables as Markdown, with the picture, what is compared and why, and a list of those who are faster.

    >>> print(markdown({"x": Table("Title", ("what", "ratio"), (("a", "1.0"), ("b", "0.5")))}, {"python": "3"}))
    ---
    orphan: true
    ---
    <BLANKLINE>
    # Speed beside the peers
    <BLANKLINE>
    | | |
    |---|---|
    | python | 3 |
    <BLANKLINE>
    ![Times as ratios to ours](benchmarks.svg)
    <BLANKLINE>
    ## Title
    <BLANKLINE>
    | what | ratio |
    |---|---|
    | a | 1.0 |
    | b | 0.5 |
    <BLANKLINE>
    Faster: b.
    <BLANKLINE>
    """
    lines = [
        "---",
        "orphan: true",
        "---",
        "",
        "# Speed beside the peers",
        "",
    ]
    lines += ["| | |", "|---|---|", *(f"| {k} | {v} |" for k, v in where.items())]
    lines += ["", "![Times as ratios to ours](benchmarks.svg)"]
    for name, table in tables.items():
        cells = [[cell.replace("|", "\\|") for cell in row] for row in table.rows]
        rows = [table.columns, ("---",) * len(table.columns), *cells]
        lesson = (lessons or {}).get(name, "").partition(">>>")[0].strip()
        lines += ["", f"## {table.title}", "", *([lesson, ""] if lesson else [])]
        lines += ["|" + "|".join(row) + "|" if row[0] == "---" else "| " + " | ".join(row) + " |" for row in rows]
        faster = [label for label, value in _ratios(table) if value < 1 and table.rows[0][0] != label]
        lines += ["", f"Faster: {', '.join(faster)}."] if faster else []
    return "\n".join([*lines, ""])


def picture(tables: dict[str, Table]) -> Figure:
    """One panel a table that has ratios: bars on a logarithmic axis, 1 is ours."""
    drawn = {name: _ratios(table) for name, table in tables.items()}
    drawn = {name: ratios for name, ratios in drawn.items() if ratios}
    heights = [len(ratios) + 2 for ratios in drawn.values()] or [1]
    figure = Figure(figsize=(9, 0.2 * sum(heights) + 1), layout="constrained")
    panels = figure.subplots(len(heights), 1, height_ratios=heights, squeeze=False)[:, 0]
    for axes, (name, ratios) in zip(panels, drawn.items()):
        labels = [label for label, _ in ratios]
        axes.barh(range(len(ratios)), [value for _, value in ratios], height=0.7)
        axes.set_yticks(range(len(ratios)), labels, fontsize=7)
        axes.invert_yaxis()
        axes.set_xscale("log")
        axes.axvline(1, color="black", linewidth=0.8)
        axes.set_title(f"{tables[name].title}: time, as a ratio to ours", fontsize=9)
    return figure


def _ratios(table: Table) -> list[tuple[str, float]]:
    """Times of the same work as ours, by ours: the column "ratio" of a table, which is called so for nothing else."""
    if "ratio" not in table.columns:
        return []
    place = table.columns.index("ratio")
    return [(row[0], float(row[place])) for row in table.rows if row[place] not in ("-", "0.0")]
