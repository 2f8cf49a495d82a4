"""Half-swings put together from two quarter-swings, each interpolated in the strength; every alpha_i >= 1.

With R = ln r(centre)/r(turning point) and T_q of ``quarters``, forwards at the strengths delta and backwards at F, the
strengths at the next turning point, L = ln(q/p) is the root of

    L - R(delta) + R(-F(L)) = 0,    F_i = delta_i e^((alpha_i-1) L),           T = T_q(delta) + T_q(-F).

For alpha_i >= 1 the left-hand side grows at least at the rate 1, so any number is off by at most its residual there
(derivation ``quarter-swing-tail``); that number is read off an interpolant of L that nobody has to prove.  R and T_q
are analytic in a far wider polydisc than the half-swing (``quarter_majorant``), and interpolation in z (``coordinate``)
takes fewer nodes.  Where z -> -z turns the sign of every strength (one law), one interpolant on [-z, z] serves both
quarters.  With z = ln A the half-swing ends at z + L.

*An uncertain amplitude.*  For alpha_i >= 1 the logarithms of two amplitudes do not part (derivation ``ratio-growth``):
where z' lies in a ball about z, z'_end lies between z_end (z'/z) and z_end (z/z'), and T is that of both balls.

>>> from asymptotics.numbers.exact import ExactReal
>>> with ctx.workprec(120):
...     quadratic = Coordinate.of([(arb(1), ExactReal(2))])
...     ratio, duration = HalfSwings.up_to(quadratic, arb("0.109375"), 60)(arb("0.1"))
>>> ratio.str(12), duration.str(12)      # 1 + W_0(-(1 + 2 delta) e^-(1 + 2 delta)) over 2 delta
('[0.882189986247 +/- ...]', '[3.14622255601 +/- ...]')
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from flint import arb, arb_poly

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import upper
from asymptotics.numbers.context import ctx
from asymptotics.return_map.chebyshev import Interpolant, interpolant, nodes
from asymptotics.return_map.coordinate import Coordinate
from asymptotics.return_map.half_swing_map import ROUTE, HalfSwingBalls
from asymptotics.return_map.panel_plan import Ellipse, verified, widest
from asymptotics.return_map.quarters import Quarter, quarter_swings

# Bits more for the residual of the root equation, a difference of nearly equal numbers; secants end after a few rounds,
# and the limit is for noise that goes on falling.
_GUARD, _ROUNDS = 32, 60
_ROOM = 1 + arb(2) ** -20  # for what midpoints drop
_LONGER = 1 + arb(2) ** -26  # than what is asked for
_MORE = 8  # nodes of the guess beyond twice the terms of R: a choice
_SHARE = 0.93  # of the reach in doubles: a node more costs less than a second majorant


@dataclass(frozen=True)
class Quarters:
    """R and T_q on an interval of z."""

    middle: arb
    scale: arb
    R: Interpolant
    duration: Interpolant

    @classmethod
    def of(cls, found: Sequence[Quarter], ellipse: Ellipse, middle: arb, half: arb, bits: int) -> "Quarters":
        """From those at the nodes of the interval about ``middle``."""
        # |R| <= G and |T_q - pi/2| <= excess on the whole ellipse: the constants of Cauchy's inequality (c = 0 and c =
        # pi/2).
        bounds, fine = ellipse.majorant, arb(2) ** -bits
        R = interpolant([one.ln_r for one in found], bounds.growth, ellipse.R, fine)
        return cls(middle, 1 / half, R, interpolant([one.duration for one in found], bounds.excess, ellipse.R, fine))

    def place(self, z: arb) -> arb:
        """z on [-1, 1]; UndecidedError beyond."""
        t = (z - self.middle) * self.scale
        if not abs(t) <= 1:
            raise UndecidedError("an amplitude is outside the interval of the quarter-swings")
        return t


@dataclass(frozen=True)
class HalfSwings:
    """z = A^``root`` or, without it, ln A; quarters ``forwards`` at z and ``backwards`` at ``turn`` z (-1 where both
    are one).

    ``last``: of an interval from 0; ``guess``: nearly L there, in 2 z/last - 1.
    """

    root: arb | None
    forwards: Quarters
    backwards: Quarters
    turn: int
    last: arb
    guess: arb_poly | None = None

    @classmethod
    def up_to(cls, coordinate: Coordinate, last: arb, bits: int) -> "HalfSwings":
        """For 0 <= z <= ``last`` (exact), of a coordinate that ``is_quartered`` and falls to 0.

        UndecidedError, LimitError where quarter-swings do not serve.
        """
        with ctx.workprec(bits + _GUARD):
            # z -> -z turns every delta_i = epsilon_i z^k_i, which is a quarter backwards in time: one interpolant on
            # [-z, z] instead of two.
            odd = coordinate.is_odd
            # A little longer at both ends, so that a rounded place next to one of them lies inside; no node of it is
            # below 0, as the first one is about (pi/4 m)^2 of the interval from its end.
            middle, half = (arb(0), last * _LONGER) if odd else (last / 2, last / 2 * _LONGER)
            return cls._about(coordinate, middle.mid(), half.mid(), bits, odd)._guessed(last, bits)

    @classmethod
    def mirrored(cls, root: arb | None, quarters: Quarters, last: arb, bits: int) -> "HalfSwings":
        """From quarters on [-last, last], where those at -z are those at z backwards in time."""
        return cls(root, quarters, quarters, -1, last)._guessed((last / _LONGER).mid(), bits)

    @classmethod
    def between(cls, coordinate: Coordinate, first: arb, last: arb, growth: arb, bits: int) -> "HalfSwings":
        """For first <= z = ln A <= last (exact), of a coordinate that ``is_quartered``; they end above z - ``growth``.

        UndecidedError, LimitError where quarter-swings do not serve.
        """
        with ctx.workprec(bits + _GUARD):
            # The half-swing ends at z + L, |L| <= growth; the secants may look half as far again, and beyond the
            # interval they would be refused.
            low = (first - growth * 3 / 2).mid()  # where the root is sought first
            return cls._about(coordinate, ((low + last) / 2).mid(), ((last - low) / 2 * _ROOM).mid(), bits, odd=False)

    @classmethod
    def _about(cls, coordinate: Coordinate, middle: arb, half: arb, bits: int, odd: bool) -> "HalfSwings":
        stretch = _SHARE * widest(coordinate, float(middle), float(half), whole=False)
        ellipse = verified(coordinate, middle, half, stretch, whole=False)
        count = ellipse.nodes_for(bits)
        # An even count has no node at z = 0, where all strengths vanish and no law is left.
        places = [middle + half * t for t in nodes(count + count % 2 if odd else count)]
        if odd:
            laws = [(coordinate.damping(abs(z)), 1 if z > 0 else -1) for z in places]
        else:
            laws = [(coordinate.damping(z), side) for side in (1, -1) for z in places]
        found, m = quarter_swings(laws, bits), len(places)
        both = [Quarters.of(part, ellipse, middle, half, bits) for part in (found[:m], found[m:]) if part]
        root = None if coordinate.root is None else arb(coordinate.root)
        return cls(root, both[0], both[-1], -1 if odd else 1, middle + half)

    def _guessed(self, last: arb, bits: int) -> "HalfSwings":
        """The same up to ``last`` with L nearly, from 0 on: as many nodes as R took terms, and some more."""
        places = nodes(2 * self.forwards.R.degree + _MORE)
        found = [self._near(z, self.forwards.R(self.forwards.place(z))) for z in ((t + 1) / 2 * last for t in places)]
        # A choice like any other guess: its error is not used.
        return replace(self, last=last, guess=interpolant(found, arb(1), arb(2), arb(2) ** -bits).polynomial)

    def holds(self, z: arb) -> bool:
        """Whether every place in the ball lies in the interval from 0."""
        return bool(z > 0) and bool(z <= self.last)

    def __call__(self, z: arb, wide: arb | None = None) -> tuple[arb, arb]:
        """(q/p, T) at a ball z in the interval; T of every place in the ball ``wide`` about an interval from 0."""
        t = self.forwards.place(z)
        before = self.forwards.R(t)
        L = self._near(z, before) if self.guess is None else self.guess(2 * z / self.last - 1).mid()
        # The left-hand side grows at least at the rate 1, as R falls in every delta_i and alpha_i >= 1 (derivation
        # ``quarter-swing-tail``): the root is no farther from the exact number L than the residual there.
        L += arb(0, upper(self._residual(z, before, L)))
        if wide is None:
            return L.exp(), self.forwards.duration(t) + self.backwards.duration(self._after(z, L))
        # Logarithms of amplitudes do not part, in either direction: both quotients.
        after = self._end(z, L) * (wide / z).union(z / wide)
        duration = self.forwards.duration(self.forwards.place(wide)) + self.backwards.duration(
            self.backwards.place(after)
        )
        return L.exp(), duration

    def half_swing(self, z: arb, wide: arb) -> HalfSwingBalls:
        """The half-swing from the place z of an exact amplitude; its durations are those of all places in ``wide``."""
        ratio, duration = self(z, wide)
        return HalfSwingBalls(ratio, duration, ROUTE, self.forwards.R.degree, self.forwards.R.error)

    def _after(self, z: arb, L: arb) -> arb:
        """Where the half-swing ends, on the interval of the backward quarters."""
        return self.backwards.place(self._end(z, L))

    def _end(self, z: arb, L: arb) -> arb:
        return z + L if self.root is None else self.turn * z * (self.root * L).exp()

    def _residual(self, z: arb, before: arb, L: arb) -> arb:
        return L - before + self.backwards.R(self._after(z, L))

    def _near(self, z: arb, before: arb) -> arb:
        """The root nearly: a choice, by secants."""
        # Both quarters lose nearly alike, L = 2 R; the slope is a little more than 1.
        L, slope, last = (2 * before).mid(), arb(1), None
        for _ in range(_ROUNDS):
            residual = self._residual(z, before, L).mid()
            if last is not None:
                # No better than the last: the noise of the interpolants is reached.
                if not abs(residual) < abs(last[1]):
                    break
                slope = ((residual - last[1]) / (L - last[0])).mid()
            last, L = (L, residual), (L - residual / slope).mid()
        return L if last is None else last[0]
