"""Dry friction: where it stops, ties, a static friction, a start in motion."""

from types import SimpleNamespace

import pytest
import sympy
from flint import arb

from asymptotics.curves.motions import reference
from asymptotics.errors import InputError, UndecidedError
from asymptotics.law import Law, Oscillator
from asymptotics.motions import coulomb
from asymptotics.motions.coulomb import coulomb_motion, coulomb_stop
from asymptotics.turning.choose import turning_points


def oscillator(alpha, b, **rest):
    return Oscillator(Law({alpha: b}), **rest)


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


def test_a_kicked_mass_under_dry_friction():
    """x0 = 0, v0 = 1, c = 1/10: R^2 = c^2 + 1 and the first turning point is R - c."""
    system = oscillator("0", "1/10", x0="0", v0="1")
    turn = (sympy.sqrt(sympy.Rational(101, 100)) - sympy.Rational(1, 10)).n(30)
    stop = coulomb_stop(system, 15)
    assert stop.half_swings == 6  # r = 0.905, 0.705, 0.505, 0.305, 0.105 > 0.1, -0.095
    assert abs(sympy.Rational(stop.x) + (turn - 1)) < 1e-14


def test_a_time_that_may_be_before_the_stop_is_undecided(monkeypatch):
    motion = SimpleNamespace(stop=lambda: (arb(1), arb(7, "0.1")), place=lambda _: (arb(0), arb(0)))
    monkeypatch.setattr(coulomb, "_dry_motion", lambda *_: motion)
    with pytest.raises(UndecidedError):
        coulomb_motion(oscillator("0", "1/10"), 7)


@pytest.mark.parametrize("law", [{0: "1/10", 2: 0}, {2: 0, 0: "1/10"}])
def test_dry_friction_beside_a_law_of_strength_0_is_dry_friction_alone(law):
    """At one time, as a table, with its events and with a static force, whichever term stands first."""
    for static in (None, "2/5"):
        alone, beside = (reference(Oscillator(one), static=static) for one in ({0: "1/10"}, law))
        assert beside.at(8).x == alone.at(8).x
        assert beside.sample([1, 8, 30]).x.tolist() == alone.sample([1, 8, 30]).x.tolist()
    assert reference(Oscillator(law)).events(30).stop == pytest.approx(float(5 * sympy.pi), rel=1e-12)
    free = reference(Oscillator({0: "1/10"}, spring={3: 0}))  # a spring, though it does nothing: by the flow
    assert free.sample([7]).x[0] == pytest.approx(float(free.at(7).x), rel=1e-13)
