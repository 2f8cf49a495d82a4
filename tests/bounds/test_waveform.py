"""Enclosures of the waveform: they hold a quadrature of another kind with few pieces, and half of each does not."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from flint import acb, arb, ctx

from asymptotics.bounds.local import multinomial
from asymptotics.bounds.waveform import _modulus, _Pieces, _size, _Waveform, waveform_bounds
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.motions.waveform import waveform_at
from asymptotics.numbers.exact import parse_real
from asymptotics.series import Series

BITS = 80


def reals(*texts):
    return tuple(parse_real(t, "alpha") for t in texts)


def quadrature(waveform, psi):
    """(P_n, Q_n) at psi, by Chebyshev panels in ln psi: heuristic, some twenty digits."""
    forces = Forces.losses(waveform.alphas)
    return waveform_at(waveform.true, forces, psi, waveform.order + 1)


LADDER = [("2",), ("1/2",), ("0",), ("sqrt(2)",), ("1", "2")]


@pytest.mark.parametrize("alphas", LADDER)
@pytest.mark.parametrize("count", [2, 8, 64])
def test_few_wide_pieces_hold_the_waveform(alphas, count):
    with ctx.workprec(BITS):
        waveform = _Waveform.of(reals(*alphas), 2, count)
        for piece in {0, 1, count - 1}:
            for place in ("1e-6", "999999/1000000"):
                psi = (arb.pi() / (2 * count) * (piece + arb(parse_real(place, "place").ball()))).mid()
                s, c = psi.sin(), psi.cos()
                for key, (p, q) in quadrature(waveform, psi).items():
                    slack = arb(0, 1e-14)
                    P, Q, g = (part[sum(key)][key][piece] for part in (waveform.P, waveform.Q, waveform.g))
                    assert (P + slack).contains(p)
                    assert (Q + slack).contains(q)
                    assert (g + slack).contains(p + c / s * q)
                    assert P.rad() < 80 / arb(count)


def test_the_hull_of_an_integral_is_attained_at_the_ends_of_a_piece():
    """f = 1: int_0^psi f = psi fills its hull; f = cos: the mean sin(psi)/psi nearly reaches the end of its hull."""
    with ctx.workprec(BITS):
        pieces = _Pieces.of(2)
        whole, mean = pieces.integrate(np.array([arb(1), arb(1)], dtype=object))
        for k in (0, 1):
            low, high = arb.pi() / 4 * k, arb.pi() / 4 * (k + 1)
            assert abs(whole[k].lower() - low) < 1e-8
            assert abs(whole[k].upper() - high) < 1e-8
            assert mean[k].contains(1)
        exact = np.array([arb(1), arb(0)], dtype=object)  # a step: mean 1/2 at psi = pi/2
        _, mean = pieces.integrate(exact)
        assert abs(mean[1].lower() - arb(1) / 2) < 1e-8
        assert abs(mean[1].upper() - 1) < 1e-8


def test_the_pieces_are_hulls_of_their_functions():
    with ctx.workprec(BITS):
        pieces, powers = _Pieces.of(4), {}
        for a in ("0", "1/3", "5/2"):
            powers[a] = pieces.power(parse_real(a, "alpha"))
        for k in range(4):
            for place in (1e-9, 0.5, 1 - 1e-9):
                psi = arb.pi() / 8 * (k + arb(place))
                assert pieces.s[k].contains(psi.sin())
                assert pieces.c[k].contains(psi.cos())
                assert pieces.psi_cot[k].contains(psi * psi.cot())
                for a, power in powers.items():
                    assert power[k].contains(psi.sin() ** parse_real(a, "alpha").ball())
            edge = arb.pi() / 8 * (k + 1)
            assert abs(pieces.s[k].upper() - edge.sin()) < 1e-8
            assert abs(pieces.psi_cot[k].lower() - edge * edge.cos() / edge.sin()) < 1e-8


def residual(waveform, psi, delta, h=1e-6):
    """R of one law at one psi by its definition, Z by quadrature, Z' by differences."""
    order, alpha = waveform.order, waveform.alphas[0].ball()
    p, Omega = (f.truncate(order) for f in (waveform.true.p, waveform.true.Omega))

    def total(found):
        return 1 + sum((acb(*found[k]) * delta ** k[0] for k in found), acb(0))

    found = quadrature(waveform, psi)
    W = 1 / (1 + Omega.without_constant().at((delta,)))
    U = -p.at((delta,)) * W
    value = total(found)
    slope = (total(quadrature(waveform, psi + h)) - total(quadrature(waveform, psi - h))) / (2 * h)
    stretched = sum((acb(*z) * k[0] * (alpha - 1) * delta ** k[0] for k, z in found.items()), acb(0))
    s, c = psi.sin(), psi.cos()
    g = value.real + c / s * value.imag
    F = delta * (s * g) ** alpha
    return slope - (acb(0, 1) * (W - 1) * value - U * (value + stretched) - acb(0, 1) * W * F * acb(c, -s))


# exponent, order, delta: bounds of |R| that are nearly attained
RESIDUALS = [
    ("2", 1, "1/4", 1.35),
    ("2", 2, "1/5", 1.6),
    pytest.param("3/2", 3, "1/4", 1.9, marks=pytest.mark.slow),
    ("1/2", 1, "1/4", 1.5),
    pytest.param("3", 2, "1/10", 1.4, marks=pytest.mark.slow),
]


@pytest.mark.parametrize(("alpha", "order", "delta", "slack"), RESIDUALS)
def test_what_is_left_over_is_bounded_and_nearly_attained(alpha, order, delta, slack):
    with ctx.workprec(BITS):
        d = arb(parse_real(delta, "delta").ball())
        waveform = _Waveform.of(reals(alpha), order, 4096)
        bound = waveform.bounds().residual(d)
        seen = max(abs(residual(waveform, arb.pi() * k / 12, d)).upper() for k in range(1, 6))
        assert seen < bound * (1 + arb("1e-4"))
        assert bound < slack * seen


@pytest.mark.parametrize(("alphas", "order"), [(("2",), 3), (("1", "2"), 2), (("1/2",), 2)])
def test_the_degree_of_the_residual_that_is_secular(alphas, order):
    """R of degree N + 1 is i Omega_(N+1) or p_(N+1), up to products with lower degrees, which order N has too."""
    waveform = _Waveform.of(reals(*alphas), order, 8)
    p, Omega = waveform.true.p, waveform.true.Omega
    missing = [float(abs(arb(p[k]) if order % 2 == 0 else arb(Omega[k]))) for k in _keys(len(alphas), order + 1)]
    sizes = [m / multinomial(k) for m, k in zip(missing, _keys(len(alphas), order + 1))]
    assert float(waveform.bounds().residual.coefficients[0]) == pytest.approx(max(sizes), rel=1e-9)


def _keys(variables, degree):
    return [(degree,)] if variables == 1 else [(k, degree - k) for k in range(degree + 1)]


@pytest.mark.parametrize("alpha", ["2", "1/2"])
def test_cauchy_takes_over_where_the_computed_degrees_end(alpha):
    """M, from the moduli of the waveform by quadrature: |W - 1| |Z| + |U| (|Z| + |D Z|) + |W| rho (1 + g^)^alpha."""
    with ctx.workprec(BITS):
        waveform = _Waveform.of(reals(alpha), 2, 4096)
        found = waveform.bounds().residual
        rho, a = found.radius, waveform.alphas[0].ball()
        rows = [quadrature(waveform, arb.pi() * k / 64) for k in range(4, 32, 4)]
        psi = [arb.pi() * k / 64 for k in range(4, 32, 4)]
        size = [max(abs(acb(*row[(n,)])) for row in rows) for n in (1, 2, 3)]
        growth = sum(max(abs(r[(n,)][0] + x.cot() * r[(n,)][1]) for r, x in zip(rows, psi)) * rho**n for n in (1, 2, 3))
        Z = 1 + sum(z * rho ** (n + 1) for n, z in enumerate(size))
        weighted = 1 + sum(abs(1 + (n + 1) * (a - 1)) * z * rho ** (n + 1) for n, z in enumerate(size))
        W = 1 / (1 - abs(arb(waveform.true.Omega[2])) * rho**2)
        M = (W - 1) * Z + abs(arb(waveform.true.p[1])) * rho * W * weighted + W * rho * (1 + growth) ** a
        assert growth < arb("0.51")
        assert M * arb("0.98") < found.cauchy < M * arb("1.02")


def test_the_sizes_are_those_of_closed_forms():
    """alpha = 2: Im Z_1 = -sin^3/3, and the displacement attains 1/3 at pi/2; alpha = 0: nothing but Z_1."""
    drag, friction = waveform_bounds(reals("2"), 1), waveform_bounds(reals("0"), 1)
    assert 0 <= float(drag.displacements[1]) - 1 / 3 < 2e-3
    assert float(friction.sizes[1]) == pytest.approx(1, abs=1e-2)
    assert float(friction.sizes[2]) < 1e-20


def test_the_largest_is_chosen_in_balls_not_in_doubles():
    """1 and 1 + 2^-70 are one double."""
    with ctx.workprec(BITS):
        one, more = arb(1), 1 + arb(2) ** -70
        assert _size({(0, 1): one, (1, 0): more}) >= more
        assert _modulus(np.array([one, more], dtype=object), np.array([one * 0, one * 0], dtype=object)) >= more


@pytest.mark.parametrize("alpha", ["2", "1/2"])
def test_how_fast_the_waveform_turns_is_attained(alpha):
    """|Z_k' + i Z_k|, the slope by differences of a quadrature."""
    h = 1e-6
    with ctx.workprec(BITS):
        waveform = _Waveform.of(reals(alpha), 2, 512)
        rows = [[quadrature(waveform, arb.pi() * j / 24 + step) for step in (-h, 0, h)] for j in range(1, 12)]
        for k, bound in enumerate(waveform.bounds().turns):
            if k:
                slopes = [(acb(*b[(k,)]) - acb(*a[(k,)])) / (2 * h) + acb(0, 1) * acb(*m[(k,)]) for a, m, b in rows]
                seen = max(float(abs(s)) for s in slopes)
                assert seen < float(bound) < 1.5 * seen


def test_the_circle_of_cauchy_keeps_away_from_zeros():
    """g = 1 + 3 delta and 1 + Omega = 1 + 3 delta vanish at delta = -1/3: each alone keeps rho below 1/6."""
    with ctx.workprec(BITS):
        waveform = _Waveform.of(reals("2"), 2, 2)
        rates = SimpleNamespace(p=Series({(1,): arb(1)}, 1, 2), Omega=Series({}, 1, 2))
        flat = [{(0,): waveform.pieces.s * 0 + 1}]
        plain = replace(waveform, g=flat, true=rates)
        assert plain._cauchy()[1] == 1
        steep = replace(plain, g=[*flat, {(1,): flat[0][(0,)] * 3}])
        fast = replace(plain, true=SimpleNamespace(p=rates.p, Omega=Series({(1,): arb(3)}, 1, 2)))
        for changed in (steep, fast):
            assert arb(1) / 7 < changed._cauchy()[1] < arb(1) / 6
