"""The series of a limit cycle."""

import pytest
from flint import fmpq_poly

from asymptotics.errors import UndecidedError
from asymptotics.limit_cycles.series import _positive_roots


def test_a_double_root_of_the_balance_has_no_series():
    assert _positive_roots(fmpq_poly([-2, 1])) == [2]
    with pytest.raises(UndecidedError, match="double root"):
        _positive_roots(fmpq_poly([4, -4, 1]))
