"""One page for each public name, in sections: parameters with types and units, returned, raised, examples, source.

The names are those of ``docs/api.md``; signatures and annotations come from the source, sentences from the docstring,
meanings of parameters from ``parameters``.  A test asks for every section of every page; Sphinx only sets them.
"""

import ast
import inspect
import re
import textwrap
from importlib import import_module
from pathlib import Path

from parameters import meaning

import asymptotics

NAMES = re.compile(r"^reference/([\w.]+)$", re.MULTILINE)
RAISED = re.compile(r"[^.;]*\b(?:InputError|LimitError|UndecidedError|ValueError)\b[^;.]*(?:\.(?!\s|$)[^;.]*)*[.;]?")
ROOT = Path(asymptotics.__file__).parents[1]


def thing(name):
    """The object of a name of api.md: a public one, or one with its path."""
    if "." not in name:
        return getattr(asymptotics, name)
    module, _, last = name.rpartition(".")
    return getattr(import_module(f"asymptotics.{module}"), last)


def page(name, others):
    """The page of one name as reStructuredText."""
    found = thing(name)
    title = f"asymptotics.{name}"
    parts = [f"{title}\n{'=' * len(title)}", ".. py:currentmodule:: asymptotics"]
    parts += _class(name, found) if isinstance(found, type) else _call(name, found, name)
    parts += _section("See also", ", ".join(f":doc:`{other}`" for other in others))
    return "\n\n".join(parts) + "\n"


def _call(shown, function, call, kind="function", indent=""):
    """A function or a method: signature and sections."""
    plain = inspect.unwrap(function)
    node = definition(plain)
    declared = getattr(function, "__question__", None)
    sections = _numpydoc(plain.__doc__ or "")
    # Of a declared question the page of --help is the text, its sections stand below.
    body = _docstring(
        plain.__doc__ or "" if declared is None else "\n\n".join((declared.page, sections.get("Notes", "")))
    )
    body += _section("Parameters", _parameters(node, call, declared))
    returns = ast.unparse(node.returns) if node.returns is not None else "None"
    body += _section("Returns", f"``{returns}``{_linked(returns)}" if returns != "None" else "")
    told = " ".join(sections["Raises"].split()) if "Raises" in sections else " ".join(raised(plain.__doc__ or ""))
    body += _section("Raises", _prose(told))
    if kind == "function":
        body += _section("Examples", _block("\n".join(examples(plain)), "pycon"))
        body += _section("Source", _prose(source(plain)))
    text = [f".. py:{kind}:: {shown}{signature(node)}", textwrap.indent("\n\n".join(body), "   ")]
    return [textwrap.indent("\n\n".join(text), indent)]


def _class(name, kind):
    """A result or an input type: what it is, its fields, properties and methods."""
    if issubclass(kind, Exception):
        return [f".. py:exception:: {name}", *[textwrap.indent(p, "   ") for p in _docstring(kind.__doc__ or "")]]
    body = _docstring(kind.__doc__ or "")
    fields = [(n, a) for n, a in _annotated(kind) if not n.startswith("_")]
    body += _section("Attributes", "\n".join(f"**{n}** : ``{a}``\n" for n, a in fields))
    for member, made in vars(kind).items():
        getter = getattr(made, "fget", None) or getattr(made, "function", None)
        if member.startswith("_") or not (getter or inspect.isfunction(getattr(made, "__func__", made))):
            continue
        if getter:
            doc = "\n\n".join(_docstring(getter.__doc__ or ""))
            body.append(f".. py:property:: {member}\n\n{textwrap.indent(doc, '   ')}")
        else:
            body += _call(member, getattr(made, "__func__", made), f"{name}.{member}", "method")
    body += _section("Inherited", _inherited(kind))
    body += _section("Source", _prose(source(kind)))
    return [f".. py:class:: {name}", textwrap.indent("\n\n".join(body), "   ")]


def _inherited(kind):
    """What a result has from its base classes, in one line each."""
    found = {}
    for base in kind.__mro__[1:]:
        if base.__module__.startswith("asymptotics"):
            for member, made in vars(base).items():
                if not member.startswith("_") and inspect.isfunction(made):
                    found.setdefault(member, (inspect.getdoc(made) or "").split("\n")[0])
    return "\n".join(f"``.{member}()``: {_prose(line)}\n" for member, line in found.items() if member not in vars(kind))


def definition(function):
    """The ``def`` of a function, from its source."""
    return ast.parse(textwrap.dedent(inspect.getsource(function))).body[0]


def signature(node):
    """The parameters as they are written, without annotations, which stand below."""
    arguments = [a for a in (*node.args.posonlyargs, *node.args.args) if a.arg not in ("self", "cls")]
    defaults = [None] * (len(arguments) - len(node.args.defaults)) + node.args.defaults
    shown = [a.arg + (f"={ast.unparse(d)}" if d is not None else "") for a, d in zip(arguments, defaults)]
    star = [f"*{node.args.vararg.arg}"] if node.args.vararg else ["*"] if node.args.kwonlyargs else []
    keywords = [
        a.arg + (f"={ast.unparse(d)}" if d is not None else "")
        for a, d in zip(node.args.kwonlyargs, node.args.kw_defaults)
    ]
    double = [f"**{node.args.kwarg.arg}"] if node.args.kwarg else []
    return f"({', '.join([*shown, *star, *keywords, *double])})"


def _plain(annotation):
    """The type of an annotation, without the kind that reads it."""
    kind = isinstance(annotation, ast.Subscript) and ast.unparse(annotation.value) == "Annotated"
    return annotation.slice.elts[0] if kind else annotation


def parameters(node):
    """(name, annotation) of each parameter."""
    every = [*node.args.posonlyargs, *node.args.args, node.args.vararg, *node.args.kwonlyargs, node.args.kwarg]
    return [
        (a.arg, "" if a.annotation is None else ast.unparse(_plain(a.annotation)))
        for a in every
        if a is not None and a.arg not in ("self", "cls")
    ]


def _numpydoc(docstring):
    """The sections of a numpydoc docstring, by name."""
    parts = re.split(r"^(\w+)\n-+\n", inspect.cleandoc(docstring), flags=re.MULTILINE)
    return {name: text.strip() for name, text in zip(parts[1::2], parts[2::2])}


def explained(call, parameter, declared=None):
    """What a parameter means: what its own question says, else the list; None where neither does."""
    helped = {} if declared is None else {a.name: a.help for a in declared.asked}
    return helped.get(parameter) or meaning(call, parameter)


def _parameters(node, call, declared=None):
    rows = [(n, a, explained(call, n, declared) or "") for n, a in parameters(node)]
    return "\n".join(f"**{n}** : ``{a}``\n    {_prose(m)}\n" for n, a, m in rows)


def _annotated(kind):
    found = []
    for base in reversed(kind.__mro__):
        if base.__module__.startswith("asymptotics"):
            body = definition(base).body
            found += [(s.target.id, ast.unparse(s.annotation)) for s in body if isinstance(s, ast.AnnAssign)]
    return found


def raised(docstring):
    """The sentences of a docstring that say what is refused."""
    text = re.sub(r"\s+", " ", ">>>".join(docstring.split(">>>")[:1]))
    return [found.strip().rstrip(";") for found in RAISED.findall(text)]


def examples(function):
    """The examples of a docstring; where it has none, those of its file that call the function."""
    own = _prompts(function.__doc__ or "")
    if own:
        return own
    file = _prompts(inspect.getmodule(function).__doc__ or "")
    return file if any(re.search(rf"\b{function.__name__}\(", line) for line in file) else []


def _prompts(docstring):
    """The lines of the doctests, with what they print."""
    lines, kept, inside = inspect.cleandoc(docstring).split("\n"), [], False
    for line in lines:
        inside = line.startswith((">>> ", "... ")) or inside and bool(line.strip())
        kept += [line] if inside else []
    return kept


def source(found):
    """The file and line, and what the docstring says of the derivation."""
    lines, first = inspect.getsourcelines(found)
    del lines
    where = f"{Path(inspect.getsourcefile(found)).relative_to(ROOT).as_posix()}, line {first}."
    told = re.search(r"Source: (.*?\.)(?:\s|$)", re.sub(r"\s+", " ", found.__doc__ or ""))
    return f"{told[1][:1].upper()}{told[1][1:]} {where}" if told else where


def _docstring(docstring):
    """Paragraphs as prose, what is indented (formulas, tables) as it is written; examples stand in a section."""
    found = []
    for paragraph in re.split(r"\n\s*\n", inspect.cleandoc(docstring)):
        if paragraph.startswith(">>>"):
            continue
        laid_out = paragraph.startswith((" ", "=")) or "\n    " in paragraph
        found.append(_block(textwrap.dedent(paragraph), "text") if laid_out else _prose(paragraph))
    return found


def _prose(text):
    """Plain text in which only ``code`` is markup."""
    parts = re.split(r"(``[^`]+``)", text)
    return "".join(p if p.startswith("``") else re.sub(r"([\\*|`_])", r"\\\1", p) for p in parts)


def _block(text, language):
    return f".. code-block:: {language}\n\n{textwrap.indent(text, '   ')}" if text.strip() else ""


def _section(title, body):
    return [f".. rubric:: {title}", body] if body.strip() else []


def _linked(returns):
    """The pages of the types that are returned."""
    public = [n for n in re.findall(r"\b[A-Z]\w+", returns) if n in asymptotics.__all__]
    return f" ({', '.join(f':doc:`{n}`' for n in public)})" if public else ""


def pages(source_dir):
    """name -> page, for every name of api.md; names of one list are neighbours."""
    text = (Path(source_dir) / "api.md").read_text(encoding="utf-8")
    found = {}
    for group in re.findall(r"```\{toctree\}(.*?)```", text, re.DOTALL):
        names = NAMES.findall(group)
        found |= {name: page(name, [n for n in names if n != name]) for name in names}
    return found


def _write(app):
    folder = Path(app.srcdir) / "reference"
    folder.mkdir(exist_ok=True)
    wanted = {f"{name}.rst": text for name, text in pages(app.srcdir).items()}
    for left in {path.name for path in folder.glob("*.rst")} - set(wanted):
        (folder / left).unlink()
    for name, text in wanted.items():
        path = folder / name
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")


def setup(app):
    """Pages are written before Sphinx looks for them."""
    app.connect("builder-inited", _write)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
