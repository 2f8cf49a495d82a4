"""A creep that settles beside N: against Taylor steps at many bits, an integrator, and with the region made smaller."""

from fractions import Fraction
from math import exp, log, log1p

import pytest
from flint import arb, ctx
from scipy.integrate import quad, solve_ivp

from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.linear_spring import Creep, LinearSpring, ToSlowCurve
from asymptotics.flow.slow_manifold.attraction import ForceCurve, _at, _wait, attracted, spread
from asymptotics.flow.slow_manifold.slow_curve import solve
from asymptotics.flow.trajectory import half_swing_pieces
from asymptotics.law import Oscillator
from asymptotics.motions.reference import reference_motion
from asymptotics.numbers.exact import ExactReal
from tests.flow.forces import by_strength


def damping(*terms):
    return Damping.of([(ExactReal(Fraction(e)).ball(), ExactReal(Fraction(a))) for a, e in terms])


PAIR = (("1/40", "3/10"), ("1/39", "1/10"))
LAWS = [(("1/40", "1/2"),), PAIR, (("1/40", "1/2"), ("3/2", "1"))]


@pytest.mark.parametrize("terms", LAWS, ids=str)
def test_a_ladder_of_precisions(terms):
    def after(bits, place, time):
        with ctx.workprec(bits + 32):
            law = damping(*terms)
        with ctx.workprec(bits):
            found = attracted(law, place, arb(0), arb(2) ** (2 - bits))
            return found.strip.state(time), found.wait

    place, time = arb("0.1").mid(), arb(10) ** 9
    for bits in (36, 48, 60):
        (y, w), wait = after(bits, place, time)
        (finer_y, finer_w), _ = after(2 * bits, place, time)
        with ctx.workprec(2 * bits):
            assert y.contains(finer_y) and w.contains(finer_w)
            assert y.rad() < arb(2) ** (12 - bits) and w.rad() < arb(2) ** (22 - bits) * w and wait < 1e-3


@pytest.mark.parametrize("terms", LAWS, ids=str)
@pytest.mark.parametrize("speed", ["0", "1e-12"])
def test_taylor_steps_pass_through_the_attraction_into_the_strip(terms, speed, monkeypatch):
    """In a time so short that y does not move: the strip holds the speed that is reached."""
    place = arb("0.1").mid()
    with ctx.workprec(100):
        law, w = damping(*terms), arb(speed).mid()
    with ctx.workprec(40):
        found = attracted(law, place, w, arb(2) ** -50)
        there = found.strip.state(arb(0))
    monkeypatch.setattr(LinearSpring, "along_slow_curve", lambda *_: iter(()))
    with ctx.workprec(120):
        law, inside = damping(*terms), 0
        for step in half_swing_pieces(LinearSpring(law), place, w):
            true = step.own(step.begin)
            assert found.y.contains(true[0]) and found.w.contains(true[1]) and step.begin < found.wait
            inside = inside + 1 if there[1].contains(true[1]) else 0
            if inside == 3:
                break
        assert there[0].contains(true[0]) and there[1].rel_accuracy_bits() > 25


@pytest.mark.parametrize("terms", [LAWS[0], PAIR], ids=str)
def test_the_wait_is_as_long_as_it_takes_or_longer(terms):
    """From the largest speed, in ln w.  A wait so short costs nothing: it may be 10^4 times as long."""
    with ctx.workprec(53):
        law, place = damping(*terms), 0.1
        found = attracted(law, arb(place), arb("1e-13"), arb(2) ** -50)
        curve = ForceCurve(law, 2, law.exponents[0])

        def outside(_, state):
            y, u = state
            force, n, _ = (float(s.mid()) for s in curve.sums(arb(u)))
            return (force - y) - 2 * exp(2 * u) / n

        def slope(_, state):
            return [-exp(state[1]), (state[0] - float(law.resistance(arb(state[1]).exp()).mid())) / exp(state[1])]

        outside.terminal, outside.direction = True, -1
        top = float(found.w.upper().log())
        end = solve_ivp(slope, (0, 1), [place, top], "Radau", events=outside, rtol=1e-7, atol=1e-12, first_step=1e-18)
        assert len(end.t_events[0]) and float(found.wait) / 1e4 < end.t_events[0][0] < float(found.wait)


@pytest.mark.parametrize("slow", [-10.0, -7.0, -5.0])
def test_the_wait_is_the_sum_of_its_two_times(slow):
    """8 W/n(m) + (8/3) (W/n(W)) |ln 16 sigma(m)|, and m_1/n(m_1) + (W/n(W)) ln(1 + n(W) y/(W m_1)), m_1 = m/e."""
    law, most, y = damping(("1/4", "1/2"), ("3/4", "1/3")), -3.0, 0.1

    def n(u):
        return exp(u / 4) / 8 + exp(3 * u / 4) / 4

    m, W, m_1 = exp(slow), exp(most), exp(slow - 1)
    parts = [
        8 * W / n(slow), 8 / 3 * W / n(most) * abs(log(16 * (m / n(slow)) ** 2)),
        m_1 / n(slow - 1), W / n(most) * log1p(n(most) * y / (W * m_1)),
    ]  # fmt: skip
    found = float(_wait(ForceCurve(law, 0, law.exponents[0]), arb(slow), arb(most), arb(y)))
    assert found == pytest.approx(sum(parts), rel=1e-9) and min(parts) > 1e-6 * sum(parts)


def test_the_region_is_left_if_it_is_narrower_or_sigma_larger():
    """(d(y - Y)/d tau)/w on y = N - h w^2/n is h - 1 - h^2 (2 - rho) sigma."""
    law = damping(("1/2", "1"))

    def crossing(h, log_w):
        curve = ForceCurve(law, h, law.exponents[0])
        y, slope = curve.place(arb(log_w))
        w = arb(log_w).exp()
        return float(-1 - slope / w * (y - law.resistance(w)) / w)

    small, large = log(1e-6), log(0.2)  # sigma = 4 w: 4e-6 and 0.8
    assert crossing(2, small) > 0 > crossing(1, small) and crossing(0, small) < 0
    assert crossing(2, large) < 0
    for h, log_w in ((2, small), (1, large), (0, large)):
        sigma = 4 * exp(log_w)
        assert crossing(h, log_w) == pytest.approx(h - 1 - h * h * 1.5 * sigma, rel=1e-9)


@pytest.mark.parametrize("log_w", ["-9", "-6", "-4.5"])
def test_the_curves_are_as_far_apart_as_sigma_says(log_w):
    """sigma = 4 w up to 0.044; two thirds of the spread would not do."""
    law, least = damping(("1/2", "1")), arb("0.5")
    above, below = (ForceCurve(law, h, least) for h in (0, 2))
    fast = arb(log_w)
    slow = solve(above.place, below.place(fast)[0], fast)
    sigma, apart = 4 * fast.exp(), fast - slow
    assert apart < spread(sigma) and apart > spread(sigma) * 2 / 3


def test_the_time_on_the_curves_is_the_integral_of_their_slope():
    law = damping(*PAIR)
    for h in (0, 2):
        curve = ForceCurve(law, h, law.exponents[0])
        low, high = arb("-16"), arb("-15.9")
        passed = curve.clock(high)[0] - curve.clock(low)[0]
        steps = [low + (high - low) * (k + arb(1) / 2) / 400 for k in range(400)]
        summed = sum((curve.place(u)[1] / u.exp() for u in steps), arb(0)) * (high - low) / 400
        assert abs(float(passed.mid() - summed.mid())) < 1e-5 * float(summed.mid()) and passed.rad() < 1e-6 * passed
        assert float(curve.clock(low)[1]) == pytest.approx(float((curve.place(low)[1] / low.exp()).mid()))


def test_the_antiderivative_beside_two_exponents_lies_between_its_bounds():
    law, log_w = damping(("1/4", "1"), ("3/4", "1")), -3.0
    n = lambda u: exp(u / 4) / 4 + 3 * exp(3 * u / 4) / 4  # noqa: E731
    true = quad(lambda u: exp(u) / n(u), -80, log_w, epsabs=1e-14)[0]
    both, at = (ForceCurve(law, h, law.exponents[0]) for h in (0, 2)), arb(log_w)
    plain, lacking = (curve.clock(at)[0] for curve in both)
    held = (plain - lacking) / 2 - exp(log_w) / n(log_w)
    assert held.contains(arb(true)) and 0.1 < float((held.mid() - true) / held.rad()) + 1 < 1.9


@pytest.mark.parametrize("side", [-1, 1])
def test_a_state_at_the_edge_of_its_error_is_held(side):
    place, error, time = arb("0.1").mid(), arb(2) ** -40, arb(10) ** 6
    with ctx.workprec(100):
        law = damping(*PAIR)
    with ctx.workprec(60):
        found = attracted(law, place, arb(0), error)
        wide = found.strip.state(time)
        true = attracted(law, (place + side * error * arb("0.999")).mid(), arb(0), arb(0)).strip.state(time)
        assert (found.strip.above.h, found.strip.below.h) == (0, 2)
        assert all(map(arb.contains, wide, true)) and found.y.contains(true[0])


def test_a_speed_at_which_y_moves_while_it_settles_has_to_fall_first():
    law = damping(("1/1000", "1/2"))
    with ctx.workprec(60):
        fast = arb(2) ** -30 * arb("4.5e-4")  # sigma is just below 2^-60
        assert attracted(law, arb("0.1"), fast.mid(), arb(0)) is None
        assert attracted(law, arb("0.1"), (fast / 20).mid(), arb(0)) is not None


def test_nothing_is_promised_where_the_speed_may_grow_or_is_not_small():
    law = damping(("1/2", "1"))
    with ctx.workprec(60):
        assert attracted(law, arb("0.1"), arb(0), arb(2) ** -60) is None  # sigma = 4 w = 0.04 at the slow speed
        assert attracted(law, arb("1e-20"), arb(0), arb("1e-20")) is None
        assert attracted(damping(("1", "3")), arb("0.1"), arb(0), arb(0)) is None


@pytest.mark.parametrize(
    ("law", "x"),
    [({"1/1000": "3/10"}, "-0.1980456649"), ({"1/100000": "3/10"}, "-0.1999803632")],
    ids=str,
)
def test_reference_motion_at_any_time_for_exponents_near_0(law, x):
    for time in (20, 10**18):
        ten, more = (reference_motion(Oscillator(law), time, digits) for digits in (10, 14))
        assert ten.certified and ten.x == x and more.x.startswith(x[:-1])
        assert abs(Fraction(ten.v) - Fraction(more.v)) < abs(Fraction(more.v)) / 10**9


def test_a_creep_begins_at_rest_without_a_step():
    with ctx.workprec(60):
        pieces = half_swing_pieces(LinearSpring(damping(*PAIR)), arb("0.1").mid(), arb(0))
        assert [type(next(pieces)) for _ in range(2)] == [ToSlowCurve, Creep]


def test_each_part_of_the_wait_counts():
    """The time above the curves, 8 W/n(m) and more with sigma, and that of the fall below them."""
    with ctx.workprec(80):
        curve = ForceCurve(damping(*LAWS[0]), 0, damping(*LAWS[0]).exponents[0])
        slow, most, y = arb(-9), arb(-6), arb("0.1")
        (m, _, n_m, _, _), (W, _, n, _, _) = _at(curve, slow - 1), _at(curve, most)
        _, _, n_slow, _, sigma = _at(curve, slow)
        parts = 8 * W / n_slow, arb(8) / 3 * W / n * abs((16 * sigma).log())
        fall = m / n_m + W / n * (1 + n * y / (W * m)).log()
        assert _wait(curve, slow, most, y) > (parts[0] + parts[1] + fall) * arb("0.999")


def test_no_attraction_beside_a_force_that_grows_faster_than_the_speed():
    """w n'/n is near 3 where the cubic loss is all: the region of the slow curve asks for less than 1."""
    with ctx.workprec(60):
        assert attracted(by_strength(("1/1000", "1/2"), ("1e35", "3")), arb("0.1"), arb(0), arb(0)) is None
        assert attracted(by_strength(("1", "1/1000")), arb("0.1"), arb(0), arb(0)) is not None
