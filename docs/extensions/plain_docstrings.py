"""Docstrings shown as they are written: they hold formulas in plain text, which no markup language should touch."""


def _literal(app, what, name, obj, options, lines):
    if lines:
        lines[:] = [".. code-block:: text", "", *("    " + line for line in lines), ""]


def setup(app):
    """Listen to autodoc."""
    app.connect("autodoc-process-docstring", _literal)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
