"""The box of physical strengths holds the truth, and its tests bite."""

from fractions import Fraction

import numpy as np
from flint import ctx

from asymptotics.decays.identification.certified_sets import physical
from asymptotics.decays.identification.certified_sets.certified_ratio import CertifiedRatio
from asymptotics.decays.identification.certified_sets.physical import physical_box
from asymptotics.decays.identification.certified_sets.table_rows import rows_of
from asymptotics.decays.identification.fitting.printed import Decrements
from tests.decays.identification.certified_sets.printed_tables import losses, printed


def test_the_physical_box_holds_the_truth_and_its_tests_bite():
    terms, table = losses("1+2"), printed("1+2", [0.01, 0.03], 3)
    with ctx.workprec(80):
        ratio = CertifiedRatio.of(terms)
        low, high = physical_box(terms, ratio, rows_of(ratio, table))
        assert (low <= [0.01, 0.03]).all()
        assert (high >= [0.01, 0.03]).all()
        assert (high - low < 0.02).all()
        # half a unit of the last digit more in one row, and the box is empty
        wrong = Decrements(table.amplitude, table.decrement + 3e-3 * (np.arange(12) == 5), table.resolution)
        assert physical_box(terms, ratio, rows_of(ratio, wrong)) == "none"


def test_a_last_box_that_is_dismissed_in_the_last_round_leaves_none(monkeypatch):
    terms, table = losses("1+2"), printed("1+2", [0.01, 0.03], 3)
    wrong = Decrements(table.amplitude, table.decrement + 3e-3 * (np.arange(12) == 5), table.resolution)
    monkeypatch.setattr(physical, "MAX_BOXES", 1)
    with ctx.workprec(80):
        ratio = CertifiedRatio.of(terms)
        assert physical_box(terms, ratio, rows_of(ratio, wrong)) == "none"
        assert isinstance(physical_box(terms, ratio, rows_of(ratio, table)), tuple)


def test_a_narrow_box_is_covered_by_its_centre_and_radius_exactly():
    random = np.random.default_rng(5)
    low = random.uniform(0.0, 1.0, 2000)
    high = low + low * 10.0 ** random.uniform(-16.0, 0.0, 2000)
    for c, r, one, two in zip(*physical._covering(low, high), low, high, strict=True):
        assert Fraction(c) - Fraction(r) <= Fraction(one)
        assert Fraction(two) <= Fraction(c) + Fraction(r)
