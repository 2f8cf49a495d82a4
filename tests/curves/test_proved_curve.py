"""What is proved of a solution: until when, within which size, and the reason where nothing is."""

from fractions import Fraction

import pytest
import sympy

import asymptotics as asy
from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.symbolic import alpha as symbolic_alpha
from asymptotics.shell.main import main

FADING, GROWING = {1: "1/10", 2: "1/20"}, {"1/2": "1/100", 2: "1/100"}


@pytest.mark.parametrize(
    ("law", "size", "kind"),
    [
        (GROWING, "1/1000000000", "0"),
        pytest.param(FADING, "1/500", "oo", marks=pytest.mark.slow),
        pytest.param(GROWING, "1/1000", "some", marks=pytest.mark.slow),
    ],
)
def test_until_when_a_sum_is_proved_within_a_size(law, size, kind):
    """The label is computed: for ever, up to a time, not at all; and what is proved is true of certified motion."""
    found = asy.solution(law, order=2)
    reach, moving = found.proved_until(size), asy.reference(law)
    assert reach.label == ("not proved" if kind == "0" else "proved")
    assert reach.until == kind or (kind == "some" and float(Fraction(reach.until)) > 1)
    if kind != "0":
        last = 30 if kind == "oo" else Fraction(reach.until)
        for time in (last / 3, last):
            point = found.at(str(time), digits=20)
            assert abs(float(point.x) - float(moving.at(str(time), digits=15).x)) <= float(Fraction(size))


HEAVY = {"mass": "3/2", "stiffness": 30, "x0": "1/5"}


@pytest.mark.parametrize(
    ("law", "start"),
    [
        ({"3/2": "1/10"}, {}),
        ({"3/2": "1/10", 2: "1/10"}, {}),
        ({"3/2": "1/10", 2: "1/10"}, {"v0": "1/2"}),
        ({1: "1/10"}, {"mass": "sqrt(2)", "stiffness": 3}),
    ],
)
def test_strengths_that_are_products_of_roots_are_served_like_all_others(law, start):
    """In SI epsilon = b omega_0^alpha l^(alpha-1)/k is such a product: every method refused it by accident."""
    heavy = asy.Oscillator(law, **{**HEAVY, **start})
    found, moving = asy.solution(heavy, order=2), asy.reference(heavy)
    omega, length = (float(ball.mid()) for ball in (heavy.omega_0(), heavy.length()))
    gap = abs(float(found.at(9, digits=12).x) - float(moving.at(str(Fraction(9 / omega)), digits=15).x) / length)
    proved = found.proved()
    assert proved.label == "proved" and 0 < gap <= float(proved.size) < 1e-3
    assert float(found.sample([9.0])[2][0]) == pytest.approx(float(found.at(9).x), abs=1e-9)
    if found.start is None and len(law) == 1:
        assert gap <= float(found.bound(9, digits=12)) <= float(proved.size)


def test_a_proved_time_needs_a_size():
    with pytest.raises(InputError, match="within"):
        asy.solution(FADING, order=2).proved_until(0)


def test_what_is_proved_is_told_and_what_is_not_has_its_reason(capsys):
    """One law from rest: proved, with a size; no strength, a start in motion, strong damping: asymptotic, and why."""
    proved = asy.solution({2: "1/20"}, order=2)
    told = proved.to_dict()
    assert (told["valid_until"], told["valid_label"]) == ("oo", "proved")
    assert told["valid_within"] == proved.proved().size and f"<= {told['valid_within']} for every tau" in str(proved)
    moving = asy.reference({2: "1/20"})
    for time in ("7", "30"):
        gap = float(moving.at(time, digits=15).x) - float(proved.at(time, digits=20).x)
        assert 0 < abs(gap) <= float(told["valid_within"])
    for law, why in ((2, "strength"), ({2: 2}, "range"), (asy.Oscillator({2: "1/10"}, v0=1), "start in motion")):
        found = asy.solution(law, order=2).to_dict()
        assert found["valid_label"] == "asymptotic" and why in found["not_proved"]
    both = asy.Oscillator({1: "1/40", "3/2": "1/40"}, x0="3/5", v0="-4/5")
    summed, moving = asy.solution(both, order=2), asy.reference(both)
    told = summed.to_dict()
    assert told["valid_label"] == "proved" and f"<= {told['valid_within']} for every tau" in str(summed)
    gap = float(moving.at("9", digits=15).x) - float(summed.at("9", digits=20).x)
    assert 0 < abs(gap) <= float(told["valid_within"])
    sprung = asy.solution(asy.Oscillator({2: "1/10"}, spring={3: "1/10"}), order=2).to_dict()
    assert (sprung["valid_until"], sprung["valid_label"]) == (None, "asymptotic") and "springs" in sprung["not_proved"]
    assert asy.solution("symbolic", order=2).valid_until.subs(symbolic_alpha, 2) == sympy.oo
    assert proved.proved_until("1/1000").until == "oo" and proved.proved_until("1/10000000").label == "not proved"
    with pytest.raises(InputError, match="within"):
        proved.proved_until(0)
    assert main(["solution", "--alpha", "2", "--epsilon", "3", "--order", "2"]) == 0
    assert "proved  nothing for all times" in capsys.readouterr().out
