"""The flow in any even well: what is known of its motions, for the half-swings of ``flow``.

>>> from asymptotics.law import Law
>>> with ctx.workprec(60):
...     pendulum = EvenWell.of(Law({2: "1/5"}, spring="pendulum").terms)
>>> pendulum.unit(arb(2), arb(0)), pendulum.leaves(arb(4))
(1.00000000000000, 'rotates')
"""

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import size_of, upper
from asymptotics.flow.trajectory import CertifiedFlow
from asymptotics.flow.wells.expansion import WellExpansion
from asymptotics.flow.wells.force import WellForce
from asymptotics.flow.wells.rational_stops import Stop
from asymptotics.flow.wells.trapping_regions import beyond, inside, leaves, may_trap, trap
from asymptotics.flow.wells.turning_point import arrive, turns_within
from asymptotics.numbers.context import cached_property, ctx
from asymptotics.terms import Term

_LOW = 40


@dataclass(frozen=True)
class EvenWell(CertifiedFlow):
    """The flow of a ``WellForce``; ``stops``: the turning points from rest that are known exactly."""

    force: WellForce
    stops: tuple[Stop, ...] = ()

    @classmethod
    def of(cls, terms: Sequence[Term]) -> "EvenWell":
        """Of the terms of a dimensionless law, at the current precision."""
        return cls(WellForce.of(terms))

    @cached_property
    def traps(self) -> bool:
        """An exponent below 1, or a linear loss of 2 or more."""
        return may_trap(self.force)

    def unit(self, u: arb, w: arb) -> arb:
        """A power of two near the frequency at that amplitude."""
        with ctx.workprec(_LOW):
            return unit_for(self.force, upper(abs(u) + w))

    def expansion(self, place: arb) -> WellExpansion:
        """The local expansion at a turning point of this well."""
        return WellExpansion.at(self.force, place)

    def turns_within(self, place: arb, w: arb, _error: arb) -> bool:
        """By the energy, in doubles."""
        return turns_within(self.force, place, w)

    def arrive(self, place: arb, w: arb) -> WellExpansion:
        """The expansion of the orbit that turns nearly there."""
        return arrive(self.force, place, w)

    def ended(self, place: arb, w: arb) -> str | None:
        """Whether it has left the well, or is trapped in it."""
        # Leaving the well first: beyond it a trap means nothing.  Traps are asked for only where the force can have
        # one.
        return beyond(self.force, place) or (trap(self.force, place, w) if self.traps else None)

    def exact(self, n: int) -> Stop | None:
        """The n-th of the ``stops``, where it is one of them."""
        return self.stops[n] if n < len(self.stops) else None

    def leaves(self, turn: arb) -> str | None:
        """UndecidedError at the edge of the well."""
        stays = inside(self.force, turn)
        if stays is None:
            raise UndecidedError("whether the first turning point lies inside the well is undecided")
        return None if stays else leaves(self.force)


def unit_for(force: WellForce, size: arb) -> arb:
    """A power of two near the frequency at the amplitude ``size``: a choice."""
    with ctx.workprec(_LOW):
        # |lambda| = |G_u - unit^2|/(2 unit) (``flow.error_propagation``) is smallest where unit^2 is about the mean
        # slope, half of the steepest met at nine places.  Another unit makes distances grow a little faster; each step
        # proves its own factor.
        steepest = max((abs(force.slope(size * k / 8, arb(0))).upper() for k in range(9)), default=arb(1))
        return arb((1, round(size_of(steepest / 2) / 2)), 0)
