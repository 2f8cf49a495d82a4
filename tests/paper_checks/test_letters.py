"""Every check of a formula varies the letters of the formula; what it holds fixed is the statement's own."""

import pytest
import sympy

from paper_checks.identities import same
from paper_checks.lancaster2020.section_4_validity import E, _not_yet, _within, q, valid_for_any_strength
from paper_checks.letters import frozen, frozen_letters
from paper_checks.registry import confirmed_form, load
from paper_checks.verdict import Evidence, Outcome, Printed

ENTRIES = load()
FAMILIES = [  # what is not reduced to zero with its letters in it: there the letters have numbers
    key
    for key, entry in ENTRIES.items()
    if entry.check and entry.verdict != Printed.OPEN and entry.evidence != Evidence.PROVED
]
GIVEN = {  # letters that the statement itself gives a number: it is about that number
    **dict.fromkeys(
        (f"lelas2024:value.{name}-{panel}" for name in ("tau", "tau-tilde") for panel in "ab"),
        {"g", "mu", "omega_0", "x_0"},
    ),
    "lelas2024:claim.general-forms": {"phi_0"},  # measured from rest, where it is 0; its derivative has the letter
    **dict.fromkeys((f"lelas2024:value.tau-exact-{panel}" for panel in "ab"), {"omega_0"}),
}
SLOW = (
    "lancaster2020:13", "lancaster2020:21", "lancaster2020:claim.large-b-agreement",
    "lancaster2020:claim.no-restriction", "lancaster2020:claim.valid-for-any-b", "lelas2024:47", "lelas2024:48",
    "lelas2024:51", "smith2012:16", "smith2012:21", "smith2012:61", "smith2012:69",
)  # fmt: skip


@pytest.mark.parametrize("key", [pytest.param(k, marks=pytest.mark.slow) if k in SLOW else k for k in FAMILIES])
def test_no_letter_of_a_form_stands_still(key):
    assert set(frozen_letters(ENTRIES[key])) == GIVEN.get(key, set())


def test_a_check_at_one_exponent_is_noticed():
    wrong = sympy.Max(1, (1 + q) * E ** (1 / (1 + q))) / q  # what the check at alpha = 2 alone confirmed
    right = confirmed_form(ENTRIES["lancaster2020:claim.valid-for-any-b"])
    assert same(wrong.subs(q, 1), right.subs(q, 1)) == Outcome.CONFIRMED

    def at_two_alone(form):
        times = [20 * form.subs({q: 1, E: e}) for e in (1, 100)]
        found = [_within(sympy.Integer(2), e, time) for e, time in zip((1, 100), times)]
        return next((outcome for outcome in found if outcome != Outcome.CONFIRMED), Outcome.CONFIRMED)

    assert at_two_alone(wrong) == at_two_alone(right) == Outcome.CONFIRMED
    assert "q" in frozen(at_two_alone, right)
    assert valid_for_any_strength(wrong) == Outcome.REFUTED


@pytest.mark.parametrize("power", [-2, -1, 1, 2])
def test_other_powers_of_the_distance_to_linear_damping_are_refuted(power):
    other = sympy.Max(1, (1 + q) * E ** (1 / (1 + q)) / q * q**power) / q
    assert valid_for_any_strength(other) == Outcome.REFUTED


def test_neither_too_early_nor_too_late():
    two, creep = sympy.Integer(2), 2 * sympy.sqrt(E)  # T_c at alpha = 2, where half-swings are quick
    assert _not_yet(two, creep) == Outcome.CONFIRMED
    assert _not_yet(two, 100 * creep) == Outcome.REFUTED
    assert _within(two, 100, 20 * creep.subs(E, 100)) == Outcome.CONFIRMED
    assert _within(two, 100, 4 * creep.subs(E, 100)) == Outcome.REFUTED
