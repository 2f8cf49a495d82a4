"""One Taylor step of the half-turn: its remainder is needed."""

import pytest
from flint import arb, ctx

from asymptotics.limit_cycles.certified import _Field, _picard_box, _step
from asymptotics.terms import Term

VAN_DER_POL = (Term(-1, 1), Term(1, 1, 2))


@pytest.mark.parametrize("degree", [3, 5, 8])
def test_the_remainder_of_a_step_is_needed(degree):
    """With few terms the state after the step is held, and not without the remainder."""
    with ctx.workprec(120):
        field, z, eta = _Field(VAN_DER_POL, arb(1)), (arb("1.5"), arb("-0.75"), arb(0)), arb(1) / 32
        box = _picard_box(field, z, eta)
        assert box is not None
        found = _step(field, z, box, eta, degree)
        truth = _step(field, z, box, eta, 40)
        bare = [p(eta) for p in field.taylor(z, degree - 1)]
        for whole, fine, polynomial in zip(found, truth, bare, strict=True):
            assert whole.contains(fine) and not polynomial.contains(fine)
