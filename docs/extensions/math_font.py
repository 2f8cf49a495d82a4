"""The mathematical font of the pages: the report's, STIX Two Math cut to what the formulas draw, in the style file."""

import logging
from pathlib import Path

from paper_checks.report.font import font_face

logging.getLogger("fontTools").setLevel(logging.WARNING)  # it tells of each table that it cuts
STYLE = "_static/pages.css"


def _embed(app, error):
    if error is None and app.builder.format == "html":
        folder = Path(app.outdir)
        pages = [path.read_text(encoding="utf-8") for path in sorted(folder.rglob("*.html"))]
        style = folder / STYLE
        own = style.read_text(encoding="utf-8").partition("@font-face")[0]
        style.write_text(own + font_face(pages), encoding="utf-8")


def setup(app):
    """Embedded when all pages are written."""
    app.connect("build-finished", _embed)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
