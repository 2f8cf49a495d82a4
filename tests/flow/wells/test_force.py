"""The bounds of the force beside a turning point, and of the expansion there, against a second evaluation."""

from dataclasses import replace

import mpmath
import pytest
from flint import arb, ctx

from asymptotics.flow.wells import expansion as expansions
from asymptotics.flow.wells.expansion import WellExpansion
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


@pytest.mark.parametrize("name", FORCES)
def test_the_rate_next_to_a_turning_point(name):
    """Above |w'| on both sides; within 7 of it, for it allows P to double."""
    force = FORCES[name]
    with ctx.workprec(60):
        found = WellExpansion.at(force, arb(1))
        w = found.reach
        u, _ = found.state(w)
        before = abs(force.acceleration(u, w))
        after = abs(
            force.restoring(u) + 2 * force.dry_friction(u) + force.drag(u, w)
        )  # on its way to the turning point
        most = before.max(after).max(abs(found.brake))
        assert most <= found.rate < 7 * most
        again = 6 * abs(force.restoring(arb(1))) + 2 * force.dry_friction(arb(1))
        assert again <= found.rate * (1 + arb(1e-9)) and found.rate <= again * (1 + arb(1e-9))
        assert found.speed(arb(3)) >= found.rate + 3 * found.reach


@pytest.mark.parametrize("name", FORCES)
@pytest.mark.parametrize("u0", [1, -1])
def test_the_majorant_is_a_solution_of_its_inequality(name, u0):
    """Up to the edge of what it serves: H and R fulfil a/(1-R(H)) <= H in doubles, and H is at most twice the least."""
    force = FORCES[name]
    plan, found = served(force, u0)
    size = float(abs(force.restoring(arb(u0))))
    rest = polynomial(force, 1)
    changes = [float(abs(c)) for c in mpmath.taylor(lambda U: rest(U, 0), 1, 14)]
    alphas = [2.0, *(float(f.exponent) for f in force.losses)]
    stretch = [a * plan.stretch[0] for a in alphas] if plan.denominator else plan.stretch
    for w, (factor, *bounds) in found:
        a, *z = (w**e * 2.0**g for e, g in zip(alphas, stretch))
        a, (H, R) = a / 2 / size, map(float, bounds)

        def r(h, z=z):
            lost = sum(float(f.strength) * t * (1 + h) ** f.place for f, t in zip(force.losses, z))
            return (sum(c * h**k for k, c in enumerate(changes) if k) + lost) / size

        assert r(H) <= R * (1 + 1e-9) and R < 1 and a / (1 - R) <= H * (1 + 1e-9)
        least = a
        for _ in range(400):
            least = a / (1 - r(least))
        assert least <= H < 2 * least
        assert float(factor) == pytest.approx(first_left_out(force, plan), rel=1e-9, abs=0)
    assert len(found) > 3


def served(force, u0):
    """The plan at a turning point, and the majorant at speeds that approach the largest for which there is one."""
    with ctx.workprec(60):
        plan, _ = expansions._plan(force, arb(u0), force.restoring(arb(u0)), None, 1.0)
        size, low, high, found = abs(force.restoring(arb(u0))), arb(2) ** -20, arb(4), []
        for _ in range(24):
            w = ((low + high) / 2).mid()
            majorant = expansions._majorant(force, arb(u0), size, w, plan)
            low, high = (w, high) if majorant else (low, w)
            found += [(float(w), majorant)] if majorant else []
    return plan, found


def first_left_out(force, plan):
    """2^-G: the stretch to the power of the first exponent that no term has, or the top of the weights."""
    if not plan.denominator:
        return 2.0 ** (-plan.top / 65536)
    step, _, count = expansions._line(force, plan)
    return 2.0 ** (-plan.stretch[0] * count * float(step))


@pytest.mark.parametrize("name", FORCES)
def test_what_is_left_out_is_added(name):
    """The tails are 2^-G H* and 2^-G R*/(1 - R*)/|P_0|, and both are in the radii of what is handed out."""
    force = FORCES[name]
    with ctx.workprec(40):
        few = WellExpansion.at(force, arb(1))
        _, _, (factor, H, R) = expansions._planned(force, arb(1), force.restoring(arb(1)), None)
        assert few.tail >= factor * H and few.time_tail >= factor * R / (1 - R) / abs(few.brake)
        assert few.tail <= factor * H * arb("1.01") and few.time_tail * abs(few.brake) <= R / (1 - R) * factor * arb(
            "1.01"
        )
    with ctx.workprec(80):
        wide = replace(few, tail=arb(1) / 4, time_tail=arb(1) / 2)
        for w in (few.reach, few.reach / 4):
            u, tau = wide.state(w)
            assert u.rad() >= arb(1) / 4 and tau.rad() >= (w / 2).lower()
            assert u.contains(few.state(w)[0].mid() + arb(1) / 4)


def test_a_force_sorts_its_terms_and_is_as_strong_as_all_of_them():
    """Losses, springs that harden or soften, and which loss is linear."""
    with ctx.workprec(60):
        force = WellForce.of(Law({2: "1/2", 1: "1/3", "1/2": 1}, spring={3: "-1/4"}).terms)
        assert len(force.losses) == 3 and len(force.springs) == 1 and not force.grips
        assert force.viscous.overlaps(arb(1) / 3) and force.viscous < arb("0.34")
        assert force.strongest(arb(1), arb(1)) >= arb("0.75") + arb("1.8333")
