r"""What one can send: a sheet of errata for each paper and a comment on one, as TeX, HTML and, with an engine, PDF.

A form stands in a column of its own width: a formula breaks where TeX breaks one, a sentence is a sentence.

>>> print(tabular([r"\alpha", "A"], [["1", r"\frac{1}{2}"]]))
\begin{tabular}{ll}\toprule
$\alpha$ & $A$ \\ \midrule
$1$ & $\frac{1}{2}$ \\
\bottomrule\end{tabular}
>>> print(cell(r"\text{the block stops at } x_0 \text{ and } t"), cell(r"x_0 \text{ for } t"), sep="\n")
the block stops at  $x_0$  and  $t$
$\displaystyle x_0 \text{ for } t$
"""

import math
import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Callable
from decimal import Decimal
from pathlib import Path
from typing import Any

import jinja2
import mpmath

from asymptotics.law import Law
from asymptotics.motions.invariants.symbolic import generating_function
from asymptotics.tables.registry import build
from asymptotics.turning.choose import turning_points
from paper_checks.errata import harmless, sheets
from paper_checks.registry import Shortfall, load
from paper_checks.report.tex import tex
from paper_checks.verdict import Kind, Printed

ENGINE = "pdflatex"
COMMENTED = "smith2012"
LONGEST = 120  # seconds for one document


def sheet_files(template: Callable[[str], jinja2.Template], data: dict[str, Any]) -> dict[str, bytes | str]:
    """The files by their names; ``data`` is that of the report."""
    pdf, made = shutil.which(ENGINE) is not None, {}
    for paper in data["papers"]:
        key = paper["key"]
        found = {"sheet": sheets()[key], "harmless": harmless(key), "partly": _partly(key)}
        shown = {**data, "paper": paper, **found, "pdf": pdf}
        made[f"errata-{key}.tex"] = template("errata.tex.j2").render(shown)
        made[f"errata-{key}.html"] = template("errata_sheet.html.j2").render(shown)
        if key == COMMENTED:
            made[f"comment-{key}.tex"] = template("comment.tex.j2").render({**shown, **comment(key)})
    printed = {name.replace(".tex", ".pdf"): compiled(text) for name, text in made.items() if pdf and ".tex" in name}
    return {**made, **printed}


def _partly(key: str) -> str:
    """What of a paper is no slip and yet not true as it stands: the ids, by the way in which."""
    found = {way: [s.id for s in load(key).values() if s.shortfall == way] for way in Shortfall}
    return "; ".join(f"{way}: {', '.join(ids)}" for way, ids in found.items() if ids)


def comment(key: str) -> dict[str, Any]:
    """What a comment says beyond the report: statements by their ids, sums over columns, the period, Table I."""
    slips = [entry for entry in load(key).values() if entry.verdict == Printed.MISPRINT]
    rows = [[row[0], *(_six(cell) for cell in row[1:])] for row in build(f"{key}.table1", 12).rows]
    return {
        "of": load(key),
        "formulas": sum(s.kind != Kind.NUMBER for s in slips),
        "decimals": sum(s.kind == Kind.NUMBER for s in slips),
        "column": lambda i: generating_function(i).to_dict()["latex"].replace(r"\operatorname{atan}", r"\arctan"),
        "second": fraction(build(f"{key}.transit-time", 12).rows[2][1]),
        "astray": f"{astray():.3f}",
        "second_turn": rows[2][2],
        "table": tabular(["n", r"\hat{S}_{n-1}", "u_{n-1}"], rows),
    }


def astray() -> float:
    """u_2 of the orbit from u_0 = 1 by (51) as printed, e^(2u) (2u - 1) = S - S_1, by Lambert's W."""
    (point,) = turning_points(Law({"2": "1"}), 1, 15, start=1).points
    first = float(point.x)
    known = math.exp(2 * first) * (2 * first - 1) / 4
    return float((1 + mpmath.lambertw(known / math.e).real) / 2)


def _six(cell: Any) -> str:
    """A decimal with six places, as Table I has it."""
    return str(Decimal(str(cell)).quantize(Decimal("1.000000"))) if Decimal(str(cell)) else "0"


def fraction(value: Any) -> str:
    r"""1/6 as \tfrac{1}{6}."""
    above, _, below = str(value).partition("/")
    return rf"\tfrac{{{above}}}{{{below}}}" if below else above


def cell(latex: str) -> str:
    """A form in a column: displayed, or as a sentence if it is one."""
    pieces = re.split(r"\\text\{([^{}]*)\}", latex)
    if max((len(words.split()) for words in pieces[1::2]), default=0) < 4:
        return rf"$\displaystyle {latex}$"
    signs = [f"${piece.strip()}$" if piece.strip(" \\") else "" for piece in pieces]
    return " ".join(tex(piece) if n % 2 else signs[n] for n, piece in enumerate(pieces)).strip()


def compiled(text: str) -> bytes:
    """The PDF of a document, the same bytes for the same text; RuntimeError with the end of the log if TeX stops."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "sheet.tex").write_text(text, encoding="utf-8")
        words = [ENGINE, "-interaction=nonstopmode", "-halt-on-error", "-no-shell-escape", "sheet.tex"]
        surroundings = {**os.environ, "SOURCE_DATE_EPOCH": "0", "FORCE_SOURCE_DATE": "1"}
        run = subprocess.run(words, cwd=folder, env=surroundings, capture_output=True, timeout=LONGEST, check=False)
        if run.returncode:
            raise RuntimeError(run.stdout.decode(errors="replace")[-2000:])
        return (Path(folder) / "sheet.pdf").read_bytes()


def tabular(heads: list[str], rows: list[list[Any]]) -> str:
    """A table of formulas as LaTeX."""
    lines = [" & ".join(f"${cell}$" for cell in row) + r" \\" for row in [heads, *rows]]
    return "\n".join([rf"\begin{{tabular}}{{{'l' * len(heads)}}}\toprule", lines[0] + r" \midrule", *lines[1:],
                      r"\bottomrule\end{tabular}"])  # fmt: skip
