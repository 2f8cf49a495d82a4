"""Every form mutated: each mutant is refuted, or says the same for a stated reason."""

import random

import pytest
import sympy

from paper_checks.dimensions import UNITS
from paper_checks.equivalents import EQUIVALENT, reason
from paper_checks.forms import defect
from paper_checks.mutants import mutants, survivors
from paper_checks.registry import confirmed_form, load
from paper_checks.verdict import Outcome, Printed
from tests.each import each

STATEMENTS = load()
CHECKED = [key for key, entry in STATEMENTS.items() if entry.verdict != Printed.OPEN]
SAMPLE = sorted(CHECKED, key=lambda key: random.Random(key).random())[:32]  # a new statement changes one at most


def unexplained(key):
    entry = STATEMENTS[key]
    return [name for name, _ in survivors(entry) if reason(key, name.rpartition(": ")[0]) is None]


@pytest.mark.parametrize("key", SAMPLE)
def test_a_sample_of_mutants_is_refuted(key):
    entry = STATEMENTS[key]
    found = list(mutants(confirmed_form(entry), UNITS[entry.paper]))
    for name, mutant in random.Random(key).sample(found, min(2, len(found))):
        assert reason(key, name) or entry.check(mutant) == Outcome.REFUTED, (name, mutant)


@each("key", CHECKED)
def test_nothing_infinite_empty_or_of_another_shape_passes(key):
    entry = STATEMENTS[key]
    for mutant in (sympy.nan, float("nan"), (), "", {}, None, (sympy.nan,), sympy.zoo):
        if mutant != entry.printed:
            assert entry.check(mutant) == Outcome.REFUTED, mutant


@pytest.mark.slow
@pytest.mark.parametrize("key", CHECKED)
def test_every_mutant_is_refuted_or_says_the_same(key):
    assert unexplained(key) == []


@pytest.mark.slow
@pytest.mark.parametrize("key", EQUIVALENT)
def test_each_explained_mutant_survives(key):
    survived = {name.rpartition(": ")[0] for name, _ in survivors(STATEMENTS[key])}
    for pattern in EQUIVALENT[key]:
        assert any(reason(key, name) == EQUIVALENT[key][pattern] for name in survived), pattern


def test_a_near_miss_is_a_form_of_its_own():
    for key, entry in STATEMENTS.items():
        own = [form for form in (entry.printed, entry.corrected) if form is not None]
        if entry.near_miss is not None and own:
            assert defect(entry.near_miss, own) not in ("not finite", "empty"), key
