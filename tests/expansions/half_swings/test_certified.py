"""The certified quarter swing: exact cases, closed forms, independent quadrature, overlap of routes, planted faults."""

from collections.abc import Callable
from fractions import Fraction
from math import comb, cos, pi, sin

import mpmath
import pytest
from flint import arb, ctx, fmpq
from scipy.integrate import quad, solve_ivp

from asymptotics.errors import InputError, LimitError
from asymptotics.expansions.half_swings.certified import (
    enclose,
    quarter_swing,
    tail_constants,
    terms_needed,
    truncated_sums,
)
from asymptotics.expansions.half_swings.exact import exact_quarter_swing
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.half_swings.pi_ring import PiNumber
from asymptotics.expansions.half_swings.quarter import QuarterSwing
from asymptotics.numbers.bridge import bounds, to_fmpq
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.series import Series

ALPHAS = ["1/2", "3/2", "5/3", "sqrt(2)", "2", "0", "1"]


def exponents(*texts: str) -> list[ExactReal]:
    return [parse_real(t, "--alpha") for t in texts]


def swing(*texts: str, order: int, bits: int = 160, **options: object) -> QuarterSwing:
    with ctx.workprec(bits):
        return quarter_swing(exponents(*texts), order, **options)  # type: ignore[arg-type]


def series_in(values: list[Fraction]) -> Series:
    return Series.from_list([arb(to_fmpq(v)) for v in values])


def assert_contains_narrowly(ball: arb, value: arb, bits: int = 100) -> None:
    assert ball.overlaps(value)
    assert ball.rad() < arb(2) ** -bits * max(1, abs(ball).upper())


def real(text):
    return parse_real(text, "alpha")


def test_dry_friction_is_contained() -> None:
    """α = 0: X = δ + (1−δ) cos τ, so that R = ½ ln(1−2δ) and T_q = arccos(−δ/(1−δ)).

    δ/(1−δ) to the power m has the coefficients C(n−1, m−1); arcsin y = Σ C(2k,k) y^(2k+1)/(4^k (2k+1)).
    """
    quarter = swing("0", order=10)
    for n in range(1, 11):
        arcsine = sum(
            Fraction(comb(2 * k, k) * comb(n - 1, 2 * k), 4**k * (2 * k + 1)) for k in range((n - 1) // 2 + 1)
        )
        assert_contains_narrowly(quarter.R[n], arb(fmpq(-(2 ** (n - 1)), n)))
        assert_contains_narrowly(quarter.T_q[n], arb(to_fmpq(arcsine)))
        assert not quarter.R[n].contains(arb(fmpq(-(2 ** (n - 1)) * 10**20 - 1, n * 10**20)))


def test_linear_friction_is_contained() -> None:
    """α = 1: X' ∝ e^(−ετ/2) sin ωτ, ω² = 1 − ε²/4; X = 0 at ωτ = π/2 + arcsin(ε/2), where r = e^(−ετ/2)."""
    quarter, order = swing("1", order=11), 11
    with ctx.workprec(160):
        root = series_in([Fraction(comb(n, n // 2), 16 ** (n // 2)) if n % 2 == 0 else Fraction(0) for n in range(12)])
        arcsine = series_in(
            [Fraction(comb(n - 1, n // 2), 2 * 16 ** (n // 2) * n) if n % 2 else Fraction(0) for n in range(12)]
        )
        expected = (arcsine + arb.pi() / 2) * root
    for n in range(1, order + 1):
        assert_contains_narrowly(quarter.T_q[n], expected[n])
        assert_contains_narrowly(quarter.R[n], -expected[n - 1] / 2)


def mp_bounds(ball: arb) -> tuple[mpmath.mpf, mpmath.mpf]:
    low, high = bounds(ball)
    return mpmath.mpf(low.numerator) / low.denominator, mpmath.mpf(high.numerator) / high.denominator


@pytest.mark.parametrize("text", ALPHAS)
def test_two_orders_by_quadrature(text: str) -> None:
    """Expanding the half-swing equations: R_1' = −s^(α+1), R_2' = (α−1) R_1 R_1' − s^(2α+1) c, and

    τ_1' = s^α c, τ_2' = (α−1) R_1 s^α c + s^(2α) c²; R_1(θ) = −½ B(sin²θ; (α+2)/2, 1/2), incomplete beta function.
    """
    quarter = swing(text, order=2)
    with mpmath.workdps(25):
        a = {"sqrt(2)": mpmath.sqrt(2)}.get(text) or mpmath.mpf(Fraction(text).numerator) / Fraction(text).denominator

        def r1(t: mpmath.mpf) -> mpmath.mpf:
            return -mpmath.betainc((a + 2) / 2, 0.5, 0, mpmath.sin(t) ** 2) / 2

        def second(t: mpmath.mpf) -> mpmath.mpf:
            s, c = mpmath.sin(t), mpmath.cos(t)
            return (a - 1) * r1(t) * s**a * c + s ** (2 * a) * c**2

        end = mpmath.pi / 2
        linear = -mpmath.quad(lambda t: mpmath.sin(t) ** (2 * a + 1) * mpmath.cos(t), [0, end])
        expected = [r1(end), (a - 1) * r1(end) ** 2 / 2 + linear, 1 / (a + 1), mpmath.quad(second, [0, end])]
        for ball, value in zip([quarter.R[1], quarter.R[2], quarter.T_q[1], quarter.T_q[2]], expected, strict=True):
            low, high = mp_bounds(ball)
            assert low - mpmath.mpf("1e-13") < value < high + mpmath.mpf("1e-13")
            assert high - low < mpmath.mpf("1e-35")


def integrated(laws: list[tuple[float, float]]) -> tuple[float, float, Callable[[float], list[float]]]:
    """R, T_q and the dense solution by DOP853 in θ: floats, an independent route for the tests only."""

    def slope(theta: float, state: list[float]) -> list[float]:
        s, c = sin(theta), cos(theta)
        n = sum(e * mpmath.e ** ((a - 1) * state[0]) * s**a for a, e in laws)
        return [-float(n) * s / (1 - float(n) * c), 1 / (1 - float(n) * c)]

    solution = solve_ivp(slope, (0, pi / 2), [0.0, 0.0], method="DOP853", rtol=1e-12, atol=1e-13, dense_output=True)
    return solution.y[0, -1], solution.y[1, -1], solution.sol


def value(series: Series, *deltas: float) -> float:
    total = 0.0
    for n, c in series.coefficients.items():
        low, high = bounds(c if isinstance(c, arb) else arb(c))
        term = float((low + high) / 2)
        for d, k in zip(deltas, n, strict=True):
            term *= d**k
        total += term
    return total


@pytest.mark.parametrize(
    "laws",
    [
        [("1/2", 0.08)],
        [("3/2", 0.15)],
        [("5/3", -0.1)],
        [("sqrt(2)", 0.15)],
        [("7", 0.05)],
        [("1/2", 0.04), ("5/3", 0.05)],
        [("0", 0.02), ("1", -0.05), ("5/2", 0.04)],
    ],
)
def test_series_against_an_integrator(laws: list[tuple[str, float]]) -> None:
    order = 14 if len(laws) == 1 else 12 - 2 * len(laws)
    quarter = swing(*(a for a, _ in laws), order=order, bits=100)
    deltas = [e for _, e in laws]
    numbers = [(2**0.5 if a == "sqrt(2)" else float(Fraction(a)), e) for a, e in laws]
    R, T, _ = integrated(numbers)
    assert value(quarter.R, *deltas) == pytest.approx(R, abs=3e-10)
    assert value(quarter.T_q, *deltas) == pytest.approx(T, abs=3e-10)
    # The orders beyond the second matter at this accuracy: a shorter series is seen to fail.
    assert abs(value(quarter.R.truncate(2), *deltas) - R) > 1e-7


def test_moments_without_friction_and_with_dry_friction() -> None:
    """K_k(0) = ∫ τ^k e^(−iτ) cos τ dτ, and K_k at α = 0 from X = δ + (1−δ) cos τ, both by quadrature."""
    quarter = swing("0", order=12, bits=120, moments=True)
    for delta, tolerance in ((0.0, 1e-14), (0.05, 1e-10)):
        end = float(mpmath.acos(-delta / (1 - delta)))
        for k in range(4):
            for part, factor in zip(quarter.K[k], (cos, lambda t: -sin(t)), strict=True):
                expected = quad(
                    lambda t, f=factor, k=k, d=delta: t**k * f(t) * (d + (1 - d) * cos(t)), 0, end, epsabs=1e-15
                )[0]
                assert value(part, delta) == pytest.approx(expected, abs=tolerance)


@pytest.mark.parametrize("laws", [[("3/2", 0.1)], [("sqrt(2)", -0.1)], [("1/2", 0.03), ("3", 0.05)]])
def test_moments_against_an_integrator(laws: list[tuple[str, float]]) -> None:
    quarter = swing(*(a for a, _ in laws), order=9 if len(laws) == 1 else 7, bits=120, moments=True)
    deltas = [e for _, e in laws]
    _, _, solution = integrated([(2**0.5 if a == "sqrt(2)" else float(Fraction(a)), e) for a, e in laws])
    a_e = [(2**0.5 if a == "sqrt(2)" else float(Fraction(a)), e) for a, e in laws]

    def integrand(theta: float, k: int, imaginary: bool) -> float:
        R, tau = solution(theta)
        n = sum(e * mpmath.e ** ((a - 1) * R) * sin(theta) ** a for a, e in a_e)
        factor = -sin(tau) if imaginary else cos(tau)
        return float(tau**k * factor * mpmath.e**R * cos(theta) / (1 - n * cos(theta)))

    for k in range(3):
        for imaginary in (False, True):
            expected = quad(integrand, 0, pi / 2, args=(k, imaginary), epsabs=1e-11)[0]
            assert value(quarter.K[k][imaginary], *deltas) == pytest.approx(expected, abs=2e-8)
            assert abs(value(quarter.K[k][imaginary].truncate(1), *deltas) - expected) > 1e-5


def test_each_moment_is_known_through_its_order() -> None:
    quarter = swing("3/2", order=5, moments=True)
    assert [part.order for pair in quarter.K for part in pair] == [n for k in range(6) for n in (5 - k, 5 - k)]
    assert swing("3/2", order=5).K == ()


@pytest.mark.parametrize("text", ["0", "3/2", "sqrt(2)", "7"])
def test_precisions_and_radii_overlap_and_are_narrow(text: str) -> None:
    """Different truncations and different bounds enclose the same numbers; more precision narrows the balls."""
    fine = swing(text, order=5, bits=400, moments=True)
    for options in ({"bits": 100}, {"bits": 100, "radius": 3}, {"bits": 130, "radius": 2}, {"bits": 100, "terms": 130}):
        coarse = swing(text, order=5, moments=True, **options)  # type: ignore[arg-type]
        rows = [(fine.R, coarse.R), (fine.T_q, coarse.T_q)]
        rows += [pair for a, b in zip(fine.K, coarse.K, strict=True) for pair in zip(a, b, strict=True)]
        for exact, ball in ((f[n], c[n]) for f, c in rows for n in c.coefficients):
            assert ball.contains(exact.mid())
            assert exact.rad() < arb(2) ** -390 * 100
            assert ball.rad() < arb(2) ** -80 * max(1, abs(ball).upper())


def test_equal_exponents_merge() -> None:
    """Two laws with one α are one law with δ_1 + δ_2: δ_1^i δ_2^j has C(i+j, i) times the coefficient of δ^(i+j)."""
    one, two = swing("5/3", order=5, moments=True), swing("5/3", "5/3", order=5, moments=True)
    rows = [(one.R, two.R), (one.T_q, two.T_q), (one.K[2][0], two.K[2][0]), (one.K[1][1], two.K[1][1])]
    for single, double in rows:
        for n, c in double.coefficients.items():
            if any(n):
                assert_contains_narrowly(c, single[sum(n)] * comb(sum(n), n[0]))


def test_a_missing_tail_bound_is_detected() -> None:
    """With few terms the truncated sums miss the truth; their enclosures do not: the tail bound is what saves them."""
    forces = Forces.losses(exponents("3/2"))
    fine = swing("3/2", order=4, bits=300, moments=True)
    truth = [fine.R, fine.T_q, *(part for pair in fine.K for part in pair)]
    with ctx.workprec(200):
        bound = tail_constants(forces, 4, 4, moments=True)
        for terms in (6, 12, 24):
            sums = truncated_sums(forces, 4, terms, moments=True)
            for right, naive, sure in zip(
                truth, sums, [enclose(s, b, 4, terms) for s, b in zip(sums, bound, strict=True)], strict=True
            ):
                for n in naive:
                    assert sure[n].contains(right[n])
                    assert not any(n) or not naive[n].overlaps(right[n])  # the planted fault is seen


@pytest.mark.parametrize("arguments", [([], 3), (["-1"], 3), (["2"], 0)])
def test_bad_input_is_refused_by_name(arguments: tuple[list[str], int]) -> None:
    texts, order = arguments
    with pytest.raises(InputError):
        quarter_swing(exponents(*texts), order)


def test_sizes_are_refused_before_the_work() -> None:
    with pytest.raises(LimitError, match="products of series"):
        quarter_swing(exponents("1/2", "3/2", "2"), 60)
    with pytest.raises(InputError, match="radius"):
        quarter_swing(exponents("2"), 3, radius=5)


@pytest.mark.parametrize(
    ("alphas", "order"), [((0,), 6), ((1,), 6), ((2,), 8), ((3,), 5), ((4,), 5), ((6,), 4), ((0, 2), 3), ((1, 2), 3)]
)
def test_exact_engine_is_contained(alphas: tuple[int, ...], order: int) -> None:
    """Integer exponents: each exact R, T_q and K_k lies in its ball, and a value 10^-20 beside it does not."""
    exact = exact_quarter_swing(alphas, order, moments=True)
    with ctx.workprec(160):
        balls = quarter_swing(exponents(*map(str, alphas)), order, moments=True)
        rows = [(exact.R, balls.R), (exact.T_q, balls.T_q)]
        rows += [pair for a, b in zip(exact.K, balls.K, strict=True) for pair in zip(a, b, strict=True)]
        for a, b in rows:
            assert a.order == b.order
            for n in {*a.coefficients, *b.coefficients}:
                truth = PiNumber.rational(0) + a[n]
                assert_contains_narrowly(arb(b[n]), truth.ball())
                assert not arb(b[n]).overlaps(truth.ball() + arb(10) ** -20)


@pytest.mark.parametrize("exponent", ["1/2", "3/2", "3"])
def test_the_bounds_of_the_first_order_are_attained_on_the_circle(exponent):
    """At theta = i pi, |t| = 4: g = pi sinh pi, c = cosh pi, y_1 = (sinh pi/pi)^alpha and
    e^(-i theta) c = (1 + e^(2 pi))/2; the factors of the moments by hand, each of them attained there."""
    a, pi = real(exponent).ball(), arb.pi()
    R, T, *K = tail_constants(Forces.losses([real(exponent)]), 2, 4, True)
    scale, y, last = (pi / 2) ** a, (pi.sinh() / pi) ** a, (1 + (2 * pi).exp()) / 2
    d, w = pi.cosh() * y, pi * pi.exp() * y / (a + 1)
    known = [(R[(1,)], scale * pi * pi.sinh() * y), (T[(1,)], scale * pi / 2 * pi.cosh() * y)]
    known += [(K[2 * k][(0,)], (pi / 2) ** (k + 1) * last) for k in range(3)]
    known += [(K[0][(1,)], scale * pi / 2 * last * (d + w))]
    known += [(K[2][(1,)], scale * (pi / 2) ** 2 * last * (d + w + d / (a + 1)))]
    for bound, value in known:
        assert value * (1 - arb(1e-12)) < bound < value * (1 + arb(1e-12))


def test_the_tail_of_a_power_series_is_that_of_its_bound():
    """Sum over k >= K of B r^-k/(2 k) at most, nearly attained by coefficients that are all as large as their bound."""
    for radius, terms in ((2, 50), (3, 20), (4, 9)):
        cut = enclose({(1,): arb(0)}, {(1,): arb(7)}, radius, terms)[(1,)].rad()
        whole = sum((7 * arb(radius) ** -k / (2 * k) for k in range(terms, 40 * terms)), arb(0))
        assert whole < cut < whole * arb("1.1")
    for bits in (8, 12, 40):
        terms = terms_needed([{(1,): arb(1)}], 4, bits)
        assert enclose({(1,): arb(0)}, {(1,): arb(1)}, 4, terms)[(1,)].rad() < arb(2) ** (-bits - 3)
