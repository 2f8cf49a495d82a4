"""The printed LaTeX is tied to the form: read by machine, or compared by hand and recorded."""

import re
from dataclasses import replace

import pytest
import sympy

from asymptotics.verdict import Printed
from paper_checks.reader import UnreadableError, digest, ledger, numbered, read, read_by_machine, tied
from paper_checks.registry import load

NUMBERED = [entry for entry in load().values() if numbered(entry)]
LEDGER = ledger()


READ = [entry for entry in NUMBERED if read_by_machine(entry)]


def test_every_numbered_equation_is_recorded():
    assert set(LEDGER) == {entry.id for entry in NUMBERED}


def test_the_reader_ties_a_good_part_of_them():
    assert len(READ) >= 45


@pytest.mark.parametrize("key", LEDGER)
def test_latex_and_form_are_those_that_were_compared(key):
    assert digest(load()[key]) == LEDGER[key], f"{key}: compare LaTeX and form by hand, then --compared"


@pytest.mark.parametrize("key", ["smith2012:42", "smith2012:45", "smith2012:60d", "lelas2024:52", "lelas2024:32"])
def test_an_exponent_or_number_changed_in_the_latex_unties_it(key):
    entry = load()[key]
    for found in re.finditer(r"(?<![_\d])[2-9](?!\d)", entry.latex):
        changed = f"{entry.latex[: found.start()]}{int(found[0]) - 1}{entry.latex[found.end() :]}"
        assert tied(changed, entry.printed) is not True, changed
        assert digest(replace(entry, latex=changed)) != LEDGER[key]


@pytest.mark.parametrize("latex", [r"\int x dx", "x +", r"\frac{x}", "y", r"x_{", "(x", r"\sin x"])
def test_what_is_not_known_is_said(latex):
    with pytest.raises(UnreadableError):
        read(latex, {"x": sympy.Symbol("x")})


def test_corrected_formulas_differ_from_the_printed_ones():
    for entry in NUMBERED:
        if entry.verdict in (Printed.MISPRINT, Printed.PARTLY):
            assert entry.corrected_latex != entry.latex
