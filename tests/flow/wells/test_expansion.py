"""The expansion at a turning point in a well."""

import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.flow.wells.expansion import WellExpansion
from asymptotics.flow.wells.force import WellForce
from asymptotics.law import Law


def test_an_expansion_begins_where_the_mass_moves():
    with ctx.workprec(60):
        force = WellForce.of(Law({0: "1/2", 2: 1}, spring={3: 1}).terms)
        assert WellExpansion.at(force, arb(1)).reach > 0
        with pytest.raises(UndecidedError, match="holds the mass here"):
            WellExpansion.at(force, arb(0, "0.9"))
