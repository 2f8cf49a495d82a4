"""Errors at turning points: small where they should be, growing where they should, and honest at the end."""

import numpy as np
import pytest

from paper_checks.report.turning_point_errors import turning_point_errors


@pytest.mark.parametrize("alpha", ["1/2", "3/2", "2", "3"])
def test_the_third_order_is_better_than_the_first(alpha):
    first, third = (turning_point_errors(alpha, "1/10", order, 15) for order in (1, 3))
    assert len(first.tau) == len(third.tau) >= 3
    assert np.all(third.phase < first.phase)
    good = [(np.maximum(e.amplitude, e.phase) <= 0.001).sum() for e in (first, third)]
    assert good[1] > good[0]


def test_the_phase_lag_of_first_order_saturates_at_the_closed_form():
    # alpha = 3: the total lag is 15/64 epsilon (derivation ``finite-phase-lag``);
    # order 1 has phase 0, so its error tends to it from below.
    errors = turning_point_errors("3", "1/10", 1, 60)
    assert 0.8 * 15 / 640 < errors.phase[-1] < 15 / 640 * 1.05
    assert np.all(np.diff(errors.phase) > 0)


def test_creep_is_reported():
    errors = turning_point_errors("1/2", "9/20", 3, 60)
    assert errors.ended is not None
    assert errors.ended["reason"] == "creeps"
    assert errors.tau[-1] < 60
