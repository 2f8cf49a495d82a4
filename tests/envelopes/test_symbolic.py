"""One law, first order: the averaged law by substitution, Table I, the limit alpha -> 1, the phase, Lelas."""

import pytest
import sympy
from mpmath import mp
from sympy import Integer, Rational, diff, gamma, limit, pi, simplify, sqrt

from asymptotics.envelopes.symbolic import (
    SQUARING,
    alpha,
    amplitude_symbol,
    averaged_law,
    b,
    epsilon,
    k,
    m,
    t,
    tau,
    x_0,
)
from asymptotics.errors import InputError
from asymptotics.expansions.moments.symbolic import squaring_ratio
from asymptotics.expansions.normal_form.symbolic import alpha as engine_alpha
from asymptotics.expansions.normal_form.symbolic import omega_2

ABOVE = 1 + sympy.Symbol("mu", positive=True)  # a symbolic exponent above 1
OMEGA_0 = sqrt(k / m)


@pytest.mark.parametrize("exponent", [0, Rational(1, 2), 1, Rational(3, 2), 2, 3, sqrt(2), ABOVE, alpha])
@pytest.mark.parametrize("averaging", ["mean", "squaring"])
def test_the_averaged_law_is_solved(exponent, averaging):
    law = averaged_law(exponent, averaging)
    # on the domain B = 1 + (alpha-1) kappa tau > 0 use B itself as the time: then the powers combine
    B = sympy.Symbol("B", positive=True)
    if law.alpha == 1:
        A, rate = law.amplitude, diff(law.amplitude, tau)
    else:
        A = law.amplitude.subs(tau, (B - 1) / ((law.alpha - 1) * law.kappa))
        A = A.replace(lambda e: e.is_Add and B in e.free_symbols, simplify)
        rate = diff(A, B) * (law.alpha - 1) * law.kappa
    assert simplify(sympy.powdenest(rate + law.kappa * A**law.alpha, force=True)) == 0
    assert simplify(sympy.powdenest(rate + 2 * law.kappa * A**law.alpha, force=True)) != 0  # near miss
    assert law.amplitude.subs(tau, 0) == 1
    assert simplify(diff(law.time, amplitude_symbol) * law.kappa * amplitude_symbol**law.alpha) == -1


def test_phase_solves_its_equation_with_the_engines_frequency():
    law = averaged_law(alpha)
    frequency = omega_2().subs(engine_alpha, alpha)
    assert simplify(diff(law.phase, tau) - frequency * law.delta**2) == 0
    assert simplify(law.phase.subs(tau, 0)) == 0
    assert simplify(diff(law.delta, tau) + (alpha - 1) * law.p_1 * law.delta**2) == 0


def test_limits_at_one():
    law, linear = averaged_law(alpha), averaged_law(1)
    rate = sympy.Symbol("kappa", positive=True)
    near = (1 + (alpha - 1) * rate * tau) ** (-1 / (alpha - 1))
    assert limit(near, alpha, 1) == sympy.exp(-rate * tau)
    for numeric, exact in ((law.amplitude, linear.amplitude), (law.phase, linear.phase)):
        f = sympy.lambdify((alpha, epsilon, tau), numeric, "mpmath")
        with mp.workdps(50):
            at_one = exact.subs({epsilon: Rational(1, 10), tau: 30}).evalf(50)
            error = [abs(f(1 + mp.mpf(10) ** -n, mp.mpf("0.1"), 30) - at_one) for n in (8, 9)]
            assert 9.99 < error[0] / error[1] < 10.01  # first order in alpha - 1: the limit and nothing else


def test_table_1_of_lancaster():
    rows = {
        Integer(0): x_0 - 2 * b * t / (pi * m * OMEGA_0),
        Integer(1): x_0 * sympy.exp(-b * t / (2 * m)),
        Rational(3, 2): x_0
        * (1 + 3 * b * t * sqrt(2 * x_0 * OMEGA_0) * gamma(Rational(3, 4)) ** 2 / (5 * pi ** Rational(3, 2) * m)) ** -2,
        Integer(2): x_0 / (1 + 4 * b * OMEGA_0 * x_0 * t / (3 * pi * m)),
        Integer(3): x_0 / sqrt(1 + 3 * b * k * x_0**2 * t / (4 * m**2)),
    }
    values = {b: Rational(1, 7), k: 3, m: 2, x_0: Rational(1, 5), t: 11}
    for exponent, printed in rows.items():
        ours = averaged_law(exponent).physical_amplitude()
        if exponent != Rational(3, 2):  # Gamma(1/4) Gamma(3/4) = pi sqrt 2 joins the two forms; compared to 40 digits
            assert simplify(ours - printed) == 0
        assert abs((ours - printed).subs(values).evalf(40, maxn=200)) < sympy.Float("1e-38")
        assert abs((ours - printed.subs(b, 2 * b)).subs(values).evalf(20)) > 1e-4  # near miss


def test_lancaster_13_with_the_beta_function():
    beta = gamma(alpha / 2 + 1) ** 2 / gamma(alpha + 2)
    printed = 2 ** (alpha + 1) * beta / pi  # kappa over b omega_0^alpha x_0^(alpha-1)/k
    for exponent in (0, Rational(1, 2), Rational(5, 3), 4):
        ours = averaged_law(sympy.sympify(exponent)).p_1
        assert abs((printed.subs(alpha, exponent) - ours).evalf(30)) < 1e-28


def test_total_lag():
    assert averaged_law(3).total_lag == 15 * epsilon / 64
    law = averaged_law(ABOVE)
    assert simplify(limit(averaged_law(3).phase, tau, sympy.oo) + averaged_law(3).total_lag) == 0
    assert simplify(law.total_lag - law.w_2 * epsilon / ((ABOVE - 1) * law.p_1)) == 0
    with pytest.raises(InputError, match="alpha = 1"):
        assert averaged_law(1).total_lag


def test_extinction():
    assert averaged_law(0).extinction_time == pi / (2 * epsilon)
    assert averaged_law(0, SQUARING).extinction_time == sqrt(2) / epsilon
    assert averaged_law(1).extinction_time is None
    assert averaged_law(2).extinction_time is None
    half = averaged_law(Rational(1, 2))
    assert half.amplitude.subs(tau, half.extinction_time) == 0
    # the ratio of the extinction times is the closed ratio of the dampings, whatever epsilon
    for exponent in (Integer(0), Rational(1, 2), Rational(9, 10)):
        mean, lelas = (averaged_law(exponent, a).extinction_time for a in ("mean", "squaring"))
        assert simplify(mean / lelas - squaring_ratio(exponent)) == 0


def test_lelas_32_45_and_viscous():
    f0, f1, f2 = (averaged_law(n, SQUARING) for n in (0, 1, 2))
    mu, g, C = sympy.symbols("mu g C", positive=True)
    friction = f0.to_physical(f0.amplitude).subs(b, mu * m * g)
    assert simplify(friction - (1 - mu * g * t / (sqrt(2) * OMEGA_0 * x_0))) == 0
    assert simplify(f2.to_physical(f2.amplitude).subs(b, C) - 1 / (1 + C * OMEGA_0 * x_0 * t / (2 * sqrt(2) * m))) == 0
    assert simplify(f1.to_physical(f1.amplitude) - sympy.exp(-b * t / (2 * m))) == 0
    assert f1.amplitude == averaged_law(1).amplitude  # exact at alpha = 1 only
    assert simplify(f2.amplitude - averaged_law(2).amplitude) != 0
    assert f0.phase == 0


@pytest.mark.parametrize("exponent", [-1, Rational(-1, 3), sympy.I, sympy.Symbol("a")])
def test_bad_exponents(exponent):
    with pytest.raises(InputError, match="alpha"):
        averaged_law(exponent)


def test_bad_averaging():
    with pytest.raises(InputError, match="averaging"):
        averaged_law(1, "median")
