from fractions import Fraction

import pytest
from flint import arb, ctx
from scipy.integrate import solve_ivp

from asymptotics.errors import InputError, LimitError
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.quarter import half_swing
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_real
from asymptotics.turning import enclosing
from asymptotics.turning.choose import turning_points
from tests.second_route.forced import quadratic_turning_points
from tests.second_route.local_expansion import Damping, LocalExpansion
from tests.second_route.orbit import orbit, trap


def law(*pairs):
    return Law(dict(pairs))


def damping(*pairs):
    with ctx.workprec(200):
        return Damping.of([(parse_real(e, "e").ball(), parse_real(a, "a")) for a, e in pairs])


def gap(x, text):
    """|x - text| relative to x, as a double."""
    with ctx.workprec(200):
        return float(abs((x - arb(text)) / x).mid())


def turns(d, count, bits=110):
    with ctx.workprec(bits):
        found = []
        for piece in orbit(d, arb(1), arb(0)):
            if piece.turning is not None:
                found.append((piece.turning, piece.end))
            if piece.trapped or len(found) == count:
                return found, piece.trapped
    return found, None


@pytest.mark.parametrize(("alpha", "epsilon"), [("2", "1"), ("2", "50"), ("1", "1/3"), ("1", "19/10"), ("0", "1/13")])
def test_the_integrator_reproduces_the_certified_cases(alpha, epsilon):
    """Lambert W and quadrature, exponentials, and dry friction: three routes without an integrator."""
    exact = turning_points(law((alpha, epsilon)), 5, 25, times=True)
    found, _ = turns(damping((alpha, epsilon)), 4)
    assert exact.certified and len(found) == 4
    for point, (x, tau) in zip(exact.points[1:], found):
        assert gap(x, point.x) < 1e-24 and gap(tau, point.tau) < 1e-24


def test_a_nearby_strength_is_told_apart():
    exact = quadratic_turning_points(parse_real("1", "e"), 2, 25).points[1]
    found, _ = turns(damping(("2", "1.00000000000000000001")), 1)
    assert gap(found[0][0], exact.x) > 1e-22


@pytest.mark.parametrize("alpha", ["1/2", "3/2", "sqrt(2)", "7/2"])
def test_one_half_swing_against_the_certified_series(alpha):
    """L and T of the normal form at delta = 1/200 through order 10: a remainder of 1e-25 times the coefficients."""
    epsilon = "1/200"
    ((x, tau),) = turns(damping((alpha, epsilon)), 1)[0]
    with ctx.workprec(110):
        half = half_swing(quarter_swing([parse_real(alpha, "a")], 10))
        delta = (arb(1) / 200,)
        assert abs((-x).log() - half.L.at(delta)) < arb(10) ** -18
        assert abs(tau - half.T.at(delta)) < arb(10) ** -18


@pytest.mark.parametrize("pairs", [(("0", "1/20"), ("3/2", "1/10")), (("1/3", "1/10"), ("3", "1/5")), (("5/2", "30"),)])
def test_against_an_ordinary_integrator(pairs):
    """Doubles, sign of the velocity fixed, event at v = 0: an independent method, to ten digits."""
    table = turning_points(law(*pairs), 3, 15, times=True)
    terms = [(float(Fraction(e)), float(Fraction(a))) for a, e in pairs]
    x, t, sign = 1.0, 0.0, 1

    def slope(_, state):
        w = abs(state[1])
        return [-state[1], state[0] - sum(e * (w**a if a else 1.0) for e, a in terms)]

    stop = lambda _, state: state[1] + (1.0 if _ < 1e-9 else 0.0)  # noqa: E731 (v = 0 at the start is no event)
    stop.terminal, stop.direction = True, -1
    for point in table.points[1:]:
        run = solve_ivp(slope, (0.0, 200.0), [x, 0.0], events=stop, rtol=1e-12, atol=1e-14, method="DOP853")
        x, t, sign = -run.y_events[0][0][0], t + run.t_events[0][0], -sign
        assert sign * x == pytest.approx(float(point.x), rel=1e-7)
        assert t == pytest.approx(float(point.tau), rel=1e-7)


def test_the_peers_regression_values_and_their_silent_errors():
    """Against DOP853 (alpha = 2, b = 1/10, restarted at each turn; naive: T_2 = 6.28701 or 6.29050)."""
    found, _ = turns(damping(("2", "1/10")), 6)
    assert gap(found[0][1], "3.146222556011008823268123806") < 1e-26
    assert gap(found[0][0], "-0.8821899862473063793189518542") < 1e-26
    assert gap(found[5][1], "18.86702809175320885461006892") < 1e-26
    assert gap(found[1][1], "6.29146752") < 1e-9 and gap(found[1][1], "6.29050") > 1e-4


def test_fewer_digits_are_a_rounding_of_more():
    few, many = (turning_points(law(("3/2", "1/10")), 4, d, times=True) for d in (15, 40))
    for a, b in zip(few.points, many.points):
        for short, long in ((a.x, b.x), (a.tau, b.tau)):
            assert abs(Fraction(short) - Fraction(long)) <= abs(Fraction(long)) / 10**14
    assert few.certified and "Taylor" in few.method


def test_what_could_not_be_rounded_is_tried_with_the_bits_it_lacked(monkeypatch):
    wanted, mapped = (turning_points(law(("3/2", "1/10")), 3, 12, times=True, route=r) for r in ("stepping", None))
    # 39 bits hold 12 digits, 20 spare ones and 2 x 2 for three half-swings: 63.
    assert wanted.method == "half-swing by half-swing, local expansions and Taylor steps in balls of 63 bits"
    monkeypatch.setattr(enclosing, "_SPARE", -25)
    again = turning_points(law(("3/2", "1/10")), 3, 12, times=True, route="stepping")
    assert again.points == wanted.points == mapped.points and again.method != wanted.method
    assert mapped.method.endswith("Chebyshev interpolation in the amplitude in balls of 63 bits or more")
    assert 39 < int(again.method.split()[-2]) < 130


def test_beside_a_spring_the_start_is_kept_and_the_law_is_named():
    pendulum = Law({"3/2": "1/10", "1": "1/50"}, spring="pendulum")
    whole, later = (turning_points(pendulum, n, 8, start=4 - n, times=True) for n in (4, 2))
    assert later.points == whole.points[2:] and [p.n for p in later.points] == [2, 3]
    assert (later.alpha, later.epsilon) == (whole.alpha, whole.epsilon)
    assert dict(zip(later.alpha.split(","), later.epsilon.split(","))) == {"3/2": "1/10", "1": "1/50"}


def test_dry_friction_sticks_where_the_force_is_at_most_the_friction():
    # epsilon = 1/5: 1, -3/5, 1/5, and |1/5| <= 1/5 sticks at once.  epsilon = 3/10: 1, -2/5, -1/5: on the same side.
    assert turning_points(law(("0", "1/5")), 9, 5).ended == {"n": 2, "reason": "sticks"}
    table = turning_points(law(("0", "3/10")), 9, 5)
    assert [p.x for p in table.points] == ["1.0000", "-0.40000", "-0.20000"]
    assert turning_points(law(("0", "1")), 2, 5).ended == {"n": 0, "reason": "sticks"}
    assert turning_points(law(("0", "1/100")), 5, 5).ended is None
    assert turning_points(law(("0", "sqrt(2)")), 5, 5).ended["n"] == 0
    assert turning_points(law(("0", "1/5")), 3, 5, start=7).points == ()
    found, reason = turns(damping(("0", "3/10")), 9)
    assert reason == "sticks" and len(found) == 2 and gap(found[1][0], "-0.2") < 1e-20


def test_linear_damping_ends_at_two():
    assert turning_points(law(("1", "2")), 3, 5).ended == {"n": 0, "reason": "overdamped"}
    assert turning_points(law(("1", "1.9999")), 3, 5).ended is None
    assert turns(damping(("1", "2.1")), 3) == ([], "overdamped")


def test_no_overdamping_above_one_however_strong():
    """Derivation no-overdamping: for alpha > 1 the second turning point exists for any strength."""
    for alpha, epsilon in (("3/2", "100"), ("11/10", "3"), ("3", "1000")):
        ((x, _),) = turns(damping((alpha, epsilon)), 1, bits=64)[0]
        assert x < 0


def test_half_power_comes_to_rest_in_finite_time_at_a_discrete_strength():
    """delta_0 = 0.8370887974... (theory page ``finite_strength``): passes X = 0 below it, creeps above it."""
    found, reason = turns(damping(("1/2", "0.8370887974")), 1)
    assert reason is None and -(arb(10) ** -10) < found[0][0] < 0
    assert turns(damping(("1/2", "0.8370887975")), 1) == ([], "creeps")
    assert turns(damping(("1/2", "0.83708")), 1)[0][0][0] < -(arb(10) ** -6)


def test_creep_ends_the_sequence_and_keeps_to_its_law():
    """x ~ [a/(1-a)]^(a/(1-a)) eps^(1/(1-a)) tau^(-a/(1-a)) with a = alpha: 1/tau for alpha = 1/2 and eps = 1."""
    table = turning_points(law(("1/2", "1")), 5, 10)
    assert table.ended == {"n": 0, "reason": "creeps"} and len(table.points) == 1
    with ctx.workprec(70):
        for piece in orbit(damping(("1/2", "1")), arb(1), arb(0)):
            if piece.end > 60:
                X = piece.at(arb(60))[0]
                break
    assert abs(60 * X - 1) < 0.1


def test_a_trap_is_not_announced_outside_its_condition():
    d = damping(("1/2", "1"))
    assert trap(d, arb("0.1"), arb("0.001")) == "creeps"
    assert trap(d, arb("0.1"), arb("0.5")) is None and trap(d, arb("-0.1"), arb("0.001")) is None
    assert trap(damping(("1", "1.99")), arb(1), arb("0.001")) is None


@pytest.mark.parametrize("alpha", ["3/2", "sqrt(2)", "1/10"])
def test_the_local_expansion_is_recovered_from_a_point_on_it(alpha):
    with ctx.workprec(100):
        d = damping((alpha, "1/10"))
        w = arb("0.01") if alpha != "1/10" else arb("0.00001")
        for y0 in (arb(1), arb("-0.7")):
            there = LocalExpansion.at(d, y0, w)
            y, tau = there.evaluate(w)
            back = LocalExpansion.through(d, y, w)
            assert abs(back.y0 - y0) < arb(10) ** -27
            found = back.at_time(d, tau / 3, w)
            assert abs(back.evaluate(found[1])[1] - tau / 3) < arb(10) ** -27


def test_bad_input_is_refused_by_name():
    with pytest.raises(InputError, match="negative"):
        turning_points(law(("3/2", "-1")), 2, 5)
    with pytest.raises(LimitError, match="digits"):
        turning_points(law(("3/2", "1")), 2, 5000)
    with pytest.raises(LimitError, match="max_seconds"):
        turning_points(law(("1", "1"), ("2", "1")), 90000, 1000)
    with pytest.raises(InputError, match="epsilon"):
        turning_points(law(("0", "0")), 2, 5)
    assert turning_points(law(("3/2", "0")), 2, 5).points[1].x == "-1.0000"  # undamped: cos tau
