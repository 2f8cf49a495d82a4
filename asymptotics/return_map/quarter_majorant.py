"""How far quarter-swings with all alpha_i >= 1 are analytic in the strengths: none grows more than backwards in time.

At complex strengths, |delta_i| <= rho_i, g = ln r and C obey, with s = sin(theta) and c = cos(theta) >= 0,

    g' = -N/(1 - C),    N = sum_i delta_i e^((alpha_i-1) g) s^(alpha_i+1),    C = (c/s) N,    d tau/d theta = 1/(1 - C).

Let |N| <= n and |C| <= (c/s) n < 1.  The map -N/(1 - (c/s) N) takes that disc to one about a real number, through the
images of -n and n: the real part is at most n/(1 + (c/s) n), the modulus at most n/(1 - (c/s) n).  The first of them
grows with n, and n with Re g, as alpha_i >= 1.  So Re g <= H (comparison of scalar equations; derivation
``quarter-backwards``), where H(0) = 0 and

    H' = N*/(1 + C*),    N* = sum_i rho_i e^((alpha_i-1) H) s^(alpha_i+1),    C* = (c/s) N*:

the quarter-swing backwards in time at the real strengths rho_i.  While C* < 1 the motion is analytic in the delta_i and

    |R| <= int N*/(1 - C*),    |T_q - pi/2| <= int C*/(1 - C*).

``finite_majorant`` bounds Re g by the modulus, which serves any exponent and the second quarter too; its polydisc is
half as large for 3/2.

*Enclosure.*  H' grows with n, which is largest at the end of a piece, and falls with c/s, which is least there.  If a
number h satisfies H_j + length H'(end, h) <= h, then H <= h on the whole piece, as in ``finite_majorant``.

>>> reached = quarter_majorant((arb(3) / 2,), (arb(1),))
>>> (reached.growth < 1.3, reached.excess < 0.7) if reached else None
(True, True)
>>> quarter_majorant((arb(3) / 2,), (arb("2.1"),)) is None      # C* reaches 1
True
"""

from collections.abc import Sequence
from dataclasses import dataclass
from operator import mul
from typing import Any

from flint import arb, fmpq

from asymptotics.expansions.half_swings.finite_majorant import BITS, Majorant
from asymptotics.numbers.context import ctx, lru_cache

PIECES = 256
"""Of the quarter, as of ``finite_majorant``: they decide how sharp the bounds are."""
_ROOM = arb(2) ** -50  # for the rounding of a candidate: a choice


def quarter_majorant(alphas: Sequence[arb], radii: Sequence[arb]) -> Majorant | None:
    """The bounds on the polydisc of these radii; None where they are not proved to exist.

    ValueError for an alpha below 1; a ball about 1 is that of a number >= 1.
    """
    if any(a < 1 for a in alphas):
        raise ValueError("a strength of an exponent below 1 grows as r falls")
    with ctx.workprec(BITS):
        exponents, length = tuple(map(arb, alphas)), arb.pi() / (2 * PIECES)
        # Rounded up, as in ``finite_majorant``.
        rho, weights = tuple(arb(arb(r).upper()) for r in radii), [arb((a - 1).upper()) for a in exponents]
        swell, growth, excess, gains = arb(0), arb(0), arb(0), [arb(0)] * len(exponents)
        # A ball is no key of a cache; its exact middle and radius are.
        for piece in _pieces(tuple((a.mid().man_exp(), a.rad().man_exp()) for a in exponents)):
            reached = piece.end(swell, length, rho, weights)
            if reached is None:
                return None
            swell = reached
            strengths = [r * (w * swell).exp() for r, w in zip(rho, weights, strict=True)]
            room = 1 - sum(map(mul, strengths, piece.products), arb(0))
            if not room > 0:
                return None
            # Sums of balls, rounded up at the end.  C*/(1 - C*) = 1/(1 - C*) - 1.
            growth += length * sum(map(mul, strengths, piece.sines), arb(0)) / room
            excess += length * (1 / room - 1)
            gains = [g + length * s / room for g, s in zip(gains, piece.sines, strict=True)]
        return Majorant(exponents, rho, False, growth.upper(), excess.upper(), tuple(g.upper() for g in gains))


@dataclass(frozen=True)
class _Piece:
    """The largest s^(alpha_i+1) and s^alpha_i c on a piece of the quarter, and the least c/s."""

    sines: tuple[arb, ...]
    products: tuple[arb, ...]
    cot: arb

    def end(self, start: arb, length: arb, rho: Sequence[arb], weights: Sequence[arb]) -> arb | None:
        """A number that H does not pass on the piece, or None."""

        def after(h: arb) -> arb:
            n = sum((r * (w * h).exp() * s for r, w, s in zip(rho, weights, self.sines, strict=True)), arb(0))
            return start + length * n / (1 + self.cot * n)

        first = after(start)
        second = after(first)
        # Any number will do: the fixed point is beyond the second by less than that is beyond the first.
        end = second + (second - first) + _ROOM
        end = arb(end.upper())
        return end if after(end) <= end else None


@lru_cache(maxsize=64)
def _pieces(alphas: tuple[tuple[Any, Any], ...]) -> tuple[_Piece, ...]:
    with ctx.workprec(BITS):
        exponents, found = [arb(arb(m), arb(r)) for m, r in alphas], []
        for j in range(PIECES):
            # s rises and c falls: the largest s is at the right end of the piece, the largest c at the left one.
            s, last = arb.sin_pi(arb(fmpq(j + 1, 2 * PIECES))), arb.cos_pi(arb(fmpq(j + 1, 2 * PIECES)))
            c, powers = arb.cos_pi(arb(fmpq(j, 2 * PIECES))), [s**a for a in exponents]
            found.append(_Piece(tuple(p * s for p in powers), tuple(p * c for p in powers), last / s))
        return tuple(found)
