"""The truncated slow equations: closed forms, inversion, extinction, loss of sign."""

import numpy as np
import pytest
from flint import acb, arb, ctx

from asymptotics.envelopes.slow_flow import ExponentialSum, SlowLaw
from asymptotics.errors import InputError


def law(*terms, phase=()):
    return SlowLaw(*(ExponentialSum(tuple((arb(c), arb(a)) for c, a in part)) for part in (terms, phase)))


@pytest.mark.parametrize("a", [-1.0, -0.5, 0.5, 1.0, 3.0])
def test_one_power_in_closed_form(a):
    """ds/dtau = k e^(-a s), Omega = w e^(-2 a s): e^(a s) = 1 + a k tau and phi = w (1 - e^(-a s))/(a k)."""
    k, w, tau = 0.25, -0.125, 1.5
    slow = law((k, a), phase=((w, 2 * a),))
    with ctx.workprec(150):
        s, phi = slow.solve(arb(tau), arb(0))
        exact = (1 + arb(a) * k * tau).log() / a
        assert abs(s - exact) < arb(10) ** -40
        assert abs(phi - w * (1 - (-a * exact).exp()) / (arb(a) * k)) < arb(10) ** -40
    found = slow.table(0.0, 2.0).at(np.array([0.0, tau]))
    assert found[0] == pytest.approx([0, float(exact)], abs=1e-13)
    assert found[1][1] == pytest.approx(float(phi), abs=1e-13)


def test_two_powers_solve_their_equation():
    slow = law((0.1, -1), (0.2, 1), (0.05, 3))
    with ctx.workprec(100):
        h = arb(10) ** -8
        before, s, after = (slow.solve(arb(2) + n * h, arb(0))[0] for n in (-1, 0, 1))
        assert abs((after - before) / (2 * h) - slow.p(s)) < arb(10) ** -14
        assert abs((after - before) / (2 * h) - slow.p(s) * 1.001) > arb(10) ** -5


def test_extinction_in_closed_form():
    """a = -1/2, k = 1/4: extinct at tau = 1/(k |a|) = 8."""
    slow = law((0.25, -0.5))
    assert slow.table(0.0, 100.0).extinction == pytest.approx(8, rel=1e-13)
    assert slow.solve(arb(9), arb(0)) is None and slow.solve(arb("7.99"), arb(0)) is not None
    table = law((0.25, -1)).table(0.0, 100.0)  # A = 1 - tau/4, to the last knots, which fall together in doubles
    assert np.all(np.diff(table.tau) > 0)
    tau = 4 - np.array([2.0, 1e-3, 1e-9, 1e-15])
    assert np.exp(-table.at(tau)[0]) == pytest.approx(1 - tau / 4, abs=1e-8)


def test_a_law_that_loses_its_sign_is_refused():
    with pytest.raises(InputError, match="loses its sign"):
        law((0.1, 1), (-0.2, 3)).solve(arb(1), arb(0))


@pytest.mark.parametrize(("low", "high"), [("0", "1"), ("1", "0"), ("0", "0.2")])
def test_no_integral_over_a_zero_of_the_rate(low, high):
    """p = e^(-s)/10 - e^(-3 s)/5 is below 0 up to s = ln(2)/2: one end there is enough to refuse."""
    slow = law((0.1, 1), (-0.2, 3))
    with pytest.raises(InputError, match="loses its sign"):
        slow._integral(lambda _: acb(1), arb(low), arb(high))
    assert slow._integral(lambda _: acb(1), arb("0.4"), arb(1)) > 0


def test_no_law_no_motion():
    assert law().solve(arb(5), arb(2)) == (arb(2), arb(0))
    assert law().table(0.0, 5.0).at(np.array([4.0]))[0][0] == 0


def test_without_damping_the_phase_goes_on_at_its_rate():
    slow = law(phase=((0.5, 2.0),))  # a nonlinear spring alone: Omega = e^(-2 s)/2
    s, phi = slow.table(0.25, 4.0).at(np.array([0.0, 1.0, 3.0]))
    assert s == pytest.approx([0.25] * 3, abs=1e-15)
    assert phi == pytest.approx(np.array([0.0, 1.0, 3.0]) * 0.5 * np.exp(-0.5), abs=1e-15)
