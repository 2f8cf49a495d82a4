"""The page to play with beside the pages of the docs: play.html, one file with its script inside."""

from pathlib import Path

from paper_checks.report.play import play_page

LINKS = (("Documentation", "index.html"), ("The papers, checked", "../report/index.html"))


def _write(app, error):
    if error is None and app.builder.format == "html":
        (Path(app.outdir) / "play.html").write_text(play_page(LINKS), encoding="utf-8")


def setup(app):
    """Written when the other pages are."""
    app.connect("build-finished", _write)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
