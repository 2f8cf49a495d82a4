"""What nothing reaches is given a command or removed: every public function has a use outside the tests."""

import ast
import re
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

from tests.sources import below, nodes, tree

ROOT = Path(__file__).parents[1]
USERS = ("asymptotics", "paper_checks", "derivations", "docs", "benchmarks")


def used(*parts: ast.AST) -> set[str]:
    return names_in([n for part in parts for n in below(part)])


def names_in(nodes: Iterable[ast.AST]) -> set[str]:
    names = {n.id for n in nodes if isinstance(n, ast.Name)} | {n.attr for n in nodes if isinstance(n, ast.Attribute)}
    return names | {alias.name for n in nodes if isinstance(n, ast.ImportFrom) for alias in n.names}


def unreached(module: ast.Module, elsewhere: set[str]) -> set[str]:
    """The public functions that are neither used in another file nor by anything in this one that is reached.

    A question is a command: the shell reaches it.
    """
    bodies = {n.name: n for n in module.body if isinstance(n, ast.FunctionDef | ast.ClassDef)}
    rest = [n for n in module.body if n not in bodies.values() and not isinstance(n, ast.Import | ast.ImportFrom)]
    reached: set[str] = set()
    commands = {name for name, n in bodies.items() if "question" in used(*n.decorator_list)}
    wanted = bodies.keys() & elsewhere.union(used(*rest), commands)
    while wanted:
        reached |= wanted
        wanted = bodies.keys() & used(*(bodies[name] for name in wanted)) - reached
    functions = {name for name, n in bodies.items() if isinstance(n, ast.FunctionDef) and not name.startswith("_")}
    return functions - reached


def test_every_public_function_is_reached():
    paths = [p for top in USERS for p in (ROOT / top).rglob("*.py") if "auto_gallery" not in p.parts]
    names = {path: names_in(nodes(path)) for path in paths}
    pages = [ROOT / "README.md", *(p for p in (ROOT / "docs").rglob("*.md") if "auto_gallery" not in p.parts)]
    told = {word for page in pages for word in re.findall(r"\w+", page.read_text(encoding="utf-8"))}
    told |= set(re.findall(r"\w+", (ROOT / "asymptotics/__init__.py").read_text(encoding="utf-8")))
    files = Counter(name for found in names.values() for name in found)
    for path in (p for p in paths if p.is_relative_to(ROOT / "asymptotics")):
        defined = {getattr(node, "name", "") for node in tree(path).body}
        elsewhere = {name for name in defined if name in told or files[name] > (name in names[path])}
        left = unreached(tree(path), elsewhere)
        assert not left, f"{path.relative_to(ROOT)}: {left}"


def test_a_function_that_only_itself_uses_is_not_reached():
    text = ast.parse("def f(): return g()\ndef g(): return h()\ndef h(): return h()\ndef lone(): return lone()")
    assert unreached(text, {"f"}) == {"lone"} and unreached(text, {"g"}) == {"f", "lone"}


def test_a_question_is_reached_by_the_shell():
    text = ast.parse("@question(table)\ndef asked(): return made()\ndef made(): pass\n@other\ndef lone(): pass")
    assert unreached(text, set()) == {"lone"}
