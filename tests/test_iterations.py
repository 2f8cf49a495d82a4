"""An iteration that can end unproved says so: a walk over every loop that may run out before its goal is reached.

Found are loops ``for ... in range(...)`` that can be left early (``break``, ``return``) and update a value by itself.
Each must tell the two ends apart: an ``else`` (or what follows, where the loop is left by ``return`` alone) that raises
or returns; or it is listed with the reason why a value that is not the limit does no harm.  A ``while`` ends when its
condition is met, which is the goal, unless a part of the condition is a cap: those are listed as well.
"""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.sources import tree

ROOT = Path(__file__).parents[1] / "asymptotics"
ROOMS = ("bounds", "envelopes", "expansions", "flow", "limit_cycles", "motions", "numbers", "return_map", "turning")
ROOMS += (
    "decays/comparison",
    "equivalent",
    "decays/identification/certified_sets",
)  # the rest of identification is an estimate
HARMLESS = {
    "envelopes/large.py:_newton": "the time reached is integrated anew up to the place returned, and enclosed after",
    "expansions/half_swings/finite_majorant.py:_fixed_point": "an oracle in doubles, or inf; checked in balls",
    "limit_cycles/certified.py:_fixed_point": "a guess in doubles for interval Newton",
    "motions/truncation.py:_iterated": "two digits of the change of a start, for a measured estimate",
    "flow/secant.py:secant": "a guess: any place ahead will do, the miss there is bounded",
    "return_map/half_swings.py:_near": "the place with the least residual: the residual bounds its error after",
    "return_map/courses.py:_reached": "any t serves: how far its time is from the one wanted is bounded after",
    "return_map/hand_overs.py:at_angle": "any speed serves: by how much its angle misses is in the answer, as dz",
    "flow/slow_manifold/slow_curve.py:solve": "the interval about the last place must hold its own image",
    "turning/energy_primitive.py:_guess": "the signs on both sides enclose the root",
    "flow/wells/trapping_regions.py:_held": "a bisection whose two ends are proved, however near they are",
    "decays/identification/certified_sets/central_point.py:chebyshev_point": "a choice: balls prove what is made of it",
    "decays/identification/certified_sets/physical.py:physical_box": "the boxes left hold every solution in each round",
    "decays/identification/certified_sets/set_valued.py:_smallest_box": "the box holds every solution after each round",
    "flow/wells/expansion.py:_majorant": "the bound that comes out is checked against its own equation",
}
CAPPED = {
    "bounds/reach.py:_until": "what is returned has been proved; a later time may be",
    "flow/linear_spring/expansion.py:_slow_enough": "a bisection: a choice of the step",
    "flow/wells/rational_stops.py:rational_stops": "the stops that are returned are exact, however many they are",
    "return_map/panel_plan.py:widest": "a choice of the ellipse, whose bound is proved after",
}


def loops(module: ast.AST) -> Iterator[tuple[str, ast.For, list[ast.stmt]]]:
    """(function, loop, the statements after it, those after a ``with`` about it too) of every counted loop."""
    for function in ast.walk(module):
        if isinstance(function, ast.FunctionDef):
            yield from ((function.name, *found) for found in inside(function.body, []))


def inside(block: list[ast.stmt], outer: list[ast.stmt]) -> Iterator[tuple[ast.For, list[ast.stmt]]]:
    for i, here in enumerate(block):
        rest = block[i + 1 :] + outer
        if isinstance(here, ast.For) and counted(here):
            yield here, rest
        if not isinstance(here, ast.FunctionDef | ast.ClassDef):
            for name in ("body", "orelse"):
                yield from inside(getattr(here, name, []), rest if isinstance(here, ast.With) else [])


def counted(loop: ast.For) -> bool:
    return isinstance(loop.iter, ast.Call) and getattr(loop.iter.func, "id", "") == "range"


def names(node: ast.AST, context: type[ast.expr_context]) -> set[str]:
    return {n.id for n in ast.walk(node) if isinstance(n, ast.Name) and isinstance(n.ctx, context)}


def iterates(loop: ast.For) -> bool:
    """Whether a value that the loop makes enters the next round, and the loop can be left early."""
    own = [s for s in loop.body for s in ast.walk(s)]
    made: set[str] = set()
    for statement in own:
        if isinstance(statement, ast.Assign | ast.AugAssign):
            targets = statement.targets if isinstance(statement, ast.Assign) else [statement.target]
            made |= {name for target in targets for name in names(target, ast.Store)}
    before: set[str] = set()
    seen: set[str] = set()
    for statement in loop.body:
        before |= (names(statement, ast.Load) & made) - seen
        seen |= names(statement, ast.Store)
    return bool(before) and any(isinstance(s, ast.Break) or (isinstance(s, ast.Return) and not ends(s)) for s in own)


def ends(statement: ast.stmt | None) -> bool:
    """Whether it says that nothing was found."""
    if isinstance(statement, ast.Return):
        return statement.value is None or ast.unparse(statement.value) in ("None", "False")
    return isinstance(statement, ast.Raise) or (isinstance(statement, ast.If) and ends(statement.body[-1]))


def honest(loop: ast.For, rest: list[ast.stmt]) -> bool:
    """Whether running out leads to a refusal: in ``else``, or in what follows but for a reason in words."""
    if loop.orelse:
        return ends(loop.orelse[-1])
    after = [s for s in rest if not (isinstance(s, ast.Assign) and isinstance(s.value, ast.Constant | ast.JoinedStr))]
    return bool(after) and ends(after[0])


def open_ends(module: ast.Module) -> list[str]:
    return [name for name, loop, rest in loops(module) if iterates(loop) and not honest(loop, rest)]


def capped(module: ast.Module) -> Iterator[str]:
    """The functions with a ``while`` of which one part of the condition compares with a constant."""
    for function in ast.walk(module):
        if isinstance(function, ast.FunctionDef):
            tests = [n.test for n in ast.walk(function) if isinstance(n, ast.While) and isinstance(n.test, ast.BoolOp)]
            if any(isinstance(part, ast.Compare) and constant(part) for test in tests for part in test.values):
                yield function.name


def constant(comparison: ast.Compare) -> bool:
    """Whether the right side has no variable: a number, or a name in capitals; 0 is no cap but an end."""
    right = comparison.comparators[-1]
    return ast.unparse(right) != "0" and all(n.isupper() for n in names(right, ast.Load))


@pytest.mark.parametrize(("found_in", "listed"), [(open_ends, HARMLESS), (capped, CAPPED)])
def test_every_iteration_that_can_run_out_says_so(found_in, listed):
    found = {
        f"{path.relative_to(ROOT)}:{name}"
        for room in ROOMS
        for path in sorted((ROOT / room).rglob("*.py"))
        for name in found_in(tree(path))
    }
    assert found == set(listed)


STALE = """
def root(f, x):
    for _ in range(12):
        value = f(x)
        step = value / 2
        if abs(step) < 1e-9:
            break
        x = x - step
    return x, value
"""


def test_the_walk_finds_a_newton_loop_that_goes_on_with_a_stale_value():
    def found(text):
        return open_ends(ast.parse(text))

    assert found(STALE) == ["root"]
    assert not found(STALE.replace("    return x", "    else:\n        raise ValueError\n    return x"))
    assert found(STALE.replace("break", "return x")) == ["root"]
    assert not found(STALE.replace("break", "return x").replace("return x, value", "raise ValueError"))


def test_every_reason_is_one():
    assert all(len(reason) > 20 for reason in (HARMLESS | CAPPED).values())


def test_the_walk_finds_a_search_with_a_cap():
    def found(text):
        return list(capped(ast.parse(text)))

    assert found("def f(x):\n    while x < _MOST and more(x):\n        x *= 2\n    return x") == ["f"]
    assert found("def f(x):\n    while more(x):\n        x *= 2\n    return x") == []
