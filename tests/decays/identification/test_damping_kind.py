"""``identify`` of a table of damping: recognised by its columns, the answer of ``damping --from``, refused by name."""

import io
import json
import math

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.ask.questions._damping_law import damping_law
from asymptotics.errors import InputError
from asymptotics.shell.main import main

A, ZETA = ["0.1", "0.2", "0.4", "0.8"], [0.0120, 0.0141, 0.0178, 0.0261]
FORCED = {"A": [0.5, 1.0, 1.5, 2.0], "force": [0.05, 0.1, 0.15, 0.2], "omega": [1, 1, 1, 1]}
TEXT = "A,zeta\n" + "".join(f"{a},{z}\n" for a, z in zip(A, ZETA))


@pytest.fixture
def path(tmp_path):
    made = tmp_path / "table.csv"
    made.write_text(TEXT)
    return made


def test_the_columns_say_what_it_is_and_the_judge_is_that_of_the_other_command(path):
    right = damping_law({"A": A, "zeta": ZETA}, resolution="0.0002")
    frame = pytest.importorskip("pandas").DataFrame({"A": A, "zeta": ZETA})
    for data in (path, str(path), io.StringIO(TEXT), {"A": A, "zeta": ZETA}, frame):
        assert asy.identify(data, noise=0.0002) == right
    assert asy.identify(path) != right  # near miss: no resolutions
    assert asy.identify(FORCED, laws=["1", "2"]).best.name == "1"


def test_shell_and_files(path, tmp_path, capsys):
    line = [str(path), "--laws", "1", "1+2", "--json"]
    assert main(["identify", *line, "--csv", str(tmp_path / "a.csv"), "--html", str(tmp_path / "a.html")]) == 0
    found = json.loads(capsys.readouterr().out)
    assert main(["damping", "--from", *line]) == 0
    other = json.loads(capsys.readouterr().out)
    assert found["kind"] == "damping" and found["laws"] == other["laws"] and found["verdict"] == other["verdict"]
    assert (tmp_path / "a.csv").read_text().startswith("law,grade,alpha,low,strength,high")
    assert "consistent" in (tmp_path / "a.html").read_text()


def test_differences_of_amplitudes_stay_what_they_were_and_say_so():
    """Logarithmic decrements were taken for differences, in silence, by the name "log decrement" too."""
    table = {"amplitude": [1.0, 0.9, 0.81, 0.729], "decrement": [0.1, 0.09, 0.081, 0.0729]}
    found = asy.identify(table, laws=["1"])
    assert isinstance(found, asy.Identification) and any("A_n - A_(n+1)" in note for note in found.notes)
    for name in ("log decrement", "log_decrement", "lambda", "logarithmic decrement"):
        law = asy.identify({"A": [1, 2, 3, 4], name: [0.1, 0.13, 0.18, 0.23]})
        assert isinstance(law, asy.DampingLaw) and law.problem.quantity == "decrement"
    assert isinstance(asy.identify({"A": [1, 2, 3], "decrement": [0.1, 0.2, 0.3]}, kind="damping"), asy.DampingLaw)
    turning = {"n": range(8), "x": [(-0.9) ** n for n in range(8)]}
    assert isinstance(asy.identify(turning, laws=["1"], bootstrap=False), asy.Identification)


@pytest.mark.parametrize(
    ("option", "named"),
    [
        ("--springs 3", "--springs"), ("--amplitudes 0.1:0.5", "--amplitudes"), ("--amplitudes-only", "--amplitudes"),
        ("--omega0 2 --mass 1 --stiffness 4", "--omega0"), ("--modes 2", "--modes"), ("--rate 5", "--rate"),
        ("--kind damping --columns x=1", "--columns"), ("--mass 2", "--stiffness"), ("--plot a.svg", "--plot"),
        ("--laws free", "FILE"), ("--kind record", "FILE"),
    ],
)  # fmt: skip
def test_what_only_a_decay_has_is_refused_by_name(path, option, named, capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    assert main(["identify", str(path), *option.split()]) == 2
    out, err = capsys.readouterr()
    assert out == "" and err.count("\n") == 1 and f"argument {named}" in err
    assert [p.name for p in tmp_path.iterdir()] == ["table.csv"]


def test_several_runs_are_no_table(path):
    with pytest.raises(asy.InputError, match="several runs"):
        asy.identify([path, path], kind="damping")


def test_a_law_is_not_identified_while_too_few_data_tell_nothing_of_a_term_more(tmp_path):
    """Failed before: four decrements that double were "identified: 1", for 1+2 had no fit."""
    table = {"amplitude": [1, 2, 3, 4], "decrement": [0.1, 0.13, 0.18, 0.23]}
    found = asy.identify(table, laws=["1", "1+2"]).verdict
    assert found.kind == "too short or too noisy" and "too few data for a term more" in found.text
    assert asy.identify(table, laws=["1"]).verdict.kind == "identified"  # among the laws tried


def test_a_record_beside_a_force_sensor_stays_a_record(tmp_path):
    """Failed before: t, a, force (an acceleration and a sensor) was taken for a resonance, A under a force."""
    t = [0.04 * i for i in range(200)]
    motion = [math.exp(-0.05 * s) * math.cos(5 * s) for s in t]
    sensor = [0.3 + 0.01 * math.sin(i) for i in range(200)]
    for named in ({"t": t, "a": motion, "force": sensor}, {"time [s]": t, "a": motion, "Q": sensor}):
        assert isinstance(asy.identify(named, laws=["1"], bootstrap=False), asy.Identification)
    table = {"A": sensor, "zeta": sensor, "t": t, "x": motion}
    found = asy.identify(table, laws=["1"], columns="t=t,x=x", bootstrap=False)
    assert isinstance(found, asy.Identification)


def test_an_error_of_a_phase_that_is_not_used_is_told():
    table = {**FORCED, "phase_resolution": [0.01] * 4}
    assert any("not used: phase_resolution" in note for note in asy.identify(table, laws=["1"]).notes)


@pytest.mark.parametrize(
    "header",
    [
        "theta (deg);zeta",
        "roll angle (deg);zeta (-);sd zeta",
        "A (deg);zeta (%);u(zeta) (%)",
        "Amplitude [deg];D\xe4mpfungsgrad [%];Fehler D\xe4mpfungsgrad",
        "phi [deg];damping ratio (%);+/-",
        "phi [deg];u(phi);zeta",
    ],
)
def test_a_table_of_damping_with_the_names_that_people_give(tmp_path, header):
    """A column of places beside a ratio is its amplitude; its errors are the resolution, in its unit."""
    names = header.split(";")
    percent = 100 if "%" in names[1] else 1
    rows = []
    for i, angle in enumerate((40, 30, 20, 15, 10, 5)):
        zeta = 0.005 + 4 / (3 * np.pi) * 0.05 * np.radians(angle)
        of_angle = names[1] == "u(phi)"
        cells = [angle, 0.5, zeta] if of_angle else [angle, percent * (zeta + 2e-5 * (-1) ** i), percent * 2e-5]
        rows.append(";".join(f"{cell:.6g}" for cell in cells[: len(names)]))
    path = tmp_path / "table.csv"
    path.write_text("\n".join([header, *rows]), encoding="utf-8")
    found = asy.identify(path, laws=["1", "1+2"])
    (e1, e2) = found.law("1+2").strengths
    assert e1.low < 0.01 < e1.high and e2.low < 0.05 < e2.high
    assert found.law("1+2").grade == "consistent" and found.law("1").grade != "consistent"
    told = any("no resolutions" in note for note in found.notes)
    assert told == (len(names) == 2 or names[1] == "u(phi)")


def test_two_places_beside_a_ratio_are_asked_for(tmp_path):
    path = tmp_path / "two.csv"
    path.write_text("x (cm);y (cm);zeta\n1;2;0.01\n2;3;0.02\n3;4;0.03\n")
    with pytest.raises(InputError):
        asy.identify(path)


def test_the_frequency_alone_tells_b_over_m_in_the_unit_that_is_said():
    # failed before: "argument omega_0: means nothing for a table of damping", and the same of the unit
    table = {"t": [0, 10], "A": [5, 3]}
    found = asy.identify(table, kind="damping", omega_0=6, unit="cm")
    assert found == asy.identify({"t": [0, 10], "A (cm)": [5, 3]}, omega_0=6)  # the kind is seen, too
    assert "b/m_1 = 0.1022 1/s" in found.verdict.text and "b/m_2 = 0.5236 1/m" in found.verdict.text
    si = damping_law({"t": [0, 10], "A [cm]": [5, 3]}, mass=1, stiffness=36)
    assert [law.strengths for law in found.laws] == [law.strengths for law in si.laws]
    assert any("Q 58.73" in note for note in found.notes)
    assert "b/m_2 = 0.005236 1/(unit of x)" in asy.identify(table, omega_0=6).verdict.text
    # Failed before: "si" was true of strengths in a unit that nobody says.
    told, si = asy.identify(table, omega_0=6).to_dict(), asy.identify(table, mass=1, stiffness=36).to_dict()
    assert (told["si"], told["per_mass"], si["si"], si["per_mass"]) == (False, True, True, False)
    assert found.to_dict()["si"] is True  # b/m in 1/m
    with pytest.raises(InputError, match="unit: mm contradicts the column"):
        asy.identify({"t": [0, 10], "A (cm)": [5, 3]}, unit="mm")


def test_two_amplitudes_under_a_letter_are_no_neighbouring_peaks(tmp_path):
    # failed before: "2 rows with numbers that change (accepted: 14 samples ...)"
    path = tmp_path / "two.txt"
    path.write_text("t A\n0 5\n10 3\n")
    assert asy.identify(path) == damping_law(path)
    # amplitudes further apart than the period that is said were refused
    assert isinstance(asy.identify({"t": [0, 10, 20], "amplitude": [5, 3, 2]}, omega_0=6), asy.DampingLaw)
    near = asy.identify({"t": [0, 1.1], "amplitude": [5, 3]})
    assert isinstance(near, asy.Identification)
    assert len(near.to_dict()["envelope"]["quality"]) == 1  # three amplitudes before, with one and the same Q


def test_the_verdict_is_of_one_type_and_json_has_what_every_identification_has():
    for resolution, kind in ((0.0002, "identified"), (0.002, "several laws are consistent")):
        found = asy.identify({"A": A, "zeta": ZETA}, noise=resolution)
        assert type(found.verdict).__name__ == "Verdict" and found.verdict.kind == kind
        told = found.to_dict()
        assert told["verdict"] == found.verdict.text and told["untried"] == []
        assert {law["pendulum"] for law in told["laws"]} == {False}
    pendulum = damping_law({"A": A, "zeta": ZETA}, spring="pendulum").to_dict()
    assert {law["pendulum"] for law in pendulum["laws"]} == {True}


@pytest.mark.parametrize("name", ["peak number", "Peak #", "Schwingung Nr.", "number of oscillations"])
def test_a_number_of_the_peak_counts_periods(tmp_path, name):
    # failed before: "what is measured is not clear"
    path = tmp_path / "peaks.csv"
    path.write_text(f"{name},amplitude\n" + "".join(f"{i},{5 * 0.9**i:.4f}\n" for i in range(7)))
    found = asy.identify(path, laws=["1", "2"], bootstrap=False)
    middle = found.to_dict()["envelope"]["quality"][1]
    assert abs(float(middle["estimate"]) / (np.pi / np.log(1 / 0.9)) - 1) < 0.001
    assert damping_law(path, laws="1").laws[0].strengths[0].estimate == pytest.approx(np.log(1 / 0.9) / np.pi, rel=1e-3)
