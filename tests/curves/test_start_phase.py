"""One meaning of phi wherever it is told: x = A cos(omega_0 t + phi) with A >= 0, from whatever start."""

import csv
import io
import json
from fractions import Fraction

import numpy as np
import pytest
from matplotlib.figure import Figure

import asymptotics as asy
from asymptotics.ask.questions.solution import solution_at
from asymptotics.curves.envelope_order import end_of_series
from asymptotics.numbers.exact import ExactReal
from asymptotics.shell.main import main
from tests.shell.answers import answer

STARTS = [("1", "0"), ("-2", "0"), ("3/5", "4/5"), ("-3/5", "4/5"), ("-1", "-1"), ("0", "1"), ("0", "-1")]
LAWS = [{"3/2": "1/50"}, {1: "1/40", 2: "1/80"}, {0: "1/30"}]
EACH = [  # every start with one law in `make test`
    pytest.param(law, start, marks=() if n % 3 == k else pytest.mark.slow)
    for k, law in enumerate(LAWS)
    for n, start in enumerate(STARTS)
]


def started(law, x0, v0, **rest):
    return asy.Oscillator(law, mass="3/2", stiffness="6", x0=x0, v0=v0, **rest)


def rows_of(line, tmp_path, capsys):
    file = tmp_path / "table.csv"
    assert main([*line.split(), "--csv", str(file), "--json"]) == 0
    return json.loads(capsys.readouterr().out), list(csv.DictReader(io.StringIO(file.read_text())))


@pytest.mark.parametrize(("law", "start"), EACH)
def test_the_phase_of_an_envelope_is_that_of_the_motion(law, start):
    """One formula with the motion of order 2, which the same start gives its own A(0) and phi(0): O(epsilon) apart."""
    oscillator = started(law, *start)
    found, moving = asy.envelope(oscillator), asy.motion(oscillator, order=2)
    for t, time in ((0, 0.0), ("5/2", 2.5)):
        phi = float(found.phase(t, digits=12))
        assert phi == pytest.approx(float(moving.at(t, digits=12).phase), abs=0.15)
        assert found.phases([time])[0] == pytest.approx(phi, abs=1e-9)
    begin = found.sample([0.0])
    assert begin.x[0] == pytest.approx(float(oscillator.x0.ball().mid()), abs=1e-12)
    assert begin.v[0] == pytest.approx(float(oscillator.v0.ball().mid()), abs=1e-12)


@pytest.mark.parametrize("start", STARTS)
@pytest.mark.parametrize("law", LAWS)
def test_the_samples_of_an_envelope_are_its_own_amplitudes_and_phases(law, start):
    found, t = asy.envelope(started(law, *start)), np.array([[0.0, 7.0], [np.nan, 1e4]])
    seen, A, phi = found.sample(t), found.amplitudes(t), found.phases(t)
    assert np.array_equal(seen.amplitude, A, equal_nan=True) and np.array_equal(seen.phase, phi, equal_nan=True)
    there = A > 0
    assert np.allclose(seen.x[there], (A * np.cos(2 * t + phi))[there], atol=1e-13)
    assert np.allclose(seen.v[there], (-2 * A * np.sin(2 * t + phi))[there], atol=1e-13)
    assert (seen.missing, seen.extinct) == (1, int((A == 0).sum()))
    assert not np.any(seen.x[A == 0]) and not np.any(seen.v[A == 0])


def test_samples_after_the_extinction_are_zero_and_tell_when_it_was():
    found = asy.envelope({0: "1/7", 1: "1/5"})
    seen = found.sample([9.0])
    assert (seen.amplitude[0], seen.x[0], seen.v[0], np.isnan(seen.phase[0])) == (0.0, 0.0, 0.0, True)
    assert seen.extinction == pytest.approx(float(found.extinction_time(digits=15)), rel=1e-12)
    assert asy.envelope({"3/2": "1/10"}).sample([7]).phase[0] == pytest.approx(-0.00921858360000, abs=1e-12)


@pytest.mark.parametrize("spring", ["pendulum", {3: "1/10"}])
def test_beside_a_spring_a_start_on_the_other_side_is_half_a_turn_later(spring):
    right, left = (asy.envelope(asy.Oscillator({2: "1/20"}, spring=spring, x0=x0)) for x0 in (1, -1))
    t = np.array([0.0, 3.0, 40.0])
    assert np.allclose(left.phases(t) - right.phases(t), np.pi, atol=1e-13)
    assert float(left.phase(3, digits=15)) - float(right.phase(3, digits=15)) == pytest.approx(np.pi, abs=1e-13)
    assert np.array_equal(left.sample(t).x, -right.sample(t).x) and left.phase(0, digits=6) == "3.14159"


def test_the_formula_of_the_phase_has_the_phase_of_the_start():
    for x0, v0 in STARTS:
        found = asy.envelope(asy.Oscillator({3: "1/10"}, x0=x0, v0=v0))
        strength = float(found.oscillator.epsilons()[0].mid())
        values = {s: {"tau": 7, "epsilon": strength}[s.name] for s in found.phase_formula.free_symbols}
        assert float(found.phase_formula.subs(values)) == pytest.approx(float(found.phase(7, digits=15)), abs=1e-12)


@pytest.mark.parametrize("law", ["--law 1:1/10 --law 2:1/20", "--alpha 2 --epsilon 1/10", "--alpha 3/2 --epsilon 1/10"])
@pytest.mark.parametrize("x0", ["-2", "2"])
def test_text_table_and_motion_have_one_phase_of_a_solution(law, x0, tmp_path, capsys):
    request = f"{law} --x0 {x0} --order 2 --time 5 --digits 12"
    found, rows = rows_of(f"solution {request} --points 2", tmp_path, capsys)
    A, phi, x = (float(found[f"{name}_value"]) for name in ("amplitude", "phase", "x"))
    moved = answer(capsys, f"motion {request}")
    assert phi == pytest.approx(float(moved["phase"]), abs=2e-3) and x == pytest.approx(float(moved["x"]), rel=0.05)
    last = rows[-1]
    assert [float(last[n]) for n in ("amplitude", "phase", "x")] == pytest.approx([A, phi, x], abs=1e-11)
    assert x == pytest.approx(A * np.cos(5 + phi), abs=0.1 * A) and A > 0
    envelope, drawn = rows_of(f"envelope {request} --points 2".replace("--order 2 ", ""), tmp_path, capsys)
    assert float(envelope["phase"]) == pytest.approx(phi, abs=2e-3)
    assert float(drawn[-1]["phase"]) == pytest.approx(float(envelope["phase"]), abs=1e-11)
    assert main(["compare", str(tmp_path / "table.csv"), "--json"]) == 0
    capsys.readouterr()


@pytest.mark.parametrize("law", [{2: "1/10"}, {"3/2": "1/10"}, {1: "1/10", 2: "1/20"}])
def test_a_solution_from_the_other_side_is_the_mirror_image_in_every_answer(law):
    right, left = (asy.solution(asy.Oscillator(law, x0=x0), order=2) for x0 in (1, -1))
    t = np.array([0.0, 5.0])
    seen = [(s.sample(t), s.columns(t)[1:], [(p.amplitude, p.phase, p.x) for p in [s.at(5)]][0]) for s in (right, left)]
    for one, other in zip(*seen):
        (A, phi, x), (A_2, phi_2, x_2) = (np.array(values, float) for values in (one, other))
        assert np.allclose(A_2, A, atol=1e-12) and np.allclose(x_2, -x, atol=1e-12)
        assert np.allclose(phi_2 - phi, np.pi, atol=1e-12)
    assert left.columns([0.0])[3][0] == pytest.approx(-1, abs=1e-12)


def test_the_printed_formula_of_x_holds_with_the_start_put_in():
    found = asy.solution(asy.Oscillator({2: "1/10"}, x0=-1), order=2)
    (tau,) = found.x.free_symbols
    assert float(found.x.subs(tau, 5)) == pytest.approx(float(found.at(5).x), abs=1e-13)
    assert "x(0) = -1" in str(found) and float(found.bound(5)) < 0.01


@pytest.mark.parametrize("alpha", ["2", "1/2", "3/2"])
def test_formulas_in_SI_hold_for_a_start_on_the_other_side(alpha):
    """Put in: m, k, b, t and x_0 = |x(0)|, as the text says."""
    oscillator = asy.Oscillator({alpha: "1/10"}, mass="3/2", stiffness=30, x0="-1/5")
    found = asy.solution(oscillator, order=2)
    point = found.at_time(oscillator, 3, 15)
    values = {"m": 1.5, "k": 30.0, "b": 0.1, "x_0": 0.2, "t": 3.0}
    A, phi = (complex(e.subs({s: values[s.name] for s in e.free_symbols})) for e in found.in_units("SI"))
    assert pytest.approx(float(point.amplitude), rel=1e-12) == A and phi == pytest.approx(float(point.phase), abs=1e-12)


def test_what_x_0_is_in_SI_is_said(capsys):
    line = "solution --alpha 2 --mass 3/2 --stiffness 30 --damping 1/10 --x0 -1/5 --order 1"
    assert main(line.split()) == 0
    assert "x_0 = |x(0)|" in capsys.readouterr().out
    assert "x_0 = |x(0)|" in answer(capsys, line)["where"]


def test_units_that_an_implicit_solution_does_not_have_are_refused_by_name(capsys):
    sums = "solution --law 1:1/10 --law 2:1/20 --order 1"
    for units in ("kappa", "SI"):
        assert main([*sums.split(), "--units", units]) == 2
        assert "--units" in capsys.readouterr().err
    assert answer(capsys, f"{sums} --units epsilon")["units"] == "epsilon"
    physical = "solution --law 1:1/10 --law 2:1/20 --mass 2 --stiffness 8 --order 1"
    assert answer(capsys, physical)["units"] == "epsilon"  # the label is that of the formulas
    with pytest.raises(asy.InputError, match="units"):
        solution_at({1: "1/10", 2: "1/20"}, units="kappa")


@pytest.mark.parametrize(("law", "times"), [({0: "1/50"}, [80.0, 100.0]), ({"1/2": "1/20"}, [100.0])])
def test_columns_of_an_order_end_where_its_amplitude_does(law, times):
    found = asy.envelope(law)
    _, A, phi = found.columns(times, order=3)
    assert not np.any(A) and np.all(np.isnan(phi))
    for t in times:
        with pytest.raises(asy.InputError, match="extinct"):
            found.at_order(t, 3)
    _, A, phi = found.columns([1.0], order=3)
    assert [A[0], phi[0]] == pytest.approx([float(v) for v in found.at_order(1, 3)], abs=1e-13)


@pytest.mark.parametrize("start", STARTS)
def test_the_picture_of_an_envelope_starts_at_the_start(start):
    for averaging in ("mean", "squaring"):
        axes = Figure().subplots()
        asy.envelope(started({2: "1/50"}, *start), averaging=averaging).plot(axes, until=3.0)
        x = axes.lines[0].get_ydata()
        assert x[0] == pytest.approx(float(Fraction(start[0])), abs=1e-12)


@pytest.mark.parametrize("alpha", ["1/2", "9/10"])
def test_an_amplitude_of_an_order_ends_at_its_own_first_zero(alpha):
    """Next to the extinction the truncated factor of A_0 turns negative before A_0 does."""
    found = asy.envelope({alpha: "1/5"})
    end = end_of_series(found.series(3), ExactReal(Fraction(1, 5)))
    assert end < 1 / (float(1 - Fraction(alpha)) * float(found.kappas(digits=15)[0]))
    _, A, phi = found.columns(np.linspace(0, 2 * end, 999), order=3)
    assert np.all(A >= 0) and np.all(np.diff(A) <= 0) and np.array_equal(A == 0, np.isnan(phi))
    late = Fraction(end * (1 + 1e-9))
    with pytest.raises(asy.InputError, match="extinct"):
        found.at_order(late, 3)
    assert 0 < float(found.at_order(Fraction(end * (1 - 1e-6)), 3)[0]) < 1e-3


@pytest.mark.parametrize(("law", "late"), [({0: "1/50"}, 80), ({"1/2": "1/5"}, 100), ({"1/2": "1/5"}, "17.9")])
def test_a_solution_ends_where_its_amplitude_vanishes_in_every_answer(law, late):
    found = asy.solution(law, order=3)
    A, phi, x = (float(column[0]) for column in found.sample([float(Fraction(late))]))
    assert (A, x, np.isnan(phi)) == (0.0, 0.0, True)
    with pytest.raises(asy.InputError, match="A has vanished"):
        found.at(late)
    before = found.at(10, digits=15)
    assert [v[0] for v in found.sample([10.0])] == pytest.approx([float(v) for v in before], abs=1e-13)


def test_the_title_of_a_picture_has_its_order():
    axes = Figure().subplots()
    asy.envelope({2: "1/50"}).plot(axes, until=3.0, order=3)
    assert "order 3" in axes.get_title() and "first order" not in axes.get_title()
    svg = asy.envelope({2: "1/50"}).picture("svg", until=3.0, order=3)
    assert b"first order" not in svg


def test_a_strength_of_0_keeps_its_number_beside_a_spring():
    plain, springy = (
        asy.envelope(asy.Oscillator({1: 0, "3/2": 0, 2: "1/20"}, **k)) for k in ({}, {"spring": {3: "1/10"}})
    )
    assert plain.kappas(digits=8) == springy.kappas(digits=8) and springy.kappas(digits=8)[:2] == ("0", "0")
