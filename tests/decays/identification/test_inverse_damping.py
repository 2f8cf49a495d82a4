"""From tables to laws: coverage of intervals, grades, near misses, refusals; conversions against their definitions."""

import math

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.inverse_damping import Problem, as_zeta, columns, fitted
from asymptotics.errors import InputError
from asymptotics.present.percent import percent
from asymptotics.shell.main import main

A = np.geomspace(0.05, 1, 12)
LAWS = (("1",), ("2",), ("1", "2"), ("0", "1"), ("0", "2"))


def table(strengths, noise, rng):
    z = sum(b * (0.5 if a == 1 else 2 / (np.pi * A) if a == 0 else 4 * A / (3 * np.pi)) for a, b in strengths.items())
    return z + noise * rng.standard_normal(len(A))


def test_the_columns_are_the_formulas():
    made = columns(Problem("zeta", LAWS), ("0", "1", "2"), A.tolist())
    expected = np.stack([2 / (np.pi * A), np.full(len(A), 0.5), 4 * A / (3 * np.pi)], axis=1)
    assert np.allclose(made, expected, rtol=1e-13)


@pytest.mark.parametrize("truth", [{1: 0.02}, {1: 0.02, 2: 0.05}, {0: 0.002, 2: 0.05}], ids=str)
def test_intervals_cover_and_the_right_law_is_consistent(truth, monkeypatch):
    """120 tables: 95 % intervals cover in 90 to 99 of 100 (three standard errors), the law is consistent as often."""
    rng, problem = np.random.default_rng(20 + len(truth)), Problem("zeta", (tuple(map(str, truth)),))
    known = columns(problem, problem.candidates[0], A.tolist())
    monkeypatch.setattr("asymptotics.decays.identification.inverse_damping.columns", lambda *_: known)
    covered = consistent = 0
    for _ in range(120):
        (found,) = fitted(A.tolist(), table(truth, 3e-4, rng).tolist(), [3e-4] * len(A), problem)
        consistent += found.grade == "consistent"
        covered += sum(s.low <= b <= s.high for s, b in zip(found.strengths, truth.values()))
    assert 0.89 < covered / (120 * len(truth)) < 1
    assert consistent / 120 > 0.89


def covered_share(rows, known, monkeypatch, count=300):
    """Of intervals of tables with as many rows, whose errors are known or not."""
    rng, problem, places = np.random.default_rng(39), Problem("zeta", (("1", "2"),)), A[:: len(A) // rows][:rows]
    columns_there = columns(problem, ("1", "2"), places.tolist())
    monkeypatch.setattr("asymptotics.decays.identification.inverse_damping.columns", lambda *_: columns_there)
    zeta, truth, covered = columns_there @ [0.02, 0.05], (0.02, 0.05), 0
    for _ in range(count):
        seen = zeta + 1e-4 * rng.standard_normal(rows)
        (found,) = fitted(places.tolist(), seen.tolist(), [1e-4] * rows if known else None, problem)
        covered += sum(s.low <= b <= s.high for s, b in zip(found.strengths, truth))
    return covered / (2 * count)


@pytest.mark.parametrize("rows", [4, 6, 12])
@pytest.mark.parametrize("known", [True, False])
def test_few_rows_cover_as_often_as_they_say(rows, known, monkeypatch):
    """Failed before: 81 of 100 where four rows told their own resolution, as though it were known."""
    assert 0.92 < covered_share(rows, known, monkeypatch) < 0.98  # three standard errors of 300 tables
    if not known and rows == 4:  # near miss: the quantile of chi^2
        monkeypatch.undo()
        monkeypatch.setattr("asymptotics.decays.identification.inverse_damping._rise_of_scatter", lambda _: 3.84)
        assert covered_share(rows, known, monkeypatch) < 0.9


def test_a_misfit_widens_the_intervals_of_a_refuted_law_alone():
    rng = np.random.default_rng(5)
    clean = table({1: 0.02}, 0, rng)
    widths = {}
    for off in (1.0, 1.3, 4.0):  # chi^2 per degree of freedom is its square
        noise = rng.standard_normal(len(A))
        noise -= noise.mean()
        seen = clean + 1e-4 * off * noise / np.sqrt(noise @ noise / (len(A) - 1))
        (found,) = fitted(A.tolist(), seen.tolist(), [1e-4] * len(A), Problem("zeta", (("1",),)))
        widths[off] = found.strengths[0].high - found.strengths[0].low
        assert (found.chi_squared == pytest.approx(11 * off**2, rel=1e-6)) and (found.p > 0.05) == (off < 2)
    assert widths[1.3] == pytest.approx(widths[1.0], rel=1e-6) and widths[4.0] == pytest.approx(4 * widths[1.0])


def test_wrong_laws_are_refuted_and_more_terms_are_not_needed():
    zeta = table({1: 0.02, 2: 0.05}, 0, np.random.default_rng(0))
    found = fitted(A.tolist(), zeta.tolist(), [1e-5] * len(A), Problem("zeta", (*LAWS, ("0", "1", "2"))))
    grades = {c.name: c.grade for c in found}
    assert found[0].name == "1+2" and grades["0+1+2"] == "consistent"
    assert [grades[name] for name in ("1", "2", "0+1", "0+2")] == ["refuted"] * 4
    wide = next(c for c in found if c.name == "0+1+2")
    assert wide.unneeded == ("0",) and wide.strengths[0].high < 1e-4


def test_a_law_a_little_off_is_adequate_and_says_by_how_much():
    zeta = table({1: 0.02}, 0, np.random.default_rng(0)) * (1 + 0.03 * np.sin(7 * A))
    (found,) = fitted(A.tolist(), zeta.tolist(), [1e-6] * len(A), Problem("zeta", (("1",),)))
    assert found.grade == "adequate" and 0.01 < found.left < 0.03
    assert found.grade_in_words() == f"adequate to {percent(found.left)} of the loss"


def test_quantities_are_one():
    zeta = table({2: 0.05}, 0, np.random.default_rng(0))
    for quantity, values in (("Q", 1 / (2 * zeta)), ("decrement", 2 * np.pi * zeta)):
        assert np.allclose(as_zeta(quantity, values, values)[0], zeta)


def test_no_strength_is_negative_even_where_it_would_fit_better():
    falling = 0.02 - 0.005 * A
    (found,) = fitted(A.tolist(), falling.tolist(), [1e-4] * len(A), Problem("zeta", (("1", "2"),)))
    assert all(s.estimate >= 0 and s.low >= 0 for s in found.strengths) and found.grade != "consistent"


def test_the_public_table_in_si_and_beside_the_pendulum(tmp_path):
    osc = asy.Oscillator({1: "1/10", 2: "1/5"}, mass="3/2", stiffness=30, spring="pendulum")
    rows = [asy.damping(osc, a, motion=False).rows[0] for a in ("1/10", "1/2", "1", "2")]
    path = tmp_path / "q.csv"
    path.write_text("A,Q,sigma\n" + "".join(f"{float(eval(r.amplitude))},{r.first.Q},0.001\n" for r in rows))  # noqa: S307
    found = asy.damping_law(path, mass="3/2", stiffness=30, spring="pendulum", laws=["1", "1+2"])
    assert found.best.name == "1+2" and found.best.strengths[1].estimate == pytest.approx(0.2, rel=1e-3)
    assert found.verdict.startswith("viscous drag and drag in v^2: consistent; b_1 = 0.1")
    assert found.neglected > 0.1 and "more than the resolution" in str(found)
    straight = asy.damping_law(path, mass="3/2", stiffness=30, laws=["1", "1+2"])
    assert straight.best.grade != "consistent"  # the pendulum is no linear spring


THREE = {"A": [1, 2, 3], "zeta": [1, 2, 3]}
REFUSED = [
    ({"x": [1, 2, 3]}, {}, "no column A"), ({"A": [1, 2, 3]}, {}, "0 of the columns"),
    ({**THREE, "Q": [1, 2, 3]}, {}, "2 of the columns"), ({"A": [1, 2, 3], "zeta": [1, 2]}, {}, "differ in length"),
    ({**THREE, "A": [1, -2, 3]}, {}, "not positive"), ({"A": [1, 2], "zeta": [1, 2]}, {"laws": ["1+2"]}, "too few"),
    (THREE, {"mass": 1}, "stiffness"), (THREE, {"laws": ["1+1"]}, "no candidate"),
    (THREE, {"laws": [-1]}, "no candidate"), ({**THREE, "sigma": [1, 1, 1]}, {"resolution": 1}, "one of the two"),
]  # fmt: skip


@pytest.mark.parametrize(("given", "options", "said"), REFUSED, ids=[r[-1] for r in REFUSED])
def test_what_is_refused_is_named(given, options, said):
    with pytest.raises(asy.InputError, match=said):
        asy.damping_law(given, **options)


def test_the_command_reads_a_table(capsys, tmp_path):
    path = tmp_path / "z.csv"
    path.write_text("A,zeta\n0.1,0.0120\n0.2,0.0141\n0.4,0.0178\n0.8,0.0261\n")
    line = ["damping", "--from", str(path), "--resolution", "0.0002", "--laws", "1", "2", "1+2"]
    assert main([*line, "--csv", str(tmp_path / "laws.csv")]) == 0
    assert capsys.readouterr().out.startswith("viscous drag and drag in v^2: consistent; epsilon_1 = 0.01995")
    head = 'law,grade,alpha,low,strength,high,"code [damping-law --A=0.1,0.2,0.4,0.8 --zeta='
    assert (tmp_path / "laws.csv").read_text().startswith(head)
    assert main([*line, "--alpha", "2"]) == 2 and "--from" in capsys.readouterr().err
    assert main(["damping", "--alpha", "2", "--epsilon", "1", "--laws", "1"]) == 2
    capsys.readouterr()
    assert main(["damping", "--law", "1:1", "--mass", "2", "--amplitudes", "1", "--conversions", "--digits", "5"]) == 0
    assert "AddBLin = 1.0000" in capsys.readouterr().out


def test_the_extinction_curve_is_what_a_half_swing_takes():
    """Weak damping: phi_0 - phi_1 of the motion against a phi_m + b phi_m^2 + c phi_m^3, to first order."""
    weak = {1: "1/5000", 2: "1/3000", 3: "1/2000"}
    osc = asy.Oscillator(weak, mass=2, stiffness=8, x0="1/2")
    named = {c.name: float(c.value) for c in asy.damping(osc, 1, motion=False).conversions()}
    points = [abs(float(p.x)) for p in asy.turning_points(osc, 2, digits=15).points]
    middle = sum(points) / 2
    expected = named["a"] * middle + named["b"] * middle**2 + named["c"] * middle**3
    assert points[0] - points[1] == pytest.approx(expected, rel=1e-6)
    assert named["N20"] * 20**2 == pytest.approx(  # degrees in, degrees out
        math.degrees(sum(named[n] * math.radians(20) ** i for i, n in enumerate("abc", start=1))), rel=1e-10
    )


@pytest.mark.parametrize("alpha", ["1/2", "1", "3/2", "2"])
def test_the_ratio_of_a_power_law_damper_is_that_of_the_design_codes(alpha):
    """zeta = lambda C A^(alpha-1) omega^(alpha-2)/(2 pi m), lambda = 2^(2+alpha) Gamma(1+alpha/2)^2/Gamma(2+alpha)."""
    a = {"1/2": 0.5, "1": 1.0, "3/2": 1.5, "2": 2.0}[alpha]
    C, m, k, place = 0.3, 2.0, 8.0, 0.7
    factor = 2 ** (2 + a) * math.gamma(1 + a / 2) ** 2 / math.gamma(2 + a)
    zeta = factor * C * place ** (a - 1) * math.sqrt(k / m) ** (a - 2) / (2 * math.pi * m)
    osc = asy.Oscillator({alpha: "3/10"}, mass=2, stiffness=8)
    found = asy.damping(osc, "7/10", motion=False)
    assert float(found.rows[0].first.zeta) == pytest.approx(zeta, rel=1e-11)
    assert [c.value for c in found.conversions() if c.name == "C"] == ["0.300000000000"]


def test_conversions_need_units_and_a_linear_spring_for_the_extinction_curve():
    with pytest.raises(asy.InputError, match="no units"):
        asy.damping({1: 1}, 1, motion=False).conversions()
    bent = asy.damping(asy.Oscillator({1: 1}, spring="pendulum"), 1, motion=False).conversions()
    assert {c.name for c in bent} == {"alpha", "AddBLin", "C"}
    for other in (0, 4):  # an exponent that roll coefficients do not know
        mixed = asy.damping(asy.Oscillator({1: 1, other: 1}), 1, motion=False).conversions()
        assert [c.name for c in mixed] == ["AddBLin", "C", "C"]


def test_a_file_that_is_not_there_is_named_before_the_options(capsys, tmp_path):
    # failed before: "--alpha: cannot be combined with --from"
    assert main(["damping", "--from", str(tmp_path / "missing.csv"), "--alpha", "2"]) == 2
    err = capsys.readouterr().err
    assert "cannot read missing.csv" in err
    assert "--alpha" not in err


@pytest.mark.parametrize(
    ("name", "size"), [("A [deg]", 180 / np.pi), ("Amplitude / mm", 1000.0), ("amplitude (rad)", 1.0)]
)
def test_the_amplitudes_of_a_table_are_in_the_unit_of_their_header(name, size):
    A, zeta = np.array([0.1, 0.2, 0.4, 0.8, 1.0]), [0.0120, 0.0141, 0.0178, 0.0261, 0.0300]
    plain = asy.damping_law({"A": A, "zeta": zeta}, resolution="0.0002", laws=["1+2"])
    found = asy.damping_law({name: A * size, "zeta": zeta}, resolution="0.0002", laws=["1+2"])
    assert [s.estimate for s in found.best.strengths] == pytest.approx([s.estimate for s in plain.best.strengths])
    assert ("taken as" in " ".join(found.notes)) == (size != 1.0)


def test_a_unit_that_is_not_known_is_refused():
    with pytest.raises(InputError, match="furlong"):
        asy.damping_law({"A [furlong]": [0.1, 0.2, 0.4], "zeta": [0.01, 0.02, 0.03]}, laws=["1"])
