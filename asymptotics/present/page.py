r"""One page that is complete in itself: plain HTML with its pictures inside, no script, nothing fetched, text escaped.

Formulas are MathML (by latex2mathml, of the extra report), lines of text have their mathematics in signs, and what is
aligned in columns becomes a table.

>>> paragraphs(["n   x", "0   1", "certified: true"])
'<table><tr><td>n</td><td>x</td></tr><tr><td>0</td><td>1</td></tr></table><p>certified: true</p>'
>>> formulas(r"\zeta = \frac{1}{2} \\ Q = 1"), formulas(r"\[ a \] \[ b \]")
(['\\zeta = \\frac{1}{2}', 'Q = 1'], ['a', 'b'])
"""

import re
from collections.abc import Iterable, Sequence
from html import escape
from itertools import groupby
from pathlib import Path
from string import Template

from asymptotics.errors import printable
from asymptotics.present.mathml import mathml
from asymptotics.present.signs import signs

_SHELL = Path(__file__).with_name("page.html")
_LONG = 2000
"""Characters of one text: a cell of a file may be as long as the file."""
_DISPLAYED = re.compile(r"\\\[(.*?)\\\]", re.DOTALL)
_ALIGNED = re.compile(r"\\begin\{aligned\}(.*)\\end\{aligned\}", re.DOTALL)


def page(title: str, body: str) -> str:
    """The page: its title, and what stands on it as HTML."""
    return Template(_SHELL.read_text(encoding="utf-8")).substitute(title=text(title), body=body)


def text(given: str) -> str:
    """Text that HTML shows as it stands."""
    return escape(printable(given, _LONG), quote=True)


def table(head: Sequence[str], rows: Iterable[Sequence[str]], caption: str = "") -> str:
    """A table of texts."""
    cells = "".join("<tr>" + "".join(f"<td>{text(c)}</td>" for c in row) + "</tr>" for row in rows)
    top = "<tr>" + "".join(f"<th>{text(c)}</th>" for c in head) + "</tr>" if any(head) else ""
    return f"<table>{f'<caption>{text(caption)}</caption>' if caption else ''}{top}{cells}</table>"


def paragraphs(lines: Iterable[str]) -> str:
    """Lines of text: paragraphs, and a table of those that follow each other with as many cells (two blanks apart)."""
    cells = [re.split(r" {2,}", line.strip()) for line in lines if line.strip()]
    made = []
    for count, group in groupby(cells, key=len):
        shown = [[signs(text(cell)) for cell in row] for row in group]
        if count == 1:
            made += [f"<p>{row[0]}</p>" for row in shown]
        else:
            rows = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in shown)
            made.append(f"<table>{rows}</table>")
    return "".join(made)


def formulas(latex: str) -> list[str]:
    r"""The single formulas of LaTeX: those between \[ and \], else its lines; an array is one.

    >>> formulas(r"\[ \begin{aligned}&\text{order 0:} && X = 0 \\ &\text{so:} && a = 1\end{aligned} \]")
    ['\\text{order 0:} \\quad X = 0', '\\text{so:} \\quad a = 1']
    """
    if displayed := _DISPLAYED.findall(latex):
        return [each for one in displayed for each in formulas(re.sub(r"\\displaystyle\b", "", one))]
    if aligned := _ALIGNED.search(latex):  # no MathML of latex2mathml: a line each
        rows = (re.sub(r"\s*&+\s*", r" \\quad ", row.strip().lstrip("&")) for row in aligned[1].split("\\\\"))
        return [_unnested(row) for row in rows if row]
    if r"\begin{" in latex:
        return [latex.strip()]
    return [line.strip() for line in latex.split("\\\\") if line.strip()]


def _unnested(latex: str) -> str:
    r"""Mathematics within words stands beside them: latex2mathml takes $ for a letter there."""
    return re.sub(r"\\text\{\$(.*?)\$([^{}]*)\}", r"\1\\text{\2}", latex)


def displayed(latex: str) -> str:
    """Formulas as MathML, one a line; InputError where latex2mathml, of the extra report, is not installed."""
    return "".join(mathml(each, display=True) for each in formulas(latex))


def figure(svg: str, label: str) -> str:
    """A picture in the page itself, without its XML declaration."""
    return f'<figure role="img" aria-label="{text(label)}">{svg[svg.index("<svg") :]}</figure>'
