"""What states x(t) by the method of a route to the turning points, and the one law alone that a closed form takes.

A file of this room that knows a motion says so by one `StateRoute`, with the names of the routes in ``turning.routes``
that rest on the same formula or on the same flow; ``reference`` asks them in turn.
"""

from collections.abc import Callable
from dataclasses import dataclass

from asymptotics.errors import InputError
from asymptotics.law import Oscillator, PhysicalLaw
from asymptotics.motions.point import MotionPoint
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number
from asymptotics.terms import Scaled


@dataclass(frozen=True)
class StateRoute:
    """``state(oscillator, t, digits, static)`` is the state at the time t, or None where this method does not serve.

    ``names``: the routes to the turning points that go the same way.
    """

    names: tuple[str, ...]
    state: Callable[[Oscillator, ExactReal, int, Number | None], MotionPoint | None]


def alone(oscillator: Oscillator, alpha: int) -> Oscillator | None:
    """The oscillator under the one term that acts, if it is the power ``alpha`` of the velocity, with b > 0; else None.

    Without a term that acts alpha is 1: no damping is linear damping of strength 0.
    """
    law = oscillator.law
    acting = tuple(t for t in law.terms if not t.strength.is_zero)
    if not law.is_pure or len(acting) > 1 or (acting[0].velocity if acting else 1) != alpha:
        return None
    # A strength that is a product of roots has no place in the exact solutions; integration takes it.
    if acting and (isinstance(acting[0].strength, Scaled) or not acting[0].strength > 0):
        return None
    return oscillator.with_law(PhysicalLaw.from_terms(acting or law.terms[:1], law.notes))


def require_alone(oscillator: Oscillator, alpha: int, name: str) -> Oscillator:
    """The same; InputError where another term acts, or none of that power, alpha = 0 or 2."""
    law = oscillator.law
    law.require_pure("the exact solution")
    found = alone(oscillator, alpha)
    if found is None:
        raise InputError("law", f"{law} is not {name} alone", f"one term, alpha = {alpha} and b > 0")
    return found
