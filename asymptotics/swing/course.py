"""A half-swing in pieces, from an exact state to the next turning point; every piece encloses the true motion.

Orientation: the motion goes towards smaller u = +-X, with the speed w >= 0; y = u - friction.  The state at the start
of a piece is a pair of dyadic numbers, and ``error`` bounds the Euclidean distance of the true (u, w) from the
piece's own orbit at the same time.  Two motions never part (derivation ``motions-never-part``), so errors of pieces
only add: no ball is carried through a step.

* ``Departure``: from rest, by the local expansion at the turning point;
* ``Step``: a Taylor step;
* ``Settling``: until a creep is known to lie beside the slow curve, where its speed is still lost in the errors;
* ``Creep``: for ever, once the motion is caught beside the slow curve;
* ``Landing``: the last piece, by the local expansion at the turning point ahead;
* ``LinearSwing``: the only piece where linear damping below its critical strength and dry friction act alone.

>>> from fractions import Fraction
>>> from asymptotics.numbers.context import ctx
>>> from asymptotics.numbers.exact import ExactReal
>>> with ctx.workprec(100):
...     quadratic = Damping.of([(arb(1), ExactReal(Fraction(2)))])
...     *_, last = course(quadratic, arb(1), arb(0))
>>> arb(last.turn, last.miss).str(20), last.time.str(20)
('[0.41071968606103944670 +/- ...]', '[3.3809710603589252128 +/- ...]')
"""

from collections.abc import Iterator
from dataclasses import dataclass

from flint import arb

from asymptotics.budget import tick
from asymptotics.errors import LimitError, UndecidedError
from asymptotics.flow.balls import upper
from asymptotics.flow.taylor import TaylorStep
from asymptotics.flow.times import at_time, later
from asymptotics.swing.arrival import Arrival, arrive, turns_within
from asymptotics.swing.damping import Damping
from asymptotics.swing.ends import CREEPS, may_trap, trap
from asymptotics.swing.expansion import Expansion
from asymptotics.swing.linear import LinearOrbit, is_linear
from asymptotics.swing.near_equal import Stretch, stretch
from asymptotics.swing.settling import settled
from asymptotics.swing.slide import Slide, sliding
from asymptotics.swing.slow import Strip, caught

MAX_PIECES, MAX_FREE = 200_000, 5000
_ONE = arb(1)
_FAR = 2.0**-8  # of the start: a displacement where a falling speed that is lost in the error asks for more precision
_BY_STEPS = "a creep by Taylor steps, as its slow curve is no short sum of powers yet"
_CATCH = 4  # every so many pieces a strip about the slow curve is tried


@dataclass(frozen=True)
class Piece:
    """The motion from the time ``begin`` to ``end`` (exact): its own orbit, within ``error`` of the truth."""

    damping: Damping
    begin: arb
    end: arb
    error: arb
    trapped: str | None

    def own(self, t: arb) -> tuple[arb, arb]:
        """(y, w) of the piece's own orbit at an exact time from ``begin`` to ``end``."""
        raise NotImplementedError


@dataclass(frozen=True)
class Departure(Piece):
    """From a turning point at ``begin``."""

    expansion: Expansion

    def own(self, t: arb) -> tuple[arb, arb]:
        """(y, w) by the local expansion."""
        return at_time(self.expansion, t - self.begin)


@dataclass(frozen=True)
class Step(Piece):
    """A Taylor step; ``error`` includes its own."""

    taylor: TaylorStep

    def own(self, t: arb) -> tuple[arb, arb]:
        """(y, w) of the Taylor polynomials."""
        return self.taylor.state(t - self.begin)


@dataclass(frozen=True)
class Settling(Piece):
    """A short time in which the true state stays in the balls ``y`` and ``w``; ``error`` is 0."""

    y: arb
    w: arb

    def own(self, t: arb) -> tuple[arb, arb]:
        """The two balls."""
        return self.y, self.w


@dataclass(frozen=True)
class Creep(Piece):
    """Beside the slow curve; the enclosures are those of the true state, and ``error`` is 0."""

    strip: Strip

    def own(self, t: arb) -> tuple[arb, arb]:
        """(y, w) between the two barriers."""
        return self.strip.state(t - self.begin)


@dataclass(frozen=True)
class Turned(Piece):
    """The last piece: the orbit from the exact start of the course turns within ``miss`` of -``turn``, at a time in
    ``time``."""

    turn: arb
    miss: arb
    time: arb

    def late(self, distance: arb) -> arb:
        """How much the time differs at most for an orbit that starts ``distance`` away."""
        return delay(self.turn, upper(distance + self.miss), self.damping.friction)


@dataclass(frozen=True)
class Landing(Turned):
    """By the local expansion ahead: its own orbit turns at the exact place u = -``turn`` and the time ``clock``,
    of which ``end`` is the middle."""

    arrival: Arrival
    clock: arb

    def own(self, t: arb) -> tuple[arb, arb]:
        """(y, w) by the local expansion."""
        return at_time(self.arrival.expansion, t - self.clock)


@dataclass(frozen=True)
class LinearSwing(Turned):
    """The whole course in closed form, up to the middle of ``time``: if its own orbit has turned before, its friction
    has the wrong sign for as long as the radius, which is in ``error``."""

    orbit: LinearOrbit

    def own(self, t: arb) -> tuple[arb, arb]:
        """(y, w) in closed form."""
        return self.orbit.state(t)


def course(damping: Damping, u: arb, w: arb, error: arb | None = None, *, pieces: int = MAX_PIECES) -> Iterator[Piece]:
    """The pieces from the exact state (u, w >= 0) at time 0, at the precision current at each call, to the last one.

    ``error`` bounds the distance of the true state.  A piece in a trap names it, and the course goes on.  LimitError
    after ``pieces`` pieces, UndecidedError where the enclosures are too wide.
    """
    given = arb(0) if error is None else error
    t, error = arb(0), given
    if is_linear(damping):
        yield _linear(damping, u, w, error)
        return
    scale, watch = upper(abs(u) + w), may_trap(damping)
    stiff = not watch and len(damping.alphas) == 1
    if w == 0:
        y = u - damping.friction
        if watch and trap(damping, y + arb(0, error), w) == CREEPS:
            yield from _caught(damping, y, w, t, error)
        first = _departure(damping, u, error)
        yield first
        t = first.end
        y, w = first.expansion.state(first.expansion.reach)
        error = upper(first.error + y.rad())
        u, w = (y + damping.friction).mid(), first.expansion.reach
    reason: str | None = None
    for count in range(pieces):
        tick(f"piece {count} of {'a half-swing' if reason is None else _BY_STEPS}")
        y = u - damping.friction
        blur = arb(0, error)
        if y + error < 0 and turns_within(damping, y, w, error):  # whatever the true speed: it turns, or just did
            yield _landing(damping, y, w, t, error, given)
            return
        reason = trap(damping, y + blur, w + blur) if watch else None
        if reason == CREEPS and count % _CATCH == 0:
            yield from _caught(damping, y, w, t, error)
        slide = _for_a_while(damping, (y, w, error), stiff, reason == CREEPS) if count % _CATCH == 0 else None
        if slide is not None:
            end = later(t, slide.length)
            yield Creep(damping, t, end, arb(0), reason, slide)
            y, w = slide.state(slide.length)
            error, given = upper(y.rad() + w.rad()), arb(0)  # what was known of the start is in the strip
            u, w, t = (y + damping.friction).mid(), w.mid(), end
            continue
        lost = upper(abs(y) + w) < 4 * error or (
            watch and y > _FAR * scale and w < 4 * error and _slowing(damping, y, w)
        )
        if reason is None and ((watch and count > MAX_FREE) or lost):
            where = f"after {count} pieces of a half-swing: too near a separatrix for the working precision"
            raise UndecidedError(f"whether the motion turns or creeps home is undecided {where}")
        taylor = TaylorStep.at(damping, y, w, _ONE, scale)
        end = later(t, taylor.length)
        error = upper(error + taylor.residual)
        yield Step(damping, t, end, error, reason, taylor)
        y, w = taylor.state(taylor.length)
        error = upper(error + y.rad() + w.rad())
        u, w, t = (y + damping.friction).mid(), w.mid(), end
    reason = f"one half-swing takes more than {pieces} pieces: the motion is too stiff or too near a separatrix"
    raise LimitError("time", reason, "weaker damping, another strength, or a shorter time")


def _for_a_while(damping: Damping, state: tuple[arb, arb, arb], stiff: bool, creeps: bool) -> Slide | Stretch | None:
    """A strip about a slow curve that ends, from (y, w, error) on."""
    if stiff and state[0] > 0:
        return sliding(damping, *state)
    return stretch(damping, *state) if creeps else None


def _caught(damping: Damping, y: arb, w: arb, t: arb, error: arb) -> Iterator[Piece]:
    """The rest of a creep, for ever, where a strip holds it now or soon; else nothing."""
    strip = caught(damping, y, w, error)
    if strip is not None:
        yield from _creep(damping, t, strip)
    found = settled(damping, y, w, error)
    if found is not None:
        end = later(t, found.wait)
        yield Settling(damping, t, end, arb(0), CREEPS, found.y, found.w)
        yield from _creep(damping, end, found.strip)


def _creep(damping: Damping, t: arb, strip: Strip) -> Iterator[Piece]:
    """Longer and longer pieces without an end."""
    length = arb(1)
    while True:
        end = later(t, length)
        yield Creep(damping, t, end, arb(0), CREEPS, strip)
        length *= 2


def _slowing(damping: Damping, y: arb, w: arb) -> bool:
    """Whether the speed falls; with y > 0 it then goes on falling."""
    return bool(damping.resistance(w) > y)


def _linear(damping: Damping, u: arb, w: arb, error: arb) -> LinearSwing:
    y = u - damping.friction
    if w == 0 and not y > error:
        raise UndecidedError("whether dry friction holds the mass here is undecided")
    orbit = LinearOrbit.of(damping, y, w)
    time, there = orbit.turning()
    at = there + damping.friction
    own = upper(error + 4 * damping.friction * time.rad())
    return LinearSwing(damping, arb(0), time.mid(), own, None, -at.mid(), upper(at.rad()), time, orbit)


def _departure(damping: Damping, u: arb, error: arb) -> Departure:
    y0 = u - damping.friction
    if not y0 > error:
        raise UndecidedError("whether dry friction holds the mass here is undecided")
    expansion = Expansion.at(damping, y0)
    _, tau = expansion.state(expansion.reach)
    error = upper(error + tau.rad() * expansion.speed())
    return Departure(damping, arb(0), tau.mid(), error, None, expansion)


def _landing(damping: Damping, y: arb, w: arb, t: arb, error: arb, given: arb) -> Landing:
    """Two orbits that are some distance apart turn within that distance; ``given`` is the part of the start."""
    arrival = arrive(damping, y, w)
    at = arrival.turning + damping.friction
    turn, slack = -at.mid(), upper(at.rad() + arrival.miss)
    clock = t + arrival.own_duration
    local = upper(error + slack - given)
    time = t + arrival.duration + arb(0, delay(turn, local, damping.friction))
    own = upper(error + slack + clock.rad() * arrival.expansion.speed())
    return Landing(damping, t, clock.mid(), own, None, turn, local, time, arrival, clock)


def delay(amplitude: arb, distance: arb, friction: arb) -> arb:
    """How much later the second of two orbits turns that are ``distance`` apart, one of them at -``amplitude``.

    When the first turns the other moves with a speed of at most ``distance``, and y <= -(amplitude - 2 distance): its
    speed falls at least at that rate.  UndecidedError where this is not positive.
    """
    rate = amplitude - 2 * distance + friction
    if not rate > 0:
        raise UndecidedError("the enclosure of a turning point reaches the place of rest: raise the precision")
    return upper(distance / rate)
