r"""What one can send: a sheet of errata for each paper and a comment on one, as TeX, HTML and, with an engine, PDF.

>>> print(tabular([r"\alpha", "A"], [["1", r"\frac{1}{2}"]]))
\begin{tabular}{ll}\toprule
$\alpha$ & $A$ \\ \midrule
$1$ & $\frac{1}{2}$ \\
\bottomrule\end{tabular}
"""

import os
import shutil
import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jinja2

from asymptotics.motions.invariants.symbolic import generating_function
from asymptotics.tables.registry import build
from paper_checks.errata import harmless, sheets
from paper_checks.registry import load
from paper_checks.verdict import Printed

ENGINE = "pdflatex"
COMMENTED = "smith2012"
LONGEST = 120  # seconds for one document


def sheet_files(template: Callable[[str], jinja2.Template], data: dict[str, Any]) -> dict[str, bytes | str]:
    """The files by their names; ``data`` is that of the report."""
    pdf, made = shutil.which(ENGINE) is not None, {}
    for paper in data["papers"]:
        key = paper["key"]
        shown = {**data, "paper": paper, "sheet": sheets()[key], "harmless": harmless(key), "pdf": pdf}
        made[f"errata-{key}.tex"] = template("errata.tex.j2").render(shown)
        made[f"errata-{key}.html"] = template("errata_sheet.html.j2").render(shown)
        if key == COMMENTED:
            made[f"comment-{key}.tex"] = template("comment.tex.j2").render({**shown, **_comment(key)})
    printed = {name.replace(".tex", ".pdf"): compiled(text) for name, text in made.items() if pdf and ".tex" in name}
    return {**made, **printed}


def _comment(key: str) -> dict[str, Any]:
    """What a comment says beyond the report: statements by their ids, sums over columns, Table I to six digits."""
    table = build(f"{key}.table1", 6)
    rows = [[str(cell) for cell in row] for row in table.rows]
    slips = [entry for entry in load(key).values() if entry.verdict == Printed.MISPRINT]
    return {
        "of": load(key),
        "slips": slips,
        "column": lambda i: generating_function(i).to_dict()["latex"],
        "table": tabular(["n", r"\hat{S}_{n-1}", "u_{n-1}"], rows),
    }


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
