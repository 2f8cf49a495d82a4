"""Every statement of the paper: present, borne out by its check, and refutable."""

from importlib import import_module

import pytest

from paper_checks.registry import load
from paper_checks.smith2012 import figures
from paper_checks.verdict import Printed

ENTRIES = load("smith2012")

LETTERED = {
    1: "ab",
    4: "ab",
    18: "ab",
    20: "abcd",
    24: "abcd",
    27: "abc",
    38: "ab",
    39: "ab",
    46: "abc",
    52: "abc",
    56: "abcd",
    59: "abcd",
    60: "abcdefgh",
    62: "ab",
}
NUMBERED = [
    f"{number}{letter}" for number in range(1, 73) for letter in (LETTERED.get(number) or ("",))
]  # (1a)-(72) as the paper numbers them
TABLE = ["table1.S", *(f"table1.{column}{row}" for row in range(6) for column in ("S", "u"))]
FIGURES = [f"fig{number}" for number in range(1, 8)]
NOT_HOLDING = {  # found by hand from the paper's own equations, see the notes of the entries
    "claim.integrating-factor-exists": "partly",
    "claim.hat-T": "partly",
    "31": "partly",
    "34": "misprint",
    "claim.integrating-factors": "misprint",
    "38b": "misprint",
    "40": "misprint",
    "48": "misprint",
    "49": "misprint",
    "51": "misprint",
    "52a": "misprint",
    "52b": "misprint",
    "54": "misprint",
    "55": "misprint",
    "56b": "transcription",
    "56c": "transcription",
    "62b": "misprint",
    "63": "misprint",
    "71": "partly",
    "72": "misprint",
    "table1.S3": "misprint",
    "table1.S5": "misprint",
    "claim.second-cycle": "partly",
    "claim.inversion": "partly",
    "claim.not-identifiable": "refuted",
    "claim.iterations": "partly",
}


def short(key: str) -> str:
    return key.removeprefix("smith2012:")


def test_the_ids_are_the_papers_numbering():
    ids = {short(key) for key in ENTRIES}
    claims = {key for key in ids if key.startswith("claim.")}
    assert ids - claims == {*NUMBERED, *TABLE, *FIGURES, "fn8"}
    assert len(claims) >= 20


def test_entries_stand_in_reading_order():
    numbers = [short(key) for key in ENTRIES if short(key)[:1].isdigit()]
    assert numbers == NUMBERED


def test_verdicts_other_than_holds():
    exceptions = (Printed.HOLDS, Printed.DEFINITION)
    found = {short(key): str(entry.verdict) for key, entry in ENTRIES.items() if entry.verdict not in exceptions}
    assert found == NOT_HOLDING


@pytest.mark.parametrize("name", sorted(figures.FIGURES))
def test_the_curves_fill_the_picture(name):
    axes = import_module("matplotlib.figure").Figure().subplots()
    figures.FIGURES[name][1](axes)
    for limits, data in ((axes.get_xlim(), axes.dataLim.intervalx), (axes.get_ylim(), axes.dataLim.intervaly)):
        assert (data[1] - data[0]) / (limits[1] - limits[0]) > 0.7
