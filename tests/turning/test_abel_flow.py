"""A sum's jump lands where the steps do; its bound is nearly attained, so that half of it would be wrong."""

from dataclasses import replace
from itertools import islice, product

import mpmath
import numpy as np
import pytest
from flint import acb, arb, ctx
from scipy.integrate import quad, solve_ivp

from asymptotics.errors import UndecidedError
from asymptotics.flow.damping import Damping
from asymptotics.flow.sequence import sequence
from asymptotics.flow.turning import at_rest
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_real
from asymptotics.return_map.panels import Panels
from asymptotics.return_map.sequence import Interpolated
from asymptotics.turning.abel_flow import abel_flow
from asymptotics.turning.choose import turning_points
from asymptotics.turning.jump import planned
from asymptotics.turning.routes import abel_flow as by_flow
from asymptotics.turning.table import Request

LAWS = [(("3/2", "3"), ("1/1000", "1/100000")), (("sqrt(2)", "5/2"), ("1/1000", "1/100000"))]


def flow_of(law, terms):
    alphas, epsilons = law
    numbers = [parse_real(a, "alpha") for a in alphas]
    return abel_flow(numbers, [parse_real(e, "epsilon").ball() for e in epsilons], terms)


@pytest.fixture(scope="module")
def orbits():
    """ln A and tau of turning points 0 and 2000, at 90 bits, by interpolation in the amplitude."""
    found = {}
    for alphas, epsilons in LAWS:
        law = Law(dict(zip(alphas, epsilons)))
        with ctx.workprec(122):
            damping = Damping.of_law(law)
        with ctx.workprec(90):
            points = list(islice(sequence(Interpolated(damping, Panels(law, 90), 2001), at_rest(arb(1))), 2001))
            found[alphas] = [(arb(p.amplitude, p.amplitude_error).log(), p.tau) for p in (points[0], points[2000])]
    return found


@pytest.mark.parametrize("law", LAWS, ids=str)
def test_a_ladder_of_jumps_lands_where_the_steps_do(law, orbits):
    (x, t), (there, later) = orbits[law[0]]
    for bits, terms in ((20, 2), (40, 2), (70, 3)):
        with ctx.workprec(bits):
            after, time = flow_of(law, terms).advance(arb(x.mid()), 2000)
        with ctx.workprec(90):
            assert after.contains(there.mid()) and time.contains((later - t).mid())
            assert after.rad() < max(2.0 ** (16 - bits), 1e-12) and time.rad() < max(2.0 ** (28 - bits), 1e-9)


@pytest.mark.parametrize("law", LAWS, ids=str)
def test_half_of_the_next_term_or_one_term_less_would_be_wrong(law, orbits):
    (x, t), (there, later) = orbits[law[0]]
    with ctx.workprec(90):
        flow = flow_of(law, 2)
        bounds = flow.defects(x)
        for drive, rise, bound in zip((flow.rates[:1], flow.clock), (arb(2000), later - t), bounds, strict=True):
            defect = abs(flow._integral(drive, x, there) - rise)
            assert bound.following / 2 < defect < bound.total and bound.total / 2 < defect
            shorter = replace(flow, K=1)
            wrong = abs(
                shorter._integral(flow.rates[:1] if drive is not flow.clock else shorter.clock, x, there) - rise
            )
            assert not wrong < bound.total


def test_the_bound_on_the_circle_holds_what_an_independent_integration_finds():
    # d(lambda) at 12 points of the circle, by SciPy in complex doubles from the equations of the half-swing.
    alphas, top = np.array([1.5, 3.0]), [arb("0.02"), arb("0.0002")]
    with ctx.workprec(64):
        flow = flow_of((("3/2", "3"), ("1/50", "1/5000")), 2)
        bound = flow._polydisc(top)
        D, least = float(flow._on_circle(bound)[0]), float(flow._least(bound))
        G, rho = float(bound.growth), np.array([float(r) for r in bound.radii])
    v = [{key: float(c) for key, c in part} for part in flow.rates]

    def sums(delta):
        return [sum(c * delta[0] ** k[0] * delta[1] ** k[1] for k, c in part.items()) for part in v]

    def f(delta):
        v1, v3, v5 = sums(delta)
        return (1 - v3 / v1 - v5 / v1 + (v3 / v1) ** 2) / v1

    def defect(delta):
        def slope(theta, g):
            u, s, c = delta * np.exp((alphas - 1) * g[0]), np.sin(theta), np.cos(theta)
            return [-np.sum(u * s ** (alphas + 1)) / (1 - np.sum(u * s**alphas * c))]

        L = solve_ivp(slope, (0, np.pi), [0j], rtol=1e-10, atol=1e-12).y[0, -1]
        path = lambda share: f(delta * np.exp((alphas - 1) * share * L)) * L  # noqa: E731
        return L, quad(path, 0, 1, complex_func=True)[0] - 1

    found = [defect(rho * np.exp(2j * np.pi * k / 12)) for k in range(12)]
    assert max(abs(d) for _, d in found) < D
    assert max(abs(L) for L, _ in found) < G < 2 * max(abs(L) for L, _ in found)
    turns = [G * r * np.exp(2j * np.pi * k / 24) for r, k in product((0.5, 1), range(24))]
    steepest = max(abs(f(rho * np.exp((alphas - 1) * xi + 2j * np.pi * k / 24))) for xi in turns for k in range(24))
    assert 1 + G * steepest < D < 1 + 2.5 * G * steepest
    nearest = min(
        abs(sums(rho * np.exp((alphas - 1) * xi) * side)[0]) for xi in turns for side in (1, np.array([1, 0]))
    )
    assert least < nearest < 2 * least


def test_the_integrand_is_the_slow_flow_of_first_order_where_that_is_all():
    with ctx.workprec(80):
        flow = flow_of(LAWS[0], 2)
        short = replace(flow, K=1)
        x = arb(-3)
        delta = [d.mid() for d in flow.strengths(x)]
        mpmath.mp.prec = 80
        rate = -sum(
            mpmath.pi
            * mpmath.gamma(a / 2 + 1)
            / mpmath.sqrt(mpmath.pi)
            / mpmath.gamma(a / 2 + 1.5)
            * mpmath.mpf(d.str(25, radius=False))
            for a, d in zip((1.5, 3), delta)
        )
        assert abs(short.integrand(flow.rates[:1], x) * arb(mpmath.nstr(rate, 22)) - 1) < arb(10) ** -18
        assert flow.integrand(flow.rates[:1], acb(x)).real.overlaps(flow.integrand(flow.rates[:1], x))


def test_far_points_from_two_heads_agree(orbits):
    (x, t), (later, time) = orbits[LAWS[0][0]]
    with ctx.workprec(90):
        flow = flow_of(LAWS[0], 3)
        one, other = flow.advance(x, 10**9), flow.advance(later, 10**9 - 2000)
        assert one[0].overlaps(other[0]) and (t + one[1]).overlaps(time + other[1])
        assert other[0].rad() < 1e-24 and other[1].rad() < 1e-12


def test_a_jump_gives_the_points_that_interpolation_gives():
    law, start = Law({"3/2": "1/1000", 3: "1/100000"}), {"x0": "1/2", "v0": "-1"}
    jumped = turning_points(law, 2, 8, start=2001, times=True, route="abel-flow", **start)
    assert "slow flow" in jumped.method
    walked = turning_points(law, 2, 8, start=2001, times=True, route="interpolated", **start)
    assert "slow flow" not in walked.method and jumped.points == walked.points and jumped.first == walked.first


def test_a_moving_start_reaches_far_points_of_one_law():
    # 1/(epsilon A_n^2) = 3 pi n/4 + O(ln n): from there on only the sign of the first turning point is left.
    for v0, side in (("1/1000", 1), ("-1/1000", -1)):
        table = turning_points(Law({3: "1/1000"}), 1, 10, start=10**12 + 1, v0=v0)
        assert table.first is not None
        size = float(table.points[0].x) * float(table.first["amplitude"])
        assert abs(-side * size * (0.001 * 0.75 * np.pi * 1e12) ** 0.5 - 1) < 1e-5


def test_what_is_out_of_reach_is_refused():
    with ctx.workprec(80), pytest.raises(UndecidedError, match=r"not decrease here|too large|no circle"):
        flow_of((("3/2", "3"), ("2", "5")), 2).advance(arb(0), 100)
    assert by_flow.serves(Request.read(Law({"3/2": "1/5", 3: 1}), 1, 1000, start=10**18)) > 1000
    assert planned([parse_real("1.000001", "a"), parse_real("3", "a")], 120, 10**18).seconds > 60


def test_a_newton_method_that_runs_out_says_so(monkeypatch):
    """What was reached is known at the place before: beside the next one it encloses nothing."""
    monkeypatch.setattr("asymptotics.turning.abel_flow._STEPS", 1)
    with ctx.workprec(90), pytest.raises(UndecidedError, match="does not settle"):
        flow_of(LAWS[0], 4).advance(arb(0), 2000)


def test_an_uncertain_start_is_paid_for():
    with ctx.workprec(90):
        flow, wide = flow_of(LAWS[0], 4), arb(-2, "1e-6")
        found, time = flow.advance(wide, 50)
        for end in (wide.lower(), wide.upper()):
            there, then = flow.advance(arb(end), 50)
            assert found.contains(there.mid()) and time.contains(then.mid())


def test_an_uncertain_start_is_as_many_half_swings_as_it_takes(monkeypatch):
    """The blur of the number of half-swings is all of the start's radius times the slope there."""
    with ctx.workprec(90):
        flow, wide, seen = flow_of(LAWS[0], 4), arb(-2, "1e-6"), []
        solve = type(flow)._solve
        monkeypatch.setattr(type(flow), "_solve", lambda self, *given: seen.append(given[1]) or solve(self, *given))
        flow.advance(wide, 50)
        assert seen[0].rad() >= wide.rad() * abs(flow.integrand(flow.rates[:1], arb(-2))) * arb("0.999")


def test_what_the_flow_does_not_cover_is_undecided(monkeypatch):
    with ctx.workprec(90):
        flow = flow_of(LAWS[0], 4)
        with pytest.raises(UndecidedError, match="was not verified"):
            flow.advance(arb(-2), 0)  # the box about the place is not below the start
        monkeypatch.setattr(type(flow), "_following", lambda *_: (arb(0), arb(0)))
        with pytest.raises(UndecidedError, match="too large for the sum"):
            flow.defects(arb(20))
        monkeypatch.setattr(type(flow), "integrand", lambda *_: acb("nan"))
        with pytest.raises(UndecidedError, match="not enclosed"):
            flow._integral(flow.rates[:1], arb(-9), arb(-2))
        monkeypatch.setattr(type(flow), "_least", lambda *_: arb(-1))
        with pytest.raises(UndecidedError, match="no circle"):
            flow._polydisc(flow.strengths(arb(-2)))
