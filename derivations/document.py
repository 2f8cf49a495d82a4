r"""Derivations as a LaTeX document that stands alone: it needs amsmath and geometry, no font and no picture.

>>> print(display("a + b = c"))
\[ a + b = c \]
>>> print(display(" + ".join(24 * ["a"]) + " = c"))
\begin{align*}
& a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a + a \\
& \qquad + a \\
& \quad = c
\end{align*}
"""

from collections.abc import Iterable
from typing import TYPE_CHECKING

from derivations.breaking import broken
from derivations.words import worded

if TYPE_CHECKING:
    from derivations.steps import Derivation

PREAMBLE = r"""\documentclass[a4paper]{article}
\usepackage{amsmath}
\usepackage[margin=25mm]{geometry}
\allowdisplaybreaks
\setlength{\parindent}{0pt}
\sloppy
\begin{document}"""


def document(derivations: Iterable["Derivation"]) -> str:
    """The sections of some derivations, in one document."""
    return "\n\n".join([PREAMBLE, *map(section, derivations), r"\end{document}"])


def section(derivation: "Derivation") -> str:
    """Title, source, and the lines with their numbers."""
    parts = [
        rf"\section*{{{worded(derivation.title)}}}",
        rf"\texttt{{asymptotics derive {derivation.name}}}",
        rf"\emph{{{worded(derivation.source)}}}",
    ]
    for number, step in enumerate(derivation.steps, 1):
        parts.append(rf"{number}.\quad {worded(step.reason)}" + "\n" + display(step.latex()))
    return "\n\n".join(parts)


def display(latex: str) -> str:
    """A formula on a line of its own, or on several where it is too wide."""
    lines = broken(latex)
    if len(lines) == 1:
        return rf"\[ {lines[0]} \]"
    rows = " \\\\\n".join(f"& {line}" for line in lines)
    return f"\\begin{{align*}}\n{rows}\n\\end{{align*}}"
