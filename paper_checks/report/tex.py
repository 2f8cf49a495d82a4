"""Text for LaTeX: every character that is not plain has its command.

>>> tex("50 % of α ≤ 1")
'50 \\\\% of $\\\\alpha$ $\\\\le$ 1'
"""

import re

_GREEK = (
    r"\alpha", r"\beta", r"\gamma", r"\delta", r"\varepsilon", r"\kappa", r"\mu", r"\pi", r"\tau",
    r"\varphi", r"\psi", r"\omega", r"\Omega",
)  # fmt: skip
_TEX = {c: "\\" + c for c in "&%$#_{}"}
_TEX |= {"\\": r"\textbackslash{}", "^": r"\textasciicircum{}", "~": r"\textasciitilde{}"}
_TEX |= {"−": "$-$", "²": "$^2$", "′": "$'$", "₀": "$_0$", "≤": r"$\le$", "·": r"$\cdot$", "–": "--", "é": "\\'e"}
_TEX |= {c: f"${command}$" for c, command in zip("αβγδεκμπτφψωΩ", _GREEK)}


_NAMES = ("alpha", "beta", "gamma", "delta", "epsilon", "eps", "kappa", "lambda", "mu", "pi", "rho", "sigma", "tau",
          "phi", "psi", "omega", "theta", "Omega")  # fmt: skip
_RAISED = re.compile(r"(\^|_)(\{[^{}]*\}|\([^()]*(?:\([^()]*\)[^()]*)*\)|[-+]?\w+)")
_SIGNS = {"<<": r"$\ll$", ">>": r"$\gg$", "<=": r"$\le$", ">=": r"$\ge$", "!=": r"$\ne$", "->": r"$\to$", "<": "$<$",
          ">": "$>$", "|": "$|$"}  # fmt: skip


def said(text: str) -> str:
    r"""A note as LaTeX: powers raised, indices lowered, Greek letters and relations by their commands.

    >>> print(said("alpha <= 1: e^(-2u) and u_1, |sin|^3 for 50 %"))
    $\alpha$ $\le$ 1: e$^{-2u}$ and u$_{1}$, $|$sin$|$$^{3}$ for 50 \%
    """
    found, rest = [], 0
    for match in _RAISED.finditer(text):
        inside = match[2][1:-1] if match[2][0] in "{(" else match[2]
        found += [_signs(text[rest : match.start()]), f"${match[1]}{{{_inside(inside)}}}$"]
        rest = match.end()
    return "".join([*found, _signs(text[rest:])])


def _inside(text: str) -> str:
    """What stands in an exponent or an index: letters by their commands, with no exponent of their own."""
    text = re.sub(rf"(?<![A-Za-z])({'|'.join(_NAMES)})(?![A-Za-z])", lambda m: _letter(m[1]) + " ", text)
    return text.replace("%", r"\%").replace("&", r"\&").replace("#", r"\#")


def _signs(text: str) -> str:
    names = rf"(?<![A-Za-z])({'|'.join(_NAMES)})(?![A-Za-z])|<<|>>|<=|>=|!=|->|[<>|]"
    pieces, rest = [], 0
    for match in re.finditer(names, text):
        pieces += [tex(text[rest : match.start()]), f"${_letter(match[1])}$" if match[1] else _SIGNS[match[0]]]
        rest = match.end()
    return "".join([*pieces, tex(text[rest:])])


def _letter(name: str) -> str:
    return {"eps": r"\varepsilon", "epsilon": r"\varepsilon"}.get(name, "\\" + name)


def tex(text: object) -> str:
    """The text with LaTeX's special characters and signs written as commands."""
    return "".join(_TEX.get(c, c) for c in str(text))
