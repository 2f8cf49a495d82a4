"""What vanishes by theorem, dry friction by the shifted centre, and which losses are pure."""

from types import SimpleNamespace

import pytest
from flint import arb, ctx

from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.certified_zeros import certified_half_swing, duration_vanishes, is_pure_at
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.half_swings.quarter import half_swing
from asymptotics.numbers.exact import ExactReal, parse_real


def real(text):
    return parse_real(text, "alpha")


def test_the_duration_is_even_where_no_loss_bends_the_amplitude():
    linear, quadratic = Forces.losses([real("1")]), Forces.losses([real("2")])
    assert [duration_vanishes(linear, (n,)) for n in (1, 2, 3, 4)] == [True, False, True, False]
    assert [duration_vanishes(quadratic, (n,)) for n in (1, 2, 3, 4)] == [True, False, False, False]


@pytest.mark.parametrize("exponents", [("0", "3/2"), ("2", "0"), ("0", "sqrt(2)")])
def test_dry_friction_by_the_shifted_centre_is_dry_friction_by_the_quarter_swing(exponents):
    alphas = tuple(map(real, exponents))
    with ctx.workprec(100):
        shifted, plain = certified_half_swing(alphas, 3), half_swing(quarter_swing(alphas, 3))
        for ours, theirs in ((shifted.L, plain.L), (shifted.T, plain.T)):
            for key in {*ours.coefficients, *theirs.coefficients}:
                difference = arb(ours.coefficients.get(key, 0)) - arb(theirs.coefficients.get(key, 0))
                assert difference.contains(0) and difference.rad() < 1e-20, key


def test_a_force_that_is_no_loss_of_the_velocity_is_not_pure():
    def forces(sign, weight):
        return SimpleNamespace(signs=(sign,), weights=(ExactReal(weight),), velocities=(ExactReal(2),))

    assert is_pure_at(forces(-1, 1), (1,))
    assert not is_pure_at(forces(1, 1), (1,)) and not is_pure_at(forces(-1, 2), (1,))
