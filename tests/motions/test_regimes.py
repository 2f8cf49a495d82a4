"""The regimes: creep after finitely many swings for alpha < 1, slow starts but never overdamping for alpha > 1."""

from fractions import Fraction

import pytest
from flint import arb, ctx

from asymptotics.law import Law, Oscillator
from asymptotics.motions.reference import reference_states
from asymptotics.numbers.exact import ExactReal
from asymptotics.turning.choose import turning_points


def states(epsilon: str, alpha: str, times: list[int]) -> list[float]:
    oscillator = Oscillator(Law({alpha: epsilon}), mass=1, stiffness=1, x0=1)
    found = reference_states(oscillator, [ExactReal(Fraction(t)) for t in times], 10)
    return [float(x.mid()) for x in found.x]


@pytest.mark.parametrize("alpha", ["1/2", "1/3"])
def test_creep_follows_its_law(alpha):
    # X = -eps X'|X'|^(alpha-1) alone: |X'| = (X/eps)^(1/alpha), so with a = alpha/(1-alpha)
    # X ~ a^a eps^(1/(1-alpha)) tau^(-a).  The ratio to the law tends to one from below like 1 - O(1/tau).
    a = float(Fraction(alpha)) / (1 - float(Fraction(alpha)))
    times = [20, 40]
    ratios = [x / (a**a * t**-a) for x, t in zip(states("1", alpha, times), times)]
    assert 0.5 < ratios[0] < ratios[1] < 1.1
    assert abs(ratios[1] - 1) < 0.15
    assert abs(states("1", alpha, [40])[0] / (2 * a**a * 40**-a) - 1) > 0.3  # twice the law is refuted


@pytest.mark.parametrize(("alpha", "epsilon"), [("2", "100"), ("3", "100"), ("3/2", "10")])
def test_alpha_above_one_is_never_overdamped(alpha, epsilon):
    # However strong the damping, the mass passes the equilibrium: there is a next turning point, on the other side.
    table = turning_points(Law({alpha: epsilon}), 3, 10, times=True)
    assert table.ended is None
    assert [p.x.startswith("-") for p in table.points] == [False, True, False]


def test_strong_quadratic_drag_creeps_at_first():
    # eps = 100: the first half-swing lasts sqrt(2) (sqrt(y) + log(2)/sqrt(y) + ...), y = 1 + 200, not about pi.
    table = turning_points(Law({"2": "100"}), 3, 10, times=True)
    first, second = (float(p.tau) for p in table.points[1:])
    with ctx.workprec(60):
        expected = arb(402).sqrt() + arb(2).log() * (arb(2) / 201).sqrt()
    assert abs(first - float(expected.mid())) < 0.001
    assert 3.1 < second - first < 3.6
