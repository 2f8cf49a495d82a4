"""Rows of a printed table as inequalities for the strengths, linear on a box, with proved slack.

The field's words are the mean-value form (Moore 1966) and weak duality: safe bounds from a linear program that was
solved in doubles (Neumaier and Shcherbina 2004, Math. Program. 99, 283-296).

The decrement of a law grows with g in  L(a + D/2) + ln((a + D/2)/(a - D/2))  as in ``printed``, so that a row with the
decrement D in [D_lo, D_hi] at the mean amplitude a holds exactly if

    -L(epsilon, a + D_lo/2) >= ln((a + D_lo/2)/(a - D_lo/2)),
    -L(epsilon, a + D_hi/2) <= ln((a + D_hi/2)/(a - D_hi/2)).

On a box of strengths -L is its value at the centre, plus a gradient in balls times the distance, plus the tail: two
linear inequalities.  A linear program (heuristic) finds the multipliers lambda >= 0, and

    c.y = lambda.M y + (c - M^T lambda).y >= lambda.b + min over the box of (c - M^T lambda).y

in balls turns *any* multipliers into a proved bound; in the same way multipliers of an empty program prove that no
strengths at all in the box meet every row.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from flint import arb, fmpq
from scipy.optimize import linprog

from asymptotics.decays.identification.certified_sets.certified_ratio import CertifiedRatio
from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.errors import UndecidedError


@dataclass(frozen=True)
class RatioInequality:
    """sign (-L(epsilon, A) - level) >= 0; ``scale``: A^(w_i), so that the local strengths are epsilon_i scale_i."""

    sign: int
    scale: tuple[arb, ...]
    level: arb

    def local(self, epsilon: Array) -> list[arb]:
        """The local strengths at a point."""
        return [s * arb(float(e)) for s, e in zip(self.scale, epsilon)]


def exact(x: float) -> arb:
    """The printed decimal as an exact number."""
    # repr is the shortest decimal that reads back as this double: up to 15 digits it is what stood in the table.
    q = Fraction(repr(float(x)))
    return arb(fmpq(q.numerator, q.denominator))


def rows_of(ratio: CertifiedRatio, table: Decrements) -> list[RatioInequality]:
    """Two inequalities for each row; the table has a resolution."""
    assert table.resolution is not None
    rows = []
    for a, d, r in zip(table.amplitude, table.decrement, table.resolution):
        for sign in (1, -1):
            # sign 1: the decrement is at least D - r; sign -1: it is at most D + r. The function of D in the docstring
            # increases, for the next amplitude increases with this one (paths do not cross), so that its sign at the
            # end decides.
            half = (exact(d) - sign * exact(r)) / 2
            upper, lower = exact(a) + half, exact(a) - half
            scale = tuple((w * upper.log()).exp() for w in ratio.weights)
            rows.append(RatioInequality(sign, scale, (upper / lower).log()))
    return rows


def linear(ratio: CertifiedRatio, rows: Sequence[RatioInequality], centre: Array, radius: Array) -> tuple[Array, Array]:
    """M y >= b for every solution centre + y in the box: b is rounded down after all slack is taken off.

    Rows that the series does not reach are left out, which makes the set larger; UndecidedError if none is left.
    """
    matrix, bounds = [], []
    for row in rows:
        # The local strengths of the whole box: the tail and the gradient are wanted on all of it.
        in_box = [s * arb(float(c), float(r)) for s, c, r in zip(row.scale, centre, radius)]
        try:
            tail = ratio.tail(in_box)
        except UndecidedError:
            continue
        # Mean-value form: -L = -P(centre) - P'(somewhere in the box) y, give or take the tail, P the truncated sum; the
        # gradient over the box holds that of the unknown place.
        slopes = [-g * s * row.sign for g, s in zip(ratio.gradient(in_box), row.scale)]
        # Any doubles may stand for the slopes: what they miss, times the half-sides, is taken off b.
        chosen = [float(s.mid()) for s in slopes]
        slack = sum((abs(s - c) * arb(float(r)) for s, c, r in zip(slopes, chosen, radius)), tail)
        b = row.sign * (row.level + ratio.polynomial(row.local(centre))) - slack
        matrix.append(chosen)
        # Downwards, for a smaller b is the weaker inequality; the neighbour pays for the rounding to a double.
        bounds.append(np.nextafter(float(b.lower()), -np.inf))
    if not matrix:
        raise UndecidedError("the series does not reach the amplitudes of the table")
    return np.array(matrix), np.array(bounds)


def bounds(M: Array, b: Array, radius: Array) -> tuple[Array, Array]:
    """Proved bounds of y_i over M y >= b, |y| <= radius."""
    low, high = -radius.copy(), radius.copy()
    for i in range(len(radius)):
        for sign in (1.0, -1.0):
            c = np.zeros(len(radius))
            c[i] = sign
            # The program is solved in doubles and believed in nothing but its multipliers.
            found = linprog(c, A_ub=-M, b_ub=-b, bounds=list(zip(-radius, radius)), method="highs")
            if found.x is None:
                continue
            # SciPy's marginals of <= rows are <= 0; what rounding makes of the wrong sign is set to 0, for only lambda
            # >= 0 proves.
            proved = _lower_bound(c, M, b, radius, np.maximum(-found.ineqlin.marginals, 0))
            if sign > 0:
                low[i] = max(low[i], proved)
            else:
                high[i] = min(high[i], -proved)
    # Ends that cross prove that there is no solution in the box: any interval then holds all of them.
    return low, np.maximum(high, low)


def _lower_bound(c: Array, M: Array, b: Array, radius: Array, multipliers: Array) -> float:
    """lambda.b + min over the box of (c - M^T lambda).y, rounded down."""
    # The doubles enter as the exact numbers they are, so that the balls hold all roundings of this sum.
    total = sum((arb(float(m)) * arb(float(v)) for m, v in zip(multipliers, b)), arb(0))
    for j, r in enumerate(radius):
        rest = arb(float(c[j])) - sum((arb(float(m)) * arb(float(M[k, j])) for k, m in enumerate(multipliers)), arb(0))
        # The least of rest y_j over |y_j| <= r.
        total = total - abs(rest) * arb(float(r))
    return float(np.nextafter(float(total.lower()), -np.inf))


def elastic(M: Array, b: Array, low: Array, high: Array) -> tuple[Array, Array]:
    """(y, multipliers) of: the least t with M y + t size >= b, low <= y <= high; heuristic, in units of the box."""
    # A side without length must not divide by 0. In units of the box every row has the same size: the tolerances of the
    # program (1e-7 in HiGHS) then mean the same in each.
    half = (high - low) / 2 + 1e-300
    size = np.abs(M) @ half + 1e-300
    padded = np.column_stack([M * half / size[:, None], np.ones(len(b))])
    c = np.append(np.zeros(len(half)), 1.0)
    found = linprog(
        c, A_ub=-padded, b_ub=-b / size, bounds=[*zip(low / half, high / half), (None, None)], method="highs"
    )
    if found.x is None:
        # A program that fails proves nothing: with multipliers 0 the bound is 0, and the box stays.
        return np.zeros(len(half)), np.zeros(len(b))
    return found.x[:-1] * half, np.maximum(-found.ineqlin.marginals, 0) / size


def is_empty(M: Array, b: Array, radius: Array) -> bool:
    """Whether multipliers prove that no y in the box has M y >= b: lambda.b exceeds the maximum of lambda.M y."""
    multipliers = elastic(M, b, -radius, radius)[1]
    # With c = 0: lambda.b - max lambda.M y > 0 contradicts M y >= b (Farkas).
    return _lower_bound(np.zeros(len(radius)), M, b, radius, multipliers) > 0


def meets(ratio: CertifiedRatio, rows: Sequence[RatioInequality], point: Array) -> bool:
    """Whether every row is proved to hold at the point."""
    for row in rows:
        L = ratio.at(row.local(point))
        # A ball that holds 0 is not >= 0: only what is proved is met. -L is infinite where the mass stays on its side:
        # there a lower row is met and an upper one is missed, as the decrement wants it.
        if not row.sign * (-L - row.level) >= 0:
            return False
    return True
