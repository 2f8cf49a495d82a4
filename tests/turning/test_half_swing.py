"""One half-swing as it is asked for: its radii, and where dry friction stops it."""

import pytest
from flint import arb

from asymptotics.errors import InputError
from asymptotics.flow.turning import TurningState
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_real
from asymptotics.turning import half_swing as half_swings
from asymptotics.turning.half_swing import half_swing_result


def real(text):
    return parse_real(text, "alpha")


def reals(*texts):
    return [real(text) for text in texts]


def test_a_half_swing_of_any_terms_keeps_its_radii(monkeypatch):
    e = arb(2) ** -20
    there = TurningState(1, -1, arb("0.5"), arb(3), e, e)
    monkeypatch.setattr(half_swings, "turning_by_pieces", lambda *_: (there, 7))
    found = half_swings.half_swing_of_terms(Law({"3/2": 1}, spring="pendulum").terms, reals("1/10", "4"), 4).to_dict()
    for name, middle in (("amplitude", 0.5), ("duration", 3.0)):
        low, high = map(float, found[name]["enclosure"])
        assert low <= middle - 2.0**-20 and middle + 2.0**-20 <= high < middle + 2.0**-19


def test_dry_friction_that_stops_at_the_centre_or_before():
    zero = [parse_real("0", "a")]
    for delta, words in (("1/2", "A'/A = 0, T = pi"), ("3/4", "before the centre"), ("2", "where it is")):
        with pytest.raises(InputError, match=words):
            half_swing_result(zero, [parse_real(delta, "d")], 10)
    assert half_swing_result(zero, [parse_real("0.49", "d")], 10).amplitude == "0.02000000000"
