"""The exact motions: initial values, equation of motion, sticking, regimes."""

from fractions import Fraction
from types import SimpleNamespace

import pytest
import sympy
from flint import arb

from asymptotics.api.motions import Reference
from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.law import Law, Oscillator
from asymptotics.motions import coulomb, quadratic
from asymptotics.motions.certify import certified_values, half_unit
from asymptotics.motions.coulomb import coulomb_motion, coulomb_stop
from asymptotics.motions.linear import linear_motion, regime
from asymptotics.motions.quadratic import quadratic_motion
from asymptotics.motions.reference import reference_states
from asymptotics.numbers.exact import ExactReal
from asymptotics.turning.choose import turning_points


def oscillator(alpha, b, **rest):
    return Oscillator(Law({alpha: b}), **rest)


MOTIONS = [("0", coulomb_motion), ("1", linear_motion), ("2", quadratic_motion)]


@pytest.mark.parametrize(("alpha", "motion"), MOTIONS)
def test_equation_of_motion_by_fourth_order_differences(alpha, motion):
    """m x'' + k x + b v|v|^(alpha-1) = 0 with x'' and x' from five points, h = 1e-6: errors below 1e-22."""
    system = oscillator(alpha, "1/3", mass="2", stiffness="3", x0="1")
    h = Fraction(1, 10**6)
    x = [Fraction(motion(system, Fraction(1) + n * h, 60).x) for n in (-2, -1, 0, 1, 2)]
    acceleration = (-x[0] + 16 * x[1] - 30 * x[2] + 16 * x[3] - x[4]) / (12 * h * h)
    velocity = (x[0] - 8 * x[1] + 8 * x[3] - x[4]) / (12 * h)
    v = Fraction(motion(system, 1, 60).v)
    assert abs(v - velocity) < Fraction(1, 10**20) and v < 0
    residual = 2 * acceleration + 3 * x[2] - Fraction(1, 3) * abs(v) ** int(alpha)
    assert abs(residual) < Fraction(1, 10**20)
    assert abs(residual + Fraction(1, 100) * abs(v) ** int(alpha)) > Fraction(1, 10**3)  # a near miss of b


@pytest.mark.parametrize(("alpha", "motion"), MOTIONS)
def test_the_start_and_fewer_digits(alpha, motion):
    system = oscillator(alpha, "1/3", x0="-3/7")
    start = motion(system, 0, 12)
    assert (start.x, start.v) == ("-0.428571428571", "0")
    few, many = (motion(system, "5/2", digits) for digits in (10, 40))
    assert abs(Fraction(few.x) - Fraction(many.x)) <= Fraction(few.error)
    assert few.certified and few.gauge is None
    with pytest.raises(InputError, match="time"):
        motion(system, "-1", 10)
    with pytest.raises(InputError, match="law"):
        motion(oscillator("3/2", "1"), "1", 10)


def test_mirror_symmetry():
    for alpha, motion in MOTIONS:
        plus, minus = (motion(oscillator(alpha, "1/3", x0=x), "7/2", 15) for x in ("1", "-1"))
        assert Fraction(plus.x) == -Fraction(minus.x) and Fraction(plus.v) == -Fraction(minus.v)


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


def test_dry_friction_stops_where_the_turning_points_say():
    system = oscillator("0", "1/10", x0="1")
    stop = coulomb_stop(system, 12)
    table = turning_points(Law({"0": "1/10"}), 99, 12, times=True)
    assert stop.half_swings == table.ended["n"] == 5 and (stop.x, stop.t) == (table.points[-1].x, table.points[-1].tau)
    late = coulomb_motion(system, "1000", 12)
    assert (late.x, late.v) == (stop.x, "0")


def test_a_tie_is_decided_exactly_for_rationals():
    """c = 1/5: 1, -3/5, 1/5 = c: it sticks there; with a slightly smaller c it makes another half-swing."""
    assert coulomb_stop(oscillator("0", "1/5"), 5).half_swings == 2
    assert coulomb_stop(oscillator("0", "0.19999999999999999999"), 5).half_swings == 3
    assert coulomb_stop(oscillator("0", "2", x0="1"), 5).half_swings == 0
    assert coulomb_motion(oscillator("0", "2", x0="1"), "3", 5).x == "1.0000"


def test_static_friction_holds_earlier():
    system = oscillator("0", "1/10")
    assert coulomb_stop(system, 6, static="2/5").x == "-0.400000"  # 1, -4/5, 3/5, -2/5
    assert coulomb_stop(system, 6, static="0.39").half_swings == 4
    with pytest.raises(InputError, match="static"):
        coulomb_stop(system, 6, static="1/20")


@pytest.mark.parametrize("law", [{0: "1/10", 2: 0}, {2: 0, 0: "1/10"}])
def test_dry_friction_beside_a_law_of_strength_0_is_dry_friction_alone(law):
    """At one time, as a table, with its events and with a static force, whichever term stands first."""
    for static in (None, "2/5"):
        alone, beside = (Reference(Oscillator(one), static) for one in ({0: "1/10"}, law))
        assert beside.at(8).x == alone.at(8).x
        assert beside.sample([1, 8, 30]).x.tolist() == alone.sample([1, 8, 30]).x.tolist()
    assert Reference(Oscillator(law)).events(30).stop == pytest.approx(float(5 * sympy.pi), rel=1e-12)
    free = Reference(Oscillator({0: "1/10"}, spring={3: 0}))  # a spring, though it does nothing: by the flow
    assert free.sample([7]).x[0] == pytest.approx(float(free.at(7).x), rel=1e-13)


def test_a_kicked_mass_under_dry_friction():
    """x0 = 0, v0 = 1, c = 1/10: R^2 = c^2 + 1 and the first turning point is R - c."""
    system = oscillator("0", "1/10", x0="0", v0="1")
    turn = (sympy.sqrt(sympy.Rational(101, 100)) - sympy.Rational(1, 10)).n(30)
    stop = coulomb_stop(system, 15)
    assert stop.half_swings == 6  # r = 0.905, 0.705, 0.505, 0.305, 0.105 > 0.1, -0.095
    assert abs(sympy.Rational(stop.x) + (turn - 1)) < 1e-14


@pytest.mark.parametrize("time", ["200", "646.073", "3000"])
def test_quadratic_motion_after_many_half_swings(time):
    # the time left over for the last half-swing is less certain than the working precision, at every precision
    system = oscillator("2", "9/500", x0="-9/10")
    states = reference_states(Oscillator(Law({"2": "9/500"}), x0="-9/10", v0="1e-30"), [ExactReal(Fraction(time))], 14)
    assert abs(states.x[0] - float(quadratic_motion(system, time, 14).x)) < 1e-13


def test_quadratic_motion_passes_the_turning_points():
    table = turning_points(Law({"2": "1"}), 3, 10, times=True)
    for point in table.points[1:]:
        near = quadratic_motion(oscillator("2", "1"), Fraction(point.tau), 6)
        assert abs(Fraction(near.x) - Fraction(point.x)) < Fraction(1, 10**6)
        assert abs(Fraction(near.v)) < Fraction(1, 10**9)
    with pytest.raises(LimitError, match="time"):
        quadratic_motion(oscillator("2", "1"), "1e6", 12)
    with pytest.raises(InputError, match="v0"):
        quadratic_motion(oscillator("2", "1", v0="1"), "1", 12)


def test_an_undecidable_value_is_said_to_be_so():
    def tie():
        raise UndecidedError("a tie")

    with pytest.raises(UndecidedError, match="a tie"):
        certified_values(tie, 5)
    assert half_unit("-123.4", 4) == "0.050"


def test_the_place_on_a_half_swing_is_enclosed_or_undecided(monkeypatch):
    """Where time goes by slowly a tolerance of 16 radii is just wide enough for 10 of them, not for 100 on any side."""
    time = arb(1, "1e-6")
    monkeypatch.setattr(quadratic, "_slope", lambda *_: arb(1) / 10)
    monkeypatch.setattr(quadratic, "elapsed", lambda _p, _q, chi: 1 + (chi - 2) / 10)
    found = quadratic._angle(arb(1), arb(1), time)
    assert found.contains(2 - arb("9.9e-6")) and found.contains(2 + arb("9.9e-6")) and found.rad() < 1e-4
    for sides in ((10, 100), (100, 10)):
        monkeypatch.setattr(
            quadratic, "elapsed", lambda _p, _q, chi, sides=sides: 1 + (chi - 2) / sides[0 if chi < 2 else 1]
        )
        with pytest.raises(UndecidedError, match="not enclosed"):
            quadratic._angle(arb(1), arb(1), time)


def test_a_time_that_may_be_on_two_half_swings_is_undecided(monkeypatch):
    monkeypatch.setattr(quadratic, "duration", lambda *_: arb(3, "0.1"))
    with pytest.raises(UndecidedError, match="half-swing of this time"):
        quadratic._place(oscillator("2", "1/10"), arb(3))


def test_a_time_that_may_be_before_the_stop_is_undecided(monkeypatch):
    course = SimpleNamespace(stop=lambda: (arb(1), arb(7, "0.1")), place=lambda _: (arb(0), arb(0)))
    monkeypatch.setattr(coulomb, "_course", lambda *_: course)
    with pytest.raises(UndecidedError):
        coulomb_motion(oscillator("0", "1/10"), 7)
