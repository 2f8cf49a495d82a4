"""The second order of a sum of laws (derivation second-order-sums) against the engine's exact quarter-swings."""

import pytest
import sympy

from asymptotics.expansions.half_swings.exact import exact_quarter_swing
from asymptotics.expansions.half_swings.quarter import half_swing
from asymptotics.expansions.moments.symbolic import moment
from asymptotics.expansions.normal_form.flow import flow_of


@pytest.mark.parametrize(("a", "b"), [(1, 2), (0, 3), (2, 3), (1, 4)])
def test_the_cross_term_of_two_laws_is_in_the_frequency_alone(a, b):
    flow = flow_of(half_swing(exact_quarter_swing((a, b), 2)))
    assert flow.U[1, 1] == 0
    found = 0 if flow.W[1, 1] == 0 else flow.W[1, 1].to_sympy()
    weight = sympy.Rational(2 * a * b, (a + 1) * (b + 1))
    assert sympy.simplify(found - weight * moment(a + b)) == 0
    near_miss = weight / 2 if weight else sympy.Integer(1)  # without the factor 2 of the cross term
    assert sympy.simplify(found - near_miss * moment(a + b)) != 0
