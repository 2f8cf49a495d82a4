"""Cauchy-Heine against the exact coefficients, and the laws of p_k, Omega_k, V_k to order 60; near misses refuted."""

from functools import cache

import pytest
from flint import arb
from mpmath import mp

from asymptotics.divergence.abel import at_height, odd_series
from asymptotics.divergence.constants import effort, rough_petal, stokes_balls
from asymptotics.divergence.germ import germ
from asymptotics.normal_form.coefficients import expansion_coefficients
from asymptotics.normal_form.expansion import exact_expansion
from asymptotics.normal_form.large_orders import large_order
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import parse_real
from asymptotics.turning.quadratic_series import abel_coefficients

ORDERS = [
    ("2", 30),
    pytest.param("2", 60, marks=pytest.mark.slow),
    pytest.param("3", 60, marks=pytest.mark.slow),
    pytest.param("3/2", 24, marks=pytest.mark.slow),
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
    """p_k has c_1 + d_1/pi, Omega_k has d_1, with the first correction; c_1 alone and no correction are refuted."""
    c, f, c_1, d_1 = known(text)
    p, Omega = rows(text, order)
    least = 40 if "/" not in text else 120  # the O(k^-2) has no numbers: at 3/2 it is 90 k^-2
    with mp.workdps(40):
        k = max(p)
        law = large_order(k, "p", c, f, c_1, d_1) * p[1]
        assert abs(p[k] / law - 1) < least / mp.mpf(k) ** 2
        wrong = large_order(k, "p", c, f, c_1, 0) * p[1]
        assert not abs(p[k] / wrong - 1) < 0.1
        shown = (p[k] / law * (1 + f / (k - 2)) - 1) * (k - 2)  # the first correction, seen in p_k
        assert abs(shown / f - 1) < 2 * least / mp.mpf(k) / abs(f) < 1
        k = max(Omega)
        law = large_order(k, "Omega", c, f, c_1, d_1)
        assert abs(Omega[k] / law - 1) < least / mp.mpf(k) ** 2
        assert abs(Omega[k] / law - 1) < abs(Omega[k] / law * (1 + f / (k - 1)) - 1)


def rows(text, order):
    """p_k of odd k and Omega_k of even k > 0: exact for integers, certified for 3/2."""
    if "/" not in text:
        found = exact_expansion((int(text),), order)
        with ctx.workprec(200):
            p = {k: number(found.p[k].ball()) for k in range(1, order + 1, 2)}
            return p, {k: number(found.Omega[k].ball()) for k in range(2, order + 1, 2)}
    found = expansion_coefficients([parse_real(text, "alpha")], order, 25)
    p, Omega = ({int(k): mp.mpf(c.value) for k, c in row.items()} for row in (found.amplitude, found.frequency))
    return {k: x for k, x in p.items() if x}, {k: x for k, x in Omega.items() if x}


def test_the_law_of_v():
    c, f, c_1, d_1 = known("2")
    V = exact_expansion((2,), 40).turning_point_flow().U
    with mp.workdps(40), ctx.workprec(200):
        value = number(V[39].ball())  # V_40 = (alpha - 1) U_39
        assert abs(value / large_order(40, "V", c, f, c_1, d_1) - 1) < 5e-3
        assert not abs(value / large_order(40, "V", c, f, c_1 + d_1 / mp.pi, d_1) - 1) < 0.1
