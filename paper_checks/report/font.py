"""The mathematical font of the pages: STIX Two Math, cut down to what the formulas draw, and embedded.

A browser draws more than the characters of a formula: the root of ``msqrt``, a minus where a hyphen is typed, a prime
for an apostrophe, italic letters for single ones, smaller primes in superscripts, and of a bracket or a bar that grows
every size and part.  ``drawn`` adds the characters; the subset keeps the tables MATH and GSUB whole for them.

The font comes with ziamath under the SIL OFL 1.1, which allows subsets under another name.

>>> sorted(map(hex, map(ord, italic("aα1"))))
['0x1d44e', '0x1d6fc']
>>> sorted(drawn("<math><msqrt><mo>-</mo><mn>2</mn></msqrt></math>"))
['-', '2', '−', '√']
"""

import io
import re
from base64 import b64encode
from collections.abc import Iterable
from html import unescape
from importlib.util import find_spec
from pathlib import Path

from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont

FAMILY = "Report Math"
_ITALICS = ((0x41, 0x5A, 0x1D434), (0x61, 0x7A, 0x1D44E), (0x391, 0x3A9, 0x1D6E2), (0x3B1, 0x3C9, 0x1D6FC))
_SPECIAL = {"h": "\u210e", "ϵ": "\U0001d716", "ϕ": "\U0001d719", "∂": "\U0001d715"}
_REPLACED = {"-": "−", "'": "′"}  # MathML Core: what a browser draws for these in an operator
_BY_ELEMENT = {"msqrt": "√", "mroot": "√"}
_NAMES = (1, 3, 4, 6)
_POSTSCRIPT = 6


def font_path() -> Path:
    """STIX Two Math, as ziamath carries it."""
    spec = find_spec("ziamath")
    if spec is None or spec.origin is None:
        raise ImportError("the pages need ziamath, which is in the extras report and docs")
    return Path(spec.origin).parent / "fonts" / "STIXTwoMath-Regular.ttf"


def font_face(pages: Iterable[str]) -> str:
    """The CSS rules of the font, with all that the formulas on ``pages`` draw."""
    data = b64encode(subset(drawn("".join(pages)))).decode()
    face = f'@font-face {{ font-family: "{FAMILY}"; src: url("data:font/woff;base64,{data}") format("woff"); }}'
    return f'{face}\nmath {{ font-family: "{FAMILY}", math, serif; }}\n'


def drawn(page: str) -> set[str]:
    """The characters that a browser needs for the formulas of a page: those in the text, and those it draws itself."""
    formulas = "".join(re.findall(r"<math.*?</math>", page, re.DOTALL))
    text = {c for c in unescape(re.sub(r"<[^>]*>", "", formulas)) if c.isprintable() and c != " "}
    own = {sign for tag, sign in _BY_ELEMENT.items() if f"<{tag}" in formulas}
    return text | own | {_REPLACED[c] for c in text if c in _REPLACED} | set(italic("".join(text)))


def italic(text: str) -> str:
    """The italic letters by which a browser shows single letters in formulas."""
    found = [_SPECIAL[c] for c in text if c in _SPECIAL]
    found += [
        chr(start + ord(c) - low)
        for c in text
        for low, high, start in _ITALICS
        if low <= ord(c) <= high and c not in _SPECIAL
    ]
    return "".join(found)


def subset(characters: Iterable[str]) -> bytes:
    """A WOFF file with these characters, the sizes and parts by which they grow, and their smaller forms."""
    options = Options(layout_features=["ssty"], hinting=False, notdef_outline=True, name_IDs=[0, *_NAMES, 13])
    font = TTFont(font_path(), recalcTimestamp=False)
    cutter = Subsetter(options)
    cutter.populate(unicodes=[ord(c) for c in characters])
    cutter.subset(font)
    for record in font["name"].names:
        if record.nameID in _NAMES:
            record.string = FAMILY.replace(" ", "") if record.nameID == _POSTSCRIPT else FAMILY
    font.flavor = "woff"
    stream = io.BytesIO()
    font.save(stream)
    return stream.getvalue()
