"""Route "dry": dry friction alone (alpha = 0), exactly: each half-swing costs 2 epsilon, until the mass sticks.

X'' + X + epsilon sign(X') = 0 is a harmonic motion about +-epsilon on each half-swing (Lelas 2024, section 2), so

    x_n = (-1)^n (1 - 2 n epsilon),    tau_n = n pi,    n = 0, 1, ..., N,

and the mass sticks at the first turning point with 1 - 2 N epsilon <= epsilon, off centre in general: the restoring
force is there at most the friction.  x_N may lie on the side it came from (1 - 2 N epsilon < 0).

After a start in motion the first half-swing has s X = c + R cos theta, c = epsilon, R^2 = (s x0 - c)^2 + v0^2; it
turns at theta = pi, at the amplitude a = R - c.  Where a/c is rational, ties are decided exactly; elsewhere another
route serves.

>>> from asymptotics.law import Law
>>> table = points(PointsRequest.read(Law({0: "3/10"}), 5, 10, times=True))
>>> [(p.n, p.x, p.tau) for p in table.points], table.ended
([(0, '1.000000000', '0'), (1, '-0.4000000000', '3.141592654'), (2, '-0.2000000000', '6.283185307')],
 {'n': 2, 'reason': 'sticks'})
"""

from fractions import Fraction

from flint import arb

from asymptotics.costs import closed_form_seconds
from asymptotics.flow.sequence import STICKS
from asymptotics.numbers.exact import ExactReal
from asymptotics.turning.dry_friction import amplitude_in_motion, half_swings_until
from asymptotics.turning.result import Number, TurningPoints, proved_digits, proved_point
from asymptotics.turning.route import Route
from asymptotics.turning.table import Ended, Points, PointsDone, PointsRequest, Progress

METHOD = "closed form, exact"


def last_turning_point(epsilon: ExactReal) -> int:
    """N: the smallest n >= 0 with (2 n + 1) epsilon >= 1, decided exactly; InputError unless epsilon > 0.

    >>> last_turning_point(ExactReal(Fraction(1, 3))), last_turning_point(ExactReal(Fraction(33, 100)))
    (1, 2)
    """
    return half_swings_until(ExactReal(1), epsilon, epsilon)


def serves(request: PointsRequest) -> float | None:
    """The seconds; None unless dry friction acts alone, and the first amplitude is a rational multiple of epsilon."""
    alone = request.alone
    if alone is None or alone[0] != 0 or (request.in_motion and _first_amplitude(request) is None):
        return None
    return closed_form_seconds(request.count, request.digits)


def points(request: PointsRequest, progress: Progress = lambda done: None) -> TurningPoints:
    """The turning points as far as they exist; all digits are correctly rounded."""
    if not request.in_motion:
        return request.table(*_from_rest(request, request.epsilon, 1, progress))
    a = _first_amplitude(request)
    assert a is not None
    c, v0 = request.epsilon, request.speed
    # s X = c + R cos theta at the start, theta in (0, pi): what is left to pi is the time to the turning point.
    y = (-1 if v0 > 0 else 1) * request.place - c
    tau = proved_digits(lambda: arb.pi() - arb.atan2(abs(v0.ball()), y.ball()), request.digits)
    first = {"amplitude": proved_digits(a, request.digits), "tau": tau}
    side = 1 if v0 > 0 else -1
    return request.table(*_from_rest(request, c / a, side, progress, first), first)


def _from_rest(
    request: PointsRequest, epsilon: ExactReal, side: int, progress: Progress, first: dict[str, str] | None = None
) -> tuple[Points, str, Ended]:
    """The points from X = ``side`` at rest, the method, and how they end."""
    last = last_turning_point(epsilon)
    with PointsDone(request) as kept:
        made = kept.begin(lambda: METHOD, first)
        for n in range(request.start, min(request.last, last) + 1):
            made.append(proved_point(n, _place(epsilon, n, side), _time(n) if request.times else None, request.digits))
            progress(len(made))
    ended = {"n": last, "reason": STICKS} if request.last >= last else None
    return tuple(made), METHOD, ended


def _first_amplitude(request: PointsRequest) -> ExactReal | None:
    """a = R - c of a start in motion, where a/c is rational and it moves on at all; else None."""
    alone, v0 = request.alone, request.speed
    if alone is None:
        return None
    a = amplitude_in_motion((-1 if v0 > 0 else 1) * request.place, alone[1], v0 * v0)
    return a if a is not None and a > 0 else None


def _place(epsilon: ExactReal, n: int, side: int) -> Number:
    # A rational place is rounded exactly, ties included; a root is rounded from balls, and no tie is possible.
    if epsilon.is_rational:
        return Fraction(side * (-1) ** n) * (1 - 2 * n * epsilon.rational)
    return lambda: side * (-1) ** n * (1 - 2 * n * epsilon.ball())


def _time(n: int) -> Number:
    return (lambda: arb.pi() * n) if n else Fraction(0)


DOMAIN = "dry friction alone, from rest or where the first amplitude is a rational multiple of epsilon"
ROUTE = Route("dry", DOMAIN, METHOD, serves, points)
