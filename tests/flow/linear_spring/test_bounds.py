"""Every bound of a half-swing bites: at parameters where it is nearly attained, half of it is refuted by the truth.

Where a bound keeps a stated slack, its constant is evaluated a second time, without balls.
"""

from itertools import islice
from types import SimpleNamespace

import mpmath
import pytest
from flint import arb, ctx

from asymptotics.errors import InputError, UndecidedError
from asymptotics.flow import dense
from asymptotics.flow.damping import Damping
from asymptotics.flow.error_propagation import CarriedErrors, turning_delay
from asymptotics.flow.linear_spring import turning_point as arrivals
from asymptotics.flow.linear_spring.expansion import TurningExpansion
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.linear_spring.majorant import majorant
from asymptotics.flow.linear_spring.trapping_regions import trap
from asymptotics.flow.sequence import first_from, sequence
from asymptotics.flow.times import at_time
from asymptotics.flow.trajectory import ArrivalPiece, FlowState, _arrival, half_swing_pieces
from asymptotics.flow.turning import TurningState
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_real
from asymptotics.return_map import half_swing_map
from asymptotics.return_map.half_swing_map import HalfSwingBalls, integrated
from asymptotics.return_map.sequence import following


def damping(*pairs):
    with ctx.workprec(300):
        return Damping.of([(parse_real(e, "e").ball(), parse_real(a, "a")) for a, e in pairs])


NOTHING = (("3", "1e-300"),)


@pytest.mark.parametrize("w", ["0.1", "0.5", "0.9"])
def test_the_majorant_is_attained_without_damping(w):
    """y = sqrt(1 - w^2): r = 1 - sqrt(1 - w^2) = S(w^2/2, 0)."""
    truth = 1 - (1 - arb(w) ** 2).sqrt()
    bound = majorant(arb(w) ** 2 / 2, arb(0))
    assert truth <= bound * (1 + arb(1e-12)) and bound / 2 < truth


@pytest.mark.parametrize("b", ["0.05", "0.5", "0.95"])
def test_the_majorant_is_attained_without_inertia(b):
    """With a -> 0, P = P_0 (1 - b) exactly."""
    bound = majorant(arb(2) ** -40, arb(b))
    assert arb(b) <= bound and bound / 2 < arb(b) and bound < arb(b) * arb(1.001)


def test_the_majorant_knows_its_edge():
    assert majorant(arb("0.1"), arb("0.36")) is not None  # 2 sqrt(a) + b = 0.992
    assert majorant(arb("0.1"), arb("0.41")) is None
    assert majorant(arb("0.49"), arb(0)) is not None and majorant(arb("0.51"), arb(0)) is None


@pytest.mark.parametrize("law", [NOTHING, (("3/2", "1/5"),), (("2", "3"),), (("sqrt(2)", "1/10"),), (("1/2", "1/9"),)])
@pytest.mark.parametrize("y0", [1, -1, "0.01"])
def test_the_tail_of_the_expansion(law, y0):
    """Few terms: what they lack is below the tail, which is the majorant's constant times the stretch, no less."""
    d = damping(*law)
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


@pytest.mark.parametrize("law", [NOTHING, (("3/2", "1/5"),), (("2", "3"),)])
def test_a_wrong_guess_of_the_turning_point_is_paid_for(law, monkeypatch):
    """|y_1 - guess| <= |Y - y| with a guess that is off: attained to a few per cent, and so is the time."""
    d, w, off = damping(*law), arb(2) ** -6, arb(2) ** -30
    with ctx.workprec(120):
        there = TurningExpansion.at(d, arb(-1), w)
        y, tau = there.state(w)
        monkeypatch.setattr("asymptotics.flow.secant.secant", lambda *given: arb(-1) + off)
        flow, friction = LinearSpring(d), d.friction
        here = FlowState(arb(0), (y + friction).mid(), w, CarriedErrors(arb(0), arb(0)))
        found = _arrival(flow, arb(1), here)
        assert off <= found.miss and found.miss / 2 < off and found.miss < off * arb(1.2)
        late = abs(found.clock + tau)
        assert found.time.contains(-tau.mid()) and late <= found.late(arb(0)) < off * arb(1.2)


def test_a_guess_beyond_the_place_of_rest_is_undecided(monkeypatch):
    law = damping(("2", "1/10"))
    monkeypatch.setattr("asymptotics.flow.secant.secant", lambda *_: arb(-1))
    found = _arrival(
        LinearSpring(law),
        arb(1),
        FlowState(arb(0), arb("-0.1").mid(), arb("0.01").mid(), CarriedErrors(arb(0), arb(0))),
    )
    with pytest.raises(UndecidedError, match="place of rest"):
        found.late(arb(0))


def test_a_mass_that_leaves_its_turning_point_does_not_turn():
    law = damping(("2", "1/10"))
    assert arrivals.turns_within(law, arb("-0.1"), arb("0.001"), arb(0))
    assert not arrivals.turns_within(law, arb("0.1"), arb("0.001"), arb(0))


def test_errors_of_pieces_add_up():
    """Each piece has at least the error of the one before it and its own, rounding of the restart included."""
    with ctx.workprec(24):
        first, *steps, last = half_swing_pieces(LinearSpring(damping(("3/2", "1/5"))), arb(1), arb(0))
        off = last.expansion.state(last.beside[1])[0] - last.beside[0]
        dropped = [[c.rad() for c in step.taylor.state(step.taylor.length)] for step in steps]
    for step, following_step, (y, w) in zip(steps, steps[1:], dropped, strict=False):
        assert following_step.error >= step.error + following_step.taylor.residual + y + w
    assert last.error >= steps[-1].error + abs(off).lower() and steps[0].error > first.error


def test_a_shifted_orbit_turns_as_much_later_as_the_bound_says():
    """Undamped, an orbit d ahead on its circle turns d/p earlier."""
    p, d = arb(1), arb(2) ** -20
    bound = turning_delay(damping(*NOTHING), arb(1), -p, d, d)
    assert d / p <= bound and bound / 2 < d / p


def test_the_error_of_a_start_reaches_the_turning_point():
    """The enclosure from a start with an error contains the orbits from both of its ends, and half of it does not."""
    law, d = damping(*NOTHING), arb(2) ** -20
    with ctx.workprec(80):
        *_, last = half_swing_pieces(LinearSpring(law), arb("0.5"), arb("0.5"), d)
        *_, high = half_swing_pieces(LinearSpring(law), arb("0.5") + d * arb(0.7), arb("0.5") + d * arb(0.7))
        assert isinstance(last, ArrivalPiece) and isinstance(high, ArrivalPiece)
        apart = abs(high.turn - last.turn)
        assert apart <= last.error and last.error / 2 < apart


@pytest.mark.parametrize("law", [NOTHING, (("1", "1/10"),)])
def test_amplitudes_carry_their_error_by_contraction(law):
    d, error = damping(*law), arb(2) ** -30
    ratio = arb("0.75")
    here = TurningState(3, -1, arb("0.5"), arb(9), error, arb(0))
    there = following(d, here, HalfSwingBalls(ratio, arb(3), "", 1, arb(0)))
    moved = ratio * error  # linear: the ratio is the same for all amplitudes
    assert moved <= there.amplitude_error and there.amplitude_error / 2 < moved
    friction = damping(("0", "1/100"), ("1", "1/10"))
    by_distance = following(friction, here, HalfSwingBalls(ratio, arb(3), "", 1, arb(0)))
    assert by_distance.amplitude_error >= error  # dry friction: relative errors grow, distances do not


def test_radii_of_a_passage_are_kept():
    """What the midpoints drop: the radius of q and that of T."""
    law = damping(("1", "1/10"))
    found = HalfSwingBalls(arb("0.75", arb(2) ** -20), arb(3, arb(2) ** -21), "", 1, arb(0))
    there = following(law, TurningState(0, 1, arb(1), arb(0), arb(0), arb(0)), found)
    assert there.amplitude_error >= arb(2) ** -20 and there.time_error >= arb(2) ** -21


@pytest.mark.parametrize("law", [NOTHING, (("3/2", "1/2"),), (("0", "1/10"), ("2", "1"))])
def test_a_wide_time_near_a_turning_point(law):
    """The states at both ends of the time are contained; the speed in phase space is bounded within a factor of 4."""
    with ctx.workprec(90):
        expansion = TurningExpansion.at(damping(*law), arb("0.75"))
        middle, width = expansion.reach.mid() / 2, arb(2) ** -18
        y, w = at_time(expansion, middle + arb(0, width))
        for end in (middle - width, middle + width):
            exact_y, exact_w = at_time(expansion, end.mid())
            assert y.contains(exact_y) and w.contains(exact_w)
        assert w.rad() < 10 * width
        largest = abs(expansion.y0) + expansion.damping.friction
        assert largest <= expansion.speed(arb(1)) and expansion.speed(arb(1)) < 4 * largest


def test_the_error_of_a_time_becomes_a_distance():
    """Near a turning point of amplitude a the state moves by a |t|."""
    law, late = damping(*NOTHING), arb(2) ** -20
    bound = dense._distance(LinearSpring(law), TurningState(1, -1, arb(2), arb(3), arb(0), late))
    truth = 2 * (2 * (late / 2).sin())
    assert truth <= bound and bound / 2 < truth


def test_an_uncertain_time_widens_the_state():
    law = damping(("2", "1/10"))
    with ctx.workprec(100):
        (low, _), (high, _) = dense.states(LinearSpring(law), arb(1), arb(0), [arb("1.5"), arb("1.5") + arb(2) ** -20])
        ((x, v),) = dense.states(
            LinearSpring(law), arb(1), arb(0), [arb("1.5") + arb(2) ** -21 + arb(0, arb(2) ** -21)]
        )
        assert x.contains(low) and x.contains(high) and x.rad() < 4 * abs(high - low)


def test_a_time_with_more_bits_than_the_work_is_not_rounded():
    law = damping(("2", "1/10"))
    with ctx.workprec(200):
        time = arb(10) ** 6 / 3
    with ctx.workprec(30):
        wanted = dense._Wanted(LinearSpring(law), [time])
        ((first, width),) = wanted.queue
    with ctx.workprec(300):
        assert first <= time and time <= first + width and width < arb(2) ** -170


def test_a_trap_is_announced_inside_its_condition_only():
    law = damping(("1/2", "1"))
    assert trap(law, arb("0.1"), arb("0.001")) == "creeps"
    assert trap(law, arb("0.1"), arb("0.5")) is None and trap(law, arb("-0.1"), arb("0.001")) is None
    edge = (arb(2) / arb("1.5")) ** 2 * arb("0.01")  # (w/c)^(1/2) = y, c^(1/2) = 4/3
    assert trap(law, arb("0.1"), edge * arb("0.999")) == "creeps" and trap(law, arb("0.1"), edge * arb("1.001")) is None
    steep = arb(9) / 96  # c^2 y^2 < 1/6 with c = 16/9
    largest = (arb(1) / 6).sqrt() * 9 / 16
    assert steep < largest
    assert trap(law, largest * arb("0.999"), arb(0)) == "creeps" and trap(law, largest * arb("1.001"), arb(0)) is None
    for text in ("1/3", "2", "7"):  # y^2 < eps^4/6/c^2: at w = 0 the second condition alone
        law, edge = damping(("1/2", text)), (arb(1) / 6).sqrt() * 9 / 16 * parse_real(text, "e").ball() ** 2
        assert trap(law, edge * arb("0.999"), arb(0)) == "creeps" and trap(law, edge * arb("1.001"), arb(0)) is None
    assert trap(damping(("1", "1.99")), arb(1), arb("0.001")) is None
    assert trap(damping(("1", "2")), arb(1), arb("0.999")) == "overdamped"
    assert trap(damping(("1", "2")), arb(1), arb("1.001")) is None


def test_dry_friction_holds_exactly_up_to_itself():
    law = damping(("0", "1/4"), ("2", "1/10"))
    p, e = arb("0.25"), arb(2) ** -40
    assert integrated(law, p).ended == "sticks" and integrated(law, p - e, e).ended == "sticks"
    with ctx.workprec(120):
        assert integrated(law, p + e).ended is None
    with ctx.workprec(60), pytest.raises(UndecidedError):
        integrated(law, p, e)


@pytest.mark.parametrize("side", [1, -1])
def test_a_start_in_motion_and_its_mirror_image(side):
    law, state = damping(("3/2", "1/5")), (arb("0.25"), arb("0.5"))
    with ctx.workprec(80):
        first, other = first_from(LinearSpring(law), *state), first_from(LinearSpring(law), *(side * x for x in state))
        assert first.side == 1 and other.side == side and first.n == other.n == 0
        for a, b in zip(*(islice(sequence(LinearSpring(law), here), 3) for here in (first, other)), strict=True):
            assert (b.n, b.side) == (a.n, side * a.side)
            for name in ("amplitude", "amplitude_error", "time", "time_error"):
                assert getattr(a, name).mid() == getattr(b, name).mid()


def test_a_law_that_is_no_damping_is_refused_as_such():
    with pytest.raises(InputError, match="this half-swing"):
        Damping.of_law(Law({2: "1/10"}, spring="pendulum"))


def test_what_the_pieces_leave_out_is_told_with_the_half_swing(monkeypatch):
    piece = SimpleNamespace(error=arb("1e-5"), ended=None, turn=arb("0.9"), miss=arb("1e-9"), time=arb(3))
    found = half_swing_map.of_arrival(arb(1), arb(0), piece, 3)
    assert found.tail >= arb("9.99e-6") and found.amplitude.contains(arb("-0.9") + arb("0.99e-9"))
    monkeypatch.setattr(
        half_swing_map, "half_swing_pieces", lambda *_, **__: iter([SimpleNamespace(error=arb("1e-5"), ended="held")])
    )
    assert integrated(damping(("2", "1/10")), arb(1)).tail >= arb("9.99e-6")


def test_a_trap_is_asked_for_all_amplitudes_that_may_be(monkeypatch):
    asked = []
    monkeypatch.setattr(LinearSpring, "ended", lambda _self, y, _w: asked.append(y) or "held")
    integrated(damping(("2", "1/10")), arb(1), arb("0.1"))
    assert asked[0].contains(arb("0.901")) and asked[0].contains(arb("1.099"))
