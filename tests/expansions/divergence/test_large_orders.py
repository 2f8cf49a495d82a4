"""Cauchy-Heine against the exact coefficients, and the laws of p_k, Omega_k, V_k to order 60; near misses refuted."""

from functools import cache

import pytest
from flint import arb
from mpmath import mp

from asymptotics.expansions.divergence.abel import at_height, odd_series
from asymptotics.expansions.divergence.constants import effort, rough_petal, stokes_balls
from asymptotics.expansions.divergence.germ import germ
from asymptotics.expansions.normal_form.coefficients import expansion_coefficients
from asymptotics.expansions.normal_form.expansion import exact_expansion
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import parse_real
from asymptotics.turning.quadratic_series import abel_coefficients
from tests.second_route.abel_rows import corrections, rows_of
from tests.second_route.large_orders import large_order

ORDERS = [
    ("2", 30),
    pytest.param("2", 60, marks=pytest.mark.slow),
    pytest.param("3", 60, marks=pytest.mark.slow),
    pytest.param("3/2", 60, marks=pytest.mark.slow),
]


def number(x):
    return mp.mpf(x.mid().str(40, radius=False)) if isinstance(x, arb) else mp.mpf(int(x.p)) / int(x.q)


@cache
def known(text):
    """(c, f, c_1, d_1) as mpmath numbers: the germ gives the first two."""
    law = parse_real(text, "alpha")
    c_1, d_1 = (number(x[0]) for x in stokes_balls(law, 1, 17))
    with ctx.workprec(150):
        g = germ(law, 24, 150, 0.2)
        f = 4 * arb.pi() ** 2 * odd_series(g)[0].coefficients[0] * g.c
        return number(g.c), number(f), c_1, d_1


def test_cauchy_heine_gives_the_exact_coefficients():
    """e_n c^n, exact by Smith's map, = (+-1/pi) int D y^(n-1) dy + O(y_0^n): trapezoidal rule over certified D."""
    with mp.workdps(40):
        exact = [number(e) / 2 * mp.mpf(2) ** (2 * k) for k, e in enumerate(abel_coefficients(32))]
        c, y_0, step = known("2")[0], 3, mp.mpf(1)
        assert abs(exact[0] - c) < 1e-30
        D = dict(heights(y_0, 20, step))
        for n, tolerance in ((53, 1e-4), (61, 1e-6)):
            e = exact[(n + 1) // 2] * c**n
            sign = (-1) ** ((n - 1) // 2)
            integral = step * sum(d * y ** (n - 1) for y, d in D.items())
            assert abs(sign * integral / mp.pi / e - 1) < tolerance
            assert not abs(-sign * integral / mp.pi / e - 1) < 0.1
            one = known("2")[2] / mp.pi * sign * mp.factorial(n - 1) / (2 * mp.pi) ** n
            f = known("2")[1]
            assert abs(one * (1 + f / (n - 1)) / e - 1) < abs(f / (n - 1)) / 5 < abs(one / e - 1)


def heights(y_0, top, step):
    """(y, D) from y_0 to ``top``."""
    law = parse_real("2", "alpha")
    rough, p = rough_petal(law)
    plan = effort(rough, p, 1, 10)
    bits = plan.bits + 250
    with ctx.workprec(bits):
        g = germ(law, plan.order, bits, plan.small)
        series = odd_series(g)
        for j in range(int((top - y_0) / step) + 1):
            y = y_0 + j * step
            yield y, 2 * number(at_height(g, p, series, arb(str(y)))[0].real)


@pytest.mark.parametrize(("text", "order"), ORDERS)
def test_the_laws_of_p_and_omega(text, order):
    """Each correction takes a power of k from what is left, down to c_2 or 10^-14; near misses are refuted."""
    law = parse_real(text, "alpha")
    c_1, d_1 = (x[0] for x in stokes_balls(law, 1, 25))
    made = rows_of(law, order)
    with mp.workdps(40), ctx.workprec(200):
        c, constants = number(made.c), (number(c_1), number(d_1))
        for row, values in zip(("p", "Omega"), rows(text, order, made), strict=True):
            k = max(values)
            g = [number(x) for x in corrections(made, row, c_1, d_1, 14)]
            scale = values[1] if row == "p" else 1

            def left(count, pair=constants, row=row, k=k, g=g, ratio=values[k] / scale):
                kept = [*g[:count], *[mp.mpf(0)] * (count == 0)]
                return abs(ratio / large_order(k, row, c, kept[0], *pair, kept[1:]) - 1)

            falling = [left(count) for count in (0, 1, 2, 6, 10, 14)]
            assert all(a > 1.5 * b for a, b in zip(falling, falling[1:], strict=False))
            least = 30 * mp.mpf(2) ** -min(k, 50)
            assert falling[-1] < least and falling[2] < 450 / mp.mpf(k) ** 3
            assert not left(14, (constants[0], constants[1] * (1 + 9 * least))) < least
            if row == "p":  # c_1 alone: a constant of the amplitude without that of the time
                assert not left(14, (constants[0], mp.mpf(0))) < 0.1


def test_the_first_correction_is_f():
    c, f, _, _ = known("2")
    for row in ("V", "p", "Omega"):
        g = corrections(rows_of(parse_real("2", "alpha"), 6), row, arb(1), arb(1), 2)
        assert abs(number(g[0]) / f - 1) < 1e-15 and not abs(number(g[1]) / (f**2 / 2) - 1) < 0.1


def rows(text, order, made):
    """p_k of odd k and Omega_k of even k > 0: exact for integers, for 3/2 those of the Abel function."""
    if "/" not in text:
        found = exact_expansion((int(text),), order)
        p, Omega = ({k: row[k].ball() for k in range(1, order + 1) if row[k]} for row in (found.p, found.Omega))
    else:
        p, Omega = ({k: row[k] for k in range(1, order + 1)} for row in (made.p, made.Omega))
    return {k: number(p[k]) for k in range(1, order + 1, 2)}, {k: number(Omega[k]) for k in range(2, order + 1, 2)}


@pytest.mark.parametrize(("text", "order"), [("3/2", 8), ("sqrt(7)", 6), ("1/3", 6)])
def test_the_rows_of_the_abel_function_are_those_of_the_half_swing(text, order):
    law = parse_real(text, "alpha")
    made, found = rows_of(law, order), expansion_coefficients([law], order, 20)
    with mp.workdps(30):
        for row, values in ((found.amplitude, made.p), (found.frequency, made.Omega)):
            for k, coefficient in row.items():
                ball, value = values[int(k)], mp.mpf(coefficient.value)
                assert abs(number(ball) - value) <= mp.mpf(10) ** -19 * abs(value) and float(ball.rad()) < 1e-15
    moved = rows_of(parse_real("1001/2000", "alpha"), 4)
    assert not moved.p[3].overlaps(rows_of(parse_real("1/2", "alpha"), 4).p[3])


def test_the_law_of_v():
    c, f, c_1, d_1 = known("2")
    V = exact_expansion((2,), 40).turning_point_flow().U
    with mp.workdps(40), ctx.workprec(200):
        value = number(V[39].ball())  # V_40 = (alpha - 1) U_39
        assert abs(value / large_order(40, "V", c, f, c_1, d_1) - 1) < 5e-3
        assert not abs(value / large_order(40, "V", c, f, c_1 + d_1 / mp.pi, d_1) - 1) < 0.1
