"""The force of a limit cycle on a disc."""

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
