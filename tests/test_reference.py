"""One page for each public name, with its sections: every parameter has a type and a meaning, every call an example."""

import inspect
import re
import sys
from importlib import import_module
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
NAMES = re.findall(r"^reference/([\w.]+)$", (ROOT / "docs/api.md").read_text(encoding="utf-8"), re.MULTILINE)
UNTYPED = {  # Matplotlib's own, and what is read by its columns or as an array, whatever library made it
    "ax", "style", "results", "data", "file", "table", "A", "y", "psi", "epsilon", "x",
}  # fmt: skip


@pytest.fixture(scope="module")
def reference():
    sys.path.insert(0, str(ROOT / "docs/extensions"))
    yield import_module("reference")
    sys.path.remove(str(ROOT / "docs/extensions"))


def calls(reference, name):
    """(name of a call, its function, its question if it is one) of a page: the function, or the methods of a class."""
    found = reference.thing(name)
    if inspect.isfunction(found):
        yield name, inspect.unwrap(found), getattr(found, "__question__", None)
    elif isinstance(found, type) and not issubclass(found, Exception):
        for member, made in vars(found).items():
            function = getattr(made, "__func__", made)
            if not member.startswith("_") and inspect.isfunction(function):
                yield f"{name}.{member}", inspect.unwrap(function), None


@pytest.mark.parametrize("name", NAMES)
def test_every_parameter_has_a_type_and_a_meaning(reference, name):
    for call, function, declared in calls(reference, name):
        for parameter, annotation in reference.parameters(reference.definition(function)):
            assert reference.explained(call, parameter, declared), (call, parameter)
            assert annotation and (annotation != "Any" or parameter in UNTYPED), (call, parameter)


@pytest.mark.parametrize("name", NAMES)
def test_every_page_has_its_sections(reference, name):
    text, found = reference.page(name, ["expand"]), reference.thing(name)
    heads = re.findall(r"\.\. rubric:: (.+)", text)
    assert text.startswith(f"asymptotics.{name}\n") and "See also" in heads
    assert "object at 0x" not in text and "```" not in text
    if inspect.isfunction(found):
        wanted = {"Returns", "Examples", "Source"}
        assert wanted <= set(heads) and (">>> " in text), heads
        assert ("Parameters" in heads) == bool(inspect.signature(found).parameters)
    elif not issubclass(found, Exception):
        assert "Source" in heads


def test_what_is_refused_stands_in_a_section_of_its_own(reference):
    told = reference.raised("Answers. InputError for x <= -1.5, LimitError beyond. Source: a book.\n\n>>> 1\n1\n")
    assert told == ["InputError for x <= -1.5, LimitError beyond."]
    assert reference.raised("Nothing is refused.") == []
    with_raises = [name for name in NAMES if "rubric:: Raises" in reference.page(name, [])]
    assert len(with_raises) > 20 and "expand" in with_raises


def test_a_missing_meaning_and_a_missing_example_are_noticed(reference):
    def stray(unheard_of: int) -> int:
        """Nothing."""
        return unheard_of

    assert reference.meaning("stray", "unheard_of") is None and reference.meaning("compare", "digits")
    assert reference.examples(stray) == []
    assert reference.parameters(reference.definition(stray)) == [("unheard_of", "int")]
    assert reference.signature(reference.definition(stray)) == "(unheard_of)"


def test_text_is_no_markup(reference):
    assert reference._prose("|x'|*2_ and ``code|``") == r"\|x'\|\*2\_ and ``code|``"


def test_nothing_is_explained_twice(reference):
    """Parameters of questions are explained in their docstrings: the list has those of other calls alone."""
    needed = set()
    for name in NAMES:
        for call, function, declared in calls(reference, name):
            own = set() if declared is None else {asked.name for asked in declared.asked}
            for parameter, _ in reference.parameters(reference.definition(function)):
                needed |= set() if parameter in own else {parameter, f"{call}.{parameter}"}
    assert set(import_module("parameters").MEANINGS) <= needed
