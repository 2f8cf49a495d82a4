"""A turning point whose place is known exactly."""

from fractions import Fraction

import pytest
from flint import arb

from asymptotics.flow.turning import TurningState, at_exact_place


def test_a_place_that_is_known_lies_in_its_enclosure():
    here = TurningState(1, -1, arb(1), arb(2), arb("1e-9"), arb(0))
    assert at_exact_place(here, None) is here and at_exact_place(here, (Fraction(-1), True)).amplitude_error == 0
    third = at_exact_place(TurningState(1, -1, arb(1) / 3, arb(2), arb("1e-9"), arb(0)), (Fraction(-1, 3), True))
    assert (3 * third.x).contains(-1) and third.amplitude_error < 1e-15
    with pytest.raises(ArithmeticError, match="turning point 1"):
        at_exact_place(here, (Fraction(1), True))
