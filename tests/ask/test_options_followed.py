"""What an option changes is changed wherever it is told: in the text, the header, the letters, the export, the numbers.

Each of these was wrong once, beside numbers that were right.
"""

import csv
import json

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import asymptotics as asy
from asymptotics import Law, Oscillator
from asymptotics.shell.main import main


def shown(capsys, line):
    assert main(line.split()) == 0, capsys.readouterr().err
    return capsys.readouterr().out


def test_a_spring_beside_a_limit_cycle_is_not_multiplied_by_mu(capsys):
    """The printed equation, integrated, ends in the printed cycle; with the spring under mu it does not."""
    found = asy.limit_cycle(Law({1: -1, (1, 2): 1}), spring={3: "1/2"}, mu="1/2", digits=12)
    equation = "x'' + x + 1/2 x^3 + mu (-x' + x^2 x') = 0"
    assert equation in str(found) and found.to_dict()["equation"] == equation
    assert equation in shown(capsys, "limit-cycle --law 1:-1 --law 1,2:1 --spring 3:1/2 --mu 1/2")

    def amplitude(c):
        orbit = solve_ivp(lambda t, y: [y[1], -y[0] - c * y[0] ** 3 - 0.5 * (y[0] ** 2 - 1) * y[1]], (0, 40), [2, 0],
                          rtol=1e-9, atol=1e-9, dense_output=True)  # fmt: skip
        return np.abs(orbit.sol(np.linspace(30, 40, 2001))[0]).max()

    assert amplitude(0.5) == pytest.approx(float(found.at_mu.amplitude), abs=1e-4)
    assert amplitude(0.25) != pytest.approx(float(found.at_mu.amplitude), abs=1e-2)
    plain = asy.limit_cycle(Law({1: -1, (1, 2): 1}), order=2).equation
    assert plain == "x'' + x + mu (-x' + x^2 x') = 0"


@pytest.mark.parametrize(
    "law", ["--alpha 3", "--alpha 3 --damping 1/10 --mass 3/2 --stiffness 30", "--law 2:1/10 --law 1:1"]
)
def test_a_table_in_another_gauge_is_held_against_that_gauge(capsys, tmp_path, law):
    """The coefficients of order 3 differ between gauges: those of the first one would be called wrong."""
    shown(capsys, f"expand {law} --order 3 --gauge averaging --csv {tmp_path / 'g.csv'}")
    found = json.loads(shown(capsys, f"compare {tmp_path / 'g.csv'} --json"))
    assert found["certified"] and float(found["summary"]["worst_digits"]) > 29
    shown(capsys, f"expand {law} --order 3 --csv {tmp_path / 'f.csv'}")
    first, second = ((tmp_path / name).read_text().splitlines()[1:] for name in ("f.csv", "g.csv"))
    assert first != second


@pytest.mark.parametrize("start", [{"x0": "-1/5"}, {"x0": "1/5"}, {"x0": 0, "v0": 1}])
def test_the_start_is_no_event(start):
    oscillator = Oscillator({2: "1/10"}, mass=2, stiffness=8, **start)
    one, other = asy.motion(oscillator).events(4), asy.reference(oscillator).events(4)
    assert len(one.turning) == len(other.turning) == (2 if "v0" not in start else 3)
    assert len(one.zeros) == len(other.zeros) and min(*one.turning, *one.zeros) > 0.1


def test_the_error_of_a_gauge_at_the_start_is_no_event():
    for gauge in ("averaging", "no-first-harmonic"):
        assert min(asy.motion(Oscillator({3: "1/10"}), order=3, gauge=gauge).events(9).turning) > 3


def test_a_bound_stands_in_the_export_of_a_sweep(capsys, tmp_path):
    line = "sweep motion --alpha 2 --epsilon 1/10 --order 2 --time 1,2 --bound --workers 1"
    shown(capsys, f"{line} --store {tmp_path / 'runs'} --export {tmp_path / 'x.csv'}")
    rows = list(csv.DictReader((tmp_path / "x.csv").read_text().splitlines()))
    alone = json.loads(shown(capsys, "motion --alpha 2 --epsilon 1/10 --order 2 --time 2 --bound --json"))
    assert rows[1]["result.bound"] == alone["bound"] != "" and rows[1]["bound"] == ""


def test_the_amplitude_of_a_pendulum_is_in_radians(capsys):
    line = "expand --law 1:1/20 --mass 1 --stiffness 1"
    assert "A in rad, t in s" in shown(capsys, f"{line} --spring pendulum") and "A in m, t in s" in shown(capsys, line)


def test_psi_is_what_the_gauge_makes_it():
    for gauge, told in (("turning-point", "n pi at the n-th turning point"), ("averaging", "phase, gauge averaging")):
        assert told in asy.expand(3, order=3, gauge=gauge)._repr_latex_()


@pytest.mark.parametrize(
    "line", ["expand --alpha 2 --best-order 1/3", "motion --alpha 2 --epsilon 1/10 --time 1 --best-order 1/3"]
)
def test_no_number_of_json_is_a_float(capsys, line):
    def no(text):
        raise AssertionError(text)

    found = json.loads(shown(capsys, f"{line} --json"), parse_float=no)
    assert float(found["best_order"]["predicted"]) > 0 and all(map(float, found["best_order"]["errors"]))
