"""The numbers of a response carry their units: SI of an oscillator, none of a law alone."""

import csv
import io

import pytest

import asymptotics as asy
from asymptotics import Oscillator

UNITS = {
    "amplitude": "m", "x0": "m", "v0": "m/s", "phase": "rad", "energy per cycle": "J", "amplitude of harmonic 3": "m",
    "phase of harmonic 3": "rad", "c_eq": "N s/m", "Q_decay at omega_0": "", "omega of the peak": "rad/s",
}  # fmt: skip


@pytest.fixture(scope="module")
def found():
    return asy.response(Oscillator({2: "1/10"}, mass="3/2", stiffness=30), "1/10", 4, digits=6)


def test_every_quantity_has_its_unit(found):
    named = {row[0] for row in csv.reader(io.StringIO(found.to_csv()))}
    assert {f"{name} [{unit}]" if unit else name for name, unit in UNITS.items()} <= named
    assert all(f"{name}  " in str(found) or f"{name} [{unit}]" in str(found) for name, unit in UNITS.items())
    assert found.plot().get_xlabel() == "Omega (rad/s)" and found.to_dict()["units"] == "SI"


def test_a_law_alone_has_none():
    bare = asy.response({2: "1/10"}, "1/10", 1, digits=6)
    assert "[" not in str(bare) and bare.to_dict()["units"] is None and bare.plot().get_ylabel() == "amplitude"


def test_the_units_are_those_of_the_numbers(found):
    """A hundred times the length: b v|v| and F scale with it, and so must the numbers."""
    longer = asy.response(Oscillator({2: "1/1000"}, mass="3/2", stiffness=30), 10, 4, digits=6)  # b/100, 100 F
    assert float(longer.amplitude) == pytest.approx(100 * float(found.amplitude), rel=1e-5)
    assert float(longer.energy) == pytest.approx(10**4 * float(found.energy), rel=1e-5)
    assert float(longer.first_order.c_eq) == pytest.approx(float(found.first_order.c_eq), rel=1e-5)


def test_a_data_frame_has_numbers_and_digits(found):
    table = found.to_dataframe()
    row = table[table["quantity"] == "amplitude [m]"].iloc[0]
    assert row["response"] == float(row["response (digits)"]) and row["first order"] == pytest.approx(
        0.0166665, rel=1e-5
    )
