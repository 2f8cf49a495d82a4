"""How far the series of a half-swing reach: a majorant of the motion for complex local strengths, enclosed by steps.

A comparison theorem in the complex domain, by Cauchy's method of majorants (Hille, Ordinary Differential Equations in
the Complex Domain, chapter 2) and a differential inequality (Walter, Ordinary Differential Equations, section 9): the
modulus of the motion stays below the solution of a real equation that dominates it.

With u_i = epsilon_i r^(alpha_i - 1), s = sin(theta), c = cos(theta) (see ``quarter``), for *complex* starting values
delta_i in the polydisc |delta_i| <= rho_i, ln r = g obeys

    g' = -N/(1 - C),   N = sum_i u_i s^(alpha_i+1),   C = sum_i u_i s^alpha_i c,   u_i = delta_i e^((alpha_i-1) g).

Hence |g| <= G as long as the real majorant exists, where (derivation ``quarter-swing-tail``)

    G' = N*/(1 - C*),   N* = sum_i v_i s^(alpha_i+1),   C* = sum_i v_i s^alpha_i |c|,   v_i = rho_i e^(|alpha_i-1| G),

and G(0) = 0.
While C* < 1 the motion is analytic in all delta_i, and Cauchy's inequality bounds every coefficient and every tail:

    |R| <= G,   |T - (length)| <= int C*/(1 - C*),   |1/u - 1/delta| <= |alpha-1| int s^(alpha+1)/(1 - C*)  (one law).

*Enclosure.*  On a piece of length h let N*, C* be taken with the largest s^(alpha_i+1) and s^alpha_i |c| on it.  If a
number g satisfies G_j + h N*(g)/(1 - C*(g)) <= g, then G <= g on the whole piece: both sides grow with G, so G cannot
reach g before the end.  The candidate g comes from floats, the inequality is decided in balls.

>>> cube = majorant((arb(3),), (arb(1) / 2,))
>>> (cube.growth < arb("0.7"), cube.excess < arb("0.3")) if cube else None
(True, True)
>>> majorant((arb(3),), (arb(7) / 10,)) is None                 # beyond the radius: no bound is claimed
True
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce
from math import exp, inf, pi
from typing import Any

from flint import arb, fmpq

from asymptotics.numbers.context import ctx, lru_cache

BITS = 64
PIECES = 256
"""Pieces of a quarter-swing: they decide how sharp the majorant is, not whether it is right."""


@dataclass(frozen=True, eq=False)
class Majorant:
    """Bounds on the polydisc |delta_i| <= radii[i], at the end of the quarter (or, if ``whole``, the half) swing.

    ``growth``: of |ln r(end)/r(0)|; ``excess``: of |duration - pi/2| (or pi); ``gains``: int s^(alpha_i+1)/(1 - C*).
    """

    alphas: tuple[arb, ...]
    radii: tuple[arb, ...]
    whole: bool
    growth: arb
    excess: arb
    gains: tuple[arb, ...]

    def ratio(self, delta: Sequence[arb]) -> arb:
        """max |delta_i|/rho_i: how deep in the polydisc a point lies."""
        with ctx.workprec(BITS):
            quotients = [(abs(d) / r).upper() for d, r in zip(delta, self.radii, strict=True)]
            return reduce(arb.max, quotients)  # exact numbers, also below the range of doubles

    def final(self, i: int) -> arb:
        """A bound of |u_i| at the end."""
        with ctx.workprec(BITS):
            # |u| = |delta| e^(weight ln r) <= rho e^(|weight| G).
            return (self.radii[i] * (abs(self.alphas[i] - 1) * self.growth).exp()).upper()

    def inverse(self, i: int = 0) -> arb:
        """A bound of |1/u_i| at the end on the circle |delta_i| = rho_i (one law)."""
        with ctx.workprec(BITS):
            # 1/u - 1/delta is the integral whose bound the module docstring has; |1/delta| = 1/rho on the circle.
            return (1 / self.radii[i] + abs(self.alphas[i] - 1) * self.gains[i]).upper()


def majorant(
    alphas: Sequence[arb], radii: Sequence[arb], *, whole: bool = False, pieces: int = PIECES
) -> Majorant | None:
    """The majorant of the quarter-swing, or of the half-swing if ``whole``; None where it is not proved to exist."""
    with ctx.workprec(BITS):
        exponents = tuple(arb(a) for a in alphas)
        # Rounded up: the majorant then holds on a polydisc that is no smaller than the one asked for.
        balls = tuple(arb(arb(r).upper()) for r in radii)
        if not all(r > 0 for r in balls):
            return None
        # A ball is no key of a cache; its exact middle and radius are.
        steps = _extremes(tuple((a.mid().man_exp(), a.rad().man_exp()) for a in exponents), pieces)
        # s and |c| come back on the second quarter: s(pi - theta) = s(theta).
        walk = [*steps, *reversed(steps)] if whole else list(steps)
        h = arb.pi() / (2 * pieces)
        growth, excess, gains = arb(0), arb(0), [arb(0)] * len(exponents)
        slopes = [abs(a - 1) for a in exponents]
        for sines, products in walk:
            step = _Step(h, balls, slopes, sines, products)
            # C* and N* grow with G, so that their values at the upper end of the piece hold for all of it.
            reached = step.upper_end(growth)
            if reached is None:
                return None
            growth, room = reached, 1 - step.C(reached)
            # C*/(1 - C*) = 1/(1 - C*) - 1. Each piece is rounded up: sums of upper bounds stay upper bounds.
            excess = (excess + h * (1 / room - 1)).upper()
            gains = [(g + h * s / room).upper() for g, s in zip(gains, sines, strict=True)]
    return Majorant(exponents, balls, whole, growth, excess, tuple(gains))


def widest(alphas: Sequence[arb], direction: Sequence[arb], *, whole: bool = False, share: float = 0.97) -> Majorant:
    """A majorant on nearly the largest polydisc with radii proportional to ``direction`` (its largest entry is found).

    ``share``: the part of the largest scale found by bisection; any value is right, it only moves the bounds.
    """
    low, high = 0.0, _first_guess(alphas, direction)
    # One per cent is finer than what ``share`` gives away after it.
    while high - low > 0.01 * high:
        middle = (low + high) / 2
        seems = _seems_to_exist(alphas, [float(d) * middle for d in direction], whole)
        low, high = (middle, high) if seems else (low, middle)
    while True:
        # The proof in balls decides; where it fails the disc shrinks until it holds.
        found = majorant(alphas, [d * arb(low * share) for d in direction], whole=whole)
        if found is not None:
            return found
        low *= share


def _seems_to_exist(alphas: Sequence[arb], radii: Sequence[float], whole: bool, pieces: int = 128) -> bool:
    """Whether the fixed points of all pieces exist in floats: where to look, no claim."""
    with ctx.workprec(BITS):
        steps = _extremes_in_doubles(tuple((arb(a).mid().man_exp(), arb(a).rad().man_exp()) for a in alphas), pieces)
    # Half the pieces of the proof: larger maxima, so that what seems to exist here mostly does.
    slopes, growth, h = [abs(float(a) - 1) for a in alphas], 0.0, pi / (2 * pieces)
    for sines, products in [*steps, *reversed(steps)] if whole else steps:
        growth = _fixed_point(growth, h, list(zip(radii, slopes, sines, products, strict=True)))
        if growth == inf:
            return False
    return True


def _first_guess(alphas: Sequence[arb], direction: Sequence[arb]) -> float:
    """A scale at which sixteen pieces prove no majorant: the bisection looks below it."""
    scale = 1.0
    while majorant(alphas, [d * arb(scale) for d in direction], pieces=16) is not None:
        scale *= 2
    return scale


@dataclass(frozen=True)
class _Step:
    """One piece: its length and the largest s^(alpha_i+1) and s^alpha_i |c| on it."""

    h: arb
    radii: Sequence[arb]
    slopes: Sequence[arb]
    sines: Sequence[arb]
    products: Sequence[arb]

    def C(self, g: arb) -> arb:
        """C* at G = g."""
        return sum((v * p for v, p in zip(self._strengths(g), self.products, strict=True)), arb(0))

    def N(self, g: arb) -> arb:
        """N* at G = g."""
        return sum((v * s for v, s in zip(self._strengths(g), self.sines, strict=True)), arb(0))

    def _strengths(self, g: arb) -> list[arb]:
        return [r * (k * g).exp() for r, k in zip(self.radii, self.slopes, strict=True)]

    def upper_end(self, start: arb) -> arb | None:
        """A proved upper bound of G on the piece, or None."""
        columns = (self.radii, self.slopes, self.sines, self.products)
        rows = list(zip(*(map(float, column) for column in columns), strict=True))
        g = _fixed_point(float(start), float(self.h), rows)
        if g == inf:
            return None
        # A little above the fixed point, so that the inequality below has room for the rounding of the doubles.
        end = arb(g * (1 + 1e-12) + 1e-15)
        room = 1 - self.C(end)
        # The differential inequality: the slope grows with G, so that below ``end`` it is at most the slope there, and
        # with that one G does not pass ``end`` before the piece is over.
        if not (room > 0 and start + self.h * self.N(end) / room <= end):
            return None
        return end


def _fixed_point(start: float, h: float, rows: Sequence[tuple[float, ...]]) -> float:
    """The fixed point of g = G_j + h N*(g)/(1 - C*(g)) in floats; rows (rho, slope, s^(alpha+1), s^alpha |c|).

    By Newton's method from G_j: the right side grows and is convex, so that no step goes beyond the fixed point, and
    there is none where the slope has reached 1.
    """
    g, steepest = start, max(row[1] for row in rows)
    for _ in range(200):
        # e^700 is the end of the doubles; r would have grown by e^50: no bound of use is found there.
        if g > 50 or steepest * g > 700:
            return inf
        N = N_slope = C_slope = 0.0
        room = 1.0
        for rho, slope, sine, product in rows:
            v = rho * exp(slope * g)
            N, room = N + v * sine, room - v * product
            N_slope, C_slope = N_slope + slope * v * sine, C_slope + slope * v * product
        if room <= 0:
            return inf
        rise = h * (N_slope + N * C_slope / room) / room
        if rise >= 1:
            return inf
        step = (start + h * N / room - g) / (1 - rise)
        g += step
        if step <= 1e-14 * (1 + g):
            return g
    return inf


@lru_cache(maxsize=64)
def _extremes(alphas: tuple[tuple[Any, Any], ...], pieces: int) -> tuple[tuple[tuple[arb, ...], tuple[arb, ...]], ...]:
    """For each piece of the first quarter the largest s^(alpha_i+1) and s^alpha_i c, by the monotonicity of s and c."""
    with ctx.workprec(BITS):
        exponents = [arb(arb(m), arb(r)) for m, r in alphas]
        found = []
        for j in range(pieces):
            # s rises and c falls on the quarter: the largest s is at
            # the right end of the piece, the largest c at the left one.
            s = arb.sin_pi(arb(fmpq(j + 1, 2 * pieces)))
            c = arb.cos_pi(arb(fmpq(j, 2 * pieces)))
            powers = [s**a for a in exponents]
            found.append((tuple((p * s).upper() for p in powers), tuple((p * c).upper() for p in powers)))
        return tuple(found)


@lru_cache(maxsize=64)
def _extremes_in_doubles(
    alphas: tuple[tuple[Any, Any], ...], pieces: int
) -> tuple[tuple[tuple[float, ...], tuple[float, ...]], ...]:
    """The same in floats, for where to look."""
    return tuple((tuple(map(float, s)), tuple(map(float, c))) for s, c in _extremes(alphas, pieces))
