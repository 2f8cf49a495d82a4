"""Rows of a printed table as inequalities: each alone at its least favourable."""

import numpy as np
from flint import arb, ctx

from asymptotics.decays.identification.certified_sets.certified_ratio import BITS, CertifiedRatio
from asymptotics.decays.identification.certified_sets.physical import physical_box
from asymptotics.decays.identification.certified_sets.set_valued import strengths_that_fit
from asymptotics.decays.identification.certified_sets.table_rows import RatioInequality, linear, meets, rows_of
from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.terms import Term
from tests.decays.identification.certified_sets.printed_tables import losses

CUBE = CertifiedRatio((arb(0),), (arb(0),), {(1,): arb("-1e-9"), (3,): arb(-1)}, 200)
"""-L = x^3 and a little x."""


def test_a_linear_row_holds_on_the_whole_box():
    """x^3 over |x| <= 1/10: the row that is just met at the end of the box is met by its line there."""
    end = 0.125
    for place in (end, -end):
        for sign in (1, -1):
            row = RatioInequality(sign, (arb(1),), -CUBE.polynomial([arb(place)]))
            M, b = linear(CUBE, [row], np.array([0.0]), np.array([end]))
            assert M[0] * place >= b


def test_a_row_whose_decrement_may_be_negative_refutes_nothing():
    """0.001 +- 0.004 at one amplitude: its lower row asks for -L above a negative level."""
    table = Decrements(np.array([1.0, 0.5]), np.array([0.01, 0.001]), np.array([0.004, 0.004]))
    with ctx.workprec(BITS):
        ratio = CertifiedRatio.of((Term(1, 2),))
        rows = rows_of(ratio, table)
        assert any(row.sign > 0 and row.level < 0 for row in rows)
        assert physical_box((Term(1, 2),), ratio, rows) not in ("none", None)
    assert strengths_that_fit((Term(1, 2),), table).verdict == "consistent"


def test_a_row_that_is_missed_is_not_met():
    row = RatioInequality(1, (arb(1),), arb("0.01"))
    with ctx.workprec(BITS):
        assert meets(CUBE, [row], np.array([0.25])) and not meets(CUBE, [row], np.array([0.2]))


def test_a_row_that_the_truth_just_meets_is_met_with_the_tail_only():
    """No box about the centre, and L itself as the level: b <= 0 on both sides, which the truncated sum is not."""
    with ctx.workprec(80):
        ratio, d = CertifiedRatio.of(losses("1")), arb("0.0625")
        true = -arb.pi() * (d / 2) / (1 - d**2 / 4).sqrt()
        short = CertifiedRatio(
            ratio.weights, ratio.crests, {k: c for k, c in ratio.coefficients.items() if sum(k) <= 3}, 3
        )
        b = linear(
            short, [RatioInequality(sign, (arb(1),), -true) for sign in (1, -1)], np.array([0.0625]), np.zeros(1)
        )[1]
        tail = float(short.tail([d]))
    assert max(b) <= 0 < max(b) + tail * (1 - 1e-9) and min(b) > -2 * tail
