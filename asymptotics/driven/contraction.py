"""How a period, or half of one, draws motions together beside a trial orbit: all motions within a distance of it.

The difference (X, V) of two motions obeys mu V' + k X + g(theta) V = 0, X' = V, with a quotient of differences g that
is a slope of the losses at a speed between the two, so between lower and upper bounds along the orbit.  With a = g/mu
and the norm |z|^2 = k X^2 + mu V^2, nu^2 = k/mu, over an interval

    |z(end)|^2 <= (1 - 2 lambda/(1 + sqrt(I G))^2) |z(0)|^2,    I = int a_low, G = int a_high,
    lambda = (I - |int a_low e^(2 i nu theta)|)/2.

Where a loss is steep at rest the integrals have a part of each turn (``turn``), and the interval is a period, which
begins in motion: with dry friction alone a difference that is at rest at one turn is not so at the next one.

Derivation ``driven-unique``.
"""

from flint import acb, arb

from asymptotics.driven.drive import Balls
from asymptotics.driven.expansion import Arc
from asymptotics.driven.trial import Trial
from asymptotics.driven.turn import is_steep, turn
from asymptotics.flow.balls import upper


def halves(balls: Balls) -> int:
    """Of how many half periods the factor is."""
    return 2 if is_steep(balls) else 1


def factor(trial: Trial, room: arb) -> arb:
    """The factor by which ``halves`` shorten the distance of any motion within ``room`` of the orbit.

    The exact motion itself may be ``trial.miss`` away from the trial orbit in each: ``room`` counts from there.
    """
    balls = trial.balls
    nu, count = (balls.k / balls.mu).sqrt(), halves(balls)
    away = upper(room + count * trial.miss)
    total, high, waves = _integrals(trial, nu, upper(away / balls.mu.sqrt()))
    wave, late = sum(waves, acb(0)), arb(0)
    if is_steep(balls):
        here, half = turn(trial, away), acb(0, 2 * nu * arb.pi()).exp()
        # The interval begins after the first piece, which ends it, mirrored, after a turn.
        wave = (1 + half) * (wave - waves[0] + half * (waves[0] + here.mass))
        total, high = count * (total + here.mass), count * (high + here.high)
        late = count * here.mass * 2 * nu * here.delay
    share = (total - abs(wave) - late) / 2
    # As 2 lambda <= I <= G the root is of 3/4 at least; without any sure loss the factor is 1 or more.
    return (1 - 2 * share / (1 + (total * high).sqrt()) ** 2).sqrt().upper()


def _integrals(trial: Trial, nu: arb, apart: arb) -> tuple[arb, arb, list[acb]]:
    """int a_low, int a_high, and int a_low e^(2 i nu theta) of each piece; steep losses beside rest are no part of
    a_high."""
    balls, nodes, total, high, waves = trial.balls, trial.nodes, arb(0), arb(0), []
    for p, begin, end in zip(trial.pieces, nodes, nodes[1:]):
        low, most = _speeds(p, apart)
        least = _slope(balls, low, most, lower=True)
        # For sums of pieces e^(2 i nu theta) is integrated exactly; a_low is constant on each.
        total += least * (end - begin)
        waves.append(least * ((acb(0, 2 * nu * end)).exp() - acb(0, 2 * nu * begin).exp()) / acb(0, 2 * nu))
        high += _slope(balls, low, most, lower=False) * (end - begin)
    return total, high, waves


def _speeds(p: Arc, apart: arb) -> tuple[arb, arb]:
    """The least and the largest speed along a piece, of all motions within that distance in speed."""
    least = arb(0) if p.lead else (p.ws[0] * (1 - p.growth) - apart).lower()
    most = p.ws[0] * (1 + p.growth) * (p.length if p.lead else arb(1)) + apart
    return max(arb(0), least), upper(most)


def _slope(balls: Balls, low: arb, high: arb, *, lower: bool) -> arb:
    """A bound of sum c alpha |v|^(alpha-1)/mu for speeds from ``low`` to ``high``; without what is infinite at 0."""
    total = arb(0)
    for c, a in balls.losses:
        # It grows with the speed for alpha > 1, and falls below.
        at = low if lower == (a >= 1) else high
        power = arb(1) if a == 1 else arb(0) if at == 0 else at ** (a - 1)
        total += c * a * power / balls.mu
    return total.lower() if lower else total.upper()
