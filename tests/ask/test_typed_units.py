"""Units behind the numbers of every command that has a start: the answer is that of the plain number, files too."""

import json

import pytest

from asymptotics.ask.moving import PHYSICAL
from asymptotics.ask.registry import QUESTIONS, loaded
from asymptotics.shell.main import main
from tests.each import each
from tests.every_question import example, options_of, without_law

STARTED = [name for name in QUESTIONS if "--x0" in options_of(name)]
UNITS = {"x0": ("5 cm", "0.05"), "v0": ("30 cm/s", "0.3"), "mass": ("200 g", "0.2"), "stiffness": ("2 N/cm", "200"),
         "time": ("500 ms", "0.5")}  # fmt: skip


def line(name, folder, units):
    """The example of a command in SI, its numbers with units or plain."""
    words = without_law(example(name, folder))
    for option in (f"--{name}" for name in UNITS):
        if option in words:
            del words[words.index(option) : words.index(option) + 2]
    given = [f"--{o}={UNITS[o][not units]}" for o in UNITS if f"--{o}" in options_of(name)]
    return [*words, *given, "--alpha=2", "--damping=1/10"]


def found(capsys, words):
    assert main([*words, "--json", "--quiet"]) == 0, capsys.readouterr().err
    return {k: v for k, v in json.loads(capsys.readouterr().out).items() if k not in ("files", "seconds")}


@pytest.mark.parametrize("name", STARTED)
def test_a_start_with_units_has_the_answer_of_the_plain_one(name, tmp_path, capsys):
    assert found(capsys, line(name, tmp_path, True)) == found(capsys, line(name, tmp_path, False))


@pytest.mark.parametrize("name", [n for n in STARTED if loaded(n).offers.table and loaded(n).offers.again is not None])
def test_a_file_says_the_plain_numbers_and_is_compared_back(name, tmp_path, capsys):
    words = line(name, tmp_path, True)
    if "--order" in words:
        words = [*words[: words.index("--order")], *words[words.index("--order") + 2 :]]
    if name == "motion":
        words.append("--reference")
    words += ["--points=3"] if "--points" in options_of(name) else []
    assert main([*words, "--csv", str(tmp_path / "found.csv"), "--quiet"]) == 0
    head = (tmp_path / "found.csv").read_text().partition("\n")[0]
    assert "--x0=1/20" in head and "--mass=1/5" in head and "cm" not in head and " g" not in head
    capsys.readouterr()
    if name != "solution":  # an approximation, which no route certifies
        assert main(["compare", str(tmp_path / "found.csv"), "--json"]) == 0
        summary = json.loads(capsys.readouterr().out)["summary"]
        assert summary["all_right"] == summary["values"] > 0


@each("name", STARTED)
@each(
    ("given", "said"),
    [
        ("5 kg", "it has the unit kg, and m is meant"),
        ("5,0 cm", "it has a comma"),
        ("20 deg", "it has the unit deg, and m is meant"),
    ],
)
def test_another_unit_and_a_comma_are_named(name, given, said, tmp_path, capsys):
    words = [w for w in line(name, tmp_path, False) if not w.startswith("--x0")]
    assert main([*words, f"--x0={given}"]) == 2
    assert f"argument --x0: '{given}' is not an exact number: {said}" in (err := capsys.readouterr().err), err


@pytest.mark.parametrize("name", STARTED)
def test_a_law_alone_has_no_metres(name, tmp_path, capsys):
    si = tuple(f"--{o}" for o in PHYSICAL)
    words = [w for w in line(name, tmp_path, False) if not w.startswith((*si, "--x0"))]
    assert main([*words, "--epsilon=1/10", "--x0=5 cm"]) == 2
    assert "argument --x0: '5 cm' has the unit cm, and a law alone has none" in (err := capsys.readouterr().err), err


def test_a_pendulum_alone_starts_at_degrees_and_has_no_seconds(capsys):
    swing = ["turning-points", "--law=2:1/10", "--spring=pendulum", "--count=2", "--digits=12"]
    degrees, radians = found(capsys, [*swing, "--x0=170 deg"]), found(capsys, [*swing, "--x0=2.967059728390360"])
    assert [p["x"][:12] for p in degrees["points"]] == [p["x"][:12] for p in radians["points"]]
    assert main([*swing, "--x0=1", "--v0=3 deg/s"]) == 2
    assert "argument --v0: '3 deg/s' has the unit deg/s, and a law alone has none" in capsys.readouterr().err
    assert main([*swing, "--x0=5 cm"]) == 2
    assert "it has the unit cm, and rad is meant" in capsys.readouterr().err


def test_what_rests_rests_with_units_too(capsys):
    resting = ["motion", "--alpha=2", "--damping=1/10", "--time=1", "--reference"]
    assert found(capsys, [*resting, "--x0=0 cm", "--v0=0 m/s"]) == found(capsys, [*resting, "--x0=0", "--v0=0"])


def test_axes_and_lists_of_a_sweep_have_units(tmp_path, capsys):
    """The points are those of the plain numbers: what the store holds of them is not computed again."""
    asked = ["sweep", "turning-points", "--alpha=2", "--damping=1/10", "--count=1", "--start=1", "--digits=8"]
    asked += [f"--store={tmp_path}/runs", "--workers=1"]
    plain = found(capsys, [*asked, "--mass=1/5,3/10", "--x0=1/20:1/10:1/20"])
    units = found(capsys, [*asked, "--mass=200 g,300 g", "--x0=5 cm:10 cm:5 cm"])
    (tmp_path / "list.csv").write_text("x0\n5 cm\n1/10\n")
    listed = found(capsys, [*asked, "--mass=200 g", f"--list={tmp_path}/list.csv"])
    assert [(each["computed"], each["reused"]) for each in (plain, units, listed)] == [(4, 0), (0, 4), (0, 2)]


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--mass=1", "--x0=5,6 cm"], "of the numbers in '5,6 cm' some have a unit and others none"),
        (["--x0=5 cm,6 cm"], "'5 cm' has the unit cm, and a law alone has none"),
        (["--mass=1", "--x0=5 kg,6 kg"], "it has the unit kg, and m is meant"),
    ],
)  # fmt: skip
def test_axes_with_a_comma_or_no_place_for_units_are_refused(options, said, capsys):
    law = ["--alpha=2", "--damping=1"] if "--mass=1" in options else ["--alpha=2", "--epsilon=1"]
    assert main(["sweep", "turning-points", *law, "--count=1", *options]) == 2
    assert said in (err := capsys.readouterr().err), err


@pytest.mark.parametrize(("law", "with_units", "plain"), [
    ("--damping 1/10 --mass 2", "20 cm,10 cm", "20,10 --unit cm"),
    ("--damping 1/10 --mass 2", "20 cm,0.1 m", "1/5,1/10"),
    ("--epsilon 1/10 --spring pendulum", "20 deg,40 deg", "20,40 --unit deg"),
    ("--epsilon 1/10 --spring pendulum", "20\u00b0", "20 --unit deg"),
])  # fmt: skip
def test_amplitudes_with_a_unit_are_those_of_that_unit(capsys, law, with_units, plain):
    asked = ["damping", "--alpha=2", *law.split(), "--digits=5", "--amplitudes"]
    assert found(capsys, [*asked, with_units]) == found(capsys, [*asked, *plain.split()])


@pytest.mark.parametrize(("law", "listed", "said"), [
    ("--epsilon 1/10", "20 cm", "a law alone has none"), ("--damping 1/10", "20 cm,10", "some have a unit"),
    ("--damping 1/10", "20 kg", "m is meant"), ("--damping 1/10 --unit cm", "20 cm", "units of its own"),
])  # fmt: skip
def test_amplitudes_whose_unit_has_no_place_are_refused(capsys, law, listed, said):
    assert main(["damping", "--alpha=2", *law.split(), "--amplitudes", listed]) == 2
    assert said in capsys.readouterr().err
