"""A half-swing in pieces, from an exact state to the next turning point; every piece encloses the true motion.

Orientation: the motion goes towards smaller u = +-X, with the speed w >= 0.  The state at the start of a piece is a
pair of dyadic numbers, no ball is carried through a step, and ``errors`` bound the distance of the truth from the
piece's own orbit at the same time (``error_propagation``).

* ``DeparturePiece``: from rest, by the local expansion at the turning point;
* ``Step``: a Taylor step; where the force has a kink it ends at u = 0 just before it, and the next one starts there;
* ``ArrivalPiece``: the last piece, by the local expansion at the turning point ahead.

What else is known of the motions of a force is asked of its ``CertifiedFlow``: a closed form, traps, a slow curve.

*What stays apart.*  ``limit_cycles.half_cycle`` shares the Taylor step, the state and the rule of its errors, but not
this loop.  Whatever is said here of a turning point (``state_gap``, ``turning_delay``) needs a ``Force`` that only
loses energy; gains need their own, and the integral J with the errors of each step.  Where all powers are whole, steps
through rest are faster as well: of x'' + x'^3/5 + x = 0 a half-swing in 80, 200 and 700 bits took them 8, 39 and 436
ms, the pieces from expansion to expansion 15, 74 and 1140 (with the spring x^3/2 beside it 2.1 to 3.4 times as long).
The two local expansions stay as well: beside the linear spring the wells' one, without the logarithms and the shared
rows of ``linear_spring``, took 1.6 times as long for the exponent 2, 2.2 to 2.8 for 3/2 and 3.3 for sqrt(2) (80 bits).

>>> from asymptotics.law import Law
>>> from asymptotics.flow.linear_spring.linear_spring import LinearSpring
>>> from asymptotics.flow.damping import Damping
>>> from asymptotics.flow.wells.even_well import EvenWell
>>> with ctx.workprec(100):
...     *_, last = half_swing_pieces(LinearSpring(Damping.of_law(Law({2: 1}))), arb(1), arb(0))
...     (last.turn + arb(0, last.miss)).str(20), last.time.str(20)
...     *_, last = half_swing_pieces(EvenWell.of(Law({2: "1/5"}, spring="pendulum").terms), arb(2), arb(0))
...     (last.turn + arb(0, last.miss)).str(20)
('[-0.41071968606103944670 +/- ...]', '[3.3809710603589252128 +/- ...]')
'[-1.2038040963510937100 +/- ...]'
"""

from collections.abc import Generator, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Protocol

from flint import arb

from asymptotics.errors import LimitError, UndecidedError
from asymptotics.flow.balls import size_of, upper
from asymptotics.flow.error_propagation import CarriedErrors, growth, state_gap, turning_delay
from asymptotics.flow.force import Force
from asymptotics.flow.taylor import TaylorStep
from asymptotics.flow.times import NearRest, at_time, later
from asymptotics.flow.turning import TurningState
from asymptotics.numbers.context import ctx
from asymptotics.running.budget import tick

MAX_PIECES, MAX_FREE, MAX_BEYOND = 200_000, 5000, 200
"""Pieces of a half-swing; of one that may be trapped, or turn, without either being seen; after the well was left.

A half-swing of moderate strength takes 20 to 40 pieces in 100 to 1000 bits, and one of them 0.7 ms or more: the first
limit is minutes, the second a separatrix; a motion beyond its well has no turning point to wait for.
"""
ESCAPES, ROTATES = "escapes", "rotates"
_BY_STEPS = "a creep by Taylor steps, as its slow curve is no short sum of powers yet"
# Choices of when to try what: earlier costs a try in vain, later some steps more; no bound rests on them.
_FAR = 2.0**-8  # of the start: a displacement where a falling speed that is lost in the error asks for more precision
_CATCH = 4  # every so many pieces a strip about the slow curve is tried
_NEAR = 10  # bits above the last one of the scale within which a place counts as the kink's


class LocalExpansion(NearRest, Protocol):
    """A local expansion that bounds the rates beside its turning point."""

    def speed(self, unit: arb, /) -> arb:
        """A bound of |(unit u', w')| within the reach, on both sides of the turning point."""


@dataclass(frozen=True)
class FlowState:
    """Where a piece begins: its time from the start of the half-swing, an exact place and speed, and the errors."""

    t: arb
    u: arb
    w: arb
    errors: CarriedErrors


@dataclass(frozen=True)
class CertifiedFlow:
    """A force, and what is known of its motions.  Places are u - ``shift`` in the force and in the pieces' orbits."""

    force: Force

    @property
    def shift(self) -> arb | None:
        """The place of rest that dry friction shifts."""
        return None

    @property
    def traps(self) -> bool:
        """Whether some loss may hold the mass on one side for ever."""
        raise NotImplementedError

    @property
    def endless(self) -> bool:
        """Whether there is always a next turning point, by a theorem."""
        return False

    def unit(self, _u: arb, _w: arb) -> arb:
        """The unit of the distance on a half-swing from the state (u, w): a choice."""
        raise NotImplementedError

    def expansion(self, place: arb) -> LocalExpansion:
        """The motion next to a turning point, for the speeds that are cheapest."""
        raise NotImplementedError

    def turns_within(self, place: arb, w: arb, error: arb) -> bool:
        """Whether the turning point ahead is near enough for its expansion: a choice."""
        raise NotImplementedError

    def arrive(self, place: arb, w: arb) -> LocalExpansion:
        """The expansion at an exact guess of the turning point of the orbit through the state."""
        raise NotImplementedError

    def ended(self, place: arb, w: arb) -> str | None:
        """Why no turning point follows from any state in the two balls, or why the motion has left its well."""
        raise NotImplementedError

    def leaves(self, _turn: arb) -> str | None:
        """How a motion goes on that turned at a place outside the well; None inside."""
        return None

    def closed(self, _u: arb, _w: arb, _given: arb) -> "ArrivedPiece | None":
        """The whole half-swing in closed form."""
        return None

    def along_slow_curve(self, _here: FlowState, _ended: str | None) -> Generator["Piece", None, FlowState | None]:
        """Pieces other than Taylor steps, beside a slow curve; what comes back is the state at their end, if any."""
        yield from ()
        return None

    def read_off(self, _u: arb, _given: arb) -> "tuple[LocalExpansion, Piece] | None":
        """The expansion from rest at u up to a piece that is known without steps, and that piece; its flow goes on."""
        return None

    def exact(self, _n: int) -> tuple[Fraction, bool] | None:
        """X at turning point n of the orbit from rest that is followed, and whether it stays there; None: not known."""
        return None

    def leap(self, _here: TurningState, _before: arb | None = None) -> TurningState | None:
        """The next turning point by another way than these pieces, if it pays and comes before that time."""
        return None

    def place(self, u: arb) -> arb:
        """u less the shift by dry friction: the place as the force counts it."""
        return u if self.shift is None else u - self.shift

    def back(self, place: arb) -> arb:
        """u at a place of the force: the place plus the shift."""
        return place if self.shift is None else place + self.shift


@dataclass(frozen=True)
class Piece:
    """The motion from the time ``begin`` to ``end`` (exact): its own orbit, within ``errors`` of the truth at the end.

    ``ended``: why no turning point follows (a trap) or why the motion left its well, else None.
    """

    flow: CertifiedFlow
    unit: arb
    begin: arb
    end: arb
    errors: CarriedErrors
    ended: str | None

    @property
    def error(self) -> arb:
        """The distance of the truth from the own orbit."""
        return self.errors.error

    def own(self, t: arb) -> tuple[arb, arb]:
        """(place, w) of the piece's own orbit at an exact time from ``begin`` to ``end``."""
        raise NotImplementedError


@dataclass(frozen=True)
class DeparturePiece(Piece):
    """From a turning point at ``begin``."""

    expansion: LocalExpansion

    def own(self, t: arb) -> tuple[arb, arb]:
        """(place, w) by the local expansion."""
        return at_time(self.expansion, t - self.begin)


@dataclass(frozen=True)
class Step(Piece):
    """A Taylor step; ``errors`` include its own."""

    taylor: TaylorStep

    def own(self, t: arb) -> tuple[arb, arb]:
        """(place, w) of the Taylor polynomials."""
        return self.taylor.state(t - self.begin)


@dataclass(frozen=True)
class ArrivedPiece(Piece):
    """The last piece: its own orbit turns at the exact u = ``turn`` at a time in ``clock``, of which ``end`` is the
    middle.  The orbit from the exact start of the half-swing turns within ``miss`` of ``turn``.
    """

    turn: arb
    miss: arb
    clock: arb

    def gap(self, given: arb) -> arb:
        """How far from ``turn`` an orbit turns that starts within ``given``, no more than the pieces were given."""
        return upper(self.miss + given)

    def late(self, given: arb) -> arb:
        """How much later or earlier than its own orbit such an orbit turns."""
        return turning_delay(self.flow.force, self.unit, self.flow.place(self.turn), self.gap(given), given)

    @property
    def time(self) -> arb:
        """When the orbit from the exact start turns."""
        return self.clock + arb(0, self.late(arb(0)))


@dataclass(frozen=True)
class ArrivalPiece(ArrivedPiece):
    """By the local expansion ahead: it passes the place and the speed ``beside`` within the errors ``begun``, and
    every distance grows by ``factor`` from there on."""

    expansion: LocalExpansion
    beside: tuple[arb, arb]
    begun: CarriedErrors
    factor: arb

    def own(self, t: arb) -> tuple[arb, arb]:
        """(place, w) by the local expansion."""
        return at_time(self.expansion, t - self.clock)

    def gap(self, given: arb) -> arb:
        """The distance when the piece begins, led on to the turning point."""
        turn, _ = self.expansion.state(arb(0))
        return state_gap(self.flow.force, self.unit, *self.beside, turn, self.begun.apart(given))

    def late(self, given: arb) -> arb:
        """The distance when its own orbit turns, in time."""
        turn, _ = self.expansion.state(arb(0))
        distance = upper(self.factor * self.begun.apart(given))
        return turning_delay(self.flow.force, self.unit, turn, self.gap(given), distance)


def half_swing_pieces(
    flow: CertifiedFlow, u: arb, w: arb, given: arb | None = None, *, pieces: int = MAX_PIECES
) -> Iterator[Piece]:
    """The pieces from the exact state (u, w >= 0) at time 0 to ``ArrivedPiece``, at the precision current at each call.

    ``given`` bounds the distance of the true state, in the distance of ``flow.unit``.  A piece that ended names why,
    and the half-swing goes on.  LimitError after ``pieces`` pieces, UndecidedError where the enclosures are too wide.
    """
    error = arb(0) if given is None else given
    closed = flow.closed(u, w, error)
    if closed is not None:
        yield closed
        return
    # The orbit from the exact start has no error yet.  One unit of places for all of it, so that distances compare.
    here, unit = FlowState(arb(0), u, w, CarriedErrors(arb(0), error)), flow.unit(u, w)
    scale, left = upper(unit * abs(u) + w), 0
    # The powers of w have no Taylor series in the time at rest.  A creep from rest is caught first, and never expanded.
    if w == 0:
        yield from flow.along_slow_curve(here, _ended(flow, unit, here))
        expansion, known = flow.read_off(u, error) or (None, None)
        first = _departure(flow, unit, here, expansion)
        yield from (first,) if known is None else (replace(first, end=known.begin), known)
        place, w = known.own(known.end) if known else (first.expansion.state(reach := first.expansion.reach)[0], reach)
        here, flow = after(known or first, place, w), known.flow if known else flow
    ended: str | None = None
    for count in range(pieces):
        tick(f"piece {count} of {'a half-swing' if ended in (None, ESCAPES, ROTATES) else _BY_STEPS}")
        # The end first: next to it w is small and a Taylor step, which must keep w > 0 on its disc, would be short.
        if flow.turns_within(flow.place(here.u), here.w, here.errors.error):
            yield _arrival(flow, unit, here)
            return
        # For the true state.  In a trap the motion goes on, for those who ask for a state at a time.
        ended = _ended(flow, unit, here)
        beside = (yield from flow.along_slow_curve(here, ended)) if count % _CATCH == 0 else None
        if beside is not None:
            here = beside
            continue
        if ended is None:
            _require_room(flow, unit, here, count, scale)
        step = _step(flow, unit, here, scale, ended)
        yield step
        left += ended in (ESCAPES, ROTATES)
        if left > MAX_BEYOND:
            break
        # From midpoints, whose distance from the enclosure is added: no ball is carried on, so nothing wraps.
        here = _at_a_kink(after(step, *step.taylor.state(step.taylor.length)), step, scale)
    where = "the motion is too stiff, leaves its well or is too near a separatrix"
    reason = f"one half-swing takes more than {pieces} pieces: {where}"
    raise LimitError("time", reason, "weaker damping, another start or strength, or a shorter time")


def _ended(flow: CertifiedFlow, unit: arb, here: FlowState) -> str | None:
    error = here.errors.error
    return flow.ended(flow.place(here.u) + arb(0, upper(error / unit)), here.w + arb(0, error))


def _require_room(flow: CertifiedFlow, unit: arb, here: FlowState, count: int, scale: arb) -> None:
    """UndecidedError where the place and the speed are lost in the errors, or a trap may be missed for ever."""
    error, place = here.errors.error, flow.place(here.u)
    # No larger than four times its error, the state is not told from rest.  A choice: the bounds hold all the same.
    lost = upper(unit * abs(place) + here.w) < 4 * error
    # Far from the centre and slower and slower: no further step will show whether the motion falls into the trap.
    if flow.traps and here.w < 4 * error and unit * place > _FAR * scale:
        lost = lost or flow.force.drag(place, here.w) > flow.force.restoring(place)
    if lost or (flow.traps and count > MAX_FREE):
        where = f"after {count} pieces of a half-swing: too near a separatrix for the working precision"
        raise UndecidedError(f"whether the motion turns or creeps home is undecided {where}")


def after(piece: Piece, place: arb, w: arb) -> FlowState:
    """The next exact state: midpoints, and what they drop."""
    u = piece.flow.back(place)
    return FlowState(piece.end, u.mid(), w.mid(), piece.errors.plus(upper(upper(piece.unit * u.rad()) + w.rad())))


def _at_a_kink(here: FlowState, step: Step, scale: arb) -> FlowState:
    """The state itself, or u = 0 if it is as near before a kink there as makes no difference."""
    start = step.taylor.us[0]
    # A step is cut off 2^8 last places before u = 0; from a start that is itself tiny, half of its own bits count as
    # near.  What the place is moved by enters the errors: too large a choice costs digits, and no truth.
    near = max(size_of(start) - ctx.prec / 2, size_of(scale) - ctx.prec + _NEAR)
    if step.flow.force.kinked and start > 0 and here.u > 0 and size_of(here.u) < near:
        return FlowState(here.t, arb(0), here.w, here.errors.plus(upper(step.unit * here.u)))
    return here


def _departure(flow: CertifiedFlow, unit: arb, here: FlowState, first: LocalExpansion | None = None) -> DeparturePiece:
    place, force = flow.place(here.u), flow.force
    # For the true start as well: s_0 > 0 is what makes the mass leave, and P_0 = s_0 divides in the expansion.
    if not force.restoring(place + arb(0, upper(here.errors.error / unit))) > 0:
        raise UndecidedError("whether dry friction holds the mass here is undecided")
    expansion = flow.expansion(place) if first is None else first
    end, tau = expansion.state(expansion.reach)
    if force.kinked and not end > 0:
        raise UndecidedError("the expansion at a turning point reaches a kink of the force")
    factor = growth(force, unit, place.union(end), arb(0).union(expansion.reach), tau, here.errors.error)
    # It ends at the exact time tau.mid(), up to which the speed ``reach`` is off by tau.rad() at the rate ``speed``.
    errors = here.errors.times(factor).plus(upper(tau.rad() * expansion.speed(unit)))
    return DeparturePiece(flow, unit, arb(0), tau.mid(), errors, None, expansion)


def _step(flow: CertifiedFlow, unit: arb, here: FlowState, scale: arb, ended: str | None) -> Step:
    """A Taylor step, with the growth of the distances along it."""
    taylor = _up_to_a_kink(flow.force, TaylorStep.at(flow.force, flow.place(here.u), here.w, unit, scale))
    # D' <= lambda D + residual: at most (D + integral of the residual) e^(lambda h), so the residual comes first.
    errors = here.errors.plus(taylor.residual)
    if not flow.force.nonexpansive:
        errors = errors.times(growth(flow.force, unit, *taylor.box, taylor.length, errors.error))
    return Step(flow, unit, here.t, later(here.t, taylor.length), errors, ended, taylor)


def _up_to_a_kink(force: Force, step: TaylorStep) -> TaylorStep:
    """The step; across a kink at u = 0 it ends just before it."""
    u, w = step.us[0], step.ws[0]
    if not (force.kinked and u > 0) or step.state(step.length)[0] > 0:
        return step
    # Newton's method for U(t) = 0, U' = -W: each round doubles the bits, and six more start it.
    t = (u / w).mid()
    for _ in range(6 + ctx.prec.bit_length()):
        t = min(t, step.length)
        place, speed = step.state(t)
        t = (t + place / speed).mid()
    # Earlier by 2^8 last places, so that U > 0 can be proved there, in the check below.
    early = (t - (step.length + u / w) * arb(2) ** (-ctx.prec + 8)).mid()
    if not (early > 0 and early < step.length and step.state(early)[0] > 0):
        raise UndecidedError("the passage of a kink of the force is too near for the working precision")
    return step.shortened(early)


def _arrival(flow: CertifiedFlow, unit: arb, here: FlowState) -> ArrivalPiece:
    """The last piece.  Two orbits that are some distance apart turn within the gap that the force allows."""
    start, w, force = flow.place(here.u), here.w, flow.force
    # The orbit that ends at a guess of the turning point is followed from now on; its distance from the state is added.
    expansion = flow.arrive(start, w)
    turn, _ = expansion.state(arb(0))
    place, time = expansion.state(w)
    if force.kinked and not turn * place > 0:
        raise UndecidedError("the expansion at a turning point reaches a kink of the force")
    at = flow.back(turn)
    begun = here.errors.plus(upper(upper(unit * (place - start)) + upper(unit * at.rad())))
    # The time of the expansion is negative here, from w = 0 backwards: -time is how long the piece lasts.
    factor = growth(force, unit, turn.union(place), arb(0).union(w), -time, begun.error)
    clock = here.t - time
    errors = begun.times(factor).plus(upper(clock.rad() * expansion.speed(unit)))
    miss = state_gap(force, unit, start, w, turn, begun.local)
    state_gap(force, unit, start, w, turn, begun.error)  # the truth turns as well, or that is undecided
    return ArrivalPiece(flow, unit, here.t, clock.mid(), errors, None,
                   at.mid(), miss, clock, expansion, (start, w), begun, factor)  # fmt: skip
