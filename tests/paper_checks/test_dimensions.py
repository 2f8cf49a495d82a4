"""What is dimensionally false is refuted, in every statement: the dimensions of all forms are known."""

import doctest

import pytest
import sympy

from paper_checks import dimensions
from paper_checks.dimensions import UNITS, dimensionally_false
from paper_checks.registry import confirmed_form, load
from paper_checks.verdict import Outcome, Printed

ENTRIES = load()
CHECKED = {key: confirmed_form(e) for key, e in ENTRIES.items() if e.check is not None and e.verdict != Printed.OPEN}
x0, A0, b, v, m = (sympy.Symbol(name, positive=True) for name in ("x_0", "A_0", "b", "v", "m"))


def times(form, unit):
    """The form with each of its expressions in turn times a unit."""
    if isinstance(form, tuple):
        yield from ((*form[:i], other, *form[i + 1 :]) for i, part in enumerate(form) for other in times(part, unit))
    elif isinstance(form, sympy.Expr) and unit * form != form:
        yield unit * form


def test_the_examples():
    assert doctest.testmod(dimensions).failed == 0


@pytest.mark.parametrize("each", [4, pytest.param(1, marks=pytest.mark.slow)])
def test_a_unit_too_much_is_refuted_in_every_statement(each):
    for key, form in [*CHECKED.items()][::each]:
        assert not dimensionally_false(key, form, form), key
        for false in (false for unit in UNITS[ENTRIES[key].paper] for false in times(form, unit)):
            assert ENTRIES[key].check(false) == Outcome.REFUTED, (key, false)


def test_the_forms_that_once_passed():
    entry = ENTRIES["lelas2024:claim.energy-decreases"]
    assert any(dimensionally_false(entry.id, false, entry.printed) for false in times(entry.printed, x0))
    form = ENTRIES["lelas2024:claim.shifted-pairs"].printed
    assert all(dimensionally_false("lelas2024:claim.shifted-pairs", false, form) for false in times(form, m))
    omega = sympy.Symbol("omega", positive=True)
    form = ENTRIES["smith2012:claim.arctan-argument"].printed
    assert dimensionally_false("smith2012:claim.arctan-argument", omega * form, form)
