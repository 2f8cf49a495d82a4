"""The embedded fonts: every character of the formulas is there, under a name of its own, and nothing else."""

import io
import re
from html import unescape

from fontTools.ttLib import TTFont

from paper_checks.report.font import _FOLDER, FAMILIES, font_faces, italic, subset


def test_every_character_of_a_formula_has_its_glyph(report):
    pages = [path.read_text() for path in report.glob("*.html")]
    formulas = "".join("".join(re.findall(r"<math.*?</math>", page, re.DOTALL)) for page in pages)
    wanted = {c for c in unescape(re.sub(r"<[^>]*>", "", formulas)) if c.isprintable() and c != " "}
    known = set()
    for family, name in FAMILIES:
        font = TTFont(io.BytesIO(subset(_FOLDER / name, family, wanted | set(italic("".join(wanted))))))
        known |= set(map(chr, font.getBestCmap()))
        assert {r.toUnicode() for r in font["name"].names if r.nameID == 1} == {family}
    assert len(wanted) > 60 and wanted <= known
    assert set(italic("axεψ")) <= known and "Ж" not in known


def test_roots_and_brackets_can_grow_and_the_bytes_are_the_same_again():
    family, name = FAMILIES[0]
    once, again = (subset(_FOLDER / name, family, "√(x)") for _ in range(2))
    font = TTFont(io.BytesIO(once))
    assert once == again and "MATH" in font
    grown = font["MATH"].table.MathVariants.VertGlyphCoverage.glyphs
    assert len(grown) >= 3  # the root and both brackets


def test_the_style_sheet_carries_them(report):
    css = (report / "style.css").read_text()
    assert css.count("@font-face") == 2 and "url(http" not in css and len(css) < 400_000
    assert font_faces(["<math><mi>x</mi></math>"]).count("base64") == 2
