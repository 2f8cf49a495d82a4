"""What holds for every statement of every paper: borne out, refutable, explained, shown."""

import re
from dataclasses import replace

import pytest

from asymptotics.present.mathml import mathml
from paper_checks.near_misses import LEFT, WORDS
from paper_checks.registry import expected_outcomes, forms, load
from paper_checks.report.pages import near_miss
from paper_checks.runner import examine
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

ENTRIES = load()
OPEN = [key for key, entry in ENTRIES.items() if entry.verdict == Printed.OPEN]
DECIDED = [key for key in ENTRIES if key not in OPEN]
SOUND = (Printed.HOLDS, Printed.DEFINITION)


def test_what_near_misses_have_in_words_is_needed_and_no_form_is_shown_as_it_stands_in_the_code():
    assert set(WORDS) | set(LEFT) <= {key for key, entry in ENTRIES.items() if entry.near_miss is not None}
    assert not set(WORDS) & set(LEFT)
    for key, entry in ENTRIES.items():
        if entry.near_miss is not None:
            shown = near_miss(entry)
            assert bool(shown["latex"]) != bool(shown["text"]), key
            assert key in WORDS or not re.search(r"Fraction|Rational|Symbol|\*\*|Interval|[\[{(]'", shown["latex"]), key
            assert key in WORDS or key in LEFT or "in place of" in shown["latex"], key


def planted(entry, result):
    """The statement with its near miss in the place of the printed form, or a wrong one looking right.

    Its forms have been decided in ``result``: the check is not run a second time.
    """
    decided = [(form, result.outcomes[name]) for name, form in forms(entry)]

    def check(form):
        return next(outcome for known, outcome in decided if known is form)

    return replace(entry, printed=entry.near_miss if entry.verdict in SOUND else entry.corrected, check=check)


@pytest.mark.parametrize("key", DECIDED)
def test_the_check_bears_out_the_recorded_verdict_and_can_fail_and_a_planted_fault_is_noticed(key):
    result = examine(ENTRIES[key])
    assert result.agrees, result.outcomes
    assert result.printed == ENTRIES[key].verdict
    assert result.outcomes["near miss"] == Outcome.REFUTED
    assert result.outcomes["printed"] != Outcome.UNDECIDED
    assert result.evidence == ENTRIES[key].evidence  # the label is what the check used, or a derivation
    assert result.extent == ENTRIES[key].extent
    assert result.order_by != "argued" or ENTRIES[key].evidence != Evidence.MEASURED
    assert result.apart is not None or key in (WORDS | LEFT) or " = " in near_miss(ENTRIES[key])["latex"]
    wrong = examine(planted(ENTRIES[key], result))
    assert wrong.outcomes != expected_outcomes(wrong.statement)
    assert wrong.printed == Printed.OPEN
    assert wrong.to_dict()["evidence"] == "none"


@pytest.mark.parametrize("key", OPEN)
def test_what_is_open_claims_nothing_and_says_why(key):
    assert examine(ENTRIES[key]).outcomes == {"printed": Outcome.UNDECIDED, "near miss": Outcome.REFUTED}
    assert ENTRIES[key].evidence == Evidence.NONE
    assert ENTRIES[key].note.startswith("Open: ")


def test_what_is_wrong_is_corrected_and_explained():
    for key in DECIDED:
        entry = ENTRIES[key]
        wrong = entry.verdict not in SOUND
        assert (entry.corrected_latex is not None) == (entry.corrected is not None) == wrong, key
        assert bool(entry.note) or not wrong, key
        assert entry.evidence != Evidence.NONE, key
        assert entry.methods and entry.conditions, key
        assert entry.kind != Kind.APPROXIMATION or entry.order is not None, key


def test_slips_that_change_nothing_are_listed():
    """A note that tells a reader of a slip is a slip: it stands in the errata."""
    slips = {key for key, entry in ENTRIES.items() if entry.slip}
    assert slips >= {"lelas2024:44", *(f"smith2012:{n}" for n in ("52c", "56a", "59d", "claim.maximum-velocity"))}
    telling = re.compile("should read|is meant|not equal to it|by (another|the wrong) number|The limits of")
    for key, entry in ENTRIES.items():
        assert entry.verdict not in SOUND or not telling.search(entry.note), key


def test_latex_becomes_mathml():
    for key, entry in ENTRIES.items():
        for latex in filter(None, (entry.latex, entry.corrected_latex)):
            formula = mathml(latex)
            assert formula.startswith("<math") and "\\" not in formula, (key, formula)
