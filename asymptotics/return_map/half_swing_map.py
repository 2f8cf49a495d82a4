"""From one turning point to the next: the half-swing as a map and a duration, by whichever route is cheapest.

On the section v = 0 the map is the return map of Poincare, reflected, as sides alternate (Guckenheimer and Holmes 1983,
section 1.5).

>>> from fractions import Fraction
>>> from flint import ctx
>>> from asymptotics.numbers.exact import ExactReal
>>> with ctx.workprec(100):
...     quadratic = Damping.of([(arb(1), ExactReal(Fraction(2)))])
...     found = integrated(quadratic, arb(1))
>>> found.amplitude.str(20), found.duration.str(20), found.route
('[0.41071968606103944670 +/- ...]', '[3.3809710603589252128 +/- ...]', 'local expansions and Taylor steps')
"""

from dataclasses import dataclass

from flint import arb

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import upper
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.linear import ROUTE as CLOSED
from asymptotics.flow.linear_spring.linear_spring import LinearPiece, LinearSpring
from asymptotics.flow.sequence import STICKS
from asymptotics.flow.trajectory import MAX_PIECES, ArrivedPiece, half_swing_pieces

INTEGRATED = "local expansions and Taylor steps"
ROUTE = "Chebyshev interpolation in the amplitude"


@dataclass(frozen=True)
class HalfSwingBalls:
    """A half-swing from the amplitude p: ``amplitude`` encloses q/p, ``duration`` its time.

    ``route``: how; ``terms``: Taylor pieces, or terms of the series; ``tail``: what was left out, in units of p.
    ``ended``: why there is no next turning point (then the enclosures are None).
    """

    amplitude: arb | None
    duration: arb | None
    route: str
    terms: int
    tail: arb
    ended: str | None = None


def integrated(damping: Damping, p: arb, error: arb | None = None, *, pieces: int = MAX_PIECES) -> HalfSwingBalls:
    """The half-swing from rest at the exact amplitude p, by pieces.

    With ``error``: whether it turns or ends holds for all amplitudes within that distance of p, or is undecided
    (UndecidedError); the enclosures are those of p itself.
    """
    error = arb(0) if error is None else error
    # Held at every amplitude within the error; a tie in between is for the departure to find undecided.
    if p + error <= damping.friction:
        return HalfSwingBalls(None, None, INTEGRATED, 0, arb(0), STICKS)
    flow = LinearSpring(damping)
    # A trap that holds all of them, before anything is integrated.
    reason = flow.ended(p - damping.friction + arb(0, error), arb(0))
    if reason is not None:
        return HalfSwingBalls(None, None, INTEGRATED, 0, arb(0), reason)
    for count, piece in enumerate(half_swing_pieces(flow, p, arb(0), error, pieces=pieces), start=1):
        if piece.ended is not None:
            return HalfSwingBalls(None, None, INTEGRATED, count, upper((piece.error - error) / p), piece.ended)
        if isinstance(piece, ArrivedPiece):
            return of_arrival(p, error, piece, count)
    raise UndecidedError("the half-swing has no end")


def of_arrival(p: arb, error: arb, piece: ArrivedPiece, count: int) -> HalfSwingBalls:
    """The half-swing whose last piece is known; ``error`` was the distance allowed at its start."""
    # ``piece.error`` began with the error allowed for; what the pieces added is their own.
    tail = upper((piece.error - error) / p)
    route = CLOSED if isinstance(piece, LinearPiece) else INTEGRATED
    return HalfSwingBalls(arb(-piece.turn, piece.miss) / p, piece.time, route, count, tail)
