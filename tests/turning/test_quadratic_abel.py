from itertools import islice

import pytest
from flint import arb, ctx, fmpq

from asymptotics.turning.quadratic_abel import quadratic_abel
from asymptotics.turning.quadratic_duration import duration
from asymptotics.turning.quadratic_map import amplitudes, next_amplitude
from asymptotics.turning.quadratic_series import abel_coefficients, time_coefficients

PRECISION = 250


@pytest.mark.parametrize("p0", [2, 200, "0.004"])
@pytest.mark.parametrize("terms", [4, 10, 20])
def test_a_jump_lands_where_the_steps_do(p0, terms):
    with ctx.workprec(PRECISION):
        head = list(islice(amplitudes(arb(p0)), 1201))
        far = 2 * quadratic_abel(terms).advance(head[100] / 2, 1100)
        assert far.overlaps(head[1200])
        assert far.rel_accuracy_bits() > 8 * terms


def test_the_time_of_a_jump_is_the_sum_of_the_half_periods():
    with ctx.workprec(PRECISION):
        head = list(islice(amplitudes(arb(2)), 401))
        total = sum((duration(a, b) for a, b in zip(head[200:], head[201:])), arb(0))
        between = quadratic_abel(12).time_between(head[200] / 2, head[400] / 2)
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
        abel, delta = quadratic_abel(5), arb(1) / 200
        image = next_amplitude(2 * delta) / 2
        scale = (delta / abel.rho) ** 10 / (1 - delta / abel.rho)
        assert abs(abel.psi(image) - abel.psi(delta) - 1) < abel.psi.D * scale
        time = duration(2 * delta, 2 * image)
        assert abs(abel.theta(image) - abel.theta(delta) - time) < abel.theta.D * scale


def test_both_series_begin_alike():
    # Theta = pi Psi + O(p): the first terms 3/2 agree, since T = pi + O(p^2).
    assert abel_coefficients(1) == time_coefficients(1) == [fmpq(3, 2)]
