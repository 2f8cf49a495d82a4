"""The constructs of MathML that the pages use, each with a formula that is drawn and compared.

>>> sorted(occurring("<math><msqrt><mi>x</mi></msqrt><mo stretchy='true'>(</mo></math>"))
['msqrt', 'stretchy (']
"""

import re
from html import unescape
from xml.etree import ElementTree

PLAIN = {"math", "mrow", "mi", "mn", "mo", "mtext", "mspace", "mstyle", "mpadded", "mtr", "mtd"}
LARGE = "∑∫∏⋃⋂"
EXAMPLES = {
    "msqrt": r"\sqrt{2km}",
    "mroot": r"\sqrt[3]{x+1}",
    "mfrac": r"\frac{\Gamma(a)}{\pi+1}",
    "msup": "e^{x}",
    "msub": "x_{0}",
    "msubsup": "A_{n}^{2}",
    "munder": r"\underset{n}{f}",
    "munderover": r"\sum_{n}^{N}a",
    "mover": r"\dot{x}",
    "mtable": r"\begin{matrix}a&b\\c&d\end{matrix}",
    "accent ^": r"\hat{S}",
    "accent ˙": r"\dot{x}",
    "accent ¨": r"\ddot{x}",
    "accent ~": r"\tilde{A}",
    "accent ¯": r"\bar{x}",
    "accent ―": r"\overline{ab}",
    "large ∑": r"\sum a",
    "large ∫": r"\int_{0}^{1}f\,dx",
    "stretchy (": r"\left(\frac{a}{b}\right.",
    "stretchy )": r"\left.\frac{a}{b}\right)",
    "stretchy [": r"\left[\frac{a}{b}\right.",
    "stretchy ]": r"\left.\frac{a}{b}\right]",
    "stretchy |": r"\left|\frac{a}{b}\right.",
    "stretchy {": r"\left\{\frac{a}{b}\right.",
    "stretchy }": r"\left.\frac{a}{b}\right\}",
    "stretchy ⌈": r"\left\lceil\frac{a}{b}\right.",
    "stretchy ⌉": r"\left.\frac{a}{b}\right\rceil",
    "stretchy ⌊": r"\left\lfloor\frac{a}{b}\right.",
    "stretchy ⌋": r"\left.\frac{a}{b}\right\rfloor",
    "stretchy ⟨": r"\left\langle\frac{a}{b}\right.",
    "stretchy ⟩": r"\left.\frac{a}{b}\right\rangle",
}


def formulas(page: str) -> list[str]:
    """The MathML elements of a page."""
    return re.findall(r"<math.*?</math>", page, re.DOTALL)


def occurring(page: str) -> set[str]:
    """The constructs of a page: elements, accents, large operators, brackets that grow."""
    found = set()
    for formula in set(formulas(page)):
        root = ElementTree.fromstring(re.sub(r"&(?!#|amp;|lt;|gt;|quot;)\w+;", lambda m: unescape(m[0]), formula))
        for element in root.iter():
            tag = element.tag.rpartition("}")[2]
            found |= {tag} - PLAIN
            if tag in {"mover", "munder"} and list(element)[1].tag.endswith("mo"):
                sign = (list(element)[1].text or "").strip()
                found |= {f"accent {sign}"} if len(sign) == 1 else set()
            if tag == "mo" and (element.get("stretchy") == "true" or element.get("minsize")) and element.text:
                found.add(f"stretchy {element.text.strip()}")
            if tag == "mo" and (element.text or "").strip() in LARGE and element.text:
                found.add(f"large {element.text.strip()}")
    return {name.replace("stretchy ¯", "accent ¯").replace("stretchy ―", "accent ―") for name in found}


def characters(page: str) -> list[str]:
    """Every visible character of the formulas, once."""
    text = "".join(unescape(re.sub(r"<[^>]*>", "", formula)) for formula in formulas(page))
    return sorted({c for c in text if c.isprintable() and not c.isspace()})
