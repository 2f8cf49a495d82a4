"""Where quarter-swings are handed over from the local expansion at the turning point to ``quarters``: a small speed.

In the notation of ``quarters``; at one speed, or at one angle theta for all strengths.

>>> from fractions import Fraction
>>> from asymptotics.numbers.exact import ExactReal
>>> with ctx.workprec(80):
...     laws = [(Damping.of([(arb(1) / n, ExactReal(Fraction(2)))]), 1) for n in (10, 20)]
>>> with ctx.workprec(60):
...     [[h.str(5) for h in bundle.h] for bundle in (Bundle.of(laws), Bundle.together(laws))]
[['[1.3843 +/- ...]', '[1.3843 +/- ...]'], ['[2.2043 +/- ...]', '[2.2043 +/- ...]']]
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import reduce

import numpy as np
from flint import arb

from asymptotics.errors import LimitError, UndecidedError
from asymptotics.flow.balls import upper
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.expansion import TurningExpansion, plan_at
from asymptotics.flow.linear_spring.kept_terms import MAX_KEYS
from asymptotics.numbers.context import cached_property, ctx
from asymptotics.return_map.quarters_in_doubles import Array, QuarterInDoubles
from asymptotics.running.budget import tick

# A power of two more of the speed shortens the interval of z by ln 2, which saves a few nodes, and costs terms of the
# expansion.
HAND_OVERS = (2.0**-3, 2.0**-5, 2.0**-7, 2.0**-9)
"""Speeds, in units of the amplitude, up to which the local expansion serves: the first that takes few terms."""
_LOW = 53  # bits of the bounds
_EARLIER = arb(0.125)  # of h: by how much hand-overs at one angle come before the speed that the expansions reach
# Of hand-overs at one angle, a choice: a state before them costs as much as ten on the way, which is longer by more
# the more bits it has.  10^4 states of 3/2 over 200 half-swings took 0.76, 0.63, 0.62 s for 2^-3, 2^-5, 2^-6 in 94
# bits, 10^3 of them 1.65, 1.76, 2.1 s for 2^-3, 2^-5, 2^-7 in 300.
_LATER, _CHEAP = 4, 192
_SECANTS = 20  # rounds; five bring 100 bits


@dataclass(frozen=True)
class Bundle:
    """Orbits at their hand-over, by columns: ``strengths`` signed, h and g_0 exact, ``times`` since the turning point.

    ``dz`` and ``dg``: how far z_0 and g_0 are from the truth at most.
    """

    alphas: tuple[arb, ...]
    strengths: tuple[tuple[arb, ...], ...]
    h: tuple[arb, ...]
    g0: tuple[arb, ...]
    times: tuple[arb, ...]
    dz: arb
    dg: arb

    @classmethod
    def of(cls, laws: Sequence[tuple[Damping, int]]) -> "Bundle":
        """From the local expansions; ValueError for laws with different exponents."""
        w = _hand_over(laws)
        columns = [_Start.of(law, side, w).at(w) for law, side in laws]
        return cls._of_columns(laws, columns, [h.mid() for h, _, _ in columns])

    @classmethod
    def together(cls, laws: Sequence[tuple[Damping, int]]) -> "Bundle":
        """The same with one h: hand-overs at one angle theta."""
        w = _hand_over(laws) / (_LATER if ctx.prec < _CHEAP else 1)
        # A little before the speed up to which the expansions serve: at one angle the speeds differ with the strengths.
        h = (((1 + (1 - w * w).sqrt()) / w).log() / 2 + _EARLIER).mid()
        columns = [_Start.of(law, side, w).at_angle(h) for law, side in laws]
        return cls._of_columns(laws, columns, [h] * len(laws))

    @classmethod
    def _of_columns(
        cls, laws: Sequence[tuple[Damping, int]], columns: Sequence[tuple[arb, arb, arb]], ends: Sequence[arb]
    ) -> "Bundle":
        """From (h, g_0, time) at each hand-over; ``ends``: exact numbers in place of the h."""
        if any(law.alphas != laws[0][0].alphas for law, _ in laws):
            raise ValueError("quarter-swings of laws with different exponents")
        h, g0, times = (tuple(column) for column in zip(*columns))
        # In polar coordinates about X = 0 dry friction is a term of exponent 0 like any other.
        rubs = any(law.friction != 0 for law, _ in laws)
        alphas = (*laws[0][0].exponents, *([arb(0)] if rubs else []))
        strengths = (tuple(side * e for e in (*law.strengths, *([law.friction] if rubs else []))) for law, side in laws)
        # Exact ends for the collocation; how far the true hand-over is from them is carried as dz and dg.
        dh, dg = largest(x - y for x, y in zip(h, ends)), largest(x.rad() for x in g0)
        exact_g0 = tuple(x.mid() for x in g0)
        return cls(alphas, tuple(strengths), tuple(ends), exact_g0, times, upper(2 * dh), dg)

    @cached_property
    def in_doubles(self) -> QuarterInDoubles:
        """The same orbits in doubles, for a first solution."""
        columns = zip(*self.strengths)
        return QuarterInDoubles(doubles([self.alphas])[0], doubles(columns), *doubles([self.h, self.g0]))


@dataclass(frozen=True)
class _Start:
    """A quarter-swing next to its turning point, by the local expansion up to a speed."""

    side: int
    friction: arb
    expansion: TurningExpansion

    @classmethod
    def of(cls, law: Damping, side: int, w: arb) -> "_Start":
        tick("the start of a quarter-swing")
        # Backwards in time the quarter is the mirrored end of a half-swing: y_0 = -1 - friction, tau <= 0 (P_0 < 0).
        return cls(side, law.friction, TurningExpansion.at(law, side - law.friction, w))

    def at(self, w: arb) -> tuple[arb, arb, arb]:
        """(h, ln r, the time) at the speed w."""
        y, tau = self.expansion.state(w)
        u = self.side * (y + self.friction)
        if not u > 0:
            raise UndecidedError("the local expansion does not reach the hand-over")
        r = (u * u + w * w).sqrt()
        # h = -z_0/2 with tan(theta/2) = w/(r + u).
        return ((r + u) / w).log() / 2, r.log(), self.side * tau

    def at_angle(self, h: arb) -> tuple[arb, arb, arb]:
        """The same at about the angle of h, by secants in ln w: how far h is missed is in the answer."""
        w, slope, fine = (self.expansion.reach * (-2 * _EARLIER).exp()).mid(), arb(-0.5), arb(2) ** (4 - ctx.prec)
        here = self.at(w)
        for _ in range(_SECANTS):
            missed = (here[0] - h).mid()
            if not abs(missed) > fine:
                break
            # -2 h is nearly ln w, but for a constant.
            other = (w * (-missed / slope).exp()).mid()
            if not other < self.expansion.reach:
                raise UndecidedError("the local expansion does not reach the hand-over")
            there = self.at(other)
            slope, w, here = ((there[0] - here[0]) / (other / w).log()).mid(), other, there
        return here


def _hand_over(laws: Sequence[tuple[Damping, int]]) -> arb:
    """The largest speed at which no expansion takes more terms than one does without a given speed: a choice."""
    for w in map(arb, HAND_OVERS):
        try:
            if all(plan_at(law, side - law.friction, w).count <= MAX_KEYS for law, side in laws):
                return w
        except LimitError:
            continue
    return arb(HAND_OVERS[0])


def doubles(rows: Iterable[Iterable[arb]]) -> Array:
    """The midpoints of the balls in rows."""
    return np.array([[float(x) for x in row] for row in rows])


def largest(values: Iterable[arb]) -> arb:
    """An upper bound of all absolute values."""
    with ctx.workprec(_LOW):
        return reduce(arb.max, (x.abs_upper() for x in values))
