"""Where a stretch of free decay begins and ends, from windows that are told free or touched."""

import numpy as np
import pytest

from asymptotics.decays.records.repairs import _ends

PERIOD = 1.0
T = np.linspace(0.0, 20.0, 401)
CENTRES = np.arange(0.5, 20.0, 0.5)
"""39 windows of a period, half a period apart."""


def ends(parts, *, grown=(), size=None):
    size = np.linspace(2, 1, len(CENTRES)) if size is None else np.asarray(size, dtype=float)
    touched = np.zeros(len(CENTRES), dtype=bool)
    touched[list(grown)] = True
    return _ends(T, CENTRES, size, touched, parts, PERIOD)


@pytest.mark.parametrize(("first", "start"), [(10, 0.0), (20, 0.0), (23, 10.0), (24, 10.5), (30, 13.5)])
def test_after_a_short_hold_one_decay_begins_with_the_record_and_after_a_long_one_with_its_window(first, start):
    """Half of the record: the window begins half a period before its centre, three windows before it is free."""
    assert ends([(first, 39)]) == [(start, 20.0)]


def test_each_of_several_begins_with_the_window_that_swings_most_of_the_last_four():
    size = np.ones(len(CENTRES))
    size[[8, 22]] = 5
    size[[1, 11, 26]] = 9  # before the four, or behind the first that is free
    assert ends([(10, 15), (25, 39)], size=size) == [(CENTRES[8] - 0.5, 20.0), (CENTRES[22] - 0.5, 20.0)]
    assert ends([(3, 15), (25, 39)], size=size)[0][0] == CENTRES[0] - 0.5  # fewer than four: the first of all


def test_one_that_is_touched_again_ends_with_its_last_window_and_the_last_with_the_record():
    parts = [(10, 15), (25, 39)]
    assert [end for _, end in ends(parts, grown=[20])] == [CENTRES[14] + 0.5, 20.0]
    assert [end for _, end in ends(parts, grown=[15])] == [CENTRES[14] + 0.5, 20.0]
    assert [end for _, end in ends(parts, grown=[14])] == [20.0, 20.0]  # within it: it is not touched after it
    assert [end for _, end in ends(parts, grown=[25])] == [20.0, 20.0]
    assert [end for _, end in ends([(10, 15), (25, 30)], grown=[38])] == [20.0, CENTRES[29] + 0.5]
