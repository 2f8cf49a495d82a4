"""Products and compositions of power series, on a line and on a simplex, against polynomials and mpmath."""

import mpmath
import pytest
from flint import arb

from asymptotics.flow.composition import ComposedSeries, ExponentLine, Simplex


def test_products_on_a_simplex_are_those_of_polynomials():
    grid = Simplex((2, 3), 30)
    a, b = ([arb(k * s % 7 - 3) for k in range(len(grid.keys))] for s in (5, 11))
    for k, key in enumerate(grid.keys):
        direct = sum(
            a[i] * b[j] for i, f in enumerate(grid.keys) for j, g in enumerate(grid.keys)
            if tuple(map(sum, zip(f, g))) == key
        )  # fmt: skip
        assert grid.product(a[: k + 1], b[: k + 1]) == direct
        assert grid.product_from_1(a[: k + 1], b[:k]) == direct - a[0] * b[k]


def test_curves_on_a_line_are_power_series():
    curve = ComposedSeries(ExponentLine(()), arb(2), {0, 5}, arb("0.5"))
    for k in range(1, 6):
        curve.append(arb(1) / k)
    with mpmath.workdps(30):
        u = [mpmath.mpf(1) / 2, *(mpmath.mpf(1) / k for k in range(1, 6))]

        def f(t):
            return mpmath.polyval(u[::-1], t)

        for series, g in ((curve.power[5], lambda t: f(t) ** 5), (curve.sine, lambda t: mpmath.sin(2 * f(t)))):
            for found, value in zip(series, mpmath.taylor(g, 0, 5)):
                assert float(found) == pytest.approx(float(value), rel=1e-10)
