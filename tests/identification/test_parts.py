"""Parts of what a printed table proves, each alone at its least favourable."""

import numpy as np
import pytest
from flint import arb, ctx
from scipy.optimize import brentq

from asymptotics.errors import UndecidedError
from asymptotics.identification.certified_sets.certified_ratio import BITS, CertifiedRatio
from asymptotics.identification.certified_sets.free_exponent import _Strips
from asymptotics.identification.certified_sets.physical import physical_box
from asymptotics.identification.certified_sets.set_valued import _beyond, strengths_that_fit
from asymptotics.identification.certified_sets.table_rows import RatioInequality, linear, meets, rows_of
from asymptotics.identification.fitting.printed import Decrements
from asymptotics.terms import Term

CUBE = CertifiedRatio((arb(0),), (arb(0),), {(1,): arb("-1e-9"), (3,): arb(-1)}, 200)
"""-L = x^3 and a little x."""


def test_the_tail_of_a_sum_that_is_not_followed_is_added_whole():
    ratio = CertifiedRatio.of((Term(1, 2),))
    few = CertifiedRatio(ratio.weights, ratio.crests, {(1,): ratio.coefficients[(1,)]}, 1)
    with ctx.workprec(BITS):
        for size in (arb("0.1"), arb("1e-7")):
            assert few.at([size]).rad() >= few.tail([size]) * arb("0.999")


def test_negative_strengths_are_not_followed():
    """What is followed is a loss: a gain has the series alone, or nothing."""
    ratio = CertifiedRatio.of((Term(1, 2),))
    with ctx.workprec(BITS):
        assert ratio.at([arb("0.3")]) < 0
        for size in ("-0.2", "-0.3", "-5"):
            try:
                tail = ratio.tail([arb(size)])
            except UndecidedError:
                with pytest.raises(UndecidedError, match="too large"):
                    ratio.at([arb(size)])
            else:
                assert ratio.at([arb(size)]).rad() >= tail * arb("0.999")


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


@pytest.mark.parametrize("size", [1.0, 3.0])
def test_the_strengths_at_one_exponent_hold_the_truth_from_both_sides_and_are_not_wide(size):
    """x'^2: (1 + 2 e A) exp(-2 e A) = (1 - 2 e B) exp(2 e B) from A to -B, in any unit; printed to four digits."""
    e, tops = 0.03, size * np.array([1.0, 0.8, 0.6])
    energy = lambda y: np.log1p(y) - y  # noqa: E731
    ends = [brentq(lambda y, a=a: energy(-y) - energy(2 * e * a), 0, 2 * e * a) / (2 * e) for a in tops]
    table = Decrements((tops + ends) / 2, np.round(tops - ends, 4), np.full(3, 5e-5))
    with ctx.workprec(BITS):
        low, high = _Strips.of(table).strengths(2.0, 2.0)
    assert low < e < high < 1.01 * low


def test_a_negative_point_is_no_estimate_of_strengths_that_are_not_negative():
    """Where the set goes on behind the searched box, a box of the strengths >= 0 has no room for a negative point."""
    losses = (Term(1, 1), Term(1, 2))
    a = np.array([1.0, 0.9])
    table = Decrements(a, np.array([0.06, 0.05]), np.array([0.02, 0.02]))
    negative, positive = np.array([-0.002, 0.05]), np.array([0.01, 0.02])
    with ctx.workprec(BITS):
        ratio = CertifiedRatio.of(losses)
        rows = rows_of(ratio, table)
        found = [_beyond(losses, ratio, rows, np.ones(2), None, p, False) for p in (negative, positive)]
        assert meets(ratio, rows, negative) and meets(ratio, rows, positive)
    for answer, point in zip(found, (negative, positive)):
        assert answer.verdict == "consistent" and (answer.point == point).all()
        assert all(e.low is None or e.low <= e.estimate <= e.high for e in answer.epsilon)
    assert found[1].epsilon[0].low is not None
