"""The expansion at a turning point: its tail, its speeds, and one term alone for exponents near 0."""

from dataclasses import replace
from fractions import Fraction

import mpmath
import pytest
from flint import arb, arb_poly, ctx
from scipy.integrate import solve_ivp

from asymptotics.errors import UndecidedError
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.expansion import TurningExpansion, room
from asymptotics.flow.linear_spring.kept_terms import KeptTerms
from asymptotics.flow.times import at_time
from asymptotics.law import Law
from asymptotics.numbers.exact import ExactReal
from asymptotics.return_map.half_swing_map import integrated
from asymptotics.turning.choose import turning_points
from tests.flow.forces import NOTHING, damping_of


def damping(*terms):
    return Damping.of([(arb(e), ExactReal(Fraction(a))) for a, e in terms])


LAWS = [(("1/1000", "0.3"),), (("1/300", "0.25"), ("2", "0.5"))]


def _tails(d, expansion):
    """lambda^-E |P_0| R* and lambda^-E R*/(1 - R*)/|P_0| with mpmath, from the plan alone."""
    plan, size, w = expansion.plan, abs(float(expansion.y0.mid())), float(expansion.reach)
    a = w * w / 2 / size**2
    b = [float(e.mid()) * w ** float(x.mid()) / size for e, x in zip(d.strengths, d.exponents)]
    if plan.denominator:
        g = [2 * plan.stretch[0], *(plan.stretch[0] * float(x.mid()) for x in d.exponents)]
        factor = 2 ** (-plan.stretch[0] * plan.count / plan.denominator)
    else:
        g, factor = plan.stretch, 2 ** (-plan.top / 65536)
    a, b = a * 2 ** g[0], sum(t * 2**s for t, s in zip(b, g[1:]))
    found = []
    if b < 1 and (1 - b) ** 2 > 4 * a:
        found.append((1 + b - mpmath.sqrt((1 - b) ** 2 - 4 * a)) / 2)
    if a + b < 0.5:
        found.append(1 - mpmath.sqrt(1 - 2 * a - 2 * b))
    R = min(found)
    return float(factor * size * R), float(factor * R / (1 - R) / size)


@pytest.mark.parametrize("terms", LAWS, ids=str)
def test_a_ladder_of_precisions(terms):
    with ctx.workprec(160):
        fine = integrated(damping(*terms), arb(1))
        assert fine.amplitude.rad() < 1e-33 and fine.duration.rad() < 1e-33
    for bits in (30, 50, 90):
        with ctx.workprec(bits + 32):
            law = damping(*terms)
        with ctx.workprec(bits):
            found = integrated(law, arb(1))
            for a, b in ((found.amplitude, fine.amplitude), (found.duration, fine.duration)):
                assert a.contains(b.mid()) and a.rad() < 2.0 ** (14 - bits)


@pytest.mark.parametrize("terms", LAWS, ids=str)
def test_the_half_swing_is_that_of_scipy(terms):
    laws = [(float(Fraction(a)), float(e)) for a, e in terms]

    def slope(_, state):
        y, w = state
        return [-w, y - sum(e * max(w, 0.0) ** a for a, e in laws)]

    turned = lambda t, state: state[1]  # noqa: E731
    turned.terminal, turned.direction = True, -1
    end = solve_ivp(slope, (0, 9), [1.0, 1e-13], "DOP853", events=turned, rtol=1e-12, atol=1e-13, max_step=0.05)
    with ctx.workprec(112):
        law = damping(*terms)
    with ctx.workprec(80):
        found = integrated(law, arb(1))
    assert abs(-end.y_events[0][0][0] - float(found.amplitude)) < 1e-9
    assert abs(end.t_events[0][0] - float(found.duration)) < 1e-8


def test_half_of_the_drop_or_of_the_delay_would_be_wrong():
    with ctx.workprec(60):
        law, w = damping(("1/1000", "0.1")), arb(2) ** -8
        for side in (1, -1):
            short = TurningExpansion._short(law, arb(side), w, KeptTerms(-8.0, 1, (), 1))
            y, tau = TurningExpansion.at(law, arb(side), w).state(w)
            about = short.state(w)
            assert about[0].contains(y) and about[1].contains(tau)
            assert not arb(side, short.tail / 2).contains(y)
            assert not (w * (side + arb(0, short.time_tail / 2))).contains(tau)


@pytest.mark.parametrize("strength", ["0.5", "0.8", "0.93"])
def test_the_drop_counts_that_braking_slows_the_motion(strength):
    """Under a nearly constant brake w' = 1 - N: the place falls by w^2/(2 (1 - N)), which the drop covers."""
    with ctx.workprec(60):
        law, w = damping(("1/1000", strength)), arb(2) ** -8
        drop, slowest, _ = room(law, arb(1), w)
        truth = w * w / (2 * (1 - law.resistance(w)))
        assert truth < drop < 4 * truth and drop >= w * w / (2 * slowest)


@pytest.mark.parametrize(
    ("law", "n"),
    [({"1/1000": "9/10"}, 0), ({"1/100000": "9/10"}, 0), ({"1/1000": "1/2"}, 1), ({"1/500": "1/3", "1/2": "1/10"}, 1)],
)
def test_strengths_near_1_are_served(law, n):
    table = turning_points(Law(law), 4, 12, times=True)
    assert table.certified and table.ended == {"n": n, "reason": "creeps"}


def test_a_moving_start_is_served():
    table = turning_points(Law({"1/1000": "9/10"}), 4, 12, x0="1/2", v0="-3")
    assert table.ended == {"n": 1, "reason": "creeps"} and table.points[1].x.startswith("0.15341082")


def test_where_braking_may_stop_the_motion_at_once_there_is_no_room():
    law = damping(("1", "1"))
    with pytest.raises(UndecidedError, match="may stop the motion at once"):
        room(law, arb("0.1"), arb("0.2"))


@pytest.mark.parametrize("law", [NOTHING, (("3/2", "1/5"),), (("2", "3"),), (("sqrt(2)", "1/10"),), (("1/2", "1/9"),)])
@pytest.mark.parametrize("y0", [1, -1, "0.01"])
def test_the_tail_of_the_expansion(law, y0):
    """Few terms: what they lack is below the tail, which is the majorant's constant times the stretch, no less."""
    d = damping_of(*law)
    with ctx.workprec(250):
        full = TurningExpansion.at(d, arb(y0))
    with ctx.workprec(14):
        few = TurningExpansion.at(d, arb(y0))
    w = min(few.reach, full.reach)
    with ctx.workprec(250):
        (y, tau), (low_y, low_tau) = full.state(w), few.state(w)
        assert low_y.contains(y) and low_tau.contains(tau)
        missing = abs(low_y.mid() - y)
        assert missing <= few.tail + low_y.rad()
    tail, time_tail = _tails(d, few)
    assert 0.999 * tail <= float(few.tail) <= 1.02 * tail
    assert 0.999 * time_tail <= float(few.time_tail) <= 1.03 * time_tail


@pytest.mark.parametrize("law", [(("3/2", "1/5"),), (("3/2", "1/5"), ("5/3", "1/3"))])
@pytest.mark.parametrize("y0", [arb("0.75"), arb("-0.375")])
def test_many_speeds_from_one_line(law, y0):
    """The same terms in another order: both hold 200 bits, and a coefficient that is moved by one place does not."""
    d = damping_of(*law)
    with ctx.workprec(200):
        fine = TurningExpansion.at(d, y0)
    with ctx.workprec(90):
        rows = TurningExpansion.at(d, y0)
        line = rows.gathered
        assert rows.line is None and line.line is not None and line.terms == rows.terms
        for share in (1, "0.5", "0.01"):
            w = (min(rows.reach, fine.reach) * arb(share)).mid()
            truth = fine.state(w)
            for found in (rows.state(w), line.state(w)):
                assert all(x.overlaps(y) and x.rad() < arb(2) ** -80 for x, y in zip(found, truth))
        moved = replace(line, line=tuple(p.left_shift(1) for p in line.line))
        assert not any(x.overlaps(y) for x, y in zip(moved.state(w), truth))


@pytest.mark.parametrize("law", [(("3/2", "1/5"),), (("1", "1/20"), ("3", "1/5")), (("2", "1/5"),)])
def test_a_line_solves_its_equations(law):
    """P Q = 1 and dy/dw = -w Q to the last coefficient, whole or with zeros left out; one that is off is noticed."""
    d = damping_of(*law)
    with ctx.workprec(300):
        found = TurningExpansion.at(d, arb("0.75"))
        (y, slow), q = found.line, found.root
        force = {int(a.rational * q): e for a, e in zip(d.alphas, d.strengths)}
        P = arb_poly([c - force.get(k, 0) for k, c in enumerate(y)])
        Q = arb_poly([c * (k + q) / q for k, c in enumerate(slow)])
        count = min(len(P), len(Q))
        ones = [c.contains(int(k == 0)) for k, c in enumerate((P * Q).coeffs()[:count])]
        assert count > 200 and ones == [True] * count
        assert all((y[k] * k / q + Q[k - 2 * q]).contains(0) for k in range(2 * q, count))
        Q[count // 2] += arb(2) ** -200
        assert not (P * Q)[count // 2].contains(0)


@pytest.mark.parametrize("law", [(("sqrt(2)", "1/5"),), (("37/20", "1/5"),), (("3/2", "1/5"), ("5/2", "1/3"))])
def test_an_expansion_that_has_no_short_line_or_is_on_one_stays_as_it_is(law):
    with ctx.workprec(90):
        found = TurningExpansion.at(damping_of(*law), arb(1))
        assert found.gathered is found


@pytest.mark.parametrize("law", [NOTHING, (("3/2", "1/2"),), (("0", "1/10"), ("2", "1"))])
def test_a_wide_time_near_a_turning_point(law):
    """The states at both ends of the time are contained; the speed in phase space is bounded within a factor of 4."""
    with ctx.workprec(90):
        expansion = TurningExpansion.at(damping_of(*law), arb("0.75"))
        middle, width = expansion.reach.mid() / 2, arb(2) ** -18
        y, w = at_time(expansion, middle + arb(0, width))
        for end in (middle - width, middle + width):
            exact_y, exact_w = at_time(expansion, end.mid())
            assert y.contains(exact_y) and w.contains(exact_w)
        assert w.rad() < 10 * width
        largest = abs(expansion.y0) + expansion.damping.friction
        assert largest <= expansion.speed(arb(1)) and expansion.speed(arb(1)) < 4 * largest


@pytest.mark.parametrize("law", [NOTHING, (("3/2", "1/2"),), (("0", "1/10"), ("2", "1"))])
def test_the_speed_beside_a_turning_point(law):
    """|(y', w')| on both sides: P doubles at most, friction counts twice where its sign turns; evaluated again."""
    with ctx.workprec(60):
        found = TurningExpansion.at(damping_of(*law), arb("0.75"))
        y, _ = found.state(found.reach)
        across = y + 2 * found.damping.friction + found.damping.resistance(found.reach)
        assert (across**2 + found.reach**2).sqrt() <= found.speed(arb(1))
        again = 2 * arb("0.75") + 2 * found.damping.friction + found.reach
        assert again <= found.speed(arb(1)) * (1 + arb(1e-9)) and found.speed(arb(1)) <= again * (1 + arb(1e-9))
    with ctx.workprec(30):
        short = TurningExpansion._short(
            damping_of(("1/1000", "0.3")), arb("0.75"), arb(2) ** -8, KeptTerms(-8.0, 1, (), 1)
        )
        again = 2 * arb("0.75") + short.reach + short.damping.resistance(short.reach)
        assert again <= short.speed(arb(1)) * (1 + arb(1e-6)) and short.speed(arb(1)) < again * (1 + arb(1e-6))
