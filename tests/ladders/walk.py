"""The public functions of ``asymptotics`` that return balls, found in the syntax trees by their annotations."""

import ast
import re
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

from tests import sources

ROOT = Path(__file__).parents[2]
BALLS = {"arb", "acb", "arb_poly", "acb_poly", "arb_series", "acb_series", "arb_mat", "acb_mat"}
_WORD = re.compile(r"[A-Za-z_][A-Za-z_0-9]*")

SERIES = (
    "asymptotics.expansions.half_swings.certified.quarter_swing",
    "asymptotics.expansions.half_swings.certified_zeros.certified_half_swing",
)
"""Their results are series of any coefficients by annotation, and balls in fact."""

Names = dict[str, str]
"""What a module calls a class or an alias -> its full name."""


@lru_cache(maxsize=1)
def trees() -> dict[str, ast.Module]:
    """Module name -> its syntax tree."""
    files = sorted((ROOT / "asymptotics").rglob("*.py"))
    names = [".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__") for path in files]
    return {name: sources.tree(path) for name, path in zip(names, files, strict=True)}


def returning_balls(modules: dict[str, ast.Module]) -> dict[str, str]:
    """Full name of every public function, method and property -> its annotation, where that holds balls."""
    known = {name: _names(name, tree) for name, tree in modules.items()}
    holders = _holders(modules, known)
    found = dict.fromkeys(SERIES, "series of arb")
    for module, tree in modules.items():
        for name, node in _functions(tree.body, module):
            if node.returns is not None and _words(ast.unparse(node.returns), known[module]) & holders:
                found[name] = ast.unparse(node.returns).strip("'")
    return found


def _names(module: str, tree: ast.Module) -> Names:
    found = {}
    for node in tree.body:
        if isinstance(node, ast.ImportFrom):
            found |= {alias.asname or alias.name: f"{node.module}.{alias.name}" for alias in node.names}
        elif isinstance(node, ast.ClassDef):
            found[node.name] = f"{module}.{node.name}"
        elif isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            found[node.targets[0].id] = f"{module}.{node.targets[0].id}"
    return found


def _holders(modules: dict[str, ast.Module], known: dict[str, Names]) -> set[str]:
    """Classes with a field that holds balls, and names of types that do, until nothing is added."""
    parts = {name: words for module, tree in modules.items() for name, words in _parts(module, tree, known[module])}
    holders = {f"flint.{name}" for name in BALLS}
    while more := {name for name, words in parts.items() if words & holders} - holders:
        holders |= more
    return holders


def _parts(module: str, tree: ast.Module, known: Names) -> Iterator[tuple[str, set[str]]]:
    """Each class, and each alias of a type, with what its fields are made of."""
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            fields = [ast.unparse(part.annotation) for part in node.body if isinstance(part, ast.AnnAssign)]
            yield f"{module}.{node.name}", set().union(*(_words(text, known) for text in fields))
        elif isinstance(node, ast.Assign) and isinstance(node.value, ast.Subscript):
            words = _words(ast.unparse(node.value), known)
            yield from ((known[target.id], words) for target in node.targets if isinstance(target, ast.Name))


def _words(annotation: str, known: Names) -> set[str]:
    """The full names of the types in an annotation, but not those that a function takes or gives."""
    if annotation.startswith(("Callable", "type[")):
        return set()
    return {known[word] for word in _WORD.findall(annotation) if word in known}


def _functions(body: list[ast.stmt], prefix: str) -> list[tuple[str, ast.FunctionDef]]:
    found = []
    for node in body:
        if isinstance(node, ast.FunctionDef) and (node.name == "__call__" or not node.name.startswith("_")):
            found.append((f"{prefix}.{node.name}", node))
        elif isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            found += _functions(node.body, f"{prefix}.{node.name}")
    return found
