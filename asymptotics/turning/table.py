"""A request for turning points, read once for every route, and the one rounding of what a route finds.

A route is asked for a `PointsRequest` (which law, from which start, which points, how many digits, with or without
times) and follows an orbit; the turning points of the orbit are rounded here, by one rule:

* from rest x_n is what the balls say: in units of x0 where the law is a sum of powers of the velocity, and in the units
  of the strengths beside a spring;
* after a start in motion turning point 0 is the unit and the origin of time: x_n = X_n/a and tau_n = time - t, with the
  amplitude a and the time t of turning point 0 told in ``first``.

A value that its enclosure cannot round asks for the bits that it lacks (``numbers.precision``).

>>> request = PointsRequest.read(Law({"3/2": "1/10", 2: 0}), 4, 12, start=2)
>>> request.law.alphas, request.last, request.alone is not None, request.in_motion
((ExactReal('3/2'),), 5, True, False)
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import arb

from asymptotics.errors import InputError
from asymptotics.flow.turning import TurningState
from asymptotics.law import Law
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.integers import require_integer
from asymptotics.numbers.policy import Number, exact_number
from asymptotics.running.budget import tick
from asymptotics.running.cut_short import keeping
from asymptotics.turning.result import TurningPoint, TurningPoints, proved_digits, proved_point

MAX_COUNT, MAX_DIGITS, MAX_START = 100_000, 10_000, 10**30

Progress = Callable[[int], None]
Points = tuple[TurningPoint, ...]
Ended = dict[str, Any] | None


@dataclass(frozen=True)
class PointsRequest:
    """Turning points n = start ... start + count - 1 of the motion from (``place``, ``speed``), ``digits`` of each."""

    law: Law
    count: int
    digits: int
    start: int = 0
    times: bool = False
    place: ExactReal = ExactReal(Fraction(1))
    speed: ExactReal = ExactReal(Fraction(0))

    @classmethod
    def read(
        cls,
        law: Any,
        count: int,
        digits: int,
        *,
        start: int = 0,
        times: bool = False,
        x0: Number = 1,
        v0: Number = 0,
        most: int = MAX_DIGITS,
    ) -> "PointsRequest":
        """The request, checked: InputError names the argument.  Powers of the velocity of strength 0 are left out.

        ``most``: the most digits; a caller who has checked what was asked may want more of them to compute with.
        """
        law = Law.read(law)
        law.require_dissipative("sequence of turning points to rest")
        require_counts(count, digits, start, most)
        place, speed = exact_number(x0, "x0"), exact_number(v0, "v0")
        if law.is_pure:
            if speed.is_zero and place != 1:
                reason = f"{x0}: from rest the unit of length is |x0|, X(0) = 1"
                raise InputError("x0", reason, "1, or a start with v0")
            # Terms of strength 0 would keep a closed form from serving; one is left where all are 0.
            law = Law.from_terms([t for t in law.terms if t.strength.sign > 0] or [law.terms[0]])
        return cls(law, count, digits, start, times, place, speed)

    @property
    def last(self) -> int:
        """The number of the last point asked for."""
        return self.start + self.count - 1

    @property
    def in_motion(self) -> bool:
        """Whether the start has a velocity."""
        return not self.speed.is_zero

    @property
    def alone(self) -> tuple[Fraction, ExactReal] | None:
        """(alpha, epsilon) where one power of the velocity acts, with a rational alpha and one number epsilon."""
        term = self.law.terms[0]
        if not self.law.is_pure or len(self.law.terms) > 1 or not term.velocity.is_rational:
            return None
        return (term.velocity.rational, term.strength) if isinstance(term.strength, ExactReal) else None

    @property
    def epsilon(self) -> ExactReal:
        """The strength of the one law that acts ``alone``."""
        assert self.alone is not None
        return self.alone[1]

    def table(
        self, points: Points, method: str, ended: Ended = None, first: dict[str, str] | None = None
    ) -> TurningPoints:
        """The result, with the losses by name."""
        alpha, epsilon = (",".join(str(getattr(t, n)) for t in self.law.losses) for n in ("velocity", "strength"))
        return TurningPoints(alpha, epsilon, self.digits, points, method, ended, first)


def require_counts(count: int, digits: int, start: int, most: int = MAX_DIGITS) -> None:
    """InputError unless count, digits and start are integers in range: the same for every law."""
    require_integer(count, "count", 1, MAX_COUNT)
    require_integer(digits, "digits", 1, most)
    require_integer(start, "start", 0, MAX_START)


class PointsDone(keeping):
    """``with PointsDone(request) as kept:`` an error carries the points of the attempt that came farthest."""

    def __init__(self, request: PointsRequest) -> None:
        super().__init__(self._table)
        self.request = request
        self.tried: list[tuple[list[TurningPoint], Callable[[], str], dict[str, str] | None]] = []

    def __enter__(self) -> "PointsDone":
        return self

    def begin(self, method: Callable[[], str], first: dict[str, str] | None = None) -> list[TurningPoint]:
        """Where an attempt puts its points, one by one; ``method`` and ``first`` as in the table."""
        self.tried.append(([], method, first))
        return self.tried[-1][0]

    def _table(self) -> TurningPoints | None:
        # Each point was rounded when it was put there, so that the attempt of any precision may be shown.
        farthest = max(self.tried, key=lambda attempt: len(attempt[0]), default=None)
        if farthest is None or not farthest[0]:
            return None
        made, method, first = farthest
        return self.request.table(tuple(made), method(), None, first)


def rounded(
    request: PointsRequest,
    turnings: Iterator[TurningState],
    unit: TurningState | None,
    progress: Progress,
    made: list[TurningPoint] | None = None,
) -> tuple[Points, Ended]:
    """The points asked for and how the sequence ends; ``unit``: turning point 0 of a start in motion.

    ``made``: where the points are put, one by one.  TooWideError as soon as a point cannot be rounded.
    """
    made = [] if made is None else made
    for here in turnings:
        tick(f"turning point {here.n}")
        if here.n >= request.start:
            made.append(_point(request, here, unit))
            progress(len(made))
        if here.ended is not None:
            return tuple(made), {"n": here.n, "reason": here.ended}
        if here.n >= request.last:
            break
    return tuple(made), None


def named(request: PointsRequest, unit: TurningState) -> dict[str, str]:
    """Turning point 0 of a start in motion, in words: its amplitude and its time."""
    return {"amplitude": proved_digits(size(unit), request.digits), "tau": proved_digits(unit.tau, request.digits)}


def size(here: TurningState) -> arb:
    """The amplitude with all that is uncertain about it."""
    return arb(here.amplitude, here.amplitude_error)


def _point(request: PointsRequest, here: TurningState, unit: TurningState | None) -> TurningPoint:
    # Exact where it is known: no ball rounds a tie such as x = 1/8 to two digits.
    x: arb | ExactReal | Fraction = request.place if here.n == 0 else here.x if here.exact is None else here.exact[0]
    tau = here.tau
    if unit is not None:
        x, tau = (arb(here.side), arb(0)) if here.n == 0 else (here.x / size(unit), tau - unit.tau)
    return proved_point(here.n, x, tau if request.times else None, request.digits)
