"""The parts on which a proved tail rests, each alone: the majorant, the order, the reach, the integrals of I_4."""

import mpmath
import pytest
from flint import arb, ctx

from asymptotics.errors import LimitError
from asymptotics.half_swings.finite import MAX_ORDER, _order, _polydisc, finite_quarter, series_reach
from asymptotics.half_swings.finite_majorant import _Step, majorant, widest
from asymptotics.half_swings.forces import Forces
from asymptotics.half_swings.symbolic import (
    RADIUS,
    _integrate,
    alpha,
    field_half_swing,
    nested_integral_definition,
    nested_integral_exact,
)
from asymptotics.numbers.exact import parse_real


def real(text):
    return parse_real(text, "alpha")


@pytest.mark.parametrize("factor", ["1.001", "1.5", "1.99", "5"])
def test_outside_the_polydisc_no_order_is_enough(factor):
    (radius,) = widest([arb(2)], [arb(1)]).radii
    with pytest.raises(LimitError, match="out of reach"):
        finite_quarter([real("2")], [radius * arb(factor)], 30)


@pytest.mark.parametrize("exponent", ["0", "3/2", "3"])
def test_the_reach_of_an_order_is_what_that_order_reaches(exponent):
    disc = _polydisc((real(exponent),), (1.0,))
    for order, bits in ((MAX_ORDER[1], 40), (12, 10)):
        reach = series_reach(real(exponent), bits, order)
        assert _order(disc, [reach], bits) <= order < _order(disc, [reach * arb("1.5")], bits)


@pytest.mark.parametrize("exponent", ["0", "2", "3"])
def test_the_final_strength_and_its_inverse_are_bounded_and_nearly_attained(exponent):
    """u = delta e^((alpha - 1) R) at the passage; its size and that of 1/u are largest at delta = -rho and rho."""
    with ctx.workprec(100):
        a = real(exponent).ball()
        rho = widest([a], [arb(1)]).radii[0] / 5
        bound, quarter = majorant([a], [rho]), finite_quarter([real(exponent)], [rho], 60)
        ends = [abs(d * ((a - 1) * quarter._R([d])).exp()) for d in (rho, -rho)]
        largest, smallest = max(ends, key=float), min(ends, key=float)
        assert largest < bound.final(0) < largest * arb("1.3")
        assert 1 / smallest < bound.inverse() < 1 / smallest * arb("1.3")
        inside = (bound.inverse() - 1 / rho) / 2 + 1 / rho  # with half the gain it would be no bound
        assert not 1 / smallest < inside


def test_an_end_that_was_not_proved_is_refused(monkeypatch):
    step = _Step(arb("0.1"), [arb("0.5")], [arb(1)], [arb(1)], [arb("0.5")])
    found = step.upper_end(arb(0))
    assert found is not None
    for share in (0.9, 0.99, 0.999):
        monkeypatch.setattr(_Step, "_candidate", lambda self, start, share=share: float(found) * share)
        assert step.upper_end(arb(0)) is None
    monkeypatch.setattr(_Step, "_candidate", lambda self, start: float(found) * 1.01)
    assert step.upper_end(arb(0)) is not None


@pytest.mark.parametrize("terms", [1, 2, 5])
def test_the_tail_of_an_integral_is_needed(terms):
    """y_j = R^(-2 j) attains Cauchy's bound with B = 1; for a large power of theta the bound is nearly attained."""
    y, e = [arb(RADIUS) ** (-2 * j) for j in range(400)], arb(60)
    with ctx.workprec(200):
        value, found = _integrate(y, e, arb(1)), _integrate(y[:terms], e, arb(1))
        assert found.contains(value.mid())
        assert not (found.mid() + arb(0, found.rad() / 2)).overlaps(value)
        assert _integrate(y[:terms], e, arb(2)).rad() > found.rad() * arb("1.99")


@pytest.mark.parametrize("n", [1])
def test_the_integral_that_defines_i_4_is_i_4(n):
    shown = nested_integral_definition().subs(alpha, n).doit()
    with mpmath.workdps(20):
        assert (
            abs(mpmath.mpmathify(shown.evalf(20)) - mpmath.mpf(nested_integral_exact(n).ball().str(20, radius=False)))
            < 1e-15
        )


def test_the_symbolic_half_swing_is_what_it_was_computed_to_be():
    cached, anew = field_half_swing(), field_half_swing.__wrapped__()
    assert [cached.T[k] for k in range(5)] == [anew.T[k] for k in range(5)]
    assert [cached.L[k] for k in range(5)] == [anew.L[k] for k in range(5)]


def test_some_variables_by_themselves_are_the_forces_that_they_make():
    both = Forces.read((real("1"), real("5/2")), 4)
    for place, text in enumerate(("1", "5/2")):
        alone, here = Forces.read((real(text),), 4), both.only([place], 4)
        assert here.members == alone.members != ()
        assert (here.weights, here.signs, here.velocities) == (alone.weights, alone.signs, alone.velocities)
