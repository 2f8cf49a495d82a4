"""How half a period draws motions together, beside a trial orbit: all motions within a distance of it.

The difference (X, V) of two motions obeys mu V' + k X + g(theta) V = 0, X' = V, with a quotient of differences g that
is a slope of the losses at a speed between the two, so between lower and upper bounds along the orbit.  With a = g/mu
and the norm |z|^2 = k X^2 + mu V^2, nu^2 = k/mu, over an interval

    |z(end)|^2 <= (1 - 2 lambda/(1 + sqrt(I G))^2) |z(0)|^2,    I = int a_low, G = int a_high,
    lambda = (I - |int a_low e^(2 i nu theta)|)/2.

Derivation ``driven-unique``.
"""

from collections.abc import Iterator

from flint import acb, arb

from asymptotics.driven.drive import Balls
from asymptotics.driven.expansion import Arc
from asymptotics.driven.trial import Trial
from asymptotics.flow.balls import upper


def factor(trial: Trial, room: arb) -> arb:
    """The factor by which half a period shortens the distance of any motion within ``room`` of the orbit; alpha >= 1.

    The exact motion itself may be ``trial.miss`` away from the trial orbit: ``room`` counts from there.
    """
    balls = trial.balls
    nu, apart = (balls.k / balls.mu).sqrt(), upper((room + trial.miss) / balls.mu.sqrt())
    nodes, total, high, wave = trial.nodes, arb(0), arb(0), acb(0)
    for p, begin, end in zip(trial.pieces, nodes, nodes[1:]):
        low, most = _speeds(p, apart)
        least = _slope(balls, low, most, lower=True)
        # For sums of pieces e^(2 i nu theta) is integrated exactly; a_low is constant on each.
        total += least * (end - begin)
        wave += least * ((acb(0, 2 * nu * end)).exp() - acb(0, 2 * nu * begin).exp()) / acb(0, 2 * nu)
        high += _slope(balls, low, most, lower=False) * (end - begin)
    share = (total - abs(wave)) / 2
    # As 2 lambda <= I <= G the root is of 3/4 at least; without any sure loss the factor is 1 or more.
    return (1 - 2 * share / (1 + (total * high).sqrt()) ** 2).sqrt().upper()


def _speeds(p: Arc, apart: arb) -> tuple[arb, arb]:
    """The least and the largest speed along a piece, of all motions within that distance in speed."""
    least = arb(0) if p.lead else (p.ws[0] * (1 - p.growth) - apart).lower()
    most = p.ws[0] * (1 + p.growth) * (p.length if p.lead else arb(1)) + apart
    return max(arb(0), least), upper(most)


def _slope(balls: Balls, low: arb, high: arb, *, lower: bool) -> arb:
    """A bound of sum c alpha |v|^(alpha-1)/mu, which grows with the speed, for speeds from ``low`` to ``high``."""

    def terms() -> Iterator[arb]:
        for c, a in balls.losses:
            at = low if lower else high
            power = arb(1) if a == 1 else arb(0) if at == 0 else at ** (a - 1)
            yield c * a * power / balls.mu

    total = sum(terms(), arb(0))
    return total.lower() if lower else total.upper()
