"""Turning points, half periods and stops, for exponents, strengths and sums of laws."""

from fractions import Fraction
from functools import partial

from asymptotics.law import Law
from asymptotics.numbers.exact import ExactReal
from asymptotics.running.cut_short import changed
from asymptotics.tables.cells import Cell, Nearest, Rows
from asymptotics.tables.inputs import SUMS, Inputs, label
from asymptotics.tables.recipe import Found, rows_in_progress
from asymptotics.turning.choose import turning_points
from asymptotics.turning.result import TurningPoints
from asymptotics.turning.routes.dry import last_turning_point

# Points of each law by default: enough to see how the decrement goes.
_ROWS = 5


def turning(inputs: Inputs, digits: int) -> Found:
    """Rows (law, n, x, tau, certified, ended): turning points and times until --rows of them or the end."""
    rows = rows_in_progress()
    certified = True
    for law in inputs.laws_or(SUMS):
        # Points of the law at which the time was over come after the rows of the laws before it.
        with changed(partial(_after, rows, law)):
            made = turning_points(law, inputs.count(_ROWS), digits, times=True)
        certified = certified and made.certified
        rows += _points(law, made)
    return Found(rows, certified)


def _after(rows: Rows, law: Law, made: TurningPoints) -> Rows:
    return rows + _points(law, made)


def _points(law: Law, made: TurningPoints) -> Rows:
    """The rows of one law."""
    rows: Rows = []
    for point in made.points:
        last = made.ended is not None and point.n == made.ended["n"]
        ended = str(made.ended["reason"]) if last and made.ended else ""
        x, tau = _x(law, point.n, point.x), _tau(point.n, str(point.tau))
        rows.append((label(law), str(point.n), x, tau, str(made.certified).lower(), ended))
    return rows


def half_periods(inputs: Inputs, digits: int) -> Found:
    """Rows (law, ratio, T, certified): the first half-swing from amplitude 1, where delta is epsilon."""
    rows = rows_in_progress()
    certified = True
    for law in inputs.laws_or((), ("1/10", "1/2", "1")):
        made = turning_points(law, 2, digits, times=True)
        certified = certified and made.certified
        # A law that sticks, creeps or is overdamped at once has no second turning point: the reason stands there
        # instead.
        if len(made.points) < 2:
            reason = str(made.ended["reason"]) if made.ended else ""
            rows.append((label(law), "", "", str(made.certified).lower(), reason))
            continue
        point = made.points[1]
        x = _x(law, 1, point.x)
        ratio = abs(x) if isinstance(x, Fraction) else Nearest(point.x.lstrip("-"))
        rows.append((label(law), ratio, Nearest(str(point.tau)), str(made.certified).lower(), ""))
    return Found(rows, certified)


def stops(inputs: Inputs, digits: int) -> Found:
    """Rows (epsilon, N, x_N, tau_N): where and when dry friction alone holds the mass."""
    rows = rows_in_progress()
    for epsilon in inputs.epsilons_or("1/100", "1/20", "1/10", "3/20", "1/5", "1/4", "3/10", "1/2"):
        # N is decided in exact arithmetic: at (2 N + 1) epsilon = 1 the mass sticks, and no ball could tell.
        law, last = Law({0: epsilon}), last_turning_point(epsilon)
        point = turning_points(law, 1, digits, start=last, times=True).points[0]
        rows.append((str(epsilon), str(last), _x(law, last, point.x), _tau(last, str(point.tau))))
    return Found(rows, True)


def _x(law: Law, n: int, text: str) -> Cell:
    """The turning point as an exact number where it is one: the start, and dry friction alone."""
    if n == 0:
        return Fraction(1)
    acting = [t for t in law.terms if t.strength.sign > 0]
    epsilon = acting[0].strength if len(acting) == 1 and acting[0].velocity.is_zero else None
    # Dry friction alone takes 2 epsilon from the amplitude on every half-swing (closed form of ``motions.coulomb``).
    if isinstance(epsilon, ExactReal) and epsilon.is_rational:
        return Fraction((-1) ** n) * (1 - 2 * n * epsilon.rational)
    return Nearest(text)


def _tau(n: int, text: str) -> Cell:
    return Nearest(text) if n else Fraction(0)
