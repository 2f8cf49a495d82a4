"""Text for LaTeX: every character that is not plain has its command.

>>> tex("50 % of α ≤ 1")
'50 \\\\% of $\\\\alpha$ $\\\\le$ 1'
"""

_GREEK = (
    r"\alpha", r"\beta", r"\gamma", r"\delta", r"\varepsilon", r"\kappa", r"\mu", r"\pi", r"\tau",
    r"\varphi", r"\psi", r"\omega", r"\Omega",
)  # fmt: skip
_TEX = {c: "\\" + c for c in "&%$#_{}"}
_TEX |= {"\\": r"\textbackslash{}", "^": r"\textasciicircum{}", "~": r"\textasciitilde{}"}
_TEX |= {"−": "$-$", "²": "$^2$", "′": "$'$", "₀": "$_0$", "≤": r"$\le$", "·": r"$\cdot$", "–": "--", "é": "\\'e"}
_TEX |= {c: f"${command}$" for c, command in zip("αβγδεκμπτφψωΩ", _GREEK)}


def tex(text: object) -> str:
    """The text with LaTeX's special characters and signs written as commands."""
    return "".join(_TEX.get(c, c) for c in str(text))
