"""What ``identify --csv`` and ``damping --csv`` say of Q, zeta, T and omega at amplitudes: a pendulum integrated here.

The truth is that of whole motions by another integrator (DOP853 with events), one half-swing at a time whose geometric
mean amplitude is the one of the row: no formula of the library enters.
"""

import csv
from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from asymptotics.shell.main import main

UNIT = 1.7 / (2 * np.pi)  # s for 1/omega_0
LINEAR, QUADRATIC = 0.012, 0.03
TURNS = {"period": lambda T: T, "omega": lambda T: 2 * np.pi / T}
LOSES = {
    "Q": lambda fall, T: np.pi / 2 / fall, "zeta": lambda fall, T: fall / np.pi,
    "rate of decay": lambda fall, T: 2 * fall / T,
}  # fmt: skip


def moves(_, y):
    return [y[1], -np.sin(y[0]) - LINEAR * y[1] - QUADRATIC * y[1] * abs(y[1])]


def half_swing(first):
    """(turning amplitude, time) of the half-swing from rest at ``first``."""
    turned = lambda _, y: y[1]  # noqa: E731
    turned.terminal, turned.direction = True, 1
    found = solve_ivp(moves, (0, 20), [first, -1e-13], events=turned, method="DOP853", rtol=1e-11, atol=1e-13)
    return abs(found.y[0, -1]), found.t[-1]


@cache
def truth(amplitude):
    """(fall of ln A, period in s) of the half-swing whose ends have this geometric mean."""
    first = amplitude
    for _ in range(8):  # what is off shrinks to a hundredth
        last, _time = half_swing(first)
        first *= amplitude / np.sqrt(first * last)
    last, time = half_swing(first)
    return np.log(first / last), 2 * time * UNIT


@pytest.fixture(scope="module")
def rows(tmp_path_factory):
    """The rows of the table that stand before any law, of a record in milliseconds."""
    folder = tmp_path_factory.mktemp("written")
    t = np.arange(1500) / 40 * 2 * np.pi
    found = solve_ivp(moves, (0, t[-1]), [1.2, 0.0], t_eval=t, method="DOP853", rtol=1e-10, atol=1e-12)
    x = found.y[0] + 1e-3 * np.random.default_rng(4).standard_normal(len(t))
    data = np.column_stack([1e3 * t * UNIT, x])
    np.savetxt(folder / "decay.csv", data, delimiter=",", header="t [ms],phi [rad]", comments="", fmt="%.9g")
    line = ["identify", str(folder / "decay.csv"), "--laws", "1+2+pendulum", "--csv", str(folder / "table.csv")]
    assert main([*line, "--quiet"]) == 0
    table = csv.DictReader((folder / "table.csv").read_text(encoding="utf-8").splitlines())
    return {
        r["parameter"]: [float(r[n]) for n in ("low", "estimate", "high")]
        for r in table
        if r["law"] == "before any law"
    }


@pytest.mark.parametrize("name", [*TURNS, *LOSES])
def test_the_table_before_any_law_holds_the_truth_of_another_integrator(rows, name):
    own = {key: ends for key, ends in rows.items() if key.startswith(f"{name} at ")}
    assert len(own) == 3
    for key, (low, estimate, high) in own.items():
        fall, period = truth(float(key.removeprefix(f"{name} at ").split()[0]))
        right = LOSES[name](fall, period) if name in LOSES else TURNS[name](period)
        right *= {"[ms]": 1e3, "[1/ms]": 1e-3}.get(key.split()[-1], 1)
        assert low < right < high and abs(estimate - right) < 0.04 * right, key
        assert high - low < 0.1 * right  # near miss: an interval that holds everything
