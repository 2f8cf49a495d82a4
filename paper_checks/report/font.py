"""The mathematical fonts of the pages, cut down to the characters that the formulas use, and embedded.

DejaVu Serif has the table MATH by which a browser sets fractions, roots and tall brackets; STIX has the italic Greek
letters that it lacks.  Both come with Matplotlib, and both licences (Bitstream Vera; SIL OFL 1.1) allow subsets under
another name.

>>> sorted(map(hex, map(ord, italic("aα1"))))
['0x1d44e', '0x1d6fc']
"""

import io
import re
from base64 import b64encode
from collections.abc import Iterable
from html import unescape
from pathlib import Path

import matplotlib
from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont

FAMILIES = (("Report Math", "DejaVuSerif.ttf"), ("Report Greek", "STIXGeneral.ttf"))
_FOLDER = Path(matplotlib.get_data_path()) / "fonts" / "ttf"
_ITALICS = ((0x41, 0x5A, 0x1D434), (0x61, 0x7A, 0x1D44E), (0x391, 0x3A9, 0x1D6E2), (0x3B1, 0x3C9, 0x1D6FC))
_SPECIAL = {"h": "\u210e", "ϵ": "\U0001d716", "ϕ": "\U0001d719", "∂": "\U0001d715"}
_FAMILY, _FULL, _POSTSCRIPT, _UNIQUE = 1, 4, 6, 3


def font_faces(pages: Iterable[str]) -> str:
    """The CSS rules of the fonts, with all that the formulas on ``pages`` need."""
    formulas = "".join("".join(re.findall(r"<math.*?</math>", page, re.DOTALL)) for page in pages)
    plain = {c for c in unescape(re.sub(r"<[^>]*>", "", formulas)) if c.isprintable()}
    wanted = plain | set(italic("".join(plain)))
    rules = []
    for family, name in FAMILIES:
        data = b64encode(subset(_FOLDER / name, family, wanted)).decode()
        source = f'url("data:font/woff;base64,{data}") format("woff")'
        rules.append(f'@font-face {{ font-family: "{family}"; src: {source}; }}')
    names = ", ".join(f'"{family}"' for family, _ in FAMILIES)
    return "\n".join([*rules, f"math {{ font-family: {names}, math, serif; }}", ""])


def italic(text: str) -> str:
    """The italic letters by which a browser shows single letters in formulas."""
    found = [_SPECIAL[c] for c in text if c in _SPECIAL]
    found += [chr(start + ord(c) - low) for c in text for low, high, start in _ITALICS if low <= ord(c) <= high]
    return "".join(found)


def subset(path: Path, family: str, characters: Iterable[str]) -> bytes:
    """A WOFF file with these characters and what the table MATH makes of them, under the name ``family``."""
    options = Options(layout_features=[], hinting=False, notdef_outline=True, name_IDs=[0, 1, 3, 4, 6, 13])
    options.drop_tables += ["FFTM"]  # the time stamp of FontForge
    font = TTFont(path, recalcTimestamp=False)
    cutter = Subsetter(options)
    cutter.populate(unicodes=[ord(c) for c in characters])
    cutter.subset(font)
    for record in font["name"].names:
        if record.nameID in (_FAMILY, _FULL, _POSTSCRIPT, _UNIQUE):
            record.string = family.replace(" ", "") if record.nameID == _POSTSCRIPT else family
    font.flavor = "woff"
    stream = io.BytesIO()
    font.save(stream)
    return stream.getvalue()
