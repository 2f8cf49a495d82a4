"""Certificates of what was printed: a table of turning points, and motions at times.

>>> from asymptotics.turning.choose import turning_points
>>> table = turning_points(Law({"3/2": "1/10"}), 3, 12, times=True)
>>> print(*of_turning_points(Law({"3/2": "1/10"}), table).proved, sep="\\n")
x'' + 1 x + 1/10 sgn(x')|x'|^(3/2) = 0, x(0) = 1, x'(0) = 0
turning point 0: x = 1.00000000000 exactly t = 0 exactly
turning point 1: x = -0.870193291989 (known to 1e-16) t = 3.14608217222 (known to 1e-16)
turning point 2: x = 0.764131218388 (known to 1e-16) t = 6.29159801056 (known to 1e-16)
>>> from asymptotics.motions.reference import reference_motion
>>> drag = Oscillator({"3/2": "1/10"}, mass="3/2", stiffness="30", x0="1/5")
>>> of_states(drag, [("7", reference_motion(drag, "7", 12))], 12).proved[1][:33]
't = 7: x = 0.163853083447 (known '
"""

from collections.abc import Iterable, Sequence
from typing import Any, Protocol

from asymptotics.certificates.certificate import Certificate, certificate
from asymptotics.certificates.claims import Claim, Turned, rest_claim, state_claim, turning_claim
from asymptotics.errors import InputError
from asymptotics.law import Law, Oscillator, of_unit_start
from asymptotics.motions.certify import time_of
from asymptotics.motions.point import MotionPoint
from asymptotics.numbers.integers import require_integer
from asymptotics.numbers.policy import Number
from asymptotics.running.budget import DEFAULT_SECONDS

MAX_COUNT, MAX_DIGITS = 1000, 100


class PrintedPoints(Protocol):
    """Printed turning points, in units of the start or in SI."""

    @property
    def digits(self) -> int:
        """Of each number."""

    @property
    def points(self) -> Sequence[Turned]:
        """From some number on."""

    @property
    def ended(self) -> dict[str, Any] | None:
        """The last number, and why it is the last."""

    @property
    def certified(self) -> bool:
        """Whether its digits are claimed to be proved."""


def of_turning_points(
    law: Law | Oscillator, table: PrintedPoints, *, max_seconds: float = DEFAULT_SECONDS
) -> Certificate:  # fmt: skip
    """The places, the times where they were printed, and the stop under dry friction.

    A law alone: in units of the start, from rest; an oscillator: in SI.  InputError by name for what has no
    certificate, LimitError for more than ``max_seconds``, UndecidedError where no precision tried is enough.
    """
    _require_certified(table.certified)
    if getattr(table, "first", None) is not None:
        reason = "a start in motion has places in units of an amplitude that is itself computed"
        raise InputError("certificate", reason, "the same as an Oscillator, whose places are in m")
    if not table.points:
        raise InputError("certificate", "there is no turning point", "a motion that turns, or its states at times")
    claims = [turning_claim(p, table.digits) for p in table.points]
    if table.ended is not None and table.ended["reason"] == "sticks":
        claims.append(rest_claim(table.ended["n"]))
    oscillator = law if isinstance(law, Oscillator) else of_unit_start(law)
    return of_claims(oscillator, claims, max_seconds=max_seconds)


def of_states(
    oscillator: Oscillator, states: Iterable[tuple[Number, MotionPoint]], digits: int, *,
    max_seconds: float = DEFAULT_SECONDS,
) -> Certificate:  # fmt: skip
    """x and v at rational times, as the reference motion printed them; errors as `of_turning_points`."""
    claims = []
    for t, point in states:
        _require_certified(point.certified)
        moment = time_of(t)
        if not moment.is_rational:
            raise InputError("certificate", f"the time {moment} is not rational", "rational times")
        claims.append(state_claim(moment.rational, point.x, point.v, digits))
    return of_claims(oscillator, claims, max_seconds=max_seconds)


def of_claims(oscillator: Oscillator, claims: Sequence[Claim], *, max_seconds: float = DEFAULT_SECONDS) -> Certificate:
    """Claims within what is served: ``MAX_COUNT`` half-swings and ``MAX_DIGITS`` digits."""
    for claim in claims:
        require_integer(claim.get("digits", 1), "digits", 1, MAX_DIGITS)
        require_integer(claim.get("number", 0), "count", 0, MAX_COUNT)
    return certificate(oscillator, claims, max_seconds=max_seconds)


def _require_certified(certified: bool) -> None:
    if not certified:
        raise InputError("certificate", "what is printed is an estimate", "certified turning points and motions")
