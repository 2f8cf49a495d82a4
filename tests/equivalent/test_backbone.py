"""The backbone: period and omega of the cycle without loss, and of the motion, against other routes."""

from fractions import Fraction

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from scipy.special import ellipk

import asymptotics as asy
from asymptotics.errors import InputError


def swing_time(force, amplitude):
    """The time from rest at the amplitude to the second turning point, by DOP853."""
    found = solve_ivp(
        lambda _, y: [y[1], -force(*y)], (0, 30), [amplitude, 0.0], events=lambda _, y: y[1],
        method="DOP853", rtol=1e-12, atol=1e-14, dense_output=True,
    )  # fmt: skip
    return next(t for t, y in zip(found.t_events[0], found.y_events[0]) if t > 1 and y[0] > 0)


def test_the_viscous_swing_is_late_and_the_cycle_is_not():
    row = asy.damping(asy.Oscillator({1: "1/5"}, mass=2, stiffness=8), 3, digits=15).rows[0]
    # epsilon = 0.2/sqrt(16) = 1/20.
    assert float(row.first.period) == pytest.approx(np.pi, rel=1e-14) and float(row.first.omega) == 2.0
    assert float(row.motion.omega) == pytest.approx(2 * np.sqrt(1 - 1 / 1600), rel=1e-14)
    assert row.motion.certified and row.first.certified


@pytest.mark.parametrize("amplitude", ["1/10", "1", "3"])
def test_a_pendulum_without_loss_has_its_elliptic_integral(amplitude):
    row = asy.damping({2: "1/20"}, amplitude, spring="pendulum", digits=12).rows[0]
    a = float(Fraction(amplitude))
    assert float(row.first.period) == pytest.approx(4 * ellipk(np.sin(a / 2) ** 2), rel=1e-11)
    assert float(row.motion.period) == pytest.approx(
        swing_time(lambda x, v: np.sin(x) + 0.05 * v * abs(v), a), rel=1e-9
    )
    # Near miss: with the loss the swing is another one.
    assert abs(float(row.motion.period) / float(row.first.period) - 1) > 1e-6


def test_a_cubic_spring_and_dry_friction():
    row = asy.damping({0: "1/50"}, 1, spring={3: "3/10"}, digits=12).rows[0]
    rest = quad(lambda s: 1 / np.sqrt(1 + 0.15 * (1 + np.sin(s) ** 2)), 0, np.pi / 2, epsabs=0, epsrel=1e-12)[0]
    assert float(row.first.period) == pytest.approx(4 * rest, rel=1e-11)
    assert float(row.motion.period) == pytest.approx(
        swing_time(lambda x, v: x + 0.3 * x**3 + 0.02 * np.sign(v), 1.0), rel=1e-4
    )
    # Beside the linear spring dry friction leaves the period as it is, exactly.
    bare = asy.damping({0: "1/50"}, 1, digits=12).rows[0]
    assert bare.motion.period == bare.first.period and float(bare.motion.omega) == 1.0


def test_it_is_a_column_and_a_curve(tmp_path):
    found = asy.damping(asy.Oscillator({1: "1/5"}, mass=2, stiffness=8), ["1", "2"], digits=6, order=2)
    assert found.header()[-4:-2] == ["period [s]", "omega [rad/s]"]
    assert found.to_dict()["rows"][0]["first"]["omega"] == "2.00000"
    assert found.to_dict()["units"]["omega"] == "rad/s"
    # The series of order N has no times.
    assert found.rows[0].expanded.period is None
    at = asy.damping({2: "1/20"}, 1, spring="pendulum", digits=6).sample([0.5, 1.0, np.nan])
    assert at["omega"][:2] == pytest.approx(np.pi / 2 / ellipk(np.sin([0.25, 0.5]) ** 2)) and np.isnan(at["omega"][2])
    found.plot(quantity="omega").figure.savefig(tmp_path / "backbone.svg")
    with pytest.raises(InputError, match="period, omega"):
        found.plot(quantity="frequency")


def test_where_no_swing_can_be_enclosed_the_first_order_stands():
    # failed at first: the times of such a swing asked for more than the whole request may take
    row = asy.damping({2: "1e400"}, 1, digits=12, max_seconds=5).rows[0]
    assert row.motion.reason and row.motion.period is None and row.first.period
