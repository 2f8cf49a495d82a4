"""Where nearby motions turn, and what a loss that is steep at rest, 0 <= alpha < 1, does to their difference there.

Of all motions within a distance of the trial orbit each turns once, within ``delay`` of it, where the pull towards the
other side, |f cos(theta) - k x|, is more than dry friction and what the other losses take at their speeds there.  With
the pull P, dry friction c, the rest of the losses g at most, S = 2 P_low - g, a turn takes of the half square of the
distance no less than ``mass`` times mu V^2 when the first of two motions turns, and what dry friction adds to
sqrt(mu) V is sqrt(4 c/S) of the root of what it takes at most:

    mass = c S/(P_high + c + g)^2.

Derivation ``driven-unique``.
"""

from dataclasses import dataclass

from flint import arb

from asymptotics.driven.drive import Balls
from asymptotics.driven.expansion import Arc
from asymptotics.driven.trial import Trial
from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import upper


def is_steep(balls: Balls) -> bool:
    """Whether a loss is steep at rest, for which the contraction counts a turn."""
    if not all(a >= 1 or a < 1 for _, a in balls.losses):
        raise UndecidedError("it is not decided whether an exponent is below 1")
    return any(a < 1 for _, a in balls.losses)


@dataclass(frozen=True)
class Turn:
    """``pull``, and ``speed`` at most, within two ``delay`` of the turn; ``mass``: its part of the contraction;
    ``high``: of the integral of the slopes."""

    delay: arb
    speed: arb
    pull: arb
    mass: arb
    high: arb


def turn(trial: Trial, room: arb) -> Turn:
    """For all motions within ``room``; UndecidedError where one may stick, or turn elsewhere."""
    balls, ends = trial.balls, (trial.pieces[0], trial.pieces[-1])
    of_x, of_v = room / balls.k.sqrt(), room / balls.mu.sqrt()
    rises = [p.ws[0] * (1 - p.growth) for p in ends]
    delay = max(upper(of_v / rise) for rise in rises)
    if not all(p.ws[0] * (1 - p.growth) > of_v for p in trial.pieces[1:-1]):
        raise UndecidedError("the trial orbit is not near enough to tell that no motion turns between its turns")
    if not all(2 * delay < p.length for p in ends):
        raise UndecidedError("the trial orbit is not near enough to tell where the motions beside it turn")
    speed = max(upper(2 * delay * p.ws[0] * (1 + p.growth) + of_v) for p in ends)
    angle, place = trial.theta + arb(0, 2 * delay), trial.X + arb(0, of_x + 2 * delay * speed)
    pull = ends[0].sign * (balls.f * angle.cos() - balls.k * place)
    low, high = pull.lower(), pull.upper()
    dry = sum((c for c, a in balls.losses if a == 0), arb(0))
    rest = sum((c * speed**a for c, a in balls.losses if a != 0), arb(0))
    if not low > dry + rest:
        raise UndecidedError("it is not decided that no motion beside the trial orbit sticks where it turns")
    both = 2 * low - rest
    steep = _steep(balls, ends, rises, delay, (low - dry - rest) / balls.mu)
    return Turn(delay, speed, pull, dry * both / (high + dry + rest) ** 2, 4 * dry / both + steep)


def _steep(balls: Balls, ends: tuple[Arc, Arc], rises: list[arb], delay: arb, least: arb) -> arb:
    """int a over the pieces beside the turn, of the terms 0 < alpha < 1.

    Within two delays, where a motion has the speed least |t - t_1| at least, a quotient of differences is at most
    2^(1-alpha) times the larger speed to the power alpha - 1; beyond, both are faster than half of the trial orbit.
    """
    total = arb(0)
    for c, a in balls.losses:
        if a == 0 or a >= 1:
            continue
        total += c / balls.mu * (least / 2) ** (a - 1) * 2 * (3 * delay) ** a / a
        for p, rise in zip(ends, rises):
            total += c / balls.mu * (rise / 2) ** (a - 1) * p.length**a
    return total
