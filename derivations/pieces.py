r"""A formula in LaTeX as its pieces, and how wide they are, for the lines of a display.

>>> [node.kind for node in parse(r"- a_{1} + \frac{1}{2} \left(b - c\right)^{2} = d,\quad e")]
['atom', 'atom', 'sign', 'fraction', 'fence', 'relation', 'atom', 'comma', 'atom']
"""

import re
from collections.abc import Iterable
from dataclasses import dataclass, field

RELATIONS = {"=", "<", ">", ":=", r"\neq", r"\le", r"\leq", r"\geq"}
ARGUMENT = {r"\sqrt", r"\operatorname", r"\hat", r"\substack", r"\tilde", r"\overline", r"\text", r"\mathrm"}
TOKEN = re.compile(r":=|\\[A-Za-z]+|\\.|[A-Za-z]+|\d+|\s+|.", re.DOTALL)
WIDE = {r"\quad": 10.0, r"\qquad": 20.0, r"\int": 9.5, r"\sum": 14.5, r"\limits": 0.0, r"\,": 1.7, r"\ ": 3.4}
WIDE |= {"(": 5.0, ")": 5.0, "[": 5.0, "]": 5.0, "|": 4.0, ".": 2.8, ",": 4.5, " ": 0.0, "{": 0.0, "}": 0.0}
NAMED = re.compile(r"\\(sin|cos|tan|cot|sinh|cosh|tanh|log|ln|exp|lim|max|min)$")


@dataclass
class Node:
    """A piece of a formula: ``kind`` is atom, sign, relation, comma, fence or fraction; ``inside`` what can be opened.

    A fence has its brackets in ``ends``; a fraction is [numerator, denominator]; ``script`` are indices and powers.
    """

    kind: str
    text: str
    inside: list[list["Node"]] = field(default_factory=list)
    ends: tuple[str, str] = ("", "")
    script: list[tuple[str, list["Node"]]] = field(default_factory=list)

    def width(self, level: int = 0) -> float:
        """In points at 10 pt, by the mean width of a character; ``level`` is that of TeX's style, 0 for a display."""
        scale = (1.0, 1.0, 0.75, 0.6)[min(level, 3)]
        raised = max((width(nodes, level + 2) for _, nodes in self.script), default=0.0)
        if self.kind == "fraction":
            return max(width(part, level + 1) for part in self.inside) + 3.0 + raised
        if self.inside:  # brackets and what is in them, or an argument
            return (13.0 if self.kind == "fence" else 9.0) * scale + width(self.inside[0], level) + raised
        return scale * _plain_width(self.kind, self.text) + raised


def width(nodes: Iterable[Node], level: int = 0) -> float:
    """Of a sequence, in points."""
    return sum(node.width(level) for node in nodes)


def _plain_width(kind: str, text: str) -> float:
    if kind in ("sign", "relation"):
        return 13.5
    if kind == "comma":
        return 5.0
    if text in WIDE:
        return WIDE[text]
    if name := NAMED.match(text):
        return 5.2 * len(name[1]) + 2.0
    if text.startswith("\\"):
        return 8.0 if text[1:2].isupper() else 6.5
    return sum(7.5 if c.isupper() else 5.6 for c in text)


def parse(latex: str) -> list[Node]:
    """The pieces of a formula; ValueError where something does not close."""
    tokens = [token for token in TOKEN.findall(latex) if not token.isspace()]
    nodes = _sequence(tokens)
    if tokens:
        raise ValueError(f"not balanced from {tokens[:3]} on: {latex}")
    return nodes


def _sequence(tokens: list[str]) -> list[Node]:
    """Up to the end, or to a closing brace or bracket, which stays."""
    nodes: list[Node] = []
    while tokens and tokens[0] not in ("}", r"\right"):
        token = tokens.pop(0)
        if token in "^_" and nodes:
            nodes[-1].script.append((token, _group(tokens)))
        elif token == "{":
            tokens.insert(0, token)
            nodes += _group(tokens)
        elif token == r"\left":
            nodes.append(_fence(tokens))
        elif token == r"\frac":
            nodes.append(Node("fraction", token, [_group(tokens), _group(tokens)]))
        elif token in ARGUMENT:
            nodes.append(Node("atom", token, [_group(tokens)]))
        elif token == "," and tokens[:1] in ([r"\quad"], [r"\ "]):
            nodes.append(Node("comma", "," + tokens.pop(0)))
        else:
            nodes.append(Node(_kind(token, nodes), token))
    return nodes


def _kind(token: str, before: list[Node]) -> str:
    if token in RELATIONS:
        return "relation"
    binary = bool(before) and before[-1].kind not in ("sign", "relation", "comma")
    return "sign" if token in ("+", "-") and binary else "atom"


def _group(tokens: list[str]) -> list[Node]:
    """What stands in braces, or the next token alone."""
    if not tokens:
        raise ValueError("a command without its argument")
    if (token := tokens.pop(0)) != "{":
        return [Node("atom", token)]
    nodes = _sequence(tokens)
    if tokens[:1] != ["}"]:
        raise ValueError("a brace is not closed")
    tokens.pop(0)
    return nodes


def _fence(tokens: list[str]) -> Node:
    opening = tokens.pop(0)
    inside = _sequence(tokens)
    if tokens[:1] != [r"\right"]:
        raise ValueError(r"\left without \right")
    tokens.pop(0)
    return Node("fence", "", [inside], (opening, tokens.pop(0)))


def written(nodes: list[Node]) -> str:
    """Pieces as LaTeX."""
    return " ".join(_text(node) for node in nodes)


def _text(node: Node) -> str:
    parts = [written(nodes) for nodes in node.inside]
    if node.kind == "fraction":
        shown = r"\frac{" + "}{".join(parts) + "}"
    elif node.kind == "fence":
        shown = rf"\left{node.ends[0]} {parts[0]} \right{node.ends[1]}"
    else:
        shown = node.text + "".join(f"{{{part}}}" for part in parts)
    return shown + scripts(node)


def scripts(node: Node) -> str:
    """Index and power of a piece as LaTeX."""
    return "".join(f"{token}{{{written(nodes)}}}" for token, nodes in node.script)
