"""How far two motions of one force can part, in the distance sqrt(unit^2 (u - u~)^2 + (w - w~)^2).

*Along a piece* (derivation ``wells-distance``).  Losses grow with the speed, so only the slope of the force in u
enters:

    d/dt distance <= |dG/du - unit^2|/(2 unit) distance + residual,

for any ``unit`` > 0; over a piece of duration t it grows at most by e^(t max |dG/du - unit^2|/(2 unit)).

*From turning point to turning point* (derivation ``wells-contract``).  At equal places u the difference of the
squares of two speeds cannot grow: D = (w_1^2 - w_2^2)/2 obeys dD/du = drag(u, w_1) - drag(u, w_2) >= 0, and u falls.
Two motions from rest at p and p~ that turn at u_1 and u~_1 have D <= |p - p~| max s_0 at the first and D >= |u_1 -
u~_1| min |s_0| at the second end:

    |u_1 - u~_1| <= e^(-epsilon t) |p - p~| max s_0/min |s_0|,

with the strength epsilon of the loss epsilon w and the time t that the faster one needs for the places of both.
"""

from flint import arb

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import size_of, upper
from asymptotics.numbers.context import ctx
from asymptotics.wells.force import Force

_LOW = 40


def unit_for(force: Force, size: arb) -> arb:
    """A power of two near the frequency at the amplitude ``size``: a choice."""
    with ctx.workprec(_LOW):
        steepest = max((abs(force.slope(size * k / 8, arb(0))).upper() for k in range(9)), default=arb(1))
        return arb((1, round(size_of(steepest / 2) / 2)), 0)


def growth(force: Force, unit: arb, u: arb, w: arb, duration: arb, error: arb) -> arb:
    """The factor by which ``error`` may grow along a piece: u a ball with all its places, w with all its speeds.

    UndecidedError where it grows so much that the piece does not hold it.
    """
    with ctx.workprec(_LOW):
        room = upper(4 * error)
        for _ in range(8):
            slope = force.slope(u + arb(0, upper(room / unit)), w + arb(0, room))
            factor = upper((duration * abs(slope - unit**2) / (2 * unit)).exp())
            if factor * error <= room:
                return factor
            room = upper(2 * factor * error)
    raise UndecidedError("two motions part too fast for the working precision")


def turning_gap(force: Force, turn: arb, square: arb, beyond: arb | None = None) -> arb:
    """How far apart two motions turn, the difference of whose w^2/2 at equal places is at most ``square``.

    One of them turns within ``beyond`` of ``turn``.  UndecidedError where the force there may not point forward.
    """
    if square == 0:
        return arb(0)
    with ctx.workprec(_LOW):
        near = arb(0) if beyond is None else beyond
        room = upper(2 * square / abs(force.rest(turn)).lower()) if force.rest(turn) < 0 else None
        if room is not None:
            brake = -force.rest(turn + arb(0, upper(near + room)))
            if brake > 0 and brake.lower() * room > square:
                return upper(square / brake.lower())
    raise UndecidedError("the enclosure of a turning point reaches the place of rest")


def lateness(force: Force, unit: arb, turn: arb, gap: arb, distance: arb) -> arb:
    """How much later the second of two motions turns: they are ``distance`` apart, and one turns within ``gap`` of
    ``turn``.

    When the first turns the other moves with w <= distance at a place within distance/unit, and w' <= s_0 < 0 from
    there.
    """
    if distance == 0:
        return arb(0)
    with ctx.workprec(_LOW):
        around = turn + arb(0, upper(gap + 2 * distance / unit))
        brake = (-force.rest(around)).lower()
        if brake > 0 and distance * unit <= brake:  # it moves at most distance^2/brake meanwhile
            return upper(distance / brake)
    raise UndecidedError("the enclosure of a turning point reaches the place of rest: raise the precision")


def contracted(force: Force, p: arb, error: arb, duration: arb, turn: arb, gap: arb) -> arb:
    """How far apart two motions turn that start from rest within ``error`` of p, each after at least ``duration``.

    The motion from p itself turns within ``gap`` of ``turn``.
    """
    if error == 0:
        return arb(0)
    with ctx.workprec(_LOW):
        steep = force.rest(p + arb(0, error))
        square = upper(error * steep)
        if force.viscous > 0:
            common = (duration - _outside(force, p, error, turn, gap, square)).lower()
            square = upper(square * (-force.viscous * common).exp()) if common > 0 else square
        return turning_gap(force, turn, square, gap)


def _outside(force: Force, p: arb, error: arb, turn: arb, gap: arb, square: arb) -> arb:
    """How long the faster motion may stay at places where the other one never is.

    It falls through at most ``error`` from rest at an acceleration of at least half of min s_0, and it stops from
    w^2/2 <= ``square`` at a rate of at least min |s_0|.
    """
    box = p + arb(0, error)
    slow, fast = force.rest(box).lower(), force.rest(box).upper()
    stopped = turn + arb(0, upper(gap + turning_gap(force, turn, square, gap)))
    brake = (-force.rest(stopped)).lower()
    if not (slow > 0 and brake > 0 and force.drag(box, (2 * error * fast).sqrt()) <= slow / 2):
        return arb("inf")
    return upper(2 * (error / slow).sqrt() + (2 * square).sqrt() / brake)
