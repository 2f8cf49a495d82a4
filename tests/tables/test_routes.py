"""Every value of every table by a second route that shares as little as possible with the first."""

from fractions import Fraction
from functools import cache
from itertools import pairwise

import mpmath
import numpy as np
import pytest
import sympy
from scipy.integrate import quad, solve_ivp

from asymptotics.envelopes.symbolic import averaged_law
from asymptotics.half_swings.symbolic import alpha as symbol
from asymptotics.invariants.exact import coefficient_by_closed_sum, rows_by_integration
from asymptotics.normal_form.symbolic import omega_2
from asymptotics.tables.inputs import Inputs
from asymptotics.tables.registry import build, names
from asymptotics.turning.quadratic_series import half_period_series

CHECKED = {
    "moments", "lelas-ratios", "normal-form", "half-swing", "turning-points", "half-periods", "stops", "phase-lags",
    "extinction-times", "two-law-times", "lancaster2020.table1", "smith2012.table1", "smith2012.transit-time",
    "smith2012.c", "smith2012.f", "error-bounds",
}  # fmt: skip


def test_no_table_is_left_out():
    assert set(names()) == CHECKED


def near(text, value, digits):
    return abs(mpmath.mpf(text) - value) <= abs(value) * mpmath.mpf(10) ** -digits


def mean_of_sine(p):
    """<|sin|^p> by mpmath's quadrature."""
    return mpmath.quad(lambda t: mpmath.sin(t) ** p, [0, mpmath.pi / 2]) * 2 / mpmath.pi


def test_moments_and_lelas_ratios_are_integrals():
    with mpmath.workdps(25):
        for row in build("moments", 20).rows:
            a = mpmath.mpf(Fraction(row[0]).numerator) / Fraction(row[0]).denominator
            for text, p in zip(row[1:], (a + 1, 2 * a, 3 * a + 1)):
                assert near(text, mean_of_sine(p), 18 if a == int(a) else 9)  # the end points are branch points
        for name, text in build("lelas-ratios", 20).rows:
            a = mpmath.mpf(Fraction(name).numerator) / Fraction(name).denominator
            assert near(text, 2 ** (-(a + 1) / 2) / mean_of_sine(a + 1), 9)


def test_normal_form_has_the_closed_forms_of_symbolic_alpha():
    for alpha, name, value, _ in build("normal-form", 15).rows:
        a = sympy.Rational(alpha)
        if name == "p_1":
            expected = averaged_law(a).p_1
        elif name == "Omega_2":
            expected = omega_2().subs(symbol, a)
        else:
            continue
        assert near(value, mpmath.mpf(str(sympy.N(expected, 20))), 13) or value == "0" == str(expected)


def swing(alphas, epsilons, x0=1.0):
    """One half-swing by SciPy with the sign of v fixed: (|x_1|, T)."""

    def rhs(_, y):
        w = max(-y[1], 0.0)
        return [y[1], -y[0] + sum(e * (w**a if a else 1.0) for a, e in zip(alphas, epsilons))]

    def turn(t, y):
        return y[1] if t > 0.5 else -1.0

    turn.terminal = True
    found = solve_ivp(rhs, (0, 8), [x0, 0.0], "DOP853", rtol=1e-12, atol=1e-14, events=turn)
    if not len(found.t_events[0]):
        return None
    return -found.y_events[0][0][0], found.t_events[0][0]


def numbers_of(law):
    pairs = [tuple(map(Fraction, term.split(":"))) for term in law.split(",")]
    return [float(a) for a, _ in pairs], [float(e) for _, e in pairs]


def test_half_periods_by_an_integrator():
    for law, ratio, duration, certified, ended in build("half-periods", 12).rows:
        assert certified == "true"
        if ended:
            assert (ratio, duration) == ("", "")
            continue
        q, T = swing(*numbers_of(law))
        assert float(ratio) == pytest.approx(q, rel=1e-8, abs=1e-8)
        assert float(duration) == pytest.approx(T, rel=1e-6)  # a multiple root for the event: half the digits


def test_turning_points_by_an_integrator_one_after_the_other():
    rows = build("turning-points", 12).rows
    for here, there in pairwise(rows):
        if here[0] != there[0]:
            continue
        found = swing(*numbers_of(here[0]), abs(float(here[2])))
        side = 1 if float(here[2]) > 0 else -1
        assert float(there[2]) == pytest.approx(-side * found[0], rel=1e-8)
        assert float(there[3]) - float(here[3]) == pytest.approx(found[1], rel=1e-6)


def test_the_half_swing_series_gives_the_half_swing():
    rows = build("half-swing", 15, Inputs.of(alphas=["1/2", "3/2", "2", "3"], rows=4)).rows
    for alpha in ("1/2", "3/2", "2", "3"):
        found = {name: float(value) for a, name, value, _ in rows if a == alpha}
        e, a = 0.002, float(Fraction(alpha))
        q, T = swing([a], [e])
        assert sum(found[f"L_{k}"] * e**k for k in range(1, 5)) == pytest.approx(np.log(q), abs=1e-10)
        assert sum(found.get(f"T_{k}", 0) * e**k for k in range(5)) == pytest.approx(T, abs=1e-6)
        assert sum(found[f"F_{k}"] * e**k for k in range(1, 5)) == pytest.approx(e * q ** (a - 1), rel=1e-7)


def test_error_bounds_hold_and_are_nearly_attained():
    """Order 1: A = (1 + (alpha-1) p_1 delta tau)^(-1/(alpha-1)) at tau = pi, T = pi; the truth is certified."""
    for alpha, order, limit, C_L, m_L, C_T, m_T in build("error-bounds", 5, Inputs.of(rows=1)).rows:
        a, d = Fraction(alpha), Fraction(limit) / 2
        if alpha == "0":
            continue
        p_1 = float(mean_of_sine(float(a) + 1))
        fall = np.pi * p_1 * float(d)
        L_1 = -fall if a == 1 else -np.log1p(float(a - 1) * fall) / float(a - 1)
        ((_, ratio, T, _, _),) = build("half-periods", 20, Inputs.of(alphas=[alpha], epsilons=[str(d)])).rows
        for wrong, C, m in ((np.log(float(ratio)) - L_1, C_L, m_L), (float(T) - np.pi, C_T, m_T)):
            bound = float(C) * float(d) ** int(m)
            assert abs(wrong) <= bound
            assert abs(wrong) > bound / 8  # C is that at delta_max: the next order is in it
        assert order == "1"


def test_stops_in_rationals():
    for epsilon, last, place, tau in build("stops", 15).rows:
        e, x, n = Fraction(epsilon), Fraction(1), 0
        while abs(x) > e:
            x, n = -(abs(x) - 2 * e) * (1 if x > 0 else -1), n + 1
        assert int(last) == n
        assert Fraction(place) == x
        assert near(tau, n * mpmath.pi, 13)


def test_phase_lags_from_the_lambert_w_map():
    """n pi - tau_n for weak quadratic damping, up to the next order in epsilon."""
    (row,) = build("phase-lags", 12, Inputs.of(alphas=["2"], epsilons=["1/1000"])).rows
    points = build("turning-points", 15, Inputs.of(alphas=["2"], epsilons=["1/1000"], rows=4000)).rows
    lag, total = float(points[-1][3]) - np.pi * (len(points) - 1), float(row[2])
    left = abs(float(points[-1][2]))  # delta is now this share of epsilon
    assert lag == pytest.approx(total * (1 - left), rel=1e-4)
    for alpha, _, text in build("phase-lags", 15).rows:
        a = sympy.Rational(alpha)
        expected = -omega_2().subs(symbol, a) / ((a - 1) * averaged_law(a).p_1) / 10
        assert near(text, mpmath.mpf(str(sympy.N(expected, 20))), 13)


def test_times_of_averaged_laws_by_quadrature():
    @cache
    def mean(a):
        return float(mean_of_sine(a + 1))

    def rate(law, A):
        return sum(e * mean(a) * A**a for a, e in zip(*numbers_of(law)))

    for law, A, tau in build("two-law-times", 12).rows:
        expected = quad(lambda x, law=law: 1 / rate(law, x), float(Fraction(A)), 1, epsabs=1e-11)[0]
        assert float(tau) == pytest.approx(expected, rel=1e-7)
    for alpha, epsilon, tau in build("extinction-times", 12).rows:
        law = f"{alpha}:{epsilon}"
        assert float(tau) == pytest.approx(quad(lambda x, law=law: 1 / rate(law, x), 0, 1)[0], rel=1e-7)


def test_lancasters_table_solves_the_averaged_law():
    x0, b, k, m, t = (sympy.Symbol(s, positive=True) for s in ("x_0", "b", "k", "m", "t"))
    places = {str(s): s for s in (x0, b, k, m, t)}
    point = {x0: 0.3, b: 0.2, k: 5, m: 2, t: 1.7}
    for alpha in (0, 1, sympy.Rational(3, 2), 2, 3):
        A = averaged_law(alpha).physical_amplitude()
        A = A.subs({s: places[str(s)] for s in A.free_symbols})
        w = sympy.sqrt(k / m)
        right = -averaged_law(alpha).p_1 * b * w ** (alpha + 1) * A**alpha / k
        assert abs(sympy.N((sympy.diff(A, t) - right).subs(point))) < 1e-12
        assert sympy.simplify(A.subs(t, 0) - x0) == 0


@pytest.mark.parametrize("u_0", ["1", "1/3", "5"])
def test_smiths_table_by_the_lambert_w_function_of_mpmath(u_0):
    """2|u'| = 1 + W_0(-y e^-y), y = 1 + 2|u|; S^-(|u|) = -(1 + 2u) e^(-2u)/2 up to a constant, so that S_n follows."""
    rows = build("smith2012.table1", 20, Inputs.of(epsilons=[u_0], rows=9)).rows
    with mpmath.workdps(40):
        u = mpmath.mpf(Fraction(u_0).numerator) / Fraction(u_0).denominator
        for row in rows:
            assert near(row[3].lstrip("-"), u, 18)
            y = 1 + 2 * u
            u = (1 + mpmath.lambertw(-y * mpmath.exp(-y)).real) / 2
        assert [row[3].startswith("-") for row in rows] == [n % 2 == 1 for n in range(9)]
        start = mpmath.mpf(Fraction(u_0).numerator) / Fraction(u_0).denominator
        for row in rows[1:]:  # at rest S = -(1 + 2u) e^(-2u)/4 on either side
            u = abs(mpmath.mpf(row[3]))
            expected = ((1 + 2 * u) * mpmath.exp(-2 * u) - (1 + 2 * start) * mpmath.exp(-2 * start)) / 4
            assert near(row[2], expected, 16)


def test_smiths_coefficients_by_integration_and_by_the_closed_sum():
    polynomials = rows_by_integration(9)
    for n, i, text, value in build("smith2012.c", 12, Inputs.of(rows=9)).rows:
        c = coefficient_by_closed_sum(int(n), int(i))
        assert Fraction(text) == c
        assert near(value, mpmath.mpf(c.numerator) / c.denominator, 11)
        assert str(polynomials[int(n) - 1][int(i)]) == text
    w = sympy.Symbol("w")
    for n, text in build("smith2012.f", 12, Inputs.of(rows=9)).rows:
        expected = sum(sympy.Rational(str(c)) * w**i for i, c in enumerate(polynomials[int(n) - 1].coeffs()))
        value = {"w": Fraction(1, 3)}
        by_hand = sum(Fraction(str(c)) * value["w"] ** i for i, c in enumerate(polynomials[int(n) - 1].coeffs()))
        assert str(expected) == text or float(by_hand) == pytest.approx(float(sympy.S(expected).subs(w, 1 / 3)))


def test_the_transit_time_is_the_series_of_the_level_integral():
    rows = dict(build("smith2012.transit-time", 5).rows)
    for i, c in enumerate(half_period_series(11)):  # in powers of p = 2u
        assert Fraction(rows[str(i)]) == Fraction(str(c)) * 2**i
