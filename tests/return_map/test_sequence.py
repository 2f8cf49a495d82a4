"""From one amplitude to the next by a half-swing that is known: what is carried, and the radii that are kept."""

import pytest
from flint import arb, ctx

from asymptotics.flow.turning import TurningState
from asymptotics.return_map.half_swing_map import HalfSwingBalls
from asymptotics.return_map.sequence import following
from tests.flow.forces import NOTHING, by_strength, damping_of


@pytest.mark.parametrize("law", [NOTHING, (("1", "1/10"),)])
def test_amplitudes_carry_their_error_by_contraction(law):
    d, error = damping_of(*law), arb(2) ** -30
    ratio = arb("0.75")
    here = TurningState(3, -1, arb("0.5"), arb(9), error, arb(0))
    there = following(d, here, HalfSwingBalls(ratio, arb(3), "", 1, arb(0)))
    moved = ratio * error  # linear: the ratio is the same for all amplitudes
    assert moved <= there.amplitude_error and there.amplitude_error / 2 < moved
    friction = damping_of(("0", "1/100"), ("1", "1/10"))
    by_distance = following(friction, here, HalfSwingBalls(ratio, arb(3), "", 1, arb(0)))
    assert by_distance.amplitude_error >= error  # dry friction: relative errors grow, distances do not


def test_radii_of_a_half_swing_are_kept():
    """What the midpoints drop: the radius of q and that of T."""
    law = damping_of(("1", "1/10"))
    found = HalfSwingBalls(arb("0.75", arb(2) ** -20), arb(3, arb(2) ** -21), "", 1, arb(0))
    there = following(law, TurningState(0, 1, arb(1), arb(0), arb(0), arb(0)), found)
    assert there.amplitude_error >= arb(2) ** -20 and there.time_error >= arb(2) ** -21


def test_a_half_swing_read_off_carries_the_ratio_of_its_error():
    """Linear damping: q e/p, exactly."""
    with ctx.workprec(60):
        law, e, ratio = by_strength(("1/2", "1")), arb(2) ** -10, arb("0.5")
        here = TurningState(0, 1, arb(1), arb(0), e, arb(0))
        there = following(law, here, HalfSwingBalls(ratio, arb(3), "panels", 1, arb(0)))
        assert e * ratio <= there.amplitude_error < e * ratio * arb("1.01")
