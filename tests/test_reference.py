"""The docstrings of the public names, as ``help`` and the pages of the reference show them: every parameter has a type
and a meaning, every function an example, and no signature spells out a union that has a name."""

import inspect
import re
import sys
from importlib import import_module
from pathlib import Path

import pytest

from tests.each import each

ROOT = Path(__file__).parents[1]
NAMES = re.findall(r"^reference/([\w.]+)$", (ROOT / "docs/api.md").read_text(encoding="utf-8"), re.MULTILINE)
UNTYPED = {  # Matplotlib's own, and what is read by its columns or as an array, whatever library made it
    "ax", "style", "results", "data", "file", "table", "A", "y", "psi", "epsilon", "x",
}  # fmt: skip
EVERYWHERE = {"self", "cls", "max_seconds"}  # the last: docs/api.md says it once for all methods


@pytest.fixture(scope="module")
def reference():
    sys.path.insert(0, str(ROOT / "docs/extensions"))
    yield import_module("reference")
    sys.path.remove(str(ROOT / "docs/extensions"))


def calls(found):
    """(name, function) of a public name: the function itself, or the methods of a class."""
    if inspect.isfunction(found):
        yield found.__name__, found
    elif isinstance(found, type) and not issubclass(found, Exception):
        for member, made in vars(found).items():
            function = getattr(made, "__func__", made)
            if not member.startswith("_") and inspect.isfunction(function):
                yield f"{found.__name__}.{member}", function


def section(docstring, title):
    """A section of a numpydoc docstring; empty where there is none."""
    found = re.search(rf"^{title}\n-+\n(.*?)(?=^\w+\n-+\n|\Z)", docstring, re.MULTILINE | re.DOTALL)
    return found[1].strip() if found else ""


def untold(name, function):
    """The parameters that a docstring does not explain: functions in their section, methods in their sentences."""
    told = inspect.getdoc(function) or ""
    named = set(re.findall(r"^(\w+)\n    \S", section(told, "Parameters"), re.MULTILINE))
    if "." in name:
        named |= EVERYWHERE | set(re.findall(r"\b\w+\b", " ".join(re.findall(r"``(.*?)``", told))))
        named |= {word for word in re.findall(r"\w+", told) if len(word) == 1}  # A, t: the letters of formulas
    return set(inspect.signature(function).parameters) - named


@each("name", NAMES)
def test_every_parameter_has_a_type_and_a_meaning(reference, name):
    for call, function in calls(reference.thing(name)):
        assert not untold(call, function), call
        for parameter, its in inspect.signature(function).parameters.items():
            typed = str(its.annotation) not in ("Any", "typing.Any", str(inspect.Parameter.empty))
            assert typed or parameter in UNTYPED | EVERYWHERE, (call, parameter)


@each("name", NAMES)
def test_no_signature_spells_out_a_type_that_has_a_name(reference, name):
    for call, function in calls(reference.thing(name)):
        shown = str(reference.readable(function))
        assert "Decimal" not in shown and "asymptotics." not in shown and " at 0x" not in shown, (call, shown)


@each("name", [name for name in NAMES if name[0].islower() and name.rpartition(".")[2][0].islower()])
def test_every_function_says_what_it_returns_and_has_an_example(reference, name):
    found = reference.thing(name)
    told, shown = inspect.getdoc(found), str(inspect.signature(found).return_annotation)
    assert ">>> " in section(told, "Examples") or ">>> " in told
    assert section(told, "Returns") or shown[0].isupper() and shown != "Any", shown


def test_what_is_missing_is_noticed(reference):
    def stray(unheard_of: int, told: int) -> int:
        """Nothing.

        Parameters
        ----------
        told
            something
        """
        return unheard_of + told

    assert untold("stray", stray) == {"unheard_of"} and untold("Of.a_class", stray) == {"unheard_of"}
    assert section(inspect.getdoc(stray), "Parameters") == "told\n    something" and section("none", "Raises") == ""


def test_text_is_no_markup_and_formulas_stand_as_they_are(reference):
    assert reference.escaped("|x|*2_ and ``code|``") == r"\|x\|\*2\_ and ``code|``"
    shown = reference.plain(
        ["a_b:", "", "    a*b", "", ">>> 2*3", "Traceback:", "    ...", "", "Raises", "------", "E", "    a_b"]
    )
    assert shown == [
        r"a\_b:", "", "::", "", "    a*b", "", ">>> 2*3", "Traceback:", "    ...", "", "Raises", "------", "E",
        r"    a\_b",
    ]  # fmt: skip


def test_every_page_is_set_by_autodoc(reference):
    assert reference.page("motion").endswith(".. autofunction:: asymptotics.motion\n")
    assert ".. autoclass:: asymptotics.terms.Term\n   :members:" in reference.page("terms.Term")
