"""Traps of sums, of what falls from far above, and of exponents near 0: up to their edges, and beside an integrator."""

from fractions import Fraction
from math import exp, log, sqrt
from random import Random

import pytest
from flint import arb
from scipy.integrate import solve_ivp

from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.trapping_regions import _together, trap
from asymptotics.numbers.exact import ExactReal, parse_real
from tests.flow.forces import damping_of


def damping(*terms):
    return Damping.of([(arb(e), ExactReal(Fraction(a))) for a, e in terms])


def edge_of(traps, low, high):
    """The place between where a trap ends."""
    assert traps(low) and not traps(high)
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if traps(middle) else (low, middle)
    return low


def test_terms_of_lower_exponents_count_together():
    law = damping(("1/1000", "0.2"), ("1/500", "0.2"), ("1/2", "0.1"))

    def lacking(y):
        """ln of c^2 y^(2/a-2) (2-a)/a^2 E^(-2/a), a = 1/500, E = e_1 y^(a_1-a) + e_2: w = 0, so V = y."""
        a, E = 1 / 500, 0.2 * y**-0.001 + 0.2
        return (2 / a) * log(2 / (2 - a)) + (2 / a - 2) * log(y) + log((2 - a) / a**2) - (2 / a) * log(E)

    edge = edge_of(lambda y: trap(law, arb(y), arb(0)) == "creeps", 0.3, 0.42)
    assert edge_of(lambda y: lacking(y) < 0, 0.3, 0.42) == pytest.approx(edge, rel=1e-12)
    assert 0.39 < edge < 0.4
    assert trap(damping(("1/1000", "0.2")), arb("0.3"), arb(0)) is None
    assert trap(damping(("1/1000", "0.2"), ("3/2", "0.2")), arb("0.3"), arb(0)) is None


def test_what_falls_from_above_is_told_up_to_half_of_the_displacement():
    for a, e, y in ((0.001, "1", 0.5), (0.25, "4", 0.1)):
        law = damping((Fraction(a), e))
        low = a * y / (2 * sqrt(8 * (2 - a)))
        edge = sqrt(y / 2 * (float(e) * low**a - y))
        assert trap(law, arb(y), arb(edge * 0.999)) == "creeps" and trap(law, arb(y), arb(edge * 1.001)) is None
        end = fall([(a, float(e))], y, edge, low)
        assert y / 2 < end[0] < y


def fall(terms, y, w, low):
    """(y, w) where the speed has fallen to ``low``."""
    slope = lambda _, s: [-s[1], s[0] - sum(e * max(s[1], 1e-300) ** a for a, e in terms)]  # noqa: E731
    slow = lambda _, s: s[1] - low  # noqa: E731
    slow.terminal, slow.direction = True, -1
    end = solve_ivp(slope, (0, 10), [y, w], "DOP853", events=slow, rtol=1e-10, atol=1e-14)
    return end.y_events[0][0]


def test_no_orbit_leaves_a_trap():
    """In y and ln w, where the equations are smooth."""
    random, told = Random(7), 0
    while told < 12:
        terms = [(Fraction(random.randint(20, 90), 100), round(random.uniform(0.1, 3), 3)) for _ in range(2)]
        y, w = random.uniform(0.01, 1), random.uniform(0.1, 1) ** 3
        if trap(damping(*terms), arb(y), arb(w)) != "creeps":
            continue
        told += 1
        end = solve_ivp(in_logarithm, (0, 5), [y, log(w)], "Radau", rtol=1e-6, atol=1e-9, args=(terms,))
        assert end.success and end.y[0, -1] > 0


def in_logarithm(_, state, terms):
    w = exp(state[1])
    return [-w, (state[0] - sum(e * w ** float(a) for a, e in terms)) / w]


@pytest.mark.parametrize("k", [3, 10, 30, 300])
def test_an_exponent_of_any_size_is_decided_in_few_bits(k):
    law = damping((Fraction(1, 10**k), "1.01"))
    assert trap(law, arb(1), arb(0)) == "creeps" and trap(law, arb("1.02"), arb(0)) is None
    assert trap(law, arb("0.3"), arb("0.3")) == "creeps"


def test_no_exponent_from_1_on_creeps():
    """The condition of the trap alone would hold at alpha = 3/2, where nothing traps."""
    for law in (damping((Fraction(3, 2), 10)), damping((Fraction(3, 2), 10), (Fraction(5, 4), "0.1"))):
        assert trap(law, arb(1), arb(0)) is None and law.least_power == 1
    assert damping((Fraction(1, 2), 10), (Fraction(3, 2), 1)).least_power == arb(1) / 2


def test_a_trap_is_announced_inside_its_condition_only():
    law = damping_of(("1/2", "1"))
    assert trap(law, arb("0.1"), arb("0.001")) == "creeps"
    assert trap(law, arb("0.1"), arb("0.5")) is None and trap(law, arb("-0.1"), arb("0.001")) is None
    edge = (arb(2) / arb("1.5")) ** 2 * arb("0.01")  # (w/c)^(1/2) = y, c^(1/2) = 4/3
    assert trap(law, arb("0.1"), edge * arb("0.999")) == "creeps" and trap(law, arb("0.1"), edge * arb("1.001")) is None
    steep = arb(9) / 96  # c^2 y^2 < 1/6 with c = 16/9
    largest = (arb(1) / 6).sqrt() * 9 / 16
    assert steep < largest
    assert trap(law, largest * arb("0.999"), arb(0)) == "creeps" and trap(law, largest * arb("1.001"), arb(0)) is None
    for text in ("1/3", "2", "7"):  # y^2 < eps^4/6/c^2: at w = 0 the second condition alone
        law, edge = damping_of(("1/2", text)), (arb(1) / 6).sqrt() * 9 / 16 * parse_real(text, "e").ball() ** 2
        assert trap(law, edge * arb("0.999"), arb(0)) == "creeps" and trap(law, edge * arb("1.001"), arb(0)) is None
    assert trap(damping_of(("1", "1.99")), arb(1), arb("0.001")) is None
    assert trap(damping_of(("1", "2")), arb(1), arb("0.999")) == "overdamped"
    assert trap(damping_of(("1", "2")), arb(1), arb("1.001")) is None


def test_only_terms_up_to_alpha_help_to_trap():
    """At small speeds w^3 is nothing beside w^(1/2); w^(1/4) is more, by fastest^(-1/4) at least."""
    law = damping_of(("1/4", "1/5"), ("1/2", "1/5"), ("3", "10"))
    found = float(_together(law, law.alphas[1], law.exponents[1], arb("0.0625")))
    assert found == pytest.approx(0.2 + 0.2 * 2, rel=1e-9)
