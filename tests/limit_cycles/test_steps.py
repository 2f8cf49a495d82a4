"""One Taylor step of the half-turn: its remainder is needed."""

import pytest
from flint import arb, ctx

from asymptotics.law import Law
from asymptotics.limit_cycles.certified import _Field, _interval_newton, _picard_box, _step, certified_limit_cycle
from asymptotics.numbers.exact import parse_real
from asymptotics.terms import Term

VAN_DER_POL = (Term(-1, 1), Term(1, 1, 2))


@pytest.mark.parametrize("degree", [3, 5, 8])
def test_the_remainder_of_a_step_is_needed(degree):
    """With few terms the state after the step is held, and not without the remainder."""
    with ctx.workprec(120):
        field, z, eta = _Field(VAN_DER_POL, arb(1)), (arb("1.5"), arb("-0.75"), arb(0)), arb(1) / 32
        box = _picard_box(field, z, eta)
        assert box is not None
        found = _step(field, z, box, eta, degree)
        truth = _step(field, z, box, eta, 40)
        bare = [p(eta) for p in field.taylor(z, degree - 1)]
        for whole, fine, polynomial in zip(found, truth, bare, strict=True):
            assert whole.contains(fine) and not polynomial.contains(fine)


def test_a_newton_method_that_runs_out_claims_nothing(monkeypatch):
    """After one step from afar the half-turn is that of the place before."""
    with ctx.workprec(80):
        assert _interval_newton(VAN_DER_POL, arb(1), arb("2.1"), 50) is not None
        monkeypatch.setattr("asymptotics.limit_cycles.certified._NEWTON", 1)
        assert _interval_newton(VAN_DER_POL, arb(1), arb("2.1"), 50) is None


@pytest.mark.parametrize("mu", ["1", "1e-7", "1/3"])
def test_a_cycle_that_repels_is_followed_back_in_time(mu):
    """t -> -t and mu -> -mu: the same cycle, the multiplier inverted; and for small mu it is 1 - 2 pi mu + ..."""
    law, size = Law({1: -1, (1, 2): 1}), parse_real(mu, "mu")
    there, back = (certified_limit_cycle(law, m, 12, 2.0) for m in (size, -size))
    assert (there.amplitude, there.period) == (back.amplitude, back.period)
    assert there.stable and back.stable is False
    assert abs(float(there.multiplier) * float(back.multiplier) - 1) < 1e-10
    assert mu != "1e-7" or abs((1 - float(there.multiplier)) / 1e-7 - 6.283185) < 1e-5


@pytest.mark.slow
def test_a_relaxation_oscillation():
    """mu = 5: amplitude and period as a stiff integrator has them."""
    found = certified_limit_cycle(Law({1: -1, (1, 2): 1}), parse_real("5", "mu"), 10, 2.0)
    assert (found.amplitude[:8], found.period[:8]) == ("2.021508", "11.61223")
