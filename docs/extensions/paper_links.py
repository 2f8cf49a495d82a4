"""Names of derivations and ids of statements, wherever they stand as code, lead to their place in the report beside.

``make reproduce`` writes the report to ``build/report``, ``make docs`` the pages to ``build/docs``: links are relative.
"""

from docutils import nodes

from asymptotics.papers.lookup import statements
from derivations.__main__ import names

STATEMENTS = {statement.id: f"{statement.paper}.html#{statement.id}" for statement in statements()}
TARGETS = STATEMENTS | {name: f"derivations.html#{name}" for name in names()}


def _link(app, doctree, docname):
    if app.builder.format != "html":
        return
    root = "../" * (docname.count("/") + 1)
    for code in list(doctree.findall(nodes.literal)):
        target = TARGETS.get(code.astext())
        if target and not isinstance(code.parent, nodes.reference):
            code.replace_self(nodes.reference("", "", code.deepcopy(), refuri=f"{root}report/{target}", internal=False))


def setup(app):
    """When a page is about to be written."""
    app.connect("doctree-resolved", _link)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
