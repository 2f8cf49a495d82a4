"""Forces as they are read: some of the variables by themselves."""

from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.numbers.exact import parse_real


def real(text):
    return parse_real(text, "alpha")


def test_some_variables_by_themselves_are_the_forces_that_they_make():
    both = Forces.read((real("1"), real("5/2")), 4)
    for place, text in enumerate(("1", "5/2")):
        alone, here = Forces.read((real(text),), 4), both.only([place], 4)
        assert here.members == alone.members != ()
        assert (here.weights, here.signs, here.velocities) == (alone.weights, alone.signs, alone.velocities)
