"""The bounds of one half-turn: what is missing to the turning point, the box of a step; a second evaluation of each."""

from math import cos, sin

import pytest
from flint import arb

from asymptotics.law import Law
from asymptotics.limit_cycles.certified import _Field, _picard_box, _to_the_turn
from asymptotics.limit_cycles.series import require_polynomial

VAN_DER_POL = require_polynomial(Law({1: -1, (1, 2): 1}), springs=True)


def test_what_is_missing_to_the_turn_is_bounded_on_its_box():
    """dt = w/g, dx = 2 w dt, dJ = |h_v| dt, with g and h_v at the worst corner of |v| <= 2 w, |x - x_0| <= 4 w."""
    x, w = 1.9, 0.01
    found = _to_the_turn(_Field(VAN_DER_POL, arb(1)), arb(-x), arb(-w), arb(0), arb(3))
    corners = [(-x + a * 4 * w, b * 2 * w) for a in (-1, 1) for b in (-1, 1)]
    g = min(abs(-u - v * (u * u - 1)) for u, v in corners)
    divergence = max(abs(u * u - 1) for u, _ in corners)
    for radius, wanted in ((found.T.rad(), w / g), (found.q.rad(), 2 * w * w / g), (found.J.rad(), divergence * w / g)):
        assert wanted * (1 - 1e-9) <= float(radius) < 1.05 * wanted


@pytest.mark.parametrize(("x", "v"), [(1.9, 0.3), (0.5, 0.2), (1.9, 1.0)])
def test_too_far_from_the_turn_nothing_is_claimed(x, v):
    """|v| must be below a quarter of the least acceleration on the box, or the orbit may leave it."""
    assert _to_the_turn(_Field(VAN_DER_POL, arb("1e-9")), arb(-x), arb(-v), arb(0), arb(3)) is None


def test_the_box_of_a_step_holds_the_whole_step():
    """Without forces x = cos t, v = -sin t: every state of the step is inside, also at its end."""
    field, eta = _Field(VAN_DER_POL, arb(0)), 0.5
    box = _picard_box(field, (arb(1), arb(0), arb(0)), arb(eta))
    for k in range(9):
        t = eta * k / 8
        assert box[0].contains(arb(cos(t))) and box[1].contains(arb(-sin(t)))
    assert box[0].rad() < 0.3 and box[1].rad() < 0.5
