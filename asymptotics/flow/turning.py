"""A turning point of an orbit that is followed, with its errors.

>>> at_rest(arb(-2)).x, at_rest(arb(-2)).tau
(-2.00000000000000, 0)
"""

from dataclasses import dataclass, replace
from fractions import Fraction

from flint import arb

from asymptotics.numbers.rationals import to_fmpq


@dataclass(frozen=True)
class TurningState:
    """Turning point n: the exact ``amplitude`` and ``time`` of the orbit followed, and how far the truth is at most.

    ``ended``: why it is the last one, or None.  ``side`` is the sign of X.  ``exact``: X where it is a rational number
    that is known, and whether the mass stays there.
    """

    n: int
    side: int
    amplitude: arb
    time: arb
    amplitude_error: arb
    time_error: arb
    ended: str | None = None
    exact: tuple[Fraction, bool] | None = None

    @property
    def x(self) -> arb:
        """X at the turning point."""
        return self.side * arb(self.amplitude, self.amplitude_error)

    @property
    def tau(self) -> arb:
        """The time of the turning point."""
        return arb(self.time, self.time_error)


def at_rest(X: arb) -> TurningState:
    """A start from rest at X != 0, at tau = 0."""
    # The orbit that is followed starts at the midpoint; the radius is the error of the amplitude from the first.
    return TurningState(0, 1 if X > 0 else -1, abs(X).mid(), arb(0), X.rad(), arb(0))


def at_exact_place(here: TurningState, exact: tuple[Fraction, bool] | None) -> TurningState:
    """The same turning point, at a place that is known exactly.

    ArithmeticError if its enclosure does not hold that place.
    """
    if exact is None:
        return here
    place = arb(to_fmpq(exact[0]))
    # Two routes to one number: an enclosure that misses the exact place is a fault of one of them, not of the input.
    if not here.x.overlaps(place):
        raise ArithmeticError(f"turning point {here.n} is enclosed away from {exact[0]}")
    amplitude = here.side * place
    return replace(here, amplitude=amplitude.mid(), amplitude_error=arb(amplitude.rad()), exact=exact)
