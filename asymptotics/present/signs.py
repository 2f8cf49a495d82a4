r"""ASCII mathematics in printed signs, as HTML: Greek letters, powers raised, indices lowered, no sign of a program.

The text has been escaped before: what is put in are the tags ``sup`` and ``sub``, and signs as entities.  A line that
is a command or a call is left as it is, since it is to be copied.

>>> signs("A = A_0*(epsilon**2*(D**2/90) + 1), sqrt(2), x'|x'|^(1/2) &lt;= omega_0")
"A = A<sub>0</sub> (&epsilon;<sup>2</sup> (D<sup>2</sup>/90) + 1), &radic;2, ... &le; &omega;<sub>0</sub>"
>>> signs("Integral(1/(a + u**2), (u, A, 1))")
'&int;<sub>A</sub><sup>1</sup> 1/(a + u<sup>2</sup>) du'
>>> signs("X_1 + Derivative(X_1(psi), (psi, 2))")
'X<sub>1</sub> + d<sup>2</sup>X<sub>1</sub>(&psi;)/d&psi;<sup>2</sup>'
>>> signs("asymptotics motion --alpha 2"), signs("half_cycle of my_file.csv"), signs("gamma(7/4) tells gamma")
('asymptotics motion --alpha 2', 'half_cycle of my_file.csv', '&Gamma;(7/4) tells &gamma;')
"""

import re
from collections.abc import Callable

_NAMES = (
    "alpha|beta|gamma|delta|epsilon|zeta|theta|kappa|lambda|mu|xi|pi|rho|sigma|tau|phi|chi|psi|omega|Gamma|Delta|Lambda"
    "|Phi|Psi|Omega"
)
_CODE = re.compile(r"\basymptotics \w|\basy\.|--\w|::|https?:")
_GROUP = r"\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\)"  # brackets two deep, which is as deep as exponents go
_WORD = r"(?:\w+(?:_\w+)?|&\w+;)"
_POWER = re.compile(rf"(?:\*\*|\^)({_GROUP}|\{{[^{{}}]*\}}|-?{_WORD}|[+-])")
_INDEX = re.compile(  # of one letter: a number, 2n+1, a letter, a short word; longer names are names
    r"((?<![A-Za-z_])[A-Za-z]'*|&\w+;'*)_"
    r"(\{[^{}]*\}|\([^()]*\)|\d+n(?:\+1)?|\d+(?:,\d+)*|[A-Za-z]|&\w+;|eq|ex|log|max|min)(?![A-Za-z\d_]|\.\w)"
)
_SIGNS = (
    ("&lt;=", "&le;"),
    ("&gt;=", "&ge;"),
    ("-&gt;", "&rarr;"),
    ("&lt;&lt;", "&Lt;"),
    ("!=", "&ne;"),
    ("&#x27;", "'"),
)


def signs(text: str) -> str:
    """The escaped text with its mathematics in signs."""
    if _CODE.search(text):
        return text
    for plain, sign in _SIGNS:
        text = text.replace(plain, sign)
    text = _called(_called(text, "Integral", _integral), "Derivative", _derivative)
    text = re.sub(r"(?<![A-Za-z\d_.&])gamma(?=\()", "&Gamma;", text)
    text = re.sub(rf"(?<![A-Za-z\d_])([A-Za-z]_)({_NAMES})(?![A-Za-z\d;])", r"\1&\2;", text)
    text = re.sub(rf"(?<![A-Za-z\d_.&-])(d?)({_NAMES})(?![A-Za-z\d;])", r"\1&\2;", text)
    text = re.sub(rf"(?<=-)(?<!--)({_NAMES})(?![A-Za-z\d;-])", r"&\1;", text)
    text = re.sub(rf"\bsqrt({_GROUP})", lambda m: "&radic;" + _bare(m[1]), text)
    text = _INDEX.sub(lambda m: f"{m[1]}<sub>{_inner(m[2])}</sub>", text)
    for _ in range(2):  # an exponent may have one of its own
        text = _POWER.sub(lambda m: f"<sup>{_inner(m[1])}</sup>", text)
    return re.sub(r"(?<=[\w)>';])\*(?=[\w(&])", " ", text)


def _inner(group: str) -> str:
    """What stands in an exponent, without the brackets around it."""
    return group[1:-1] if group[0] in "({" else group


def _bare(group: str) -> str:
    """A root of one word needs no brackets."""
    return group[1:-1] if re.fullmatch(_WORD, group[1:-1]) else group


def _called(text: str, name: str, said: Callable[[list[str]], str]) -> str:
    """Each call of this name in other words; the innermost first."""
    while (start := text.rfind(f"{name}(")) >= 0:
        opened = start + len(name)
        end = _closing(text, opened)
        if end is None:
            return text
        text = text[:start] + said(_parts(text[opened + 1 : end])) + text[end + 1 :]
    return text


def _closing(text: str, opened: int) -> int | None:
    """Where the bracket closes that opens here."""
    depth = 0
    for place in range(opened, len(text)):
        depth += {"(": 1, ")": -1}.get(text[place], 0)
        if not depth:
            return place
    return None


def _parts(text: str) -> list[str]:
    """The arguments of a call."""
    parts, depth = [""], 0
    for sign in text:
        depth += {"(": 1, ")": -1}.get(sign, 0)
        parts = [*parts, ""] if sign == "," and not depth else [*parts[:-1], parts[-1] + sign]
    return [part.strip() for part in parts]


def _integral(parts: list[str]) -> str:
    letter, *ends = _parts(parts[-1].strip("()"))
    bounds = f"<sub>{ends[0]}</sub><sup>{ends[1]}</sup>" if len(ends) == 2 else ""
    return f"&int;{bounds} {', '.join(parts[:-1])} d{letter}"


def _derivative(parts: list[str]) -> str:
    letter, *order = _parts(parts[-1].strip("()"))
    times = f"<sup>{order[0]}</sup>" if order else ""
    return f"d{times}{', '.join(parts[:-1])}/d{letter}{times}"
