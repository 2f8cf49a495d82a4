"""Units at every entrance: of a mass and a stiffness they are obeyed, elsewhere named and refused."""

from fractions import Fraction

import pytest

import asymptotics as asy
from asymptotics.errors import InputError
from asymptotics.numbers.policy import exact_number
from asymptotics.shell.main import main


class Quantity:
    """As pint's: a magnitude, and its conversion."""

    def __init__(self, magnitude, unit):
        self.magnitude, self.unit = magnitude, unit

    def to(self, unit):
        size = {("g", "kg"): Fraction(1, 1000), ("N/mm", "N/m"): Fraction(1000)}[self.unit, unit]
        return Quantity(self.magnitude * size, unit)


@pytest.mark.parametrize("mass", ["200 g", "0.2kg", "1/5 kg", Quantity(200, "g")])
@pytest.mark.parametrize("stiffness", ["20 N/m", "0.02 N/mm", Quantity(Fraction(1, 50), "N/mm")])
def test_a_mass_and_a_stiffness_may_have_their_units(mass, stiffness):
    found = asy.Oscillator({1: "1/10"}, mass=mass, stiffness=stiffness)
    assert found.mass == Fraction(1, 5) and found.stiffness == 20


@pytest.mark.parametrize(
    ("name", "value", "word"),
    [
        ("x0", "5 cm", "it has the unit cm"), ("v0", "3 m/s", "it has the unit m/s"), ("mass", "5 cm", "the unit cm"),
        ("x0", Quantity(5, "cm"), "a quantity with a unit"), ("mass", "0,2 kg", "it has a comma"),
        ("stiffness", "1/0 N/m", "not an exact number"), ("mass", "1.2.3 kg", "not an exact number"),
    ],
)  # fmt: skip
def test_other_units_are_named_and_refused(name, value, word):
    with pytest.raises(InputError, match=f"argument {name}: .*{word}"):
        asy.Oscillator({1: "1/10"}, **{"mass": 1, "stiffness": 4, name: value})


def test_what_has_no_unit_is_read_as_before():
    assert exact_number("1e3", "mass") == 1000 and exact_number("3/2", "mass") == Fraction(3, 2)
    for text in ("kg", "5 parsec", "5e", "sqrt(2) kg"):
        with pytest.raises(InputError, match="is not an exact number .accepted"):
            exact_number(text, "mass")


def test_the_shell_reads_them_in_every_command(capsys):
    line = ["motion", "--alpha", "2", "--damping", "1/10", "--x0", "1/5", "--time", "1", "--order", "1", "--json"]
    assert main([*line, "--mass", "200 g", "--stiffness", "0.02 N/mm"]) == 0
    first = capsys.readouterr().out
    assert main([*line, "--mass", "1/5", "--stiffness", "20"]) == 0
    assert '"x": "' in first and first.split('"x"')[1] == capsys.readouterr().out.split('"x"')[1]
    assert main(["motion", *line[1:], "--mass", "1 m", "--stiffness", "20"]) == 2
    assert "argument --mass: '1 m' is not an exact number: it has the unit m" in capsys.readouterr().err
