"""What the pages show beyond the entries: sections, derivations step by step, and the source of each check."""

import html
import re
from fractions import Fraction
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

import sympy

from derivations.__main__ import names
from paper_checks.data import ROOT
from paper_checks.displays import RELATION
from paper_checks.evidence import Difference
from paper_checks.forms import DECIMAL, tex
from paper_checks.near_misses import LEFT, WORDS
from paper_checks.reader import tied
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
    r"""The near miss with what it stands in place of: as LaTeX, with its left side, or in words.

    >>> from paper_checks.registry import load
    >>> for key in ("smith2012:60b", "lelas2024:24", "lelas2024:4"):
    ...     print(" ".join(near_miss(load()[key]).values()).strip())
    f_{2} = \frac{w}{3} \quad\text{in place of}\quad \frac{2 w}{3}
    \mathrm{v1}:\quad - f g m \mu \omega_{0} s^{2} x_{0} \quad\text{in place of}\quad - f g m \mu \omega_{0} s x_{0}
    sgn 0 = 1, in place of 0
    """
    form, right = entry.near_miss, entry.printed if entry.corrected is None else entry.corrected
    if entry.id in WORDS:
        return {"latex": "", "text": typeset(WORDS[entry.id])}
    left = LEFT.get(entry.id, "")
    if isinstance(form, sympy.Basic):
        shown = (left or left_side(entry)) + _instead(form, right if entry.printed is None else entry.printed)
    else:
        shown = left + (_parts(form, right) if isinstance(form, tuple) else _instead(form, right))
    return {"latex": shown, "text": ""}


def _instead(form: Any, right: Any) -> str:
    return _formula(form) + (rf" \quad\text{{in place of}}\quad {_formula(right)}" if right is not None else "")


def _parts(form: tuple[Any, ...], right: Any) -> str:
    """Where the forms have the same parts, those that differ, behind what names them; else all of both."""
    if not isinstance(right, tuple) or len(right) != len(form):
        return _instead(form, right)
    if isinstance(form[-1], dict):  # a polynomial: its number and its coefficients
        return f"f_{{{form[0]}}} = " + _instead(form[1], right[1])
    apart = [_instead(a, b) for a, b in zip(form, right) if a != b]
    named = [
        f"{_formula(a)}:" for a, b in zip(form, right) if a == b and isinstance(a, str) and not DECIMAL.fullmatch(a)
    ]
    return r"\quad ".join([*named, r";\quad ".join(apart)])


def _formula(form: Any) -> str:
    """A part of a form as LaTeX: an expression, a number, a name, a polynomial in w, or several of them."""
    if isinstance(form, dict):
        return tex(sum(sympy.Rational(c.numerator, c.denominator) * sympy.Symbol("w") ** n for n, c in form.items()))
    if isinstance(form, tuple):
        return r",\quad ".join(map(_formula, form))
    if isinstance(form, str):
        return form.replace("-", "- ") if DECIMAL.fullmatch(form) else rf"\mathrm{{{form}}}"
    if isinstance(form, Fraction):
        return tex(sympy.Rational(form.numerator, form.denominator))
    return tex(form) if isinstance(form, sympy.Basic) else str(form)


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
