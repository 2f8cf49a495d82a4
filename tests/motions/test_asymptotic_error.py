"""The printed error of an expansion covers the true one, on random motions of all kinds.

The default cases are held against an integrator of this file (SciPy, half-swing by half-swing with the sign of the
velocity fixed, sticking included), which shares nothing with the package; the slow ones against the reference.
"""

from fractions import Fraction
from random import Random

import pytest
from scipy.integrate import solve_ivp

from asymptotics.errors import InputError
from asymptotics.law import Oscillator
from asymptotics.motions.asymptotic import AsymptoticMotion
from asymptotics.motions.reference import reference_motion

SOFT = [*map(Fraction, (0, 0, 0, 1, 2, 3)), *(Fraction(n, 10) for n in range(15, 51, 7))]
ALL = [*SOFT, *(Fraction(n, 10) for n in range(1, 10, 2))]  # creep is too stiff for the integrator in doubles
SLACK = 1e-8  # what the integrator in doubles may be wrong by


def integrated(law: dict[Fraction, Fraction], x: float, v: float, time: float) -> float:
    """x(time) for x'' + x + sum_i eps_i |v|^alpha_i sgn v = 0."""
    friction, now = float(law.get(Fraction(0), 0)), 0.0
    terms = [(float(a), float(e)) for a, e in law.items() if a]
    while True:
        if v == 0 and abs(x) <= friction + 1e-12:
            return x
        sign = (1.0 if v > 0 else -1.0) if v else (-1.0 if x > 0 else 1.0)

        def force(_, y, sign=sign):
            speed = max(sign * y[1], 0.0)
            return [y[1], -y[0] - sign * (friction + sum(e * speed**a for a, e in terms))]

        def turns(_, y, sign=sign):
            return sign * y[1]

        turns.terminal, turns.direction = True, -1
        found = solve_ivp(force, (now, time), [x, v], "DOP853", rtol=1e-10, atol=1e-13, events=turns, max_step=0.5)
        if found.status == 0:
            return float(found.y[0, -1])
        now, x, v = float(found.t_events[0][0]), float(found.y_events[0][0][0]), 0.0
        if abs(x) < 1e-12:
            return x


def case(seed: int, swings: int, exponents: list[Fraction]) -> tuple[dict[Fraction, Fraction], *tuple[Fraction, ...]]:
    """alpha in [0, 5], up to two laws, eps from 0.01 to 2 (log-uniform), v0 != 0 in half the cases, t to 30/eps."""
    random = Random(seed)
    law = {random.choice(exponents): Fraction(round(1000 * 10 ** random.uniform(-2, 0.3)), 1000) for _ in range(2)}
    if len(law) > 1 and random.random() < 0.6:
        law.popitem()
    x0 = Fraction(random.randint(-10, 10), 10)
    v0 = random.choice([Fraction(0), Fraction(random.randint(-10, 10), 10)])
    latest = min(30 / float(max(law.values())), 3.2 * swings)
    time = Fraction(round(1000 * random.uniform(0, latest)), 1000)
    return law, x0 if x0 or v0 else Fraction(1), v0, time, random.randint(1, 3)


def assert_covered(seed: int, swings: int, certified: bool) -> None:
    law, x0, v0, time, order = case(seed, swings, ALL if certified else SOFT)
    oscillator = Oscillator(law, x0=x0, v0=v0)
    told = f"{oscillator} at {time}, order {order}"
    try:
        found = AsymptoticMotion.of(oscillator, order).at(time, 10)
    except InputError as refused:  # the series has no value there, and says so
        assert refused.argument == "order", told
        return
    if certified:
        exact = float(reference_motion(oscillator, time, 12, max_seconds=600).x)
    else:
        exact = integrated(law, float(x0), float(v0), float(time))
    assert abs(float(found.x) - exact) <= float(found.error) + SLACK, f"{told}: {found} against {exact}"
    if float(sum(e.mid() for e in oscillator.epsilons())) > 1 and any(law):
        assert any("not small" in note for note in found.notes), told


@pytest.mark.parametrize("seed", range(40))
def test_the_error_is_at_most_the_printed_one(seed):
    assert_covered(seed, swings=15, certified=False)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(1000, 1500))
def test_the_error_is_at_most_the_printed_one_at_length(seed):
    assert_covered(seed, swings=1000, certified=True)
