"""The shipped examples are what their README says: made again here, byte by byte, and identified with their truth."""

import json

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.examples import EXAMPLES, example
from asymptotics.errors import InputError
from asymptotics.shell.main import main


def phone_text():
    """x'' + 16 sin x + 0.048 x' + 0.11 x'|x'| = 0 from 0.7 rad, by Runge and Kutta's rule of order 4, 2 ms a step."""
    h, state, rows = 0.002, np.array([0.7, 0.0]), []
    random = np.random.default_rng(22)

    def slope(y):
        return np.array([y[1], -16 * np.sin(y[0]) - 0.048 * y[1] - 0.11 * y[1] * abs(y[1])])

    for step in range(15_000):
        if step % 10 == 0:
            swing = np.array([0.06, 1.0, -0.04]) * state[1] + [0.003, -0.012, 0.006] + 0.008 * random.standard_normal(3)
            rows.append([step * h, *swing, np.sqrt((swing**2).sum())])
        a = slope(state)
        b = slope(state + h / 2 * a)
        c = slope(state + h / 2 * b)
        state = state + h / 6 * (a + 2 * b + 2 * c + slope(state + h * c))
    head = '"Time (s)","Gyroscope x (rad/s)","Gyroscope y (rad/s)","Gyroscope z (rad/s)","Absolute (rad/s)"\n'
    return head + "".join(",".join([f"{row[0]:.2f}", *(f"{v:.4f}" for v in row[1:])]) + "\n" for row in rows)


def ringdown_text():
    """dA/dt = -A/9 - 0.05 A^3, in closed form from A = 2 at t = 1.8 s, where the drive of 62.4 kHz stops; 1 % noise."""
    t = 0.12 * np.arange(500)
    k, c = 1 / 9, 0.05
    u = (1 / 4 + c / k) * np.exp(2 * k * np.maximum(t - 1.8, 0)) - c / k
    driven = 2 * (1 - np.exp(-(t + 0.6) / 0.5))
    a = np.where(t < 1.8, driven, 1 / np.sqrt(u)) * (1 + 0.01 * np.random.default_rng(23).standard_normal(500))
    head = "% Frequency [Hz]: 62400\n% time [s], power [dBm]\n"
    return head + "".join(f"{s:.2f}, {20 * np.log10(v):.4f}\n" for s, v in zip(t, a))


@pytest.mark.parametrize(("name", "made"), [("phone", phone_text), ("ringdown", ringdown_text)])
def test_the_file_is_what_its_readme_says(name, made):
    # To a digit in a thousand cells: other processors round otherwise.
    mine, theirs = made().splitlines(), example(name).read_text().splitlines()
    assert len(mine) == len(theirs) and sum(a != b for a, b in zip(mine, theirs)) <= len(mine) // 1000


def test_the_phone_is_a_pendulum_with_both_losses():
    laws = ["1+pendulum", "1+2+pendulum", "1+2"]
    answer = asy.identify(example("phone"), laws=laws, bootstrap=False)
    assert any("v: 'Gyroscope y (rad/s)'" in note for note in answer.notes)
    law = answer.law("1+2+pendulum").law
    assert law.verdict == "consistent" and answer.law("1+pendulum").law.verdict == "refuted"
    assert law.epsilon[0].contains(0.048 / 4) and law.epsilon[1].contains(0.11)


def test_the_ringdown_has_its_losses():
    answer = asy.identify(example("ringdown"), laws=["1", "3", "1+3", "1+2"], bootstrap=False)
    law, omega = answer.law("1+3").law, 2 * np.pi * 62_400
    assert law.verdict == "consistent" and answer.law("1").law.verdict == "refuted"
    # dA/dt = -(1/2) e_1 omega A - (3/8) e_3 omega A^3.
    assert law.epsilon[0].contains(2 / 9 / omega) and law.epsilon[1].contains(8 / 3 * 0.05 / omega)


def test_the_shell_takes_an_example_by_its_name(capsys):
    assert main(["identify", "--example", "ringdown", "--laws", "1", "1+3", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["data"][0]["name"] == EXAMPLES["ringdown"]
    assert main(["identify", "--example", "boat"]) == 2
    assert "'boat' is unknown (accepted: phone, ship, ringdown)" in capsys.readouterr().err
    assert main(["identify"]) == 2
    assert "FILE: is missing" in capsys.readouterr().err
    with pytest.raises(InputError, match="argument example"):
        example("boat")
