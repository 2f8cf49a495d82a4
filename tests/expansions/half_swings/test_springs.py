"""Springs and position-dependent losses: two exact routes, exact in balls, integrals, disguises, and near misses."""

from dataclasses import replace
from fractions import Fraction

import mpmath
import pytest
from flint import arb, ctx, fmpq
from sympy import Rational

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.certified_zeros import certified_half_swing
from asymptotics.expansions.half_swings.exact import even_half_swing, exact_half_swing, exact_quarter_swing
from asymptotics.expansions.half_swings.forces import Forces, Member
from asymptotics.expansions.half_swings.fourier_flow import fourier_flow
from asymptotics.expansions.half_swings.pi_ring import PiNumber
from asymptotics.expansions.half_swings.quarter import half_swing
from asymptotics.expansions.moments import symbolic as moments
from asymptotics.expansions.moments.symbolic import mean
from asymptotics.expansions.normal_form.flow import flow_of
from asymptotics.expansions.normal_form.spring_terms import cross_term
from asymptotics.numbers.exact import ExactReal
from asymptotics.terms import Term
from paper_checks.report.verification import numerical_half_swing


def loss(alpha, m=0):
    return Term(1, alpha, m)


def spring(p, q=0):
    return Term(1, q, p, "position")


PENDULUM = Term(1, 0, 3, "position", "pendulum")
SMOOTH = {  # polynomials in x and v: the Fourier route and the reversal identity
    "Duffing, linear loss": [loss(1), spring(3)],
    "van der Pol": [loss(1), loss(1, 2)],
    "Rayleigh": [loss(1), loss(3)],
    "pendulum, cubic loss": [loss(3), PENDULUM],
    "inertial spring x v^2": [loss(1), spring(1, 2)],
    "quintic": [spring(5)],
}
EVEN = {  # polynomials in cos(theta) on the whole half-swing
    "pendulum in air": [loss(2), PENDULUM],
    "Duffing, dry friction": [loss(0), spring(3)],
    "x^2 in a quadratic loss": [loss(2, 2), spring(3, 2)],
}
ROUGH = {  # |x| or x|x|: the quarter only
    "x|x|": [loss(2), spring(2)],
    "hysteretic |x| sgn v": [loss(0, 1)],
    "|x| v with Duffing": [loss(1, 1), spring(3)],
}
ALL = SMOOTH | EVEN | ROUGH


@pytest.mark.parametrize("terms", [*SMOOTH.values(), *EVEN.values()], ids=[*SMOOTH, *EVEN])
def test_two_exact_routes_agree(terms):
    direct, reversal = exact_half_swing(terms, 4), half_swing(exact_quarter_swing(terms, 4))
    assert (direct.L - reversal.L).coefficients == {} == (direct.T - reversal.T).coefficients


@pytest.mark.parametrize("terms", SMOOTH.values(), ids=SMOOTH)
def test_the_flow_of_the_map_is_the_fourier_flow(terms):
    flow, direct = flow_of(half_swing(exact_quarter_swing(terms, 4))), fourier_flow(terms, 4)
    assert (flow.U - direct.U).coefficients == {} == (flow.W - direct.W).coefficients


@pytest.mark.parametrize("terms", ALL.values(), ids=ALL)
def test_the_exact_half_swing_is_the_integrated_one(terms):
    half, delta = exact_half_swing(terms, 8), 0.015
    sums = [s.map(c_ball).at((arb(delta),) * len(terms)) for s in (half.L, half.T)]
    found, truth = [float(arb(s).mid()) for s in sums], numerical_half_swing(terms, [delta] * len(terms))
    assert found == pytest.approx(truth, abs=2e-11)
    assert found != pytest.approx([truth[0], truth[1] * (1 + 1e-9)], abs=2e-11)


def c_ball(c):
    return (PiNumber.rational(0) + c).ball()


@pytest.mark.parametrize("terms", ALL.values(), ids=ALL)
def test_balls_contain_the_exact_quarter_swing(terms):
    exact = exact_quarter_swing(terms, 3, moments=True)
    with ctx.workprec(100):
        balls = quarter_swing(terms, 3, moments=True)
    rows = [(exact.R, balls.R), (exact.T_q, balls.T_q)]
    rows += [pair for a, b in zip(exact.K, balls.K, strict=True) for pair in zip(a, b, strict=True)]
    with ctx.workprec(400):
        for a, b in rows:
            for n in {*a.coefficients, *b.coefficients}:
                assert arb(b[n]).contains(c_ball(a[n]))
                assert arb(b[n]).rad() < arb(2) ** -85


def test_a_missing_tail_is_seen_with_springs():
    """With few terms the balls are wide, and without their tails they would miss the truth."""
    terms = [loss("3/2", 1), spring(3)]
    with ctx.workprec(200):
        fine, coarse = quarter_swing(terms, 3), quarter_swing(terms, 3, terms=8)
        for n, c in coarse.T_q.coefficients.items():
            assert c.contains(fine.T_q[n])
            assert not any(n) or not c.mid().overlaps(fine.T_q[n])


def test_conservative_springs_are_elliptic_integrals():
    """T of x'' + sin x = 0 is 2 K(sin^2(A/2)), of x'' + x + c x^3 = 0 a K too; both by the AGM of mpmath."""
    with mpmath.workdps(30):
        A = mpmath.mpf("0.1")
        pendulum = exact_half_swing([PENDULUM], 10).T
        value = at(pendulum, A**2)
        assert abs(value - 2 * mpmath.ellipk(mpmath.sin(A / 2) ** 2)) < mpmath.mpf(10) ** -24
        gamma = mpmath.mpf("0.01")
        duffing = exact_half_swing([spring(3)], 10).T
        value = at(duffing, gamma)
        truth = 2 / mpmath.sqrt(1 + gamma) * mpmath.ellipk(gamma / (2 * (1 + gamma)))
        assert abs(value - truth) < mpmath.mpf(10) ** -20
        assert abs(value - truth * (1 + mpmath.mpf(10) ** -18)) > mpmath.mpf(10) ** -20


def at(series, delta):
    with ctx.workprec(140):
        return sum(mpmath.mpf(c_ball(c).str(40, radius=False)) * delta ** k[0] for k, c in series.coefficients.items())


def disguised(order):
    """y'' + tanh(y) (1 + y'^2) + eps y' = 0, which is x'' + eps x' + x = 0 with x = sinh y."""
    ratios = {1: fmpq(1), 3: fmpq(-1, 3), 5: fmpq(2, 15), 7: fmpq(-17, 315), 9: fmpq(62, 2835)}
    members = [Member((1, 0), fmpq(1), ExactReal(1), 0, -1)]
    for j in range(1, order + 1):
        members.append(Member((0, j), ratios[2 * j + 1], ExactReal(0), 2 * j + 1, 1))
        members.append(Member((0, j), ratios[2 * j - 1], ExactReal(2), 2 * j - 1, 1))
    zero, two = ExactReal(0), ExactReal(2)
    return Forces((zero, two), (-1, 1), (ExactReal(1), zero), tuple(members))


def test_a_linear_oscillator_in_disguise_keeps_its_frequency():
    flow = flow_of(exact_half_swing(disguised(4), 4))
    assert {k: str(c) for k, c in flow.W.coefficients.items()} == {(0, 0): "1", (2, 0): "1/8", (4, 0): "3/128"}
    assert any(k[1] for k in flow.U.coefficients)  # A is relabelled, so U does change
    spoilt = disguised(4)
    members = tuple(replace(m, ratio=m.ratio * 2) if m.key == (0, 4) and m.position == 9 else m for m in spoilt.members)
    assert (0, 4) in flow_of(exact_half_swing(replace(spoilt, members=members), 4)).W.coefficients


@pytest.mark.parametrize("terms", [[loss("3/2"), spring(3)], [loss("1/2", 1), PENDULUM], [loss("sqrt(2)"), spring(2)]])
def test_zeros_by_theorem_are_zeros(terms):
    with ctx.workprec(120):
        plain, decided = half_swing(quarter_swing(terms, 4)), certified_half_swing(terms, 4)
    gone = [(n, c) for n, c in plain.L.coefficients.items() if n not in decided.L.coefficients]
    assert {n for n, _ in gone} >= {(0, k) for k in range(1, 5)}  # a spring alone loses nothing
    assert all(arb(c).contains(0) and arb(c).rad() < arb(10) ** -25 for _, c in gone)
    assert (1, 0) not in decided.T.coefficients
    assert not decided.T[1, 1].contains(0)  # but a loss and a spring together do change T: not a zero


def test_near_misses():
    """The sign of a spring, parity by total degree, and (p - 1) for (p - alpha) would each be seen."""
    right = half_swing(exact_quarter_swing([loss(2), spring(3)], 2))
    quarter = exact_quarter_swing([loss(2), spring(3)], 2)
    wrong = half_swing(replace(quarter, grading=replace(quarter.grading, signs=(-1, -1))))
    assert right.L[0, 1] == 0 != wrong.L[0, 1]  # a spring with the sign of a loss would lose energy
    assert right.T[0, 1] != 0 == wrong.T[0, 1]  # and not change the time
    U = flow_of(right).U[1, 1].to_sympy()
    cross = cross_term(2, 0, 3, moments)
    assert U == cross != cross + Rational(1, 4) * mean(0, 3)  # (p - 1) for (p - alpha)
    by_total_degree = replace(flow_of(right).grading, signs=(-1, -1))
    with pytest.raises(ArithmeticError, match="reversibility"):
        by_total_degree.of_parity(flow_of(right).U, 1)


@pytest.mark.parametrize("terms", [[], [Term(1, "3/2")], [loss(2), spring(2, "1/2")]])
def test_what_is_not_exact_is_refused(terms):
    with pytest.raises(InputError):
        exact_half_swing(terms, 3)
    with pytest.raises(InputError):
        even_half_swing([Term(1, Fraction(1, 3))], 2)
