"""The stored table of errors, estimates and bounds: complete, in order, and a sample of it computed again."""

import pytest

from paper_checks.report.engine import AT_ONE_TIME, _compared
from paper_checks.report.expansion_errors import EPSILONS, LAWS, ORDERS, row, stored


def test_the_table_is_complete():
    found = [(r["alpha"], r["epsilon"], int(r["order"])) for r in stored()]
    assert found == [(", ".join(laws), epsilon, order) for laws in LAWS for epsilon in EPSILONS for order in ORDERS]
    for cell in (AT_ONE_TIME, "{all turning points}", "{all times}"):
        assert len(_compared(cell)) == len(LAWS) * len(ORDERS)


def test_error_bound_and_estimate_are_in_order():
    for r in stored():
        error, bound, estimate = (float(r[name]) for name in ("error", "bound", "estimate"))
        assert error <= bound <= estimate, r
        if r["all times"] != "out of range":
            assert error <= float(r["all times"].split(",")[0]), r


@pytest.mark.parametrize("index", [8, 32, 61, 127])
def test_a_sample_is_computed_again(index):
    kept = stored()[index]
    laws = tuple(kept["alpha"].split(", "))
    assert row(laws, kept["epsilon"], int(kept["order"])) == kept


@pytest.mark.slow
def test_every_row_is_computed_again():
    for kept in stored():
        assert row(tuple(kept["alpha"].split(", ")), kept["epsilon"], int(kept["order"])) == kept
