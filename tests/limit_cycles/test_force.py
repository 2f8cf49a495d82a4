"""The force of a limit cycle on a disc."""

import pytest
from flint import arb

from asymptotics.law import Law
from asymptotics.limit_cycles.force import PolynomialForce
from asymptotics.limit_cycles.series import require_polynomial


def test_the_force_on_a_disc_is_bounded_and_attained():
    """|G| with every part at its largest: all parts of one sign attain it."""
    field = PolynomialForce.of(require_polynomial(Law({1: -1, (1, 2): -1}), springs=True), arb(2))
    bound = field.largest(arb(1), arb("0.5"), arb(2), arb("0.25"))
    attained = field.at(arb("1.5"), arb("2.25"))
    assert abs(attained) <= bound and bound < attained * arb("1.000001")


@pytest.mark.parametrize("law", [{2: 1}, {"3/2": 1}, {(1, 1): 1}], ids=str)
def test_a_loss_that_is_no_polynomial_has_no_force_of_whole_powers(law):
    """x'|x'| = -w^2, not w^2: with plain powers the mass would gain what it loses."""
    with pytest.raises(ArithmeticError, match="no polynomial"):
        PolynomialForce.of(Law(law).terms, arb(1))
