"""The sources as syntax trees, each parsed once in a process: many tests walk over all of them."""

import ast
import gc
from functools import cache
from pathlib import Path


@cache
def tree(path: Path) -> ast.Module:
    """The syntax tree of a file; the collector of garbage, which would search what grows again and again, pauses."""
    pauses = gc.isenabled()
    gc.disable()
    try:
        return ast.parse(path.read_text(encoding="utf-8"))
    finally:
        if pauses:
            gc.enable()


@cache
def nodes(path: Path) -> tuple[ast.AST, ...]:
    """All nodes of a file, as ``ast.walk`` yields them."""
    return tuple(ast.walk(tree(path)))
