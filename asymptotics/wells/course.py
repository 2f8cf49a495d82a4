"""A half-swing in pieces, from an exact state to the next turning point; every piece encloses the true motion.

Orientation: the motion goes towards smaller u = +-X, with the speed w >= 0.  A piece starts from a pair of dyadic
numbers; ``error`` bounds the distance of the truth from the piece's own orbit at the same time, ``local`` that of the
orbit from the exact start of the course; both grow along a piece as ``distance`` says, and the piece adds its own
error.

* ``Departure``: from rest, by the local expansion at the turning point;
* ``Step``: a Taylor step; where the force has a kink it ends at u = 0 just before it, and the next one starts there;
* ``Landing``: the last piece, by the local expansion at the turning point ahead.

>>> from asymptotics.law import Law
>>> with ctx.workprec(100):
...     pendulum = Force.of(Law({2: "1/5"}, spring="pendulum").terms)
...     *_, last = course(pendulum, arb(2), arb(0))
...     (last.turn + arb(0, last.miss)).str(20)
'[-1.2038040963510937100 +/- ...]'
"""

from collections.abc import Iterator
from dataclasses import dataclass

from flint import arb

from asymptotics.budget import tick
from asymptotics.errors import LimitError, UndecidedError
from asymptotics.flow.balls import size_of, upper
from asymptotics.flow.taylor import TaylorStep
from asymptotics.flow.times import at_time, later
from asymptotics.numbers.context import ctx
from asymptotics.wells.distance import growth, lateness, turning_gap, unit_for
from asymptotics.wells.ends import beyond, may_trap, trap
from asymptotics.wells.expansion import Expansion
from asymptotics.wells.force import Force
from asymptotics.wells.landing import arrive, points_forward, turns_within

MAX_PIECES, MAX_FREE, MAX_BEYOND = 200_000, 5000, 200
_LOW = 40
_NEAR = 10  # bits above the last one of the scale within which a place counts as the kink's


@dataclass(frozen=True)
class Piece:
    """The motion from the time ``begin`` to ``end`` (exact): its own orbit, within ``error`` of the truth.

    ``ended``: why no turning point follows (a trap) or why the motion left its well, else None.
    """

    force: Force
    unit: arb
    begin: arb
    end: arb
    local: arb
    error: arb
    ended: str | None

    def own(self, t: arb) -> tuple[arb, arb]:
        """(u, w) of the piece's own orbit at an exact time from ``begin`` to ``end``."""
        raise NotImplementedError


@dataclass(frozen=True)
class Departure(Piece):
    """From a turning point at ``begin``; a distance given there has grown by ``factor`` at the end."""

    expansion: Expansion
    factor: arb

    def own(self, t: arb) -> tuple[arb, arb]:
        """(u, w) by the local expansion."""
        return at_time(self.expansion, t - self.begin)


@dataclass(frozen=True)
class Step(Piece):
    """A Taylor step; ``error`` includes its own."""

    taylor: TaylorStep

    def own(self, t: arb) -> tuple[arb, arb]:
        """(u, w) of the Taylor polynomials."""
        return self.taylor.state(t - self.begin)


@dataclass(frozen=True)
class Landing(Piece):
    """The last piece: its own orbit turns at the exact place ``turn`` at a time in ``clock`` (middle: ``end``).

    The orbit from the exact start of the course turns within ``miss`` of ``turn``.  It passes the place and the speed
    ``beside`` within ``parted``; a distance given at the start of the course has ``grown`` by that factor until then,
    and every distance grows by ``factor`` from there on.
    """

    expansion: Expansion
    turn: arb
    miss: arb
    clock: arb
    beside: tuple[arb, arb]
    parted: arb
    grown: arb
    factor: arb

    def own(self, t: arb) -> tuple[arb, arb]:
        """(u, w) by the local expansion."""
        return at_time(self.expansion, t - self.clock)

    def gap(self, given: arb) -> arb:
        """How far from ``turn`` an orbit turns that starts within ``given``, no more than the course was given."""
        return _gap(self.force, self.unit, *self.beside, self.turn, self.apart(given))

    def late(self, given: arb) -> arb:
        """How much later or earlier than its own orbit such an orbit turns."""
        distance = upper(self.factor * self.apart(given))
        return lateness(self.force, self.unit, self.turn, self.gap(given), distance)

    def apart(self, given: arb) -> arb:
        """How far it is from ``beside`` when the piece begins."""
        return upper(self.parted + self.grown * given)


def course(force: Force, u: arb, w: arb, given: arb | None = None, *, pieces: int = MAX_PIECES) -> Iterator[Piece]:
    """The pieces from the exact state (u, w >= 0) at time 0, at the precision current at each call, to the
    ``Landing``.

    ``given`` bounds the distance of the true state, in the distance of ``unit_at``.  A piece that ended names why,
    and the course goes on.  LimitError after ``pieces`` pieces, UndecidedError where the enclosures are too wide.
    """
    local, error = arb(0), arb(0) if given is None else given
    t, unit, watch, grown = arb(0), unit_at(force, u, w), may_trap(force), arb(1)
    scale, beyond_count = upper(unit * abs(u) + w), 0
    if w == 0:
        first = _departure(force, unit, u, error)
        yield first
        t, w = first.end, first.expansion.reach
        u, more = _middle(first.expansion.state(w)[0], unit)
        local, error = upper(first.local + more), upper(first.error + more)
        grown = first.factor
    for count in range(pieces):
        tick(f"piece {count} of a half-swing")
        if turns_within(force, u, w):
            yield _landing(force, unit, u, w, t, local, error, grown)
            return
        ended = beyond(force, u + arb(0, upper(error / unit)))
        beyond_count += ended is not None
        if watch and ended is None:
            ended = trap(force, u + arb(0, upper(error / unit)), w + arb(0, error))
            _require_room(ended, count, unit * u, w, error)
        step = _step(force, unit, u, w, scale)
        factor = growth(force, unit, *step.box, step.length, upper(error + step.residual))
        local, error = (upper(factor * (e + step.residual)) for e in (local, error))
        grown = upper(factor * grown)
        end = later(t, step.length)
        yield Step(force, unit, t, end, local, error, ended, step)
        if beyond_count > MAX_BEYOND:
            break
        (u, more), (w, rest), t = *(_middle(c, f) for c, f in zip(step.state(step.length), (unit, arb(1)))), end
        near = max(size_of(step.us[0]) - ctx.prec / 2, size_of(scale) - ctx.prec + _NEAR)
        if force.kinked and step.us[0] > 0 and u > 0 and size_of(u) < near:
            u, more = arb(0), upper(more + unit * u)
        local, error = (upper(e + more + rest) for e in (local, error))
    where = "the motion is too stiff, leaves its well or is near its top"
    reason = f"one half-swing takes more than {pieces} pieces: {where}"
    raise LimitError("time", reason, "weaker damping, another start, or a shorter time")


def unit_at(force: Force, u: arb, w: arb) -> arb:
    """The unit of the distance on a half-swing from the state (u, w): a choice."""
    with ctx.workprec(_LOW):
        return unit_for(force, upper(abs(u) + w))


def _require_room(ended: str | None, count: int, u: arb, w: arb, error: arb) -> None:
    if ended is None and (count > MAX_FREE or upper(abs(u) + w) < 4 * error):
        where = f"after {count} pieces of a half-swing: too near a separatrix for the working precision"
        raise UndecidedError(f"whether the motion turns or creeps home is undecided {where}")


def _middle(x: arb, unit: arb) -> tuple[arb, arb]:
    """A dyadic number in the ball, and how far it may be off in the distance."""
    return x.mid(), upper(unit * x.rad())


def _departure(force: Force, unit: arb, u: arb, error: arb) -> Departure:
    with ctx.workprec(_LOW):
        if not force.rest(u + arb(0, upper(error / unit))) > 0:
            raise UndecidedError("whether dry friction holds the mass here is undecided")
    expansion = Expansion.at(force, u)
    end, tau = expansion.state(expansion.reach)
    if force.kinked and not end > 0:
        raise UndecidedError("the expansion at a turning point reaches a kink of the force")
    local = upper(tau.rad() * expansion.speed(unit))
    factor = growth(force, unit, u.union(end), arb(0).union(expansion.reach), tau, error)
    return Departure(force, unit, arb(0), tau.mid(), local, upper(factor * error + local), None, expansion, factor)


def _step(force: Force, unit: arb, u: arb, w: arb, scale: arb) -> TaylorStep:
    """A Taylor step; across a kink at u = 0 it ends just before it."""
    step = TaylorStep.at(force, u, w, unit, scale)
    if not (force.kinked and u > 0) or step.state(step.length)[0] > 0:
        return step
    t = (u / w).mid()
    for _ in range(6 + ctx.prec.bit_length()):
        t = min(t, step.length)
        place, speed = step.state(t)
        t = (t + place / speed).mid()
    early = (t - (step.length + u / w) * arb(2) ** (-ctx.prec + 8)).mid()
    if not (early > 0 and early < step.length and step.state(early)[0] > 0):
        raise UndecidedError("the passage of a kink of the force is too near for the working precision")
    return step.shortened(early)


def _landing(force: Force, unit: arb, u: arb, w: arb, t: arb, local: arb, error: arb, grown: arb) -> Landing:
    """The last piece; ``local``, ``error`` and ``grown`` belong to its start."""
    expansion = arrive(force, u, w)
    turn = expansion.u0
    place, time = expansion.state(w)
    if force.kinked and not turn * place > 0:
        raise UndecidedError("the expansion at a turning point reaches a kink of the force")
    slack = upper(unit * (place - u))
    local, error = upper(local + slack), upper(error + slack)
    factor = growth(force, unit, turn.union(place), arb(0).union(w), -time, error)
    clock = t - time
    own, miss = upper(clock.rad() * expansion.speed(unit)), _gap(force, unit, u, w, turn, local)
    _gap(force, unit, u, w, turn, error)  # the truth turns as well, or that is undecided
    last, end = (upper(factor * e + own) for e in (local, error))
    return Landing(
        force, unit, t, clock.mid(), last, end, None, expansion, turn, miss, clock, (u, w), local, grown, factor
    )


def _gap(force: Force, unit: arb, u: arb, w: arb, turn: arb, error: arb) -> arb:
    """How far from ``turn`` an orbit turns that is within ``error`` of (u, w), as the one that turns there.

    The one farther back falls through error/unit before their places are equal.
    """
    if error == 0:
        return arb(0)
    with ctx.workprec(_LOW):
        width = upper(error / unit)
        box = u + arb(0, upper(2 * width))
        force_there = upper(abs(force.rest(box)) + force.drag(box, w + error))
        square = upper(error * (w + error) + width * force_there)
        if not (w > 2 * error and (w - error) ** 2 / 2 > square):
            raise UndecidedError("the enclosure of a state is too wide for its turning point")
        gap = turning_gap(force, turn, square)
        if not points_forward(force, (turn - gap).lower(), box.upper()):
            raise UndecidedError("the force ahead of a turning point is undecided")
        return gap
