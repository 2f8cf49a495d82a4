"""Interpolation at Chebyshev points with a proved error; the function is known as balls at the nodes.

Let f be analytic with |f - c| <= M, c any constant, inside the Bernstein ellipse of parameter R > 1: foci -1 and 1,
half axes (R + 1/R)/2 and (R - 1/R)/2.  With t = (u + 1/u)/2 it is a Laurent series in 1/R < |u| < R, f = sum a_k
T_k(t), and Cauchy's inequality gives |a_k| <= 2 M R^-k for k >= 1.

*Cut.*  The nodes are the m = n + 1 zeros of T_m, t_j = cos phi_j, phi_j = (2j+1) pi/(2m).  There cos(2m phi_j) = -1 and
sin(2m phi_j) = 0, so T_(2m+i) = T_(2m-i) = -T_i on the nodes, and T_m = 0: the interpolant of T_m is 0, that of T_k,
k > m, is 0 or some +-T_i, i <= n.  Hence the interpolant p of exact values obeys, on -1 <= t <= 1,

    |f - p| <= |a_m| + 2 sum_(k>m) |a_k| <= 2 M R^-m (R + 1)/(R - 1).

f = T_m attains it up to (R + 1)/(R - 1).

*Noise.*  Values off by at most e change b_k by d_k.  The vectors 1/sqrt(m), sqrt(2/m) cos(k phi_j) are orthonormal, so
2 d_0^2 + d_1^2 + ... + d_n^2 <= 2 e^2, and by Cauchy and Schwarz the sum changes at most by e sqrt(2n + 1): all n + 1
coefficients count, since those left out below are known as badly as those kept.

*Truncation.*  Of p = sum b_k T_k through the midpoints of the values only k <= N is kept: |b_(N+1)| + ... + |b_n| is
added to the error.  So the cut may be far below what is asked for, and the error is that of the first terms left out.

>>> with ctx.workprec(80):
...     found = interpolant([t.exp() for t in nodes(20)], arb(10), arb(4), arb(2) ** -40)
...     found(arb("0.3")).str(9), found.degree
('[1.34985881 +/- ...]', 12)
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce

from flint import arb, arb_mat, arb_poly, fmpq, fmpz_poly

from asymptotics.flow.balls import upper
from asymptotics.numbers.context import ctx
from asymptotics.return_map.spectral import analysis

_BITS = 53  # in which errors are added


@dataclass(frozen=True)
class Interpolant:
    """A polynomial with exact coefficients, within ``error`` of the function on [-1, 1]."""

    polynomial: arb_poly
    error: arb

    @property
    def degree(self) -> int:
        """N of the module's docstring."""
        return int(self.polynomial.degree())

    def __call__(self, t: arb) -> arb:
        """The function at every point of the ball t that lies in [-1, 1]."""
        return self.polynomial(t) + arb(0, self.error)


def nodes(count: int) -> list[arb]:
    """The zeros of T_count, descending.

    >>> [t.str(5) for t in nodes(2)]
    ['[0.70711 +/- ...]', '[-0.70711 +/- ...]']
    """
    return [arb.cos_pi(arb(fmpq(2 * j + 1, 2 * count))) for j in range(count)]


def cut(bound: arb, ellipse: arb, count: int) -> arb:
    """2 M R^-m (R + 1)/(R - 1) for M = ``bound``, R = ``ellipse``, m = ``count`` nodes."""
    # |a_m| + 2 sum_(k>m) |a_k| with |a_k| <= 2 M R^-k: a geometric series.
    return upper(2 * bound * ellipse ** (-count) * (ellipse + 1) / (ellipse - 1))


def interpolant(values: Sequence[arb], bound: arb, ellipse: arb, tolerance: arb) -> Interpolant:
    """From the values at ``nodes``: M = ``bound`` on the ellipse R; degrees that matter less than ``tolerance`` go.

    The coefficients are computed at the current precision, which should exceed that of the values by a few bits.
    """
    m = len(values)
    # Of the midpoints only: the radii of the values count once, as noise in the norm below, and not in every
    # coefficient.
    terms = coefficients([v.mid() for v in values])
    left_out, degree = arb(0), m - 1
    # From the last one down, while all that is left out together stays within the tolerance.
    while degree > 0 and not (further := upper(left_out + upper(terms[degree]))) > tolerance:
        left_out, degree = further, degree - 1
    kept = terms[: degree + 1]
    # In powers of t, which Arb evaluates fast: the coefficients of T_n add up to at most (1 + 2^(1/2))^n = 2^(1.27 n),
    # so that 2 n bits more keep the sums exact to the precision.
    with ctx.workprec(ctx.prec + 2 * degree):
        polynomial = sum((arb_poly(fmpz_poly.chebyshev_t(k)) * c.mid() for k, c in enumerate(kept)), arb_poly([]))
    rounded = [(c + 0).mid() for c in polynomial.coeffs()]
    # |t| <= 1: rounding the coefficient of t^k counts with its own size.
    slack = sum((upper(c - r) for c, r in zip(polynomial.coeffs(), rounded, strict=True)), arb(0))
    with ctx.workprec(_BITS):
        # e sqrt(2n + 1), n + 1 = m, by Parseval on the nodes and Cauchy and Schwarz.
        noise = reduce(arb.max, (v.rad() for v in values)) * arb(2 * m - 1).sqrt()
        error = upper(cut(bound, ellipse, m) + left_out + noise + slack + sum((c.rad() for c in kept), arb(0)))
    return Interpolant(arb_poly(rounded), error)


def coefficients(values: Sequence[arb]) -> list[arb]:
    """b_0, ..., b_(m-1) with sum b_k T_k = the values at ``nodes``."""
    column = arb_mat([[v] for v in values])
    return [row[0] for row in (analysis(len(values), ctx.prec) * column).table()]
