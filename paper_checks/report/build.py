"""Write the report: all contents are made in memory first, then each file appears whole."""

import json
from collections import Counter
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import jinja2

from asymptotics import __version__
from asymptotics.present.figures import render
from asymptotics.present.files import write_all
from asymptotics.present.mathml import to_mathml
from asymptotics.tables import build
from asymptotics.verdict import Printed
from paper_checks.registry import PAPERS, Entry
from paper_checks.report.engine import engine_data, regimes_picture, validity_picture

Progress = Callable[[str], None]

TABLES = {
    "lancaster2020": ("lancaster2020.table1",),
    "smith2012": ("smith2012.table1", "smith2012.transit-time"),
}
PAGES = ("index.html", "errata.html", "engine.html")
SLIPS = (Printed.MISPRINT, Printed.TRANSCRIPTION, Printed.PARTLY, Printed.REFUTED)


def write_report(folder: Path, entries: list[Entry], progress: Progress = lambda name: None) -> list[Path]:
    """Write the pages, report.json, report.tex and the figures into ``folder``, which exists; returns the paths."""
    contents = dict(_figures(entries, progress))
    data = report_data(entries)
    contents["report.json"] = json.dumps(data, indent=1, ensure_ascii=False)
    contents["report.tex"] = _template("report.tex.j2").render(data)
    contents |= _pages(data, contents)
    write_all({folder / name: content for name, content in contents.items()}, "--report")
    return [folder / name for name in contents]


def _pages(data: dict[str, Any], figures: dict[str, bytes | str]) -> dict[str, str]:
    """The site: an index of all statements, a page for each paper, the errata, and what goes beyond the papers."""
    shown = {"figures": figures, "validity": validity_picture(), "regimes": regimes_picture()}
    pages = {name: _template(f"{name}.j2").render(data, **shown) for name in PAGES}
    paper = _template("paper.html.j2")
    return pages | {f"{p['key']}.html": paper.render(data, paper=p, figures=figures) for p in data["papers"]}


def report_data(entries: list[Entry]) -> dict[str, Any]:
    """Everything the report says, as plain data."""
    return {
        "command": "paper_checks",
        "version": __version__,
        "summary": dict(Counter(str(e.printed) for e in entries)),
        "engine": engine_data(),
        "papers": [_paper(key, [e for e in entries if e.statement.paper == key]) for key in _papers(entries)],
    }


def _paper(key: str, entries: list[Entry]) -> dict[str, Any]:
    return {
        "key": key,
        "name": key[:-4].capitalize() + " " + key[-4:],
        "reference": PAPERS[key][0],
        "summary": dict(Counter(str(e.printed) for e in entries)),
        "entries": [e.to_dict() for e in entries],
        "slips": [e.statement.id for e in entries if e.printed in SLIPS],
        "disagreements": [e.statement.id for e in entries if not e.agrees],
        "tables": [build(name, 30).to_dict() for name in TABLES.get(key, ())],
        "figures": [
            {"name": name, "file": f"{key}-{name}", "statement": _statement_of(key, name, entries), "caption": text}
            for name, (text, _) in _pictures(key).items()
        ],
    }


def _statement_of(key: str, figure: str, entries: list[Entry]) -> str:
    """The statement that a picture belongs to: its own id, or for a panel (fig1a) that of the whole figure (fig1)."""
    ids = {e.statement.id for e in entries}
    return f"{key}:{figure}" if f"{key}:{figure}" in ids else f"{key}:{figure[:-1]}"


def _papers(entries: list[Entry]) -> list[str]:
    return [key for key in PAPERS if any(e.statement.paper == key for e in entries)]


def _pictures(key: str) -> dict[str, tuple[str, Callable[[Any], Any]]]:
    return dict(import_module(f"paper_checks.{key}.figures").FIGURES)


def _figures(entries: list[Entry], progress: Progress) -> Iterator[tuple[str, bytes | str]]:
    for key in _papers(entries):
        for name, (_, draw) in _pictures(key).items():
            yield f"{key}-{name}.svg", render(draw).decode()
            yield f"{key}-{name}.png", render(draw, kind="png")
            progress(f"{key} {name}")


def _template(name: str) -> jinja2.Template:
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(Path(__file__).parent),
        autoescape=name.endswith(".html.j2"),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["inline_mathml"] = to_mathml
    environment.filters["mathml"] = lambda latex: to_mathml(latex, display=True)
    environment.filters["tex"] = lambda text: "".join(_TEX.get(c, c) for c in str(text))
    environment.filters["inline"] = lambda svg: svg[svg.index("<svg") :]
    return environment.get_template(name)


_GREEK = (
    r"\alpha", r"\beta", r"\gamma", r"\delta", r"\varepsilon", r"\kappa", r"\mu", r"\pi", r"\tau",
    r"\varphi", r"\psi", r"\omega", r"\Omega",
)  # fmt: skip
_TEX = {c: "\\" + c for c in "&%$#_{}"}
_TEX |= {"\\": r"\textbackslash{}", "^": r"\textasciicircum{}", "~": r"\textasciitilde{}"}
_TEX |= {"−": "$-$", "²": "$^2$", "′": "$'$", "₀": "$_0$", "≤": r"$\le$", "·": r"$\cdot$", "–": "--", "é": "\\'e"}
_TEX |= {c: f"${command}$" for c, command in zip("αβγδεκμπτφψωΩ", _GREEK)}
