"""Weights and signs, one law at a time: values from the definitions, on gradings whose losses and springs differ."""

from fractions import Fraction

import pytest
from flint import acb, arb, fmpq

from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.grading import LOSS, SPRING, Grading, may_vanish
from asymptotics.series import Series

MIXED = Grading.of((2, 3, 0), (LOSS, SPRING, LOSS))
KEYS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 1), (0, 2, 1), (2, 1, 1)]


def test_weights_degrees_and_signs():
    assert MIXED.weights == (1, 2, -1) and MIXED.degrees == (2, 3, 0) and MIXED.variables == 3
    assert MIXED.signs == (LOSS, SPRING, LOSS) == (-1, 1, -1)
    assert Grading.of(iter((2, 2))).signs == (LOSS, LOSS)
    assert Grading.of(iter((Fraction(1, 2),))).weights == (Fraction(-1, 2),)


def test_a_monomial_carries_the_sum_of_its_weights():
    # a_n = n_1 (2 - 1) + n_2 (3 - 1) + n_3 (0 - 1); l(n) = n_1 + n_3: the spring is not counted.
    assert [MIXED.weight(k) for k in KEYS] == [0, 1, 2, 3, 0, 3, 3]
    assert [MIXED.loss_degree(k) for k in KEYS] == [0, 1, 0, 1, 2, 1, 3]


def test_reversal_changes_odd_loss_degrees_only():
    series = Series({k: fmpq(5 + j) for j, k in enumerate(KEYS)}, 3, 4)
    flipped = MIXED.flip(series)
    assert [flipped[k] for k in KEYS] == [5, -6, 7, -8, 9, -10, -11]
    assert MIXED.flip(flipped).coefficients == series.coefficients
    images = tuple(Series({KEYS[i + 1]: fmpq(i + 2)}, 3, 2) for i in range(3))
    found = MIXED.reversed(images)
    assert [f[KEYS[i + 1]] for i, f in enumerate(found)] == [-2, 3, -4] and len(found) == 3
    assert [MIXED.weighted(series)[k] for k in KEYS] == [0, 6, 14, 24, 0, 30, 33]


@pytest.mark.parametrize("order", [1, 2, 3, 5])
def test_local_strengths_further_on(order: int):
    # One loss of degree d, ln ratio = 3 delta: delta e^(3 (d-1) delta) = sum_n (3 (d-1))^n delta^(n+1)/n!.
    for d in (0, 1, 2, 3):
        (found,) = Grading.of((d,)).strengths(Series({(1,): fmpq(3)}, 1, order))
        expected, c = {}, fmpq(1)
        for n in range(order):
            if c != 0:
                expected[(n + 1,)] = c
            c = c * (3 * (d - 1)) / (n + 1)
        assert found.coefficients == expected and found.order == order
    (nothing,) = Grading.of((2,)).strengths(Series({}, 1, 0))
    assert nothing.coefficients == {} and nothing.order == 0


def test_each_strength_has_its_own_weight():
    first, second = Grading.of((2, 4), (LOSS, SPRING)).strengths(Series({(1, 0): fmpq(1), (0, 1): fmpq(5)}, 2, 2))
    assert first.coefficients == {(1, 0): 1, (2, 0): 1, (1, 1): 5}  # delta_0 (1 + ln ratio)
    assert second.coefficients == {(0, 1): 1, (1, 1): 3, (0, 2): 15}  # delta_1 (1 + 3 ln ratio)


@pytest.mark.parametrize("parity", [0, 1])
def test_the_vanishing_parity_is_checked(parity: int):
    kept = {k: arb(2) for k in KEYS if MIXED.loss_degree(k) % 2 == parity}
    gone = [k for k in KEYS if k not in kept]
    zeros = Series({**kept, **{k: arb(0, 1) for k in gone}}, 3, 4)
    assert set(MIXED.of_parity(zeros, parity).coefficients) == set(kept)
    for key in gone:
        with pytest.raises(UndecidedError, match="should vanish by reversibility"):
            MIXED.of_parity(Series({**kept, key: arb(1, 0.5)}, 3, 4), parity)


def test_what_may_vanish():
    yes = [arb(0), arb(0, 1), arb(1, 1), acb(arb(0, 1), arb(0, 1)), fmpq(0), 0]
    no = [arb(1), arb(1, 0.5), acb(0, 1), acb(1, 0), fmpq(1, 10**9), -1]
    assert [may_vanish(c) for c in yes + no] == [True] * 6 + [False] * 6
