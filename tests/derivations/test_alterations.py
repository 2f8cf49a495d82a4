"""Every displayed line notices when a side of it is altered structurally; what is displayed is what is decided."""

import json
from importlib import import_module
from itertools import islice
from pathlib import Path

import pytest
import sympy

from asymptotics.running.public import limited
from derivations.__main__ import names
from derivations.relations import value
from derivations.steps import At, Coefficient, Derivation, Solution, Taylor, defined, named
from derivations.waiting import is_name
from tests.derivations.alterations import altered

LISTED = json.loads(Path(__file__).with_name("rearranged.json").read_text(encoding="utf-8"))
WAITING = (At, Coefficient, Solution, Taylor)
WAITING += (sympy.Derivative, sympy.Integral, sympy.Limit, sympy.Sum, sympy.Subs)
PER_SIDE = 4
SECONDS = 30
"""For one altered line: the dearest that is decided takes a few; the integral of sin(psi)/X_3 fills all memory."""


def lines(name):
    return import_module("derivations." + name.replace("-", "_")).derivation.steps


def operates(side):
    """Whether an operation, a name or a function with a body is displayed, which the check has to evaluate."""
    nodes = sympy.preorder_traversal(side)
    return any(isinstance(x, WAITING) or is_name(x) or hasattr(type(x), "body") for x in nodes)


def rearranged(step):
    """Whether both sides are one expression, written in two ways: no operation is displayed on either."""
    return step.kind == "equality" and not operates(step.left) and not operates(step.right)


def spread(alterations, number):
    """Some of the alterations, from all over the expression."""
    found = list(islice(alterations, 400))
    return found[:: max(1, len(found) // number)][:number]


def passes(step, left, right):
    """Whether the line is accepted with these sides, in a time in which SymPy cannot fill the memory."""
    line = Derivation("altered", "", source="")
    try:
        with limited(SECONDS):
            line.step(step.reason, left, right)
    except (AssertionError, ArithmeticError, AttributeError, LookupError, NotImplementedError, TypeError, ValueError):
        return False
    except sympy.PolynomialError:
        return False
    return True


def same(one, other):
    """Whether two expressions have the same value at a point where all symbols are numbers, within 20 digits."""
    one, other = value(one), value(other)
    if isinstance(one, sympy.Tuple):
        return len(one) == len(other) and all(map(same, one, other))
    rest = one - other
    letters = enumerate(sorted(rest.free_symbols, key=str))
    point = {x: sympy.Integer(3 + k) if x.is_integer else sympy.Rational(31 + 7 * k, 53) for k, x in letters}
    return abs(sympy.N(rest.subs(point), 30)) < sympy.Rational(1, 10**20)


def accepted(step, number):
    """(alterations tried, those accepted) for each side; an alteration is (left, right, the altered, the original)."""
    for side in (0, 1):
        was = (step.left, step.right)[side]
        tried = [(step.right, other) for other in spread(altered(was), number)]
        pairs = [(other, right, other) if side == 0 else (step.left, other, other) for right, other in tried]
        yield pairs, [pair for pair in pairs if passes(step, *pair[:2])], was


def unnoticed(step, number):
    """What a line does not notice: an alteration that changes the value, or every alteration of a side."""
    found = []
    for side, (tried, taken, was) in enumerate(accepted(step, number)):
        found += [str(other) for _, _, other in taken if not same(other, was)]
        if tried and len(tried) == len(taken):
            more, still, _ = list(accepted(step, 40))[side]
            found += ["every alteration of " + str(was)] * (len(more) == len(still))
    return found


def relations(step):
    return list(step.left) if isinstance(step.left, sympy.Tuple) else [step.left]


REVERSED = {sympy.Lt: sympy.Ge, sympy.Le: sympy.Gt, sympy.Gt: sympy.Le, sympy.Ge: sympy.Lt, sympy.Ne: sympy.Eq}


def holds(step, relation):
    """Whether the line is accepted with another relation."""
    line = Derivation("altered", "", source="")
    try:
        with limited(SECONDS):
            line.asserts(step.reason, relation)
    except (AssertionError, ArithmeticError, AttributeError, LookupError, NotImplementedError, TypeError, ValueError):
        return False
    except sympy.PolynomialError:
        return False
    return True


def unnoticed_in(step, relation, number):
    """What a line of relations does not notice: the contrary, or every alteration of both sides."""
    contrary = REVERSED.get(type(relation), sympy.Ne)(*relation.args, evaluate=False)
    found = [f"the contrary of {relation}"] if holds(step, contrary) else []
    tried = [
        relation.func(*relation.args[:side], other, *relation.args[side + 1 :], evaluate=False)
        for side in (0, 1)
        for other in altered(relation.args[side])
    ]
    for alterations in (spread(iter(tried), number), tried[:60]):
        if not alterations or any(not holds(step, other) for other in alterations):
            return found
    return [*found, f"every alteration of {relation}"]


@pytest.mark.parametrize("name", names())
def test_no_line_is_an_expression_beside_itself_but_those_listed(name):
    found = {step.reason for step in lines(name) if rearranged(step)}
    assert found == set(LISTED["lines"].get(name, {}))  # a line that is mended leaves the list
    assert set(LISTED["lines"].get(name, {}).values()) <= set(LISTED["why"])


def test_the_list_names_derivations_and_its_length_may_only_shrink():
    assert set(LISTED["lines"]) <= set(names())
    assert sum(map(len, LISTED["lines"].values())) <= LISTED["at most"]


@pytest.mark.parametrize("name", names())
def test_relations_are_decided_and_definitions_prove_nothing(name):
    for step in lines(name):
        shown = step.left if isinstance(step.left, sympy.Tuple) and step.right is None else (step.left,)
        relations = [isinstance(part, sympy.core.relational.Relational) for part in shown]
        assert (step.kind == "relation") == (step.right is None) == all(relations)
        assert step.kind != "definition" or not step.proves
        assert step.kind != "equality" or not (is_name(step.left) or is_name(step.right))


@pytest.mark.parametrize("name", ["smith-time-series", "lelas-friction", "wells-traps"])
def test_a_line_with_a_side_altered_stops(name):
    for step in lines(name)[::4]:
        if step.kind == "equality":
            assert unnoticed(step, 1) == []


@pytest.mark.slow
@pytest.mark.parametrize("name", names())
def test_every_line_with_a_side_altered_stops(name):
    assert [said for step in lines(name) if step.kind == "equality" for said in unnoticed(step, PER_SIDE)] == []


@pytest.mark.slow
@pytest.mark.parametrize("name", names())
def test_every_relation_altered_stops(name):
    steps = (step for step in lines(name) if step.kind == "relation")
    found = {said for step in steps for relation in relations(step) for said in unnoticed_in(step, relation, PER_SIDE)}
    assert found == set()


@pytest.mark.parametrize("name", ["lelas-friction", "two-laws-time", "lelas-air"])
def test_a_relation_altered_stops(name):
    for step in (step for step in lines(name) if step.kind == "relation"):
        assert [said for relation in relations(step) for said in unnoticed_in(step, relation, 2)] == []


def test_the_walk_reaches_every_kind_of_place():
    x, y = sympy.symbols("x y", positive=True)
    h = defined("h", lambda z: z**2)
    shown = sympy.Integral(h(x) * sympy.sin(y), (x, 0, 1)) + At(x**2, {x: y + 3}) + named("U_1", x)
    found = [str(other) for other in altered(shown)]
    assert len(set(found)) >= 20  # the order of SymPy's arguments is not fixed: one may come twice
    for part in ("cos(y)", "(x, 1, 1)", "(x, 0, 2)", "h(2*x)", "Subs(x**3, x, y + 3)", "Subs(x**2, x, y + 4)", "2*U_1"):
        assert any(part in other for other in found), part
    assert not any("(2*x, 0, 1)" in other for other in found)


def test_a_line_that_cannot_fail_would_be_found():
    x = sympy.Symbol("x")
    blind = defined("D", lambda z: sympy.Integer(0))
    derivation = Derivation("d", "", source="")
    derivation.step("nothing can alter it", blind(x), 0 * x)
    assert unnoticed(derivation.steps[0], 3) == ["every alteration of D(x)"]
    assert rearranged(_line(1 / x - 1 / (x + 1), 1 / (x * (x + 1)))) and not rearranged(
        _line(sympy.Derivative(x**2, x), 2 * x)
    )


def _line(left, right):
    derivation = Derivation("d", "", source="")
    derivation.step("a line", left, right)
    return derivation.steps[0]
