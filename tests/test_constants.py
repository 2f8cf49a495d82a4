"""Constants that decide cost: what stands in ``benchmarks/constants.json`` is about the values that the library has."""

import json
import re
from pathlib import Path

from benchmarks import constants
from benchmarks.constants import CONSTANTS, RECORD, Constant, instead

ROOT = Path(__file__).parents[1] / "asymptotics"


def found():
    return json.loads(RECORD.read_text(encoding="utf-8"))


def test_the_record_names_every_constant_with_its_present_value():
    recorded = found()["constants"]
    assert recorded.keys() == {c.name for c in CONSTANTS}
    for c in CONSTANTS:
        assert recorded[c.name]["present"] == repr(c.present), c.name
        assert [row["value"] for row in recorded[c.name]["measured"]] == [repr(v) for v in c.values], c.name
        assert c.present in c.values and all(set(c.tasks) < set(row) for row in recorded[c.name]["measured"])


def test_what_refers_to_the_record_is_in_it():
    """Each file that says so has a constant there, and each constant a comment that says so."""
    said = {p for p in ROOT.rglob("*.py") if "benchmarks/constants.json" in p.read_text(encoding="utf-8")}
    assert {p.relative_to(ROOT).with_suffix("").as_posix().replace("/", ".") for p in said} == {
        c.module for c in CONSTANTS
    }


def test_no_origin_is_unknown():
    unknown = re.compile(r"(is|are|was|were)[\s#]+not[\s#]+recorded")
    assert unknown.search("where they\n# were fitted is not\n# recorded.")
    assert not [p for p in ROOT.rglob("*.py") if unknown.search(p.read_text(encoding="utf-8"))]


def test_a_value_is_put_in_and_taken_out_again():
    one = Constant("bounds.late", "ORDERS", ({1: 3}, {1: 9, 2: 5}), {"it": lambda: float(one.present[1])}, "order")
    with instead(one, {1: 3}):
        assert one.present == {1: 3} and constants.measured(one.tasks["it"], 1)["quality"] == 3
    assert one.present == {1: 9, 2: 5}


def test_what_a_poor_value_meets_is_recorded():
    assert constants.measured(lambda: 1 / 0, 1) == {"refused": "ZeroDivisionError"}
