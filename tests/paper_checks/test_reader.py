"""The printed LaTeX is tied to the form: read by machine, or compared by hand and recorded."""

import random
import re
from dataclasses import replace
from itertools import islice

import pytest
import sympy

from asymptotics.verdict import Printed
from paper_checks.reader import BY_HAND, READ, UnreadableError, digest, ledger, numbered, read, read_by_machine, tied
from paper_checks.registry import load

ENTRIES = load()
NUMBERED = [entry for entry in ENTRIES.values() if numbered(entry)]
LEDGER = ledger()
DIGESTS = {**LEDGER[READ], **LEDGER[BY_HAND]}
SAMPLE = random.Random("reader").sample(sorted(LEDGER[READ]), 25)


def test_what_no_reader_reads_is_listed():
    assert set(DIGESTS) == {entry.id for entry in NUMBERED}
    assert [entry.id for entry in NUMBERED if not read_by_machine(entry)] == list(LEDGER[BY_HAND])
    assert len(LEDGER[READ]) >= 150


@pytest.mark.parametrize("key", DIGESTS)
def test_latex_and_form_are_those_that_were_compared(key):
    assert digest(ENTRIES[key]) == DIGESTS[key], f"{key}: compare LaTeX and form by hand, then --compared"


def altered(latex):
    """The formula with one digit one less, or one sign the other, each in turn."""
    for found in re.finditer(r"(?<!_)[1-9]|[+-]", latex):
        other = {"+": "-", "-": "+"}.get(found[0]) or str(int(found[0]) - 1)
        yield f"{latex[: found.start()]}{other}{latex[found.end() :]}"


@pytest.mark.parametrize("key", SAMPLE)
def test_a_digit_or_a_sign_changed_in_the_latex_unties_it(key):
    """The left side may name what the form does not hold; somewhere it must tell, unless there is no digit and sign."""
    entry = ENTRIES[key]
    told = [tied(latex, entry.printed, key) is not True for latex in islice(altered(entry.latex), 5)]
    assert any(told) or len(told) < 2


@pytest.mark.parametrize("key", ["smith2012:42", "smith2012:45", "smith2012:60d", "lelas2024:52", "lelas2024:32"])
def test_every_exponent_and_number_changed_in_the_latex_unties_it(key):
    entry = ENTRIES[key]
    for changed in altered(entry.latex.partition("=")[2]):
        assert tied(changed, entry.printed, key) is not True, changed
        assert digest(replace(entry, latex=changed)) != DIGESTS[key]


@pytest.mark.slow
@pytest.mark.parametrize("key", LEDGER[READ])
def test_most_changes_of_the_latex_untie_it(key):
    entry = ENTRIES[key]
    told = [tied(latex, entry.printed, key) is not True for latex in altered(entry.latex)]
    assert any(told) or len(told) < 2


@pytest.mark.parametrize("latex", [r"\oint x", "x +", r"\frac{x}", "y", r"x_{", "(x", r"\sin x"])
def test_what_is_not_known_is_said(latex):
    with pytest.raises(UnreadableError):
        read(latex, {"x": sympy.Symbol("x")})


def test_corrected_formulas_differ_from_the_printed_ones():
    for entry in NUMBERED:
        if entry.verdict in (Printed.MISPRINT, Printed.PARTLY):
            assert entry.corrected_latex != entry.latex
