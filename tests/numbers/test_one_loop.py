"""One loop raises the precision until balls decide (``numbers.precision``); what else changes it says here why."""

import ast
from collections.abc import Iterator
from pathlib import Path

from tests.sources import below, nodes, walk

ROOT = Path(__file__).parents[2]
OTHERS = {
    "motions/invariants/constants.py::T": "foretells to which precision the one loop will come, for the price",
    "bounds/local.py::_half_swing": "three sizes of the bounds beyond the order: the last is taken, sharp or not",
    "bounds/motion.py::proved_bound": "digits of an enclosure that the one loop makes; any of them gives a bound",
    "decays/comparison/truth.py::at_turning_points": "digits beside a tie of what is printed, each by the one loop",
    "driven/trial.py::trial": "Newton's steps gain bits and start with few: what is left is measured at the end",
    "expansions/half_swings/nodes.py::through": "fewer bits for what is small: nothing is decided",
    "flow/secant.py::secant": "Newton's steps gain bits and start with few: a choice, fully precise in the end",
    "flow/taylor.py::_of_real_powers": "later coefficients in fewer bits: what each lacks is in its ball",
    "flow/times.py::_speed_at": "Newton's steps gain bits and start with few: a choice, fully precise in the end",
    "limit_cycles/certified.py::excess": "the first of two precisions that gives a guess in doubles",
    "motions/truncation.py::_refined": "Newton's steps gain bits and start with few: a choice, precise in the end",
    "numbers/exact.py::ball": "an exact number that is not 0: it ends without a limit",
    "numbers/precision.py::at_growing_precision": "the one loop",
}
"""A function that changes the precision or the digits from pass to pass -> why it is no second such loop."""


def changes(function: ast.FunctionDef) -> bool:
    """Whether a loop works at a precision that it sets, or doubles bits or digits, or a function calls itself there."""
    loops = [n for n in below(function) if isinstance(n, ast.While | ast.For)]
    for loop in loops:
        own = walk(loop)
        stores = [n for n in own if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)]
        inside = {n.id for n in stores}
        for n in own:
            if isinstance(n, ast.AugAssign) and isinstance(n.target, ast.Name) and n.target.id in ("bits", "digits"):
                return True
            if is_precision(n) and {x.id for x in ast.walk(n) if isinstance(x, ast.Name)} & inside:
                return True
    withs = [n for n in below(function) if isinstance(n, ast.With)]
    deeper = [n for n in withs if any(is_precision(x.context_expr) for x in n.items)]
    calls = [c.func for n in deeper for c in ast.walk(n) if isinstance(c, ast.Call)]
    called = [getattr(f, "id", getattr(f, "attr", "")) for f in calls if isinstance(f, ast.Name) or is_self(f)]
    return function.name in called


def is_precision(node: ast.AST) -> bool:
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "workprec"


def is_self(f: ast.AST) -> bool:
    return isinstance(f, ast.Attribute) and isinstance(f.value, ast.Name) and f.value.id == "self"


def found() -> Iterator[str]:
    for path in sorted((ROOT / "asymptotics").rglob("*.py")):
        for node in (n for n in nodes(path) if isinstance(n, ast.FunctionDef) and changes(n)):
            inner = [n for n in below(node) if isinstance(n, ast.FunctionDef) and n is not node]
            if not any(changes(n) for n in inner):
                yield f"{path.relative_to(ROOT / 'asymptotics')}::{node.name}"


def test_only_the_one_loop_raises_the_precision_until_something_is_decided():
    assert set(found()) == set(OTHERS)


def test_a_second_loop_is_found():
    text = "def f(b):\n    while True:\n        with ctx.workprec(b):\n            g()\n        b += 1\n"
    again = "def f(b):\n    with ctx.workprec(2 * b):\n        return f(2 * b)\n"
    fixed = "def f(b):\n    for _ in range(3):\n        with ctx.workprec(b):\n            g()\n"
    made = [ast.parse(x).body[0] for x in (text, again, fixed)]
    assert [changes(f) for f in made if isinstance(f, ast.FunctionDef)] == [True, True, False]
