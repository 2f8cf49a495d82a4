r"""The words of a line in LaTeX: what is mathematics among them, written in plain characters, becomes a formula.

>>> print(worded("So for alpha > 1 a term e w^(alpha-1) falls, int_0^pi s^2 dtheta = pi/2: (13)"))
So for $\alpha > 1$ a term $e w^{\alpha-1}$ falls, $\int_{0}^{\pi} s^{2} d\theta = \pi/2$: (13)
>>> print(formula("M_(3alpha+1) <= w^alpha_1/(2 u'), <|sin|^n> -> infinity"))
M_{3\alpha+1} \le w^{\alpha_{1}}/(2 u'), \langle|\sin|^{n}\rangle \to \infty
"""

import re
from itertools import pairwise
from string import ascii_letters

GREEK = {
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "kappa", "lambda", "mu", "nu", "xi", "pi",
    "rho", "sigma", "tau", "phi", "chi", "psi", "omega", "Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma",
    "Phi", "Psi", "Omega",
}  # fmt: skip
FUNCTIONS = {"sin", "cos", "tan", "cot", "sinh", "cosh", "tanh", "coth", "exp", "ln", "log", "lim", "max", "min"}
FUNCTIONS |= {"arctan", "arcsin", "arccos", "int", "sum", "sup"}
NAMES = {"infinity": r"\infty", "oo": r"\infty", "eps": r"\epsilon", "sgn": r"\operatorname{sgn}"}
NAMES |= {"atan": r"\arctan", "asin": r"\arcsin"}
SIGNS = {
    "<=": r" \le ", ">=": r" \ge ", "!=": r" \ne ", "->": r" \to ", "<<": r" \ll ", ">>": r" \gg ", "+-": r"\pm ",
    "-+": r"\mp ", "...": r"\dots", "…": r"\dots", "{": r"\{", "}": r"\}", "%": r"\%", "&": r"\&", "#": r"\#",
}  # fmt: skip
SPECIAL = {c: "\\" + c for c in "&%$#_{}"}
SPECIAL |= {"\\": r"\textbackslash{}", "^": r"\textasciicircum{}", "~": r"\textasciitilde{}", "…": r"\dots{}"}
SPECIAL |= {"<": "$<$", ">": "$>$", "|": "$|$"}
TOKEN = re.compile(r"[A-Za-z]+|\d+|<=|>=|!=|->|<<|>>|\+-|-\+|\.\.\.|\s+|.")
CLOSING = {"(": ")", "{": "}"}
CITED = re.compile(r"\(*(\(\d+[a-z]?\)(?![\^_/\w(])|\d\d+[a-z]\b|[A-Z]\d[a-z]?$)")
MATHEMATICAL = "|".join(sorted(GREEK | {"int", "sum", "eps"}))
CODE = re.compile(rf"(?!(?:{MATHEMATICAL})_)[a-z]{{3,}}\d*(?:[._:][a-z]+[\w.]*)+|[\w/]+\.py")
DIFFERENTIALS = {"d" + letter for letter in "abcfghklpqrstuvwxyz"}
OPERATOR = re.compile(r"[=<>+*/|-]|<=|>=|!=|->|<<|>>|\+-|-\+")


def formula(text: str) -> str:
    """Mathematics in plain characters as LaTeX for the inside of a formula."""
    tokens = TOKEN.findall(text.strip().replace("**", "^"))
    parts: list[str] = []
    place = 0
    while place < len(tokens):
        token, place = tokens[place], place + 1
        if token in ("_", "^") and parts and tokens[place : place + 1] != ["hat"]:
            inside, place = _script(tokens, place, token)
            parts.append(f"{token}{{{inside}}}")
        elif token == "_" and parts and tokens[place : place + 1] == ["hat"]:
            parts[-1], place = rf"\hat{{{parts[-1].strip()}}}", place + 1
        elif token == "sqrt":
            inside, place = _script(tokens, place, "_")
            parts.append(rf"\sqrt{{{inside}}}")
        elif token == "~" and parts:
            parts[-1] = rf"\tilde{{{parts[-1].strip()}}}"
        elif token in "<>":
            parts.append(_angle(tokens, place))
        elif token == "*":
            operand = place < len(tokens) and (tokens[place].isalnum() or tokens[place] == "(")
            parts.append(" " if operand or not parts else "^{*}")
        else:
            parts.append(_sign(token))
    return re.sub(r" {2,}", " ", _joined(parts)).strip()


def _joined(parts: list[str]) -> str:
    """A command and a letter after it stay two."""
    apart = (b.startswith(tuple(ascii_letters)) and re.search(r"\\[A-Za-z]+$", a) for a, b in pairwise(parts))
    return "".join(part + " " * bool(gap) for part, gap in zip(parts, [*apart, False], strict=True))


def _angle(tokens: list[str], after: int) -> str:
    """A bracket of a mean, or a sign of comparison, which stands between spaces."""
    token = tokens[after - 1]
    before = tokens[after - 2] if after > 1 else " "
    behind = tokens[after] if after < len(tokens) else " "
    if before.isspace() == behind.isspace():
        return token
    return r"\langle" if token == "<" else r"\rangle"


def _script(tokens: list[str], place: int, kind: str) -> tuple[str, int]:
    """What is raised or lowered: a group in brackets, or one sign and one name with its own index."""
    if place >= len(tokens):
        return "", place
    if (close := CLOSING.get(tokens[place])) and (end := _end(tokens, place, close)):
        return formula("".join(tokens[place + 1 : end])), end + 1
    sign = ""
    if tokens[place] in ("+", "-", "−") and place + 1 < len(tokens) and tokens[place + 1].isalnum():
        sign, place = tokens[place], place + 1
    inside, place = sign + _sign(tokens[place]), place + 1
    while kind == "^" and tokens[place : place + 1] == ["'"]:
        inside, place = inside + "'", place + 1
    if kind == "^" and tokens[place : place + 1] == ["_"]:
        index, place = _script(tokens, place + 1, "_")
        inside += f"_{{{index}}}"
    return inside, place


def _end(tokens: list[str], place: int, close: str) -> int:
    """Where the group that begins here ends; 0 if it does not."""
    depth = 0
    for k in range(place, len(tokens)):
        depth += (tokens[k] == tokens[place]) - (tokens[k] == close)
        if depth == 0:
            return k
    return 0


def _sign(token: str) -> str:
    """One name, number or sign."""
    if not token.isalpha():
        return " " if token.isspace() else SIGNS.get(token, token)
    if token in NAMES:
        return NAMES[token]
    if token in GREEK or token in FUNCTIONS:
        return "\\" + token
    if token[0] == "d" and token[1:] in GREEK:
        return "d\\" + token[1:]
    if token.startswith("Delta"):
        return r"\Delta " + token[5:]
    return token if len(token) < 3 else rf"\mathrm{{{token}}}"


def worded(text: str) -> str:
    """A sentence with mathematics in it."""
    words = text.split()
    kinds = [_kind(words, k) for k in range(len(words))]
    shown: list[str] = []
    place = 0
    while place < len(words):
        end = _run(words, kinds, place)
        if end == place:
            shown.append(_prose(words[place]))
            end = place + 1
        else:
            shown.append(_inline(" ".join(words[place:end])))
        place = end
    return " ".join(shown)


def _run(words: list[str], kinds: list[str], place: int) -> int:
    """The end of the formula that begins with this word; the place itself if none does."""
    end, math = place, False
    opened: list[int] = []  # where the brackets stand that are still open
    while end < len(words) and kinds[end] != "prose":
        math |= kinds[end] == "math"
        for c in words[end]:
            if c in "([{":
                opened.append(end)
            elif c in ")]}" and opened:
                opened.pop()
        last, end = words[end], end + 1
        if last[-1] in ";:" or (last[-1] == "." and last != "...") or (last[-1] == "," and not opened):
            break
    if opened and opened[0] > place:  # a bracket of the sentence
        end = opened[0]
    return end if math else place


def _core(word: str) -> str:
    return "..." if word.startswith(("...", "…")) else word.rstrip(".,;:")


def _kind(words: list[str], place: int) -> str:
    """math, prose, or neutral: an operator or a number, which joins the mathematics beside it."""
    core = _core(words[place])
    names = re.findall(r"[A-Za-z]+", core)
    if (
        core == "..."
        or OPERATOR.fullmatch(core)
        or (not names and core.strip("()").isdigit() and not CITED.match(core))
    ):
        return "neutral"
    if core in ("a", "A"):
        return _article(words, place)
    if core == "sum" and place + 1 < len(words) and words[max(place - 1, 0)] not in ("the", "that", "finite"):
        return _kind(words, place + 1)
    if CITED.match(core) or CODE.fullmatch(core) or core in ("", "%", "sum", "I", "i.e", "e.g"):
        return "prose"
    if re.search(r"[_^=<>]|\w\+\w", core) or all(map(_mathematical, names)):
        return "math"
    return "prose"


def _article(words: list[str], place: int) -> str:
    """An a is a letter beside an operator, or after mathematics and before more of it or a verb; else the article."""
    before = words[place - 1] if place else "."
    behind = words[place + 1] if place + 1 < len(words) else "is"
    follows = words[place] != _core(words[place]) or behind in ("is", "and", "obeys") or _kind([behind], 0) != "prose"
    if words[place].startswith("A"):
        return "math" if before[-1] not in ".:" or OPERATOR.fullmatch(_core(behind)) else "prose"
    operators = OPERATOR.fullmatch(before) or OPERATOR.fullmatch(_core(behind))
    joined = before[-1] not in ".,;:" and _kind([before], 0) != "prose" and follows
    return "math" if operators or joined or words[place] != _core(words[place]) else "prose"


def _mathematical(name: str) -> bool:
    if name in GREEK or name in FUNCTIONS or name in NAMES or name == "sqrt" or len(name) == 1:
        return True
    return (name[0] == "d" and name[1:] in GREEK) or (len(name) == 2 and (name[1].isupper() or name in DIFFERENTIALS))


def _inline(run: str) -> str:
    """One formula in a line, without the brackets and the stop that belong to the sentence."""
    core = re.sub(r"(?<![.…])[.,;:]+$|(?<=\.\.\.)[,;:]$|(?<=…)[,;:]$", "", run)
    stop, opened = run[len(core) :], ""
    if core.startswith("(") and core.count("(") > core.count(")"):
        core, opened = core[1:], "("
    if core.endswith(")") and core.count(")") > core.count("("):
        core, stop = core[:-1], ")" + stop
    return f"{opened}${formula(core)}${stop}" if core else opened + stop


def _prose(word: str) -> str:
    """A word of the sentence, with LaTeX's special characters as commands; a Greek letter in it is one."""
    if word == "-":
        return "--"
    if CODE.fullmatch(core := _core(word)):
        shown = "".join(SPECIAL.get(c, c) + r"\allowbreak " * (c in "._/:") for c in core)
        return rf"\texttt{{{shown}}}" + word[len(core) :]
    parts = re.split(rf"(?<![A-Za-z])({'|'.join(sorted(GREEK))})(?![A-Za-z])", word)
    return "".join(rf"$\{part}$" if k % 2 else "".join(SPECIAL.get(c, c) for c in part) for k, part in enumerate(parts))
