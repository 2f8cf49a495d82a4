"""What is told of a law alone has no units, and what is told of an oscillator has its own: in every result."""

import pytest

import asymptotics as asy
from asymptotics.frames import BARE, Frame

LAW = {2: "1/10"}
HEAVY = asy.Oscillator(LAW, mass="3/2", stiffness=30, x0="1/5")
SWING = asy.Oscillator(LAW, spring="pendulum", x0=1)
RESULTS = {
    "point": lambda law: asy.motion(law).at(1),
    "samples": lambda law: asy.motion(law).sample([0.0, 1.0]),
    "events": lambda law: asy.motion(law).events(7),
    "motion": asy.motion,
    "state": lambda law: asy.reference(law).at(1, digits=6),
    "states": lambda law: asy.reference(law).sample([0.0, 1.0]),
    "passages": lambda law: asy.reference(law).events(4),
    "reference": asy.reference,
    "envelope": lambda law: asy.envelope(law).sample([0.0, 1.0]),
    "turning points": lambda law: asy.turning_points(law, 2, digits=6, times=True),
}
SLOW = {"slow": lambda law: asy.envelope(law).slow()}
UNITS = (" m", " s", "[m]", "[s]", "[m/s]", "rad")


def told(result):
    """Everything that a reader sees of it, without what the law itself is called."""
    page = result._page()
    cells = [cell for row in page.rows for cell in row]
    return " | ".join([page.title, *page.lines, *page.head, *map(str, cells)])


@pytest.mark.parametrize("name", [*RESULTS, *SLOW])
def test_a_law_alone_has_no_units(name):
    """Events and points said m and s of every law: x is in units of the start there, and the time is tau."""
    text = told((RESULTS | SLOW)[name](LAW)).replace("turning points", "").replace("no units: m = k = x0 = 1", "")
    found = [unit for unit in UNITS if f"{unit} " in f"{text} " or f"{unit}," in text]
    assert not found, text


@pytest.mark.parametrize("name", RESULTS)
@pytest.mark.parametrize("oscillator, unit", [(HEAVY, "m"), (SWING, "rad")], ids=["m", "rad"])
def test_an_oscillator_has_its_own(name, oscillator, unit):
    text = told(RESULTS[name](oscillator))
    assert any(f"{mark}{unit}" in text for mark in (" ", "[")), text
    assert unit == "m" or "[m" not in text


def test_the_slow_part_of_an_oscillator_ends_in_seconds():
    assert str(asy.envelope(asy.Oscillator({"1/2": "1/10"}, mass=2)).slow("1/20")).count(" s") == 2


def test_a_file_of_a_pendulum_is_in_rad(tmp_path):
    """Its own header says rad; a column in m is another quantity."""
    path = tmp_path / "swing.csv"
    path.write_text("t [s],x [rad]\n0,1\n1,0.6053\n")
    assert asy.compare(path, SWING).rows[1].digits > "4"
    path.write_text("t [s],x [m]\n0,1\n1,0.6053\n")
    with pytest.raises(asy.InputError, match=r"x is in 'm' \(accepted: x \[rad\]"):
        asy.compare(path, SWING)


def test_a_quantity_without_a_name_of_its_own_is_a_place():
    assert [Frame("m", "s").unit(n) for n in ("t", "period", "v", "phase", "bound")] == ["s", "s", "m/s", "rad", "m"]
    assert [BARE.unit(n) for n in ("t", "v", "phase")] == ["", "", ""] and BARE.named("t") == "tau"
