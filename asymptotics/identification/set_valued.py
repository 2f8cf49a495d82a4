"""All strengths for which every printed decrement is met: a certified set, not a statistical interval.

A row says that the decrement at the mean amplitude a lies in [D - r, D + r], r half a unit of the last digit.  The
decrement of a law grows with g in  L(a + D/2) + ln((a + D/2)/(a - D/2))  as in ``printed``, so that the row holds
exactly if

    -L(epsilon, a + D_lo/2) >= ln((a + D_lo/2)/(a - D_lo/2)),     -L(epsilon, a + D_hi/2) <= ln((a + D_hi/2)/(a -
    D_hi/2)).

On a box of strengths -L is its value at the centre, plus a gradient in balls times the distance, plus the tail: two
linear inequalities with proved slack.  A linear program (heuristic) finds the multipliers lambda >= 0, and

    c.y = lambda.M y + (c - M^T lambda).y >= lambda.b + min over the box of (c - M^T lambda).y

in balls turns *any* multipliers into a proved bound; in the same way multipliers of an empty program prove that no
strengths at all in the box meet every row.  Boxes shrink until they stop.  A point is proved to meet every row by
evaluating L there.

*Physical strengths.*  -s N/(1 - c N) falls when N grows, and N grows with every strength; so, by comparison of
solutions of y' = f(theta, y), -L grows with every epsilon_i.  If epsilon_i = u alone already exceeds some row, all of
epsilon >= 0 with epsilon_i >= u does.  A law is refuted only if the first box holds all of 0 <= epsilon_i <= u_i:
then no strengths >= 0 meet the rows, and none of either sign in the box.

>>> import numpy as np
>>> from asymptotics.numbers.exact import parse_real
>>> table = Decrements(np.array([1.0, 0.8]), np.array([0.10, 0.06]), np.array([0.005, 0.005]))
>>> found = strengths_that_fit((parse_real("2", "alpha"),), table)      # D is about (4/3) epsilon a^2
>>> found.verdict, found.epsilon[0].contains(0.073), found.epsilon[0].contains(0.08)
('consistent', True, False)
>>> strengths_that_fit((parse_real("0", "alpha"),), table).verdict
'refuted'
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from flint import arb, ctx, fmpq
from scipy.optimize import linprog

from asymptotics.errors import UndecidedError
from asymptotics.identification.certified_ratio import BITS, CertifiedRatio
from asymptotics.identification.coefficients import Array
from asymptotics.identification.printed import Decrements
from asymptotics.identification.profile import Interval
from asymptotics.numbers.exact import ExactReal

SEARCHED = 0.15
"""The largest local strength |epsilon_i| A^(alpha_i-1) that is searched; less if the series does not reach so far."""
MAX_LAWS = 3
_ROUNDS = 14


@dataclass(frozen=True)
class StrengthSet:
    """``consistent``: a point is proved to meet every row; ``refuted``: no physical one does; else undetermined.

    ``epsilon``: a box that is proved to hold every solution of the searched box, with the proved point as estimate.
    """

    verdict: str
    epsilon: tuple[Interval, ...]
    reason: str = ""


@dataclass(frozen=True)
class _Row:
    """sign (-L(epsilon, A) - level) >= 0."""

    sign: int
    scale: tuple[arb, ...]
    level: arb


def strengths_that_fit(alphas: tuple[ExactReal, ...], table: Decrements) -> StrengthSet:
    """The certified set for a sum of at most three laws with given exponents."""
    with ctx.workprec(BITS):
        ratio = CertifiedRatio.of(alphas)
        rows = _rows(ratio, table)
        try:
            reach = _searched(ratio, rows)
            centre, radius = np.zeros(len(alphas)), reach
            for _ in range(_ROUNDS):
                M, b = _linear(ratio, rows, centre, radius)
                if _is_empty(M, b, radius):
                    return _nothing(alphas, rows, reach)
                low, high = _bounds(M, b, radius)
                shrunk = bool(((high - low) / 2 < 0.97 * radius).any())
                centre, radius = centre + (low + high) / 2, (high - low) / 2 + 1e-15 * np.abs(centre)
                if not shrunk:
                    break
            M, b = _linear(ratio, rows, centre, radius)
            point = centre + _innermost(M, b, radius)
            met = _meets(ratio, rows, point)
        except UndecidedError as error:
            return StrengthSet("undetermined", (), str(error))
    ends = zip(centre - radius, point if met else centre, centre + radius, reach)
    epsilon = tuple(_interval(*map(float, values)) for values in ends)
    if met:
        return StrengthSet("consistent", epsilon, "")
    return StrengthSet("undetermined", epsilon, "neither a point nor its absence could be proved")


def _interval(low: float, middle: float, high: float, reach: float) -> Interval:
    """An end at the wall of the first box is no end: the set may go on behind it."""
    wall = reach * (1 - 1e-6)
    return Interval(low if low > -wall else None, middle, high if high < wall else None)


def _nothing(alphas: tuple[ExactReal, ...], rows: Sequence["_Row"], reach: Array) -> StrengthSet:
    """Nothing in the box: refuted if the box holds every physical strength that could meet the rows."""
    searched = "|epsilon| <= " + ", ".join(f"{r:.3g}" for r in reach)
    if all(_exceeds(alpha, rows, i, float(reach[i])) for i, alpha in enumerate(alphas)):
        reason = f"no strengths >= 0 meet every printed value, nor any with {searched} (proved)"
        return StrengthSet("refuted", (), reason)
    return StrengthSet(
        "undetermined", (), f"nothing meets every printed value with {searched} (proved); not searched further"
    )


def _exceeds(alpha: ExactReal, rows: Sequence["_Row"], i: int, u: float) -> bool:
    """Whether epsilon_i = u alone is proved to exceed the upper end of some row."""
    alone = CertifiedRatio.of((alpha,))
    for row in rows:
        if row.sign < 0:
            try:
                if -alone.at([row.scale[i] * arb(u)]) > row.level:
                    return True
            except UndecidedError:
                continue
    return False


def _exact(x: float) -> arb:
    """The printed decimal, exactly."""
    q = Fraction(repr(float(x)))
    return arb(fmpq(q.numerator, q.denominator))


def _rows(ratio: CertifiedRatio, table: Decrements) -> list[_Row]:
    assert table.resolution is not None
    rows = []
    for a, d, r in zip(table.amplitude, table.decrement, table.resolution):
        for sign in (1, -1):
            half = (_exact(d) - sign * _exact(r)) / 2
            upper, lower = _exact(a) + half, _exact(a) - half
            scale = tuple((w * upper.log()).exp() for w in ratio.weights)
            rows.append(_Row(sign, scale, (upper / lower).log()))
    return rows


def _searched(ratio: CertifiedRatio, rows: Sequence[_Row]) -> Array:
    """The half-sides of the first box: the largest for which the tail of the series is small in every row."""
    largest = np.array([max(float(row.scale[i]) for row in rows) for i in range(len(ratio.weights))])
    for k in range(40):
        reach = SEARCHED * 0.9**k / largest
        try:
            tails = [ratio.tail([s * arb(0, float(r)) for s, r in zip(row.scale, reach)]) for row in rows]
        except UndecidedError:
            continue
        if all(tail < arb("1e-2") for tail in tails):
            return np.asarray(reach)
    raise UndecidedError("the series does not reach the amplitudes of the table")


def _linear(ratio: CertifiedRatio, rows: Sequence[_Row], centre: Array, radius: Array) -> tuple[Array, Array]:
    """M y >= b for every solution centre + y in the box: b is rounded down after all slack is taken off."""
    matrix, bounds = [], []
    for row in rows:
        at_centre = [s * arb(float(c)) for s, c in zip(row.scale, centre)]
        in_box = [s * arb(float(c), float(r)) for s, c, r in zip(row.scale, centre, radius)]
        slopes = [-g * s * row.sign for g, s in zip(ratio.gradient(in_box), row.scale)]
        chosen = [float(s.mid()) for s in slopes]
        slack = sum((abs(s - c) * arb(float(r)) for s, c, r in zip(slopes, chosen, radius)), ratio.tail(in_box))
        b = row.sign * (row.level + ratio.polynomial(at_centre)) - slack
        matrix.append(chosen)
        bounds.append(np.nextafter(float(b.lower()), -np.inf))
    return np.array(matrix), np.array(bounds)


def _bounds(M: Array, b: Array, radius: Array) -> tuple[Array, Array]:
    """Proved bounds of y_i over M y >= b, |y| <= radius."""
    low, high = -radius.copy(), radius.copy()
    for i in range(len(radius)):
        for sign in (1.0, -1.0):
            c = np.zeros(len(radius))
            c[i] = sign
            found = linprog(c, A_ub=-M, b_ub=-b, bounds=list(zip(-radius, radius)), method="highs")
            if found.x is None:
                continue
            proved = _lower_bound(c, M, b, radius, np.maximum(-found.ineqlin.marginals, 0))
            if sign > 0:
                low[i] = max(low[i], proved)
            else:
                high[i] = min(high[i], -proved)
    return low, np.maximum(high, low)


def _lower_bound(c: Array, M: Array, b: Array, radius: Array, multipliers: Array) -> float:
    """lambda.b + min over the box of (c - M^T lambda).y, rounded down."""
    total = sum((arb(float(m)) * arb(float(v)) for m, v in zip(multipliers, b)), arb(0))
    for j, r in enumerate(radius):
        rest = arb(float(c[j])) - sum((arb(float(m)) * arb(float(M[k, j])) for k, m in enumerate(multipliers)), arb(0))
        total = total - abs(rest) * arb(float(r))
    return float(np.nextafter(float(total.lower()), -np.inf))


def _elastic(M: Array, b: Array, radius: Array) -> tuple[Array, Array]:
    """(y, multipliers) of: the least t with M y + t size >= b over the box; heuristic."""
    size = np.abs(M) @ radius + 1e-300
    padded = np.column_stack([M, size])
    c = np.append(np.zeros(len(radius)), 1.0)
    found = linprog(c, A_ub=-padded, b_ub=-b, bounds=[*zip(-radius, radius), (None, None)], method="highs")
    if found.x is None:
        return np.zeros(len(radius)), np.zeros(len(b))
    return found.x[:-1], np.maximum(-found.ineqlin.marginals, 0)


def _is_empty(M: Array, b: Array, radius: Array) -> bool:
    """Whether multipliers prove that no y in the box has M y >= b: lambda.b exceeds the maximum of lambda.M y."""
    multipliers = _elastic(M, b, radius)[1]
    return _lower_bound(np.zeros(len(radius)), M, b, radius, multipliers) > 0


def _innermost(M: Array, b: Array, radius: Array) -> Array:
    return _elastic(M, b, radius)[0]


def _meets(ratio: CertifiedRatio, rows: Sequence[_Row], point: Array) -> bool:
    """Whether every row is proved to hold at the point."""
    for row in rows:
        L = ratio.at([s * arb(float(p)) for s, p in zip(row.scale, point)])
        if not row.sign * (-L - row.level) >= 0:
            return False
    return True
