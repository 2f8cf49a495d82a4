"""The embedded font: every character that the formulas draw is there, under a name of its own, and nothing else."""

import io

from fontTools.ttLib import TTFont

from paper_checks.report.font import FAMILY, drawn, font_face, font_path, subset


def test_every_character_of_a_formula_has_its_glyph(report):
    wanted = drawn("".join(path.read_text() for path in report.glob("*.html")))
    font = TTFont(io.BytesIO(subset(wanted)))
    known = set(map(chr, font.getBestCmap()))
    assert {r.toUnicode() for r in font["name"].names if r.nameID == 1} == {FAMILY}
    assert len(wanted) > 60 and wanted <= known
    assert set("√−′𝑎𝑥𝜀𝜓") <= known and "Ж" not in known


def test_the_table_of_a_subset_is_that_of_the_font_and_the_bytes_are_the_same_again():
    once, again = (subset("√(x)∑") for _ in range(2))
    font, whole = TTFont(io.BytesIO(once)), TTFont(font_path())
    assert once == again
    constants = [vars(each["MATH"].table.MathConstants) for each in (font, whole)]
    plain = [{k: getattr(v, "Value", v) for k, v in each.items()} for each in constants]
    assert plain[0] == plain[1] and plain[0]["SuperscriptShiftUp"] > 0 and plain[0]["SubscriptShiftDown"] > 0
    grown = font["MATH"].table.MathVariants
    assert {"radical", "parenleft", "parenright", "summation"} <= set(grown.VertGlyphCoverage.glyphs)
    assert len(font.getGlyphOrder()) > 30  # sizes and parts: the signs themselves are five


def test_the_style_sheet_carries_it(report):
    css = (report / "style.css").read_text()
    assert css.count("@font-face") == 1 and "url(http" not in css and len(css) < 400_000
    assert font_face(["<math><mi>x</mi></math>"]).count("base64") == 1
