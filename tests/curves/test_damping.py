"""The public table of equivalent damping: units, labels, formats, refusals, and the command."""

import csv
import io
import json
from fractions import Fraction

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.errors import InputError
from asymptotics.shell.main import main
from tests.shell.answers import run

OSC = asy.Oscillator({1: "1/10", 2: "1/5"}, mass="3/2", stiffness=30, x0="1/5")


def test_units_come_from_the_oscillator():
    """b = 1/10 viscous: zeta b/(2 sqrt(k m)), Delta E pi b omega A^2, half-life 2 m ln 2/b."""
    osc = asy.Oscillator({1: "1/10"}, mass="3/2", stiffness=30, x0="1/5")
    row = asy.damping(osc, "1/10", digits=10).rows[0].first
    omega = np.sqrt(20)
    assert float(row.zeta) == pytest.approx(0.1 / (2 * np.sqrt(45)))
    assert float(row.energy_loss) == pytest.approx(np.pi * 0.1 * omega * 0.01)
    assert float(row.c_eq) == pytest.approx(0.1) and float(row.half_life) == pytest.approx(3 * np.log(2) / 0.1)


def test_the_first_order_is_the_limit_of_the_motion():
    weak = asy.damping({2: "1/1000000"}, 1, digits=10).rows[0]
    for name in ("zeta", "Q", "decrement", "energy_loss", "c_eq"):
        motion = getattr(weak.motion, "zeta_log" if name == "zeta" else name)
        assert float(getattr(weak.first, name)) == pytest.approx(float(motion), rel=1e-4)


def test_each_damping_ratio_has_a_symbol_of_its_own():
    """Failed before: zeta was Delta E/(4 pi E) in one part of the table, and of the decrement in the other."""
    found = asy.damping(OSC, "1/5", digits=12, order=2)
    (row,), pi = found.rows, np.pi
    assert float(row.first.zeta) == pytest.approx(1 / (2 * float(row.first.Q)), rel=1e-10) and not row.first.zeta_log
    for part in (row.motion, row.expanded):
        d, near = float(part.decrement), 1e-10 if part is row.motion else 1e-2
        assert float(part.zeta_log) == pytest.approx(d / np.sqrt(4 * pi**2 + d**2), rel=near) and part.zeta is None
        assert abs(float(part.zeta_log) * 2 * float(part.Q) - 1) > 0.05  # the other definition is another number
    head, first, motion, _ = csv.reader(io.StringIO(found.to_csv()))
    assert [bool(cell) for cell in first[2:4] + motion[2:4]] == [True, False, False, True], head
    assert found.to_dict()["rows"][0]["motion"]["zeta"] is None
    assert b"the motion, one full swing: zeta log" in found.picture(quantity="zeta")


def test_the_start_is_the_largest_amplitude_where_none_is_given(capsys):
    """Failed before: damping had no --x0."""
    line = "damping --alpha 2 --epsilon 1/10 --x0 3 --digits 6 --json"
    found = json.loads(run(capsys, line)[1])
    assert [row["amplitude"] for row in found["rows"]] == ["3", "3/2", "3/4", "3/8"]
    given = json.loads(run(capsys, line.replace("--x0 3", "--amplitudes 3,3/2,3/4,3/8"))[1])
    assert found["rows"] == given["rows"]
    si = "damping --alpha 2 --damping 1/10 --mass 2 --stiffness 3 --x0 1/5 --digits 6 --json"
    same = asy.damping(asy.Oscillator({2: "1/10"}, mass=2, stiffness=3, x0="1/5"), digits=6).to_dict()["rows"]
    assert json.loads(run(capsys, si)[1])["rows"] == same


def test_the_half_life_beside_the_pendulum_is_that_of_the_envelope():
    law = asy.Oscillator({2: "1/20"}, spring="pendulum", x0=2)
    time = asy.envelope(law).time(1, digits=10)
    assert asy.damping(law, 2, digits=10, motion=False).rows[0].first.half_life == time


def test_the_table_says_what_it_is_in_every_format():
    found = asy.damping(OSC, ["1/5", "1/10"], digits=6, order=2)
    rows = list(csv.reader(io.StringIO(found.to_csv())))
    assert rows[0][1] == "amplitude [m]" and len(rows) == 7 and rows[0][-1] == "code"
    frame = found.to_dataframe()
    for name, place in (("zeta", 2), ("zeta log", 3)):
        column = [float(row[place] or "nan") for row in rows[1:]]
        assert frame[name].tolist() == pytest.approx(column, nan_ok=True) and not np.isnan(column).all()
    data = json.loads(json.dumps(found.to_dict()))
    assert data["rows"][0]["expanded"]["bounds"]["zeta_log"] and data["certified"] is True
    assert (
        data["units"]["energy_loss"] == "J"
        and "\\zeta" in found.latex()
        and "<table>" in found._repr_html_()
        and found._page().title.startswith("Q = ")
    )
    assert found.picture(quantity="zeta")[:5] == b"<?xml" and found.picture("png")[:4] == b"\x89PNG"
    angles = asy.damping(asy.Oscillator({1: 1}, spring="pendulum", x0=1), 1, motion=False)
    assert angles.header()[1] == "amplitude [rad]"


def test_the_curve_is_the_table():
    found = asy.damping(OSC, ["1/5", "1/10"], digits=12, motion=False)
    curve = found.sample([0.2, 0.1, np.nan])
    assert curve["Q"][:2].tolist() == pytest.approx([float(row.first.Q) for row in found.rows])
    assert np.isnan(curve["Q"][2])
    assert found.sample([[0.1]])["c_eq"].shape == (1, 1)


def test_the_result_cannot_be_changed():
    found = asy.damping({2: 1}, 1, motion=False)
    with pytest.raises(AttributeError):
        found.rows = ()


REFUSED = [
    (({2: 0},), {}, "no loss"), (({2: 1}, 0), {}, "not positive"), (({2: 1}, []), {}, "there is none"),
    (({2: 1}, 4), {"spring": "pendulum"}, "outside the well"), (({2: 1}, 1), {"order": 0}, "order"),
    (("symbolic", 1), {}, "cannot be combined with law symbolic"), (({2: 1},), {"spring": {(1, 2): 1}}, "no potential"),
    ((OSC, 1), {"spring": {3: 1}}, "belongs to the oscillator"), (({2: 1}, [1] * 1001), {}, "too many"),
    (({2: 1}, 1), {"motion": 1}, "truth value"),
]  # fmt: skip


@pytest.mark.parametrize(("args", "options", "said"), REFUSED, ids=[r[-1] for r in REFUSED])
def test_what_is_refused_is_named(args, options, said):
    with pytest.raises(asy.InputError, match=said):
        asy.damping(*args, **options)


def test_anti_damping_has_a_first_order_and_no_motion():
    row = asy.damping({1: -1, (1, 2): 1}, ["1/2"]).rows[0]
    assert float(row.first.zeta) < 0 and row.motion.zeta_log is None and "anti-damping" in row.motion.reason
    assert row.first.half_life is None


BAD = {
    "--alpha 2 --damping 1": "--amplitudes",
    "--alpha 2 --epsilon 1 --quantity Q": "--plot",
    "--alpha symbolic --digits 5": "--digits",
    "--alpha 2 --epsilon 1 --gauge x": "gauge",
}


def test_the_command_answers_and_refuses(capsys, tmp_path):
    line = "damping --law 1:0.1 --law 2:0.2 --mass 3/2 --stiffness 30 --amplitudes 0.2,0.1 --digits 6"
    status, out, _ = run(capsys, f"{line} --csv {tmp_path}/d.csv --plot {tmp_path}/d.svg --quantity zeta")
    assert status == 0 and "0.0187712" in out and (tmp_path / "d.svg").exists()
    assert (tmp_path / "d.csv").read_text().startswith("part,amplitude [m],zeta")
    status, out, _ = run(capsys, f"{line} --json")
    assert status == 0 and json.loads(out)["rows"][0]["first"]["zeta"] == "0.0187712"
    assert "gamma" in run(capsys, "damping --alpha symbolic")[1]
    for bad, said in BAD.items():
        try:
            status, _, err = run(capsys, f"damping {bad}")
        except SystemExit as left:
            status, err = left.code, capsys.readouterr().err
        assert status == 2 and said in err


def test_amplitudes_in_degrees_are_those_in_radians():
    law, degree = {1: "1/50", 2: "1/20"}, "0.01745329251994329576923690768488612713"
    deg = asy.damping(law, ["35/2"], spring="pendulum", unit="deg", digits=9, order=2)
    rad = asy.damping(law, [Fraction(degree) * Fraction(35, 2)], spring="pendulum", digits=9, order=2)
    assert [row.amplitude for row in deg.rows] == ["35/2"] and deg.header()[1] == "amplitude [deg]"
    for one, other in zip(deg.rows, rad.rows, strict=True):
        assert (one.first, one.motion, one.expanded) == (other.first, other.motion, other.expanded)
    assert deg.sample([17.5])["zeta"][0] == pytest.approx(float(deg.rows[0].first.zeta), rel=1e-8)
    assert deg.to_dict()["units"]["amplitude"] == "deg" and deg.picture("svg")


def test_amplitudes_in_millimetres_are_those_in_metres():
    assert asy.damping(OSC, [200], unit="mm").rows[0].motion == asy.damping(OSC, "1/5").rows[0].motion


@pytest.mark.parametrize(
    ("unit", "law", "more"),
    [("deg", OSC, {}), ("mm", {1: 1}, {}), ("mm", {1: 1}, {"spring": "pendulum"}), ("parsec", OSC, {}), (3, OSC, {})],
)
def test_a_unit_that_amplitudes_do_not_have_is_refused(unit, law, more):
    with pytest.raises(InputError, match="argument unit: .* is no unit of these amplitudes"):
        asy.damping(law, [1], unit=unit, **more)
    with pytest.raises(InputError, match="argument amplitudes: there is none in this unit"):
        asy.damping(OSC, unit="mm")


def test_a_table_in_degrees_is_read_back_as_the_law(tmp_path, capsys):
    path = tmp_path / "damping.csv"
    line = "damping --law 1:1/50 --law 2:1/20 --spring pendulum --amplitudes 10,20,30,40,50 --unit deg --csv"
    assert main([*line.split(), str(path)]) == 0
    capsys.readouterr()
    head, *rows = list(csv.reader(path.read_text().splitlines()))
    first = [row for row in rows if row[0] == "first order"]
    table = {head[1]: [float(row[1]) for row in first], "zeta": [float(row[2]) for row in first]}
    found = asy.damping_law(table, laws=["1", "2", "1+2"], spring="pendulum")
    assert found.laws[0].name == "1+2"
    assert [s.estimate for s in found.laws[0].strengths] == pytest.approx([0.02, 0.05], rel=1e-6)


def test_what_is_not_asked_for_is_twelve_digits_and_the_motion_and_no_series():
    """Of a spring that is linear, and numbers without a unit."""
    plain = asy.damping({1: "1/10"}, "1")
    assert plain.digits == 12 and plain.order is None and plain.to_dict()["digits"] == 12
    (row,) = plain.rows
    assert row.motion is not None and row.expanded is None
    assert float(row.motion.period) == pytest.approx(2 * np.pi / np.sqrt(1 - 0.0025), rel=1e-11)


def test_conversions_of_a_pendulum_are_torques_and_the_title_has_the_unit_of_its_amplitudes():
    pendulum = asy.Oscillator({2: "1/10", 1: "1/5"}, mass=2, stiffness=3, spring="pendulum")
    units = {c.definition: c.unit for c in asy.damping(pendulum, digits=6).conversions() if c.name == "C"}
    assert list(units.values()) == ["N m (s/rad)^2", "N m s"] and all("torque" in told for told in units)
    mass = asy.Oscillator({2: "1/10", 1: "1/5"}, mass=2, stiffness=3)
    assert [c.unit for c in asy.damping(mass).conversions() if c.name == "C"] == ["N (s/m)^2", "N s/m"]
    assert asy.damping(mass, amplitudes=[1])._page().title.endswith("at 1 m")
    assert asy.damping({2: "1/10"}, amplitudes=[1])._page().title.endswith("at 1")


def test_the_title_of_a_picture_is_of_what_is_drawn():
    """A picture of the period had Q in its title."""
    found = asy.damping({1: "1/50"}, spring="pendulum", amplitudes=["1/10", 1], digits=4)
    drawn = ("period", "Q", "energy_loss")
    titles = {n: found._headed({"quantity": n}) for n in drawn}
    assert f"<title>{titles['period']}</title>" in found.picture(quantity="period").decode()
    assert titles["period"] == "period = 6.287 at 1/10, 6.671 at 1" and titles["Q"] == found._page().title
    assert all(title.startswith(name.replace("_", " ")) for name, title in titles.items())
    law = asy.Oscillator({1: "1/50"}, mass=1, stiffness=4)
    assert "<title>period = 3.142 s at 1 m" in asy.damping(law, [1], digits=4).picture(quantity="period").decode()
