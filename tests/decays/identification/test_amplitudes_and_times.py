"""``damping --from`` of amplitudes at times or counts, of per cent and degrees; candidates that a table cannot hold."""

import json

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import asymptotics as asy
from asymptotics.decays.identification.between_amplitudes import means, pairs
from asymptotics.errors import InputError
from asymptotics.shell.main import main


def strength(found, law):
    return [s.estimate for s in found.law(law).strengths]


@pytest.mark.parametrize(
    ("clock", "values", "cycles"), [("cycles", [0, 10], 10), ("n", [0, 20], 10), ("t", [3, 3 + 20 * np.pi], 10)]
)
def test_two_amplitudes_and_a_time_give_b(clock, values, cycles):
    found = asy.damping_law({"A": [0.12, 0.06], clock: values})
    tau = 2 * np.pi * cycles
    # The slow flow in closed form: dA/dtau = -M eps A^alpha, M = 2/pi, 1/2, 4/(3 pi), 3/8.
    right = {"0": 0.06 / tau * np.pi / 2, "1": 2 * np.log(2) / tau, "2": (1 / 0.06 - 1 / 0.12) / tau * 3 * np.pi / 4,
             "3": (1 / 0.06**2 - 1 / 0.12**2) / 2 / tau * 8 / 3}  # fmt: skip
    for law, value in right.items():
        assert strength(found, law) == pytest.approx([value], rel=1e-9)
    assert "none is tested" in " ".join(found.notes) and "skipped: 0+1 (2 strengths)" in found.notes[-1]
    assert found.to_dict()["laws"][0]["strengths"][0]["low"] is None and "[" not in found.verdict.text
    # It said "dry friction: consistent", of four laws that all meet one number.
    assert (
        found.verdict.text.startswith("one loss tests no law: epsilon_0 = ") and found.verdict.text.count(" or ") == 3
    )
    assert {c.grade for c in found.laws} == {"not tested"}
    # With m and k it is b, in SI, and the time is in s.
    si = asy.damping_law({"A": [0.12, 0.06], clock: values}, mass="1/5", stiffness=20)
    assert strength(si, "1") == pytest.approx([right["1"] * (1 if clock == "t" else 10) * 0.2], rel=1e-9)


def test_the_motion_itself_loses_so_much():
    # 1/100 x'|x'| from 1: amplitudes at n = 0 and 30 by DOP853.
    turned = solve_ivp(
        lambda _, y: [y[1], -y[0] - 0.01 * y[1] * abs(y[1])], (0, 100), [1.0, 0.0], events=lambda _, y: y[1],
        method="DOP853", rtol=1e-11, atol=1e-13,
    )  # fmt: skip
    turns = [1.0, *(abs(y[0]) for y in turned.y_events[0] if abs(y[0]) < 0.999999)]
    found = asy.damping_law({"A": [turns[0], turns[30]], "n": [0, 30]}, resolution="1/10000")
    (s,) = found.law("2").strengths
    assert s.estimate == pytest.approx(0.01, rel=2e-3) and s.low < 0.01 < s.high
    # Near miss: the loss at the mean of both amplitudes.
    assert not s.low < np.log(turns[0] / turns[30]) / 15 / np.mean([turns[0], turns[30]]) * 3 / 8 < s.high


def test_sums_are_weighed_along_the_decay():
    b1, b2 = 0.02, 0.05
    c1, c2 = b1 / 2, 4 / 3 / np.pi * b2
    tau = np.array([0.0, 40, 80, 160, 320])
    # dA/dtau = -c1 A - c2 A^2 in closed form.
    a = 1 / ((1 + c2 / c1) * np.exp(c1 * tau) - c2 / c1)
    found = asy.damping_law({"A": a, "t": tau}, laws=["1+2", "1", "2", "0+1+2+3"])
    assert strength(found, "1+2") == pytest.approx([b1, b2], rel=1e-6) and found.best.name == "1+2"
    assert "0+1+2+3 (4 strengths)" in found.notes[-1] and found.law("1").grade == "refuted"


def test_the_mean_of_one_term_knows_no_strength():
    both, zeta = pairs(np.array([3.0, 1.0]), np.array([0.0, 2.0]))
    square = means([lambda a: a**2], both, zeta)
    # int A^2 dA/A^3 / int dA/A^3 = ln 3 / (1/2 - 1/18).
    assert square[0, 0] == pytest.approx(np.log(3) / (1 / 2 - 1 / 18), rel=1e-6)


@pytest.mark.parametrize(
    ("table", "word"),
    [
        ({"A": [1, 2], "n": [0, 1]}, "nothing is lost"),
        ({"A": [2, 1], "n": [1, 0]}, "do not increase"),
        ({"A": [2], "n": [1]}, "two at least"),
        ({"A": [2, 1], "zeta": [2, 3]}, "from 1 on nothing swings"),
        ({"A": [2, 1]}, "n, cycles, t"),
    ],
)
def test_what_tells_no_loss_is_refused(table, word):
    with pytest.raises(InputError, match=word):
        asy.damping_law(table)


def test_a_spring_beside_times_is_refused():
    with pytest.raises(InputError, match="argument spring"):
        asy.damping_law({"A": [2, 1], "n": [0, 9]}, spring={3: "1/10"})


def test_per_cent_and_degrees():
    degrees, zeta = np.array([5.0, 10, 20, 40]), np.array([0.012, 0.0141, 0.0178, 0.0261])
    plain = asy.damping_law({"A": np.radians(degrees), "zeta": zeta, "resolution": [2e-4] * 4})
    for names in (("A [deg]", "zeta [%]", "resolution [%]"), ("A_deg", "zeta_percent", "resolution (%)")):
        found = asy.damping_law(dict(zip(names, (degrees, 100 * zeta, [0.02] * 4))))
        assert strength(found, "1+2") == pytest.approx(strength(plain, "1+2")) and found.best.name == plain.best.name
        assert "amplitudes in deg taken as rad" in found.notes


def test_candidates_that_cannot_be_fitted_are_skipped_and_told():
    table = {"A": [0.1, 0.2, 0.4], "zeta": [0.0120, 0.0141, 0.0178]}
    found = asy.damping_law(table, laws=["free", "1", "1+2", "0+1+2"])
    assert [c.name for c in found.laws] == ["1+2", "1"]
    assert found.notes[-1].startswith("skipped: free (") and "0+1+2 (3 strengths)" in found.notes[-1]
    with pytest.raises(InputError, match="too few rows: skipped: free"):
        asy.damping_law(table, laws=["free"])


def test_a_file_of_two_rows_is_asked_again_by_its_own_header(tmp_path, capsys):
    path, csv = tmp_path / "two.csv", tmp_path / "law.csv"
    path.write_text("A [cm],cycles\n12,0\n6,10\n")
    assert main(["damping", "--from", str(path), "--mass", "1/5", "--stiffness", "20", "--csv", str(csv)]) == 0
    assert main(["compare", str(csv), "--json"]) == 0
    assert json.loads(capsys.readouterr().out.partition("\n{")[2].join(["{", ""]))["rows"][1]["digits"] == "17.00"


def test_two_rows_are_no_record_and_say_what_they_may_be(tmp_path):
    path = tmp_path / "two.csv"
    path.write_text("t (s),A (cm)\n0,4\n10,2\n")  # failed before: A was an acceleration in cm
    assert asy.identify(path) == asy.damping_law(path)  # then: 14 samples, or two amplitudes and a time by kind damping
    with pytest.raises(
        InputError, match="14 samples; peaks: a column 'amplitude'; two amplitudes and a time: kind damping"
    ):
        asy.identify({"t": [0, 10], "x": [4, 2]})
    found = asy.identify(path, kind="damping", mass=2, stiffness=8)
    assert strength(found, "1") == pytest.approx([2 * 2 * np.log(2) / 10])


def test_a_mapping_and_a_file_are_read_alike(tmp_path):
    columns = {"A (cm)": ["0.1", "0.2", "0.4"], "zeta (%)": [1.0, 1.5, 2.5], "who": ["a", "b", "c"]}
    path = tmp_path / "table.csv"
    path.write_text("\n".join(",".join(map(str, row)) for row in [columns, *zip(*columns.values())]))
    for resolution in (None, "0.001"):
        both = [asy.damping_law(table, resolution=resolution) for table in (columns, path)]
        assert both[0].to_dict() == both[1].to_dict() and "not used: who" in both[0].notes
    for wrong in (
        {"A": [1, 2, 3], "zeta": [0.1, 0.2]},
        {"A": 1.0, "zeta": [0.1, 0.2]},
        {"A": ["x", 1], "zeta": [1, 2]},
    ):
        with pytest.raises(InputError):
            asy.damping_law(wrong)
