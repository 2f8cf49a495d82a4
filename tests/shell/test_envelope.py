"""The command envelope: its formulas, where it is slow, its series and its files."""

import csv
import json
import math

import mpmath
import pytest
import sympy

import asymptotics as asy
from asymptotics.ask.questions.envelope import envelope_at
from asymptotics.shell.main import main
from tests.shell.answers import answer, run
from tests.worlds import OSCILLATOR

PAIRS = (
    ("0:1/20", "2:3/10"), ("0:1/10", "sqrt(3):1/10"), ("2:1/5", "3:2"), ("3:1/5", "1:1/10"), ("0:0", "3/2:1/5"),
    ("3/2:1/5", "11/8:1/9"),
)  # fmt: skip


def at(row, x, lead=0.0):
    return lead + sum(float(c["value"]) * x ** int(n) for n, c in row.items())


def test_the_envelope_of_an_order_is_that_of_the_solution_everywhere(capsys, tmp_path):
    line = ["envelope", "--alpha", "2", "--epsilon", "1/10", "--order", "6", "--time", "20", "--digits", "15", "--json"]
    assert main([*line, "--csv", str(tmp_path / "e.csv"), "--points", "4"]) == 0
    found, point = json.loads(capsys.readouterr().out), asy.solution({2: "1/10"}, order=6).at(20, digits=15)
    assert (found["amplitude"], found["phase"]) == (point.amplitude, point.phase)
    assert found["certified"] is False and found["order"] == 6 and "epsilon**4" in found["formula"]
    first = asy.envelope({2: "1/10"}).amplitude(20, digits=15)
    assert abs(float(first) - float(found["amplitude"])) > 1e-6  # no silent first order
    last = (tmp_path / "e.csv").read_text().splitlines()[-1].split(",")
    assert float(last[1]) == pytest.approx(float(point.amplitude), abs=1e-12)
    assert main(["envelope", "--alpha", "2", "--epsilon", "1/10", "--order", "2", "--latex"]) == 0
    assert capsys.readouterr().out.strip().count("\n") == 0
    assert main(["envelope", "--alpha", "2", "--epsilon", "1/10", "--order", "2", "--v0", "1"]) == 2
    assert "--order" in capsys.readouterr().err


def test_the_envelope_of_lancaster_13(capsys):
    """alpha = 3/2: A/A(0) = (1 + kappa tau/2)^-2, in SI and without units."""
    si = answer(capsys, "envelope --alpha 3/2 --mass 3/2 --stiffness 30 --damping 1/10 --x0 1/5 --time 7 --digits 12")
    assert (si["units"], si["amplitude"], si["extinction"], si["certified"]) == ("SI", "0.164991444234", None, True)
    bare = answer(capsys, "envelope --alpha 3/2 --epsilon 1/10 --time 7 --digits 12")
    kappa = float(bare["kappas"][0])
    assert bare["units"] is None
    assert float(bare["amplitude"]) == pytest.approx((1 + kappa * 7 / 2) ** -2, rel=1e-11)
    code, out, _ = run(capsys, "envelope --alpha 3/2 --epsilon 1/10")
    assert (code, out.splitlines()[0]) == (0, "A/A(0) = (kappa_1*tau/2 + 1)**(-2)")


def test_a_law_of_strength_0_is_not_the_one_whose_order_is_asked_for(capsys, tmp_path):
    """A, phi, epsilon and the rows of --csv are those of the law that acts, wherever the other one stands."""
    alone = answer(capsys, "envelope --alpha 2 --epsilon 1/10 --time 10 --order 3")
    rows = []
    for i, law in enumerate(("--law 2:1/10", "--law 0:0 --law 2:1/10", "--law 2:1/10 --law 3:0")):
        found = answer(capsys, f"envelope {law} --time 10 --order 3")
        assert (found["amplitude"], found["phase"]) == (alone["amplitude"], alone["phase"])
        line = f"envelope {law} --time 10 --order 3 --csv {tmp_path}/{i}.csv"
        assert "epsilon    1/10" in run(capsys, line)[1]
        rows.append((tmp_path / f"{i}.csv").read_text().splitlines()[1:99])
    assert rows[0] == rows[1] == rows[2]


def test_the_envelope_of_sums_extinction_and_certified_digits_at_irrational_exponents(capsys):
    dry = answer(capsys, "envelope --law 0:0.01 --law 2:0.3 --time 40 --digits 8")
    assert (dry["family"], dry["extinction"], dry["amplitude"]) == ("tangent", "47.445892", "0.048125088")
    assert answer(capsys, "envelope --law 0:0.01 --law 2:0.3 --time 50")["amplitude"] == "0"
    root = answer(capsys, "envelope --law 1:1/10 --law sqrt(3):1/10 --time 5 --digits 25")
    assert (root["family"], len(root["amplitude"].lstrip("0."))) == ("bernoulli", 25)
    assert answer(capsys, "envelope --law 0:1/10 --law sqrt(3):1/10 --time 5")["formula"] is None
    oscillator = "--alpha 0 --damping 0.14715 --mass 3/2 --stiffness 30 --x0 0.2"
    squaring = answer(capsys, f"envelope {oscillator} --squaring --digits 5")
    assert (squaring["extinction"], squaring["phase"]) == ("12.894", None)


@pytest.mark.parametrize("averaging", ["", "--squaring"])
@pytest.mark.parametrize(("one", "other"), PAIRS)
def test_the_time_formula_is_the_inverse_of_the_certified_amplitude(capsys, one, other, averaging):
    """tau(A(5)) = 5: the kappas of the formula are the printed ones, also where one is 0 or the order is turned."""
    found = answer(capsys, f"envelope --law {one} --law {other} --time 5 --digits 20 {averaging}")
    names = {f"kappa_{i}": sympy.Float(k, 20) for i, k in enumerate(found["kappas"], start=1)}
    formula = sympy.sympify(found["time_formula"])

    def tau(A):
        values = {**names, "A": A}
        return formula.subs({s: values[s.name] for s in formula.free_symbols}).evalf(20)

    A = sympy.Float(found["amplitude"], 20)
    assert abs(tau(A) - 5) < 1e-16
    assert abs(tau(A * (1 + sympy.Float("1e-9", 20))) - 5) > 1e-10


def test_where_one_law_is_slow_in_seconds(capsys):
    """There |dA/dt| = eta omega_0 A: at the time told the certified amplitude has fallen to (eta/kappa) A(0)."""
    oscillator = "--alpha 2 --damping 1/10 --mass 2 --stiffness 8 --x0 3"
    slow = answer(capsys, f"envelope {oscillator} --slow 1/50")["slow"]
    assert (slow["quantity"], slow["end"], slow["arithmetic"]) == ("time", "infinity", "heuristic")
    found = answer(capsys, f"envelope {oscillator} --time {slow['start']}")
    assert float(found["amplitude"]) == pytest.approx(3 * 0.02 / float(found["kappas"][0]), rel=1e-12)
    _, out, _ = run(capsys, f"envelope {oscillator} --slow 1/50")
    assert out.splitlines()[-1].endswith("for t from 17.146018 s to infinity; heuristic, doubles")


def test_where_a_sum_is_slow_in_metres(capsys):
    """At both ends sum kappa_i (A/x0)^(alpha_i-1) is eta; nowhere below its least value 2 sqrt(kappa_0 kappa_2)."""
    oscillator = "--law 0:1/1000 --law 2:1/10 --mass 2 --stiffness 8 --x0 3"
    found = answer(capsys, f"envelope {oscillator} --slow 1/50")
    dry, air = map(float, found["kappas"])
    assert found["slow"]["quantity"] == "amplitude"
    for end in ("start", "end"):
        A = float(found["slow"][end]) / 3
        assert dry / A + air * A == pytest.approx(0.02, rel=1e-9)
    least = 2 * math.sqrt(dry * air)
    assert answer(capsys, f"envelope {oscillator} --slow {least * 0.999}")["slow"]["start"] is None
    assert answer(capsys, f"envelope {oscillator} --slow {least * 1.001}")["slow"]["start"] is not None


@pytest.mark.parametrize("wrong", ["0", "-1", "1e-999", "nan", "1 --spring pendulum"])
def test_a_bound_of_slowness_that_is_none_is_refused(capsys, wrong):
    code, out, err = run(capsys, f"envelope --alpha 2 --epsilon 1/10 --slow {wrong}")
    assert (code, out) == (2, "")
    assert "--slow" in err


@pytest.mark.parametrize(("alpha", "kind"), [("2", "exact"), ("3/2", "certified"), ("1/2", "certified")])
def test_the_series_of_the_envelope_solves_the_equations(capsys, alpha, kind):
    """d tau/d delta = -1/((alpha-1) delta p), d phi/d tau = Omega, and G(delta(sigma)) = 1/sigma, to their order."""
    series = answer(capsys, f"envelope --alpha {alpha} --epsilon 1/10 --order 6")["series"]
    assert (series["order"], series["arithmetic"], series["formal"]) == (6, kind, True)
    expansion = answer(capsys, f"expand --alpha {alpha} --order 6")
    p_1, h = float(series["p_1"]["value"]), 1e-3

    def mismatch(d, missing=False):
        p, Omega = at(expansion["amplitude"], d), at(expansion["frequency"], d)
        G = {} if missing else series["G"]
        dG = (at(G, d + h * d, 1 / (d + h * d)) - at(G, d - h * d, 1 / (d - h * d))) / (2 * h * d)
        dH = (at(series["H"], d + h * d) - at(series["H"], d - h * d)) / (2 * h * d)
        exact = -1 / (d * d) / (1 - h * h)  # the difference quotient of 1/delta
        return abs((dG - exact) - (-p_1 / (d * p) + 1 / (d * d))), abs(dH - Omega * p_1 / (d * p))

    for wide, narrow in zip(mismatch(0.4), mismatch(0.1)):
        assert narrow < 1e-6 and wide < 1e-2
    assert mismatch(0.1, missing=True)[0] > 1e-3
    sigma = 0.1
    delta = at(series["reversal"], sigma)
    assert at(series["G"], delta, 1 / delta) == pytest.approx(1 / sigma, rel=1e-7)
    assert at(series["G"], sigma, 1 / sigma) != pytest.approx(1 / sigma, rel=1e-6)


def test_the_series_has_no_units_and_needs_one_law(capsys):
    si = answer(capsys, "envelope --alpha 2 --damping 1/10 --mass 2 --order 4")["series"]
    assert si == answer(capsys, "envelope --alpha 2 --epsilon 1/10 --order 4")["series"]
    for law in ("--alpha 1 --epsilon 1/10", "--law 1:1/10 --law 2:1/10", "--alpha 2 --epsilon 1/10 --squaring",
                "--alpha 2 --epsilon 1/10 --spring pendulum"):  # fmt: skip
        code, out, err = run(capsys, f"envelope {law} --order 3")
        assert (code, out, err.count("\n")) == (2, "", 1)
    assert "--order" in run(capsys, "envelope --alpha 2 --epsilon 1/10 --order 41")[2]


def test_no_time_formula_beyond_two_laws(capsys):
    assert answer(capsys, "envelope --law 0:1 --law 1:1 --law 3:1")["time_formula"] is None
    assert answer(capsys, "envelope --alpha 2 --epsilon 1/10 --spring pendulum")["time_formula"] is None


def test_the_files_of_the_envelope(capsys, tmp_path, monkeypatch):
    folder = tmp_path / "with a blank and ü"
    folder.mkdir()
    monkeypatch.chdir(folder)
    code, out, err = run(capsys, "envelope --alpha 2 --epsilon 1/5 --time 9 --plot e.svg --csv e.csv --points 30")
    assert code == 0, err
    rows = list(csv.reader((folder / "e.csv").read_text().splitlines()))
    request = "code [envelope --alpha=2 --epsilon=1/5 --time=9 --points=30 --double-error="
    assert rows[0][:3] == ["tau", "amplitude", "phase"] and rows[0][3].startswith(request)
    assert len(rows) == 32
    last = answer(capsys, "envelope --alpha 2 --epsilon 1/5 --time 9 --digits 15")
    assert float(rows[-1][1]) == pytest.approx(float(last["amplitude"]), abs=1e-12)
    assert float(rows[-1][2]) == pytest.approx(float(last["phase"]), abs=1e-9)
    assert (folder / "e.svg").read_text().startswith("<?xml")


def test_the_numbers_of_an_order_in_python_are_those_of_the_solution():
    """Another route: ``solution`` has x of that order; A and phi of both are the same functions."""
    osc = OSCILLATOR
    for order in (1, 3):
        A, phi = asy.envelope(osc).at_order(7, order, digits=12)
        point = asy.solution(osc, order=order).at_time(osc, 7, 12)
        assert (A, phi) == (point.amplitude, point.phase)
        t, many, phases = asy.envelope(osc).columns([7.0], order=order)
        assert many[0] == pytest.approx(float(A), rel=1e-12) and phases[0] == pytest.approx(float(phi), rel=1e-9)
    found = envelope_at(osc, 7, order=3, digits=12)
    assert (found.amplitude, found.phase) == (A, phi) and found.to_dict()["certified"] is False
    assert asy.envelope(osc).at_order(7, 3, digits=12) != asy.envelope(osc).at_order(7, 1, digits=12)


def test_a_start_in_motion_has_no_order_in_python_either():
    """Its columns were those of a start from rest, without a word."""
    moving = asy.envelope(asy.Oscillator({2: "1/10"}, v0=1))
    for ask in (lambda: moving.columns([1.0], order=3), lambda: moving.at_order(1, 3)):
        with pytest.raises(asy.InputError, match="argument order: it starts at rest"):
            ask()
    with pytest.raises(asy.InputError, match="argument time"):
        asy.envelope({"1/2": "1/10"}).at_order(10**6, 2)


def test_the_header_says_what_the_table_depends_on(capsys, tmp_path):
    """Neither --digits nor --slow: the table is doubles."""
    target = tmp_path / "e.csv"
    line = f"envelope --alpha 2 --epsilon 1/10 --time 3 --points 2 --digits 5 --slow 1/50 --csv {target}"
    assert run(capsys, line)[0] == 0
    assert "code [envelope --alpha=2 --epsilon=1/10 --time=3 --points=2 " in target.read_text().splitlines()[0]
    assert run(capsys, f"compare {target}")[0] == 0
    target.write_text(target.read_text().replace("--points=2", "--points=2 --slow=1/50"))
    code, _, err = run(capsys, f"compare {target}")
    assert code == 2 and "'--slow=1/50' of envelope, which is not asked again" in err
    target.write_text(target.read_text().replace("[envelope", "[motion"))
    code, _, err = run(capsys, f"compare {target}")
    assert code == 2 and "names no command that is asked again" in err


def test_the_rates_that_are_printed_are_those_of_the_averaging(capsys):
    """1/(1 + kappa tau) of either averaging is its amplitude; the kappa of the other one is off by a fifth."""
    values = {}
    for averaging in ("", "--squaring"):
        found = answer(capsys, f"envelope --alpha 2 --epsilon 1/10 --time 10 --digits 15 {averaging}")
        values[averaging] = float(found["kappas"][0])
        assert float(found["amplitude"]) == pytest.approx(1 / (1 + 10 * values[averaging]), rel=1e-14)
    assert values["--squaring"] == pytest.approx(0.1 / 8**0.5, rel=1e-14)  # Lelas 2024: <sin^2>^(3/2)
    assert values[""] / values["--squaring"] == pytest.approx(1.2004, abs=1e-4)


def test_ties_of_the_squaring_trick_are_rounded_as_exact_numbers():
    kappas = asy.envelope({3: "1/8", 1: "3"}, averaging="squaring").kappas(digits=2)
    assert kappas == ("0.031", "1.5")  # 1/32 = 0.03125
    assert asy.envelope({1: "0.25"}, averaging="squaring").kappas(digits=2) == ("0.12",)  # 0.125, to even
    assert asy.envelope({2: "sqrt(2)"}, averaging="squaring").kappas(digits=2) == ("0.50",)  # sqrt(2) 2^(-3/2)


def test_the_squaring_trick_has_no_phase_and_no_motion():
    for ask in (lambda e: e.phase(3), lambda e: e.sample([3.0])):
        ask(asy.envelope({2: "1/10"}))
        with pytest.raises(asy.InputError, match="averaging.*squaring gives an amplitude alone"):
            ask(asy.envelope({2: "1/10"}, averaging="squaring"))


SI = "--alpha 2 --damping 1/10 --mass 3/2 --stiffness 30 --x0 1/5"


@pytest.mark.parametrize(("line", "length", "rate"), [("--alpha 2 --epsilon 1/10", 1, 1), (SI, "1/5", "sqrt(20)")])
def test_every_digit_of_an_order_is_that_of_its_formula(capsys, line, length, rate):
    """45 digits, beside mpmath's value of the printed formula and those of the solution; a double ends at the 17th."""
    found = answer(capsys, f"envelope {line} --time 7 --order 3 --digits 45")
    other = answer(capsys, f"solution {line} --time 7 --order 3 --digits 45")
    assert (found["amplitude"], found["phase"]) == (other["amplitude_value"], other["phase_value"])
    with mpmath.workdps(60):
        epsilon, length = (mpmath.mpf(1) / (10 if rate == 1 else 75), mpmath.mpf(sympy.N(length, 60)))
        u = 1 + 4 * epsilon * 7 * mpmath.mpf(sympy.N(rate, 60)) / (3 * mpmath.pi)
        A = length * (1 + epsilon**2 * (1 / u**2 - 1 / u) / 90) / u
        assert abs(mpmath.mpf(found["amplitude"]) - A) < mpmath.mpf(10) ** -45
