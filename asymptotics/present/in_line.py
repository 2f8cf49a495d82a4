r"""A formula of LaTeX on one line of a terminal: fractions with a stroke, letters by their names.

>>> print(in_line(r"u_{0} = \frac{2}{7}, \alpha' = \frac{\sqrt{2} + 1}{3}, t \leq \left(2 \pi\right)^{1/2}"))
u_0 = 2/7, alpha' = (sqrt(2) + 1)/3, t <= (2 pi)^(1/2)
"""

import re

_FRACTION = re.compile(r"\\d?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}")
_ROOT = re.compile(r"\\sqrt\s*\{([^{}]*)\}")
_RAISED = re.compile(r"([_^])\{([^{}]*)\}")
_WRAPPED = re.compile(r"\\(?:mathrm|operatorname|text|mathit)\s*\{([^{}]*)\}")
_SIGNS = {r"\leq": "<=", r"\geq": ">=", r"\le": "<=", r"\ge": ">=", r"\neq": "!=", r"\ne": "!=", r"\cdot": "*",
          r"\approx": "~", r"\to": "->", r"\varepsilon": "epsilon", r"\left": "", r"\right": "", r"\,": " ",
          r"\quad": " ", r"\;": " "}  # fmt: skip
_WIDEST = 160
"""Signs; the rest of a longer formula is left out: JSON has it.  A choice."""


def in_line(latex: str) -> str:
    """The formula in plain signs; what has none keeps its name."""
    # SymPy wraps the arguments of a function in braces of their own.
    found, before = re.sub(r"\{\\left\((.*?)\\right\)\}", r"(\1)", latex), ""
    while found != before:  # from the inside out
        before = found
        found = _ROOT.sub(r"sqrt(\1)", found)
        found = _FRACTION.sub(lambda m: f"{_alone(m[1])}/{_alone(m[2])}", found)
        found = _RAISED.sub(lambda m: m[1] + (m[2] if re.fullmatch(r"\w+", m[2]) else f"({m[2]})"), found)
        found = _WRAPPED.sub(r"\1", found)
    found = re.sub(r"\\(?:[A-Za-z]+|[,;])", lambda m: _SIGNS.get(m[0], m[0][1:]), found)
    found = re.sub(r"\s+", " ", found).replace(" )", ")").strip()
    return found if len(found) <= _WIDEST else f"{found[:_WIDEST]} ..."


def _alone(part: str) -> str:
    """A member of a fraction, in brackets where it is more than one sign, number or word."""
    return part if re.fullmatch(r"-?[\w.]+|\\[A-Za-z]+|sqrt\([^()]*\)", part.strip()) else f"({part})"
