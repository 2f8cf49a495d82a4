"""A sum's jump lands where the steps do; its bound is nearly attained, so that half of it would be wrong."""

from dataclasses import replace
from itertools import islice, product
from types import SimpleNamespace

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
from asymptotics.turning.abel_flow import AbelFlow, DefectBound, abel_flow
from asymptotics.turning.choose import turning_points
from asymptotics.turning.jump import planned
from asymptotics.turning.routes import abel_flow as by_flow
from asymptotics.turning.table import PointsRequest

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
            points = list(islice(sequence(Interpolated(damping, Panels.alone(law, 90), 2001), at_rest(arb(1))), 2001))
            found[alphas] = [(arb(p.amplitude, p.amplitude_error).log(), p.tau) for p in (points[0], points[2000])]
    return found


def real(text):
    return parse_real(text, "alpha")


EXPONENTS = ("3/2", "3")


def flow(delta, ratio, kept=2):
    return abel_flow([real(a) for a in EXPONENTS], [arb(delta), arb(delta) * arb(ratio)], kept)


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
    assert by_flow.serves(PointsRequest.read(Law({"3/2": "1/5", 3: 1}), 1, 1000, start=10**18)) > 1000
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


def test_the_defects_of_a_flow_are_in_its_radii(monkeypatch):
    """Psi off by a thousandth either way, Theta by a half: both are enclosed, and little more."""
    with ctx.workprec(80):
        made, start = flow("0.01", "0.1"), arb(-1)
        psi, theta = arb(1) / 1000, arb(1) / 2
        exact, time = made.advance(start, 100)
        monkeypatch.setattr(AbelFlow, "defects", lambda *_: (DefectBound(psi, arb(0)), DefectBound(theta, arb(0))))
        wide, long = made.advance(start, 100)
        ends = [made._solve(start, 100 + side * psi, start) for side in (-1, 1)]
        assert all(wide.contains(end) for end in ends)
        assert (
            abs(ends[1] - ends[0]) * arb("0.98") < wide.rad()
        )  # f is at least half of 1/v_1, and nearly all of it here
        assert wide.rad() < 3 * abs(ends[1] - ends[0])
        moved = abs(made._integral(made.clock, ends[0].mid(), ends[1].mid()))
        assert long.rad() >= theta + moved / 2 and long.rad() < theta + 3 * moved
        assert wide.contains(exact.mid()) and long.contains(time.mid())


def test_the_radius_of_the_start_is_carried():
    with ctx.workprec(80):
        made, start, width = flow("0.01", "0.1"), arb(-1), arb(2) ** -20
        wide, time = made.advance(arb(start, width), 100)
        for side in (-1, 1):
            x, t = made.advance(start + side * width, 100)
            assert wide.contains(x) and time.contains(t)
        assert wide.rad() < 4 * width


def test_the_bound_of_a_flow_is_the_next_term_and_the_circle():
    """D S_m/rho^m and the integral of the following term, in doubles; D of both functions."""
    with ctx.workprec(64):
        made, x = flow("0.02", "0.05"), arb(0)
        psi, theta = made.defects(x)
        top = [float(d) for d in made.strengths(x)]
        bound = made._polydisc([arb(d) for d in top])
        D, least, G = made._on_circle(bound), float(made._least(bound)), float(bound.growth)
        rho, gain, m = float(bound.radii[0]), float(made._gain()), 2 * (made.K + 1)
        wide = [float(r) * np.exp(float(w) * G) for r, w in zip(bound.radii, made.weights)]
    along = (1 / top[0] - gain / 2) ** (1 - m) / ((m - 1) * gain) / rho**m
    assert float(psi.beyond) == pytest.approx(float(D[0]) * along, rel=1e-6, abs=0)
    assert float(theta.beyond) == pytest.approx(float(D[1]) * along, rel=1e-6, abs=0)
    v, clock = ([sum(abs(float(c)) * wide[0] ** k[0] * wide[1] ** k[1] for k, c in part) for part in parts]
                for parts in (made.rates, made.clock))  # fmt: skip
    a = [v[k] / least for k in (1, 2)]
    g = [1, a[0], a[1] + a[0] ** 2]
    h = sum(clock[i] * g[k - i] for k in range(3) for i in range(k + 1))
    assert float(D[0]) == pytest.approx(1 + G * sum(g) / least, rel=1e-6, abs=0)
    assert float(D[1]) == pytest.approx(np.pi + float(bound.excess) + G * h / least, rel=1e-6, abs=0)


@pytest.mark.parametrize("ratio", ["0", "0.5", "2"])
def test_the_following_term_is_bounded_on_the_whole_orbit(ratio):
    """On the way down delta_2/delta_1 falls from its first value to 0: the integral of the term's size, in doubles."""
    with ctx.workprec(64):
        made = flow("0.02", ratio)
        psi, _ = made._following([arb(d.upper()) for d in made.strengths(arb(0))])
    v = [{key: float(c) for key, c in part} for part in made.rates]
    w, e = [float(x) for x in made.weights], [0.02, 0.02 * float(ratio)]

    def size(x):
        d = [s * mpmath.exp(k * x) for s, k in zip(e, w)]
        v1, v3, v5 = (sum(c * d[0] ** k[0] * d[1] ** k[1] for k, c in part.items()) for part in v)
        return abs(((v3 / v1) ** 2 - v5 / v1) / v1)

    truth = float(mpmath.quad(size, mpmath.linspace(-12, 0, 13)))
    assert truth < float(psi) < (1.001 if ratio == "0" else 40) * truth


def test_what_is_taken_off_the_real_part_on_the_circle():
    """Arguments up to w_i G: the first term's least real part, less the others where theirs may be negative."""
    made = flow("0.01", "0.1")
    bound = SimpleNamespace(growth=arb("1.2"), radii=[arb("0.3"), arb("0.001")])
    c = [float(x) for x in made._first()]
    first, other = 0.5 * 1.2, 2 * 1.2
    again = c[0] * 0.3 * np.exp(-first) * np.cos(first) - c[1] * 0.001 * np.exp(other)
    assert float(made._least(bound)) == pytest.approx(again, rel=1e-9, abs=0)
    assert c[1] * 0.001 * np.exp(other) > 0.02 * again
    slow = SimpleNamespace(growth=arb("0.7"), radii=bound.radii)
    first = 0.5 * 0.7
    assert float(made._least(slow)) == pytest.approx(c[0] * 0.3 * np.exp(-first) * np.cos(first), rel=1e-9, abs=0)


def test_a_wide_psi_is_solved_at_both_of_its_ends_or_not_at_all():
    """Where the terms beyond the first take a part off, the step is larger than v_1 times the change of Psi."""
    with ctx.workprec(80):
        made = abel_flow([real(a) for a in EXPONENTS], [arb("0.1"), arb("0.1")], 2)
        start, width = arb(0), arb(2) ** -12
        wide = made._solve(start, arb(1) + arb(0, width), start)
        ends = [made._solve(start, 1 + side * width, start) for side in (-1, 1)]
        assert all(wide.contains(end) for end in ends)
        assert wide.rad() / 2 < abs(ends[1] - ends[0]) / 2 * arb("1.2")
        with pytest.raises(UndecidedError, match="not verified"):
            made._solve(start, arb(1) + arb(0, 1), start)
        with pytest.raises(UndecidedError, match="not verified"):
            made._solve(start, arb(1), start - 1)


def test_the_amplitude_equation_falls_up_to_half_of_its_first_term():
    """sum |g_k| delta^(2k) < 1/2 at every point of the orbit: the edge, found by bisection, in doubles."""
    made = flow("1", "0")
    c = {k: float(dict(part)[(2 * k + 1, 0)]) for k, part in enumerate(made.rates)}
    edge = (0.5 * abs(c[0] / c[1])) ** 0.5
    with ctx.workprec(64):
        assert made._following([arb(edge * 0.999), arb(0)])
        with pytest.raises(UndecidedError, match="may not decrease"):
            made._following([arb(edge * 1.001), arb(0)])


def test_a_following_term_that_vanishes_at_the_start_counts_later():
    """delta_1^5 - delta_1^4 delta_2 is 0 where both strengths are equal, and not on the way down."""
    made = flow("0.02", "1")
    v1, _, _ = made.rates
    made = replace(made, rates=(v1, (((3, 0), arb(0)),), (((4, 1), arb(-1)), ((5, 0), arb(1)))))
    with ctx.workprec(64):
        psi, _ = made._following([arb(d.upper()) for d in made.strengths(arb(0))])
    c = {key: float(x) for key, x in v1}

    def size(x):
        d, e = 0.02 * mpmath.exp(x / 2), 0.02 * mpmath.exp(2 * x)
        return abs((d**5 - d**4 * e) / (c[(1, 0)] * d + c[(0, 1)] * e) ** 2)

    truth = float(mpmath.quad(size, mpmath.linspace(-12, 0, 13)))
    assert 0 < truth < float(psi) < 10 * truth
