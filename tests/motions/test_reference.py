"""Reference motion against exact solutions and an ordinary integrator; its error against a run with more digits."""

from fractions import Fraction

import pytest
from flint import arb, ctx
from scipy.integrate import solve_ivp

import asymptotics as asy
from asymptotics.errors import InputError, LimitError
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.trajectory import half_swing_pieces
from asymptotics.law import Oscillator
from asymptotics.motions.reference import reference_motion, reference_states
from asymptotics.numbers.exact import ExactReal, parse_real
from tests.second_route.local_expansion import Damping as OtherDamping
from tests.second_route.orbit import orbit


def oscillator(*pairs, **rest):
    return Oscillator(dict(pairs), **rest)


def gap(a, b):
    """|a - b|/|b| of two decimals."""
    return abs(Fraction(a) - Fraction(b)) / abs(Fraction(b))


@pytest.mark.parametrize("alpha", ["0", "1", "2"])
@pytest.mark.parametrize("t", ["1/3", "2", "9"])
def test_the_integrator_agrees_with_the_certified_motion(alpha, t):
    """The integrated states against closed forms, Lambert W and quadrature: no code in common."""
    system = oscillator((alpha, "1/5"), mass="3/2", stiffness="5", x0="-2")
    exact = reference_motion(system, t, 20)
    states = reference_states(system, [parse_real(t, "t")], 22)
    assert exact.certified and exact.order is None and exact.amplitude is None
    with ctx.workprec(200):
        assert abs(states.x[0] - arb(exact.x)) <= arb(exact.error) * 2
        assert abs(states.v[0] - arb(exact.v)) < abs(arb(exact.v)) * arb(10) ** -19


def test_a_wrong_strength_is_seen():
    near, there = (oscillator(("2", b)) for b in ("1/5", "0.2000000001"))
    assert gap(reference_motion(near, "9", 20).x, reference_motion(there, "9", 20).x) > 1e-11


@pytest.mark.parametrize(
    ("pairs", "start"),
    [
        ((("3/2", "1/10"),), ("1", "0")),
        ((("1/2", "1/10"), ("3", "1/20")), ("1", "-1/2")),
        ((("0", "1/30"), ("sqrt(2)", "1/10")), ("-1", "2")),
    ],
)
def test_against_an_ordinary_integrator(pairs, start):
    """Doubles with tight tolerances and |v| as it stands: good to about six digits."""
    point = reference_motion(oscillator(*pairs, x0=start[0], v0=start[1]), "4", 15)
    terms = [(float(parse_real(a, "a").ball()), float(Fraction(b))) for a, b in pairs]

    def slope(_, state):
        v = state[1]
        force = sum(b * abs(v) ** a * (1 if v > 0 else -1 if v < 0 else 0) for a, b in terms)
        return [v, -state[0] - force]

    run = solve_ivp(slope, (0, 4), [float(Fraction(s)) for s in start], rtol=1e-11, atol=1e-12, max_step=0.01)
    assert float(point.x) == pytest.approx(run.y[0, -1], abs=2e-5)
    assert float(point.v) == pytest.approx(run.y[1, -1], abs=2e-5)
    assert point.certified


@pytest.mark.parametrize(("alpha", "t"), [("3/2", "30"), ("1/2", "20"), ("5/3", "7"), ("3", "50")])
def test_the_error_covers_the_difference_to_more_digits(alpha, t):
    system = oscillator((alpha, "1/10"))
    few, many = (reference_motion(system, t, digits) for digits in (12, 30))
    assert abs(Fraction(few.x) - Fraction(many.x)) <= Fraction(few.error) + Fraction(many.error)
    assert Fraction(few.error) < abs(Fraction(few.x)) / 10**11


@pytest.mark.parametrize("start", [("1", "0"), ("1/3", "-1/2")])
@pytest.mark.parametrize("force", [{"3/2": "1/7", 1: "1/30"}, {"2": "1/7", (1, 1): "1/9"}])
def test_a_ladder_of_digits(force, start):
    system = oscillator(*force.items(), x0=start[0], v0=start[1], mass="3/2", stiffness="5")
    times = [ExactReal(Fraction(k, 7)) for k in (1, 11, 30)]
    truth = reference_states(system, times, 30)
    for digits in (2, 5, 12):
        found = reference_states(system, times, digits)
        for rough, fine in zip((*found.x, *found.v), (*truth.x, *truth.v), strict=True):
            assert rough.contains(fine) and rough.rad() <= 3 * arb(10) ** -digits


SECOND = [
    ((("3/2", "1/10"),), ("1", "0")),
    ((("1/2", "1/10"), ("3", "1/20")), ("1", "-1/2")),
    ((("0", "1/30"), ("5/3", "1/10")), ("-1", "2")),
    ((("2", "3"),), ("0", "1")),
    ((("1/2", "1"),), ("1", "0")),
]


@pytest.mark.parametrize(("pairs", "start"), SECOND, ids=str)
def test_the_second_route_is_contained(pairs, start):
    """Two precisions of an integrator without balls, which has no code in common, at few and at many digits."""
    system, times = oscillator(*pairs, x0=start[0], v0=start[1]), [Fraction(n, 3) for n in (1, 4, 11, 20, 31)]
    with ctx.workprec(170):
        damping = OtherDamping.of([(t.strength.ball(), t.velocity) for t in system.dimensionless.terms])
        length, omega = system.length(), system.omega_0()
        X, V = (system.x0.ball() / length).mid(), (system.v0.ball() / length / omega).mid()
        wanted, truth = [(arb(t.numerator) / t.denominator * omega).mid() for t in times], []
        for piece in orbit(damping, X, V):
            while len(truth) < len(wanted) and (piece.end is None or wanted[len(truth)] <= piece.end):
                truth.append(piece.at(wanted[len(truth)]))
            if len(truth) == len(wanted):
                break
    for digits in (3, 12, 30):
        found = reference_states(system, [ExactReal(t) for t in times], digits)
        with ctx.workprec(170):
            for x, v, (X, V) in zip(found.x, found.v, truth):
                assert x.contains(X * length) and v.contains(V * length * omega)
                assert x.rad() < arb(10) ** -digits * length


def test_a_wrong_start_is_excluded():
    near, there = (oscillator(("3/2", "1/10"), x0="0", v0=v) for v in ("1", "1.00000000000000000001"))
    a, b = (reference_states(s, [ExactReal(Fraction(7))], 25) for s in (near, there))
    assert not a.x[0].overlaps(b.x[0])


def test_thirty_digits_over_ten_swings():
    point = reference_motion(oscillator(("3/2", "1/10")), "63", 30)
    assert point.x.startswith("0.1667553142184398873377862") and Fraction(point.error) < Fraction(1, 10**29)


def test_many_times_come_back_in_their_order():
    system = oscillator(("3/2", "1/10"))
    times = [ExactReal(Fraction(n, 2)) for n in (9, 0, 4, 9)]
    states = reference_states(system, times, 15)
    assert states.x[0].overlaps(states.x[3]) and states.x[1] == 1
    assert gap(states.x[2].str(20, radius=False), reference_motion(system, "2", 15).x) < 1e-14


def test_creep_follows_its_law_and_strong_damping_comes_back():
    """Creep (alpha = 1/2, eps = 1): x tau -> 1 (derivation ``creep``).  alpha = 3, b = 30: x passes 0 all the same."""
    slow = reference_motion(oscillator(("1/2", "1")), "200", 12)
    assert abs(float(slow.x) * 200 - 1) < 0.05
    strong = oscillator(("3", "30"), x0="1")
    assert float(reference_motion(strong, "1", 12).x) > 0.5 and float(reference_motion(strong, "6", 12).x) < 0


def test_no_damping_is_certified():
    point = reference_motion(oscillator(("3/2", "0")), "1", 20)
    assert point.certified and point.x == "0.54030230586813971740"  # cos 1


def test_refusals():
    system = oscillator(("3/2", "1/10"))
    for bad, name in ((("-1", 10), "time"), (("1", 0), "digits"), (("1e9", 30), "max_seconds")):
        with pytest.raises((InputError, LimitError), match=name):
            reference_motion(system, *bad)
    with pytest.raises(InputError, match="negative"):
        reference_motion(oscillator(("3/2", "-1")), "1", 10)
    with pytest.raises(InputError, match="static"):
        reference_motion(system, "1", 10, static="1")
    for closed in (("1", "1/10"), ("2", "1/10"), ("0", "0")):  # these closed forms know no static friction
        with pytest.raises(InputError, match="static"):
            reference_motion(oscillator(closed), "1", 10, static="3/4")
    with pytest.raises(LimitError, match="stiff"), ctx.workprec(64):
        stiff = Damping.of([(arb(10) ** 12, parse_real("3/2", "a")), (arb(1), parse_real("2", "a"))])
        list(half_swing_pieces(LinearSpring(stiff), arb(1), arb(0), pieces=20))
    with pytest.raises(LimitError, match="max_seconds"):
        reference_motion(oscillator(("3/2", "1e300")), "6", 10, max_seconds=0.2)


def test_a_rational_radius_comes_to_rest_at_a_rational_place():
    point = reference_motion(oscillator(("0", "1/10"), x0="0.46", v0="-0.48"), "30", 12)
    assert (point.x, point.v) == ("-0.100000000000", "0")
    near = reference_motion(oscillator(("0", "1/10"), x0="0.46", v0="-0.48000000001"), "30", 12)
    assert near.x != point.x and near.v == "0"


def test_extreme_numbers_are_answered_or_refused_at_once():
    weak = reference_motion(oscillator(("2", "1e-12")), "3", 20)
    assert weak.certified and weak.x.startswith("-0.98999249659")
    assert reference_motion(oscillator(("3/2", "1e-300")), "30", 20).x == "0.15425144988758405072"  # cos 30
    with pytest.raises(LimitError, match="halved"):
        reference_motion(oscillator(("1", "1/3")), "1e400", 10)


def test_a_reference_names_its_static_friction():
    mass = asy.Oscillator({0: "1/10"}, mass=2)
    held, free = asy.reference(mass, static="1/5"), asy.reference(mass)
    for told in (repr, str, lambda r: r._heading(), lambda r: r._page().title, lambda r: r._repr_html_()):
        assert "static friction 1/5 N" in told(held) and "static" not in told(free)
