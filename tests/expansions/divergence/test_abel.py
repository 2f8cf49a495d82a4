"""Abel functions at complex points: what an orbit leaves out, and every premise of it is asked for."""

from dataclasses import replace

import pytest
from flint import acb, arb

from asymptotics.errors import UndecidedError
from asymptotics.expansions.divergence import abel
from asymptotics.expansions.divergence.abel import at, at_height, later, odd_series
from asymptotics.expansions.divergence.constants import effort, rough_petal
from asymptotics.expansions.divergence.germ import _half, germ
from asymptotics.expansions.divergence.half_step import half_step
from asymptotics.expansions.divergence.petal import _petal
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import parse_real

DRAG = parse_real("2", "alpha")


def spoiled(row, index):
    """The row with one coefficient moved."""
    return tuple(x + arb("0.01") if n == index else x for n, x in enumerate(row))


def test_what_an_orbit_leaves_out_is_bounded():
    """Fewer terms give the same Phi_+ within their own bound, which is above their error and not far above."""
    g, p = rough_petal(DRAG)
    plan = effort(g, p, 1, 20)
    with ctx.workprec(plan.bits):
        fine, coarse = germ(DRAG, plan.order, plan.bits, 0.1), germ(DRAG, 14, plan.bits, 0.1)
        y = arb(9)
        truth, found = at_height(fine, p, odd_series(fine), y)[0], at_height(coarse, p, odd_series(coarse), y)[0]
        assert found.overlaps(truth) and found.imag.rad() > 1e6 * truth.imag.rad()
        radius = later(coarse, p, odd_series(coarse)[0], arb(144)).real.rad()
        assert 0 < radius < found.imag.rad() * 1.001
        with pytest.raises(UndecidedError, match="petal"):
            later(coarse, p, odd_series(coarse)[0], arb(1))
        with pytest.raises(UndecidedError, match="petal"):
            at_height(coarse, p, odd_series(coarse), arb(2))


def test_a_map_that_is_not_reversible_has_no_odd_solution(law):
    g, _ = law
    with ctx.workprec(100):
        with pytest.raises(ArithmeticError, match="odd power"):
            odd_series(replace(g, F=spoiled(g.F, 5)))
        with pytest.raises(ArithmeticError, match="odd power"):
            odd_series(replace(g, tau=spoiled(g.tau, 3)))
        with pytest.raises(ArithmeticError, match="reversible"):
            _half(g.eta, g.c * arb("1.01"), list(g.R), list(g.T_q))


def test_a_point_outside_the_petal_is_refused(law):
    g, p = law
    with ctx.workprec(100):
        series = odd_series(g)
        with pytest.raises(UndecidedError, match="point is not certainly"):
            at_height(g, p, series, p.Y + p.s / 2)
        Phi = series[0]
        for petal, X in (
            (replace(p, Y=arb(60)), arb(50)),  # X < Y
            (replace(p, b=arb(3000)), arb(50)),  # lambda < 0
            (replace(p, Y=arb("0.01"), b=arb(0)), arb(1)),  # outside the circle
        ):
            with pytest.raises(UndecidedError, match="orbit is not certainly"):
                later(g, petal, Phi, X)
        least = float(abs(g.c) / g.half.radii[0])
        assert _petal(g, 0.5 * least) is None and _petal(g, 1.001 * least) is None


def test_an_orbit_that_does_not_arrive_is_given_up(law, monkeypatch):
    g, p = law
    with ctx.workprec(100):
        series = odd_series(g)
        monkeypatch.setattr(abel, "_MAX_STEPS", 3)
        with pytest.raises(UndecidedError, match="not followed"):
            at(g, p, series, acb(0, -5))


def test_the_rest_of_an_orbit_is_counted_from_where_it_is(law, monkeypatch):
    """X is below Re z_J: z grows by about one a step, and the steps are counted."""
    g, p = law
    asked, steps = [], []
    monkeypatch.setattr(abel, "later", lambda g, p, f, X: asked.append(X) or acb(0))
    monkeypatch.setattr(abel, "half_step", lambda g, d: steps.append(d) or half_step(g, d))
    with ctx.workprec(100):
        at(g, p, odd_series(g), acb(0, -5))
    assert len(steps) - 3 < asked[0] < len(steps) + 3


def test_the_rest_of_an_orbit_is_its_formula(law):
    g, p = law
    X, size, rho, S = 50.0, 0.75 / 50, float(g.half.radii[0]), float(g.half.final(0))
    with ctx.workprec(100):
        for f in odd_series(g):
            found = later(g, p, f, arb(X))
            lam = 1 - float(p.b) / X**2
            along = [0, 0] + [size**m * (1 + X / ((m - 1) * lam)) for m in range(2, len(f.defect) + 1)]
            known = sum(abs(float(c)) * x for c, x in zip(f.defect, along, strict=False))
            odd = sum(abs(float(e)) * (S ** (2 * k + 1) + rho ** (2 * k + 1)) for k, e in enumerate(f.coefficients))
            last = len(f.defect)
            wanted = known + (float(f.rise) + odd) / (1 - size / rho) * along[last] / rho**last
            for part in (found.real, found.imag):
                assert wanted * (1 - 1e-8) < float(part.rad()) < wanted * (1 + 1e-6)
