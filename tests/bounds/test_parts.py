"""The parts of the theorem for all turning points, each at the worst case that it allows, where it is attained."""

from itertools import islice
from types import SimpleNamespace

import pytest
from flint import arb, ctx

from asymptotics.bounds import motion, turning
from asymptotics.bounds.late import late_turning
from asymptotics.bounds.turning import TurningBounds, rates, sensitivity, turning_bounds
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.sequence import sequence
from asymptotics.flow.turning import TurningState
from asymptotics.law import Oscillator
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.series import Series

DELTA = arb("0.25")
TIGHT = arb(1e-9)


def series(**coefficients):
    """1 + ... of one variable: c2="1/3" is the coefficient of its square."""
    return Series({(int(name[1:]),): arb(value) for name, value in coefficients.items()}, 1, 3)


def attained(bound, value):
    return bool(value <= bound * (1 + TIGHT) and bound <= value * (1 + TIGHT))


@pytest.mark.parametrize("sign", [-1, 1])
def test_the_rates_count_the_higher_terms_of_both_series(sign):
    """p = d - d^2/2 and Omega = d/3 are slowest at the far end, p = d + d^2/2 and Omega = -d/3 fastest."""
    low, high = rates(series(c1=1, c2=sign * 0.5), series(c1=-sign / 3), DELTA)
    truth = (1 + sign * DELTA / 2) / (1 - sign * DELTA / 3)
    assert attained(high if sign > 0 else low, truth)
    assert low <= truth * (1 + TIGHT) and truth <= high * (1 + TIGHT)


def rest(M, rho, order, delta):
    """Of M sum_(k > order) x^k, x = delta/rho, delta times the derivative, term by term."""
    return sum((k * M * (delta / rho) ** k for k in range(order + 1, order + 200)), arb(0))


@pytest.mark.parametrize("order", [1, 3, 8])
def test_the_sum_beyond_is_that_of_its_terms(order):
    M, rho = arb("0.7"), arb("0.6")
    assert attained(turning._beyond(M, rho, order, DELTA), rest(M, rho, order, DELTA))


def test_the_steepness_and_the_sensitivity_are_attained_by_their_majorants():
    """-L = d - d^2/9 - M sum x^k falls slowest, T = pi + d^2/5 + M sum x^k changes fastest."""
    M, rho = arb("0.01"), arb("0.6")
    beyond = SimpleNamespace(cauchy=M, radius=rho)
    half = SimpleNamespace(L=series(c1=-1, c2=arb(1) / 9), T=series(c0=arb.pi(), c2=arb(1) / 5))
    local = SimpleNamespace(half=half, amplitude=beyond, duration=beyond)
    tail = rest(M, rho, 3, DELTA)
    assert attained(turning._steepness(local, DELTA), 1 - 2 * DELTA / 9 - tail / DELTA)
    assert attained(sensitivity(local, DELTA), arb(2) / 5 + tail / DELTA**2)
    assert tail / DELTA**2 > arb("0.01")


@pytest.mark.parametrize("e", ["0.05", "0.3"])
def test_a_motion_that_is_ahead_by_e_has_the_strengths_of_its_own_amplitude(e):
    """T = pi + c delta^2, alpha = 2, B = 2 c: late by c delta^2 (e^(2 e) - 1) after one half-swing."""
    e, c, none = arb(e), arb(1) / 12, arb(0)
    local = SimpleNamespace(duration=SimpleNamespace(power=4), amplitude=SimpleNamespace(power=3))
    bounds = TurningBounds(local, DELTA, none, none, arb(1), arb(1), none, none, none, 2 * c, e, arb(1))
    late = c * DELTA**2 * ((2 * e).exp() - 1)
    assert late <= bounds.time(1) < late * (1 + arb("1.2") * e)
    assert 2 * c * e * DELTA**2 < late


@pytest.mark.parametrize(("alpha", "weight"), [("2", 1), ("3", 2)])
def test_an_uncertain_start_makes_the_strength_the_larger_one(alpha, weight):
    e, epsilon = arb("0.1"), arb(1) / 50
    bounds = turning_bounds([parse_real(alpha, "alpha")], 2, [epsilon], e)
    swell = (weight * e).exp()
    assert attained(bounds.delta, epsilon * swell)
    assert swell <= bounds.widening and bounds.widening <= swell**2 * (1 + TIGHT)  # what is needed is one factor


@pytest.mark.parametrize("side", [-1, 1])
def test_a_jump_from_an_uncertain_turning_point_holds_both_ends(side):
    """A_0 = 1 +- e and tau_0 = +- e: the motions from both ends are inside, with what is left of e as the radius."""
    e = arb(2) ** -10
    with ctx.workprec(100):
        damping = Damping.of([(arb(1) / 50, parse_real("2", "alpha"))])
        found = late_turning(damping, TurningState(0, 1, arb(1), arb(0), e, e), arb(40), 1)
        end = TurningState(0, 1, 1 + side * e, side * e, arb(0), arb(0))
        true = next(islice(sequence(LinearSpring(damping), end), found.n, None))
        apart, late = abs(found.amplitude - true.amplitude), abs(found.time - true.time)
        assert found.amplitude_error / 4 < apart < found.amplitude_error
        assert found.time_error / 4 < late < found.time_error


def test_the_bound_of_a_motion_reaches_the_far_end_of_its_enclosure(monkeypatch):
    monkeypatch.setattr(motion, "enclosure", lambda *_, **__: arb(1, "0.25"))
    assert motion.proved_bound(Oscillator({2: "1/10"}), "1.1", "1") in ("0.35", "0.36")


def test_the_energy_counts_the_speed(monkeypatch):
    """m = 1, k = 4: at x = 3 and v = 8 the energy is that of x = 5."""
    state = SimpleNamespace(x=[arb(3)], v=[arb(8)])
    monkeypatch.setattr(motion, "reference_states", lambda *_, **__: state)
    found = motion._by_energy(Oscillator({2: "1/10"}, stiffness=4), ExactReal(100), 20)
    assert found.mid() == 0 and found.rad() >= 5 and found.rad() < arb("5.000001")
