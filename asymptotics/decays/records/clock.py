"""The times of a record: repeated stamps are merged, a clock that starts again begins another run, the rest is asked.

>>> t, x = np.array([0, 0.1, 0.1, 0.2, 0.0, 0.1]), np.arange(6.0)
>>> [piece.tolist() for piece in runs_of(t, 2)]
[[0, 1, 2, 3], [4, 5]]
"""

import numpy as np
from numpy.typing import NDArray

from asymptotics.decays.records.bursts import evened
from asymptotics.decays.records.rows import RowPlaces
from asymptotics.errors import InputError

Array = NDArray[np.float64]
LEAST_RUN, _OFTEN = 50, 8
"""Rows of a run, below which a clock that goes back is disorder and no second run; and how often both gaps of a rounded
clock must occur, so that a pause or a few lost samples are none.  Choices: what fails them stays as it is, or is
asked."""


def runs_of(t: Array, least: int = LEAST_RUN) -> list[NDArray[np.intp]]:
    """The places of each stretch of a clock that does not go back, if all stretches have ``least`` rows at least;
    otherwise one stretch of all."""
    step = np.diff(t)
    cuts = np.flatnonzero(step < 0) + 1
    pieces = np.split(np.arange(len(t)), cuts)
    usual = float(np.median(np.abs(step))) if len(step) else 0.0
    # The first step of a run is an ordinary one: a single row that was written twice begins none.
    whole = all(len(p) >= least and step[p[0]] <= 3 * usual for p in pieces if len(cuts))
    return pieces if whole else [np.arange(len(t))]


def straightened(t: Array, x: Array, rows: RowPlaces) -> tuple[Array, Array, RowPlaces, tuple[str, ...]]:
    """Increasing times: a reversed record turned round, equal neighbours merged, rows in another order put in it.

    InputError, with the row, if a time does not fit where its value would go.
    """
    notes: list[str] = []
    # In this order: turned round, sorted, merged, made regular; each looks at what the one before left.
    if len(t) > 1 and (np.diff(t) <= 0).all() and t[-1] < t[0]:
        t, x, rows = t[::-1], x[::-1], rows.kept(np.arange(len(t))[::-1])
        notes.append("time runs backwards: the rows are taken from the last to the first")
    back = np.flatnonzero(np.diff(t) < 0)
    if len(back):
        # Sorting is believed if a tenth of the rows at most goes back and the sorted times are even: each then fits its
        # place.
        order = np.argsort(t, kind="stable")
        step = np.diff(t[order])
        usual = float(np.median(step))
        if (
            len(back) > max(1, len(t) // 10)
            or usual <= 0
            or float(step.min()) < 0.3 * usual
            or float(step.max()) > 3 * usual
        ):
            row = int(back[0]) + 1
            reason = f"{rows.where(row, 't')}: {t[row]:g} after {t[row - 1]:g}"
            raise InputError("FILE", reason, "increasing values")
        notes.append(f"rows out of order (the first is row {rows.row(int(back[0]) + 1)}) sorted by their times")
        t, x, rows = t[order], x[order], rows.kept(order)
    t, together = evened(t, x)
    if together:
        apart = float(t[1] - t[0])
        notes.append(f"time stamps come in bursts of about {together:.3g} (a buffer): taken as even, {apart:.4g} apart")
    same = np.diff(t) == 0
    if same.any():
        first = int(np.argmax(same)) + 1
        many = int(same.sum())
        # Every time stands twice or more often: told apart, for then the means hide a faster sampling.
        if many > 0.5 * len(t) and many < len(t) - 1:
            notes.append("most time stamps stand several times: the clock is coarser than the samples")
        starts = np.concatenate([[True], ~same])
        group = np.cumsum(starts) - 1
        # One value at a time: the mean, since nothing says which of them is right.
        x = np.bincount(group, weights=x) / np.bincount(group)
        notes.append(
            f"{many} repeated time stamps (the first in row {rows.row(first)}): the mean of their values taken"
        )
        t, rows = t[starts], rows.kept(starts)
    even, rounded = regular(t)
    if rounded:
        t = even
        notes.append(f"time stamps are those of a regular clock rounded to {rounded:.3g}: taken as regular")
    return t, x, rows, tuple(notes)


def regular(t: Array) -> tuple[Array, float]:
    """The line of which the times are multiples of a step, rounded, and the step; 0 where there is no such line.

    Stamps that are rounded to a step are its multiples, and both gaps occur again and again: a pause, or a few samples
    that are lost, is no rounding.

    >>> even, step = regular(np.round(np.arange(100) * 0.0123, 3))
    >>> bool(np.abs(even - np.arange(100) * 0.0123).max() < 2e-4), round(step, 6)
    (True, 0.001)
    >>> regular(np.arange(100) * 0.1)[1], regular(np.arange(100) + 0.1 * np.random.default_rng(0).random(100))[1]
    (0.0, 0.0)
    >>> regular(np.arange(100) + 1000.0 * (np.arange(100) > 40))[1], regular(np.delete(np.arange(100.0), 40))[1]
    (0.0, 0.0)
    """
    gaps = np.diff(t)
    # Gaps that differ by a millionth are those of an even clock in decimals: nothing to mend.
    if len(t) < LEAST_RUN or not np.ptp(gaps) > 1e-6 * float(np.median(gaps)):
        return t, 0.0
    step = float(np.ptp(gaps))  # of rounded stamps there are two gaps, or three
    # In halves of the difference of the gaps, so that three gaps, which a step of half that makes, are whole too.
    steps = (gaps - gaps.min()) / step * 2
    line = np.polynomial.Polynomial.fit(np.arange(len(t)), t, 1)(np.arange(len(t)))
    twice = np.abs(steps - np.round(steps)).max() < 0.02
    step = step / 2 if twice and (np.round(steps) == 1).any() else step
    # The smallest gap is itself a whole number of steps, 0 excepted, if the stamps are multiples of the step.
    least = float(gaps.min()) / step
    often = min(int((gaps > gaps.min() + step / 2).sum()), int((gaps < gaps.max() - step / 2).sum())) >= _OFTEN
    whole = least > 0.98 and abs(least - round(least)) < 0.02
    # Rounding moves a stamp by half a step at most; 0.6 leaves room for the fitted line.
    return (line, step) if twice and often and whole and np.abs(t - line).max() <= 0.6 * step else (t, 0.0)
