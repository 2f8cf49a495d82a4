"""What a jump adds to its radius, part by part: a second evaluation of each bound, and inputs that need all of it."""

from dataclasses import replace
from types import SimpleNamespace

import mpmath
import numpy as np
import pytest
from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.finite_majorant import majorant
from asymptotics.flow.turning import TurningState
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_real
from asymptotics.turning import energy_primitive, jump, table
from asymptotics.turning import half_swing as half_swings
from asymptotics.turning.abel import AbelFunction, Approximant, abel_function
from asymptotics.turning.abel_flow import AbelFlow, DefectBound, abel_flow


def real(text):
    return parse_real(text, "alpha")


def test_the_defects_are_the_following_terms_and_cauchys_beyond():
    """sum_i c_i S_(m+i) + D/(1 - x) S_M/r^M with S_m = (1/delta - g/2)^(1-m)/((m-1) g), in doubles."""
    f = Approximant((arb(1), arb("0.1")), (arb("0.3"), arb(0), arb("0.2")), arb(5))
    made = AbelFunction(f, f, arb("0.5"), arb("0.7"))
    delta, g = 0.125, 0.7

    def S(m):
        return (1 / delta - g / 2) ** (1 - m) / ((m - 1) * g)

    known, beyond = 0.3 * S(4) + 0.2 * S(6), 5 / (1 - delta / 0.5) * S(7) / 0.5**7
    assert float(made.defects(f, arb(delta)).rad()) == pytest.approx(known + beyond, rel=1e-8, abs=0)
    assert 0.2 * known < beyond < 5 * known  # both parts count


@pytest.mark.parametrize(("alpha", "terms"), [("2", 2), ("3/2", 3)])
def test_the_circle_of_a_defect(alpha, terms):
    """|c_0| (1/|F| + 1/rho) + sum |c_k| (|F|^(2k-1) + rho^(2k-1)) and the drive; for alpha = 2 against F itself."""
    with ctx.workprec(100):
        made = abel_function(real(alpha), terms)
        bound = majorant([real(alpha).ball()], [made.rho], whole=True)
    rho, high, low = float(made.rho), float(bound.final(0)), float(bound.inverse())
    for f, drive in ((made.psi, 1), (made.theta, np.pi + float(bound.excess))):
        c = [abs(float(x)) for x in f.coefficients]
        again = c[0] * (low + 1 / rho) + sum(
            b * (high ** (2 * k - 1) + rho ** (2 * k - 1)) for k, b in enumerate(c) if k
        )
        assert float(f.D) == pytest.approx(again + drive, rel=1e-9, abs=0)
    if alpha == "2":
        points = [rho * mpmath.expj(t) for t in mpmath.linspace(0, mpmath.pi, 9)]
        there, here = (max(abs(value(made.psi, z)) for z in zs) for zs in (map(image, points), points))
        assert there + here + 1 < float(made.psi.D) < 1.5 * (there + here + 1)


def image(delta):
    """F(delta) of quadratic damping for complex delta, from p - ln(1+p) = -q - ln(1-q), followed from small ones."""

    def equation(d, L):
        p, q = 2 * d, 2 * d * mpmath.exp(L)
        return mpmath.log(1 + p) - p - mpmath.log(1 - q) - q

    L = mpmath.mpc(0)
    for share in mpmath.linspace(0.05, 1, 20):
        d = share * delta
        start = L if L else -4 * d / 3
        L = mpmath.findroot(lambda x, d=d: equation(d, x), start)
    return delta * mpmath.exp(L)


def value(f, delta):
    return sum(float(c) * delta ** (2 * k - 1) for k, c in enumerate(f.coefficients))


def test_a_wide_value_is_solved_at_both_of_its_ends():
    """The slope is that of the whole interval, not that of its middle."""
    with ctx.workprec(80):
        made = abel_function(real("3"), 4)
        start = arb("0.02").mid()
        value, width = made.psi(start) + 50, arb(2) ** -4
        wide = made._solve(value + arb(0, width), start)
        for end in (value - width, value + width):
            assert wide.contains(made._solve(end, start))
        slope = abs(width / made.psi.slope(wide.mid()))
        assert wide.rad() < slope * arb("1.01")
        with pytest.raises(UndecidedError, match="not verified"):
            made._solve(value + arb(0, 5), start)


def test_a_function_that_may_rise_is_not_solved():
    """c_0 = 1, c_1 = 4: 1/delta + 4 delta falls up to delta = 1/2 and no farther."""
    f = Approximant((arb(1), arb(4)), (), arb(1))
    made = AbelFunction(f, f, arb(1), arb("0.5"))
    assert f.falls_up_to(arb("0.499")) and not f.falls_up_to(arb("0.501"))
    with ctx.workprec(60):
        assert made._solve(f(arb("0.25")), arb("0.25")).contains(arb("0.25"))
        with pytest.raises(UndecidedError, match="may not decrease"):
            made._solve(f(arb("0.25")), arb("0.75"))


LAWS = ("3/2", "3")


def flow(delta, ratio, kept=2):
    return abel_flow([real(a) for a in LAWS], [arb(delta), arb(delta) * arb(ratio)], kept)


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
        made = abel_flow([real(a) for a in LAWS], [arb("0.1"), arb("0.1")], 2)
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


def test_points_and_turning_points_keep_their_radii():
    here = TurningState(7, -1, arb("0.5"), arb(9), arb(2) ** -10, arb(2) ** -8)
    log = jump._log(here)
    assert all(log.contains((here.amplitude + side * here.amplitude_error).log().mid()) for side in (-1, 1))
    there = jump._arrived(here, 10, arb(-1, arb(2) ** -10), arb(9, arb(2) ** -8))
    assert (there.n, there.side) == (10, 1) and jump._arrived(here, 11, arb(0), arb(0)).side == -1
    assert all(there.x.contains((arb(-1) + side * arb(2) ** -10).exp().mid()) for side in (-1, 1))
    assert there.time_error >= arb(2) ** -8
    size = table.size(here)
    assert all(size.contains(here.amplitude + side * here.amplitude_error) for side in (-1, 1))


def test_a_guess_that_is_off_is_refused(monkeypatch):
    """Without the two signs beside it any number would be a turning point."""
    with ctx.workprec(160):
        well = energy_primitive.PrimitiveWell.of(Law({0: "1/20", 2: "1/7"}, spring={3: "1/3"}))
        right = energy_primitive._next(well, arb(1), 80)
        assert right is not None and right.rad() < abs(right) * arb(2) ** -50
        for off in (-1, 1):
            monkeypatch.setattr(energy_primitive, "_guess", lambda *_, off=off: right.mid() * (1 + off * arb(2) ** -40))
            assert energy_primitive._next(well, arb(1), 80) is None


def test_the_image_of_a_ball_is_the_hull_of_both_ends():
    with ctx.workprec(160):
        well = energy_primitive.PrimitiveWell.of(Law({2: "1/7"}, spring={3: "1/3"}))
        wide, *ends = (
            list(swing(well, x)) for x in (arb(1, arb(2) ** -20), arb(1) - arb(2) ** -20, arb(1) + arb(2) ** -20)
        )
        assert all(wide[1].contains(end[1]) for end in ends)


def swing(well, x):
    points = energy_primitive.swings(well, x, 80)
    return [next(points)[0], next(points)[0]]


def test_a_half_swing_of_any_terms_keeps_its_radii(monkeypatch):
    e = arb(2) ** -20
    there = TurningState(1, -1, arb("0.5"), arb(3), e, e)
    monkeypatch.setattr(half_swings, "turning_by_pieces", lambda *_: (there, 7))
    found = half_swings.half_swing_of_terms(Law({"3/2": 1}, spring="pendulum").terms, reals("1/10", "4"), 4).to_dict()
    for name, middle in (("amplitude", 0.5), ("duration", 3.0)):
        low, high = map(float, found[name]["enclosure"])
        assert low <= middle - 2.0**-20 and middle + 2.0**-20 <= high < middle + 2.0**-19


def reals(*texts):
    return [real(text) for text in texts]


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
