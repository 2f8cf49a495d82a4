"""The n-th turning point of a sum of laws, every exponent above 1: the Abel function as an integral of the slow flow.

Psi(F) = Psi + 1 is Abel's equation for the return map F, whose solution is a Fatou coordinate (``abel``).

A half-swing shifts x = ln A by L; the formal flow dx/dj = v(x), v = pi U, reaches it at j = 1 (``normal_form.flow``).
Powers of A would need logarithms where exponents resonate; the integrals of

    f = 1/v = (1/v_1)(1 + g_1 + g_2 + ...),    h = pi W/v = (1/v_1)(pi + ...),    v_1 = -pi sum M_(alpha_i+1) delta_i,

do not: v_1 is kept as it is, and g_k, homogeneous of degree 2k in the delta_i, comes from 1/(v_1 + v_3 + ...).  With K
terms of each, Psi = int f dx and Theta = int h dx grow on a half-swing by 1 + d and T + d (derivation ``abel-flow``):

* **Defects.**  d(lambda), the delta_i made lambda times larger, is analytic on |lambda| = rho_1/delta_1, where the
  majorant of the half-swing (``half_swings.finite_majorant``) gives |L| <= G, and |v_1| >= b there because the real
  parts of its terms have one sign; so |d| <= D, and d = O(lambda^(2K)) makes |d| <= D (delta_1/rho_1)^(2K) (Schwarz).
* **Along the orbit** 1/delta_1 gains (alpha_1-1) pi M_(alpha_1+1) at least at each step, and delta_i/delta_1 falls, so
  that one D serves all later half-swings; the sum is that of ``abel.power_sum``.
* **Following terms.**  The defects of K terms differ from those of K + 1 by an integral over the whole orbit,
  |int g_K/v_1 dx| <= C delta_1^(2K-1)/((2K-1)(alpha_1-1)): the bound is the next term and Schwarz' inequality beyond.

>>> from asymptotics.numbers.exact import parse_real
>>> with ctx.workprec(120):
...     laws = tuple(parse_real(a, "--alpha") for a in ("3/2", "3"))
...     flow = abel_flow(laws, (arb(1) / 5, arb(1) / 5), terms=3)
...     far, time = flow.advance(arb(-14), 10**9)
>>> far.exp().str(15), time.str(15)
('[4.83743985097043e-17 +/- ...]', '[3141592653.58992 +/- ...]')
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf
from typing import Any

from flint import arb

from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.certified_zeros import certified_half_swing
from asymptotics.expansions.half_swings.finite_majorant import BITS, Majorant
from asymptotics.expansions.normal_form.flow import flow_of
from asymptotics.numbers.context import ctx, lru_cache
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.integral import integral
from asymptotics.series import Key
from asymptotics.turning.abel import least_beyond, polydiscs

FOLLOWING = 1
"""How many terms beyond those kept are in the bound as they are."""
_SHARES = (0.3, 0.4, 0.5, 0.6, 0.7, 0.8)
# Of Arb's rigorous quadrature: a limit of work, beyond which the integral is not finite and refused.
_EVALUATIONS = 4000  # of the integrand, and as many for each 100 bits
_STEPS = 60

Part = tuple[tuple[Key, arb], ...]
"""A homogeneous polynomial in the delta_i."""


@dataclass(frozen=True, eq=False)
class DefectBound:
    """A bound of the sum of all defects from a point on: what the next terms give, and ``beyond`` them."""

    following: arb
    beyond: arb

    @property
    def total(self) -> arb:
        """The bound of the sum of all defects: both parts together."""
        return arb((self.following + self.beyond).upper())


@dataclass(frozen=True, eq=False)
class AbelFlow:
    """Psi and Theta of a law with all alpha_i > 1, the smallest first; parts v_1, v_3, ... and pi W_0, pi W_2, ..."""

    alphas: tuple[ExactReal, ...]
    epsilons: tuple[arb, ...]
    rates: tuple[Part, ...]
    clock: tuple[Part, ...]
    K: int

    @property
    def weights(self) -> tuple[arb, ...]:
        """The exponents alpha_i - 1 of A in the local strengths."""
        return tuple((a - 1).ball() for a in self.alphas)

    def strengths(self, x: Any) -> list[Any]:
        """delta_i at ln A = x, real or complex."""
        return [e * (w * x).exp() for e, w in zip(self.epsilons, self.weights, strict=True)]

    def advance(self, x: arb, steps: int) -> tuple[arb, arb]:
        """(ln A, time) ``steps`` half-swings after ln A = x; UndecidedError where delta_1 is too large there."""
        psi, theta = self.defects(x)
        # Integrals from exact points: the radii of both ends are added as |f| times the radius (mean value theorem),
        # since an integral from a ball would count it at every node.
        here = arb(x.mid())
        blur = arb(0, x.rad()) * self.integrand(self.rates[:1], x)
        after = self._solve(here, steps + blur + arb(0, psi.total), arb(x.upper()))
        middle = arb(after.mid())
        time = self._integral(self.clock, here, middle) + arb(0, theta.total)
        for end in (x, after):
            time += arb(0, end.rad()) * self.integrand(self.clock, end)
        return after, time

    def defects(self, x: arb) -> tuple[DefectBound, DefectBound]:
        """For Psi and Theta, from the ball x on."""
        with ctx.workprec(BITS):
            # All bounds grow with each delta_i, and along the orbit they fall: the upper ends at the start serve for
            # the whole orbit.
            top = [arb(d.upper()) for d in self.strengths(x)]
            bound = self._polydisc(top)
            after = self._following(top)
            beyond = self._on_circle(bound)
            # The power that Schwarz' inequality gives, once the following terms are counted as they are.
            m = 2 * (self.K + FOLLOWING)
            behind = 1 / top[0] - self._gain() / 2
            if not behind > 0:
                raise UndecidedError("delta is too large for the sum along the orbit")
            along = behind ** (1 - m) / ((m - 1) * self._gain()) / bound.radii[0] ** m
            psi, theta = (
                DefectBound(arb(c.upper()), arb((d * along).upper())) for c, d in zip(after, beyond, strict=True)
            )
        return psi, theta

    def integrand(self, drive: Sequence[Part], x: Any) -> Any:
        """f for ``drive`` = v_1 alone, h for ``drive`` = ``clock``: K terms."""
        delta = self.strengths(x)
        v = [_at(part, delta) for part in self.rates[: self.K]]
        g = _reciprocal([r / v[0] for r in v[1:]])
        if drive is not self.clock:
            # K terms of 1/v, homogeneous degree by degree.
            return sum(g) / v[0]
        c = [_at(part, delta) for part in self.clock[: self.K]]
        return sum(c[i] * g[k - i] for k in range(self.K) for i in range(k + 1)) / v[0]

    def _gain(self) -> arb:
        return -self.weights[0] * self.rates[0][-1][1]

    def _polydisc(self, top: Sequence[arb]) -> Majorant:
        """Of a few polydiscs in the direction of ``top`` the one with the least bound of what lies beyond."""
        exponents = [a.ball() for a in self.alphas]
        direction = [arb((d / top[0]).upper()) for d in top]
        usable = [m for m in polydiscs(exponents, direction, _SHARES) if self._least(m) > 0]
        if not usable:
            raise UndecidedError("no circle is proved on which the defects of the Abel function are bounded")
        return least_beyond(usable, 2 * (self.K + FOLLOWING), lambda m: self._on_circle(m)[0])

    def _least(self, bound: Majorant) -> arb:
        """b: terms of v_1 whose real parts have the sign of the first are left out, others are taken off."""
        G, least = bound.growth, arb(0)
        for i, (c, w, rho) in enumerate(zip(self._first(), self.weights, bound.radii, strict=True)):
            turn = w * G
            if i == 0:
                # The first law carries the bound: b must be above 0, or the polydisc is of no use.
                least = c * rho * (-turn).exp() * turn.cos() if turn < arb.pi() / 2 else arb(0)
            # A law whose real part may change its sign on the circle is taken off with its whole size.
            elif not turn <= arb.pi() / 2:
                least -= c * rho * turn.exp()
        return arb(least.lower())

    def _first(self) -> list[arb]:
        """The coefficients of -v_1, in the order of the laws."""
        return [-c for _, c in reversed(self.rates[0])]

    def _on_circle(self, bound: Majorant) -> tuple[arb, arb]:
        """D of Psi and Theta on the circle, with the following terms."""
        b, G = self._least(bound), bound.growth
        # |delta_i| on the way of a half-swing, |xi| <= G.
        wide = [rho * (w * G).exp() for rho, w in zip(bound.radii, self.weights, strict=True)]
        sizes = [_at(_sizes(part), wide) / b for part in self.rates[1:]]
        # The majorant series 1/(1 - a(t)): with minus signs the recurrence of 1/(1 + ...) adds absolute values.
        g = _reciprocal([-s for s in sizes])
        clock = [_at(_sizes(part), wide) for part in self.clock]
        h = sum((clock[i] * g[k - i] for k in range(len(g)) for i in range(k + 1)), arb(0))
        return arb((1 + G * sum(g, arb(0)) / b).upper()), arb((arb.pi() + bound.excess + G * h / b).upper())

    def _following(self, top: Sequence[arb]) -> tuple[arb, arb]:
        """sum over the following terms of |int| of their share of f and h, for every point of the orbit."""
        # delta_i/delta_1 falls along the orbit: one ball from 0 to its present value holds it at every later point, and
        # delta_1^(2k) is split off.
        shape = [arb(1), *(arb(0).union(d / top[0]) for d in top[1:])]
        v = [_at(part, shape) for part in self.rates]
        g = _reciprocal([r / v[0] for r in v[1:]])
        clock = [_at(part, shape) for part in self.clock]
        h = [sum((clock[i] * g[k - i] for i in range(k + 1)), arb(0)) for k in range(len(g))]
        # 1 + g_1 + ... is then at least 1/2: the integrand has the sign of v_1 and at least half of the size of 1/v_1,
        # which ``_solve`` uses.
        if not sum((abs(c) * top[0] ** (2 * k) for k, c in enumerate(g[: self.K]) if k), arb(0)) < arb(1) / 2:
            raise UndecidedError("the truncated Abel function may not decrease here: use a later head or fewer terms")
        psi, theta = (
            sum((abs(f[k] / v[0]) * self._tail(top[0], k) for k in range(self.K, len(f))), arb(0)) for f in (g, h)
        )
        return psi, theta

    def _tail(self, delta: arb, k: int) -> arb:
        """int delta_1^(2k-1) dx over all amplitudes below."""
        return delta ** (2 * k - 1) / ((2 * k - 1) * self.weights[0])

    def _solve(self, start: arb, value: arb, top: arb) -> arb:
        """The only x below ``start`` with Psi(x) - Psi(start) = value: Newton in the midpoints, then the mean value."""
        w, goal = self.weights[0], value.mid()
        first = self.rates[0][-1][1] * self.epsilons[0]
        # The first law alone: A^-w grows by -w v_1/A^w for each half-swing.
        x = ((1 / ((-w * start).exp() - goal * w * first)).log() / w).mid()
        reached, before = arb(0), start
        for _ in range(_STEPS):
            # Step by step, so that each integral is short.
            reached, before = reached + self._integral(self.rates[:1], before, x), x
            step = ((reached - goal) / self.integrand(self.rates[:1], x)).mid()
            if abs(step) < arb(2) ** (8 - ctx.prec):
                break
            x = (x - step).mid()
        else:  # what was reached belongs to the place before
            raise UndecidedError("Newton's method along the slow flow does not settle: raise the precision")
        near = x + arb(0, arb(2) ** -10)
        # |x - root| <= |Psi(x) - value|/min |f| and 1/|f| <= 2 |v_1|, in a box that must hold the root and lie below
        # the start.
        error = abs((reached - value) * 2 * _at(self.rates[0], self.strengths(near))).upper()
        if not (error < near.rad() and near < top):
            raise UndecidedError("the enclosure of the turning point was not verified: raise the precision")
        return x + arb(0, error)

    def _integral(self, drive: Sequence[Part], low: arb, high: arb) -> arb:
        limit = _EVALUATIONS * (1 + ctx.prec // 100)
        words = "an integral of the slow flow"
        found = integral(lambda z, _: self.integrand(drive, z), low, high, words, evaluations=limit)
        if not found.is_finite():
            raise UndecidedError("an integral of the slow flow was not enclosed")
        return found


def _at(part: Part, delta: Sequence[Any]) -> Any:
    total = arb(0)
    for key, c in part:
        for d, n in zip(delta, key, strict=True):
            if n:
                c = c * d**n
        total = total + c
    return total


def _sizes(part: Part) -> Part:
    return tuple((key, abs(c)) for key, c in part)


def _reciprocal(a: Sequence[Any]) -> list[Any]:
    """The coefficients of 1/(1 + a_1 t + a_2 t^2 + ...)."""
    found: list[Any] = [arb(1)]
    for k in range(1, len(a) + 1):
        found.append(-sum((a[i - 1] * found[k - i] for i in range(1, k + 1)), arb(0)))
    return found


def abel_flow(alphas: Sequence[ExactReal], epsilons: Sequence[arb], terms: int) -> AbelFlow:
    """Psi and Theta with K = ``terms`` at the current precision; the alphas ascend, all of them above 1."""
    rates, clock = _parts(tuple(alphas), 2 * (terms + FOLLOWING) - 1, ctx.prec)
    return AbelFlow(tuple(alphas), tuple(epsilons), rates, clock, terms)


@lru_cache(maxsize=16)
def _parts(alphas: tuple[ExactReal, ...], order: int, bits: int) -> tuple[tuple[Part, ...], tuple[Part, ...]]:
    with ctx.workprec(bits):
        flow, pi = flow_of(certified_half_swing(list(alphas), order, max_seconds=inf)), arb.pi()
        rates = tuple(tuple((k, pi * c) for k, c in flow.U.parts[m]) for m in range(1, order + 1, 2))
        clock = tuple(tuple((k, pi * c) for k, c in flow.W.parts[m]) for m in range(0, order, 2))
    return rates, clock
