"""Every public function that returns a ball has a soundness ladder, or a reason why it needs none."""

import ast

import pytest
from flint import arb

from asymptotics.errors import UndecidedError
from tests.ladders.elementary import ELEMENTARY, NUMBERS
from tests.ladders.elsewhere import ELSEWHERE
from tests.ladders.machine import size
from tests.ladders.none_needed import NONE_NEEDED
from tests.ladders.swings import SWINGS
from tests.ladders.upper_bounds import BOUNDS
from tests.ladders.walk import ROOT, returning_balls, trees
from tests.ladders.wells import WELLS

LADDERS = [*ELEMENTARY, *SWINGS, *WELLS]


def names(ladders):
    return [f"{k}-{ladder.covers[0].removeprefix('asymptotics.')}" for k, ladder in enumerate(ladders)]


def test_every_function_that_returns_a_ball_is_registered_once():
    found = set(returning_balls(trees()))
    climbed = {name for ladder in LADDERS for name in ladder.covers}
    registers = [climbed, set(BOUNDS), set(ELSEWHERE), set(NONE_NEEDED)]
    named = set().union(*registers)
    assert not found - named, "functions that return balls need a ladder, or a line in a register of tests/ladders"
    assert not named - found, "names in tests/ladders that no longer return balls"
    assert sum(map(len, registers)) == len(named), "named twice"


def test_the_tests_that_are_named_exist():
    for test in {*BOUNDS.values(), *ELSEWHERE.values()}:
        file, name = test.split("::")
        assert f"def {name}(" in (ROOT / file).read_text(), test


def test_a_function_without_a_ladder_is_found():
    modules = trees()
    known = set(returning_balls(modules))
    stray = ast.parse("from flint import arb\nclass Held:\n    x: arb\ndef f() -> list[Held]: ...\ndef g() -> int: ...")
    assert set(returning_balls({**modules, "asymptotics.stray": stray})) - known == {"asymptotics.stray.f"}


@pytest.mark.parametrize("ladder", LADDERS, ids=names(LADDERS))
def test_every_rung_holds_what_is_above_it(ladder):
    x = ladder.exact()
    truth = ladder.balls(x, ladder.truth)
    for bits in ladder.rungs:
        try:
            found = ladder.balls(x, bits)
        except UndecidedError:
            assert bits < ladder.least
            continue
        for rough, fine in zip(found, truth, strict=True):
            assert rough.contains(fine), (bits, rough, fine)
            assert bits < ladder.least or rough.rad() <= size(fine) * arb(2) ** (ladder.lost - bits), (bits, rough)


STRETCHED = [ladder for ladder in LADDERS if ladder.stretch is not None]


@pytest.mark.parametrize("ladder", STRETCHED, ids=names(STRETCHED))
def test_a_wide_input_holds_the_values_at_its_ends(ladder):
    x = ladder.exact()
    for power in ladder.wide:
        radius = arb(2) ** power
        found = ladder.balls(arb(x, radius), 60)
        for end in (x - radius, x + radius):
            for rough, fine in zip(found, ladder.balls(end, 100), strict=True):
                assert rough.contains(fine), (power, rough, fine)
        assert all(rough.rad() <= ladder.stretch * radius for rough in found), (power, found)


@pytest.mark.parametrize("fault", [lambda c: arb(c.mid(), c.rad() / 4096), lambda c: c + c.rad() * 3])
def test_a_radius_that_is_too_small_is_found(fault):
    """The machine itself: a rung from which something is taken off no longer holds the truth."""
    caught = 0
    for ladder in NUMBERS:
        truth = ladder.balls(ladder.exact(), ladder.truth)
        rough = ladder.balls(ladder.exact(), max(20, ladder.least))
        caught += any(not fault(c).contains(fine) for c, fine in zip(rough, truth, strict=True) if c.rad() > 0)
    assert caught > 5
