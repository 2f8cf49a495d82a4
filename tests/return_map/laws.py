"""Worlds of the return map, the coordinates of laws that are (exponent, strength), their half-swings by pieces."""

import pytest
from flint import ctx

from asymptotics.flow.damping import Damping
from asymptotics.numbers.exact import parse_real
from asymptotics.return_map.coordinate import Coordinate
from asymptotics.return_map.half_swing_map import integrated
from tests.worlds import WORLDS

PLACES = {  # worlds with the ends of an interval of the coordinate, and how far beyond it a map is known
    "another rational power": (0.0, 0.75, 3.0),
    "a sum of powers": (0.0, 0.5, 4.0),
    "two powers above one": (0.0, 0.5, 3.0),
    "a weak root": (0.25, 1.0, 8.0),
    "three weak powers": (0.25, 0.5, 2.5),
    "a sum with an irrational power": (0.25, 0.5, 3.0),
    "weak dry friction": (0.5, 1.0, 8.0),
    "linear": (0.0, 1.0, 1e6),
}


def placed_worlds(*names):
    """(pairs, low, high, stretch) for ``parametrize``, of all worlds or of these."""
    return [pytest.param(WORLDS[name].pairs, *PLACES[name], id=name) for name in names or PLACES]


def coordinate(pairs):
    with ctx.workprec(300):
        return Coordinate.of([(parse_real(e, "e").ball(), parse_real(a, "a")) for a, e in pairs])


def by_pieces(pairs, p, bits):
    with ctx.workprec(bits + 40):
        law = Damping.of([(parse_real(e, "e").ball(), parse_real(a, "a")) for a, e in pairs])
    with ctx.workprec(bits):
        return integrated(law, p)
