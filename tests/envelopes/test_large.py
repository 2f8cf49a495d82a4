"""The slow flow exact in the spring: quadrature, straightened series, certified turning points, integration."""

import json
from math import pi

import mpmath
import numpy as np
import pytest
from flint import acb, arb, ctx
from scipy.integrate import solve_ivp

import asymptotics as asy
from asymptotics.curves.large import SpringEnvelope
from asymptotics.envelopes.large import SlowFlow, _power, _Rate, _Turn
from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.moments.symbolic import mean
from asymptotics.expansions.straightening.wells import Loss, Well
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.exact import parse_real
from asymptotics.numbers.precision import TooWideError
from asymptotics.shell.main import main
from asymptotics.terms import Term
from tests.second_route.straightened import straighten

WELLS = {  # well, its 2 (V(A) - V(x)) over sin^2, amplitude
    "pendulum": (Well.pendulum(arb(1)), None, "2.7"),
    "hardening": (Well.duffing(arb(2)), 2.0, "1.5"),
    "softening": (Well.duffing(arb("-0.4")), -0.4, "1.2"),
}


def potential(name, x):
    c = WELLS[name][1]
    return 1 - mpmath.cos(x) if c is None else x * x / 2 + mpmath.mpf(c) * x**4 / 4


@pytest.mark.parametrize("name", WELLS)
@pytest.mark.parametrize(("alpha", "m"), [("0", 0), ("1.5", 0), ("2", 0), ("0.5", 2), ("3", 1)])
def test_loss_and_time_are_integrals_over_the_conservative_path(name, alpha, m):
    if name == "pendulum" and m:
        return
    well, _, text = WELLS[name]
    with mpmath.workdps(20):
        A, power = mpmath.mpf(text), mpmath.mpf(alpha)
        c = WELLS[name][1]

        def path(u):  # x, v and dx/du with no singularity at the turning point
            if c is None:
                k = mpmath.sin(A / 2)
                x = 2 * mpmath.asin(k * mpmath.sin(u))
                return x, 2 * k * mpmath.cos(u), 2 * k * mpmath.cos(u) / mpmath.sqrt(1 - (k * mpmath.sin(u)) ** 2)
            x = A * mpmath.sin(u)
            v = A * mpmath.cos(u) * mpmath.sqrt(1 + mpmath.mpf(c) * A * A * (1 + mpmath.sin(u) ** 2) / 2)
            return x, v, A * mpmath.cos(u)

        work = 2 * mpmath.quad(lambda u: path(u)[2] * path(u)[0] ** m * path(u)[1] ** power, [0, pi / 4, mpmath.pi / 2])
        time = 2 * mpmath.quad(lambda u: path(u)[2] / path(u)[1], [0, pi / 4, mpmath.pi / 2])
        r = work / (2 * mpmath.pi * potential(name, A))
    loss = Loss(arb(1), arb(alpha), m)
    s = -well.xi(arb(text)).log()
    assert float(well.loss(loss, s)) == pytest.approx(float(r), rel=1e-11)
    assert float(well.theta(s)) == pytest.approx(float(time / mpmath.pi), rel=1e-11)
    assert well.loss(loss, np.array([float(s)]))[0] == pytest.approx(float(r), rel=1e-11)
    assert well.loss(loss, acb(s)).real.overlaps(well.loss(loss, s))
    assert abs(float(well.loss(Loss(arb(1), arb(alpha) + arb("0.001"), m), s)) / float(r) - 1) > 1e-5


@pytest.mark.parametrize("alpha", [1, 2])
@pytest.mark.parametrize(
    ("spring", "well", "m"),
    [
        (Term(1, 0, 3, "position", "pendulum"), Well.pendulum, 0), (Term(1, 0, 3, "position"), Well.duffing, 0),
        (Term(1, 0, 3, "position"), Well.duffing, 2),
    ],
)  # fmt: skip
def test_the_series_of_the_straightened_loss_are_those_of_2f1(spring, well, m, alpha):
    """U at first order of x'(xi) |x(xi)|^m v|v|^(alpha-1), through g^6: the algebra of series against 2F1."""
    members = straighten(Forces.read([Term(1, alpha, m), spring], 7), 7).members
    strength, xi = arb("0.01"), arb(1)
    total = sum(float(to_sympy(f.ratio) * mean(f.position, alpha + 1)) * 0.01 ** f.key[1] for f in members)
    made = well(strength)
    assert float(made.loss(Loss(arb(1), arb(alpha), m), -xi.log())) == pytest.approx(total, rel=1e-13)


def test_without_loss_the_motion_is_exact():
    for spring, x0 in (("pendulum", "3"), ({3: 2}, "3/2"), ({3: "-1/5"}, "2"), ({3: "1/10"}, "-1")):
        osc = asy.Oscillator({1: 0}, spring=spring, x0=x0, mass=2, stiffness=3)
        found = asy.envelope(osc)
        if isinstance(spring, dict):
            (c,) = (float(parse_real(str(v), "v").ball()) for v in spring.values())
        start = float(osc.x0.ball())

        def field(_, y, pendulum=spring == "pendulum", c=0.0 if spring == "pendulum" else c):
            return [y[1], -1.5 * np.sin(y[0]) if pendulum else -(3 * y[0] + c * y[0] ** 3) / 2]

        run = solve_ivp(field, (0, 20), [start, 0], rtol=1e-12, atol=1e-13, method="DOP853", dense_output=True)
        t = np.linspace(0, 20, 60)
        sampled = found.sample(t)
        assert np.max(np.abs(sampled.x - run.sol(t)[0])) < 1e-8
        assert np.max(np.abs(sampled.v - run.sol(t)[1])) < 1e-8
        assert float(found.amplitude(7, digits=5)) == abs(start)
        assert found.extinction_time() is None


def test_the_period_is_an_arithmetic_geometric_mean():
    with mpmath.workdps(40):
        truth = 2 * mpmath.pi / mpmath.agm(1, mpmath.cos(mpmath.mpf(3) / 2))
        found = mpmath.mpf(asy.envelope(asy.Oscillator({2: 1}, spring="pendulum", x0=3)).period(3, digits=35))
        assert abs(found - truth) < mpmath.mpf(10) ** -33
        A, c = mpmath.mpf("1.5"), 2
        root = mpmath.sqrt(1 + c * A * A)  # int dx/v by the AGM of sqrt(1 + c A^2) and sqrt(1 + c A^2/2)
        truth = 2 * mpmath.pi / mpmath.agm(root, mpmath.sqrt(1 + c * A * A / 2))
        found = mpmath.mpf(asy.envelope(asy.Oscillator({2: 1}, spring={3: 2}, x0="3/2")).period("3/2", digits=35))
        assert abs(found - truth) < mpmath.mpf(10) ** -32


def turning_time(x, n, eps):
    """The time of the n-th turning point by DOP853, which is at x."""

    def turns(_, y):
        return y[1]

    b = float(parse_real(eps, "v").ball())
    run = solve_ivp(lambda t, y: [y[1], -np.sin(y[0]) - b * y[1] * abs(y[1])], (0, 100), [2.5, 0], events=turns,
                    rtol=1e-11, atol=1e-12, method="DOP853")  # fmt: skip
    places = [k for k, y in enumerate(run.y_events[0]) if abs(y[0] - x) < 1e-7]
    assert len(places) == 1
    return run.t_events[0][places[0]]


def test_certified_turning_points_are_reached_to_second_order():
    """Phase n pi and time t_n at certified amplitudes of a pendulum in air from 2.5 rad: relative error O(eps^2)."""
    errors = []
    for eps, n in (("1/20", 6), ("1/40", 12)):
        osc = asy.Oscillator({2: eps}, spring="pendulum", x0="5/2")
        point = asy.turning_points(osc, n + 1, digits=20).points[n]
        flow = SlowFlow(Well.pendulum(arb(1)), (Loss(parse_real(eps, "v").ball(), arb(2)),), arb("2.5"))
        xi = flow.well.xi(abs(arb(str(point.x))))
        errors.append(
            (float(flow.angle(xi)) / (n * pi) - 1, float(flow.time(xi)) / turning_time(float(point.x), n, eps) - 1)
        )
    for coarse, fine in zip(*errors):
        assert abs(fine) < 2e-3
        assert 3.5 < coarse / fine < 4.5


@pytest.mark.parametrize(
    ("law", "spring", "x0"),
    [({2: 1}, "pendulum", "5/2"), ({"3/2": 1}, {3: 2}, "3/2"), ({1: "1/2", (1, 2): 1}, {3: "-1/10"}, "3/2")],
)
def test_the_motion_is_right_to_first_order(law, spring, x0):
    worst = []
    for eps in (0.02, 0.01):
        strengths = {key: parse_real(str(v), "v") * parse_real(str(eps), "v") for key, v in law.items()}
        osc, found = (made := asy.Oscillator(strengths, spring=spring, x0=x0)), asy.envelope(made)
        losses = [(float(t.b.ball()), t.position, float(t.velocity.ball())) for t in osc.law.losses]
        c = None if spring == "pendulum" else float(parse_real(str(spring[3]), "v").ball())

        def field(_, y, losses=losses, c=c):
            pull = np.sin(y[0]) if c is None else y[0] + c * y[0] ** 3
            return [y[1], -pull - sum(b * abs(y[0]) ** m * y[1] * abs(y[1]) ** (a - 1) for b, m, a in losses if y[1])]

        t = np.linspace(0, 0.4 / eps, 80)
        run = solve_ivp(field, (0, t[-1]), [float(osc.x0.ball()), 0], t_eval=t, rtol=1e-10, atol=1e-11, method="DOP853")
        worst.append(np.max(np.abs(found.sample(t).x - run.y[0])))
    assert worst[1] < 0.15
    assert 1.6 < worst[0] / worst[1] < 2.3


def test_enclosures_contain_finer_ones_and_are_narrow():
    flow = lambda: SlowFlow(Well.duffing(arb(2) / 3), (Loss(arb(1) / 10, arb(3) / 2), Loss(arb(1) / 7, arb(1), 2)),  # noqa: E731
                            arb(3) / 2)  # fmt: skip
    with ctx.workprec(110):
        fine = flow().amplitude(arb(9)), flow().phase(arb(9)), flow().time(flow().well.xi(arb(1)))
    with ctx.workprec(64):
        coarse = flow().amplitude(arb(9)), flow().phase(arb(9)), flow().time(flow().well.xi(arb(1)))
    for one, other in zip(fine, coarse):
        assert other.contains(one)
        assert arb(2) ** -62 * abs(one).mid() < other.rad() < arb(10) ** -12
    wide = SlowFlow(Well.pendulum(arb(1)), (Loss(arb("0.1", 1e-6), arb(2)),), arb(2)).amplitude(arb(20))
    for strength in ("0.1000009", "0.0999991"):
        edge = SlowFlow(Well.pendulum(arb(1)), (Loss(arb(strength), arb(2)),), arb(2)).amplitude(arb(20))
        assert wide.contains(edge) and not wide.mid().overlaps(edge)


def test_the_rates_in_balls_are_those_of_the_table():
    flow = SlowFlow(Well.duffing(arb(2)), (Loss(arb("0.1"), arb("1.5")), Loss(arb("0.2"), arb(1), 2)), arb("1.5"))
    for rate in (_Rate(flow), _Turn(flow)):
        for s in (-0.5, 0.0, 2.0):
            assert float(rate(arb(s))) == pytest.approx(rate.array(np.array([s]))[0], rel=1e-11)
    assert _Turn(flow)(arb(60)).contains(0) and _Turn(flow)(arb(0)) > 0.1  # hardening: faster than the linear spring


def test_the_extinction_of_the_averaged_amplitude():
    osc = asy.Oscillator({0: "1/10", 1: "1/20"}, spring="pendulum", x0=2)
    found = asy.envelope(osc)
    end = found.extinction_time(digits=12)
    flow = SlowFlow(Well.pendulum(arb(1)), (Loss(arb("0.1"), arb(0)), Loss(arb("0.05"), arb(1))), arb(2))
    near = flow.time(arb("0.000001"))
    assert 0 < float(end) - float(near) < 2e-5
    later, before = str(float(end) + 1e-6), str(float(end) - 1e-2)
    assert found.amplitude(later, digits=5) == "0" and float(found.amplitude(before, digits=5)) > 0
    sampled = found.sample([float(end) - 1, float(end) + 1, float("nan")])
    assert sampled.extinct == sampled.missing == 1 and sampled.x[1] == 0
    with pytest.raises(InputError, match="no phase"):
        found.phase(later)


@pytest.mark.parametrize("order", [1, -1])
def test_the_end_is_ruled_by_the_least_exponent_that_no_double_tells(order):
    """At 1e-12 rad a pendulum is linear to 25 digits: A' = -sum b_i M(alpha_i + 1) A^alpha_i, integrated to 40."""
    near = ("1000000000000000003/3000000000000000000", "1/3")[::order]
    osc = asy.Oscillator(dict.fromkeys(near, "1/10"), x0="1e-12", spring="pendulum")
    with mpmath.workdps(40):
        exact = [mpmath.mpf(1) / 3, mpmath.mpf(1) / 3 + mpmath.mpf(10) ** -18]
        means = [mpmath.gamma(a / 2 + 1) / mpmath.sqrt(mpmath.pi) / mpmath.gamma((a + 3) / 2) for a in exact]
        speed = lambda A: sum(M * A**a for M, a in zip(means, exact, strict=True)) / 10  # noqa: E731
        end = mpmath.quad(lambda u: 3 * u**2 / speed(u**3), [0, mpmath.mpf(10) ** -4])
        found = asy.envelope(osc).extinction_time(digits=22)
        assert abs(mpmath.mpf(found) / end - 1) < mpmath.mpf(10) ** -21


def test_an_end_that_no_double_sees():
    """1 - 10^-20 is below 1: the amplitude ends, after 2 10^21, beside both springs and by the same law."""
    law = {"0.99999999999999999999": "1/10"}
    ends = [asy.envelope(asy.Oscillator(law, x0="1/2", spring=s)).extinction_time(digits=5) for s in ("pendulum", None)]
    assert ends == ["2.0000e21", "2.0000e21"]


def test_weights_that_are_not_told_apart_are_refused():
    near = Loss(arb("0.1"), arb(1) / 3), Loss(arb("0.1"), arb(1) / 3 + arb(10) ** -30)
    flow = SlowFlow(Well.pendulum(arb(1)), near, arb(1))
    with pytest.raises(TooWideError, match="not told apart"):
        flow.extinction_time()
    with pytest.raises(TooWideError, match="certainly positive"):
        _power(arb(0).union(arb(1)), arb(1), arb(0, 1e-9))


def test_small_amplitudes_are_those_of_the_linear_spring():
    small = asy.envelope(asy.Oscillator({2: "1/10"}, spring={3: "1/10000000000"}))
    linear = asy.envelope(asy.Oscillator({2: "1/10"}))
    assert small.amplitude(30, digits=8) == linear.amplitude(30, digits=8)
    assert small.kappas() == linear.kappas()


@pytest.mark.parametrize(
    ("law", "spring", "rest", "argument"),
    [
        ({2: 1}, {2: 1}, {}, "spring"), ({2: 1}, {3: 1, 5: 1}, {}, "spring"), ({2: 1}, {(3, 2): 1}, {}, "spring"),
        ({(1, 1): 1}, "pendulum", {}, "law"), ({2: 1}, "pendulum", {"v0": 1}, "v0"),
        ({2: -1}, "pendulum", {}, "strength"), ({2: 1}, "pendulum", {"x0": "22/7"}, "x0"),
        ({2: 1}, {3: -1}, {}, "x0"), ({2: 1}, {3: "-1/4"}, {"x0": 2}, "x0"),
    ],
)  # fmt: skip
def test_what_is_not_known_is_refused_by_name(law, spring, rest, argument):
    with pytest.raises(InputError, match=f"argument {argument}"):
        asy.envelope(asy.Oscillator(law, spring=spring, **rest))


def test_questions_out_of_range():
    found = asy.envelope(asy.Oscillator({2: 1}, spring="pendulum"))
    for bad in (lambda: found.amplitude(-1), lambda: found.time(2), lambda: found.time(0), lambda: found.period(4),
                lambda: found.sample([-1.0]), lambda: found.amplitude(1, digits=0)):  # fmt: skip
        with pytest.raises(InputError):
            bad()
    assert found.time(1) == "0"
    with pytest.raises(InputError, match="averaging"):
        asy.envelope(found.oscillator, averaging="squaring")
    assert isinstance(found, SpringEnvelope) and "2F1" in str(found._repr_latex_()).replace("{}_", "").replace("_", "")


def test_the_command(capsys, tmp_path):
    line = "envelope --law 2:1/20 --spring pendulum --x0 5/2 --time 40 --digits 10 --json"
    assert main(line.split()) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["amplitude"] == "0.7846242302" and data["period"] == "10.32316287" and data["certified"] is True
    path = tmp_path / "a.csv"
    assert main([*line.split()[:-1], "--csv", str(path), "--plot", str(tmp_path / "a.svg"), "--points", "10"]) == 0
    request = "envelope --law=2:1/20 --spring=pendulum --x0=5/2 --time=40 --points=10"
    assert path.read_text().splitlines()[0].startswith(f"tau,amplitude,phase,code [{request} --double-error=")
    assert len(path.read_text().splitlines()) == 12
    assert "exact in the spring" in capsys.readouterr().out
    assert main(["envelope", "--law", "2:1", "--spring", "2:1", "--time", "1"]) == 2
    assert "--spring" in capsys.readouterr().err


def test_wide_starts_and_ends_hold_their_neighbours():
    """Both ends of the integral in the mean-value form, and the inversion at a wide time."""
    with ctx.workprec(70):
        well, e = Well.pendulum(arb(1)), arb(2) ** -8
        losses = (Loss(arb("0.1"), arb(2)), Loss(arb("0.05"), arb(0)))
        here, before = SlowFlow(well, losses, arb(2)), SlowFlow(well, losses, arb(2, e))
        xi = well.xi(arb(1)).mid()
        for side in (e, -e):
            assert here.time(arb(xi, e)).contains(here.time(xi + side * arb("0.999")).mid())
            assert before.time(xi).contains(SlowFlow(well, losses, 2 + side * arb("0.999")).time(xi).mid())
            assert here.amplitude(arb(3, e)).contains(here.amplitude(3 + side).mid())


def test_what_is_left_after_the_integral_of_a_slow_extinction_counts():
    """Weight -1/10: the amplitude at which the integral ends is small, the time that is left is not."""
    flow = SlowFlow(Well.pendulum(arb(1)), (Loss(arb("0.1"), arb("0.9")),), arb(1))
    with ctx.workprec(120):
        fine = flow.extinction_time()
    with ctx.workprec(40):
        rough = flow.extinction_time()
    assert rough.contains(fine.mid()) and rough.rad() < arb("1e-6") * fine


def test_an_interval_that_the_speed_leaves_is_widened_or_not_claimed():
    with ctx.workprec(60):
        flow = SlowFlow(Well.pendulum(arb(1)), (Loss(arb("0.1"), arb(0)),), arb(1))
        end = flow.extinction_time().mid()
        for share in ("0.3", "0.45", "0.47", "0.49"):
            found = flow._inverse(arb(end / 2, end * arb(share)))
            late = flow._inverse((end * (arb("0.499") + arb(share))).mid())
            assert found is None or found.contains(late.mid())
