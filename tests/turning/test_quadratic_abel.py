from itertools import islice

import pytest
from flint import arb, ctx, fmpq

from asymptotics.turning.quadratic_abel import AbelFunction
from asymptotics.turning.quadratic_duration import duration
from asymptotics.turning.quadratic_map import amplitudes, next_amplitude
from asymptotics.turning.quadratic_series import abel_coefficients, time_coefficients

PRECISION = 250


@pytest.mark.parametrize("p0", [2, 200, "0.004"])
@pytest.mark.parametrize("terms", [4, 10, 20])
def test_a_jump_lands_where_the_steps_do(p0, terms):
    with ctx.workprec(PRECISION):
        head = list(islice(amplitudes(arb(p0)), 1201))
        abel = AbelFunction(terms, fmpq(1, 4))
        far = abel.advance(head[100], 1100)
        assert far.overlaps(head[1200])
        assert far.rel_accuracy_bits() > 8 * terms


def test_the_time_of_a_jump_is_the_sum_of_the_half_periods():
    with ctx.workprec(PRECISION):
        head = list(islice(amplitudes(arb(2)), 401))
        total = sum((duration(a, b) for a, b in zip(head[200:], head[201:])), arb(0))
        between = AbelFunction(12, fmpq(1, 4)).time_between(head[200], head[400])
        assert between.overlaps(total)
        assert between.rel_accuracy_bits() > 100


@pytest.mark.parametrize("terms", [1, 3, 6])
def test_the_defect_has_the_order_that_the_bound_assumes(terms):
    # d(p) = O(p^(2 terms)), measured by halving p; one order less or more would fail.
    defects = []
    with ctx.workprec(600):
        for p in (arb(1) / 256, arb(1) / 512):
            psi = [sum((arb(c) * x ** (2 * k - 1) for k, c in enumerate(abel_coefficients(terms))), arb(0))
                   for x in (p, next_amplitude(p))]  # fmt: skip
            defects.append(abs(psi[1] - psi[0] - 1))
        order = (defects[0] / defects[1]).log() / arb(2).log()
        assert abs(order - 2 * terms) < 0.1


def test_the_bound_of_the_defect_is_above_the_defect():
    with ctx.workprec(400):
        abel, p = AbelFunction(5, fmpq(1, 4)), arb(1) / 100
        q = next_amplitude(p)
        psi = [sum((arb(c) * x ** (2 * k - 1) for k, c in enumerate(abel.psi)), arb(0)) for x in (p, q)]
        bound = (abel._circle_bound(abel.psi) + 1) * (4 * p) ** 10
        assert abs(psi[1] - psi[0] - 1) < bound
        assert abs(abel.theta[0] - fmpq(3, 2)) == 0
        assert duration(p, q) < abel._period_bound()


def test_a_wrong_coefficient_is_noticed():
    with ctx.workprec(PRECISION):
        head = list(islice(amplitudes(arb(2)), 301))
        abel = AbelFunction(8, fmpq(1, 4))
        abel.psi[2] += fmpq(1, 100)  # plant a fault in the cached coefficients
        assert not abel.advance(head[100], 200).overlaps(head[300])


def test_hypotheses_are_checked():
    with pytest.raises(ValueError, match="too large for the bound"):
        AbelFunction(5, fmpq(3, 5)).advance(arb("0.1"), 10)
    with pytest.raises(ValueError, match="is not in"):
        AbelFunction(5, fmpq(1, 4)).advance(arb("0.3"), 10)


def test_both_series_begin_alike():
    # Theta = pi Psi + O(p): the first terms 3/2 agree, since T = pi + O(p^2).
    assert abel_coefficients(1) == time_coefficients(1) == [fmpq(3, 2)]
