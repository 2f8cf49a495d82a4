"""A start in motion: the first turning point and those after it, by routes that know nothing of it."""

from fractions import Fraction

import pytest
import sympy
from flint import arb, ctx

from asymptotics.errors import InputError
from asymptotics.law import Law
from asymptotics.turning.choose import turning_points
from tests.second_route.local_expansion import Damping
from tests.second_route.orbit import orbit


@pytest.mark.parametrize(
    ("law", "x0", "v0"), [({"3/2": "1/10"}, 0, 1), ({"1/2": "1/10", 3: "1/20"}, 1, "-1/2"), ({2: 1}, "-1/3", "-3")]
)
def test_against_the_second_route(law, x0, v0):
    table = turning_points(Law(law), 3, 20, times=True, x0=x0, v0=v0)
    assert table.certified and table.first is not None and table.points[0].tau == "0"
    with ctx.workprec(150):
        other = Damping.of([(t.strength.ball(), t.velocity) for t in Law(law).terms])
        start = [arb(Fraction(s).numerator) / Fraction(s).denominator for s in (x0, v0)]
        turns = []
        for piece in orbit(other, *(s.mid() for s in start)):
            if piece.turning is not None:
                turns.append((piece.turning, piece.end))
            if len(turns) == 3:
                break
        (a, t), near = turns[0], arb(10) ** -19
        assert abs(arb(table.first["amplitude"]) - abs(a)) < near and abs(arb(table.first["tau"]) - t) < 2 * near
        for point, (X, tau) in zip(table.points, turns, strict=True):
            assert abs(arb(point.x) - X / abs(a)) < near and abs(arb(point.tau) - (tau - t)) < 10 * near


def test_linear_damping_after_a_kick():
    """x = e^(-t/10) sin(omega t)/omega: the first turning point by SymPy; critical damping turns once, or never."""
    t, omega = sympy.Symbol("t"), sympy.sqrt(sympy.Rational(99, 100))
    x = sympy.exp(-t / 10) * sympy.sin(omega * t) / omega
    first = sympy.atan(10 * omega) / omega
    table = turning_points(Law({1: "1/5"}), 2, 15, x0=0, v0=1)
    assert abs(sympy.Rational(table.first["tau"]) - first.n(30)) < 1e-13
    assert abs(sympy.Rational(table.first["amplitude"]) - x.subs(t, first).n(30)) < 1e-14
    once = turning_points(Law({1: 3}), 3, 10, v0=1)
    assert len(once.points) == 1 and once.ended == {"n": 0, "reason": "overdamped"}
    never = turning_points(Law({1: 3}), 3, 10, v0=-1)
    assert never.points == () and never.ended == {"n": -1, "reason": "overdamped"}


def test_dry_friction_decides_a_tie_exactly():
    """R = 0.6, a = 0.5, then 0.3 and 0.1, where the friction just holds."""
    table = turning_points(Law({0: "1/10"}), 9, 8, x0="0.46", v0="-0.48", times=True)
    assert [p.x for p in table.points] == ["-1.0000000", "0.60000000", "-0.20000000"]
    assert table.ended == {"n": 2, "reason": "sticks"} and table.first["amplitude"] == "0.50000000"
    assert table.alpha == "0" and table.epsilon == "1/10"  # in the units given, not in those of a


@pytest.mark.parametrize("digits", [4, 33])
def test_the_first_turning_point_beside_a_spring_has_the_digits_asked_for(digits):
    """X'' + X + X^3 = 0 with X' = 1 at X = 0 turns where X^2 + X^4/2 = 1."""
    law = Law({1: 0}, spring={3: 1})
    first = turning_points(law, 1, digits, x0=0, v0=1).first
    amplitude = sympy.sqrt(sympy.sqrt(3) - 1)
    assert sympy.Rational(first["amplitude"]) == sympy.Rational(str(amplitude.n(digits)))
    assert len(first["amplitude"]) == 2 + digits and len(first["tau"]) == 1 + digits


def test_from_rest_the_unit_is_the_start():
    with pytest.raises(InputError, match="x0"):
        turning_points(Law({2: 1}), 2, 10, x0=2)
