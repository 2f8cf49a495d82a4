"""One list of units for what is measured: identify, damping, and the columns of files."""

import json

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.records.units import UNITS, suffix
from asymptotics.errors import InputError
from asymptotics.numbers.quantities import ANGLES, LENGTHS
from asymptotics.shell.main import main

SIZES = {"in": 0.0254, "ft": 0.3048, "mrad": 1e-3, "arcmin": np.pi / 10_800}


def record(size):
    t = np.arange(0, 60, 0.1)
    x = 0.2 * np.exp(-0.02 * t) * np.cos(2 * t) + 2e-4 * np.random.default_rng(5).standard_normal(len(t))
    return {"t": t, "x": x / size}


@pytest.mark.parametrize("unit", ["in", "ft"])
def test_a_record_in_inches_has_the_b_of_one_in_metres(unit):
    # failed before: a unit that is refused
    asked = {"laws": ["1", "2"], "mass": 2, "bootstrap": False}
    metres = asy.identify(record(1.0), unit="m", **asked)
    other = asy.identify(record(SIZES[unit]), unit=unit, **asked)
    assert other.verdict.text.split(":")[0] == metres.verdict.text.split(":")[0] == "identified"
    for law in ("1", "2"):
        one, two = (answer.law(law).to_dict()["physical"][0] for answer in (metres, other))
        assert one["quantity"] == two["quantity"] == "b"
        assert [float(two[end]) for end in ("low", "estimate", "high")] == pytest.approx(
            [float(one[end]) for end in ("low", "estimate", "high")], rel=1e-4
        )


@pytest.mark.parametrize("unit", ["mrad", "arcmin"])
def test_an_angle_in_small_units_may_be_a_pendulum(unit):
    answer = asy.identify(record(SIZES[unit]), unit=unit, laws=["1", "1+pendulum"], bootstrap=False)
    assert answer.law("1+pendulum").law.fit is not None
    with pytest.raises(InputError, match="a pendulum needs angles"):
        asy.identify(record(1.0), unit="in", laws=["1+pendulum"])


@pytest.mark.parametrize("unit", UNITS)
def test_damping_knows_every_unit_of_a_record(capsys, unit):
    angle = unit in ANGLES
    line = ["damping", "--law=2:1/10", "--mass=2", "--stiffness=3", "--json"]
    line += ["--spring=pendulum"] if angle else []
    numbers = []
    for amplitude, named in (("3/1000", unit), (str({**LENGTHS, **ANGLES}[unit] * 3 / 1000), None)):
        more = [f"--unit={named}"] if named else []
        assert main([*line, f"--amplitudes={amplitude}", *more]) == 0
        numbers.append(json.loads(capsys.readouterr().out)["rows"][0]["first"]["zeta"])
    assert numbers[0] == numbers[1]
    wrong = "rad" if not angle else "m"
    assert main([*line, "--amplitudes=1", f"--unit={wrong}"]) == 2
    assert "is no unit of these amplitudes" in capsys.readouterr().err


@pytest.mark.parametrize("unit", ["V", "counts", "%", "furlong"])
def test_what_has_no_size_is_refused_by_both(unit):
    with pytest.raises(InputError, match="unit"):
        asy.identify(record(1.0), unit=unit)
    with pytest.raises(InputError, match="unit"):
        asy.damping(asy.Oscillator({2: "1/10"}), [1], unit=unit)


@pytest.mark.parametrize(
    ("column", "unit"),
    [("x [in]", "in"), ("x_inch", "in"), ("x_in", ""), ("height (feet)", "ft"), ("phi_mrad", "mrad"), ("x / in", "in")],
)
def test_the_unit_of_a_column(column, unit):
    assert suffix(column) == unit
