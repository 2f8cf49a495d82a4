"""The force in a well: its slopes and largest changes, against a second evaluation."""

import mpmath
import pytest
from flint import arb, ctx

from asymptotics.flow.wells.force import WellForce
from asymptotics.law import Law
from tests.flow.forces import WELLS as FORCES
from tests.flow.forces import in_a_well


def on_circles(f, u, du, w=0, dw=0):
    """The largest |f(U, W)| on |U - u| = du, |W - w| = dw at 32 points of each circle."""
    turns = [mpmath.expj(mpmath.pi * k / 16) for k in range(32)]
    return max(abs(f(u + du * a, w + dw * b)) for a in turns for b in (turns if dw else [1]))


def polynomial(force, side):
    """G(U, W) on one side of U = 0, in mpmath."""
    rate = None if force.rate is None else float(force.rate)
    powers = [(float(c), n) for c, n in force.restoring_powers(side)]
    losses = [(float(f.strength) * side**f.place, f.place, float(f.exponent)) for f in force.losses]

    def G(U, W):
        rest = sum(c * U**n for c, n in powers) + (U if rate is None else mpmath.sin(rate * U) / rate)
        return rest - sum(e * U**m * W**a for e, m, a in losses)

    return G


STIFF = in_a_well({(1, 2): "1/3", "1/2": "1/5", (2, 1): "1/4"}, {3: "1/2", 2: "1/7"})
HELD = in_a_well({(0, 2): "1/3", (0, 1): "1/9", 2: "1/5"})
LOST = in_a_well({(2, 2): "1/3", "3/2": "1/4"}, "pendulum")


@pytest.mark.parametrize(("force", "u", "reach"), [(STIFF, 0.5, 0.5), (LOST, 1.5, 1.0), (LOST, 0.25, 0.5)])
def test_the_change_of_the_force_is_attained(force, u, reach):
    G = polynomial(force, 1)
    most = on_circles(lambda U, _: G(U, 0) - G(u, 0), u, reach)
    bound = force.largest_change(arb(u), arb(reach))
    assert most <= float(bound) < 1.5 * most


@pytest.mark.parametrize("force", [STIFF, LOST])
def test_the_largest_force_on_two_discs_is_attained(force):
    """Towards larger |U| and W everything adds up where U < 0."""
    most = on_circles(polynomial(force, -1), -0.5, 0.5, 0.75, 0.5)
    bound = float(force.largest(arb("-0.5"), arb("0.5"), arb("0.75"), arb("0.5")))
    assert most <= bound < 1.4 * most
    spring, loss = (float(f) for f in (abs(force.restoring(arb("-0.5"))), force.drag(arb("0.5"), arb("0.75"))))
    assert min(spring, loss) > 0.05 * most


@pytest.mark.parametrize("force", [STIFF, LOST, HELD])
@pytest.mark.parametrize("u", ["0.5", "-0.75"])
def test_every_slope_is_in_the_ball_and_hardly_more(force, u):
    """dG/du at both ends of the speeds: they are the ends of the ball."""
    x, top = float(arb(u)), 1.25
    G = polynomial(force, 1 if x > 0 else -1)
    ends = [float(mpmath.diff(lambda U, w=w: G(U, w).real, x)) for w in (0, top)]
    ball = force.slope(arb(u), arb(top))
    assert all(float(ball.lower()) - 1e-9 <= slope <= float(ball.upper()) + 1e-9 for slope in ends)
    assert float(ball.upper() - ball.lower()) < abs(ends[1] - ends[0]) + 1e-6
    wide = force.slope(arb(u) + arb(0, 0.125), arb(top))
    for place in (x - 0.125, x + 0.125):
        assert all(wide.contains(float(mpmath.diff(lambda U, w=w: G(U, w).real, place))) for w in (0.0, top))
    assert float(wide.rad()) < float(ball.rad()) + 1.5


def test_a_loss_of_uncertain_speed_counts_at_its_upper_end():
    assert FORCES["duffing"].drag(arb(1), arb(1) + arb(0, 0.5)) >= arb(1) / 3 * arb("1.5") ** 2


def test_a_force_sorts_its_terms_and_is_as_strong_as_all_of_them():
    """Losses, springs that harden or soften, and which loss is linear."""
    with ctx.workprec(60):
        force = WellForce.of(Law({2: "1/2", 1: "1/3", "1/2": 1}, spring={3: "-1/4"}).terms)
        assert len(force.losses) == 3 and len(force.springs) == 1 and not force.grips
        assert force.viscous.overlaps(arb(1) / 3) and force.viscous < arb("0.34")
        assert force.strongest(arb(1), arb(1)) >= arb("0.75") + arb("1.8333")
