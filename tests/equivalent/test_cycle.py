"""One full swing of the motion: certified, against an integrator, and the series of order N within its bound."""

import numpy as np
import pytest
from flint import arb, ctx
from scipy.integrate import solve_ivp

from asymptotics.equivalent.cycle import expanded_swing, full_swing
from asymptotics.law import Law
from tests.worlds import worlds_of

SWINGING = worlds_of(
    "quadratic", "another rational power", "dry friction beside the linear loss", "linear",
    "a loss that knows the place", "a pendulum of three halves", "air and a spring x^3",
    "a loss in a soft kinked spring",
)  # fmt: skip
BOUNDED = worlds_of("quadratic", "another rational power", "dry friction", "a sum of powers", "below the linear one")


def force_and_energy(law):
    springs = [(float(t.strength.ball()), t.position, t.family) for t in law.springs]
    losses = [(float(t.strength.ball()), float(t.velocity.ball()), t.position) for t in law.losses]

    def pull(x):
        linear = np.sin(x) if any(f for *_, f in springs) else x
        return linear + sum(c * x * abs(x) ** (p - 1) for c, p, f in springs if not f)

    def potential(x):
        linear = 1 - np.cos(x) if any(f for *_, f in springs) else x**2 / 2
        return linear + sum(c * abs(x) ** (p + 1) / (p + 1) for c, p, f in springs if not f)

    def acceleration(t, y):
        x, v = y
        return [v, -pull(x) - sum(b * abs(x) ** m * np.sign(v) * abs(v) ** a for b, a, m in losses)]

    return acceleration, potential


def integrated(law):
    """(decrement, share of the energy) of the first full swing by an integrator with events."""
    acceleration, potential = force_and_energy(law)
    x = 1.0
    for direction in (1, -1):
        at_rest = lambda t, y: y[1]  # noqa: E731
        at_rest.terminal, at_rest.direction = True, direction
        # a first step away from rest, where the event would fire at once
        first = solve_ivp(acceleration, (0, 0.05), [x, 0.0], rtol=1e-12, atol=1e-14, method="DOP853")
        run = solve_ivp(acceleration, (0, 30), first.y[:, -1], events=at_rest, rtol=1e-12, atol=1e-14, method="DOP853")
        x = float(run.y_events[0][0][0])
    return -np.log(x), 1 - potential(x) / potential(1.0)


@pytest.mark.parametrize("world", SWINGING.values(), ids=SWINGING)
def test_the_certified_swing_is_that_of_an_integrator(world):
    law = world.dimensionless
    decrement, share = integrated(law)
    found = full_swing(law, 15)
    assert float(found.decrement) == pytest.approx(decrement, rel=3e-8)
    assert float(found.share) == pytest.approx(share, rel=3e-8)
    assert float(found.decrement) != pytest.approx(decrement * 1.0001, rel=1e-6)


@pytest.mark.parametrize("world", BOUNDED.values(), ids=BOUNDED)
@pytest.mark.parametrize("order", [1, 2, 3])
def test_the_motion_is_within_the_bound_of_order_N(world, order):
    law = world.dimensionless
    truth = full_swing(law, 25)
    cut = expanded_swing(law.terms, [t.strength.ball() for t in law.terms], order)
    with ctx.workprec(100):
        for name in ("decrement", "share", "zeta_log", "quality"):
            assert getattr(cut, name).overlaps(getattr(truth, name)), name
    assert cut.decrement.rad() < truth.decrement


@pytest.mark.parametrize("order", [1, 2, 3])
def test_half_of_the_bound_would_be_wrong(order):
    law = Law({2: "1/10"})
    truth = full_swing(law, 25).decrement
    cut = expanded_swing(law.terms, [arb("0.1")], order).decrement
    assert not arb(cut.mid(), cut.rad() / 2).overlaps(truth)


def test_where_there_is_no_swing_it_is_said():
    assert full_swing(Law({0: "2/5"}), 15) == "no full swing: it sticks after 1 half-swings"
    assert "overdamped" in full_swing(Law({1: 3}), 15)
    assert "creeps" in full_swing(Law({"1/2": 1}), 15)
    assert "not below" in expanded_swing(Law({2: 5}).terms, [arb(5)], 2)
    assert "larger than the decrement" in expanded_swing(Law({2: "4/25"}).terms, [arb("0.3")], 1)
    assert "bound is proved for powers" in expanded_swing(Law({2: 1}, spring={3: 1}).terms, [arb(1), arb(1)], 2)


def test_viscous_damping_has_its_own_ratio_at_any_strength():
    with ctx.workprec(100):
        for b in ("1/100", "1/2", "19/10"):
            zeta = full_swing(Law({1: b}), 25).zeta_log
            assert abs(zeta - Law({1: b}).terms[0].strength.ball() / 2) < 1e-14
