"""Losses beside a linear spring: the exponents in their order, and which strengths are none."""

from fractions import Fraction

import pytest
from flint import arb, ctx

from asymptotics.errors import InputError, UndecidedError
from asymptotics.flow.damping import Damping
from asymptotics.law import Law
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.turning.half_swing import half_swing_result
from tests.flow.forces import by_strength


def test_a_law_that_is_no_damping_is_refused_as_such():
    with pytest.raises(InputError, match="this half-swing"):
        Damping.of_law(Law({2: "1/10"}, spring="pendulum"))


def test_the_losses_of_a_linear_spring_are_those_at_the_upper_end():
    law = by_strength(("1/2", "2"))
    with ctx.workprec(60):
        assert law.drag(arb(0), arb(1, "0.5")) >= arb("1.125")
        assert law.strongest(arb(1, "0.5"), arb(1)) >= 2


def test_a_strength_that_is_not_told_from_0_is_not_dropped():
    """A ball about 0 is refused; sqrt(2) less its first digits, 9e-24, is no such ball at 53 bits."""
    tiny, quadratic = parse_real("sqrt(2)", "e") - Fraction("1.41421356237309504880168"), parse_real("2", "a")
    with ctx.workprec(53):
        assert tiny.ball() > 0 and len(Damping.of([(tiny.ball(), quadratic)]).strengths) == 1
        with pytest.raises(UndecidedError, match="not told from 0"):
            Damping.of([(arb(0, 1e-20), quadratic)])


@pytest.mark.parametrize("apart", ["1e-17", "1e-19", "1e-40"])
@pytest.mark.parametrize("at", ["1/2", "1", "3/2"])
def test_the_least_exponent_is_the_least(at, apart):
    here = parse_real(at, "alpha")
    for sign in (1, -1):
        there = here + sign * parse_real(apart, "d").rational
        law = Damping.of([(arb(1), here), (arb(1), there)])
        assert law.alphas[law.leading] == min(here, there)
        assert law.sublinear is (min(here, there) < 1)


def test_two_terms_of_one_exponent_are_one():
    """Whether equal as written or not: the series of the half-swing are filed by exponent and kept one of them."""
    with ctx.workprec(80):
        quadratic, root = ExactReal(2), parse_real("sqrt(8)", "alpha")
        both = Damping.of([(arb(1) / 10, quadratic), (arb(1), root), (arb(1) / 10, quadratic), (arb(2), root)])
        assert both.alphas == (quadratic, root) and both.strengths[1] == 3 and (both.strengths[0] * 5).contains(1)
    twice, once = (half_swing_result([quadratic] * n, [ExactReal(Fraction(1, 5 * n))] * n, 12) for n in (2, 1))
    assert twice.ratio == once.ratio == "0.788539125907"
