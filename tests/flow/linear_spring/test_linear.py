"""The closed form of linear damping and dry friction: the pieces, which know nothing of it, agree from every start."""

from itertools import islice

import pytest
import sympy
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.flow.damping import Damping
from asymptotics.flow.dense import states, states_from
from asymptotics.flow.linear_spring import linear_spring
from asymptotics.flow.linear_spring.linear import ROUTE, LinearSolution, is_linear
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.sequence import sequence
from asymptotics.flow.trajectory import half_swing_pieces
from asymptotics.flow.turning import at_rest
from asymptotics.law import Law, Oscillator
from asymptotics.motions.reference import reference_motion
from asymptotics.numbers.exact import parse_real
from asymptotics.return_map.panels import Panels
from asymptotics.return_map.sequence import Interpolated
from asymptotics.turning.choose import turning_points
from asymptotics.turning.half_swing import half_swing_result
from tests.flow.forces import by_strength, damping_of
from tests.worlds import STARTS, pairs_of

LAWS = pairs_of(
    "dry friction beside the linear loss", "a loss next to the critical one", "dry friction",
    "dry friction and nearly critical",
)  # fmt: skip


def damping(pairs, bits=200):
    with ctx.workprec(bits):
        return Damping.of([(parse_real(e, "e").ball(), parse_real(a, "a")) for a, e in pairs])


@pytest.mark.parametrize("pairs", LAWS)
@pytest.mark.parametrize("start", STARTS.values(), ids=STARTS)
def test_the_pieces_agree(pairs, start, monkeypatch):
    with ctx.workprec(120):
        law, (u, w) = damping(pairs), (arb(x).mid() for x in start)
        *_, closed = half_swing_pieces(LinearSpring(law), u, w)
        monkeypatch.setattr(linear_spring, "is_linear", lambda given: False)
        *_, pieces = half_swing_pieces(LinearSpring(law), u, w)
        assert abs(closed.turn - pieces.turn) <= pieces.miss + closed.miss and closed.time.overlaps(pieces.time)
        assert closed.miss < arb(2) ** -110 and closed.time.rad() < arb(2) ** -100
        middle = (closed.end / 2).mid()
        (y, v), own = closed.own(middle), next(p for p in half_swing_pieces(LinearSpring(law), u, w) if p.end >= middle)
        near = own.error + arb(2) ** -100
        assert abs(y - own.own(middle)[0]) < near and abs(v - own.own(middle)[1]) < near
    monkeypatch.undo()
    for bits in (8, 16, 40):
        with ctx.workprec(bits):
            *_, low = half_swing_pieces(LinearSpring(damping(pairs, bits)), arb(start[0]).mid(), arb(start[1]).mid())
        with ctx.workprec(200):
            u, w = arb(start[0]).mid(), arb(start[1]).mid()
        if all(x.mid() == y for x, y in zip((u, w), _rounded(start, bits), strict=True)):
            assert arb(low.turn, low.miss).contains(closed.turn) and low.time.contains(closed.time.mid())
        assert low.miss < arb(2) ** (6 - bits)


def _rounded(start, bits):
    with ctx.workprec(bits):
        return [arb(x).mid() for x in start]


def test_every_route_names_the_closed_form():
    law, exact = Law({0: "1/100", 1: "1/10"}), "-0.83592321407668890920"
    table = turning_points(law, 60, 20, times=True)
    assert ROUTE in table.method and table.points[1].x == exact and table.ended == {"n": 14, "reason": "sticks"}
    swing = half_swing_result([parse_real(a, "a") for a in "01"], [parse_real(d, "d") for d in ("1/100", "1/10")], 20)
    assert swing.route == ROUTE and swing.amplitude == exact[1:]
    motion = reference_motion(Oscillator({0: "1/100", 1: "1/10"}), "3", 20)
    assert "closed form" in motion.method and motion.certified
    kicked = turning_points(law, 3, 20, v0="1/2")
    assert "closed form" in kicked.method
    omega = sympy.sqrt(1 - sympy.Rational(1, 400))  # q = (1 - mu) e^(-pi epsilon/(2 omega)) - mu
    q = sympy.Rational(99, 100) * sympy.exp(-sympy.pi / 20 / omega) - sympy.Rational(1, 100)
    assert abs(q.n(40) + sympy.Rational(exact)) < sympy.Float("1e-20", 40)


def test_where_it_does_not_hold():
    assert not is_linear(damping((("1", "2"),))) and is_linear(damping((("1", "1.9999999999"),)))
    assert not is_linear(damping((("1", "1/2"), ("2", "1e-30")))) and not is_linear(damping((("1.0000001", "1/2"),)))
    with pytest.raises(UndecidedError, match="friction"):
        list(half_swing_pieces(LinearSpring(damping((("0", "1/2"),))), arb("0.5"), arb(0)))
    over = turning_points(Law({0: "1/100", 1: 2}), 3, 20)
    assert over.ended == {"n": 0, "reason": "overdamped"} and len(over.points) == 1


def test_at_the_turning_point_the_wrong_friction_is_paid_for():
    """Past its turning the closed form keeps the sign of the friction: 2 mu t off, of which the error counts twice."""
    law, wide = damping((("0", "1/4"),)), arb(2) ** -12
    orbit = LinearSolution(arb(0), arb(1, wide / arb.pi()), arb("0.75"), arb(0))
    with ctx.workprec(100):
        time, _ = orbit.turning()
        late = time.rad()
        (last,) = half_swing_pieces(LinearSpring(law), arb(1), arb(0))
        assert last.error <= 4 * arb("0.25") * last.time.rad() * arb("1.001")
        given = arb(2) ** -90
        (after,) = half_swing_pieces(LinearSpring(law), arb(1), arb(0), given)
        assert after.error >= given + 4 * arb("0.25") * after.time.rad() > given
        gone = abs(orbit.y) * late - (abs(orbit.y) - 2 * arb("0.25")) * late  # the speed it has, and should have
        assert gone <= 4 * arb("0.25") * late and 4 * arb("0.25") * late / 2 <= gone


def test_states_in_one_pass():
    law = damping((("0", "1/50"), ("1", "1/5")))
    times = [arb(k) / 4 for k in range(60)]
    with ctx.workprec(40):
        low = states(LinearSpring(law), arb(1), arb(0), times)
        third = next(islice(sequence(LinearSpring(law), at_rest(arb(1))), 2, None))  # at 2 T: from there on the same
        for a, b in zip(low[26:], states_from(LinearSpring(law), third, times[26:]), strict=True):
            assert a[0].overlaps(b[0]) and a[1].overlaps(b[1]) and b[0].rad() < arb(2) ** -30
    with ctx.workprec(120):
        high = states(LinearSpring(law), arb(1), arb(0), times)
    for a, b in zip(low, high, strict=True):
        assert a[0].contains(b[0]) and a[1].contains(b[1]) and a[0].rad() < arb(2) ** -30


@pytest.mark.parametrize("law", [{"3/2": "1/100"}, {0: "1/900", 2: "1/50"}], ids=str)
def test_states_between_half_swings_that_are_interpolated(law):
    """Late times in a row of 100 half-swings, most of them by panels, against the pieces at more bits."""
    times = [arb(k) * 100 + arb("0.5") for k in (0, 2, 3)]
    found = []
    for bits in (40, 70):
        with ctx.workprec(bits + 40):
            made = Damping.of_law(Law(law))
        with ctx.workprec(bits):
            panels = Panels.alone(Law(law), bits) if bits == 40 else None
            found.append(
                states(LinearSpring(made) if panels is None else Interpolated(made, panels), arb(1), arb(0), times)
            )
            assert panels is None or panels.map.made
    for low, high in zip(*found, strict=True):
        for small, large in zip(low, high, strict=True):
            assert small.contains(large) and small.rad() < arb(2) ** -18


def test_the_closed_form_keeps_its_radii():
    """Of the place at which it turns, and of the friction whose sign is wrong while its time is uncertain."""
    with ctx.workprec(20):
        law = damping_of(("0", "1/7"), ("1", "1/3"))
        (swing,) = half_swing_pieces(LinearSpring(law), arb(1), arb(0))
        time, y = swing.orbit.turning()
        assert swing.miss >= (y + law.friction).rad() > 0
        assert swing.error >= 4 * law.friction * time.rad() * (1 - arb(2) ** -10) > 0
        assert swing.gap(swing.miss) >= 2 * swing.miss


def test_a_closed_half_swing_begins_farther_than_its_error():
    spring = LinearSpring(by_strength(("1/2", "1")))
    with ctx.workprec(60):
        assert spring.closed(arb("0.01"), arb(0), arb("0.001")) is not None
        with pytest.raises(UndecidedError, match="holds the mass here"):
            spring.closed(arb("0.01"), arb(0), arb("0.02"))


def test_a_closed_half_swing_counts_the_friction_after_its_end():
    with ctx.workprec(30):
        law = by_strength(("1/2", "1"), ("1/10", "0"))
        found = LinearSpring(law).closed(arb(1), arb(0), arb(2) ** -10)
        assert found.errors.error >= arb(2) ** -10 + 4 * law.friction * found.clock.rad() * arb("0.999")
        alone = LinearSpring(law).closed(arb(1), arb(0), arb(0))
        assert alone.errors.error >= 4 * law.friction * alone.clock.rad() * arb("0.999") > 0
