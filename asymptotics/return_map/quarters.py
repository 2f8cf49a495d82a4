"""Quarter-swings of one law at many strengths at once, from a turning point to the centre, forwards or backwards.

In polar coordinates, theta from the turning point, with +delta_i forwards and -delta_i backwards in time,

    z = ln tan(theta/2),  s = 1/cosh z,  c = -tanh z,     D = sum_i (+-delta_i) s^alpha_i e^((alpha_i-1) g),  g = ln r,
    dg/dz = -s^2 D/(1 - c D),        d tau/dz = s/(1 - c D):

no real z is singular, and s^alpha is analytic for |Im z| < pi/2.  The local expansion at the turning point
(``expansion``) leads to a small speed, where z = z_0 within dz and g = g_0 within dg; from there to z = 0 one
polynomial in t does it for each strength, z = h (t - 1), h = -z_0/2, -1 <= t <= 1.

*Found*: in doubles (``quarters_in_doubles``), then residuals in balls and corrections in doubles.  Choices.

*Enclosed*: let G = g_0 + the integral of any polynomial P, and f(t) the right-hand side dg/dt along G.

* On the ellipse of parameter R about [-1, 1], |G - gamma| <= B by its Chebyshev coefficients.  If h (R - 1/R)/2 <
  pi/2, s and c D are analytic there; |c D| <= kappa < 1 on the rim holds inside, and there |f| <= M = h max |s^2 D|/
  (1 - kappa) and |d tau/dt| <= N = h max |s|/(1 - kappa).
* So f differs by at most ``chebyshev.cut`` from the polynomial through its values at m nodes, and that from P by at
  most sqrt(2m - 1) times the largest difference at a node: |f - P| <= eta.
* On the real line |s^alpha c| <= (alpha^alpha/(1+alpha)^(1+alpha))^(1/2) gives a smaller kappa, and the right-hand
  sides change with g at most at the rates h s^2 D'/(1 - kappa)^2 and h s |c| D'/(1 - kappa)^2, D' = sum |alpha_i - 1|
  |delta_i| e^((alpha_i-1) g) s^alpha_i.  With dz = d theta/s their integrals along the quarter are those of sin and cos
  at most: no more than K = sum |alpha_i - 1| |delta_i| e^((alpha_i-1) g)/(1 - kappa)^2.  So (Gronwall)

    |g - G| <= e^K (|g - G|(-1) + 2 eta),    |g - G|(-1) <= dg + dz sum |delta_i| e^((alpha_i-1) g)/(1 - kappa),

  and the time is off by the cut of its integrand, by K max |g - G| and by dz max |d tau/dz| <= dz/(1 - kappa).

Derivation ``quarter-collocation``.

>>> from fractions import Fraction
>>> from asymptotics.numbers.exact import ExactReal
>>> with ctx.workprec(140):
...     law = Damping.of([(arb(1) / 10, ExactReal(Fraction(2)))])
>>> forwards, backwards = quarter_swings([(law, 1), (law, -1)], 90)
>>> forwards.ln_r.str(10), forwards.duration.str(10)
('[-0.06610623692 +/- ...]', '[1.604523150 +/- ...]')
>>> backwards.ln_r.str(10), backwards.duration.str(10)
('[0.06721722457 +/- ...]', '[1.537860788 +/- ...]')
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce

import numpy as np
from flint import arb, arb_mat, arb_poly, fmpq

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import upper
from asymptotics.flow.damping import Damping
from asymptotics.numbers.context import ctx
from asymptotics.return_map.chebyshev import cut, nodes
from asymptotics.return_map.hand_overs import Bundle, doubles, largest
from asymptotics.return_map.quarters_in_doubles import Array, corrected
from asymptotics.return_map.spectral import analysis, integrals, of_the_integral
from asymptotics.running.budget import tick

# Bits of the matrices beyond the answer's, and of the bounds.
_WORK, _LOW = 24, 53
FEWEST = 30  # bits: fewer would not keep G near
# 53 less a few that rounding in long sums takes; a smaller gain costs rounds, and a larger one would not be reached.
_GAIN = 50  # bits that a correction in doubles brings
_MOST = 500  # nodes: their matrices have 10^5 entries
# Arcs of the upper half of the rim, ball by ball: more make M and N sharper.  Ellipses tried, each 4 per cent nearer to
# R = 1: 12 of them go down to 0.6 of the planned excess.
_ARCS, _TRIES = 64, 12
# Far more than |g - G| ever is, 2^-30 at the least precision, and too little to change the slopes.
_NEAR = 2.0**-20  # the distance from G within which the slopes are bounded

Rows = list[list[arb]]


@dataclass(frozen=True)
class Quarter:
    """ln r at the centre, where r = 1 at the turning point, and the time in between."""

    ln_r: arb
    duration: arb


def quarter_swings(laws: Sequence[tuple[Damping, int]], bits: int) -> list[Quarter]:
    """The quarters from the amplitude 1 for strengths of one law, each forwards (1) or backwards (-1).

    UndecidedError where no enclosure is found.
    """
    bits = max(bits, FEWEST)
    with ctx.workprec(bits + _WORK):
        bundle = Bundle.of(laws)
        count, rim = bundle.in_doubles.planned(bits)
        if count > _MOST:
            raise UndecidedError("the quarter-swings need too many nodes")
        grid = NodeGrid.of(bundle, count)
        path = Path.along(grid, found(grid, bits))
        return path.enclosed(rim)


@dataclass(frozen=True)
class NodeGrid:
    """What does not depend on g at the ``count`` nodes of each column.

    ``places``: h s, h s^2, c, the sum of delta_i s^alpha_i over alpha_i = 1, and those with the other ``weights``
    alpha_i - 1.
    """

    bundle: Bundle
    count: int
    weights: tuple[arb, ...]
    places: tuple[tuple[tuple[arb, arb, arb, arb, tuple[arb, ...]], ...], ...]

    @classmethod
    def of(cls, bundle: Bundle, count: int) -> "NodeGrid":
        """The nodes of all columns, ``count`` in each."""
        ends, places = [t - 1 for t in nodes(count)], []
        still = [i for i, a in enumerate(bundle.alphas) if a == 1]
        # alpha = 1 exactly needs no exponential of g; a ball about 1 is treated as any other exponent.
        moving = [(i, a) for i, a in enumerate(bundle.alphas) if i not in still]
        for h, strengths in zip(bundle.h, bundle.strengths):
            tick("the nodes of a quarter-swing")
            linear, column = sum((strengths[i] for i in still), arb(0)), []
            for end in ends:
                e = (h * end).exp()
                square = e * e
                below = 1 / (1 + square)
                s = 2 * e * below
                hs = h * s
                drags = tuple(strengths[i] * s**a for i, a in moving)
                column.append((hs, hs * s, (1 - square) * below, linear * s, drags))
            places.append(tuple(column))
        return cls(bundle, count, tuple(a - 1 for _, a in moving), tuple(places))

    def rates(self, g: Rows) -> Rows:
        """f = dg/dt at the nodes (rows) of all columns."""
        weights, found = self.weights, []
        for row, places in zip(g, zip(*self.places)):
            line = []
            for value, (_, hss, c, drag, drags) in zip(row, places):
                for w, d in zip(weights, drags):
                    drag = drag + d * (w * value).exp()
                # dg/dt = h dg/dz, with the sign in the denominator.
                line.append(hss * drag / (c * drag - 1))
            found.append(line)
        return found

    def slowness(self, rates: Rows) -> Rows:
        """d tau/dt from f: h s/(1 - c D) = h s + (c/s) h s^2 D/(1 - c D)."""
        return [
            [hs - c * f * hs / hss for f, (hs, hss, c, _, _) in zip(row, places)]
            for row, places in zip(rates, zip(*self.places))
        ]


def found(grid: NodeGrid, bits: int) -> arb_mat:
    """f at the nodes, nearly: exact numbers, corrected in doubles until that is enough."""
    in_doubles, m = grid.bundle.in_doubles, grid.count
    values, sums = analysis(m, ctx.prec), arb_mat(integrals(m, ctx.prec).table()[:m])
    g0, g = arb_mat([list(grid.bundle.g0)] * m), arb_mat(in_doubles.solved(m).tolist())
    for k in range(1, 3 + bits // _GAIN):
        tick("quarter-swings by collocation")
        # Iterative refinement: the residual g_0 + integral of f - g in balls, scaled up until a double holds it, the
        # linear equation for the correction solved in doubles.
        unit, rows = arb(2) ** (-k * _GAIN), g.table()
        rates = arb_mat(grid.rates(rows)).mid()
        missing = doubles(((g0 + sums * (values * rates) - g) * (1 / unit)).table())
        _, slope = in_doubles.rates(doubles(rows))
        change = corrected(slope, missing)
        # One more correction of 50 bits reaches 2^-bits; it goes into f, as P is the polynomial through f.
        if np.max(np.abs(missing)) < 2.0 ** ((k + 1) * _GAIN - bits):
            return moved(rates, slope * change, unit)
        g = moved(g, change, unit)
    raise UndecidedError("the corrections of the quarter-swings do not converge")


def moved(rows: arb_mat, change: Array, unit: arb) -> arb_mat:
    """The rows and ``unit`` times the change."""
    return (rows + arb_mat(change.tolist()) * unit).mid()


@dataclass(frozen=True)
class Path:
    """G and what is known along it: ``ends`` at t = 1, ``slowness`` = d tau/dt at the nodes.

    ``differs``: eta without the cut, sqrt(2m - 1) times the most that P and f differ at a node; ``loads``: the largest
    |delta_i| e^((alpha_i-1) gamma), gamma the first Chebyshev coefficient of G, and ``sizes``: those of the others.
    """

    grid: NodeGrid
    ends: tuple[arb, ...]
    slowness: Rows
    differs: arb
    loads: tuple[arb, ...]
    sizes: arb_poly
    kept: Rows

    @classmethod
    def along(cls, grid: NodeGrid, rates: arb_mat) -> "Path":
        """P is the polynomial through the exact ``rates`` without its last, negligible coefficients."""
        m, bundle, none = grid.count, grid.bundle, arb(0)
        b = (analysis(m, ctx.prec) * rates).table()
        degree, lacking, negligible = m - 1, arb(0), arb(2) ** (_WORK - ctx.prec)
        # Dropped coefficients count in full, |T_k| <= 1, and so do the radii of the kept ones: P is an exact
        # polynomial.
        while degree and not (more := upper(lacking + largest(b[degree]))) > negligible:
            lacking, degree = more, degree - 1
        kept = [[x.mid() for x in row] if k <= degree else [none] * len(row) for k, row in enumerate(b)]
        lacking += sum((largest(x.rad() for x in row) for row in b[: degree + 1]), none)
        grown = (integrals(m, ctx.prec) * arb_mat(kept)).table()
        *g, ends = [[a + x for a, x in zip(bundle.g0, row)] for row in grown]
        # f along G itself, at the nodes: what P misses it by there is the only thing measured; the theorem does the
        # rest.
        slopes = grid.rates(g)
        apart = largest((rates - arb_mat(slopes)).entries())
        with ctx.workprec(_LOW):
            columns = [of_the_integral(list(column)) for column in zip(*kept[: degree + 1])]
            # G(1) = gamma + the other coefficients, as T_k(1) = 1.
            centres = [end - sum(column, none) for end, column in zip(ends, columns)]
            loads = [
                largest(e * ((alpha - 1) * gamma).exp() for e, gamma in zip(row, centres))
                for alpha, row in zip(bundle.alphas, zip(*bundle.strengths))
            ]
            sizes = [none, *map(largest, zip(*columns))]
            differs = upper(arb(2 * m - 1).sqrt() * apart + lacking)
        return cls(grid, tuple(ends), grid.slowness(slopes), differs, tuple(loads), arb_poly(sizes), kept)

    def drags(self, B: arb) -> list[arb]:
        """Bounds of |delta_i e^((alpha_i-1) g)| where |g - gamma| <= B."""
        return [load * (abs(a - 1) * B).exp() for load, a in zip(self.loads, self.grid.bundle.alphas)]

    def on_ellipse(self, R: arb) -> tuple[arb, arb] | None:
        """(M, N): bounds of |f| and |d tau/dt| along G on the ellipse of parameter R; None where it may be singular."""
        # The half axes; Im z reaches h b, and s is analytic where that is below pi/2.
        a, b = (R + 1 / R) / 2, (R - 1 / R) / 2
        h = reduce(arb.union, self.grid.bundle.h)
        if not h * b < arb.pi() / 2:
            return None
        # |T_k| <= (R^k + R^-k)/2 on the ellipse.
        drags = self.drags((self.sizes(R) + self.sizes(1 / R)) / 2)
        kappa, fast, slow = arb(0), arb(0), arb(0)
        # The upper half of the rim in balls; the lower one is its mirror image, as everything is real on the real line.
        # By the maximum principle |c D| <= kappa inside as well, so that f has no pole there.
        for j in range(_ARCS):
            angle = arb(fmpq(2 * j + 1, 2 * _ARCS), fmpq(1, 2 * _ARCS))
            x, y = h * (a * arb.cos_pi(angle) - 1), h * b * arb.sin_pi(angle)
            # |cosh z|^2 = 1/|s|^2; |c|^2 has sin^2 y in place of cos^2 y in its numerator (derivation
            # ``quarter-collocation``).
            under = x.sinh() ** 2 + y.cos() ** 2
            if not under > 0:
                return None
            s = (1 / under).sqrt()
            drag = sum((d * s**e for d, e in zip(drags, self.grid.bundle.alphas)), arb(0))
            kappa = kappa.max(upper(drag * ((x.sinh() ** 2 + y.sin() ** 2) / under).sqrt()))
            fast, slow = fast.max(upper(s * s * drag)), slow.max(upper(s))
        if not kappa < 1:
            return None
        return upper(h * fast / (1 - kappa)), upper(h * slow / (1 - kappa))

    def errors(self, rim: float) -> tuple[arb, arb]:
        """How far g and the time are from G and the integral of ``slowness`` at most, at any t.

        With the largest ellipse up to R = ``rim`` on which M and N are proved.
        """
        bundle, m = self.grid.bundle, self.grid.count
        with ctx.workprec(_LOW):
            # From the planned ellipse inwards: the first that is proved is the largest, and the cut is smallest on it.
            tried = ((R, self.on_ellipse(R)) for R in (1 + arb(rim - 1) * arb(0.96) ** k for k in range(_TRIES)))
            R, found = next(((R, bounds) for R, bounds in tried if bounds is not None), (arb(rim), None))
            if found is None:
                raise UndecidedError("no ellipse about the quarter-swings is proved to be free of singularities")
            M, N = found
            # On the real line, |T_k| <= 1, for all g within _NEAR of G: the rates in K must hold wherever the truth
            # may be, which the check of ``apart`` below closes.
            drags = self.drags(upper(self.sizes(arb(1)) + arb(_NEAR)))
            kappa = sum((d * peak(e) for d, e in zip(drags, bundle.alphas)), arb(0))
            if not kappa < 1:
                raise UndecidedError("the strengths are too large for polar coordinates")
            K = sum((abs(a - 1) * d for a, d in zip(bundle.alphas, drags)), arb(0)) / (1 - kappa) ** 2
            begun = bundle.dg + bundle.dz * sum(drags, arb(0)) / (1 - kappa)
            eta = cut(M, R, m) + self.differs
            # Gronwall's inequality over the length 2.
            apart = upper(K.exp() * (begun + 2 * eta))
            late = upper(2 * cut(N, R, m) + K * apart + bundle.dz / (1 - kappa))
        # So the truth never leaves the strip in which K was taken, by continuity.
        if not apart < _NEAR:
            raise UndecidedError("the quarter-swings are not enclosed")
        return apart, late

    def enclosed(self, rim: float) -> list[Quarter]:
        """The ends of the quarter-swings; ``rim`` as of ``errors``."""
        (apart, late), bundle, m = self.errors(rim), self.grid.bundle, self.grid.count
        weights = arb_mat([integrals(m, ctx.prec).table()[m]]) * analysis(m, ctx.prec)
        durations = (weights * arb_mat(self.slowness)).table()[0]
        rows = zip(self.ends, bundle.times, durations)
        return [Quarter(end + arb(0, apart), first + rest + arb(0, late)) for end, first, rest in rows]


def peak(alpha: arb) -> arb:
    """The largest s^alpha c, s = sin, c = cos: (alpha^alpha/(1+alpha)^(1+alpha))^(1/2).

    >>> peak(arb(1)).str(9), peak(arb(0)).str(9)
    ('[0.500000000 +/- ...]', '1.00000000')
    """
    powers = -(1 + alpha) * (1 + alpha).log() + (alpha * alpha.log() if alpha > 0 else 0)
    return (powers / 2).exp()
