"""The motion within the half-swings of one ray, at any time: quarter-swings kept along their way, interpolated in z.

For the odd maps of ``half_swings``, where z -> -z is a quarter backwards in time.  In the notation of ``quarters``,
with one h for all strengths, so that one t is one angle theta, tan(theta/2) = e^(h (t-1)):

* at each of m nodes z_j of [-z, z] the polynomials G_j(t) and tau_j(t) are within ``apart`` and ``late`` of ln r and
  the time, for all -1 <= t <= 1 at once (Gronwall's inequality holds up to each t);
* at each theta ln r and tau - theta are analytic in z on the ellipse of R, and no larger there than G and the excess of
  the majorant, whose bounds grow with theta.  So the interpolant in z of G_j(t) is off by at most
  ``chebyshev.cut``(G, R, m) + sqrt(2m - 1) ``apart``, that of tau_j(t) accordingly;
* an uncertain z moves a sum of b_kl T_k(t) T_l by at most sum |b_kl| l^2 times it (Markov's inequality |T_l'| <= l^2).

Derivation ``quarter-courses``.

>>> from asymptotics.numbers.exact import ExactReal
>>> with ctx.workprec(100):
...     quadratic = Coordinate.of([(arb(1), ExactReal(2))])
...     courses = Courses.up_to(quadratic, arb("0.125"), 60)
...     quarter = courses.quarter(arb("0.1"))
...     (quarter.ln_r(arb(1)).str(10), quarter.time(arb(1)).str(10))     # as in ``quarters``
('[-0.06610623692 +/- ...]', '[1.604523150 +/- ...]')
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import acos

import numpy as np
from flint import arb, arb_mat, arb_poly, fmpz_poly
from numpy.polynomial.chebyshev import chebder, chebval

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import upper
from asymptotics.numbers.context import cached_property, ctx, lru_cache
from asymptotics.return_map.chebyshev import cut, nodes
from asymptotics.return_map.coordinate import Coordinate
from asymptotics.return_map.half_swings import HalfSwings, Quarters
from asymptotics.return_map.hand_overs import Bundle, doubles
from asymptotics.return_map.panel_plan import verified, widest
from asymptotics.return_map.quarters import FEWEST, NodeGrid, Path, found
from asymptotics.return_map.quarters_in_doubles import Array
from asymptotics.return_map.spectral import analysis, of_the_integral

_WORK = 24  # bits more than asked for: a choice
_LOW = 53  # bits of the bounds
_SPARE = 8  # bits of the way, of which the ellipse that is proved may be smaller than the one planned: a choice
_FIRST, _LAST = arb(-1), arb(1)
_SHARE = 0.93  # of the reach in doubles, as of ``half_swings``
_MOST = 500  # nodes along the way
_PLACES, _GIVEN_UP = 1024, 40  # of the table in doubles; rounds of the secant, which ends by itself after two or three


@dataclass(frozen=True)
class Along:
    """sum c_il t^i T_l(z), exact coefficients, within ``error`` of the function; ``slope``: of its change with z.

    ``in_doubles``: the coefficients of T_l(z) T_k(t), for choices."""

    table: arb_mat
    error: arb
    slope: arb
    in_doubles: Array

    @classmethod
    def of(cls, columns: list[list[arb]], noise: arb, fine: arb) -> "Along":
        """From the Chebyshev coefficients in t at each node of z, off by at most ``noise`` together with the cut."""
        # By T_l(z) T_k(t), |T_k T_l| <= 1: what is dropped counts in full, and so do the radii of the rest.
        kept, left_out = _without_last((analysis(len(columns), ctx.prec) * arb_mat(columns)).table(), fine)
        turned, dropped = _without_last([list(row) for row in zip(*kept)], fine)
        kept = [list(row) for row in zip(*turned)]
        rounded = sum((upper(arb(x.rad())) for row in kept for x in row), arb(0))
        slope = sum((k * k * _sizes(row) for k, row in enumerate(kept)), arb(0))
        exact = arb_mat([[x.mid() for x in row] for row in kept])
        with ctx.workprec(_precise(exact.ncols())):
            table = (exact * _powers(exact.ncols())).transpose()
        return cls(table, upper(noise + left_out + dropped + rounded), upper(slope), doubles(kept))

    def at(self, place: arb) -> tuple[arb_poly, arb]:
        """The polynomial in t at a ball of places on [-1, 1], and its error."""
        with ctx.workprec(_precise(self.table.nrows())):
            u, row = place.mid(), [arb(1), place.mid()]
            while len(row) < self.table.ncols():
                row.append(2 * u * row[-1] - row[-2])
            column = self.table * arb_mat([[x] for x in row[: self.table.ncols()]])
            # The place is exact here: the powers of t cancel, and what is uncertain of it counts beside them.
            return arb_poly([x for (x,) in column.table()]), upper(self.error + self.slope * arb(place.rad()))


@dataclass(frozen=True)
class QuarterCourse:
    """ln r and tau along a quarter-swing, by t, each with its error; ``table``: tau and d tau/dt in doubles."""

    courses: "Courses"
    growth: tuple[arb_poly, arb]
    clock: tuple[arb_poly, arb]
    table: list[Array]

    def ln_r(self, t: arb) -> arb:
        """At an exact t."""
        return self._value(self.growth, t)

    def time(self, t: arb) -> arb:
        """The time since (backwards: until) the turning point at an exact t."""
        return self._value(self.clock, t)

    def _value(self, function: tuple[arb_poly, arb], t: arb) -> arb:
        polynomial, error = function
        with ctx.workprec(_precise(len(polynomial))):
            value = polynomial(t)
        return value + arb(0, error)

    def near(self, times: Sequence[arb]) -> list[tuple[arb, arb, arb]]:
        """(r cos theta, r sin theta) in units of the amplitude at the turning point, and the time, nearly those."""
        (growth, apart), (clock, late) = self.growth, self.clock
        # Half of the bits: what is left of the time counts by its square (``Course``).
        guesses, fine, found = self._guesses(np.array([float(s) for s in times])), arb(2) ** (-ctx.prec // 2), []
        with ctx.workprec(_precise(max(len(growth), len(clock)))):
            for s, guess, rate in zip(times, *(part.tolist() for part in guesses), strict=True):
                t, time = _reached(clock, s, arb(guess), arb(rate), fine)
                found.append((t, growth(t), time))
        apart, late = arb(0, apart), arb(0, late)
        return [(*self._state(t, ln_r + apart), time + late) for t, ln_r, time in found]

    def _guesses(self, s: Array) -> tuple[Array, Array]:
        """t and d tau/dt at the times s in doubles: quintics between the places of a table with two derivatives."""
        times, rates, bends = self.table
        k = np.searchsorted(times[1:-1], s)
        width, step = times[k + 1] - times[k], 2 / _PLACES
        x = (s - times[k]) / width
        # Hermite's: by x, dt/dx less that of the chord and d^2 t/dx^2 at both places.
        a, b = (width / rates[j] - step for j in (k, k + 1))
        c, d = (-(width**2) * bends[j] / rates[j] ** 3 for j in (k, k + 1))
        first, last, xy = c / 2 + 2 * a + b, d / 2 - a - 2 * b, x * (1 - x)
        cubic, quintic = a - (a + b) * x, first + (last - first) * x
        t = -1 + step * (k + x) + xy * (cubic + xy * quintic)
        speed = step + (1 - 2 * x) * (cubic + 2 * xy * quintic) + xy * (xy * (last - first) - a - b)
        return np.minimum(np.maximum(t, -1), 1), width / speed

    def _state(self, t: arb, ln_r: arb) -> tuple[arb, arb]:
        e, r = (self.courses.h * (t - 1)).exp(), ln_r.exp()
        square = e * e
        below = r / (1 + square)
        return (1 - square) * below, 2 * e * below


def _reached(clock: arb_poly, s: arb, t: arb, slope: arb, fine: arb) -> tuple[arb, arb]:
    """An exact t on [-1, 1] and its time, nearly s: the t is a choice, by secants."""
    time = clock(t)
    for _ in range(_GIVEN_UP):
        off = (time - s).mid()
        if not abs(off) > fine or (there := min(max((t - off / slope).mid(), _FIRST), _LAST)) == t:
            break
        later = clock(there)
        slope, t, time = ((later - time) / (there - t)).mid(), there, later
    return t, time


@dataclass(frozen=True)
class Courses:
    """``growth`` (ln r) and ``clock`` of all quarter-swings with |z| <= ``last``, which have one ``h``.

    ``swings``: the half-swings put together from their ends.
    """

    last: arb
    h: arb
    growth: Along
    clock: Along
    swings: HalfSwings

    @classmethod
    def up_to(cls, coordinate: Coordinate, last: arb, bits: int) -> "Courses":
        """For -``last`` <= z <= ``last`` (exact), of a coordinate that ``is_quartered`` and ``is_odd``.

        ValueError for any other; UndecidedError, LimitError where quarter-swings do not serve.
        """
        if not (coordinate.is_quartered and coordinate.is_odd):
            raise ValueError("z -> -z is no quarter-swing backwards in time")
        bits = max(bits, FEWEST)
        with ctx.workprec(bits + _WORK):
            stretch = _SHARE * widest(coordinate, 0.0, float(last), whole=False)
            ellipse = verified(coordinate, arb(0), last, stretch, whole=False)
            count = ellipse.nodes_for(bits)
            # An even count has no node at z = 0, where no law is left.
            places = [last * t for t in nodes(count + count % 2)]
            bundle = Bundle.together([(coordinate.damping(abs(z)), 1 if z > 0 else -1) for z in places])
            along, rim = bundle.in_doubles.planned(bits + _SPARE)
            if along > _MOST:
                raise UndecidedError("the quarter-swings need too many nodes")
            grid = NodeGrid.of(bundle, along)
            path = Path.along(grid, found(grid, bits))
            apart, late = path.errors(rim)
            fine, noisy = arb(2) ** -bits, arb(2 * len(places) - 1).sqrt()
            rates = zip(*(analysis(along, ctx.prec) * arb_mat(path.slowness)).table())
            growth, clock = (
                Along.of([_integrated(list(c), x) for c, x in zip(slopes, starts)], upper(bound + noisy * off), fine)
                for slopes, starts, bound, off in (
                    (zip(*path.kept), bundle.g0, cut(ellipse.majorant.growth, ellipse.R, len(places)), apart),
                    (rates, bundle.times, cut(ellipse.majorant.excess, ellipse.R, len(places)), late),
                )
            )
            quarters = Quarters.of(path.enclosed(rim), ellipse, arb(0), last, bits)
            swings = HalfSwings.mirrored(coordinate.root, quarters, last, bits)
            return cls(last, bundle.h[0], growth, clock, swings)

    def quarter(self, z: arb) -> QuarterCourse:
        """The quarter-swing at a ball of places; UndecidedError beyond the interval."""
        place = z / self.last
        if not abs(place) <= 1:
            raise UndecidedError("an amplitude is outside the interval of the quarter-swings")
        return QuarterCourse(self, self.growth.at(place), self.clock.at(place), self._table(float(place)))

    def _table(self, place: float) -> list[Array]:
        weights = np.cos(acos(max(-1.0, min(place, 1.0))) * np.arange(len(self.in_doubles[0])))
        return [weights @ part for part in self.in_doubles]

    @cached_property
    def in_doubles(self) -> list[Array]:
        """tau, d tau/dt and d^2 tau/dt^2 by T_l(z), at equal steps of t."""
        b, t = self.clock.in_doubles.T, np.linspace(-1, 1, _PLACES + 1)
        return [np.asarray(chebval(t, chebder(b, order)), float) for order in range(3)]


def _integrated(b: list[arb], start: arb) -> list[arb]:
    """The Chebyshev coefficients of ``start`` and the integral from -1 of sum b_k T_k."""
    rest = of_the_integral(b)
    # T_k(-1) = (-1)^k: what the others are at -1 is taken off.
    return [start - sum((-c if k % 2 == 0 else c for k, c in enumerate(rest)), arb(0)), *rest]


def _without_last(rows: list[list[arb]], fine: arb) -> tuple[list[list[arb]], arb]:
    """The rows up to the last one that matters, and the sum of the sizes of all others, at most ``fine``."""
    left_out, last = arb(0), len(rows) - 1
    while last and not (more := upper(left_out + _sizes(rows[last]))) > fine:
        left_out, last = more, last - 1
    return rows[: last + 1], left_out


def _sizes(row: list[arb]) -> arb:
    with ctx.workprec(_LOW):
        return sum((upper(x) for x in row), arb(0))


def _precise(terms: int) -> int:
    """Bits at which powers of t may cancel: the coefficients of T_n add up to at most (1 + 2^(1/2))^n = 2^(1.28 n)."""
    return ctx.prec + 8 + terms * 4 // 3


@lru_cache(maxsize=8)
def _powers(terms: int) -> arb_mat:
    """T_k in powers of t, row by row."""
    rows = [[int(c) for c in fmpz_poly.chebyshev_t(k).coeffs()] for k in range(terms)]
    return arb_mat([[arb(c) for c in row] + [arb(0)] * (terms - len(row)) for row in rows])
