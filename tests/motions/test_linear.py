"""Linear damping: its regimes, and the motion against SymPy."""

import sympy

from asymptotics.law import Law, Oscillator
from asymptotics.motions.linear import linear_motion, regime


def oscillator(alpha, b, **rest):
    return Oscillator(Law({alpha: b}), **rest)


def test_linear_regimes_are_decided_exactly():
    assert [regime(oscillator("1", b, stiffness="1/4")) for b in ("0.999999999999999999999", "1", "1.01")] == [
        "underdamped", "critically damped", "overdamped",
    ]  # fmt: skip
    assert regime(oscillator("1", "sqrt(2)", mass="sqrt(1/2)", stiffness="sqrt(1/2)")).startswith("critically")
    assert [linear_motion(oscillator("1", b), "1", 5).notes for b in ("3", "0")] == [("overdamped",), ()]


def test_linear_motion_against_sympy():
    """x'' + 3 x' + x = 0 (overdamped), x(0) = 1, v(0) = 2, by dsolve."""
    t = sympy.Symbol("t")
    f = sympy.Function("f")
    solution = sympy.dsolve(f(t).diff(t, 2) + 3 * f(t).diff(t) + f(t), ics={f(0): 1, f(t).diff(t).subs(t, 0): 2}).rhs
    point = linear_motion(oscillator("1", "3", v0="2"), "3/2", 20)
    half = sympy.Rational(3, 2)
    assert abs(sympy.Rational(point.x) - solution.subs(t, half).n(40)) < sympy.Rational(1, 10**19)
    assert abs(sympy.Rational(point.v) - solution.diff(t).subs(t, half).n(40)) < sympy.Rational(1, 10**19)
