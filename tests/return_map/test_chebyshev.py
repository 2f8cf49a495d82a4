"""Interpolation at Chebyshev points: each part of its error is attained, so half of it would be refuted."""

import pytest
from flint import arb, arb_poly, ctx, fmpz_poly

from asymptotics.return_map.chebyshev import coefficients, cut, interpolant, nodes


def T(k, t):
    return arb_poly(fmpz_poly.chebyshev_t(k))(t)


def size_on_ellipse(k, R):
    """max |T_k| on the ellipse: (R^k + R^-k)/2, at the ends of the long axis."""
    return (R**k + R**-k) / 2


@pytest.mark.parametrize("R", [4, 10, 100])
@pytest.mark.parametrize("m", [1, 2, 7])
def test_the_cut_is_attained_by_the_first_polynomial_left_out(m, R):
    """T_m vanishes at all m nodes: the interpolant is 0, and the error is 1 at t = 1."""
    values = [T(m, t) for t in nodes(m)]
    found = interpolant(values, size_on_ellipse(m, arb(R)), arb(R), arb(0))
    assert abs(found.polynomial(arb(1))) < 1e-10
    assert found.error >= 1 and found.error / 2 < 1
    assert cut(size_on_ellipse(m, arb(R)), arb(R), m + 1) < 1  # a node less than there are


@pytest.mark.parametrize("k", range(6, 40, 3))
def test_every_polynomial_beyond_is_within_the_cut(k):
    """Aliases of T_k, k > m, on few nodes; the ellipse bounds T_k itself."""
    R, m = arb(3), 5
    with ctx.workprec(200):
        found = interpolant([T(k, t) for t in nodes(m)], size_on_ellipse(k, R), R, arb(0))
        for j in range(21):
            t = arb(j - 10) / 10
            assert found(t).contains(T(k, t).mid())
        aliased = [abs(c).mid() for c in coefficients([T(k, t) for t in nodes(m)])]
    assert sum(c > 1e-9 for c in aliased) <= 1 and all(c < arb("1.0000001") for c in aliased)


@pytest.mark.parametrize("m", [1, 2])
def test_the_noise_is_attained_on_few_nodes(m):
    """Values off by e with the signs of the Lebesgue function at t = 1: e for one node, sqrt(2) e for two."""
    e = arb(2) ** -20
    values = [t + arb(0, e) for t in nodes(m)]
    found = interpolant(values, arb(0), arb(2), arb(0))
    worst = e if m == 1 else e * arb(2).sqrt()
    assert found.error >= worst * arb("0.9999") and found.error / 2 < worst
    for signs in ((1, 1), (1, -1), (-1, 1)):
        off = [(t.mid() + s * e).mid() for t, s in zip(nodes(m), signs, strict=False)]
        other = interpolant(off, arb(0), arb(2), arb(0))
        for end in (-1, 1):
            assert found(arb(end)).contains(other.polynomial(arb(end)).mid())


@pytest.mark.parametrize("m", [2, 8, 30])
def test_the_noise_of_the_coefficients_left_out_counts_too(m):
    """All midpoints are 0, so nothing is kept; the Lebesgue function at t = 1 is attained within the radii."""
    e = arb(2) ** -20
    signs = [(-1) ** j for j in range(m)]
    with ctx.workprec(100):
        found = interpolant([arb(0, e) for _ in range(m)], arb(0), arb(2), arb(1))
        other = sum(coefficients([s * e for s in signs]), arb(0))
    assert found.degree <= 0 and abs(other) > e * arb("1.4")
    assert found(arb(1)).contains(other.mid())


@pytest.mark.parametrize("tolerance", ["1e-3", "1e-8", "1e-15"])
def test_the_coefficients_left_out_are_paid_for(tolerance):
    with ctx.workprec(120):
        found = interpolant([(3 * t).exp() for t in nodes(40)], arb(10) ** 9, arb(20), arb(tolerance))
        gaps = [abs(found.polynomial(arb(j) / 20) - (arb(3 * j) / 20).exp()) for j in range(-20, 21)]
        worst = max(gaps, key=float)
        assert worst <= found.error and found.error / 2 < worst and found.error <= arb(tolerance) * arb("1.01")
        assert found.degree < 30


@pytest.mark.parametrize("bits", [10, 20, 53, 120])
def test_rounded_coefficients_are_paid_for(bits):
    """A ladder of precisions: the function at 300 bits is contained, and the radius is that of the precision."""
    with ctx.workprec(bits + 20):
        values = [1 / (3 + t) + arb(0, arb(2) ** -bits) for t in nodes(60)]
        found = interpolant(values, arb(10), arb(5), arb(2) ** -bits)
    with ctx.workprec(300):
        for j in range(-10, 11):
            t = arb(j) / 10
            assert found(t).contains((1 / (3 + t)).mid())
        assert found.error < arb(2) ** (5 - bits)


def test_the_coefficients_are_those_of_the_polynomial():
    with ctx.workprec(80):
        found = coefficients([2 * T(0, t) - 3 * T(1, t) + T(4, t) / 7 for t in nodes(6)])
        for value, wanted in zip(found, [arb(2), arb(-3), arb(0), arb(0), arb(1) / 7, arb(0)], strict=True):
            assert abs(value - wanted) < 1e-20


@pytest.mark.parametrize("R", [1.5, 2, 4])
def test_the_cut_is_attained_with_its_aliases(R):
    """f = 2 sum_(k>=m) R^-k T_k, Cauchy's worst: at t = 1 every term and its alias add up."""
    m, last = 6, 12
    with ctx.workprec(100):
        weights = {k: 2 * arb(R) ** -k for k in range(m, last)}
        found = coefficients([sum((c * T(k, t) for k, c in weights.items()), arb(0)) for t in nodes(m)])
        error = abs(sum(weights.values(), arb(0)) - sum(found, arb(0)))
        rest = 4 * arb(R) ** -last * R / (R - 1)
        bound = cut(arb(1), arb(R), m)
        assert error <= bound and bound < (error + rest) * arb("1.001")


@pytest.mark.parametrize("bits", [12, 20, 40])
def test_rounding_is_counted_twice_over(bits):
    """The radii of the coefficients, and what is lost where the powers' coefficients are rounded: nothing else here."""
    with ctx.workprec(bits):
        values = [(1 / (arb("1.5") + t)).mid() for t in nodes(12)]
        found = interpolant(values, arb(2) ** -200, arb(2) ** 60, arb(0))
        kept = coefficients(values)
    with ctx.workprec(400):
        exact, grid = coefficients(values), [arb(j) / 8 for j in range(-8, 9)]
        sums = [sum((c * T(k, t) for k, c in enumerate(exact)), arb(0)) for t in grid]
        worst = max((abs(found.polynomial(t) - value) for t, value in zip(grid, sums)), key=float)
        powers = sum((arb_poly(fmpz_poly.chebyshev_t(k)) * c.mid() for k, c in enumerate(kept)), arb_poly([]))
        lost = sum((abs(a - b) for a, b in zip(powers.coeffs(), found.polynomial.coeffs())), arb(0))
        radii = sum((c.rad() for c in kept), arb(0))
    assert worst <= found.error and min(lost, radii) > 0
    assert (lost + radii) * arb("0.999") <= found.error and found.error <= (lost + radii) * arb("1.001")
