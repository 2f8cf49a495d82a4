"""Where one may be counted it is one: no sentence on data says "1 rows"."""

import re
from pathlib import Path

import pytest

import asymptotics

_COUNTED = re.compile(
    r"\{len\([^{}]*\)\} (?:row|sample|value|cell|line|decrement|turning point|half-swing|amplitude)s\b"
)
_NEVER_ONE = ("label=", "are too many", "of {_WORDS", "lie {apart", "tell no law")
"""What stands behind a number that is never 1."""


@pytest.mark.parametrize("room", ["records", "identification", "comparison"])
def test_a_count_of_data_has_its_plural_from_the_one_place(room):
    """Failed before, in 20 files: "a.csv has 1 rows with numbers"."""
    found = [
        f"{path.name}: {line.strip()}"
        for path in sorted((Path(asymptotics.__file__).parent / "decays" / room).rglob("*.py"))
        for line in path.read_text().splitlines()
        if _COUNTED.search(line) and not any(words in line for words in _NEVER_ONE)
    ]
    assert found == []
