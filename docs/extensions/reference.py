"""One page for each name of ``docs/api.md``: its docstring, set by Sphinx's autodoc and napoleon.

Docstrings are plain text: ``code`` is the only markup, and what is indented (formulas, tables, examples of the shell)
stands as it is written.
"""

import inspect
import re
from pathlib import Path

import asymptotics
from asymptotics.running.signature import readable

NAMES = re.compile(r"^reference/([\w.]+)$", re.MULTILINE)
SECTION = re.compile(r"^-{3,}$")


def path_of(name):
    """Where autodoc finds a name of api.md: asymptotics.motion, or a name with its module."""
    return f"asymptotics.{name}"


def page(name):
    """The page of one name as reStructuredText."""
    title = path_of(name)
    last = title.rpartition(".")[2]
    kind = "class" if last[0].isupper() and inspect.isclass(thing(name)) else "function"
    options = (
        "   :members:\n   :inherited-members: tuple, BaseException\n   :undoc-members:\n" if kind == "class" else ""
    )
    return f"{title}\n{'=' * len(title)}\n\n.. auto{kind}:: {title}\n{options}"


def thing(name):
    module, _, last = name.rpartition(".")
    return getattr(__import__(f"asymptotics.{module}", fromlist=[last]) if module else asymptotics, last)


def plain(lines):
    r"""The lines of a docstring as markup: sections and examples as they are, formulas laid out, prose escaped.

    >>> plain(["a_b of ``x_1``:", "", "    a*b", "", "Raises", "------", "InputError", "    for a_b > 1"])
    ['a\\_b of ``x_1``:', '', '::', '', '    a*b', '', 'Raises', '------', 'InputError', '    for a\\_b > 1']
    """
    made, laid_out, sections, example = [], False, False, False
    for number, line in enumerate(lines):
        sections = sections or any(SECTION.match(each) for each in lines[number + 1 : number + 2])
        example = line.startswith(">>>") or example and bool(line.strip())
        indented = line.startswith((" ", "=")) and not sections and not example
        if indented and not laid_out:
            made += ["::", ""]
        laid_out = indented or laid_out and not line.strip()
        made.append(line if indented or example else escaped(line))
    return made


def escaped(text):
    """Text in which only ``code`` is markup."""
    parts = re.split(r"(``[^`]+``)", text)
    return "".join(p if p.startswith("``") else re.sub(r"([\\*|`_])", r"\\\1", p) for p in parts)


def _write(app):
    folder = Path(app.srcdir) / "reference"
    folder.mkdir(exist_ok=True)
    names = NAMES.findall((Path(app.srcdir) / "api.md").read_text(encoding="utf-8"))
    wanted = {f"{name}.rst": page(name) for name in names}
    for left in {path.name for path in folder.glob("*.rst")} - set(wanted):
        (folder / left).unlink()
    for name, text in wanted.items():
        target = folder / name
        if not target.exists() or target.read_text(encoding="utf-8") != text:
            target.write_text(text, encoding="utf-8")


def _signature(_app, what, _name, found, _options, given, _returns):
    """The signature with the names of types (``running.signature``); none of a result, which functions make."""
    if what in ("class", "exception") and not hasattr(found.__init__, "__signature__"):
        return ("", None) if given else None
    if what not in ("function", "method", "class"):
        return None
    shown = readable(found)
    own = [p for n, p in shown.parameters.items() if n not in ("self", "cls")]
    returns = None if what == "class" else str(shown.return_annotation)
    return str(shown.replace(parameters=own, return_annotation=inspect.Signature.empty)), returns


def _docstring(_app, _what, _name, _found, _options, lines):
    lines[:] = plain(lines)


def _property(_app, what, _name, found, _options, lines):
    """As it is written: napoleon takes "the unit of x: m" of a property for a type and its meaning."""
    if what == "property":
        lines[:] = plain((inspect.getdoc(found) or "").split("\n"))


def setup(app):
    """Pages are written before Sphinx looks for them, docstrings made markup before napoleon reads their sections."""
    app.setup_extension("sphinx.ext.autodoc")
    app.config.autodoc_member_order = "bysource"
    app.connect("builder-inited", _write)
    app.connect("autodoc-process-signature", _signature)
    app.connect("autodoc-process-docstring", _docstring, priority=400)
    app.connect("autodoc-process-docstring", _property, priority=600)
    app.setup_extension("sphinx.ext.napoleon")
    app.config.napoleon_google_docstring = False  # "x: what it is" is a sentence here
    return {"parallel_read_safe": True, "parallel_write_safe": True}
