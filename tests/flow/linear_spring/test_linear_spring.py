"""Half-swings as enclosures: at low precision they contain what is known at high precision, by routes without balls."""

import tracemalloc
from fractions import Fraction
from itertools import islice

import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.sequence import first_from, sequence
from asymptotics.flow.taylor import GUARD
from asymptotics.flow.trajectory import ArrivalPiece, half_swing_pieces
from asymptotics.flow.turning import at_rest
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_real
from asymptotics.return_map.panels import Panels
from asymptotics.return_map.sequence import Interpolated
from asymptotics.turning.choose import turning_points
from asymptotics.turning.quadratic_duration import duration
from asymptotics.turning.quadratic_map import next_amplitude
from tests.flow.forces import by_strength, damping_of
from tests.worlds import pairs_of

LAWS = pairs_of(
    "as strong as the spring", "another rational power", "a strong power between", "an irrational power",
    "below the linear one", "next to dry friction", "dry friction beside a cube", "a sum of powers",
    "three powers without a common one", "next to no loss",
)  # fmt: skip


def damping(pairs):
    return Damping.of([(parse_real(e, "e").ball(), parse_real(a, "a")) for a, e in pairs])


def landing(pairs, bits, p="1", start=None):
    with ctx.workprec(bits):
        u, w = (arb(1), arb(0)) if start is None else (arb(start[0]), arb(start[1]))
        with ctx.workprec(bits + GUARD):
            law = damping(pairs)
        *_, last = half_swing_pieces(LinearSpring(law), u, w)
        assert isinstance(last, ArrivalPiece)
        return arb(-last.turn, last.miss), last.time


@pytest.mark.parametrize("pairs", LAWS)
def test_a_ladder_of_precisions(pairs):
    """From 16 bits on: the value at 160 bits is contained, and the radius is that of the precision."""
    place, time = landing(pairs, 160)
    for bits in (16, 24, 40, 64, 100):
        low_place, low_time = landing(pairs, bits)
        assert low_place.contains(place) and low_time.contains(time), bits
        assert low_place.rad() < arb(2) ** (12 - bits) and low_time.rad() < arb(2) ** (14 - bits), bits


@pytest.mark.parametrize("start", [(0.5, 0.75), (-0.25, 0.5), (-1, 0.0078125), (1, 0.0009765625)])
def test_a_start_in_the_middle(start):
    place, time = landing((("3/2", "1/4"),), 140, start=start)
    for bits in (30, 60):
        low_place, low_time = landing((("3/2", "1/4"),), bits, start=start)
        assert low_place.contains(place) and low_time.contains(time)
        assert low_place.rad() < arb(2) ** (12 - bits)


@pytest.mark.parametrize("epsilon", ["1/7", "1", "30"])
def test_quadratic_damping_by_lambert_w(epsilon):
    """No code in common: the map by W_0, the duration by quadrature."""
    with ctx.workprec(200):
        p = 2 * parse_real(epsilon, "e").ball()
        q, T = next_amplitude(p), duration(p, next_amplitude(p))
    for bits in (30, 110):
        place, time = landing((("2", epsilon),), bits)
        with ctx.workprec(200):
            assert place.contains(q / p) and time.contains(T)


def test_a_nearby_strength_is_excluded():
    place, time = landing((("2", "1"),), 110)
    near_place, near_time = landing((("2", "1.0000000000000000000000001"),), 110)
    assert not place.overlaps(near_place) and not time.overlaps(near_time)


def test_errors_only_add():
    """30 half-swings of three laws at 60 bits contain the orbit at 180 bits, and lose no more than log2(n) bits."""
    for pairs in ((("3/2", "1/5"),), (("1", "1/20"), ("2", "1/5")), (("3", "2"),)):
        found = []
        for bits in (60, 180):
            with ctx.workprec(bits):
                points = sequence(LinearSpring(damping(pairs)), at_rest(arb(1)))
                found.append([next(points) for _ in range(12)])
        for low, high in zip(*found):
            with ctx.workprec(180):
                assert low.x.contains(high.x) and low.tau.contains(high.tau)
                assert low.x.rad() <= abs(high.x) * 60 * arb(2) ** -60 * 16
                assert low.tau.rad() <= 60 * 60 * arb(2) ** -60 * 16


def test_near_a_separatrix_the_precision_rises_until_it_is_decided():
    """alpha = 1/2: delta_0 = 0.83708879743... is known to 11 digits only; then it is a matter of bits, not of luck."""
    law = Law({"1/2": "0.83708879743"})
    table = turning_points(law, 3, 10)
    assert table.certified and table.ended == {"n": 1, "reason": "creeps"}
    assert Fraction(table.points[1].x) == pytest.approx(-2.834442194e-12, rel=1e-9)
    with ctx.workprec(110):
        low = damping((("1/2", "0.83708879743"),))
    with pytest.raises(UndecidedError, match="separatrix|place of rest|undecided"), ctx.workprec(30):
        list(sequence(LinearSpring(low), at_rest(arb(1))))


def test_exponents_at_the_rims():
    """Near 0 it is dry friction, near 1 linear damping, near each other one law; far above, N hardly acts."""
    near = {"1e-20": ("0", "1/10"), "1.00000000000000000001": ("1", "1/10")}
    for alpha, (limit, epsilon) in near.items():
        a, b = (turning_points(Law({x: epsilon}), 2, 15).points[1].x for x in (alpha, limit))
        assert abs(Fraction(a) - Fraction(b)) <= Fraction(1, 10**14)
    pair = turning_points(Law({"3/2": "1/10", "1.50000000000000000001": "1/10"}), 2, 15).points[1].x
    assert abs(Fraction(pair) - Fraction(turning_points(Law({"3/2": "1/5"}), 2, 15).points[1].x)) <= Fraction(1, 10**14)
    assert Fraction(turning_points(Law({1000: "1/1000"}), 2, 10).points[1].x) < Fraction(-99, 100)


@pytest.mark.slow
@pytest.mark.parametrize("pairs", [(("1", "1/2000"), ("2", "1/5")), (("3/2", "1/5"),), (("1/3", "1/200000"),)], ids=str)
def test_a_long_sequence_loses_nothing_and_memory_stays_flat(pairs):
    """10^4 half-swings at 30 digits: log2(10^4) bits are lost, checked against the orbit at 60 digits.

    A chain of balls would lose digits at every one.  The second half needs no more memory than the first.
    """
    law, count, ends = Law(dict(pairs)), 10_000, []
    for bits in (130, 210):
        with ctx.workprec(bits + GUARD):
            d = damping(pairs)
        with ctx.workprec(bits):
            for here in sequence(Interpolated(d, Panels.alone(law, bits), count), at_rest(arb(1))):
                if here.n == 100:  # the panel is made: watching is slow
                    tracemalloc.start()
                if here.n == count // 2:
                    half = tracemalloc.get_traced_memory()[0]
                if here.n == count:
                    break
        full = tracemalloc.get_traced_memory()[0]
        tracemalloc.stop()
        assert full < half + 10**6
        ends.append(here)
    low, high = ends
    assert low.ended is None and low.x.contains(high.x) and low.tau.contains(high.tau)
    assert low.amplitude_error < low.amplitude * arb(10) ** -30 and low.time_error < arb(10) ** -27


@pytest.mark.parametrize("side", [1, -1])
def test_a_start_in_motion_and_its_mirror_image(side):
    law, state = damping_of(("3/2", "1/5")), (arb("0.25"), arb("0.5"))
    with ctx.workprec(80):
        first, other = first_from(LinearSpring(law), *state), first_from(LinearSpring(law), *(side * x for x in state))
        assert first.side == 1 and other.side == side and first.n == other.n == 0
        for a, b in zip(*(islice(sequence(LinearSpring(law), here), 3) for here in (first, other)), strict=True):
            assert (b.n, b.side) == (a.n, side * a.side)
            for name in ("amplitude", "amplitude_error", "time", "time_error"):
                assert getattr(a, name).mid() == getattr(b, name).mid()


def test_at_the_exponent_1_a_next_turning_point_is_not_promised():
    assert LinearSpring(by_strength(("1/2", "3/2"))).endless and not LinearSpring(by_strength(("3", "1"))).endless
    assert not LinearSpring(by_strength(("3", "1"), ("1/2", "3/2"))).endless
