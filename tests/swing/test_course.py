"""Half-swings as enclosures: at low precision they contain what is known at high precision, by routes without balls."""

import pytest
from flint import arb, ctx

from asymptotics.numbers.exact import parse_real
from asymptotics.swing.course import Landing, course
from asymptotics.swing.damping import Damping
from asymptotics.swing.sequence import sequence
from asymptotics.swing.taylor import GUARD
from asymptotics.turning.quadratic_duration import duration
from asymptotics.turning.quadratic_map import next_amplitude

LAWS = [
    (("2", "1"),),
    (("3/2", "1/10"),),
    (("3/2", "5"),),
    (("sqrt(2)", "1/5"),),
    (("1/2", "1/4"),),
    (("1/100", "1/3"),),
    (("0", "1/30"), ("3", "1")),
    (("1", "1/20"), ("2", "1/5")),
    (("1/2", "1/10"), ("sqrt(3)", "1/10"), ("7/3", "1/3")),
    (("3", "1e-300"),),
]


def damping(pairs):
    return Damping.of([(parse_real(e, "e").ball(), parse_real(a, "a")) for a, e in pairs])


def landing(pairs, bits, p="1", start=None):
    with ctx.workprec(bits):
        u, w = (arb(1), arb(0)) if start is None else (arb(start[0]), arb(start[1]))
        with ctx.workprec(bits + GUARD):
            law = damping(pairs)
        *_, last = course(law, u, w)
    assert isinstance(last, Landing)
    return arb(last.turn, last.miss), last.time


@pytest.mark.parametrize("pairs", LAWS, ids=str)
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
                points = sequence(damping(pairs))
                found.append([next(points) for _ in range(12)])
        for low, high in zip(*found):
            with ctx.workprec(180):
                assert low.x.contains(high.x) and low.tau.contains(high.tau)
                assert low.x.rad() <= abs(high.x) * 60 * arb(2) ** -60 * 16
                assert low.tau.rad() <= 60 * 60 * arb(2) ** -60 * 16
