"""Percentages are digits: never an exponent, whatever the share is."""

import re
from pathlib import Path

import numpy as np
import pytest

import asymptotics
from asymptotics.present.percent import percent
from tests.each import each

_G_FORMAT = re.compile(r"\{[^{}]*:\.\d+[ge]\} ?%")


@each("share", [*np.logspace(-4.99, 6, 111).tolist(), 0.994, 0.995, 0.9949999, 0.9996, 1.0, 0.0])
def test_a_share_is_told_in_digits_to_two_places(share):
    said = percent(share)
    assert re.fullmatch(r"\d+(\.\d+)? %", said), said
    assert float(said[:-2]) == pytest.approx(100 * share, rel=0.0501)


@each("share", [*np.logspace(-16, -5.01, 40).tolist(), -1e-15, 5e-324])
def test_a_share_of_nothing_is_told_as_below_a_limit(share):
    """Failed before: "0.0000000000089 % of the loss"."""
    assert percent(share) == "below 0.001 %"


def test_no_percentage_is_written_in_the_g_format():
    root = Path(asymptotics.__file__).parent
    files = [path for path in root.rglob("*.py") if path.name != "percent.py"]
    found = [str(path) for path in files if _G_FORMAT.search(path.read_text(encoding="utf-8"))]
    assert found == []
    assert _G_FORMAT.search('f"{100 * share:.2g} % of the loss"')  # which it would see
