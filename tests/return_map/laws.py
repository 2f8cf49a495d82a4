"""The coordinates of laws that are written as (exponent, strength), and their half-swings by pieces."""

from flint import ctx

from asymptotics.flow.damping import Damping
from asymptotics.numbers.exact import parse_real
from asymptotics.return_map.coordinate import Coordinate
from asymptotics.return_map.half_swing_map import integrated

LAWS = [
    ((("3/2", "1/5"),), 0.0, 0.75, 3.0),
    ((("1", "1/20"), ("2", "1/5")), 0.0, 0.5, 4.0),
    ((("2", "1/10"), ("3", "1/30")), 0.0, 0.5, 3.0),
    ((("1/2", "1/100"),), 0.25, 1.0, 8.0),
    ((("0", "1/500"), ("1", "1/50"), ("2", "1/10")), 0.25, 0.5, 2.5),
    ((("sqrt(2)", "1/20"), ("2", "1/20")), 0.25, 0.5, 3.0),
    ((("0", "1/1000"),), 0.5, 1.0, 8.0),
    ((("1", "1/7"),), 0.0, 1.0, 1e6),
]


def coordinate(pairs):
    with ctx.workprec(300):
        return Coordinate.of([(parse_real(e, "e").ball(), parse_real(a, "a")) for a, e in pairs])


def by_pieces(pairs, p, bits):
    with ctx.workprec(bits + 40):
        law = Damping.of([(parse_real(e, "e").ball(), parse_real(a, "a")) for a, e in pairs])
    with ctx.workprec(bits):
        return integrated(law, p)
