"""The nine wrong answers that other programs give without a message: ours is right, and our checks refute theirs.

Their answers are quoted from measurements; mpmath's is reproduced here.  Each is judged by something that shares
nothing with the expansion: a half-swing integrated with the sign of v handled by events, the half-swing from
polynomials in theta, or Lambert's W.
"""

from dataclasses import replace
from fractions import Fraction
from math import cos, exp, log, pi, sin, tan

import mpmath
import numpy as np
import pytest
import sympy
from flint import arb, fmpq
from scipy.integrate import quad, solve_ivp

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.exact import exact_half_swing, exact_quarter_swing
from asymptotics.expansions.half_swings.fourier_flow import fourier_flow
from asymptotics.expansions.half_swings.pi_ring import PiNumber
from asymptotics.expansions.moments.certified import moment
from asymptotics.expansions.normal_form.expansion import exact_expansion
from asymptotics.expansions.normal_form.flow import Flow
from asymptotics.flow.damping import Damping
from asymptotics.law import Law, Oscillator
from asymptotics.motions.reference import reference_motion, reference_states
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.series import Series
from paper_checks.report.verification import (
    equation_residual,
    exact_reference,
    map_residual,
    measured_order,
    residual_order,
)
from paper_checks.verdict import Outcome
from tests.second_route.forced import quadratic_turning_points

TIGHT = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-14}


def swings(alpha, epsilon, count):
    """[(tau_n, |x_n|)] and the first passage through x = 0, the sign of v constant in each half-swing."""

    def at_rest(_, y):
        return y[1]

    def passage(_, y):
        return y[0]

    at_rest.terminal, at_rest.direction = True, 1.0
    points, first_passage, tau, size = [], None, 0.0, 1.0
    for _ in range(count):  # always the half-swing with v <= 0: the others are its mirror images
        run = solve_ivp(
            lambda _, y: [y[1], -y[0] + epsilon * abs(y[1]) ** alpha],
            (0, 10),
            [size, 0.0],
            events=[at_rest, passage],
            **TIGHT,
        )
        tau, size = tau + run.t_events[0][0], -run.y_events[0][0][0]
        first_passage = run.t_events[1][0] if first_passage is None else first_passage
        points.append((tau, size))
    return points, first_passage


def claimed(alphas, order, gauge, p, Omega):
    """An expansion with the coefficients of somebody else: {k: rational} for p_k and Omega_k."""
    ours = exact_expansion(alphas, order, gauge)
    p, Omega = (Series({(k,): PiNumber.rational(fmpq(*x)) for k, x in row.items()}, 1, order) for row in (p, Omega))
    W = (Omega + 1).inverse()
    return replace(ours, flow=Flow(ours.flow.grading, -(p * W), W))


def rest(alphas, order):
    """No decay and frequency 1."""
    return claimed(alphas, order, "turning-point", {}, {})


RIGHT_P = {1: (3, 8), 3: (351, 8192), 5: (43281, 4194304)}
RIGHT_OMEGA = {2: (9, 256), 4: (1755, 262144)}


@pytest.mark.parametrize(
    ("order", "p", "Omega"),
    [
        (3, {3: (567, 8192)}, {}),
        (4, {}, {4: (-1485, 262144)}),
        (5, {5: (43605, 4194304)}, {}),
    ],
)
def test_1_oscilate_from_third_order_on(order, p, Omega):
    gauge = "no-first-harmonic"
    reference = exact_reference((3,), order)
    here = [{k: x for k, x in row.items() if k <= order} for row in (RIGHT_P, RIGHT_OMEGA)]
    right = claimed((3,), order, gauge, *here)
    wrong = claimed((3,), order, gauge, here[0] | p, here[1] | Omega)
    ours = exact_expansion((3,), order, gauge)
    assert ours.p.coefficients == right.p.coefficients
    assert ours.Omega.coefficients == right.Omega.coefficients
    assert map_residual(ours, reference) is Outcome.CONFIRMED
    assert equation_residual((3,), order, gauge) is Outcome.CONFIRMED
    assert map_residual(wrong, reference) is Outcome.REFUTED
    assert residual_order(wrong, reference) == order


def test_1_its_third_order_seen_in_numbers_and_right_in_another_gauge():
    wrong = claimed((3,), 3, "no-first-harmonic", {1: (3, 8), 3: (567, 8192)}, {2: (9, 256)})
    # 16 levels, down to delta = 0.0017: the wrong third order of L, 0.083 delta^3, must exceed the missing 5 delta^4
    assert measured_order(wrong, levels=16) < 3.3
    assert measured_order(exact_expansion((3,), 3, "no-first-harmonic"), levels=16) > 3.9
    other = claimed((3,), 3, "averaging", {1: (3, 8), 3: (567, 8192)}, {2: (-27, 256)})
    assert map_residual(other, exact_reference((3,), 3)) is Outcome.CONFIRMED


@pytest.mark.parametrize(("alpha", "tool"), [(2.0, "ms"), (1.5, "ms"), (2.0, "twovar")])
def test_2_and_7_fast_time_in_the_amplitude_law(alpha, tool):
    # Maxima's twovar: r' = -r|r||sin|/2.  Cancelling eps A^alpha |sin|^(alpha-1) sin without the mean gives the same:
    # 2 A' = -eps A^alpha |sin|^(alpha-1), hence (alpha+1)/(2 alpha) of the decay that there is.
    epsilon = 1e-4
    seen = -log(swings(alpha, epsilon, 1)[0][0][1]) / epsilon
    ours = pi * float(moment(arb(alpha) + 1).mid())
    theirs = quad(lambda t: abs(sin(t)) ** (alpha - 1) / 2, 0, pi)[0]
    assert seen == pytest.approx(ours, rel=1e-3)
    assert theirs / ours == pytest.approx((alpha + 1) / (2 * alpha), rel=1e-7)
    assert abs(theirs / seen - 1) > 0.15
    if alpha == 2:
        assert exact_half_swing((2,), 1).L[1] == fmpq(-4, 3)
        epsilon = mpmath.mpf("0.001")  # Lambert: u_1 = (1 + W(-y e^-y))/2, y = 1 + 2 epsilon
        y = 1 + 2 * epsilon
        log_ratio = mpmath.log((1 + mpmath.lambertw(-y * mpmath.exp(-y)).real) / (2 * epsilon))
        assert float(log_ratio / epsilon) == pytest.approx(-4 / 3, rel=2e-3)


def test_2_an_amplitude_with_fast_time_does_not_solve_the_leading_equation():
    T = sympy.Symbol("T", positive=True)
    slow, fast = sympy.Symbol("A"), 2 / (2 - sympy.cos(T))  # A' = -A^2 sin(T)/2 on 0 < T < pi
    assert sympy.simplify(sympy.diff(fast, T) + fast**2 * sympy.sin(T) / 2) == 0
    residual = [sympy.diff(A * sympy.cos(T), T, 2) + A * sympy.cos(T) for A in (slow, fast)]
    assert residual[0] == 0
    assert abs(float(residual[1].subs(T, 1))) > 0.1


def test_3_dry_friction_decays():
    ours = exact_expansion((0,), 4)
    assert map_residual(ours, exact_reference((0,), 4)) is Outcome.CONFIRMED
    assert ours.half.L.exp().coefficients == {(0,): 1, (1,): fmpq(-2)}  # 1 - 2 delta, exactly
    assert residual_order(rest((0,), 4), exact_reference((0,), 4)) == 1
    sizes = [size for _, size in swings(0.0, 0.1, 3)[0]]
    assert sizes == pytest.approx([0.8, 0.6, 0.4], abs=1e-10)


@pytest.mark.parametrize("alpha", [1, 3])
def test_4_second_order_keeps_the_amplitude_and_has_no_secular_term(alpha):
    first, second = (exact_expansion((alpha,), order) for order in (1, 2))
    assert second.p[1] == first.p[1] != 0
    assert residual_order(rest((alpha,), 2), exact_reference((alpha,), 2)) == 1
    assert equation_residual((alpha,), 2, "turning-point") is Outcome.CONFIRMED
    # The waveform is a polynomial in exp(+-2 i psi) with coefficients in delta: nothing grows with time.
    flow = fourier_flow((alpha,), 2)
    assert all(p.degree() <= 2 * flow.shift * n for n, part in enumerate(flow.Z) for p in part.values())


def test_4_the_secular_term_against_the_exact_linear_motion():
    epsilon, tau = 0.1, 400.0
    rate = np.sqrt(1 - epsilon**2 / 4)
    true = exp(-epsilon * tau / 2) * (cos(rate * tau) + epsilon / (2 * rate) * sin(rate * tau))
    frozen = abs(1 + epsilon**2 * tau / 8)  # an amplitude not solved for, and a term eps^2 t
    ours = exp(-epsilon * tau / 2) * (1 + epsilon / 2)  # bounds |x|, for p_1 = 1/2 and a bounded waveform
    assert exact_expansion((1,), 2).p[1] == fmpq(1, 2)
    assert abs(true) <= ours < 1e-8
    assert frozen > 1


@pytest.mark.parametrize("alpha", [1, 2, 3])
def test_5_a_damped_motion_is_not_periodic_with_frequency_1(alpha):
    reference = exact_reference((alpha,), 2)
    ours = exact_expansion((alpha,), 2)
    assert map_residual(ours, reference) is Outcome.CONFIRMED
    assert residual_order(rest((alpha,), 2), reference) == 1
    no_lag = replace(ours, flow=Flow(ours.flow.grading, ours.flow.U, ours.flow.W * 0 + 1))
    assert residual_order(no_lag, reference) == 2  # even with the right decay, psi' = 1 is wrong
    delta = 0.02
    ((tau, size),), _ = swings(float(alpha), delta, 1)
    lag = float(ours.half.T[2].ball().mid()) * delta**2
    assert tau - pi == pytest.approx(lag, rel=0.1)
    assert size < 0.99


def test_6_maxima_lindstedt_on_damping():
    # T = (1 + (3/8) eps cot T) t: the passage T = pi/2 would come at t = pi/2, and the turning point T -> pi at t -> 0.
    epsilon = 0.02

    def theirs(T):
        return T / (1 + 3 * epsilon / (8 * tan(T)))

    points, passage = swings(3.0, epsilon, 1)
    ours = exact_quarter_swing((3,), 2).T_q
    assert ours[1] == fmpq(1, 4)
    assert passage == pytest.approx(pi / 2 + epsilon / 4, abs=epsilon**2)
    assert abs(theirs(pi / 2) - passage) > 0.9 * epsilon / 4
    assert abs(theirs(pi - 1e-9)) < 1e-3
    assert points[0][0] > pi
    assert exact_half_swing((3,), 2).T[1] == 0


EXACT_T2 = mpmath.mpf("6.2914675226633459722")
"""Certified (balls), and to ten decimals by event-handling integration: the first test below."""


def test_8_and_9_second_turning_point_three_ways():
    table = quadratic_turning_points(parse_real("1/10", "epsilon"), 3, 20, times=True).points
    assert mpmath.mpf(table[2].tau) == EXACT_T2
    points, _ = swings(2.0, 0.1, 2)
    assert points[1][0] == pytest.approx(float(EXACT_T2), abs=1e-10)
    assert points[1][1] == pytest.approx(float(table[2].x), abs=1e-10)
    p = mpmath.mpf("0.2")
    for _ in range(2):
        p = 1 + mpmath.lambertw(-(1 + p) * mpmath.exp(-(1 + p))).real
    assert float(p / 0.2) == pytest.approx(float(table[2].x), abs=1e-12)


@pytest.mark.parametrize(
    ("theirs", "error"),
    [
        ("6.28701", "4e-3"),  # 8: heyoka, select(v > 0, 1, -1) v^2 without an event
        ("6.29050", "9e-4"),
        ("6.29146704", "4e-7"),
        ("6.29095", "5e-4"),  # 9: odefun with v|v| at 15, 30, 50 digits
    ],
)
def test_8_and_9_quoted_times_are_refuted(theirs, error):
    assert abs(mpmath.mpf(theirs) - EXACT_T2) > mpmath.mpf(error)


def test_9_odefun_with_a_naive_absolute_value_reproduced():
    with mpmath.workdps(15):
        b = mpmath.mpf("0.1")
        orbit = mpmath.odefun(lambda _, y: [y[1], -y[0] - b * y[1] * abs(y[1])], 0, [1, 0])
        naive = mpmath.findroot(lambda t: orbit(t)[1], (6.28, 6.3))
    assert abs(naive - EXACT_T2) > 1e-6


@pytest.mark.parametrize("strength", ["1/10", "-1/10"])
def test_no_spring_is_left_out_silently(strength):
    """The spring is in the answer, as SciPy has it; what knows powers of the velocity only refuses it."""
    bent = Oscillator({1: 1}, spring={3: strength})
    c = float(Fraction(strength))
    theirs = solve_ivp(lambda t, y: [y[1], -y[0] - c * y[0] ** 3 - y[1]], (0, 1), [1, 0], rtol=1e-12, atol=1e-14)
    x = theirs.y[0, -1]
    assert float(reference_motion(bent, 1).x) == pytest.approx(x, abs=1e-9)
    assert float(reference_states(bent, [ExactReal(1)], 10).x[0].mid()) == pytest.approx(x, abs=1e-9)
    assert abs(float(reference_motion(Oscillator({1: 1}), 1).x) - x) > 1e-3
    with pytest.raises(InputError, match="x\\^3 is not a power of the velocity"):
        Damping.of_law(Law({1: 1}, spring={3: strength}))


def test_what_has_no_exact_or_smooth_treatment_is_refused_by_name():
    with pytest.raises(InputError, match="alpha"):
        exact_half_swing((Fraction(3, 2),), 2)
    with pytest.raises(InputError, match="gauge"):
        exact_expansion((3,), 3, "oscillator-form")
