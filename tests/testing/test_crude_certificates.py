"""Certificates of another law or start, so that the error is nearly as large as the motion: what is accepted is true.

The page proves that a turning point is found once however large the error is, if only it is less than V_low.
"""

import random
from fractions import Fraction

import pytest

from asymptotics import turning_points
from asymptotics.certificates.of_results import of_turning_points
from asymptotics.law import Oscillator
from asymptotics.numbers.digits import ends
from asymptotics.testing.check_certificate import RefusedError, follow, piece, shaped
from tests.certificates.truth import oscillator_of
from tests.worlds import worlds_of

LAWS = [
    world.law
    for world in worlds_of(
        "quadratic", "linear", "a sum with dry friction", "dry friction", "another rational power", "a strong cube",
        "a loss next to the critical one",
    ).values()
]  # fmt: skip
EASY = Fraction(1, 3)


def crude(rng):
    """A certificate of few half-swings, with another start and other strengths than its polynomials were made for."""
    law = rng.choice(LAWS)
    made = Oscillator(law, x0=rng.choice(["1", "3/10", "-7/10"]))
    table = turning_points(made, rng.randint(2, 3), digits=3, times=True)
    # Points at exact places, beside dry friction alone, have no certificate.
    content = of_turning_points(made, table).content[0] if table.points else None
    if content is None:
        return None
    size = rng.choice([EASY / 30, EASY / 4, EASY, 1])
    x0 = Fraction(content["start"][0]) * (1 + size * Fraction(rng.randint(-100, 100), 100))
    law = [[a, str(Fraction(e) * (1 + size * Fraction(rng.randint(-90, 90), 100)))] for a, e in content["law"]]
    return {**content, "law": law, "start": [str(x0), "0"], "claims": []}


def what_the_old_condition_asked(content):
    """Whether |y| > D + E/sqrt(k) held at every rest: what the checker asked for before it was proved needless."""
    law = [(Fraction(a), Fraction(e)) for a, e in content["law"]]
    one, E, x, v = 1 << content["bits"], Fraction(0), Fraction(content["start"][0]), Fraction(0)
    for p in content["pieces"]:
        shape = shaped(p, law, content["bits"])
        S, begin, end, defect, low, _ = piece(shape, law, Fraction(1), content["root"], one)
        E += abs(begin[0] - x) + abs(begin[1] - v) + S * defect
        (x, v), place = end, abs(begin[0] if p["kind"] == "leave" else end[0])
        high = 2 * abs(int(p["y"][1][1])) * Fraction(2, one * S) - low
        if p["kind"] != "pass" and not place > E + high * S * E**2 / (2 * low**2):
            return False
    return True


@pytest.mark.parametrize("seed", range(4))
def test_what_is_accepted_of_a_motion_far_off_is_true(seed):
    rng, accepted, newly = random.Random(seed), 0, 0
    for _ in range(18 if seed == 3 else 60):
        content = crude(rng)
        if content is None:
            continue
        try:
            turned, _, stays = follow(content, 1)
        except RefusedError:
            continue
        accepted += 1
        newly += not what_the_old_condition_asked(content)
        table = turning_points(oscillator_of(content), len(turned) + 1, digits=12, times=True)
        if stays:
            assert table.ended == {"n": len(turned) - 1, "reason": "sticks"}
        assert len(table.points) >= len(turned)
        for (x, within, first, last), true in zip(turned, table.points):
            low, high = ends(true.x)
            assert x - within <= high and low <= x + within
            low, high = ends(true.t)
            assert first <= high and low <= last
    assert accepted > 10
    assert newly > 0
