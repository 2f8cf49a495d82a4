from math import asinh, log

import mpmath
import pytest
from flint import arb, ctx
from hypothesis import given
from hypothesis import strategies as st

from asymptotics.turning import quadratic_duration
from asymptotics.turning.quadratic_duration import duration, elapsed
from asymptotics.turning.quadratic_map import next_amplitude
from asymptotics.turning.quadratic_series import half_period_series


def _quadrature(p: float, share: float = 1) -> mpmath.mpf:
    """The half period, or the time until chi = share pi, by mpmath: Smith (55) corrected, t = t* sin^2(phi), with the
    raw speed; only (43) in common."""
    with mpmath.workdps(40):
        p = mpmath.mpf(p)
        q = 1 + mpmath.re(mpmath.lambertw(-(1 + p) * mpmath.exp(-(1 + p))))

        def integrand(phi):
            t = (p + q) * mpmath.sin(phi) ** 2
            return (p + q) * mpmath.sin(2 * phi) / mpmath.sqrt(abs(2 * ((1 + p) * -mpmath.expm1(-t) - t)))

        return mpmath.quad(integrand, [0, share * mpmath.pi / 4, share * mpmath.pi / 2])


@pytest.mark.parametrize("p", [0.01, 0.5, 2, 10, 40])
def test_against_mpmath_quadrature(p):
    with ctx.workprec(160):
        ball = duration(arb(p), next_amplitude(arb(p)))
        assert abs(ball - arb(mpmath.nstr(_quadrature(p), 30))) < arb("1e-15")
        assert ball.rel_accuracy_bits() > 130


@given(st.fractions(min_value=1e-5, max_value=100), st.integers(60, 300))
def test_two_precisions_meet(q, bits):
    values = []
    for precision in (bits, bits + 150):
        with ctx.workprec(precision):
            p = arb(q.numerator) / q.denominator
            values.append(duration(p, next_amplitude(p)))
    assert values[0].overlaps(values[1])
    assert values[0].rel_accuracy_bits() > bits - 40


@pytest.mark.parametrize("q", ["0.001", "0.02", "0.05"])
def test_against_the_exact_power_series(q):
    # T(p) = pi sum t_k p^k; |T| < 5 on |p| = 1/4 (quadratic_abel), so the tail after p^60 is below 5 (4p)^61/(1-4p).
    with ctx.workprec(300):
        p = arb(q)
        total = arb.pi() * sum((arb(c) * p**k for k, c in enumerate(half_period_series(60))), arb(0))
        tail = 5 * (4 * p) ** 61 / (1 - 4 * p)
        ball = duration(p, next_amplitude(p))
        assert abs(ball - total) < tail + arb("1e-80")


def test_a_half_swing_lasts_as_long_seen_from_its_end():
    # T(p) = T(-q): the series at -q for p = 0.02.
    with ctx.workprec(200):
        p = arb("0.02")
        q = next_amplitude(p)
        total = arb.pi() * sum((arb(c) * (-q) ** k for k, c in enumerate(half_period_series(40))), arb(0))
        assert abs(total - duration(p, q)) < arb("1e-40")


@pytest.mark.parametrize("terms", [1, 2, 3, 4])
def test_the_large_amplitude_expansion_has_the_measured_order(terms):
    errors = []
    with ctx.workprec(200):
        for y in (400, 800):
            exact = duration(arb(y - 1), next_amplitude(arb(y - 1)))
            tail = [_coefficient(k) * arb(y) ** (-k) for k in range(terms)]
            errors.append(abs(exact - (arb(2) * y).sqrt() - sum(tail, arb(0)) * (arb(2) / y).sqrt()))
        order = (errors[0] / errors[1]).log() / arb(2).log()
    assert abs(order - terms - 0.5) < 0.06


def _coefficient(k: int) -> arb:
    """a_k of the theory page, finite_strength: C(2k, k) 4^-k/2 int_0^inf t^k ((1 - e^-t)^(-k-1/2) - 1) dt."""
    with mpmath.workdps(25):
        moment = mpmath.quad(
            lambda t: t**k * mpmath.expm1(-(k + 0.5) * mpmath.log(-mpmath.expm1(-t))), [0, 1, mpmath.inf]
        )
        return arb(mpmath.nstr(mpmath.binomial(2 * k, k) * moment / 4**k / 2, 20))


@pytest.mark.parametrize("p", [0.5, 40])
def test_a_part_of_the_half_period_against_mpmath_quadrature(p):
    """Of the waves of another sample, or of one fewer, no other test of this file would know."""
    with ctx.workprec(90):
        part = elapsed(arb(p), next_amplitude(arb(p)), arb.pi() / 4)
        assert abs(part - arb(mpmath.nstr(_quadrature(p, 0.25), 25))) < arb("1e-15")
        assert part.rel_accuracy_bits() > 70


def test_elapsed_time_is_additive_and_ends_at_the_half_period():
    with ctx.workprec(120):
        p = arb(2)
        q = next_amplitude(p)
        assert elapsed(p, q, arb(0)).contains(0)
        assert elapsed(p, q, arb.pi()).overlaps(duration(p, q))
        assert elapsed(p, q, arb(1)) < elapsed(p, q, arb(2))


@pytest.mark.parametrize("t_end", [0.01, 2.8, 31.0])
@pytest.mark.parametrize("bits", [53, 300])
def test_the_nodes_are_the_fewest_for_the_bits(t_end, bits):
    # e^(-a N) <= e^(-a-6) 2^-bits with an even N, and not with N - 2.
    a, N = asinh(3 / t_end), quadratic_duration.node_count(t_end, bits)
    assert N % 2 == 0 and a * (N - 2) < bits * log(2) + 6 + a <= a * N


def _theorem(p: arb, q: arb, nodes: int) -> tuple[arb, arb]:
    """The last lines of the derivation quadratic-trapezoid with b = 3/2, in floating point."""
    with mpmath.workdps(40):
        start, end = (mpmath.mpmathify(x.mid().str(40, radius=False)) for x in (p, p + q))
        a = mpmath.asinh(3 / end)
        last = end / 2 * (1 + mpmath.cosh(a))
        slope = (mpmath.expm1(-end) / end - mpmath.expm1(-last) / last) / (end - last)
        M = 1 / mpmath.sqrt(mpmath.cos(1.5) * (1 + start) / 2 * slope)
        z = mpmath.exp(-a)
        aliases = 2 / ((1 / z - 1) * (1 - z ** (2 * nodes)))  # m = nodes: a part is sampled twice as often
        whole, part = mpmath.pi * M / (z**-nodes - 1), mpmath.pi * M * z**nodes * (1 / (1 - z) + aliases)
        return arb(mpmath.nstr(whole, 20)), arb(mpmath.nstr(part, 20))


@pytest.mark.parametrize("size", ["0.01", "2", "30"])
def test_fewer_nodes_and_nothing_else(monkeypatch, size):
    """The enclosure widens and still holds: half the nodes do in truth, for the integrand is analytic further out than
    where it is bounded, a twelfth do not, and the bound that belongs to all nodes would not cover their error."""
    with ctx.workprec(200):
        p = arb(size)
        q = next_amplitude(p)
        truth, nodes = duration(p, q), quadratic_duration.node_count(float((p + q).mid()), 200)
        assert truth.rad() < arb(2) ** -180
        for share in (2, 12):
            monkeypatch.setattr(quadratic_duration, "node_count", lambda *_, n=nodes // share // 2 * 2: n)
            fewer = duration(p, q)
            assert fewer.contains(truth.mid())
            in_parts = elapsed(p, q, arb.pi())
            assert in_parts.contains(truth.mid())
            whole, part = _theorem(p, q, nodes // share // 2 * 2)
            assert whole <= fewer.rad() < whole * 1.001 + truth.rad()
            assert part <= in_parts.rad() < part * 1.001 + truth.rad()
        assert abs(fewer.mid() - truth) > 1000 * truth.rad()
