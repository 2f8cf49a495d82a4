"""What a jump adds to the radii of points and turning points."""

from flint import arb

from asymptotics.flow.turning import TurningState
from asymptotics.turning import jump, table


def test_points_and_turning_points_keep_their_radii():
    here = TurningState(7, -1, arb("0.5"), arb(9), arb(2) ** -10, arb(2) ** -8)
    log = jump._log(here)
    assert all(log.contains((here.amplitude + side * here.amplitude_error).log().mid()) for side in (-1, 1))
    there = jump._arrived(here, 10, arb(-1, arb(2) ** -10), arb(9, arb(2) ** -8))
    assert (there.n, there.side) == (10, 1) and jump._arrived(here, 11, arb(0), arb(0)).side == -1
    assert all(there.x.contains((arb(-1) + side * arb(2) ** -10).exp().mid()) for side in (-1, 1))
    assert there.time_error >= arb(2) ** -8
    size = table.size(here)
    assert all(size.contains(here.amplitude + side * here.amplitude_error) for side in (-1, 1))
