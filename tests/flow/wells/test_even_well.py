"""Half-swings in wells by second routes: elliptic functions, primitives, the linear spring, an integrator, series."""

from fractions import Fraction

import mpmath
import numpy as np
import pytest
from flint import arb, ctx
from scipy.integrate import solve_ivp

from asymptotics.expansions.normal_form.coefficients import half_swing_coefficients
from asymptotics.flow.damping import Damping
from asymptotics.flow.dense import states
from asymptotics.flow.sequence import turning_by_pieces
from asymptotics.flow.turning import at_rest
from asymptotics.flow.wells.even_well import EvenWell
from asymptotics.flow.wells.force import WellForce
from asymptotics.law import Law, Oscillator
from asymptotics.motions.reference import reference_motion
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.return_map.half_swing_map import integrated
from asymptotics.turning.half_swing import half_swing_of_terms
from tests.second_route.forced import drag_turning_points, quadratic_turning_points, stepping_turning_points
from tests.worlds import worlds_of

REST = ExactReal(0)


def exact(text):
    return parse_real(text, "number")


def force_of(law, bits=200):
    with ctx.workprec(bits):
        return WellForce.of(law.terms)


def swing(law, p, bits):
    """(q, T) as balls at the given precision."""
    with ctx.workprec(bits):
        found, _ = turning_by_pieces(EvenWell(force_of(law, bits + 40)), at_rest(arb(p)))
        return arb(found.amplitude, found.amplitude_error), found.tau


@pytest.mark.parametrize("bits", [45, 90])
@pytest.mark.parametrize(("p", "lost"), [("0.5", 9), ("2", 14), ("3.125", 37)])
def test_a_pendulum_without_loss_takes_two_complete_elliptic_integrals(p, lost, bits):
    q, T = swing(Law({2: 0}, spring="pendulum"), p, bits)
    with ctx.workprec(200):
        truth = 2 * (arb.pi() / 2) / arb(1).agm((arb(p) / 2).cos())
        assert q.contains(arb(p).mid()) and T.contains(truth.mid())
        assert not T.contains((truth * (1 + arb(2) ** (lost - bits))).mid())


@pytest.mark.parametrize("c", ["0.25", "-0.25", "1000"])
def test_the_half_period_of_duffing(c):
    q, T = swing(Law({2: 0}, spring={3: c}), 1, 60)
    with ctx.workprec(200):
        m = arb(c) / (2 * (1 + arb(c)))
        truth = arb.pi() / arb(1).agm((1 - m).sqrt()) / (1 + arb(c)).sqrt()
        assert q.contains(arb(1)) and T.contains(truth.mid()) and T.rad() < truth * arb(2) ** -45


def test_the_motion_of_a_pendulum_without_loss_is_a_jacobi_function():
    """sin(x/2) = k cd(t, k^2) at several times."""
    with mpmath.workdps(40):
        k = mpmath.sin(mpmath.mpf(5) / 4)
        times = [mpmath.mpf(n) / 4 for n in (1, 5, 11, 23, 47)]
        truth = [2 * mpmath.asin(k * mpmath.ellipfun("cd", t, k**2)) for t in times]
    with ctx.workprec(90):
        found = states(
            EvenWell(force_of(Law({2: 0}, spring="pendulum"))), arb("2.5").mid(), arb(0), [arb(str(t)) for t in times]
        )
        for (x, _), value in zip(found, truth, strict=True):
            assert x.rad() < arb(10) ** -18 and x.overlaps(arb(mpmath.nstr(value, 35)))


@pytest.mark.parametrize(
    ("law", "p"),
    [(Law({2: "1/10"}, spring="pendulum"), "2.5"), (Law({2: "1/10", 0: "1/50"}, spring={3: "1/2", 2: "1/5"}), "1")],
)
def test_quadratic_drag_and_dry_friction_have_their_primitive(law, p):
    """The integrator against the closed primitive: places only, no code in common."""
    primitive = drag_turning_points(law, exact(p), 5, 25)
    pieces = stepping_turning_points(law, exact(p), 5, 25)
    assert [a.x for a in pieces.points] == [a.x for a in primitive.points]


def test_quadratic_drag_with_a_linear_spring_is_lambert_w():
    q, T = swing(Law({2: "1/2", (2, 2): 0}), 1, 100)
    table = quadratic_turning_points(exact("1/2"), 2, 50, times=True).points[1]
    with ctx.workprec(200):
        assert q.contains(-arb(table.x)) and T.contains(arb(table.tau)) and q.rad() < arb(2) ** -85


LINEAR = worlds_of(
    "another rational power", "a root beside a cube", "an irrational power", "a loss next to the critical one",
    "a strong cube", "a steep power", "dry friction beside three halves",
)  # fmt: skip


@pytest.mark.parametrize("name", LINEAR)
def test_the_linear_spring_as_a_well(name):
    """Two rooms, two theories of errors: each encloses what the other finds with more digits."""
    law = LINEAR[name].dimensionless
    q, T = swing(law, 1, 60)
    with ctx.workprec(160):
        exactly = integrated(Damping.of_law(law), arb(1))
        assert q.contains(exactly.amplitude.mid()) and T.contains(exactly.duration.mid())
        assert q.rad() < arb(2) ** -36


def integrator(law):
    """The force in doubles."""
    losses = [(float(t.strength.ball()), t.position, float(t.velocity.ball())) for t in law.losses]
    springs = [(float(t.strength.ball()), t.position) for t in law.springs if not t.family]
    pendulum = any(t.family for t in law.springs)

    def field(_, z):
        x, v = z
        pull = np.sin(x) if pendulum else x
        pull += sum(c * x * abs(x) ** (p - 1) for c, p in springs)
        return [v, -pull - np.sign(v) * sum(e * abs(x) ** m * abs(v) ** a for e, m, a in losses)]

    return field


WELLS = [
    (Law({"3/2": "1/10"}, spring="pendulum"), "2", "0"),
    (Law({"1/2": "1/20", (1, 1): "1/3"}, spring={2: "1/4", 3: "-1/10"}), "-3/2", "0"),
    (Law({("3/2", 3): "1/3", 1: "1/20"}, spring={5: "1/3"}), "1", "-1"),
    (Law({"sqrt(2)": "1/10"}, spring={4: "1/2"}), "1/2", "1"),
    (Law({(2, 2): "1/2"}), "1", "1/2"),
    (Law({(0, 1): "1/5", 3: "1/10"}, spring={3: 2}), "0", "1"),
    (Law({1: "1/10"}, spring="pendulum"), "-1", "-1"),
]


@pytest.mark.parametrize(("law", "x0", "v0"), WELLS, ids=str)
def test_against_an_ordinary_integrator(law, x0, v0):
    times = [Fraction(n, 2) for n in (1, 4, 9, 14)]
    run = solve_ivp(integrator(law), (0, 7), [float(Fraction(x0)), float(Fraction(v0))], rtol=1e-11, atol=1e-12,
                    max_step=0.01, t_eval=[float(t) for t in times], method="DOP853")  # fmt: skip
    with ctx.workprec(80):
        found = states(
            EvenWell(force_of(law)),
            exact(x0).ball(),
            exact(v0).ball(),
            [arb(t.numerator) / t.denominator for t in times],
        )
    for n, (x, v) in enumerate(found):
        assert float(x) == pytest.approx(run.y[0, n], abs=3e-5) and float(v) == pytest.approx(run.y[1, n], abs=3e-5)
        assert x.rad() < 1e-15 and v.rad() < 1e-15


@pytest.mark.parametrize(
    ("law", "x0", "v0"), [*WELLS[:2], *(pytest.param(*w, marks=pytest.mark.slow) for w in WELLS[2:])]
)
def test_few_digits_contain_many(law, x0, v0):
    times = [arb(n) / 4 for n in (1, 7, 16, 29)]

    def at(bits):
        with ctx.workprec(bits):
            return states(EvenWell(force_of(law)), exact(x0).ball(), exact(v0).ball(), times)

    few, many = at(45), at(110)
    with ctx.workprec(200):
        for rough, fine in zip(few, many, strict=True):
            for a, b in zip(rough, fine, strict=True):
                assert a.contains(b.mid()) and a.rad() < 1e-6 and b.rad() < 1e-24


@pytest.mark.parametrize(
    ("law", "ratio"),
    [
        (Law({"3/2": 1}, spring={3: 1}), "2"),
        (Law({2: 1}, spring="pendulum"), "3"),
        (Law({1: 1, (1, 2): 1}, spring={2: 1}), "1"),
    ],
    ids=str,
)
def test_the_series_at_small_strengths(law, ratio):
    """Order 4 at delta and at delta/2: what is left falls by about 2^5."""
    terms, order = law.terms, 4
    series = half_swing_coefficients(terms, order, 25)
    left = []
    for size in (Fraction(1, 100), Fraction(1, 200)):
        delta = [size * (Fraction(ratio) if t.sign > 0 else 1) for t in terms]
        found = half_swing_of_terms(terms, [ExactReal(d) for d in delta], 25)
        gaps = []
        for row, value in ((series.log_ratio, found.log_ratio), (series.duration, found.duration)):
            total = Fraction(0)
            for key, c in row.items():
                powers = [int(n) for n in str(key).split(",")]
                term = Fraction(c.value)
                for d, n in zip(delta, powers, strict=True):
                    term *= d**n
                total += term
            gaps.append(abs(total - Fraction(value)))
        left.append(gaps)
    for coarse, fine in zip(*left, strict=True):
        assert coarse < Fraction(1, 10**7) and fine <= coarse / 24


def test_units_of_mass_length_and_time():
    """m = 4, k = 1: omega_0 = 1/2, epsilon = b omega_0^2/k in rad; sin stays the sine of an angle."""
    own = reference_motion(Oscillator({2: "1/10"}, spring="pendulum", x0="4/3"), "4", 20)
    other = reference_motion(Oscillator({2: "2/5"}, spring="pendulum", x0="4/3", mass=4), "8", 20)
    assert own.x == other.x and own.certified and Fraction(own.v) != Fraction(other.v)
    assert abs(Fraction(own.v) - 2 * Fraction(other.v)) < Fraction(1, 10**18)
