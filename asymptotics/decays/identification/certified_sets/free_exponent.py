"""Which exponents and strengths of one loss meet every printed value: an outer box, proved strip by strip.

Monotone dependence on two parameters (differential inequalities, Walter 1998, section 9) makes two evaluations a proof
for a whole strip of exponents.

Let the largest amplitude of the table be the unit.  Speeds are then at most 1 all the way (no turning point lies
higher, and no speed exceeds the amplitude), so that e w^alpha falls when alpha grows and grows with e.  -s N/(1 - c N)
falls when N grows; by comparison of solutions of y' = f(theta, y), the loss -L of a half-swing falls with alpha and
grows with e.  A row asks l <= -L at its upper end and -L <= u at its lower one (``table_rows``).  For a strip
alpha_1 <= alpha <= alpha_2 and any e*:

    -L(alpha_1, e*) < l for some row:   no e <= e* meets it at any alpha of the strip;
    -L(alpha_2, e*) > u for some row:   no e >= e* does.

Both together exclude the strip, by two half-swings in balls; doubles choose e* and the rows.  Strips are laid from both
ends of the range towards a point that is proved to meet every row.  In what is left, each of the two conditions alone
bounds e.

>>> table = Decrements(np.array([1.0, 0.7, 0.4]), np.array([0.1, 0.049, 0.016]), np.full(3, 5e-4))
>>> found = exponents_that_fit(table)                                       # about 2, and D = (4/3) epsilon a^2
>>> found.verdict, bool(found.alpha.low < 2 < found.alpha.high < 2.1), found.epsilon.contains(0.075)
('consistent', True, True)
"""

from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from flint import arb
from scipy.optimize import brentq

from asymptotics.decays.identification.certified_sets.central_point import chebyshev_point
from asymptotics.decays.identification.certified_sets.certified_ratio import BITS, followed
from asymptotics.decays.identification.certified_sets.table_rows import exact
from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.decays.identification.fitting.profile import Interval
from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.forward.swing import MAX_FREE_ALPHA, HalfSwingModel
from asymptotics.errors import UndecidedError
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal

_FREE = read_candidate("free")
_FIRST, _LEAST, _SHARE, _PIECES = 0.5, 2.0**-12, 1 / 16, 8
"""Widths of strips in the exponent: of the first one, of the thinnest, and of the thinnest as a share of the distance
to the proved point; then the number of strips in each of which the strength is bounded.  Choices: thinner and more
strips make the box smaller at two half-swings each, and none of them decides what is proved."""
_WIDER, _DOUBLES = 1e-3, 1e-6
"""How far behind the ends that doubles find the proof is tried: a share of the length between them, and what the
doubles themselves may be wrong.  A smaller margin fails more often, and then no bound is given; a larger one makes the
interval longer."""
_STRENGTHS = 1e-9, 10.0
"""Where the doubles look for a root, in units of the largest amplitude: from no visible loss to one that leaves hardly
anything of the amplitude.  A root that is cut off there only makes the trial in balls fail."""


@dataclass(frozen=True)
class ExponentSet:
    """``alpha``, ``epsilon``: a box that holds every solution with 0 <= alpha <= 5 and epsilon >= 0."""

    verdict: str
    alpha: Interval | None = None
    epsilon: Interval | None = None
    reason: str = ""


def exponents_that_fit(table: Decrements) -> ExponentSet:
    """The certified set of one loss whose exponent is not known, for a table with a resolution."""
    with ctx.workprec(BITS):
        strips = _Strips.of(table)
        # -L >= 0 for every strength >= 0: a row whose largest decrement is negative refutes all exponents.
        if any(level < 0 for _, level in strips.upper):
            return ExponentSet("refuted", reason="the amplitude grows, and no strength >= 0 does that")
        least, theta = chebyshev_point(_FREE, table)
        # In doubles the point meets every row; only what balls confirm is claimed, of the very strength that is told.
        # least < 1 merely saves the trial.
        strength = float(theta[0] * table.reference ** (1 - theta[1]))
        point = theta if least < 1 and strips.meets(strength, float(theta[1])) else None
        # Strips from below, then from above towards what is left: the exponents between hold every solution.
        low = strips.excluded(0.0, MAX_FREE_ALPHA, None if point is None else float(point[1]))
        if low >= MAX_FREE_ALPHA:
            return ExponentSet("refuted", reason=f"no exponent from 0 to {MAX_FREE_ALPHA:g} meets every printed value")
        high = strips.excluded(MAX_FREE_ALPHA, low, None if point is None else float(point[1]))
        ends = strips.strengths(low, high)
    reach = "" if high < MAX_FREE_ALPHA else f"searched with 0 <= alpha <= {MAX_FREE_ALPHA:g}"
    if point is None:
        middle = None if ends is None else Interval(ends[0], (ends[0] + ends[1]) / 2, ends[1])
        said = "neither a point nor its absence could be proved" + (f"; {reach}" if reach else "")
        return ExponentSet("undetermined", Interval(low, (low + high) / 2, high), middle, said)
    epsilon = Interval(None, strength, None) if ends is None else Interval(ends[0], strength, ends[1])
    return ExponentSet("consistent", Interval(low, float(theta[1]), high), epsilon, reach)


@dataclass(frozen=True)
class _Strips:
    """Rows as (amplitude in units of the largest, level): ``lower`` ask -L >= level, ``upper`` -L <= level."""

    lower: tuple[tuple[arb, arb], ...]
    upper: tuple[tuple[arb, arb], ...]
    unit: arb
    swing: HalfSwingModel

    @classmethod
    def of(cls, table: Decrements) -> "_Strips":
        """The rows of a table, at the current precision."""
        assert table.resolution is not None
        sides: dict[int, list[tuple[arb, arb]]] = {1: [], -1: []}
        for a, d, r in zip(table.amplitude, table.decrement, table.resolution):
            for sign, rows in sides.items():
                half = (exact(d) - sign * exact(r)) / 2
                rows.append((exact(a) + half, ((exact(a) + half) / (exact(a) - half)).log()))
        unit = max((amplitude for rows in sides.values() for amplitude, _ in rows), key=arb.upper)
        lower, upper = (tuple((a / unit, level) for a, level in sides[sign]) for sign in (1, -1))
        swing = HalfSwingModel(_FREE.elements, free=True)
        # Doubles choose strengths and rows only: seven digits are more than a choice needs, and the series reaches
        # farther.
        swing.tolerance = 1e-7
        return cls(lower, upper, unit, swing)

    def meets(self, strength: float, alpha: float) -> bool:
        """Whether the strength (for x0 = 1 unit of the file) and the exponent are proved to meet every row."""
        power = ExactReal(Fraction(alpha))
        e = arb(strength) * ((power.ball() - 1) * self.unit.log()).exp()
        rows = [*((1, row) for row in self.lower), *((-1, row) for row in self.upper)]
        return all(self._shows(sign, row, e, power, miss=False) for sign, row in rows)

    def excluded(self, start: float, end: float, goal: float | None) -> float:
        """How far from ``start`` towards ``end`` strips are proved to hold no solution."""
        sign = 1.0 if end > start else -1.0
        place, width = start, _FIRST
        while (end - place) * sign > 0:
            # Near the point the strips may be thin, far from it not: the work is then logarithmic in the width that is
            # left.
            last = max(_LEAST, 0.0 if goal is None else abs(goal - place) * _SHARE)
            if width < last:
                break
            ahead = place + sign * min(width, abs(end - place))
            # A strip that holds the proved point cannot be empty: the trial is saved.
            if goal is not None and (goal - ahead) * sign <= 0:
                width /= 2
            elif self._is_empty(min(place, ahead), max(place, ahead)):
                # The next strip begins at the very double at which this one ends: no exponent is left between.
                place, width = ahead, 2 * width
            else:
                width /= 2
        return place

    def strengths(self, low: float, high: float) -> tuple[float, float] | None:
        """Bounds of epsilon (for x0 = 1 unit of the file) over low <= alpha <= high; None if they were not proved."""
        cuts = np.linspace(low, high, _PIECES + 1)
        # linspace may miss its ends by a rounding.
        cuts[0], cuts[-1] = low, high
        ends: list[float] = []
        for one, two in zip(cuts[:-1], cuts[1:]):
            least, most = self._root(1, one), self._root(-1, two)
            # The roots in doubles are moved outwards, so that balls can prove that there nothing is left.
            margin = _WIDER * abs(most - least) + _DOUBLES * most
            least, most = max(least - margin, least / 2), most + margin
            # The loss falls with alpha and grows with e: what is too weak at the lower end of a piece is too weak in
            # all of it, and what is too strong at the upper end too.
            if not (self._misses(1, one, least) and self._misses(-1, two, most)):
                return None
            for alpha in (one, two):
                # epsilon = e unit^(1 - alpha) is monotone in alpha, so that the ends of the piece bound it; outwards,
                # lower and upper.
                factor = ((1 - arb(float(alpha))) * self.unit.log()).exp()
                ends += [float((factor * arb(least)).lower()), float((factor * arb(most)).upper())]
        return float(np.nextafter(min(ends), -np.inf)), float(np.nextafter(max(ends), np.inf))

    def _is_empty(self, low: float, high: float) -> bool:
        """Whether two half-swings prove that no strength meets every row at any exponent of the strip."""
        least, most = self._root(1, low), self._root(-1, high)
        # In doubles some e may meet every row: no trial in balls. The 1e-9 decides that alone.
        if not least > most * (1 + 1e-9):
            return False
        # The e* of the docstring, as far in ratio from the rows it is too weak for as from those it is too strong for.
        middle = float(np.sqrt(least * most))
        return self._misses(1, low, middle) and self._misses(-1, high, middle)

    def _root(self, sign: int, alpha: float) -> float:
        """In doubles: the least strength that all lower rows allow, or the largest that all upper rows allow."""

        def gap(log_e: float) -> float:
            # Increasing in e: for sign 1 the lower row that is met last, for sign -1 the upper row that is exceeded
            # first.
            return sign * float((sign * self._gaps(sign, alpha, float(np.exp(log_e)))).min())

        low, high = np.log(_STRENGTHS[0]), np.log(_STRENGTHS[1])
        if gap(low) > 0 or gap(high) < 0:
            return _STRENGTHS[0] if gap(low) > 0 else _STRENGTHS[1]
        # Ten digits of a strength, which is proposed to the balls with a margin.
        return float(np.exp(brentq(gap, low, high, xtol=1e-10)))

    def _gaps(self, sign: int, alpha: float, e: float) -> Array:
        """In doubles: -L minus the level, in each row of one side; large where no turning point follows."""
        rows = self.lower if sign > 0 else self.upper
        a = np.log([float(amplitude.mid()) for amplitude, _ in rows])
        try:
            lost = -self.swing.at(a, np.array([e, alpha])).values[0]
        except TooStrongError:
            # e^-1000 of the amplitude: as good as no turning point, and finite for the search of a root.
            lost = np.full(len(a), 1e3)
        return np.asarray(lost - np.array([float(level.mid()) for _, level in rows]))

    def _misses(self, sign: int, alpha: float, e: float) -> bool:
        """Whether the row of one side that is missed most is proved to be missed."""
        rows = self.lower if sign > 0 else self.upper
        # The row is chosen in doubles; one row that is proved to be missed is enough.
        place = int(np.argmin(sign * self._gaps(sign, alpha, e)))
        return self._shows(sign, rows[place], arb(e), ExactReal(Fraction(float(alpha))), miss=True)

    def _shows(self, sign: int, row: tuple[arb, arb], e: arb, alpha: ExactReal, *, miss: bool) -> bool:
        """Whether balls prove that a row is missed, or met."""
        amplitude, level = row
        local = e * ((alpha.ball() - 1) * amplitude.log()).exp()
        try:
            # Followed, not summed: the exponent is any double, and a table of coefficients for each would cost more
            # than the half-swing.
            gap = sign * (-followed([(local, alpha)]) - level)
        except UndecidedError:
            return False
        # Neither holds for a ball that reaches across 0: undecided counts as not shown, either way.
        return bool(gap < 0) if miss else bool(gap >= 0)
