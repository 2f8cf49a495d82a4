"""Where a bound is made, found in the syntax trees of ``asymptotics``: each place, with what weakens it.

    radius   arb(m, r)                            half of r
    upper    upper(x), x.upper(), x.abs_upper()   half of it
    lower    lower(x), x.lower(), x.abs_lower()   twice it
    union    a.union(b)                           a alone
    guard    if c: return None, False or raise    c never holds; of "c or d" each part is dropped by itself
    premise  c and d; all(c for …)                each part that compares is dropped by itself

A guard gives up by nan or inf as well.  Where "c and d" gives up (``if c and d: raise``), a part that is dropped gives
up more often: stricter, not weaker, and no premise; that it never gives up is the guard.  A guard that refuses a
request (``InputError``, ``LimitError``) bounds nothing, and a bound that is all of a radius is that radius; of two that
plant the same text the first counts.  A text or a set has no bounds.  Modules that use no balls have no sites, nor
those that ``docs/maintainers/arithmetics.md`` calls heuristic: nothing is claimed there.

>>> text = "from flint import arb\\ndef f(x, r):\\n    return arb(x, r).upper()\\n"
>>> [(site.kind, site.weaker) for site in sites_of(text, "f.py")]
[('upper', '(arb(x, r).upper() / 2)'), ('radius', 'arb(x, (r) / 2)')]
>>> text = "from flint import arb\\ndef f(x, y):\\n    if {}:\\n        return arb('inf')\\n    return x\\n"
>>> for test in ("x > 0 and y > 0", "not (x > 0 and y > 0)"):
...     print([(site.kind, site.text) for site in sites_of(text.format(test), "f.py")])
[('guard', 'x > 0 and y > 0')]
[('guard', 'not (x > 0 and y > 0)'), ('premise', 'x > 0'), ('premise', 'y > 0')]
"""

import ast
import re
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

ROOT = Path(__file__).parents[1]
ARITHMETICS = ROOT / "docs" / "maintainers" / "arithmetics.md"
REFUSALS = {"InputError", "LimitError", "TypeError", "ValueError", "NotImplementedError"}
HALVED, DOUBLED = {"upper", "abs_upper"}, {"lower", "abs_lower"}
Weaken = Callable[[str], str]
Found = Iterator[tuple[str, ast.expr, Weaken]]


@dataclass(frozen=True)
class Site:
    """``text`` at ``start`` of ``file``, in ``function``, becomes ``weaker``; ``nth`` among equal ones there."""

    file: str
    function: str
    kind: str
    text: str
    weaker: str
    start: int
    line: int
    nth: int

    @property
    def key(self) -> str:
        """What names it, whatever line it stands in."""
        words = " ".join(self.text.split())
        return f"{self.file}::{self.function}::{self.kind}::{words}" + (f"::{self.nth}" if self.nth else "")

    def planted(self, source: str) -> str:
        """The source of the file with this one bound weakened."""
        return source[: self.start] + self.weaker + source[self.start + len(self.text) :]


@lru_cache(maxsize=1)
def sites() -> tuple[Site, ...]:
    """All sites of the library."""
    files = sorted(str(path.relative_to(ROOT)) for path in (ROOT / "asymptotics").rglob("*.py"))
    return tuple(
        site
        for file in files
        if arithmetic_of(file) != "heuristic"
        for site in sites_of((ROOT / file).read_text(), file)
    )


@lru_cache(maxsize=1)
def _arithmetics() -> dict[str, str]:
    """The room or the file -> its arithmetic."""
    rows = re.findall(r"^\|(.*)\| (exact|certified|heuristic|none) \|(.*)\|$", ARITHMETICS.read_text(), re.MULTILINE)
    found, room = {}, ""
    for left, arithmetic, right in rows:
        rooms, files = (re.findall(r"`([\w/.]+)`", cell) for cell in (left, right))
        room = rooms[-1] if rooms else room
        here = rooms if not right.strip() else [room] if "all others" in right else files
        found |= dict.fromkeys(here, arithmetic)
    return found


def arithmetic_of(file: str) -> str:
    """What the table of arithmetics says of the file itself, else of its room, the innermost that it names."""
    path, known = Path(file).relative_to("asymptotics"), _arithmetics()
    here = (str(path), *(f"{room}/" for room in path.parents))
    return next((known[name] for name in here if name in known), "")


def sites_of(source: str, file: str) -> Iterator[Site]:
    """The sites of one module, in the order of its text."""
    if "from flint import" not in source or not _uses_balls(tree := ast.parse(source)):
        return
    starts = [0]
    for line in source.encode().splitlines(keepends=True):
        starts.append(starts[-1] + len(line.decode()))
    lines = source.splitlines(keepends=True)

    def place(line: int, column: int) -> int:
        return starts[line - 1] + len(lines[line - 1].encode()[:column].decode())

    seen: Counter[tuple[str, str, str]] = Counter()
    planted: set[tuple[int, str]] = set()
    for function, node in _functions(tree.body, ""):
        for kind, part, weaken in _weakened(node):
            start, end = place(part.lineno, part.col_offset), place(part.end_lineno or 0, part.end_col_offset or 0)
            text = source[start:end]
            same = (function, kind, text)
            site = Site(file, function, kind, text, weaken(text), start, part.lineno, seen[same])
            negated = isinstance(part, ast.UnaryOp) and isinstance(part.op, ast.Not) and kind == "guard"
            outcome = (end, f"True {text.removeprefix('not ')}" if negated else f"{site.weaker} {text}")
            if outcome not in planted:
                planted.add(outcome)
                yield site
                seen[same] += 1


def _uses_balls(tree: ast.Module) -> bool:
    imports = (node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) and node.module == "flint")
    return any(alias.name.startswith(("arb", "acb")) for node in imports for alias in node.names)


def _functions(body: list[ast.stmt], prefix: str) -> Iterator[tuple[str, ast.FunctionDef]]:
    for node in body:
        if isinstance(node, ast.FunctionDef):
            yield f"{prefix}{node.name}", node
        elif isinstance(node, ast.ClassDef):
            yield from _functions(node.body, f"{prefix}{node.name}.")


def _weakened(function: ast.FunctionDef) -> Found:
    """(kind, node, text -> weaker text) of each site, outer ones first."""
    nodes = list(ast.walk(function))
    whole = {id(radius) for node in nodes if (radius := _radius(node)) is not None}
    refusals = [node.test for node in nodes if isinstance(node, ast.If) and _refuses(node.body[0])]
    stricter = {id(node) for test in refusals for node in _required(test)}
    for node in nodes:
        if id(node) in stricter:
            continue
        if isinstance(node, ast.Call):
            yield from (found for found in _call(node) if id(node) not in whole)
        elif isinstance(node, ast.BoolOp) and isinstance(node.op, ast.And):
            yield from (("premise", part, lambda text: "True") for part in node.values if _compares(part))
        elif isinstance(node, ast.If) and not node.orelse and len(node.body) == 1 and _gives_up(node.body[0]):
            test = node.test
            parts = test.values if isinstance(test, ast.BoolOp) and isinstance(test.op, ast.Or) else [test]
            yield from (("guard", part, lambda text: "False") for part in parts if _compares(part))


def _radius(node: ast.AST) -> ast.expr | None:
    """r of arb(m, r)."""
    if isinstance(node, ast.Call) and _name(node) == "arb" and len(node.args) == 2:
        return None if isinstance(node.args[0], ast.Tuple) else node.args[1]
    return None


def _is_no_ball(node: ast.Call) -> bool:
    """str(…).lower(), set().union(…)."""
    made = node.func.value if isinstance(node.func, ast.Attribute) else None
    return isinstance(made, ast.Call) and _name(made) in ("str", "set")


def _name(node: ast.Call) -> str:
    f = node.func
    return f.id if isinstance(f, ast.Name) else f.attr if isinstance(f, ast.Attribute) else ""


def _call(node: ast.Call) -> Found:
    name, radius = _name(node), _radius(node)
    if _is_no_ball(node):
        return
    if radius is not None:
        middle, half = ast.unparse(node.args[0]), ast.unparse(radius)
        yield "radius", node, lambda text: f"arb({middle}, ({half}) / 2)"
    elif name in HALVED:
        yield "upper", node, lambda text: f"({text} / 2)"
    elif name in DOUBLED:
        yield "lower", node, lambda text: f"({text} * 2)"
    elif name == "all" and node.args and isinstance(node.args[0], ast.GeneratorExp) and _compares(node.args[0].elt):
        yield "premise", node, lambda text: "True"
    elif name == "union" and isinstance(node.func, ast.Attribute):
        first = ast.unparse(node.func.value)
        yield "union", node, lambda text: f"({first})"


def _required(test: ast.expr, holds: bool = True) -> Iterator[ast.expr]:
    """Each "c and d" and "all(…)" whose truth, or with ``holds`` False whose untruth, makes ``test`` true."""
    if isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not):
        yield from _required(test.operand, not holds)
    elif isinstance(test, ast.BoolOp):
        yield from ([test] if holds and isinstance(test.op, ast.And) else [])
        yield from (node for part in test.values for node in _required(part, holds))
    elif isinstance(test, ast.Call) and _name(test) in ("all", "any", "bool") and test.args:
        yield from ([test] if holds and _name(test) == "all" else [])
        inner = test.args[0]
        yield from _required(inner.elt if isinstance(inner, ast.GeneratorExp) else inner, holds)


def _refuses(statement: ast.stmt) -> bool:
    """Whether it gives up or refuses a request."""
    return isinstance(statement, ast.Raise) or _gives_up(statement)


def _gives_up(statement: ast.stmt) -> bool:
    if isinstance(statement, ast.Return):
        value = statement.value
        if isinstance(value, ast.Call) and _name(value) in ("arb", "acb"):
            value = value.args[0] if len(value.args) == 1 else value
        return isinstance(value, ast.Constant) and value.value in (None, False, "nan", "inf")
    if isinstance(statement, ast.Raise) and isinstance(statement.exc, ast.Call):
        return ast.unparse(statement.exc.func) not in REFUSALS
    return False


def _compares(test: ast.expr) -> bool:
    """Whether the condition compares values (not ``is None``, a flag, or a type)."""
    inner = test.operand if isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not) else test
    comparisons = [n for n in ast.walk(inner) if isinstance(n, ast.Compare)]
    ordered = any(isinstance(op, ast.Lt | ast.LtE | ast.Gt | ast.GtE) for n in comparisons for op in n.ops)
    calls = {n.func.attr for n in ast.walk(inner) if isinstance(n, ast.Call) and isinstance(n.func, ast.Attribute)}
    return ordered or bool(calls & {"contains", "contains_interior", "is_finite", "overlaps"})
