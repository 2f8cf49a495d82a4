"""Units at every entrance: of a mass, a stiffness and a start they are obeyed, elsewhere named and refused."""

from fractions import Fraction

import mpmath
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
        sizes = {("g", "kg"): Fraction(1, 1000), ("N/mm", "N/m"): Fraction(1000), ("yd", "m"): Fraction(9144, 10_000)}
        return Quantity(self.magnitude * sizes[self.unit, unit], unit)


class Spelled(Quantity):
    """The same, its unit written as pint writes it: ``format(q.units, "~")``."""

    @property
    def units(self):
        class Unit:
            __format__ = lambda _, how: {"~": self.unit.replace("/", " / ")}[how]  # noqa: E731

        return Unit()


@pytest.mark.parametrize("mass", ["200 g", "0.2kg", "1/5 kg", Quantity(200, "g")])
@pytest.mark.parametrize("stiffness", ["20 N/m", "0.02 N/mm", Quantity(Fraction(1, 50), "N/mm")])
def test_a_mass_and_a_stiffness_may_have_their_units(mass, stiffness):
    found = asy.Oscillator({1: "1/10"}, mass=mass, stiffness=stiffness)
    assert found.mass == Fraction(1, 5) and found.stiffness == 20


@pytest.mark.parametrize(
    ("name", "value", "word"),
    [
        ("x0", "5 kg", "it has the unit kg, and m is meant"), ("v0", "3 m", "it has the unit m, and m/s is meant"),
        ("mass", "5 cm", "the unit cm, and kg is meant"), ("x0", Quantity(5, "kg"), "a quantity in .*m is meant"),
        ("x0", "20 deg", "the unit deg, and m is meant"), ("x0", "5,0 cm", "it has a comma, and decimals have a point"),
        ("v0", Spelled(5, "cm"), "a quantity in cm, and m/s is meant"), ("mass", "0,2 kg", "it has a comma"),
        ("stiffness", "1/0 N/m", "not an exact number"), ("mass", "1.2.3 kg", "not an exact number"),
    ],
)  # fmt: skip
def test_other_units_are_named_and_refused(name, value, word):
    with pytest.raises(InputError, match=f"argument {name}: .*{word}"):
        asy.Oscillator({1: "1/10"}, **{"mass": 1, "stiffness": 4, name: value})


@pytest.mark.parametrize(
    ("given", "exact"),
    [
        ("5 cm", Fraction(1, 20)), ("-50mm", Fraction(-1, 20)), ("1/20 m", Fraction(1, 20)),
        ("2 in", Fraction(127, 2500)),
        (Quantity(5, "yd"), Fraction(9144, 2000)), (Spelled(5.3, "cm"), Fraction(53, 1000)), (0.05, Fraction(1, 20)),
    ],
)  # fmt: skip
def test_a_start_may_have_its_unit_and_is_exact(given, exact):
    assert asy.Oscillator({1: "1/10"}, x0=given).x0 == exact
    assert asy.Oscillator({1: "1/10"}, v0="90 cm/s").v0 == Fraction(9, 10)
    assert asy.Oscillator({1: "1/10"}, v0=Spelled(18, "km/h")).v0 == 5


def test_the_start_of_a_pendulum_is_an_angle():
    swing = asy.Oscillator({1: "1/10"}, spring="pendulum", x0="20 deg", v0="-90 deg/s")
    with mpmath.workdps(120):
        for found, right in ((swing.x0, mpmath.pi / 9), (swing.v0, -mpmath.pi / 2)):
            assert (
                abs(mpmath.mpf(found.rational.numerator) / found.rational.denominator - right) < mpmath.mpf(10) ** -118
            )
    assert asy.Oscillator({1: 1}, spring="pendulum", x0="20\u00b0").x0 == swing.x0
    with pytest.raises(InputError, match="argument x0: .*it has the unit cm, and rad is meant"):
        asy.Oscillator({1: "1/10"}, spring="pendulum", x0="5 cm")


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
