"""What is called proved is proved for every value: a loop over chosen values is a sample, or exhausts its cases."""

import ast
import inspect
import textwrap

from paper_checks.evidence import Marks, mark, recorded, sampled
from paper_checks.registry import load
from paper_checks.report.words import evidence
from paper_checks.verdict import Evidence
from tests.each import each

PROVED = {
    inspect.unwrap(entry.check): key
    for key, entry in load().items()
    if entry.check and entry.evidence == Evidence.PROVED and entry.line is None
}
TOOLS = ("paper_checks.identities", "paper_checks.evidence", "paper_checks.forms", "paper_checks.registry")
EXHAUSTED = {  # what is looped over, and why there are no other cases
    "(0, 1, 2)": "the statement names these three exponents",
    "(1, -1)": "both signs of the velocity",
    "(X1, X2, V1, V2)": "the four quantities of the statement",
    "(-1, 1)": "both signs of the velocity",
    "(w0, 0, -w0)": "the three signs of the velocity; both sides scale with its size",
    "zip(form, (2, 0, -2))": "the three signs of the velocity; both sides scale with its size",
    "(1, 2)": "the first two orders, which the statement names",
    "range(3)": "three exponents, or three dimensions",
    "range(4)": "the four quarter periods of a period",
    "range(form[0])": "the orders below the stated one",
    "(ENERGY, CLOCK)": "the two constants of one motion",
    "POWERS": "the three laws of the paper, n = 0, 1, 2",
    "PANELS": "the two panels of the figure",
    "VS": "the components of the velocity",
    "BOUNDS.items()": "the three bounds of the paper",
    "(sympy.Integer(1), sympy.Rational(3, 5))": "two orbits that may refute; what is confirmed is reduced to zero",
    "PFAFFIAN": "the two components",
}


def reached(check, seen):
    """The functions of the paper that the check calls, itself included."""
    if check in seen or not check.__module__.startswith("paper_checks") or check.__module__ in TOOLS:
        return seen
    seen.append(check)
    for node in ast.walk(tree(check)):
        called = check.__globals__.get(node.id) if isinstance(node, ast.Name) else None
        if inspect.isroutine(called) or hasattr(called, "__wrapped__"):
            called = inspect.unwrap(called)
            if inspect.isfunction(called):
                reached(called, seen)
    return seen


def tree(function):
    """The body alone: the statement above it is data."""
    (node,) = ast.parse(textwrap.dedent(inspect.getsource(function))).body
    node.decorator_list = []
    return node


def chosen(function):
    """The loops of a function over values that stand in the code."""
    for node in ast.walk(tree(function)):
        if isinstance(node, ast.For | ast.comprehension) and fixed(node.iter, function):
            yield ast.unparse(node.iter)


def fixed(values, function):
    """Whether values are looped over that stand in the code: literals, ranges, constants, not what a form brings."""
    if isinstance(values, ast.Call) and ast.unparse(values.func) in ("sampled", "enumerate"):
        return values.func.id == "enumerate" and fixed(values.args[0], function)
    names = {n.id for n in ast.walk(values) if isinstance(n, ast.Name)}
    numbers = any(isinstance(n, ast.Constant) and isinstance(n.value, int | float) for n in ast.walk(values))
    return numbers or bool(names) and all(name.isupper() and name in function.__globals__ for name in names)


@each("check", PROVED)
def test_what_is_proved_without_a_derivation_looks_at_every_case(check):
    loops = [loop for function in reached(check, []) for loop in chosen(function)]
    assert [loop for loop in loops if loop not in EXHAUSTED] == []


def test_no_reason_is_left_over():
    found = {loop for check in PROVED for function in reached(check, []) for loop in chosen(function)}
    assert set(EXHAUSTED) <= found, set(EXHAUSTED) - found


def test_a_sample_is_no_proof():
    with recorded() as marks:
        for _ in sampled(range(3)):
            mark(Evidence.PROVED)
    assert (marks.weakest, marks.extent) == (Evidence.MEASURED, "sampled: 3 points")
    assert Marks([Evidence.CERTIFIED], 3).weakest == Evidence.CERTIFIED
    assert (Marks([Evidence.PROVED]).weakest, Marks([Evidence.PROVED]).extent) == (Evidence.PROVED, "")
    assert Marks().weakest == Evidence.PROVED


def test_one_exact_example_and_what_is_read_off_are_neither_measured_nor_proved():
    one, read = "exact, one example", "read off the text"
    found = {key: entry.extent for key, entry in load().items() if entry.extent in (one, read)}
    assert [key for key in found if found[key] == one] == [f"smith2012:{n}" for n in (14, 15, 16, 21, 22)]
    assert [key.partition(".")[2] for key in found if found[key] == read] == [
        "number-of-sections", "force-of-47", "figure-of-section-6",
    ]  # fmt: skip
    assert not any("1 points" in entry.extent for entry in load().values())
    for extent in (one, read):
        shown = evidence({"evidence": "measured", "extent": extent, "order": None, "digits": None})
        assert shown == f"{extent.capitalize()}."
