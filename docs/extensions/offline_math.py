"""Formulas as MathML in the page itself: no script, no network; no line ends inside what is read as one.

>>> context = {"body": '<span class="pre">motion</span> <span class="pre">--bound</span>, <math>x</math>.'}
>>> _kept_whole(None, "", "", context, None)
>>> context["body"]
'<span class="pre">motion</span> <span class="pre whole">--bound</span>, <span class="whole"><math>x</math>.</span>'
>>> context = {"body": "<h1>asymptotics.half_swing<a>"}
>>> _kept_whole(None, "", "", context, None)
>>> context["body"]
'<h1>asymptotics.<wbr>half_<wbr>swing<a>'
"""

import re

from docutils import nodes

from asymptotics.present.mathml import mathml, whole


def _inline(self, node):
    self.body.append(mathml(node.astext()))
    raise nodes.SkipNode


def _display(self, node):
    self.body.append(f'<div class="math-display">{mathml(node.astext().strip(), display=True)}</div>')
    raise nodes.SkipNode


def _kept_whole(app, pagename, templatename, context, doctree):
    """A formula with its punctuation, and an option of the command line, stay on one line; a name ends it at a dot."""
    if "body" in context:
        body = re.sub(r'<span class="pre">(?=--?\w)', '<span class="pre whole">', context["body"])
        body = re.sub(r"<h1>[\w.]+", lambda name: re.sub(r"(?<=[._])(?=\w)", "<wbr>", name[0]), body)
        context["body"] = whole(body)


def setup(app):
    """Register the renderer that conf.py asks for."""
    app.add_html_math_renderer("offline_mathml", (_inline, None), (_display, None))
    app.connect("html-page-context", _kept_whole)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
