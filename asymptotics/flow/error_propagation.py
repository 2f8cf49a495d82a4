"""Error propagation along a half-swing: how far two motions of one force can part, and the errors carried so.

*Along a piece.*  The distance D = sqrt(unit^2 (u - u~)^2 + (w - w~)^2) of two motions in a convex box obeys the
differential inequality of the logarithmic norm (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd
ed., theorem I.10.6; derivation ``parting-with-gains``)

    D' <= lambda D + residual,    lambda = G_w/2 + sqrt((G_w/2)^2 + c^2),    c = (G_u - unit^2)/(2 unit).

Three forces, one factor:

* nonexpansive (the linear spring, unit 1, c = 0, G_w <= 0): 1, errors only add (derivation ``motions-never-part``);
* losses that grow with the speed, in any well: G_w <= 0 and lambda = |c| (derivation ``wells-distance``);
* gains as well: lambda is near c^2/|G_w| where losses are strong, so that on a slow branch nothing parts.

*From turning point to turning point*, for orbits from p and p~ that turn at q and q~: nonexpansive flows have
|q - q~| <= |p - p~|, and beside the linear spring, a <= 1 being no more than any alpha_i > 0, without dry friction
(derivation ``ratio-growth``),

    |ln q - ln q~| <= g |ln p - ln p~|,    g = 1 + (1 - a)/(2 - a) ((p/(q - |p - p~|))^(2-a) - 1).

In any other well (derivation ``wells-contract``) the difference of the squares of two speeds at equal places cannot
grow: D = (w_1^2 - w_2^2)/2 obeys dD/du = drag(u, w_1) - drag(u, w_2) >= 0, and u falls.  Two motions from rest at p and
p~ that turn at u_1 and u~_1 have D <= |p - p~| max s_0 at the first and D >= |u_1 - u~_1| min |s_0| at the second end:

    |u_1 - u~_1| <= e^(-epsilon t) |p - p~| max s_0/min |s_0|,

with the strength epsilon of the loss epsilon w and the time t that the faster one needs for the places of both.
"""

from dataclasses import dataclass

from flint import arb

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import upper
from asymptotics.flow.force import Force, HasSlopes
from asymptotics.numbers.context import ctx

# 40 bits for bounds of a few digits, beyond the 30 of a radius.  64 pieces for the sign of a force on one stretch:
# halving finds six bits of a place where it changes, and nearer ones count as undecided.
_LOW, _PIECES = 40, 64
_ONE = arb(1)


@dataclass(frozen=True)
class CarriedErrors:
    """Distances at one time of a half-swing: ``local`` of the orbit from its exact start, ``error`` of the truth.

    A distance given at the start has ``grown`` by that factor at most.
    """

    # Both are kept, as they answer different questions: ``local`` says where the orbit from the midpoint turns, and the
    # error given at its start is led on to the turning point by the sharper contractions at the end of this file.
    local: arb
    error: arb
    grown: arb = _ONE

    def plus(self, own: arb) -> "CarriedErrors":
        """The errors after a piece that adds ``own`` to every distance."""
        return CarriedErrors(upper(self.local + own), upper(self.error + own), self.grown)

    def times(self, factor: arb) -> "CarriedErrors":
        """The errors after a piece along which distances grow by ``factor``."""
        if factor == 1:
            return self
        return CarriedErrors(*(upper(factor * e) for e in (self.local, self.error, self.grown)))

    def apart(self, given: arb) -> arb:
        """How far an orbit is that started within ``given``, no more than the pieces were given."""
        return upper(self.local + self.grown * given)


def distance_growth(force: HasSlopes, unit: arb, u: arb, w: arb, duration: arb) -> arb:
    """The factor by which the distance of two motions in the box may grow in that time."""
    with ctx.workprec(_LOW):
        in_u, in_w = force.slopes(u, w)
        # lambda grows with G_w and with |c|: on a box of states the upper ends of both bound it.
        half, c = (in_w / 2).upper(), abs((in_u - unit**2) / (2 * unit)).upper()
        # For G_w = 0 the rate is |c| itself, without the rounding of a root.  For G_w < 0 the two terms of lambda
        # nearly cancel under strong losses; c^2/(root - half) is the same number (last step of ``parting-with-gains``).
        root = (half**2 + c**2).sqrt() if half != 0 else c
        rate = c**2 / (root - half) if half < 0 else half + root
        return upper((duration * rate).exp())


def growth(force: HasSlopes, unit: arb, u: arb, w: arb, duration: arb, error: arb) -> arb:
    """The factor by which ``error`` may grow along a piece: u a ball with all its places, w with all its speeds.

    UndecidedError where it grows so much that the piece does not hold it.
    """
    if force.nonexpansive:
        return _ONE
    with ctx.workprec(_LOW):
        # The rate must hold wherever the two motions are, so a room for their distance comes first, four times the
        # error at the start: a choice.  While they are within it the distance is at most factor times error; if that
        # lies within the room, they never leave it, by continuity.
        room = upper(4 * error)
        for _ in range(8):
            factor = distance_growth(force, unit, u + arb(0, upper(room / unit)), w + arb(0, room), duration)
            if factor * error <= room:
                return factor
            # Twice what this room asks for: the next factor is larger, as the box is.  After eight rooms the motions
            # part too fast to be worth following.
            room = upper(2 * factor * error)
    raise UndecidedError("two motions part too fast for the working precision")


def state_gap(force: Force, unit: arb, u: arb, w: arb, turn: arb, error: arb) -> arb:
    """How far from ``turn`` an orbit turns that is within ``error`` of (u, w), as the one that turns there.

    The one farther back falls through error/unit before their places are equal.
    """
    if error == 0 or force.nonexpansive:
        return error
    with ctx.workprec(_LOW):
        # Places differ by error/unit at most, and so does the place of either orbit from u.
        width = upper(error / unit)
        box = u + arb(0, upper(2 * width))
        force_there = upper(abs(force.restoring(box)) + force.drag(box, w + error))
        # The difference of w^2/2 at equal places: |w_1 - w_2| (w_1 + w_2)/2 at this time, with |w_1 - w_2| <= error and
        # both speeds at most w + error, and what the one farther back loses on the way to the place of the other.
        square = upper(error * (w + error) + width * force_there)
        # So the one farther back does get there before it turns, and both are in motion.
        if not (w > 2 * error and (w - error) ** 2 / 2 > square):
            raise UndecidedError("the enclosure of a state is too wide for its turning point")
        gap = turning_gap(force, turn, square)
        # s_0 < 0 from the box down to the farthest turning point: both brake all the way, the speed w + error above is
        # the largest one, and both turn.
        if not points_forward(force, (turn - gap).lower(), box.upper()):
            raise UndecidedError("the force ahead of a turning point is undecided")
        return gap


def turning_gap(force: Force, turn: arb, square: arb, beyond: arb | None = None) -> arb:
    """How far apart two motions turn, the difference of whose w^2/2 at equal places is at most ``square``.

    One of them turns within ``beyond`` of ``turn``.  UndecidedError where the force there may not point forward.
    """
    if square == 0:
        return arb(0)
    with ctx.workprec(_LOW):
        near = arb(0) if beyond is None else beyond
        # A room for the second turning point, from the force at the first: a choice, twice what would do if the force
        # were constant.
        room = upper(2 * square / abs(force.restoring(turn)).lower()) if force.restoring(turn) < 0 else None
        if room is not None:
            # The least force in that room (derivation ``wells-contract``): w^2/2 falls by at least ``brake`` for each
            # unit of length, so less than ``room`` is needed.
            brake = -force.restoring(turn + arb(0, upper(near + room)))
            if brake > 0 and brake.lower() * room > square:
                return upper(square / brake.lower())
    raise UndecidedError("the enclosure of a turning point reaches the place of rest")


def points_forward(force: Force, low: arb, high: arb) -> bool:
    """Whether s_0 < 0 from ``low`` to ``high``, proved on pieces."""
    stack, pieces = [(low.lower(), high.upper())], 0
    with ctx.workprec(53):
        while stack:
            a, b = stack.pop()
            pieces += 1
            if force.restoring(a.union(b)) < 0:
                continue
            # At one place the ball is narrow: if the sign fails there, no smaller piece will help.
            if pieces > _PIECES or not force.restoring(b) < 0:
                return False
            middle = ((a + b) / 2).mid()
            stack += [(a, middle), (middle, b)]
    return True


def turning_delay(force: Force, unit: arb, turn: arb, gap: arb, distance: arb) -> arb:
    """How much later the second of two motions turns: they are ``distance`` apart, and one turns within ``gap`` of
    ``turn``, where the other may be the one that turns.

    When the first turns the other moves with w <= distance at a place within distance/unit, and w' <= s_0 < 0 from
    there.  The linear spring brakes the more the farther it goes; elsewhere the way to the turning point counts too.
    """
    if distance == 0:
        return arb(0)
    with ctx.workprec(_LOW):
        # The second distance/unit is for the way that the motion still goes, checked below; the linear spring, y < 0,
        # pulls harder the farther it goes, so its least force is met at once.
        around = turn + arb(0, upper(gap + (1 if force.nonexpansive else 2) * distance / unit))
        brake = (-force.restoring(around)).lower()
        inside = force.nonexpansive or distance * unit <= brake  # it moves at most distance^2/brake meanwhile
        if brake > 0 and inside:
            return upper(distance / brake)
    raise UndecidedError("the enclosure of a turning point reaches the place of rest: raise the precision")


def contraction_by_energy(force: Force, p: arb, error: arb, clock: arb, late: arb, turn: arb, gap: arb) -> arb:
    """How far apart two motions turn that start from rest within ``error`` of p, each within ``late`` of ``clock``.

    The motion from p itself turns within ``gap`` of ``turn``.
    """
    # Beside the linear spring absolute errors do not grow (derivation ``motions-never-part``), and relative ones hardly
    # (``ratio-growth``).  In any other well only squares of speeds at equal places draw together.
    if error == 0 or force.nonexpansive:
        return contraction_by_ratio(force, p, error, abs(turn) + arb(0, gap))
    with ctx.workprec(_LOW):
        # The first end: when the motion from farther out passes the start of the other, its w^2/2 is at most error max
        # s_0.
        steep = force.restoring(p + arb(0, error))
        square = upper(error * steep)
        if force.viscous > 0:
            # Linear loss contracts at the rate epsilon, but only in the time that the faster motion spends where the
            # other one is too: a lower bound of it.  It may be either, so the shorter of the two durations counts.
            common = (clock - late - _outside(force, p, error, turn, gap, square)).lower()
            square = upper(square * (-force.viscous * common).exp()) if common > 0 else square
        return turning_gap(force, turn, square, gap)


def contraction_by_ratio(force: Force, p: arb, error: arb, q: arb) -> arb:
    """A bound of how far apart two motions turn that start from rest within ``error`` of p, the one from p in q.

    It is ``error``, or q (e^(g error/(p - error)) - 1) if that is less.
    """
    if error == 0 or force.least_power is None or not p > error:
        return error
    # |ln p - ln p~| <= error/(p - error), as 1/p is the slope of ln p and p~ >= p - error.
    relative = upper(ratio_growth(force.least_power, p, error, q) * error / (p - error))
    # Both are upper bounds, and either may be the smaller: far below the start, q << p, relative errors are better;
    # under a strong law with an exponent below 1 the growth g is not.  Where g is inf, so is the second.
    return min(error, upper(q * relative.expm1()))


def ratio_growth(a: arb, p: arb, error: arb, q: arb) -> arb:
    """A bound of d ln q/d ln p for all starts within ``error`` < p of p, the one from p turning in q; it may be inf.

    >>> ratio_growth(arb(1) / 2, arb(1), arb(0), arb(1) / 4).str(5), ratio_growth(arb(1), arb(1), arb(0), arb(0))
    ('[3.3333 +/- ...]', 1.00000000000000)
    """
    # All alpha_i >= 1: relative errors never grow (L1b of the shared notes, derivation ``motions-never-part``).
    if a == 1:
        return _ONE
    # The smallest amplitude that any of these starts may end at; g grows with p/q, so it counts for all of them.
    nearest = (q - error).lower()
    if not nearest > 0:
        return arb("inf")
    with ctx.workprec(_LOW):
        return upper(1 + (1 - a) / (2 - a) * ((2 - a) * (p / nearest).log()).expm1())


def _outside(force: Force, p: arb, error: arb, turn: arb, gap: arb, square: arb) -> arb:
    """How long the faster motion may stay at places where the other one never is.

    It falls through at most ``error`` from rest at an acceleration of at least half of min s_0, and it stops from
    w^2/2 <= ``square`` at a rate of at least min |s_0|.
    """
    box = p + arb(0, error)
    slow, fast = force.restoring(box).lower(), force.restoring(box).upper()
    stopped = turn + arb(0, upper(gap + turning_gap(force, turn, square, gap)))
    brake = (-force.restoring(stopped)).lower()
    # Within ``error`` of its start the motion reaches at most w^2/2 = error max s_0; if drag takes no more than half of
    # min s_0 at that speed, the acceleration is at least the other half.
    if not (slow > 0 and brake > 0 and force.drag(box, (2 * error * fast).sqrt()) <= slow / 2):
        return arb("inf")
    return upper(2 * (error / slow).sqrt() + (2 * square).sqrt() / brake)
