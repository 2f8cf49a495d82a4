"""The response in balls: its turning point, its state at theta = 0, its harmonics, from a trial orbit and its distance.

Half a period takes the ball of radius r about the turning point of the trial orbit into itself where miss + q r <= r, q
the factor of ``contraction``; a fixed point is in it (Brouwer), the response by ``driven-unique``, and its distance is
miss/(1 - q) at most.
"""

from dataclasses import dataclass

from flint import acb, arb

from asymptotics.driven import first_order, guess
from asymptotics.driven.contraction import factor, halves
from asymptotics.driven.drive import Balls, Drive
from asymptotics.driven.trial import Trial, trial
from asymptotics.driven.turn import is_steep
from asymptotics.errors import UndecidedError
from asymptotics.expansions.moments.certified import moment
from asymptotics.flow.balls import size_of, upper
from asymptotics.numbers.context import ctx

MAX_BITS = 1 << 10
"""Of the working precision: some twenty seconds of one processor."""
_FIT_FOR_DOUBLES = 30.0
_ROOMS = (10, 20, 40, 80)  # that many bits less than the amplitude: choices


def bits_lost(drive: Drive) -> int:
    """About how many bits the smallness of the losses costs, by first order: a choice, more are taken where needed.

    Half a period draws motions together by about pi R/(2 mu A), the third harmonic is about C_3 beside A, and the part
    of x in phase with the force's work about R/f.
    """
    with ctx.workprec(MAX_BITS):
        balls = drive.balls()
        A = first_order.amplitude(balls)
        R = first_order.resistance(balls, A)
        third = sum((c * A**a * 2 * moment(a + 1) * (a - 1) / (a + 3) for c, a in balls.losses), arb(0))
        small = min(size_of(R / balls.f), size_of(third / A) - size_of(balls.k - 9 * balls.mu))
        return int(min(max(0.0, -small) + _weakness(balls, A) + _free(drive, balls), 1e6))


def free_harmonic(drive: Drive) -> int | None:
    """n where dry friction acts alone and omega_0 = n Omega: it takes nothing of a free motion at rest at each turn."""
    if not all(a.is_zero for a in drive.alphas):
        return None
    with ctx.workprec(MAX_BITS):
        balls = drive.balls()
        whole = (balls.k / balls.mu).sqrt().unique_fmpz()
        return None if whole is None else int(whole)


def _free(drive: Drive, balls: Balls) -> float:
    """-log2 (1 - |cos(pi omega_0/Omega)|) for dry friction alone, what is lost beside such a frequency."""
    if not all(a.is_zero for a in drive.alphas):
        return 0.0
    return -size_of(1 - abs(((balls.k / balls.mu).sqrt() * arb.pi()).cos()))


def _weakness(balls: Balls, A: arb) -> float:
    """log2 of mu A/R, 0 at least: half a period draws motions together by that little."""
    return max(0.0, size_of(balls.mu * A) - size_of(first_order.resistance(balls, A)))


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
        if not 0 <= elapsed <= arb.pi():
            elapsed, mirror = elapsed + (-1 if elapsed > 0 else 1) * arb.pi(), -1
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
    lost, lag = _weakness(balls, first), first_order.phase(balls, first)
    if is_steep(scaled):
        theta, X = guess.turning_point_of_waves(scaled, float(lag.mid()))
        start, least = (arb(theta), arb(X)), 64
    elif lost < _FIT_FOR_DOUBLES:
        theta, X = guess.turning_point(scaled, float(lag.mid()))
        start, least = (arb(theta), arb(X)), 64
    else:  # first order is nearer, and fewer bits than these see no loss
        start, least = ((lag - arb.pi()).mid(), -(first / unit).mid()), 64 + 2 * int(lost)
    found = trial(scaled, drive.alphas, start, least)
    # On the way the trial orbit parts by another miss; its jumps, part of that, may make it pass its turning point.
    miss = halves(scaled) * found.miss
    return Orbit(found, unit, upper(miss / (1 - _factor(found, miss)) + 2 * miss))


def _factor(found: Trial, miss: arb) -> arb:
    """The factor in the first room that holds what it maps; where motions turn is decided in a small one."""
    size, said = found.balls.k.sqrt() * abs(found.X), "the trial orbit is not near enough for its contraction"
    for share in _ROOMS:
        room = upper(size * arb(2) ** -share)
        try:
            q = factor(found, room)
        except UndecidedError as error:
            said = str(error)
            continue
        if miss <= (1 - q) * room:
            return q
    raise UndecidedError(said)
