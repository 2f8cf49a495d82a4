"""Route "linear": linear damping alone (alpha = 1), in closed form: a geometric sequence, or none if overdamped.

X'' + epsilon X' + X = 0 from rest at X = 1.  For epsilon < 2, with mu = (epsilon/2)/sqrt(1 - epsilon^2/4),

    x_n = (-1)^n exp(-n pi mu),     tau_n = n pi/sqrt(1 - epsilon^2/4).

For epsilon >= 2 (critical damping included) X' has no zero after the start: the mass returns without passing X = 0.

>>> from asymptotics.law import Law
>>> first = points(PointsRequest.read(Law({1: "1/5"}), 2, 12, times=True)).points[1]
>>> first.x, first.tau
('-0.729247614288', '3.15741941700')
>>> points(PointsRequest.read(Law({1: 2}), 2, 12)).ended
{'n': 0, 'reason': 'overdamped'}
"""

from fractions import Fraction

from flint import arb

from asymptotics.costs import closed_form_seconds
from asymptotics.flow.linear_spring.trapping_regions import OVERDAMPED
from asymptotics.numbers.exact import ExactReal
from asymptotics.turning.result import TurningPoint, TurningPoints, proved_point
from asymptotics.turning.route import Route
from asymptotics.turning.table import PointsDone, PointsRequest, Progress

METHOD = "closed form, certified"


def serves(request: PointsRequest) -> float | None:
    """The seconds; None unless linear damping acts alone, from rest."""
    alone = request.alone
    if alone is None or alone[0] != 1 or request.in_motion:
        return None
    return closed_form_seconds(request.count, request.digits)


def points(request: PointsRequest, progress: Progress = lambda done: None) -> TurningPoints:
    """The turning points as far as they exist; all digits are correctly rounded."""
    epsilon = request.epsilon
    oscillates = epsilon < 2
    with PointsDone(request) as kept:
        made = kept.begin(lambda: METHOD)
        # epsilon < 2 is decided exactly; an overdamped motion has its start as the only turning point.
        for n in range(request.start, request.last + 1 if oscillates else min(request.last + 1, 1)):
            made.append(_point(epsilon, n, request.digits, request.times))
            progress(len(made))
    return request.table(tuple(made), METHOD, None if oscillates else {"n": 0, "reason": OVERDAMPED})


def _point(epsilon: ExactReal, n: int, digits: int, times: bool) -> TurningPoint:
    if n == 0:
        return proved_point(0, Fraction(1), Fraction(0) if times else None, digits)

    def frequency() -> arb:
        return (1 - (epsilon.ball() / 2) ** 2).sqrt()

    def place() -> arb:
        return arb(-1) ** n * (-n * arb.pi() * epsilon.ball() / 2 / frequency()).exp()

    return proved_point(n, place, (lambda: n * arb.pi() / frequency()) if times else None, digits)


ROUTE = Route("linear", "linear damping alone, from rest", METHOD, serves, points)
