"""The boxes of strengths >= 0: what dismisses one, and that what is not proved dismisses nothing."""

from types import SimpleNamespace

import numpy as np
import pytest
from flint import arb

from asymptotics.decays.identification.certified_sets.physical import _covering, _halved, _is_beyond
from asymptotics.errors import UndecidedError


def ratio(bias=0.0, failing=False, seen=None):
    """-L = 2 delta in balls; in doubles with a bias."""

    def at(local):
        if seen is not None:
            seen.append(float(local[0].mid()))
        if failing:
            raise UndecidedError("not reached")
        return -2 * local[0]

    return SimpleNamespace(at=at, polynomial=lambda local: -2 * local[0] - arb(bias))


def row(sign, level, scale=1.0):
    return SimpleNamespace(
        sign=sign, level=arb(level), scale=(arb(scale),), local=lambda c: [arb(scale) * arb(float(c[0]))]
    )


@pytest.mark.parametrize(
    ("corner", "sign", "beyond"),
    [(0.3, -1, True), (0.2, -1, False), (0.25, -1, False), (0.05, 1, True), (0.1, 1, False)],
)
def test_a_corner_is_beyond_a_row_that_it_is_proved_to_miss(corner, sign, beyond):
    """Upper rows ask -L <= 1/2, lower ones -L >= 1/5; just met is met."""
    rows = [row(-1, 0.5), row(1, 0.2)]
    assert _is_beyond(ratio(), rows, np.array([corner]), sign) == beyond


def test_what_is_not_reached_or_not_decided_is_not_beyond():
    corner, rows = np.array([0.3]), [row(-1, 0.5)]
    assert _is_beyond(ratio(), rows, corner, -1) and not _is_beyond(ratio(failing=True), rows, corner, -1)
    wide = SimpleNamespace(at=lambda local: arb(-0.6, 0.2), polynomial=lambda local: -2 * local[0])
    assert not _is_beyond(wide, rows, corner, -1)
    assert not _is_beyond(ratio(bias=-0.2), rows, corner, -1)  # in doubles no row is missed: no trial


def test_the_row_that_is_missed_most_is_tried():
    seen = []
    rows = [row(-1, 0.5, 1.0), row(-1, 0.5, 3.0), row(-1, 0.5, 2.0), row(1, 0.2, 9.0)]
    assert _is_beyond(ratio(seen=seen), rows, np.array([0.3]), -1) and seen == pytest.approx([0.9])


def test_a_box_is_halved_across_its_longest_side_in_units_of_the_first():
    low, high, size = np.array([0.0, 1.0]), np.array([4.0, 2.0]), np.array([8.0, 1.0])
    (a, b), (c, d) = _halved(low, high, size)
    assert (a.tolist(), b.tolist(), c.tolist(), d.tolist()) == ([0, 1], [4, 1.5], [0, 1.5], [4, 2])
    (a, b), (c, d) = _halved(low, high, np.ones(2))
    assert (b.tolist(), c.tolist()) == ([2, 2], [2, 1]) and low.tolist() == [0, 1] and high.tolist() == [4, 2]


@pytest.mark.parametrize(("low", "high"), [(0.1, 0.7), (1.0, 1.0 + 2**-52), (1e-9, 1.0), (0.3, 0.3)])
def test_the_covering_box_holds_both_ends_as_exact_sums(low, high):
    centre, radius = _covering(np.array([low]), np.array([high]))
    exact = arb(float(centre[0])) - arb(float(radius[0])), arb(float(centre[0])) + arb(float(radius[0]))
    assert exact[0] <= low and exact[1] >= high and radius[0] < (high - low) / 2 + 1e-14
