"""How a statement is put into words for a referee: its evidence as a sentence, its notes in printed signs.

>>> typeset("alpha >= 1: omega_0 t -> infinity, e^(-b t/2m), x0 != u_1")
'α ≥ 1: ω₀ t → ∞, e^(−b t/2m), x₀ ≠ u₁'
"""

import re
from typing import Any

from markupsafe import Markup, escape

from paper_checks.evidence import ONE_EXAMPLE, READ_OFF

GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "eps": "ε", "kappa": "κ", "lambda": "λ",
    "mu": "μ", "pi": "π", "rho": "ρ", "sigma": "σ", "tau": "τ", "phi": "φ", "psi": "ψ", "omega": "ω", "theta": "θ",
    "eta": "η", "Omega": "Ω",
}  # fmt: skip
SIGNS = (
    ("->", "→"),
    ("<=", "≤"),
    (">=", "≥"),
    ("!=", "≠"),
    ("+-", "±"),
    ("-+", "∓"),
    ("<<", "≪"),
    (">>", "≫"),
    ("sqrt", "√"),
    ("infinity", "∞"),
    ("...", "…"),
)
SUBSCRIPTS = str.maketrans("0123456789n", "₀₁₂₃₄₅₆₇₈₉ₙ")
SUPERSCRIPTS = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
OUTCOMES = {
    "confirmed": "confirmed by the check",
    "refuted": "refuted by the check",
    "undecided": "left undecided by the check",
}


LEGEND = (  # the verdicts: the word, one and several of them, and what they mean
    ("holds", "holds", "hold", "true as printed, under its stated premises"),
    ("misprint", "misprint", "misprints", "the printed form is false; the corrected one, beside it, is true"),
    ("transcription", "transcription slip", "transcription slips",
     "the text at hand has lost or changed signs; what is meant is true"),
    ("partly", "partly true", "partly true",
     "true under a condition that is omitted, or not where it is said to be, or true without following"),
    ("refuted", "refuted", "refuted", "the claim is false; the contrary is proved"),
    ("open", "open", "open", "neither proved nor refuted here; why is said"),
    ("definition", "definition", "definitions", "it fixes a name and claims nothing"),
)  # fmt: skip
_KINDS = {"identity": "an equation", "approximation": "an approximation", "number": "a number", "figure": "a figure",
          "claim": "a claim in the text", "definition": "a definition"}  # fmt: skip


def counted(verdict: str, count: int) -> str:
    """How many statements have a verdict, in words.

    >>> counted("holds", 1), counted("holds", 258), counted("definition", 28), counted("partly", 40)
    ('1 holds', '258 hold', '28 definitions', '40 partly true')
    """
    one, several = next((one, several) for name, one, several, _ in LEGEND if name == verdict)
    return f"{count} {one if count == 1 else several}"


def a_kind(kind: str) -> str:
    """What sort of statement it is, in words."""
    return _KINDS[kind]


def plain_note(note: str) -> str:
    """A note for a reader: what its last sentence calls the form is what the check is given.

    >>> plain_note("True for alpha = 1. Form: the exponent."), plain_note("Form as for fig2.")
    ('True for alpha = 1. What the check is given: the exponent.', 'What the check is given: as for fig2.')
    """
    return re.sub(r"\bForm(?::| (?=as for))", "What the check is given:", note).replace("given:as", "given: as")


def typeset(text: str) -> str:
    """ASCII mathematics in printed signs: Greek letters, relations, simple indices and powers, a true minus."""
    for plain, sign in SIGNS:
        text = text.replace(plain, sign)
    text = re.sub(rf"(?<![A-Za-z])(d?)({'|'.join(GREEK)})(?=\b|_|\d)", lambda m: m[1] + GREEK[m[2]], text)
    text = re.sub(r"(?<=[A-Za-zα-ωΩ])_(\d+|n)(?![\w}])", lambda m: m[1].translate(SUBSCRIPTS), text)
    text = re.sub(r"\b([xv])0\b", r"\1₀", text)
    text = re.sub(r"(?<=[\w)₀-₉'])\^(\d+)(?![\w/(])", lambda m: m[1].translate(SUPERSCRIPTS), text)
    text = text.replace("_hat", "\u0302")  # the accent that combines with the letter before it
    text = re.sub(r"\bint(?=[_₀-₉ ])", "∫", text)
    text = re.sub(r"\bsum(?=_)", "Σ", text)
    return re.sub(r"(?<![\w.)])-(?=[\w(√])|(?<= )-(?=[ .,;])|(?<=[α-ωΩ₀-₉])-(?=\d|[a-zα-ω]\b)", "−", text)


def inline(text: str) -> Markup:
    """The same as HTML: powers raised, indices lowered.

    >>> print(inline("A^(alpha-1) << e^{-2u_1}, F_d, |v|^n"), inline("f_alpha, int_0^pi, C_i^n, alpha-half"), sep="\\n")
    A<sup>α−1</sup> ≪ e<sup>−2u<sub>1</sub></sup>, F<sub>d</sub>, |v|<sup>n</sup>
    f<sub>α</sub>, ∫₀<sup>π</sup>, C<sub>i</sub><sup>n</sup>, α-half
    """
    shown = str(escape(typeset(text)))
    for mark, tag in ((r"(?<=\S)\^", "sup"), (r"(?<![^\W\d_]{2})(?<=[\w∫])_", "sub")):
        bracketed = rf"{mark}(?:\{{([^{{}}]*)\}}|\(((?:[^()]|\([^()]*\))*)\)|([+−-]?(?:[^\W_]+|∞)|[+−-]))"
        for _ in range(2):  # an exponent may have one of its own
            shown = re.sub(bracketed, lambda m, t=tag: f"<{t}>{m[1] or m[2] or m[3]}</{t}>", shown)  # type: ignore[misc]
    return Markup(shown)


def evidence(entry: dict[str, Any]) -> str:
    """What the verdict rests on, as a sentence."""
    kinds = {
        "proved": "Proved, by exact or symbolic computation",
        "certified": "Certified, in ball arithmetic with proved error bounds",
        "measured": "Measured numerically, not proved",
        "none": "No evidence",
    }
    if entry["extent"] in (ONE_EXAMPLE, READ_OFF):  # neither is a measurement, and neither a proof
        parts = [entry["extent"].capitalize()]
    else:
        parts = [kinds[entry["evidence"]], *filter(None, [entry["extent"]])]
    if entry["order"]:
        zero = entry["order"] == "0"
        how = f", {entry['order_by']}" if entry["order_by"] else ""
        parts.append(f"the error does not vanish{how}" if zero else f"error of order {entry['order']}{how}")
    if entry["digits"]:
        parts.append(f"{entry['digits']} digits")
    return "; ".join(parts) + "."
