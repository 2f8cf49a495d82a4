"""The motion next to a turning point, as an enclosure: y and tau in powers of the speed, so the branch point is gone.

A generalized power series (exponents 2 n_0 + sum alpha_i n_i) with a tail by Cauchy's method of majorants.

With w as the variable, P = y - N(w) and Q = 1/P (coefficients by exponent e),

    dy/dw = -w/P,    d tau/dw = 1/P,
    P_e = -Q_(e-2)/e - [e = alpha_i] epsilon_i,   Q_e = -(1/P_0) sum_(0<f<=e) P_f Q_(e-f),   tau_(e+1) = Q_e/(e+1).

The same series serves both ends: P_0 = y_0 > 0 where a half-swing begins, P_0 < 0 where it ends (then tau <= 0).
Where the powers are kept apart, the coefficients belong to the exponents alone and are shared (``rows``).  They are
balls; what is left out is bounded by the majorant (``majorant``), stretched as ``kept_terms`` proposes.

*One term.*  Without any series, if d >= w^2/(2 p) for some d and p = P_0 - d - N(w) > 0 (|P_0| - d where P_0 < 0),

    |P| >= p,    |y - y_0| <= d,    1/(|P_0| + N(w)) <= |tau|/w <= 1/p:

while |y - y_0| <= d the first holds, so that |dy/dw| <= w/p and the distance stays below d.

>>> from fractions import Fraction
>>> from asymptotics.numbers.exact import ExactReal
>>> with ctx.workprec(60):
...     law = Damping.of([(arb(1) / 10, ExactReal(Fraction(3, 2)))])
...     start = TurningExpansion.at(law, arb(1))
...     y, tau = start.state(arb("0.0625"))
...     y.str(12), tau.str(12)
('[0.998043212541 +/- ...]', '[0.0625799720549 +/- ...]')
"""

from dataclasses import dataclass, replace
from math import ceil, lcm, prod
from operator import mul

from flint import arb, arb_poly

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import dyadic, size_of, upper
from asymptotics.flow.damping import Damping
from asymptotics.flow.growing_product import GrowingProduct
from asymptotics.flow.linear_spring.kept_terms import KeptTerms, plan_for, sums_below
from asymptotics.flow.linear_spring.majorant import majorant
from asymptotics.flow.linear_spring.rows import Row, rows_below
from asymptotics.numbers.context import cached_property, ctx

# Sums of at most about 3000 terms lose log2 of that many, 12 bits; the loss is in the balls anyhow.
_SUMMED = 12  # bits more for sums of hundreds of terms
_FAINTEST = 2.0**20  # -log2 of the least reach that is looked for
_LONGEST = 400  # coefficients of a line for many speeds: of 3/2 a place costs a tenth of what it does by rows
_STEPS = 4  # delta^(1/alpha) is rounded up to a quarter of a power of two: plans are shared


@dataclass(frozen=True)
class TurningExpansion:
    """y(w) and tau(w)/w at the turning point ``y0`` for 0 <= w <= ``reach``, with the bounds of their tails.

    ``terms`` many coefficients: of the powers of w^(1/``root``) on a ``line`` (y, tau/w), else of the ``rows``.
    """

    damping: Damping
    y0: arb
    reach: arb
    plan: KeptTerms
    line: tuple[arb_poly, arb_poly] | None
    rows: tuple[Row, ...]
    tail: arb
    time_tail: arb
    root: int = 1

    @classmethod
    def at(cls, damping: Damping, y0: arb, w: arb | None = None) -> "TurningExpansion":
        """The expansion at a displacement y0 != 0, for speeds up to ``w`` (without it: up to what is cheapest).

        UndecidedError where the majorant does not provably converge.
        """
        plan = plan_at(damping, y0, w)
        reach = dyadic(plan.omega + size_of(y0)) if w is None else w
        if plan.short:
            return cls._short(damping, y0, reach if w is not None else _slow_enough(damping, y0, reach), plan)
        # The stretch may be large, and the majorant is verified at the stretched speed: a few more bits than a short
        # working precision has.
        with ctx.workprec(max(ctx.prec, 64)):
            factor, bound = _stretched(damping, abs(y0), reach, plan)
        line = _on_a_line(damping, y0, plan) if plan.denominator else None
        rows = () if line else rows_below(damping.alphas, plan.weights, plan.top, ctx.prec + _SUMMED)
        # y = P + N lacks the monomials z_i, which N has in P, and shares all others with P = P_0 (1 - r): its tail is
        # at most that of P_0 r, the factor of the first term left out times R*.  For tau/w it is that of 1/P, R/(1-R)
        # over |P_0|, as tau_(e+1) = Q_e/(e+1) is no larger.
        small = upper(factor * bound * abs(y0))
        slow = upper(factor * bound / (1 - bound) / abs(y0))
        return cls(damping, y0, reach, plan, line, rows, small, slow, plan.denominator)

    @classmethod
    def _short(cls, damping: Damping, y0: arb, reach: arb, plan: KeptTerms) -> "TurningExpansion":
        """The expansion of which the first term alone is kept; the rest is bounded by ``room``."""
        drop, slowest, fastest = room(damping, y0, reach)
        # tau/w lies between 1/fastest and 1/slowest; the centre is 1/|y_0| with the sign of y_0, so the larger
        # deviation is the tail.
        late = upper((1 / slowest - 1 / abs(y0)).max(1 / abs(y0) - 1 / fastest))
        return cls(damping, y0, reach, plan, (arb_poly([y0]), arb_poly([1 / y0])), (), drop, late)

    @property
    def terms(self) -> int:
        """How many terms are kept."""
        return sum(len(y) for _, y, _ in self.rows) if self.rows else self.plan.count

    def speed(self, _unit: arb) -> arb:
        """A bound of |(y', w')| within the reach, on both sides of the turning point: |P| <= 2 |P_0| where r < 1."""
        # Where the series converge r < 1 within the reach, so |P| = |P_0| |1 - r| < 2 |P_0|; the mirrored state beyond
        # the turning point has friction on the other side, twice.  A short plan has no r: |P| <= |y| + N.
        fast = upper(self.damping.resistance(self.reach)) if self.plan.short else arb(0)
        return upper(2 * abs(self.y0) + 2 * self.damping.friction + self.reach + fast)

    def acceleration(self, y: arb, w: arb) -> arb:
        """The acceleration dw/dt = y - N(w)."""
        return y - self.damping.resistance(w)

    def moved(self, wait: arb) -> tuple[arb, arb]:
        """How far y and w move at most in the time |wait|."""
        far = upper(wait * self.speed(arb(1)))
        return far, far

    def state(self, w: arb) -> tuple[arb, arb]:
        """(y, tau) at the speed 0 <= w <= ``reach``; tau since (or, if negative, until) the turning point."""
        if w == 0:
            return self.y0, arb(0)
        if not w <= self.reach:
            raise ValueError("the speed is beyond the reach of the expansion")
        if self.line is not None:
            s = w.root(self.root)
            y, slowness = (polynomial(s) for polynomial in self.line)
        else:
            with ctx.workprec(ctx.prec + _SUMMED):
                y, slowness = self._by_rows(w)
        return y + arb(0, self.tail), w * (slowness + arb(0, self.time_tail))

    @cached_property
    def gathered(self) -> "TurningExpansion":
        """The same at the current precision for many speeds: its rows on one line, where the exponents allow a short
        one."""
        if not self.rows or not all(a.is_rational for a in self.damping.alphas):
            return self
        q = lcm(*(a.rational.denominator for a in self.damping.alphas))
        steps = [int(a.rational * q) for a in self.damping.alphas]
        starts = [sum(map(mul, m, steps)) for m, _, _ in self.rows]
        length = max(k + 2 * q * (len(row) - 1) for k, (_, row, _) in zip(starts, self.rows)) + 1
        if length > _LONGEST:
            return self
        with ctx.workprec(ctx.prec + _SUMMED):
            # In units of y_0 the monomial of a row is that of the exponents times the powers of epsilon_i/y_0.
            shares = [e / self.y0 for e in self.damping.strengths]
            square, ys, slow = arb_poly([*[0] * (2 * q), 1 / self.y0**2]), arb_poly([]), arb_poly([])
            for k, (m, row, slow_row) in zip(starts, self.rows):
                unit = prod((x**n for x, n in zip(shares, m)), start=arb(1))
                ys += (row(square) * unit).left_shift(k)
                slow += (slow_row(square) * unit).left_shift(k)
            return replace(self, line=(ys * self.y0, slow * (1 / self.y0)), root=q)

    def _by_rows(self, w: arb) -> tuple[arb, arb]:
        """(y, tau/w) without the tails."""
        square, *others = (z / self.y0 for z in (w * w / self.y0, *self.damping.terms(w)))
        powers = [_powers(z, max(m[i] for m, _, _ in self.rows)) for i, z in enumerate(others)]
        y, slowness = arb(0), arb(0)
        for m, row, slow_row in self.rows:
            monomial = prod(map(list.__getitem__, powers, m), start=arb(1))
            y += monomial * row(square)
            slowness += monomial * slow_row(square)
        return y * self.y0, slowness / self.y0


def room(damping: Damping, y0: arb, w: arb) -> tuple[arb, arb, arb]:
    """(d, p, the largest |P|) of the last paragraph above, up to the speed w."""
    size, brake = arb(abs(y0).lower()), upper(damping.resistance(w))
    # d = (9/8) w^2/(2 |y_0|): right at once where damping and d take off no more than 1/9 of |P_0|; otherwise d is
    # doubled until d >= w^2/(2 p), the hypothesis of the module's docstring, or p is no longer above 0.  For y_0 > 0
    # damping makes |P| smaller, for y_0 < 0 larger.
    drop = upper(9 * w * w / (16 * size))
    slowest = (size - drop - (brake if y0 > 0 else 0)).lower()
    while slowest > 0 and not drop >= w * w / (2 * slowest):
        drop = upper(2 * drop)
        slowest = (size - drop - (brake if y0 > 0 else 0)).lower()
    if not slowest > 0:
        raise UndecidedError(
            "the damping may stop the motion at once next to a turning point: weaker damping is served"
        )
    # y moves towards 0 with growing w on either side, so |P| <= |y_0| + N.
    return drop, slowest, upper(abs(y0) + brake)


def _slow_enough(damping: Damping, y0: arb, reach: arb) -> arb:
    """A reach at which the damping takes off at most 15/16 of the force, or one that is small beyond use: a choice."""
    # 2^-0.1 = 0.933, about 15/16.  Only where y_0 > 0 can damping take the force away; the search is a bisection of
    # log2 w, as the term epsilon w^alpha with a small alpha asks for very small speeds.
    most, low, high = size_of(y0) - 0.1, -_FAINTEST, size_of(reach)

    def fits(x: float) -> bool:
        return sum(float(2.0 ** min(e + a * x - most, 99.0)) for e, a in damping.sizes) < 1

    if not y0 > 0 or fits(high):
        return reach
    while fits(low) and high - low > 0.1:
        middle = (low + high) / 2
        low, high = (middle, high) if fits(middle) else (low, middle)
    return dyadic(low)


def plan_at(damping: Damping, y0: arb, w: arb | None = None) -> KeptTerms:
    """The plan for the turning point ``y0`` (and the speed ``w``) at the current precision."""
    size = size_of(y0)
    # The room of a plan hangs on delta^(1/alpha), which an exponent below 1 magnifies: its deltas are rounded more
    # finely.  Rounded up, a plan is no bolder than the true strengths allow.
    steps = _STEPS * max(1, ceil(1 / damping.least)) if damping.sizes else _STEPS
    deltas = tuple(ceil((e + (a - 1) * size) * steps) / steps for e, a in damping.sizes)
    rational = tuple(a.rational if a.is_rational else None for a in damping.alphas)
    omega = None if w is None else ceil((size_of(w) - size) * _STEPS) / _STEPS
    return plan_for(deltas, rational, tuple(a for _, a in damping.sizes), ctx.prec, omega)


def _stretched(damping: Damping, size: arb, w: arb, plan: KeptTerms) -> tuple[arb, arb]:
    """(e^-G, R*): the factor of the first term left out, and the majorant at the stretched speed, in balls."""
    two = arb(2)
    a, b = w**2 / (2 * size**2), [t / size for t in damping.terms(w)]
    if plan.denominator:
        stretch = arb(plan.stretch[0])
        # With w made 2^g times larger the monomial w^e grows by 2^(g e), and the first exponent left out is count/q.
        factor = two ** (-stretch * plan.count / plan.denominator)
        wider = sum((t * two ** (e * stretch) for t, e in zip(b, damping.exponents)), arb(0))
        room = majorant(a * two ** (2 * stretch), wider)
    else:
        stretches = [arb(g) for g in plan.stretch]
        # 2^-G with the integer weights of ``kept_terms``, in units of 2^-16: a monomial is left out where sum n_i
        # weights_i >= top.
        factor = two ** (-arb(plan.top) / (1 << 16))
        room = majorant(a * two ** stretches[0], sum((t * two**g for t, g in zip(b, stretches[1:])), arb(0)))
    # The plan was made in doubles, and this is where it is verified: a plan that is too bold is refused, none is
    # trusted.
    if room is None:
        raise UndecidedError("the majorant of the expansion at a turning point does not provably converge")
    return factor, room


def _on_a_line(damping: Damping, y0: arb, plan: KeptTerms) -> tuple[arb_poly, arb_poly]:
    """y and tau/w in powers of w^(1/q); what no sum of 2q and the alpha_i q reaches is exactly 0."""
    q = plan.denominator
    # alpha q is a whole number, as q is a common denominator.  Whoever makes a ``Damping`` has merged equal exponents
    # (``Law`` does): two of them would meet in one key here.
    force = {int(a.rational * q): e for a, e in zip(damping.alphas, damping.strengths)}
    Q, y, reached = [1 / y0], [y0], sums_below(plan.count, (2 * q, *force))
    scale, none = -1 / y0, arb(0)
    # Where few coefficients vanish the product of P - P_0 and Q grows by blocks; elsewhere those that do are left out.
    P: list[arb] = []
    dense = GrowingProduct(P, Q, plan.count) if 2 * sum(reached) > plan.count else None
    places: list[int] = []  # of the coefficients of P, after the first, that are not 0
    for k in range(1, plan.count):
        # The recurrence of the module's docstring with e = k/q.
        squared = k >= 2 * q and reached[k - 2 * q]
        y.append(-Q[k - 2 * q] * q / k if squared else none)
        if dense or squared or k in force:
            places.append(k)
            P.append(y[k] - force[k] if k in force else y[k])
        found = dense.last() if dense else sum(map(mul, P, [Q[k - f] for f in places]), none) if reached[k] else none
        Q.append(scale * found if reached[k] else none)
    return arb_poly(y), arb_poly([c * q / (k + q) for k, c in enumerate(Q)])


def _powers(z: arb, highest: int) -> list[arb]:
    """The powers 1, z, z^2, ... up to z^highest."""
    found = [arb(1)]
    for _ in range(highest):
        found.append(found[-1] * z)
    return found
