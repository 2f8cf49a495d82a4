"""Formulas as MathML in the page itself: no script, no font, no network."""

from docutils import nodes
from latex2mathml.converter import convert


def _inline(self, node):
    self.body.append(convert(node.astext(), display="inline"))
    raise nodes.SkipNode


def _display(self, node):
    text = node.astext().strip()
    self.body.append('<div class="math-display" style="overflow-x: auto; margin: 1em 0">')
    self.body.append(convert(text, display="block"))
    self.body.append("</div>")
    raise nodes.SkipNode


def setup(app):
    """Register the renderer that conf.py asks for."""
    app.add_html_math_renderer("offline_mathml", (_inline, None), (_display, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
