"""The same engine in balls: against the exact one at integers, against the closed forms in alpha elsewhere."""

import pytest
import sympy
from flint import ctx

from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.grading import may_vanish
from asymptotics.expansions.half_swings.symbolic import alpha
from asymptotics.expansions.normal_form.expansion import exact_expansion, expansion_of
from asymptotics.expansions.normal_form.symbolic import omega_2
from asymptotics.gauges import GAUGES
from asymptotics.numbers.bridge import closed_form_ball, to_sympy
from asymptotics.numbers.exact import parse_real
from paper_checks.report.verification import measured_order
from tests.second_route.closed_forms import certified_coefficients


@pytest.mark.parametrize("text", ["1/2", "3/4", "3/2", "7/3", "sqrt(2)"])
def test_closed_forms_at_exponents_that_are_not_integers(text):
    number = parse_real(text, "alpha")
    with ctx.workprec(160):
        quarter = quarter_swing([number], 4, moments=True)
        closed = certified_coefficients(number.ball())
        found = {g: expansion_of(quarter, g, arithmetic="certified") for g in GAUGES}
        for name, series in (("p", found[GAUGES[0]].p), ("Omega", found[GAUGES[0]].Omega)):
            for k, ball in closed[name].items():
                assert series[k].overlaps(ball) and series[k].rad() < 1e-30
        for gauge, expansion in found.items():
            value = closed_form_ball(sympy.simplify(omega_2(gauge).subs(alpha, to_sympy(number))))
            assert expansion.Omega[2].overlaps(value)
        assert not found[GAUGES[0]].Omega[2].overlaps(found[GAUGES[1]].Omega[2])


@pytest.mark.parametrize("gauge", GAUGES)
@pytest.mark.parametrize("alphas", [(0,), (1,), (2,), (3,), (0, 1), (1, 2)])
def test_balls_enclose_the_exact_coefficients(alphas, gauge):
    with ctx.workprec(160):
        quarter = quarter_swing([parse_real(str(a), "alpha") for a in alphas], 4, moments=True)
        balls, exact = expansion_of(quarter, gauge, arithmetic="certified"), exact_expansion(alphas, 4, gauge)
        for ours, theirs in ((balls.p, exact.p), (balls.Omega, exact.Omega)):
            for key in set(ours.coefficients) | set(theirs.coefficients):
                a, b = ours[key], theirs[key]
                assert a.overlaps(b.ball()) if not isinstance(b, int) else may_vanish(a)
                assert isinstance(a, int) or a.rad() < 1e-30


def test_measured_order_for_balls():
    with ctx.workprec(120):
        quarter = quarter_swing([parse_real("3/2", "alpha")], 4)
        assert measured_order(expansion_of(quarter, arithmetic="certified")) == pytest.approx(5, abs=0.3)
