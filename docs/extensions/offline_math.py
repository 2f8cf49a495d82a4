"""Formulas as MathML in the page itself: no script, no network."""

from docutils import nodes

from asymptotics.present.mathml import to_mathml


def _inline(self, node):
    self.body.append(to_mathml(node.astext()))
    raise nodes.SkipNode


def _display(self, node):
    self.body.append(f'<div class="math-display">{to_mathml(node.astext().strip(), display=True)}</div>')
    raise nodes.SkipNode


def setup(app):
    """Register the renderer that conf.py asks for."""
    app.add_html_math_renderer("offline_mathml", (_inline, None), (_display, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
