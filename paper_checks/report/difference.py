r"""What a correction changes: the tokens of the corrected formula that the printed one does not have, coloured.

>>> marked(r"e^{\pm 2u}", r"e^{\mp 2u}")
'e^{{\\color{#b45309}\\mp} 2u}'
>>> marked("a+b", r"\frac{1}{4}(a+b)")
'{\\color{#b45309}\\frac{1}{4}(}a+b{\\color{#b45309})}'
"""

import re
from difflib import SequenceMatcher

from asymptotics.present.mathml import mathml

COLOUR = "#b45309"
TOKEN = re.compile(r"\\[A-Za-z]+\s*|\\.|\s+|.", re.DOTALL)


def marked(printed: str, corrected: str) -> str:
    """The corrected formula with what differs from the printed one in colour; unmarked if that cannot be done."""
    if r"\text" in corrected or r"\begin" in corrected:
        return corrected
    before, after = TOKEN.findall(printed), TOKEN.findall(corrected)
    shown = []
    for kind, _, _, start, end in SequenceMatcher(None, before, after, autojunk=False).get_opcodes():
        span = "".join(after[start:end])
        shown.append(span if kind in ("equal", "delete") or not _whole(after, start, end) else _coloured(span))
    formula = "".join(shown)
    return formula if _converts(formula) else corrected


def _whole(tokens: list[str], start: int, end: int) -> bool:
    """Whether a span is a formula by itself: its braces close, it begins and ends with no operator on a neighbour."""
    depth = 0
    for token in tokens[start:end]:
        depth += (token == "{") - (token == "}")
        if depth < 0:
            return False
    first, last = tokens[start], tokens[end - 1].strip()
    following = tokens[end] if end < len(tokens) else ""
    takes_argument = last in (r"\frac", r"\sqrt", r"\left", r"\right", r"\hat", r"\dot", "^", "_")
    return depth == 0 and first not in ("^", "_") and not takes_argument and following not in ("^", "_")


def _coloured(span: str) -> str:
    core = span.rstrip()
    return f"{{\\color{{{COLOUR}}}{core}}}{span[len(core) :]}" if core else span


def _converts(formula: str) -> bool:
    try:
        mathml(formula)
    except Exception:  # noqa: BLE001 (the converter has no error of its own)
        return False
    return True
