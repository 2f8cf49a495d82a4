"""The coefficients that derivation zeros-by-theorem lets vanish, in exact half-swings, and others that do not."""

import pytest

from asymptotics.expansions.half_swings.certified_zeros import duration_vanishes, log_ratio_vanishes, map_vanishes
from asymptotics.expansions.half_swings.exact import exact_half_swing
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.normal_form.expansion import exact_expansion
from asymptotics.series import monomials
from asymptotics.terms import Term

ORDER = 4
LAWS = {
    "dry friction and x|x|": [Term(1, 0), Term(1, 0, 2, "position")],
    "linear and quadratic loss, x^3": [Term(1, 1), Term(1, 2), Term(1, 0, 3, "position")],
    "|x| sgn x' and x x'^2": [Term(1, 0, 1), Term(1, 2, 1, "position")],
    "quadratic loss and a pendulum": [Term(1, 2), Term(1, 0, 3, "position", "pendulum")],
}


@pytest.mark.parametrize("name", LAWS)
def test_what_the_theorem_lets_vanish_is_not_in_an_exact_half_swing(name):
    forces, swing = Forces.of(LAWS[name], ORDER), exact_half_swing(LAWS[name], ORDER)
    keys = [key for n in range(1, ORDER + 1) for key in monomials(len(LAWS[name]), n)]
    named = [swing.L[key] for key in keys if log_ratio_vanishes(forces, key)]
    named += [swing.T[key] for key in keys if duration_vanishes(forces, key)]
    for i, F in enumerate(swing.F):
        named += [F[key] for key in keys if map_vanishes(forces, i, key)]
    assert named and not any(x != 0 for x in named)
    assert any(swing.L[key] != 0 for key in keys)


def test_near_misses_of_the_theorem():
    """Parity by total degree; one loss beside a spring; the square of the cubic loss beside dry friction."""
    balanced = exact_half_swing(LAWS["dry friction and x|x|"], ORDER).L
    assert balanced[1, 1] != 0 and balanced[2, 2] == 0
    assert exact_half_swing([Term(1, 2), Term(1, 0, 3, "position")], 2).T[1, 1] != 0
    W = exact_expansion([Term(1, 0), Term(1, 3)], 5).flow.W
    assert all(W[n, 3] == 0 for n in range(3)) and W[0, 2] != 0


def test_the_closed_form_of_dry_friction_and_a_quadratic_spring():
    L = exact_half_swing(LAWS["dry friction and x|x|"], ORDER).L
    assert [L[1, n] for n in range(4)] == [-2, 2, -2, 2]
