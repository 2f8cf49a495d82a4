"""The regenerated figures: a circle is round, and no two curves differ in colour alone."""

from importlib import import_module
from itertools import combinations

import pytest
from matplotlib.figure import Figure

from paper_checks.registry import PAPERS

DRAWN = [(key, name) for key in PAPERS for name in import_module(f"paper_checks.{key}.figures").FIGURES]
PORTRAITS = ("fig1", "fig2", "fig3", "fig4", "fig7")


def drawn(key, name):
    axes = Figure().subplots()
    import_module(f"paper_checks.{key}.figures").FIGURES[name][1](axes)
    return axes


@pytest.mark.parametrize("name", PORTRAITS)
def test_both_axes_of_a_phase_portrait_have_one_scale(name):
    assert drawn("smith2012", name).get_aspect() == 1


@pytest.mark.parametrize(("key", "name"), DRAWN)
def test_curves_are_told_apart_without_colour(key, name):
    lines = [line for line in drawn(key, name).get_lines() if not line.get_label().startswith("_")]
    for first, second in combinations(lines, 2):
        looks = [(line.get_linestyle(), line.get_marker()) for line in (first, second)]
        assert looks[0] != looks[1], (first.get_label(), second.get_label())
