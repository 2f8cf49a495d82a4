"""A law, an oscillator or a mapping, read as what is meant: epsilons stay epsilons, and b's need their m, k and x0.

>>> oscillator_of({2: "1/10"})                           # a law alone: m = k = x0 = 1
Oscillator(x'' + x + 1/10 x'|x'| = 0, x(0) = 1, x'(0) = 0)
>>> oscillator_of(Oscillator({2: "1/10"}, mass=2).law)
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument law: its strengths are b in SI, and epsilon is meant (accepted: ...)
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from asymptotics.errors import InputError, shown
from asymptotics.frames import BARE, Frame, frame_of
from asymptotics.law import Law, Oscillator, of_unit_start
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import exact_number
from asymptotics.terms import Term


@dataclass(frozen=True)
class Given:
    """An oscillator, and the frame in which what it does is told.

    ``rests``: x0 = 0 and v0 = 0, of which no oscillator can be made: the start of this one stands in.
    """

    oscillator: Oscillator
    frame: Frame = BARE
    rests: bool = False

    @property
    def x_unit(self) -> str:
        """What x counts: m or rad, the start itself (x0), or the length in which the strengths are given."""
        law, pendulum = self.oscillator.law, any(t.family for t in self.oscillator.law.terms)
        if self.frame:
            return "rad" if pendulum else "m"
        if pendulum:
            return "rad"
        # A loss |x|^M and a spring have strengths that belong to a length.
        return "x0" if law.is_pure and self.oscillator.x0 == 1 else "strengths"


def given_of(value: Any) -> Given:
    """An oscillator in its units; a law or mapping of epsilons without any.

    >>> given_of({2: "1/10"}).frame == BARE, given_of(Oscillator({2: "1/10"})).frame.x
    (True, 'm')
    """
    return Given(oscillator_of(value), frame_of(value) if isinstance(value, Oscillator) else BARE)


def given_at_unit_start(value: Any) -> Given:
    """The same; a law whose units were taken off, with its strengths, is read as it is."""
    if isinstance(value, Oscillator):
        return given_of(value)
    return Given(of_unit_start(law_of(value)))


def oscillator_of(value: Any, spring: Any = None) -> Oscillator:
    """An oscillator as it is; a law or mapping of epsilons as the oscillator with m = k = x0 = 1 (no units)."""
    if isinstance(value, Oscillator):
        return value
    # m = k = x0 = 1 makes b and epsilon the same number, so that a law without units loses nothing on the way.
    return Oscillator(law_of(value), spring=spring)


def require_oscillator(value: Any) -> Oscillator:
    """``value`` if it is an oscillator; InputError otherwise."""
    if not isinstance(value, Oscillator):
        raise InputError("oscillator", f"{shown(value)} is no oscillator", "an Oscillator")
    return value


def law_of(value: Any) -> Law:
    """The dimensionless law of a law, a mapping, or an oscillator."""
    return value.dimensionless if isinstance(value, Oscillator) else Law.read(value)


def one_exponent(law: Any) -> tuple[ExactReal | None, Oscillator | None]:
    """The one exponent, None if it is a symbol, and the oscillator if there is a strength; InputError else."""
    if isinstance(law, str) and law.strip() == "symbolic":
        return None, None
    if not isinstance(law, Law | Oscillator | Mapping):
        return Term(1, exact_number(law, "alpha")).velocity, None
    oscillator = oscillator_of(law)
    return oscillator.law.terms[0].velocity, oscillator
