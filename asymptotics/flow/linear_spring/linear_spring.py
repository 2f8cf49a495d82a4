"""The flow beside the linear spring: what is known of its motions, for the half-swings of ``flow``.

Places are y = u - friction in the force; the unit of the distance is 1, and two motions never part (derivation
``motions-never-part``).  Besides the local expansions and Taylor steps a half-swing has here

* ``ToSlowCurve``: until a creep is known to lie beside the slow curve, where its speed is still lost in the errors;
* ``Creep``: for ever, once the motion is caught beside the slow curve, or as long as a strip about it goes;
* ``LinearPiece``: the only piece where linear damping below its critical strength and dry friction act alone.

>>> from asymptotics.law import Law
>>> from asymptotics.numbers.context import ctx
>>> with ctx.workprec(60):
...     flow = LinearSpring(Damping.of_law(Law({1: "1/5", 0: "1/50"})))
...     swing = flow.closed(arb(1), arb(0), arb(0))
>>> swing.turn.str(5), swing.time.str(5)
('[-0.69466 +/- ...]', '[3.1574 +/- ...]')
"""

from collections.abc import Generator, Iterator
from dataclasses import dataclass

from flint import arb

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import upper
from asymptotics.flow.damping import Damping
from asymptotics.flow.error_propagation import CarriedErrors
from asymptotics.flow.linear_spring.expansion import TurningExpansion
from asymptotics.flow.linear_spring.linear import LinearSolution, is_linear
from asymptotics.flow.linear_spring.trapping_regions import CREEPS, may_trap, trap
from asymptotics.flow.linear_spring.turning_point import arrive, turns_within
from asymptotics.flow.slow_manifold.attraction import attracted
from asymptotics.flow.slow_manifold.near_equal_exponents import FencedStretch, stretch
from asymptotics.flow.slow_manifold.slow_curve import FencedStrip, caught
from asymptotics.flow.slow_manifold.strong_damping import StrongDampingStrip, strong_damping_strip
from asymptotics.flow.times import later
from asymptotics.flow.trajectory import ArrivedPiece, CertifiedFlow, FlowState, Piece
from asymptotics.numbers.context import cached_property

_ONE, _EXACT = arb(1), CarriedErrors(arb(0), arb(0))


@dataclass(frozen=True)
class ToSlowCurve(Piece):
    """A short time in which the true state stays in the balls ``y`` and ``w``; ``error`` is 0."""

    y: arb
    w: arb

    def own(self, t: arb) -> tuple[arb, arb]:
        """The true state lies in these two balls all the time."""
        return self.y, self.w


@dataclass(frozen=True)
class Creep(Piece):
    """Beside the slow curve; the enclosures are those of the true state, and ``error`` is 0."""

    strip: FencedStrip

    def own(self, t: arb) -> tuple[arb, arb]:
        """(y, w) between the two barriers."""
        return self.strip.state(t - self.begin)


@dataclass(frozen=True)
class LinearPiece(ArrivedPiece):
    """All of the half-swing in closed form, up to the middle of ``clock``: if its own orbit has turned before, its
    friction has the wrong sign for as long as the radius, which is in ``error``."""

    orbit: LinearSolution

    def own(self, t: arb) -> tuple[arb, arb]:
        """(y, w) in closed form."""
        return self.orbit.state(t)


@dataclass(frozen=True)
class LinearSpring(CertifiedFlow):
    """The flow of a ``Damping``."""

    force: Damping

    @property
    def shift(self) -> arb | None:
        """The strength of dry friction, by which the centre of the half-swing is shifted."""
        return self.force.friction

    @cached_property
    def traps(self) -> bool:
        """An exponent below 1, or a linear term of 2 or more."""
        return may_trap(self.force)

    @cached_property
    def endless(self) -> bool:
        """Every alpha_i > 1, and no dry friction."""
        # The hypothesis of the derivation ``no-overdamping``: N(w)/w tends to 0 with w.
        return self.force.friction == 0 and bool(self.force.alphas) and all(a > 1 for a in self.force.alphas)

    @cached_property
    def _stiff(self) -> bool:
        # One exponent above 1, the case of ``strong_damping``; a linear law has its closed form.
        return not self.traps and len(self.force.alphas) == 1

    def unit(self, _u: arb, _w: arb) -> arb:
        """The unit of places is 1: in it two motions never part."""
        return _ONE

    def expansion(self, place: arb) -> TurningExpansion:
        """The local expansion, its coefficients shared."""
        return TurningExpansion.at(self.force, place)

    def turns_within(self, place: arb, w: arb, error: arb) -> bool:
        """Whatever the true speed: it turns, or just did."""
        # y + error < 0: every true place is on the side where w' <= y < 0.
        return bool(place + error < 0) and turns_within(self.force, place, w, error)

    def arrive(self, place: arb, w: arb) -> TurningExpansion:
        """The expansion of the orbit that turns nearly there."""
        return arrive(self.force, place, w)

    def ended(self, place: arb, w: arb) -> str | None:
        """Why no turning point follows (the state lies in a trap), or None; asked only where ``traps``."""
        return trap(self.force, place, w) if self.traps else None

    def closed(self, u: arb, w: arb, given: arb) -> LinearPiece | None:
        """Linear damping and dry friction alone."""
        if not is_linear(self.force):
            return None
        y = self.place(u)
        # Friction holds the mass where y <= 0.  The closed form has no trap to ask, as epsilon < 2.
        if w == 0 and not y > given:
            raise UndecidedError("whether dry friction holds the mass here is undecided")
        orbit = LinearSolution.of(self.force, y, w)
        time, there = orbit.turning()
        # If the own orbit turned within the radius before the end of the piece, friction acts the wrong way for at most
        # 2 radii at a difference of 2 friction in the acceleration.
        at, own = self.back(there), upper(4 * self.force.friction * time.rad())
        miss = upper(at.rad())
        return LinearPiece(self, _ONE, arb(0), time.mid(), CarriedErrors(miss, upper(given + own)), None,
                           at.mid(), miss, time, orbit)  # fmt: skip

    def along_slow_curve(self, here: FlowState, ended: str | None) -> Generator[Piece, None, FlowState | None]:
        """A creep for ever, where a strip holds it now or soon; or a strip about a slow curve that ends."""
        y, error = self.place(here.u), here.errors.error
        # Strips for ever need the motion to be trapped already.  ``caught`` first, as its strip follows the slow curve
        # to all digits; ``attracted`` where the speed is lost in the errors.  A creep that begins never returns here.
        if ended == CREEPS:
            strip = caught(self.force, y, here.w, error)
            if strip is not None:
                yield from self._creep(here.t, strip)
            found = attracted(self.force, y, here.w, error)
            if found is not None:
                end = later(here.t, found.wait)
                yield ToSlowCurve(self, _ONE, here.t, end, _EXACT, CREEPS, found.y, found.w)
                yield from self._creep(end, found.strip)
        # A strip that ends: a stiff motion above 1, or exponents that are nearly equal.
        finite = self._for_a_while(y, here.w, error) if here.w != 0 else None
        if finite is None:
            return None
        end = later(here.t, finite.length)
        yield Creep(self, _ONE, here.t, end, _EXACT, ended, finite)
        y, w = finite.state(finite.length)
        u = self.back(y)
        dropped = upper(u.rad() + w.rad())  # the strip holds the truth, whatever was known of the start
        return FlowState(end, u.mid(), w.mid(), CarriedErrors(dropped, dropped))

    def _for_a_while(self, y: arb, w: arb, error: arb) -> StrongDampingStrip | FencedStretch | None:
        if self._stiff and y > 0:
            return strong_damping_strip(self.force, y, w, error)
        return stretch(self.force, y, w, error)

    def _creep(self, t: arb, strip: FencedStrip) -> Iterator[Piece]:
        """Longer and longer pieces without an end."""
        # Doubling: a creep is asked for at times of any size, and log2(time) pieces lead there.
        length = arb(1)
        while True:
            yield Creep(self, _ONE, t, later(t, length), _EXACT, CREEPS, strip)
            length *= 2
