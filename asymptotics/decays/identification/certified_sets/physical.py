"""The strengths >= 0 that meet every printed value, if there are any: boxes, halved until each is decided.

The field's words are monotone dependence (differential inequalities, Walter 1998, section 9) and branch and prune.

-s N/(1 - c N) falls when N grows, and N grows with every strength; so, by comparison of solutions of y' = f(theta, y),
-L grows with every epsilon_i.  Three things follow.

* If epsilon_i = u_i alone exceeds some row, so does every epsilon >= 0 with epsilon_i >= u_i: what there is to find
  lies in the box 0 <= epsilon_i <= u_i.
* A box whose lowest corner exceeds some row, or whose highest corner falls short of one, holds no solution.
* For the rest the linear inequalities of ``table_rows`` prove that there is none, or shrink the box, or it is halved.
"""

from collections.abc import Sequence
from typing import Literal

import numpy as np
from flint import arb

from asymptotics.decays.identification.certified_sets.certified_ratio import CertifiedRatio
from asymptotics.decays.identification.certified_sets.table_rows import RatioInequality, bounds, is_empty, linear
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.errors import UndecidedError
from asymptotics.terms import Term

MAX_BOXES, _MORE = 60, 6
"""Boxes that are looked at, and as many where a point is known, so that emptiness is out of the question.  Choices:
each box costs two half-swings and a few linear programs; fewer leave a larger box, or leave it open, and prove nothing
wrong."""
_LARGER = 1.03
"""The largest strengths are tried in steps of 3 %, from the first-order estimate on: smaller ones find a smaller first
box by more half-swings; each strength is proved."""
Box = tuple[Array, Array]


def physical_box(
    losses: Sequence[Term], ratio: CertifiedRatio, rows: Sequence[RatioInequality], *, met: bool = False
) -> Box | Literal["none"] | None:
    """(low, high) of a box that holds all strengths >= 0 that meet every row, "none" if it is proved that there are
    none, or None if the series does not reach far enough to say.  ``met``: there are some, and a larger box will do."""
    if any(row.sign < 0 and row.level < 0 for row in rows):
        return "none"  # the amplitude grows in this row, and -L >= 0
    # If one alone exceeds a row, so does every sum with it: beyond these strengths nothing is left to search.
    largest = [_largest(term, rows, i) for i, term in enumerate(losses)]
    if any(u is None for u in largest):
        return None
    size = np.array(largest, dtype=float)
    boxes: list[Box] = [(np.zeros(len(losses)), size)]
    last = _MORE if met else MAX_BOXES
    for k in range(MAX_BOXES):
        if not boxes or k > last:
            break
        # The oldest first, so that all parts of the box are looked at before any is looked at twice.
        low, high = boxes.pop(0)
        # Monotone: what the lowest corner loses too much is lost everywhere in the box, and what the highest loses too
        # little.
        if _is_beyond(ratio, rows, low, -1) or _is_beyond(ratio, rows, high, 1):
            continue
        shrunk = _shrunk(ratio, rows, low, high)
        if shrunk is not None:
            boxes += _halved(*shrunk, size)
    # Every box was proved empty or replaced by its halves; those that are left at the end make the outer box.
    if not boxes:
        return "none"
    return np.min([low for low, _ in boxes], axis=0), np.max([high for _, high in boxes], axis=0)


def _largest(term: Term, rows: Sequence[RatioInequality], i: int) -> float | None:
    """A strength at which this loss alone is proved to exceed some row; None if the series does not reach it."""
    alone = CertifiedRatio.of((term,))
    upper = [row for row in rows if row.sign < 0]
    # To first order -L = J delta: the strength at which this loss alone fills a row. Doubles propose it, the lowest row
    # first; what is returned exceeds its row in balls.
    first = -float(alone.coefficients[(1,)])
    guess = [float(row.level) / (first * float(row.scale[i])) for row in upper]
    for u, row in sorted(zip(guess, upper), key=lambda pair: pair[0]):
        # Up to 1.03^11 = 1.38 of the first order: a loss that needs more is beyond what the series or the steps reach
        # here.
        for step in range(1, 12):
            value = u * _LARGER**step
            try:
                if -alone.at([row.scale[i] * arb(value)]) > row.level:
                    return float(value)
            except UndecidedError:
                break
    return None


def _is_beyond(ratio: CertifiedRatio, rows: Sequence[RatioInequality], corner: Array, sign: int) -> bool:
    """Whether -L at the corner is proved to miss a row of this sign: above its upper end, or below its lower one.

    The row that the truncated series misses most is tried.
    """
    own = [row for row in rows if row.sign == sign]
    # Doubles choose the row, the evaluation in balls below is the proof; without a promising row it is saved.
    gaps = [sign * (-float(ratio.polynomial(row.local(corner)).mid()) - float(row.level.mid())) for row in own]
    row = own[int(np.argmin(gaps))]
    if min(gaps) > 0:
        return False
    try:
        return bool(row.sign * (-ratio.at(row.local(corner)) - row.level) < 0)
    except UndecidedError:
        return False


def _shrunk(ratio: CertifiedRatio, rows: Sequence[RatioInequality], low: Array, high: Array) -> Box | None:
    """The part of the box that may hold a solution, or None if no part does."""
    centre, radius = _covering(low, high)
    try:
        M, b = linear(ratio, rows, centre, radius)
    except UndecidedError:
        # No row is reached by the series on this box: it stays whole, and is halved.
        return low, high
    if is_empty(M, b, radius):
        return None
    below, above = bounds(M, b, radius)
    # The bounds are those of the distance to the centre; each sum is rounded once, and its neighbour outwards pays for
    # it.
    outward = np.nextafter(centre + below, -np.inf), np.nextafter(centre + above, np.inf)
    return np.maximum(low, outward[0]), np.minimum(high, outward[1])


def _covering(low: Array, high: Array) -> Box:
    """(centre, radius) with centre - radius <= low and high <= centre + radius, as exact sums of these doubles."""
    centre, radius = (low + high) / 2, (high - low) / 2
    # The centre is wrong by 1.2e-16 of itself: in a narrow box far more than any share of its radius.
    return centre, radius + 1e-15 * (np.abs(centre) + radius)


def _halved(low: Array, high: Array, size: Array) -> list[Box]:
    """The two halves of a box across its longest side, in units of the first box."""
    # Strengths of different terms have different units: only in those of the first box are sides comparable.
    i = int(np.argmax((high - low) / size))
    middle = (low[i] + high[i]) / 2
    left, right = high.copy(), low.copy()
    left[i] = right[i] = middle
    return [(low, left), (right, high)]
