"""Every value of every table by a second route that shares as little as possible with the first.

``SECOND`` holds, for each table, a function that takes a row as a dictionary and gives, for each column that is no key,
whether the second route agrees.  The test that walks the registry demands an answer for every cell of every default
table; each answer is also asked for the same row with its last digits changed, and must then be no.
"""

import re
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise
from math import exp, inf, log, pi

import mpmath
import numpy as np
import pytest
import sympy
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq

from asymptotics.expansions.divergence.constants import stokes_balls
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_real
from asymptotics.tables.inputs import Inputs
from asymptotics.tables.registry import build, names
from asymptotics.turning.quadratic_series import half_period_series
from tests.second_route.smith_rows import coefficient_by_closed_sum, rows_by_integration
from tests.tables import second

SECOND = {}


def route(name):
    """The second route of a table."""

    def keep(function):
        SECOND[name] = function
        return function

    return keep


def agrees(text, value, tolerance=1e-11):
    """A printed decimal, or an exact form, beside a number: relative, or absolute where the number is 0."""
    given = float(sympy.N(sympy.sympify(text), 20))
    return abs(given - float(value)) <= tolerance * (abs(float(value)) or 1)


def number(text):
    return float(sympy.sympify(text))


def numbers_of(law):
    pairs = [term.split(":") for term in law.split(",")]
    return tuple(number(a) for a, _ in pairs), tuple(number(e) for _, e in pairs)


@lru_cache
def mean_of_sine(p):
    """<|sin|^p>, by quadrature."""
    return second.whole(second.SIN**p) / pi


def slow_law(a, e, A):
    return sum(strength * mean_of_sine(power + 1) * A**power for power, strength in zip(a, e))


@route("moments")
def _(row):
    a = number(row["alpha"])
    orders = {"M_(alpha+1)": a + 1, "M_(2 alpha)": 2 * a, "M_(3 alpha+1)": 3 * a + 1}
    return {column: agrees(row[column], mean_of_sine(p)) for column, p in orders.items()}


@route("lelas-ratios")
def _(row):
    a = number(row["alpha"])
    return {"ratio": agrees(row["ratio"], 2 ** (-(a + 1) / 2) / mean_of_sine(a + 1))}


def coefficient(row, made):
    """A row of the tables of coefficients; ``made`` gives the series by name."""
    alphas = tuple(map(number, row["alpha"].split(",")))
    name, _, key = row["coefficient"].partition("_")
    index = tuple(map(int, key.split(",")))
    expected = made(alphas, max(4, sum(index)), name).get(index, 0.0)
    expected = 0.0 if abs(expected) < 1e-14 else expected
    right = agrees(row["value"], expected)
    return {"value": right, "exact": row["exact"] == "" or agrees(row["exact"], expected)}


@route("normal-form")
def _(row):
    return coefficient(row, lambda a, order, name: dict(zip(("p", "Omega"), second.normal_form(a, order)))[name])


def by_name(alphas, order, name):
    (L, T), (U, W) = second.half_swing(alphas, order), second.flow(alphas, order)
    if name in "LTUW":
        return {"L": L, "T": T, "U": U, "W": W}[name]
    (a,) = alphas
    if name == "V":  # dδ/dψ = (alpha - 1) delta U
        return {(k + 1,): (a - 1) * c for (k,), c in U.items()}
    ratio = second.exponential(second.by(L, a - 1), order)
    return {(k + 1,): c for (k,), c in ratio.items()}


@route("half-swing")
def _(row):
    return coefficient(row, by_name)


@route("half-periods")
def _(row):
    return half_swing_of(row["law"], 1.0, row["ratio"], row["T"], row["ended"]) | {"certified": proved(row)}


def proved(row):
    return row["certified"] == "true"  # what that claims is what the numbers beside it are held to


def half_swing_of(law, amplitude, ratio, T, ended):
    """Whether a half-swing from an amplitude has that ratio and duration, or never comes to its end."""
    a, e = numbers_of(law)
    local = tuple(s * amplitude ** (p - 1) for p, s in zip(a, e))
    end = how_it_ends(a, local)
    if end:
        return {"ratio": ratio == "", "T": T == "", "ended": ended == end}
    q, duration = second.swing_at(a, local)
    return {"ratio": agrees(ratio or "inf", q, 1e-10), "T": agrees(T or "inf", duration, 1e-10), "ended": ended == ""}


def how_it_ends(a, local):
    """What an integrator of another library sees from amplitude 1: no next turning point, and why."""
    if sum(s for p, s in zip(a, local) if p == 0) >= 1:
        return "sticks"
    if turns(a, local):
        return ""
    return "creeps" if min(a) < 1 else "overdamped"


@lru_cache
def turns(a, local):
    def rhs(_, y):
        w = max(-y[1], 0.0)
        return [y[1], -y[0] + sum(e * (w**p if p else 1.0) for p, e in zip(a, local))]

    def turn(t, y):
        return y[1] if t > 0.5 else -1.0

    turn.terminal = True
    return bool(len(solve_ivp(rhs, (0, 8), [1.0, 0.0], "DOP853", rtol=1e-10, atol=1e-13, events=turn).t_events[0]))


@route("turning-points")
def _(row, before=None):
    """From the turning point before it, which is checked in its turn."""
    found = {"certified": proved(row)}
    x, tau = float(row["x"]), float(row["tau"])
    if row["n"] == "0":
        found |= {"x": row["x"].rstrip("0") == "1.", "tau": row["tau"] == "0"}
    else:
        x_0, tau_0 = float(before["x"]), float(before["tau"])
        there = half_swing_of(row["law"], abs(x_0), str(-x / x_0), str(tau - tau_0), "")  # < 0: on the same side
        found |= {"x": there["ratio"], "tau": there["T"]}
    a, e = numbers_of(row["law"])
    local = tuple(s * abs(x) ** (p - 1) for p, s in zip(a, e)) if x else (inf,)
    return found | {"ended": row["ended"] == how_it_ends(a, local) or row["n"] == "4" and not row["ended"]}


@route("error-bounds")
def _(row):
    """The equations of that order integrated, against the half-swing: the bound holds, is near, and has its power."""
    a, N, limit = number(row["alpha"]), int(row["order"]), number(row["delta_max"])
    odd = N % 2
    found = {"m_L": row["m_L"] == str(N + 2 if odd else N + 1), "m_T": row["m_T"] == str(N + 1 if odd else N + 2)}
    near, far = (differences(a, N, limit * share) for share in (0.5, 1.0))
    holds, slack = True, 1e-13 if a else 1e-11  # dry friction takes 98 % of the amplitude: doubles lose digits
    for name, half, full in zip("LT", near, far):
        C, m = number(row[f"C_{name}"]), int(row[f"m_{name}"])
        holds = holds and full <= C * limit**m + slack
        sharp = C == 0 or (C * limit**m < 8 * full and C * (limit / 2) ** m < 12 * half)
        found[f"C_{name}"] = half <= C * (limit / 2) ** m + slack and sharp
    return found | {"delta_max": holds}


def differences(a, N, d):
    """|L - L_N| and |T - T_N| at the local strength d, in doubles."""
    p, Omega = second.normal_form((a,), 4)

    def rates(_, y):
        x = d * exp((a - 1) * y[0])
        speed = 1 + sum(c * x**k for (k,), c in Omega.items() if k <= N)
        return [-sum(c * x**k for (k,), c in p.items() if k <= N) / speed, 1 / speed]

    L, T = solve_ivp(rates, (0, pi), [0.0, 0.0], "DOP853", rtol=1e-13, atol=1e-15).y[:, -1]
    ratio, duration = second.swing_at((a,), (d,))
    return abs(log(ratio) - L), abs(duration - T)


@route("stops")
def _(row):
    """Half-swing by half-swing in rationals."""
    e, x, n = Fraction(row["epsilon"]), Fraction(1), 0
    while abs(x) > e:
        x, n = -(abs(x) - 2 * e) * (1 if x > 0 else -1), n + 1
    return {"N": row["N"] == str(n), "x_N": agrees(row["x_N"], x, 1e-13), "tau_N": agrees(row["tau_N"], n * pi)}


@route("phase-lags")
def _(row):
    """W_2 epsilon/((alpha-1) (-U_1)) with W_2 and U_1 from integrals over theta."""
    a, e = number(row["alpha"]), number(row["epsilon"])
    U, W = second.flow((a,), 2)
    return {"lag": agrees(row["lag"], -W[(2,)] / U[(1,)] * e / (a - 1))}


@route("resonance")
def _(row):
    """The work of the force 1 in step with the speed against that of the losses, R(A) = 1; half of it for the width."""
    a, e = numbers_of(row["law"])
    A = brentq(lambda A: 2 * slow_law(a, e, A) - 1, 1e-9, 1e9, xtol=1e-15, rtol=1e-14)
    half = 2 * slow_law(a, e, A / 2**0.5)
    known = {"amplitude": A, "Q_decay": A, "Q_width": A / (2 * (1 - half**2)) ** 0.5}
    return {column: agrees(row[column], value, 1e-10) for column, value in known.items()}


@route("two-law-times")
def _(row):
    a, e = numbers_of(row["law"])
    expected = quad(lambda A: 1 / slow_law(a, e, A), number(row["A"]), 1, epsabs=1e-11)[0]
    return {"tau": agrees(row["tau"], expected, 1e-7)}


@route("extinction-times")
def _(row):
    a, e = (number(row["alpha"]),), (number(row["epsilon"]),)
    return {"tau_e": agrees(row["tau_e"], quad(lambda A: 1 / slow_law(a, e, A), 0, 1)[0], 1e-7)}


@route("stokes.constants")
def _(row):
    """The Abel functions 0.6 higher up the petal, where the germ takes another order; the pole by quadrature."""
    a = number(row["alpha"])
    pole = 1 / ((a - 1) * pi * mean_of_sine(a + 1))
    c_1, d_1 = (float(x) for x in higher_up(row["alpha"]))
    found = {"pole": agrees(row["pole"], pole), "action": agrees(row["action"], 2 * pi * abs(pole))}
    return found | {"c_1": agrees(row["c_1"], c_1), "d_1": agrees(row["d_1"], d_1)}


@lru_cache
def higher_up(a):
    if a == "0":  # z' = z + 1: all vanish
        return 0, 0
    (c_1,), (d_1,) = stokes_balls(parse_real(a, "alpha"), 1, 13, lift=0.6)
    assert max(c_1.rad() / abs(c_1), d_1.rad() / abs(d_1)) < 1e-12
    return c_1, d_1


@route("lancaster2020.table1")
def _(row):
    """The averaged law, put back: dA/dt = -<|sin|^(alpha+1)> b omega^(alpha+1) A^alpha/k, A(0) = x_0."""
    x0, b, k, m, t, alpha = sympy.symbols("x_0 b k m t alpha")
    a = Fraction(7, 3) if row["alpha"] == "alpha" else Fraction(row["alpha"])
    A = sympy.sympify(row["A"]).subs(alpha, sympy.Rational(str(a)))
    point = {x0: 0.3, b: 0.2, k: 5, m: 2, t: 1.7}
    here, rate, start = (complex(sympy.N(f.subs(point))) for f in (A, sympy.diff(A, t), A.subs(t, 0)))
    wanted = -mean_of_sine(float(a) + 1) * 0.2 * 2.5 ** ((float(a) + 1) / 2) * here ** float(a) / 5
    return {"A": abs(rate - wanted) < 1e-12 and abs(start - 0.3) < 1e-12}


@route("smith2012.table1")
def _(row):
    """2|u'| = 1 + W_0(-y e^-y), y = 1 + 2|u| with mpmath's W_0; at rest S = -(1 + 2u) e^(-2u)/4 on either side."""
    n, u_0 = int(row["half_cycle"]) - 1, Fraction(row.get("u_0", "1"))
    with mpmath.workdps(40):
        start = u = mpmath.mpf(u_0.numerator) / u_0.denominator
        for _ in range(n):
            y = 1 + 2 * u
            u = (1 + mpmath.lambertw(-y * mpmath.exp(-y)).real) / 2
        S = ((1 + 2 * u) * mpmath.exp(-2 * u) - (1 + 2 * start) * mpmath.exp(-2 * start)) / 4
        return {"u": agrees(row["u"], (-1) ** n * u), "S_hat": agrees(row["S_hat"], S)}


@route("smith2012.transit-time")
def _(row):
    i = int(row["i"])
    level = half_period_series(i + 1)[i]  # in powers of p = 2u
    return {"c_i": row["c_i"] == str(Fraction(str(level)) * 2**i)}


@route("smith2012.c")
def _(row):
    n, i = int(row["n"]), int(row["i"])
    c = coefficient_by_closed_sum(n, i)
    integrated = Fraction(str(polynomials(n)[n - 1][i]))
    return {"C": row["C"] == str(c) and c == integrated, "value": agrees(row["value"], c)}


@lru_cache
def polynomials(n):
    return rows_by_integration(n)


@route("smith2012.f")
def _(row):
    w, n = sympy.Symbol("w"), int(row["n"])
    by_integration = polynomials(n)[n - 1].coeffs()
    found = sympy.Poly(sympy.sympify(row["f"]), w).all_coeffs()[::-1]
    return {"f": found == [sympy.Rational(str(c)) for c in by_integration]}


def as_rows(table):
    return [dict(zip(table.columns, row)) for row in table.rows]


def judged(name, rows):
    """What the second route says of each row."""
    if name == "turning-points":
        return [SECOND[name](row, before) for before, row in pairwise([None, *rows])]
    return [SECOND[name](row) for row in rows]


@pytest.mark.parametrize("name", names())
def test_every_cell_of_every_table_has_a_second_route_and_agrees(name):
    table = build(name, 14)
    assert table.certified
    values = set(table.columns) - set(table.keys)
    rows = as_rows(table)
    for row, found in zip(rows, judged(name, rows), strict=True):
        assert set(found) == values, row
        assert all(found.values()), (row, found)


SUMS = [{0: 1, 1: 1}, {1: 1, 2: 1}, {1: 1, 3: 1}, {0: 1, 1: 1, 2: 1}, {"1/2": 1, 2: 1}]
MORE = [
    *((name, Inputs.of(law=Law(law), rows=3)) for name in ("normal-form", "half-swing") for law in SUMS),
    ("smith2012.table1", Inputs.of(epsilons=["1/3", "5"], rows=9)),
    ("turning-points", Inputs.of(law=Law({"1/2": "1/5", "7/3": "1/3"}), rows=5)),
    ("half-periods", Inputs.of(law=Law({0: "1/10", "3/2": "1/2"}))),
    ("two-law-times", Inputs.of(law=Law({"1/3": "1/10", "7/2": "1/5"}))),
    ("stops", Inputs.of(epsilons=["1/7", "2", "1/1000"])),
    ("resonance", Inputs.of(law=Law({"1/2": "1/5", "7/3": "1/3"}))),
    ("phase-lags", Inputs.of(alphas=["sqrt(2)"], epsilons=["1/3"])),
]


@pytest.mark.parametrize(("name", "inputs"), MORE, ids=lambda v: v if isinstance(v, str) else str(v.to_dict()))
def test_other_inputs_too(name, inputs):
    rows = as_rows(build(name, 14, inputs))
    assert all(all(found.values()) for found in judged(name, rows))


@pytest.mark.parametrize("name", names())
def test_a_near_miss_is_refuted_in_every_column(name):
    table = build(name, 14)
    rows = as_rows(table)[:12]
    for column in set(table.columns) - set(table.keys) - {"delta_max"}:  # of delta_max: that the bounds hold there
        refuted = 0
        for place, row in enumerate(rows):
            if column == "exact" and not row[column]:
                continue
            missed = {**row, column: near_miss(column, row[column])}
            before = (rows[place - 1] if place else None,) if name == "turning-points" else ()
            refuted += not SECOND[name](missed, *before)[column]
        assert refuted >= 0.7 * len(rows) or column == "exact"  # C = 0 stays 0, and not every C is sharp


def near_miss(column, cell):
    if column in ("certified", "ended"):
        return {"true": "false", "": "sticks"}.get(cell, "")
    if column in ("C_L", "C_T"):
        return str(float(cell) / 20)
    if column in ("m_L", "m_T", "N"):
        return str(int(cell) + 1)
    if re.fullmatch(r"-?[0-9.]+", cell):
        return repr(float(cell) * 1.00001 or 1e-5)
    return f"{cell}+1/1000" if cell else "1/2"


def test_phase_lags_from_the_lambert_w_map():
    """n pi - tau_n for weak quadratic damping, up to the next order in epsilon."""
    (row,) = build("phase-lags", 12, Inputs.of(alphas=["2"], epsilons=["1/1000"])).rows
    points = build("turning-points", 15, Inputs.of(alphas=["2"], epsilons=["1/1000"], rows=4000)).rows
    lag, total = float(points[-1][3]) - np.pi * (len(points) - 1), float(row[2])
    left = abs(float(points[-1][2]))  # delta is now this share of epsilon
    assert lag == pytest.approx(total * (1 - left), rel=1e-4)
