from itertools import islice

import mpmath
import pytest
from flint import arb, ctx
from hypothesis import given
from hypothesis import strategies as st

from asymptotics.errors import UndecidedError
from asymptotics.numbers.precision import TooWideError
from asymptotics.turning.quadratic_map import amplitudes, next_amplitude
from asymptotics.turning.quadratic_series import map_series

sizes = st.fractions(min_value=2e-6, max_value=2000)


@given(sizes)
def test_both_ends_lie_on_one_level(q):
    # The equation itself: (1+p) e^(-p) = (1-q) e^(q), Smith (43).
    with ctx.workprec(200):
        p = arb(q.numerator) / q.denominator
        image = next_amplitude(p)
        assert ((1 + p) * (-p).exp()).overlaps((1 - image) * image.exp())
        assert image.rel_accuracy_bits() > 150


@given(sizes)
def test_the_contraction_bounds(q):
    with ctx.workprec(200):
        p = arb(q.numerator) / q.denominator
        gap = 1 / next_amplitude(p) - 1 / p
        assert gap > arb(2) / 3
        assert gap < 1


def test_two_thirds_is_the_best_lower_bound():
    with ctx.workprec(200):
        p = arb("1e-9")
        assert 1 / next_amplitude(p) - 1 / p < arb(2) / 3 + arb("1e-8")


def test_the_chain_keeps_its_digits_where_the_naive_one_dies():
    with ctx.workprec(210):
        chain = list(islice(amplitudes(arb(2)), 1001))[1000]
        assert chain.rel_accuracy_bits() > 180
        naive = arb(2)
        for _ in range(120):
            y = 1 + naive
            naive = 1 + (-y * (-y).exp()).lambertw()
        assert not naive.is_finite()  # measured: NaN at step 32, 106, 419 with 50, 200, 1000 digits


def test_against_mpmath_at_higher_precision():
    with mpmath.workdps(120), ctx.workprec(200):
        p = mpmath.mpf(2)
        for ball in islice(amplitudes(arb(2)), 1, 40):
            p = 1 + mpmath.re(mpmath.lambertw(-(1 + p) * mpmath.exp(-(1 + p))))
            assert abs(ball - arb(mpmath.nstr(p, 100))) < arb("1e-50")


def test_a_ball_is_mapped_to_a_ball_that_holds_all_images():
    with ctx.workprec(100):
        wide = next_amplitude(arb(2, "0.01"))
        for p in ("1.99", "1.995", "2", "2.01"):
            assert wide.contains(next_amplitude(arb(p)).mid())
    with pytest.raises(UndecidedError, match="positive"):
        next_amplitude(arb(0, 1))
    with pytest.raises(ValueError, match="positive"):
        next_amplitude(arb(0))


def test_the_power_series_is_the_map():
    # |F(p) - sum_(k<=20) F_k p^k| < p^21 for p = 1/50: the radius of convergence is 1 and |F| < 1.
    with ctx.workprec(300):
        p = arb(1) / 50
        total = sum((arb(c) * p**k for k, c in enumerate(map_series(20))), arb(0))
        assert abs(total - next_amplitude(p)) < p**20
        assert not abs(total - next_amplitude(p)) < p**25


def test_an_amplitude_that_may_be_positive_is_too_wide():
    with pytest.raises(TooWideError, match="not certainly positive"):
        next_amplitude(arb(0, 1e-9))
