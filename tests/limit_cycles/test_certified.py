"""Certified cycles: an integrator, what Newton's method may claim, cycles that repel, and that relax."""

from fractions import Fraction

import numpy as np
import pytest
from flint import arb, ctx
from scipy.integrate import solve_ivp

from asymptotics.errors import InputError
from asymptotics.law import Law
from asymptotics.limit_cycles.certified import MAX_MU, _interval_newton, certified_limit_cycle
from asymptotics.limit_cycles.series import limit_cycle_series
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.terms import Term

VAN_DER_POL = (Term(-1, 1), Term(1, 1, 2))
VAN_DER_POL_LAW, RAYLEIGH = Law({1: -1, (1, 2): 1}), Law({1: -1, 3: 1})


def test_a_newton_method_that_runs_out_claims_nothing(monkeypatch):
    """After one step from afar the half-turn is that of the place before."""
    with ctx.workprec(80):
        assert _interval_newton(VAN_DER_POL, arb(1), arb("2.1"), 50) is not None
        monkeypatch.setattr("asymptotics.limit_cycles.certified._NEWTON", 1)
        assert _interval_newton(VAN_DER_POL, arb(1), arb("2.1"), 50) is None


@pytest.mark.parametrize("mu", ["1", "1e-7", "1/3", "3"])
def test_a_cycle_that_repels_is_followed_back_in_time(mu):
    """t -> -t and mu -> -mu: the same cycle, the multiplier inverted; and for small mu it is 1 - 2 pi mu + ..."""
    law, size = Law({1: -1, (1, 2): 1}), parse_real(mu, "mu")
    there, back = (certified_limit_cycle(law, m, 12, 2.0) for m in (size, -size))
    assert (there.amplitude, there.period) == (back.amplitude, back.period)
    assert there.stable and back.stable is False
    assert abs(float(there.multiplier) * float(back.multiplier) - 1) < 1e-10
    assert mu != "1e-7" or abs((1 - float(there.multiplier)) / 1e-7 - 6.283185) < 1e-5


@pytest.mark.parametrize("mu", ["5", "10"])
def test_a_relaxation_oscillation(mu):
    """Amplitude and period as a stiff integrator has them, and twelve digits among twenty-four."""
    law, m = Law({1: -1, (1, 2): 1}), float(mu)
    found, fine = (certified_limit_cycle(law, parse_real(mu, "mu"), digits, 2.0) for digits in (12, 24))
    run = solve_ivp(lambda _, y: [y[1], -y[0] - m * (y[0] ** 2 - 1) * y[1]], (0, float(found.period)),
                    [float(found.amplitude), 0], "LSODA", rtol=1e-10, atol=1e-12)  # fmt: skip
    assert run.y[0, -1] == pytest.approx(float(found.amplitude), abs=1e-7)
    assert abs(run.y[1, -1]) < 1e-6
    for name in ("amplitude", "period", "frequency"):
        assert abs(float(getattr(found, name)) - float(getattr(fine, name))) < 1e-10
    assert found.stable


def test_beyond_the_largest_mu_the_refusal_says_what_is_accepted():
    with pytest.raises(InputError, match=f"to {MAX_MU} in size"):
        certified_limit_cycle(Law({1: -1, (1, 2): 1}), parse_real("20.5", "mu"), 12, 2.0)


@pytest.mark.parametrize("mu", ["1e-308", "-1e-400"])
def test_a_mu_whose_multiplier_is_one_to_a_hundred_digits_is_refused(mu):
    with pytest.raises(InputError, match="from 1e-100 to 20"):
        certified_limit_cycle(Law({1: -1, (1, 2): 1}), parse_real(mu, "mu"), 12, 2.0)


def test_a_newton_step_without_an_end_claims_nothing():
    with ctx.workprec(80):
        assert _interval_newton(VAN_DER_POL, arb("1e-60"), arb("2.02"), 50) is None


def test_certified_cycle_against_an_integrator_and_the_series():
    found = certified_limit_cycle(VAN_DER_POL_LAW, ExactReal(Fraction(1, 2)), 15, 2.0)
    run = solve_ivp(
        lambda t, y: [y[1], -y[0] - 0.5 * (y[0] ** 2 - 1) * y[1], 0.5 * (y[0] ** 2 - 1)],
        (0, float(found.period)), [float(found.amplitude), 0, 0], rtol=1e-12, atol=1e-13,
    )  # fmt: skip
    assert run.y[0, -1] == pytest.approx(float(found.amplitude), abs=1e-9)
    assert np.exp(-run.y[2, -1]) == pytest.approx(float(found.multiplier), rel=1e-8)
    series = limit_cycle_series(VAN_DER_POL_LAW, 24)
    value = sum(2 * float(int(c.p) / int(c.q)) * 0.5**k for k, c in series.amplitude.items())
    assert value == pytest.approx(float(found.amplitude), abs=1e-12)
    assert found.stable is True
    assert certified_limit_cycle(VAN_DER_POL_LAW, ExactReal(Fraction(-1, 2)), 10, 2.0).stable is False
