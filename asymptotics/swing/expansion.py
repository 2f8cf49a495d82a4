"""The motion next to a turning point, as an enclosure: y and tau in powers of the speed, so the branch point is gone.

With w as the variable, P = y - N(w) and Q = 1/P (coefficients by exponent e),

    dy/dw = -w/P,    d tau/dw = 1/P,
    P_e = -Q_(e-2)/e - [e = alpha_i] epsilon_i,   Q_e = -(1/P_0) sum_(0<f<=e) P_f Q_(e-f),   tau_(e+1) = Q_e/(e+1).

The same series serves both ends: P_0 = y_0 > 0 where a half-swing begins, P_0 < 0 where it ends (then tau <= 0).
The coefficients are balls; what is left out is bounded by the majorant (``majorant``), stretched as ``keys`` proposes.

>>> from fractions import Fraction
>>> from asymptotics.numbers.exact import ExactReal
>>> with ctx.workprec(60):
...     law = Damping.of([(arb(1) / 10, ExactReal(Fraction(3, 2)))])
...     start = Expansion.at(law, arb(1))
...     y, tau = start.state(arb("0.0625"))
...     y.str(12), tau.str(12)
('[0.998043212541 +/- ...]', '[0.0625799720549 +/- ...]')
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil
from operator import mul

from flint import arb, arb_poly, ctx

from asymptotics.errors import UndecidedError
from asymptotics.swing.damping import Damping, dyadic, size_of, upper
from asymptotics.swing.keys import Key, Plan, keys_of, plan_for, sums_below
from asymptotics.swing.majorant import majorant

_STEPS = 4  # delta is rounded up to a quarter of a power of two: plans are shared


@dataclass(frozen=True)
class Expansion:
    """y(w) and tau(w)/w at the turning point ``y0`` for 0 <= w <= ``reach``, with the bounds of their tails.

    ``terms`` many coefficients, of the powers of w^(1/q) on a line, else of the monomials ``keys`` in w^2, w^alpha_i.
    """

    damping: Damping
    y0: arb
    reach: arb
    plan: Plan
    keys: Sequence[Key]
    y: arb_poly
    slowness: arb_poly
    tail: arb
    time_tail: arb

    @classmethod
    def at(cls, damping: Damping, y0: arb, w: arb | None = None) -> "Expansion":
        """The expansion at a displacement y0 != 0, for speeds up to ``w`` (without it: up to what is cheapest).

        UndecidedError where the majorant does not provably converge.
        """
        plan = plan_at(damping, y0, w)
        reach = dyadic(plan.omega + size_of(y0)) if w is None else w
        with ctx.workprec(max(ctx.prec, 64)):
            factor, bound = _stretched(damping, abs(y0), reach, plan)
        if plan.denominator:
            keys: Sequence[Key] = ()
            y, Q, slowness = _on_a_line(damping, y0, plan)
        else:
            keys = keys_of(plan.weights, plan.top)
            y, Q, slowness = _on_a_simplex(damping, y0, keys)
        small = upper(factor * bound * abs(y0))
        slow = upper(factor * bound / (1 - bound) / abs(y0))
        return cls(damping, y0, reach, plan, keys, arb_poly(y), arb_poly(slowness), small, slow)

    @property
    def terms(self) -> int:
        """How many terms are kept."""
        return len(self.keys) or self.plan.count

    def speed(self) -> arb:
        """A bound of |(y', w')| within the reach, on both sides of the turning point: |P| <= 2 |P_0| where r < 1."""
        return upper(2 * abs(self.y0) + 2 * self.damping.friction + self.reach)

    def state(self, w: arb) -> tuple[arb, arb]:
        """(y, tau) at the speed 0 <= w <= ``reach``; tau since (or, if negative, until) the turning point."""
        if w == 0:
            return self.y0, arb(0)
        if not w <= self.reach:
            raise ValueError("the speed is beyond the reach of the expansion")
        if self.plan.denominator:
            s = (w.log() / self.plan.denominator).exp()
            y, slowness = self.y(s), self.slowness(s)
        else:
            powers = _monomials(self.damping, self.keys, w)
            y, slowness = (sum(map(mul, c.coeffs(), powers), arb(0)) for c in (self.y, self.slowness))
        return y + arb(0, self.tail), w * (slowness + arb(0, self.time_tail))


def plan_at(damping: Damping, y0: arb, w: arb | None = None) -> Plan:
    """The plan for the turning point ``y0`` (and the speed ``w``) at the current precision."""
    size = size_of(y0)
    deltas = tuple(ceil((e + (a - 1) * size) * _STEPS) / _STEPS for e, a in damping.sizes)
    rational = tuple(a.rational if a.is_rational else None for a in damping.alphas)
    omega = None if w is None else ceil((size_of(w) - size) * _STEPS) / _STEPS
    return plan_for(deltas, rational, tuple(a for _, a in damping.sizes), ctx.prec, omega)


def _stretched(damping: Damping, size: arb, w: arb, plan: Plan) -> tuple[arb, arb]:
    """(e^-G, R*): the factor of the first term left out, and the majorant at the stretched speed, in balls."""
    two = arb(2)
    a, b = w**2 / (2 * size**2), [t / size for t in damping.terms(w)]
    if plan.denominator:
        stretch = arb(plan.stretch[0])
        factor = two ** (-stretch * plan.count / plan.denominator)
        wider = sum((t * two ** (e * stretch) for t, e in zip(b, damping.exponents)), arb(0))
        room = majorant(a * two ** (2 * stretch), wider)
    else:
        stretches = [arb(g) for g in plan.stretch]
        factor = two ** (-arb(plan.top) / (1 << 16))
        room = majorant(a * two ** stretches[0], sum((t * two**g for t, g in zip(b, stretches[1:])), arb(0)))
    if room is None:
        raise UndecidedError("the majorant of the expansion at a turning point does not provably converge")
    return factor, room


def _on_a_line(damping: Damping, y0: arb, plan: Plan) -> tuple[list[arb], list[arb], list[arb]]:
    """Coefficients of y, Q and tau/w in powers of w^(1/q); what no sum of 2q and the alpha_i q reaches is exactly 0."""
    q = plan.denominator
    force = {int(a.rational * q): e for a, e in zip(damping.alphas, damping.strengths)}
    Q, y, reached = [1 / y0], [y0], sums_below(plan.count, (2 * q, *force))
    scale, none = -1 / y0, arb(0)
    places: list[int] = []  # of the coefficients of P, after the first, that are not 0
    P: list[arb] = []
    for k in range(1, plan.count):
        squared = k >= 2 * q and reached[k - 2 * q]
        y.append(-Q[k - 2 * q] * q / k if squared else none)
        if squared or k in force:
            places.append(k)
            P.append(y[k] - force[k] if k in force else y[k])
        Q.append(scale * sum(map(mul, P, [Q[k - f] for f in places]), none) if reached[k] else none)
    return y, Q, [c * q / (k + q) for k, c in enumerate(Q)]


def _on_a_simplex(damping: Damping, y0: arb, keys: Sequence[Key]) -> tuple[list[arb], list[arb], list[arb]]:
    """The same for the monomials ``keys`` in z_0 = w^2, z_i = w^alpha_i."""
    axes = len(keys[0])
    force = {tuple(int(i == j) for j in range(axes)): e for i, e in enumerate(damping.strengths, start=1)}
    zero, none = keys[0], arb(0)
    P, Q, y = {zero: y0}, {zero: 1 / y0}, {zero: y0}
    scale, live = -1 / y0, []
    exponents = _exponents(damping, keys)
    for key, e in zip(keys[1:], exponents[1:]):
        before = Q[(key[0] - 1, *key[1:])] if key[0] else None
        y[key] = none if before is None else -before / e
        P[key] = y[key] - force[key] if key in force else y[key]
        if before is not None or key in force:
            live.append((key, P[key]))
        total = none
        for f, c in live:
            rest = tuple(map(int.__sub__, key, f))
            if min(rest) >= 0:
                total += c * Q[rest]
        Q[key] = scale * total
    return [y[k] for k in keys], [Q[k] for k in keys], [Q[k] / (e + 1) for k, e in zip(keys, exponents)]


def _exponents(damping: Damping, keys: Sequence[Key]) -> list[arb]:
    return [sum((n * a for n, a in zip(key[1:], damping.exponents)), arb(2 * key[0])) for key in keys]


def _monomials(damping: Damping, keys: Sequence[Key], w: arb) -> list[arb]:
    ln_w = w.log()
    bases = [w * w, *((a * ln_w).exp() for a in damping.exponents)]
    tables = []
    for i, z in enumerate(bases):
        table = [arb(1)]
        for _ in range(max(key[i] for key in keys)):
            table.append(table[-1] * z)
        tables.append(table)
    found = []
    for key in keys:
        value = tables[0][key[0]]
        for table, n in zip(tables[1:], key[1:]):
            value = value * table[n]
        found.append(value)
    return found
