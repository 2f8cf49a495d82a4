"""All strengths for which every printed decrement is met: a certified set, not a statistical interval.

The field's word is set-membership estimation (Milanese and Vicino 1991, Automatica 27, 997-1009), with a box as the
outer approximation.

A row says that the decrement at the mean amplitude a lies in [D - r, D + r], r half a unit of the last digit: two
inequalities for the strengths (``table_rows``).  Boxes shrink by proved linear bounds until they stop; a point is
proved to meet every row by evaluating L there in balls.

``consistent``: a point is proved to meet every row.  A law that contains a consistent law is consistent, by the same
point.  ``refuted``: no strengths >= 0 meet every row, by ``physical``.  ``undetermined``: neither could be proved.

>>> import numpy as np
>>> table = Decrements(np.array([1.0, 0.8]), np.array([0.10, 0.06]), np.array([0.005, 0.005]))
>>> found = strengths_that_fit((Term(1, 2),), table)                    # D is about (4/3) epsilon a^2
>>> found.verdict, found.epsilon[0].contains(0.073), found.epsilon[0].contains(0.08)
('consistent', True, False)
>>> strengths_that_fit((Term(1, 0),), table).verdict
'refuted'
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from flint import arb

from asymptotics.decays.identification.certified_sets.central_point import chebyshev_point
from asymptotics.decays.identification.certified_sets.certified_ratio import BITS, CertifiedRatio
from asymptotics.decays.identification.certified_sets.physical import Box, physical_box
from asymptotics.decays.identification.certified_sets.table_rows import (
    RatioInequality,
    bounds,
    is_empty,
    linear,
    meets,
    rows_of,
)
from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.decays.identification.fitting.profile import Interval
from asymptotics.decays.identification.forward.candidates import Candidate
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.errors import UndecidedError
from asymptotics.numbers.context import ctx
from asymptotics.terms import Term

SEARCHED = 0.15
"""The largest local strength |epsilon_i| A^(w_i) that is searched; less if the series does not reach so far.  At 0.15
of linear loss a half-swing takes a fifth of the amplitude; what lies beyond is left to ``physical``, and the answer
says so."""
MAX_LAWS = 4
"""As many losses as ``certified_ratio`` has orders for: with five the coefficients of a useful order are too many."""
_ROUNDS = 14
"""Shrinkings of the box: each is proved, and a round that gains less than 3 % ends them sooner.  A choice."""
_OPEN = "neither a point nor its absence could be proved"
_NONE = "no strengths >= 0 meet every printed value (proved)"


@dataclass(frozen=True)
class StrengthSet:
    """``consistent``: a point is proved to meet every row; ``refuted``: no physical one does; else undetermined.

    ``epsilon``: a box that is proved to hold every solution of the searched box, with the proved point as estimate.
    """

    verdict: str
    epsilon: tuple[Interval, ...]
    reason: str = ""
    alpha: Interval | None = None

    @property
    def point(self) -> Array | None:
        """Strengths that are proved to meet every row, if such were found."""
        return np.array([e.estimate for e in self.epsilon]) if self.verdict == "consistent" else None


def strengths_that_fit(losses: tuple[Term, ...], table: Decrements, known: Array | None = None) -> StrengthSet:
    """The certified set for a sum of at most four losses (of strength 1) with given exponents.

    ``known``: strengths >= 0 that are proved to meet every row, such as those of a law that this one contains.
    """
    # The precision is set before any strength or level becomes a ball.
    with ctx.workprec(BITS):
        ratio = CertifiedRatio.of(losses)
        rows = rows_of(ratio, table)
        # A point of a law that this one contains is proved already, with further strengths 0.
        point = proved_point(losses, ratio, rows, table) if known is None else known
        try:
            reach = _searched(ratio, rows)
            box = _smallest_box(ratio, rows, reach)
            # A box that touches the end of what was searched, to a millionth, may go on behind it; the set does where
            # its point lies there.
            if box is None or (np.maximum(-box[0], box[1]) > reach * (1 - 1e-6)).any() or _is_outside(point, box):
                return _beyond(losses, ratio, rows, reach, box, point, known is not None)
            # Only then can the strengths >= 0 be empty: a point >= 0 that meets every row disproves it without a
            # search.
            if (point is None or (point < 0).any()) and physical_box(losses, ratio, rows) == "none":
                return StrengthSet("refuted", (), _NONE + ("" if point is None else "; negative ones do: unphysical"))
        except UndecidedError as error:
            # What could not be bounded says nothing against a point that is proved.
            return StrengthSet("undetermined", (), str(error)) if point is None else _open(point, str(error))
    return _found(point, box, "")


def _is_outside(point: Array | None, box: Box) -> bool:
    return point is not None and bool(((point < box[0]) | (point > box[1])).any())


def proved_point(
    losses: Sequence[Term], ratio: CertifiedRatio, rows: Sequence[RatioInequality], table: Decrements
) -> Array | None:
    """Strengths that are proved to meet every row, >= 0 if such are found; None if none are."""
    candidate = Candidate(tuple((str(t.velocity), t.position) for t in losses))
    # Strengths >= 0 first: a negative one is unphysical, but it tells that the table is no contradiction in itself.
    for physical in (True, False):
        least, theta = chebyshev_point(candidate, table, physical=physical)
        # In units of the file; this double is what balls are asked about below, so its own rounding does not matter.
        point = theta * table.reference ** -np.array([e.weight for e in candidate.elements])
        try:
            # least < 1 in doubles saves a trial in balls; what counts is meets.
            if least < 1 and meets(ratio, rows, point):
                return point
        except UndecidedError:
            continue
    return None


def _open(point: Array, scope: str) -> StrengthSet:
    """A point that is proved, in a set without known ends."""
    return StrengthSet("consistent", tuple(Interval(None, float(p), None) for p in point), scope)


def _found(point: Array | None, box: Box, scope: str) -> StrengthSet:
    ends = zip(box[0], (box[0] + box[1]) / 2 if point is None else point, box[1])
    epsilon = tuple(Interval(*map(float, values)) for values in ends)
    if point is None:
        return StrengthSet("undetermined", epsilon, f"{_OPEN}; {scope}" if scope else _OPEN)
    return StrengthSet("consistent", epsilon, scope)


def _beyond(
    losses: Sequence[Term],
    ratio: CertifiedRatio,
    rows: Sequence[RatioInequality],
    reach: Array,
    box: Box | None,
    point: Array | None,
    known: bool,
) -> StrengthSet:
    """The set goes on behind the searched box, or is not in it: what there is among the strengths >= 0."""
    searched = "|epsilon| <= " + ", ".join(f"{r:.3g}" for r in reach)
    # Without a bound for the searched box: monotone dependence bounds the strengths >= 0 from above by itself.
    physical = physical_box(losses, ratio, rows, met=known)
    if physical == "none":
        return StrengthSet("refuted", (), _NONE + (f", nor any with {searched}" if box is None else ""))
    # A negative point is no estimate within a box of strengths >= 0.
    if physical is not None and (point is None or (point >= 0).all()):
        return _found(point, physical, "the set is that of strengths >= 0")
    if point is not None:
        return _open(point, f"searched with {searched}; the set goes on behind")
    if box is None:
        reason = f"nothing meets every printed value with {searched} (proved); larger strengths are open"
        return StrengthSet("undetermined", (), reason)
    return StrengthSet("undetermined", (), _OPEN)


def _smallest_box(ratio: CertifiedRatio, rows: Sequence[RatioInequality], reach: Array) -> Box | None:
    """(low, high) of a box that holds every solution with |epsilon| <= reach; None if there is none."""
    centre, radius = np.zeros(len(reach)), reach
    # On a smaller box the gradient is sharper and the tail smaller, so that the next linear bounds are better.
    for _ in range(_ROUNDS):
        M, b = linear(ratio, rows, centre, radius)
        if is_empty(M, b, radius):
            # The multipliers of the program prove that the rows exclude the whole box.
            return None
        low, high = bounds(M, b, radius)
        # Each round costs a linear program for each end of each strength.
        shrunk = bool(((high - low) / 2 < 0.97 * radius).any())
        slack = 1e-15 * (np.abs(centre) + radius)  # more than the roundings of the next line
        centre, radius = centre + (low + high) / 2, (high - low) / 2 + slack
        if not shrunk:
            break
    # Outwards: the difference and the sum are rounded once.
    return np.nextafter(centre - radius, -np.inf), np.nextafter(centre + radius, np.inf)


def _searched(ratio: CertifiedRatio, rows: Sequence[RatioInequality]) -> Array:
    """The half-sides of the first box: the largest for which the tail of the series is small in every row."""
    largest = np.array([max(float(row.scale[i]) for row in rows) for i in range(len(ratio.weights))])
    for k in range(40):
        # The same local strength for every term at the largest amplitude; 40 steps reach 1.6 % of the first box.
        reach = SEARCHED * 0.9**k / largest
        try:
            tails = [ratio.tail([s * arb(0, float(r)) for s, r in zip(row.scale, reach)]) for row in rows]
        except UndecidedError:
            continue
        # On the first box the tail is at most 0.01 of ln(A'/A): a choice. It falls with a high power of the strengths
        # that are left; a larger one would begin with slacker rows, never with wrong ones.
        if all(tail < arb("1e-2") for tail in tails):
            return np.asarray(reach)
    raise UndecidedError("the series does not reach the amplitudes of the table")
