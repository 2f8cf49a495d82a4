"""What the pages show beyond the entries: sections, derivations step by step, and the source of each check."""

import html
import re
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

import sympy

from derivations.__main__ import names
from paper_checks.data import ROOT
from paper_checks.evidence import Difference
from paper_checks.forms import tex
from paper_checks.reader import RELATION, tied
from paper_checks.readings import READINGS
from paper_checks.registry import SECTIONS, Statement
from paper_checks.report.words import typeset

_LONG = 500  # characters of LaTeX that a line has room for


def sections(key: str) -> list[dict[str, str]]:
    """The sections of a paper: the name of the file and the first line of its lesson."""
    found = []
    for name in SECTIONS[key]:
        lesson = (import_module(f"paper_checks.{key}.{name}").__doc__ or "").partition("\n")[0]
        found.append({"name": name, "title": lesson.rstrip(".")})
    return found


def section_of(entry: Statement) -> str:
    """The file in which a statement stands."""
    return str(entry.check.__module__).rpartition(".")[2] if entry.check else ""


@cache
def derivations() -> tuple[dict[str, Any], ...]:
    """All derivations with their steps in LaTeX, run as they are loaded."""
    return tuple(_derivation(name) for name in names())


def _derivation(name: str) -> dict[str, Any]:
    derivation = import_module("derivations." + name.replace("-", "_")).derivation
    steps = [{"reason": step.reason, "latex": step.latex()} for step in derivation.steps]
    return {"name": name, "title": derivation.title, "source": derivation.source, "steps": steps}


def left_side(entry: Statement) -> str:
    r"""The left side and the relation of a printed formula whose right side is the form, as it reads; else nothing.

    >>> from paper_checks.registry import load
    >>> [left_side(load()[key]) for key in ("smith2012:46c", "lancaster2020:6", "smith2012:2")]
    ['u_f = ', '', '']
    """
    found = RELATION.search(entry.latex)
    if found is None or entry.id in READINGS and (READINGS[entry.id].unit or READINGS[entry.id].parts):
        return ""
    left, right = entry.latex[: found.start()], entry.latex[found.end() :]
    several = RELATION.search(right) or "," in re.sub(r"\([^()]*\)|\\[,;:!]", "", right) or r"\text" in entry.latex
    if several or left.count("{") != left.count("}") or not left.strip() or not tied(right, entry.printed, entry.id):
        return ""
    return f"{left.strip()} {found[0]} "


def near_miss(entry: Statement) -> dict[str, str]:
    """The near miss as LaTeX if it is an expression, with what it stands in place of; else as text."""
    form = entry.near_miss
    if isinstance(form, sympy.Expr) and isinstance(entry.printed, sympy.Expr):
        instead = rf"{tex(form)} \quad\text{{in place of}}\quad {tex(entry.printed)}"
        return {"latex": left_side(entry) + instead, "text": ""}
    if isinstance(form, sympy.Basic):
        return {"latex": tex(form), "text": ""}
    if isinstance(form, tuple) and form and all(isinstance(part, sympy.Basic) for part in form):
        return {"latex": r",\quad ".join(tex(part) for part in form), "text": ""}
    if callable(form):
        return {"latex": "", "text": form.__name__.strip("_").replace("_", " ")}
    return {"latex": "", "text": typeset(re.sub(r"Fraction\((-?\d+), (\d+)\)", r"\1/\2", str(form)))}


def apart(found: Difference | None) -> dict[str, str] | None:
    r"""What the check has compared at the near miss, where the two sides differ; long sides by their values alone.

    >>> apart(Difference("2 b", "=", "b", ("0.5", "0.25"), "b = 1/4"))
    {'where': 'b = 1/4', 'latex': '2 b = 0.5 \\neq b = 0.25'}
    """
    if found is None:
        return None
    values = [re.sub(r"e([+-]?\d+)$", r" \\cdot 10^{\1}", value) for value in found.values]
    sides = [found.left, found.right]
    if sum(map(len, sides)) > _LONG and all(values):
        sides = [r"\text{left side}", r"\text{right side}"]
    shown = [f"{side} = {value}" if value and value != side else side for side, value in zip(sides, values)]
    sign = {"=": r"\neq", "<": r"\nless"}[found.relation]
    return {"where": found.where, "latex": f"{shown[0]} {sign} {shown[1]}"}


def source_name(path: str) -> str:
    """The page that shows a source file."""
    return "source-" + path.removeprefix("paper_checks/").removesuffix(".py").replace("/", "-") + ".html"


def source_lines(path: str) -> list[str]:
    """The lines of a source file, ready for a page."""
    return [html.escape(line) for line in Path(ROOT / path).read_text(encoding="utf-8").splitlines()]
