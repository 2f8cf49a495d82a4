"""Footnote 22 of Lancaster: both forms differentiated and integrated, where each breaks, the elementary form."""

from itertools import product

import mpmath
import pytest
import sympy
from mpmath import mp
from sympy import Rational, S, simplify, symbols

from asymptotics.envelopes.hypergeometric import (
    breaks_companion,
    breaks_printed,
    companion_antiderivative,
    elementary_F,
    elementary_time,
    extinction_time,
    long_time_amplitude,
    printed_antiderivative,
    time_of_amplitude,
    two_law_time,
)
from asymptotics.envelopes.symbolic import amplitude_symbol
from asymptotics.errors import InputError

GRID = sorted({Rational(p, q) for q in (1, 2, 3, 4) for p in range(4 * q + 1)})
PAIRS = [(a, b) for a, b in product(GRID, GRID) if a < b]
SAMPLES = [
    tuple(map(Rational, pair.split()))
    for pair in ("0 1", "0 2", "0 3", "0 1/2", "0 2/3", "1 2", "1 3", "2 3", "2 5", "3/2 2", "1/3 7/5", "5/4 3")
]
KAPPAS = (Rational(1, 10), Rational(1, 4))


def quadrature(low, high, A):
    (a, c), (b, d) = [(mp.mpf(e.p) / e.q, mp.mpf(k.p) / k.q) for e, k in (low, high)]
    return mpmath.quad(lambda x: 1 / (c * x**a + d * x**b), [A, (1 + A) / 2, 1])


@pytest.mark.parametrize("pair", SAMPLES)
def test_three_routes(pair):
    low, high = zip(pair, KAPPAS)
    with mp.workdps(30):
        for A in (Rational(9, 10), Rational(1, 7)):
            want = quadrature(low, high, mp.mpf(A.p) / A.q)
            for form in (two_law_time, elementary_time):
                got = mp.mpf(str(form(low, high, A).evalf(28)))
                assert abs(got - want) < 1e-22 * want
            assert abs(want / quadrature((low[0], low[1] + Rational(1, 10**6)), high, mp.mpf(A.p) / A.q) - 1) > 1e-8


@pytest.mark.parametrize("form", [printed_antiderivative, companion_antiderivative])
def test_where_defined_each_form_is_an_antiderivative(form):
    """For a sample of all pairs of the grid: the derivative by the identity z F' = a (1/(1-z) - F), exactly."""
    x, c, d, F = symbols("x c d F", positive=True)
    breaks = breaks_printed if form is printed_antiderivative else breaks_companion
    for a, b in PAIRS[::13]:
        if breaks(a, b):
            with pytest.raises(InputError, match="breaks down"):
                form((a, c), (b, d), x)
            continue
        expression = form((a, c), (b, d), x)
        (hyper,) = expression.atoms(sympy.hyper)
        z = hyper.argument
        index = next(p for p in hyper.ap if p + 1 == hyper.bq[0])
        factor = expression.subs(hyper, 1)
        slope = index * (1 / (1 - z) - F) / z
        derivative = sympy.diff(factor, x) * F + factor * slope * sympy.diff(z, x)
        assert simplify(derivative - 1 / (c * x**a + d * x**b)) == 0


@pytest.mark.parametrize("alpha", ["0", "1/2", "1", "sqrt(2)", "3"])
def test_one_law_by_its_equation(alpha):
    exponent, (k,) = sympy.sympify(alpha), symbols("k,", positive=True)
    A, time = amplitude_symbol, time_of_amplitude({exponent: k})
    assert simplify(sympy.diff(time, A) + 1 / (k * A**exponent)) == 0 and time.subs(A, 1) == 0
    assert time_of_amplitude({S(0): k, S(1): k, exponent + 2: k}) is None


def test_where_the_forms_break_down():
    for a, b in PAIRS:
        printed, companion = breaks_printed(a, b), breaks_companion(a, b)
        assert not (printed and companion)
        steps = [k for k in range(50) if b == 1 - k * (b - a)]
        assert printed == bool(steps)
        assert companion == bool([k for k in range(50) if a == 1 + k * (b - a)])
        if printed:
            assert b <= 1
        if companion:
            assert a >= 1
        if breaks_printed(a, b):  # the lower parameter a+1 of 2F1 is then a nonpositive integer, or alpha' = 1
            assert b == 1 or ((1 + a - 2 * b) / (a - b)).is_nonpositive
    assert [breaks_printed(S(0), b) for b in (S(1), Rational(1, 2), Rational(1, 3))] == [True] * 3
    assert [breaks_companion(S(a), S(b)) for a, b in ((1, 2), (1, 3), (2, 3))] == [True] * 3
    assert not breaks_printed(S(0), Rational(2, 3))
    assert not breaks_companion(S(2), S(4))


def test_the_printed_form_is_singular_at_its_exceptions():
    low, high = (S(0), S(1)), (Rational(1, 2) + Rational(1, 10**8), S(1))
    assert abs(printed_antiderivative(low, high, S(1)).evalf(20)) > 1e6  # next to (0, 1/2) it has a pole
    assert abs(companion_antiderivative(low, high, S(1)).evalf(20)) < 2


def test_elementary_F_and_its_shape():
    with mp.workdps(30):
        for a in map(Rational, ("1", "3", "1/2", "5/2", "1/3", "7/3", "3/4", "8/5")):
            for w in (Rational(1, 3), S(1), S(40)):
                want = mpmath.hyp2f1(1, mp.mpf(a.p) / a.q, mp.mpf(a.p) / a.q + 1, -mp.mpf(w.p) / w.q)
                assert abs(mp.mpf(str(elementary_F(a, w).evalf(28))) - want) < 1e-22
    w = symbols("w", positive=True)
    assert not elementary_F(S(4), w).has(sympy.atan, sympy.atan2)
    assert elementary_F(Rational(5, 2), w).has(sympy.atan)
    with pytest.raises(InputError):
        elementary_F(sympy.sqrt(2), w)


def test_elementary_pairs_are_short():
    k, kp = symbols("kappa kappa_p", positive=True)
    A = amplitude_symbol
    expected = {
        (0, 1): sympy.log((k + kp) / (k + kp * A)) / kp,
        (0, 2): (sympy.atan(sympy.sqrt(kp / k)) - sympy.atan(A * sympy.sqrt(kp / k))) / sympy.sqrt(k * kp),
        (1, 2): sympy.log((k + kp * A) / (A * (k + kp))) / k,
        (1, 3): sympy.log((k + kp * A**2) / (A**2 * (k + kp))) / (2 * k),
        (2, 3): (1 / A - 1) / k - kp / k**2 * sympy.log((k + kp * A) / (A * (k + kp))),
    }
    for (a, b), want in expected.items():
        got = elementary_time((S(a), k), (S(b), kp))
        assert simplify(sympy.expand_log(got - want, force=True)) == 0
        assert simplify(sympy.diff(want, A) + 1 / (k * A**a + kp * A**b)) == 0
        assert want.subs(A, 1) == 0


def test_extinction():
    low, high = (S(0), KAPPAS[0]), (S(3), KAPPAS[1])
    with mp.workdps(25):
        want = mpmath.quad(lambda x: 1 / (0.1 + mp.mpf(1) / 4 * x**3), [0, 1])
        assert abs(extinction_time(low, high).evalf(20) - sympy.Float(str(want), 20)) < 1e-13
    assert abs(elementary_time(low, high, S(0)).evalf(20) - extinction_time(low, high).evalf(20)) < 1e-18
    assert elementary_time((S.One, S(2)), (S(2), S(3)), S.Zero) is S.Infinity  # A vanishes only in the limit
    assert elementary_time((S.Zero, S(2)), (S(2), S(3)), S.Zero).is_finite
    assert extinction_time((S(1), S(1)), (S(2), S(1))) is None


LATE = [((1, 2), 300), ((1, 3), 300), ((2, 3), 10**9), ((2, 5), 10**9), ((0, 2), None), (("1/2", 2), None)]


@pytest.mark.parametrize(("pair", "late"), LATE)
def test_long_time_limits(pair, late):
    low, high = zip(map(S, pair), KAPPAS)
    end = extinction_time(low, high)
    t = sympy.Integer(late) if late else (end * (1 - Rational(1, 10**6))).evalf(40)
    claimed = long_time_amplitude(low, high, t).evalf(40)
    reached = elementary_time(low, high, claimed).evalf(40)
    scale = 1 if pair[0] == 1 else t if late else end.evalf(40) - t
    assert abs(reached - t) < 1e-3 * scale
    wrong = elementary_time(low, high, claimed * Rational(101, 100)).evalf(40)
    assert abs(wrong - t) > 4e-3 * scale  # near miss: one per cent


def test_lancaster_22():
    b, bp, m, w, x_0, t = symbols("b bp m omega_0 x_0 t", positive=True)
    # tau = omega_0 t, kappa = b/(2 m omega_0), kappa' = 4 b' x_0/(3 pi m)
    ours = long_time_amplitude((S(1), b / (2 * m * w)), (S(2), 4 * bp * x_0 / (3 * sympy.pi * m)), w * t)
    printed = 1 / (1 + 8 * bp * w * x_0 / (3 * b * sympy.pi)) * sympy.exp(-b * t / (2 * m))
    assert simplify(ours - printed) == 0
    assert simplify(ours - printed.subs(bp, 2 * bp)) != 0


def test_refusals():
    with pytest.raises(InputError, match="not in order"):
        two_law_time((S(2), S(1)), (S(1), S(1)))
    with pytest.raises(InputError, match="rational"):
        elementary_time((S(0), S(1)), (sympy.sqrt(2), S(1)))
