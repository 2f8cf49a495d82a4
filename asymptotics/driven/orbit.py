"""The response in balls: its turning point, its state at theta = 0, its harmonics, from a trial orbit and its distance.

Half a period takes the ball of radius r about the turning point of the trial orbit into itself where miss + q r <= r, q
the factor of ``contraction``; a fixed point is in it (Brouwer), the response by ``driven-unique``, and its distance is
miss/(1 - q) at most.
"""

from dataclasses import dataclass

from flint import acb, arb

from asymptotics.driven import first_order, guess
from asymptotics.driven.contraction import factor
from asymptotics.driven.drive import Drive
from asymptotics.driven.trial import Trial, trial
from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import upper


@dataclass(frozen=True)
class Orbit:
    """``trial`` is within ``error`` of the response all along, in sqrt(k x^2 + mu v^2); x in units of ``length``."""

    trial: Trial
    length: arb
    error: arb

    @property
    def _of_x(self) -> arb:
        return arb(0, upper(self.error / self.trial.balls.k.sqrt()))

    @property
    def _of_v(self) -> arb:
        return arb(0, upper(self.error / self.trial.balls.mu.sqrt()))

    def amplitude(self) -> arb:
        """The largest |x|: the trial orbit is monotone between its turning points."""
        return self.length * (abs(self.trial.X) + self._of_x)

    def state(self) -> tuple[arb, arb]:
        """(x, dx/d theta) at theta = 0, where the force is largest."""
        elapsed, mirror = -self.trial.theta, 1
        if not elapsed >= 0:
            elapsed, mirror = elapsed + arb.pi(), -1
        nodes = self.trial.nodes
        number = max(n for n, node in enumerate(nodes[:-1]) if n == 0 or node <= elapsed)
        p = self.trial.pieces[number]
        y, w = p.state(elapsed - nodes[number] if p.side > 0 else arb.pi() - elapsed)
        x, v = p.sign * y, p.side * p.sign * w
        return mirror * self.length * (x + self._of_x), mirror * self.length * (v + self._of_v)

    def harmonic(self, n: int) -> acb:
        """C_n = (2/pi) int x e^(-i n theta) over half a period, n odd: x = sum of Re(C_n e^(i n theta))."""
        total = sum((p.harmonic(n) for p in self.trial.pieces), acb(0))
        return self.length * (total * 2 / arb.pi() + acb(2 * self._of_x, 2 * self._of_x))


def orbit(drive: Drive) -> Orbit:
    """At the precision in force; UndecidedError where it is too low."""
    balls = drive.balls()
    first = first_order.amplitude(balls)
    unit = first.mid()
    scaled = balls.in_units(unit)
    found = trial(scaled, drive.alphas, guess.turning_point(scaled, float(first_order.phase(balls, first).mid())))
    room = upper(scaled.k.sqrt() * abs(found.X) / 1024)
    q = factor(found, room)
    if not found.miss <= (1 - q) * room:
        raise UndecidedError("the trial orbit is not near enough for its contraction")
    # On the way the trial orbit parts by another miss; its jumps, part of that, may make it pass its turning point.
    return Orbit(found, unit, upper(found.miss / (1 - q) + 2 * found.miss))
