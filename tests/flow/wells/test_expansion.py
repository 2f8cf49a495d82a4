"""The expansion at a turning point in a well: its majorant and its tails, against a second evaluation."""

from dataclasses import replace
from types import SimpleNamespace

import mpmath
import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.flow.times import at_time
from asymptotics.flow.wells import expansion as expansions
from asymptotics.flow.wells.expansion import WellExpansion
from asymptotics.flow.wells.force import WellForce
from asymptotics.law import Law
from tests.flow.forces import WELLS as FORCES
from tests.flow.wells.test_force import polynomial


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


def test_an_expansion_begins_where_the_mass_moves():
    with ctx.workprec(60):
        force = WellForce.of(Law({0: "1/2", 2: 1}, spring={3: 1}).terms)
        assert WellExpansion.at(force, arb(1)).reach > 0
        with pytest.raises(UndecidedError, match="holds the mass here"):
            WellExpansion.at(force, arb(0, "0.9"))


@pytest.mark.parametrize("name", FORCES)
@pytest.mark.parametrize("u0", [1, -1])
def test_the_majorant_bounds_the_coefficients_and_is_nearly_attained(name, u0):
    """Sum of |coefficients| at the edge of what is kept is below H; a small piece of the range attains it."""
    force = FORCES[name]
    with ctx.workprec(60):
        few = WellExpansion.at(force, arb(u0))
    with ctx.workprec(200):
        full = WellExpansion.at(force, arb(u0))
        w = min(few.reach, full.reach)
        (u, tau), (low_u, low_tau) = full.state(w), few.state(w)
        assert low_u.contains(u.mid()) and low_tau.contains(tau.mid())
        tiny = w * arb(2) ** -12
        fallen = abs(full.u0 - full.state(tiny)[0])
        bound = tiny**2 / (2 * abs(full.brake))
        assert fallen > bound / 2 and fallen < bound * 2  # H -> a


def test_the_tail_is_the_factor_times_the_majorant():
    """2^-G H* for the free pendulum, from the plan and the two equations of the majorant in floats."""
    force, sine, cosine = FORCES["free pendulum"], mpmath.sin(1), mpmath.cos(1)
    with ctx.workprec(40):
        few = WellExpansion.at(force, arb(1))
        plan, _ = expansions._plan(force, arb(1), force.restoring(arb(1)), None, 1.0)
    stretch, H = plan.stretch[0], mpmath.mpf(0)
    a = float(few.reach) ** 2 * 4**stretch / 2 / sine
    for _ in range(200):
        H = a / (1 - (sine * (mpmath.cosh(H) - 1) + cosine * mpmath.sinh(H)) / sine)
    again = 2 ** (-stretch * few.u.length() * float(few.step)) * H
    assert again <= float(few.tail) <= 1.15 * again
    with ctx.workprec(300):
        fine = WellExpansion.at(force, arb(1), few.reach).state(few.reach)[0]
        kept = few.u(few.reach**few.step.numerator)
        assert abs(kept.mid() - fine) <= few.tail + kept.rad()


def test_where_dry_friction_may_hold_there_is_no_expansion():
    with pytest.raises(UndecidedError, match="holds the mass here"):
        WellExpansion.at(SimpleNamespace(restoring=lambda _: arb(0, 1)), arb(1))


@pytest.mark.parametrize("name", ["free pendulum", "duffing", "dry beside springs"])
def test_a_wide_time_near_a_turning_point(name):
    """Both ends of the time are contained; the place moves at the speed reached there, half is less."""
    with ctx.workprec(90):
        expansion = WellExpansion.at(FORCES[name], arb(1))
        middle, width = (expansion.state(expansion.reach)[1] * arb("0.96")).mid(), arb(2) ** -18
        u, w = at_time(expansion, middle + arb(0, width))
        moved = []
        for end in (middle - width, middle + width):
            exact_u, exact_w = at_time(expansion, end.mid())
            assert u.contains(exact_u) and w.contains(exact_w)
            moved.append((abs(exact_u - u.mid()), abs(exact_w - w.mid())))
        assert u.rad() / 2 < moved[0][0] and w.rad() < 8 * moved[0][1]


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
