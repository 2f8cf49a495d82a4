"""The coordinate in which all strengths of a law are one variable, and its radii on an ellipse."""

import numpy as np
import pytest
from flint import arb

from asymptotics.numbers.exact import parse_real
from tests.return_map.laws import coordinate
from tests.worlds import WORLDS


def test_below_exponent_1_no_quarters_are_put_together():
    """There the equation for the end need not grow with it."""
    assert not coordinate(
        (
            ("0.9999999999", "1/2"),
            ("1.0000000001", "1/2"),
        )
    ).is_quartered
    assert not coordinate(
        (
            ("1/2", "1/10"),
            ("2", "1/10"),
        )
    ).is_quartered


def test_an_ellipse_that_may_lie_on_the_other_side_of_zero_has_no_majorant():
    falls = coordinate((("2", "1/10"),))
    assert falls.bounds(arb(0), arb("0.1")) is not None and falls.bounds(arb("-0.01"), arb("0.1")) is None
    assert falls.is_quartered and not coordinate((("1", "1/10"),)).is_quartered


@pytest.mark.parametrize(
    ("exponents", "root", "powers"),
    [
        (("3/2",), "1/2", ("1",)),
        (("1/2",), "-1/2", ("1",)),
        (("sqrt(2)",), "sqrt(2)", ("1",)),
        (("1",), "1", ("0",)),
        (("1", "2"), "1", ("0", "1")),
        (("2", "5/2", "1"), "1/2", ("2", "3", "0")),
        (("1/2", "1/4"), "-1/4", ("2", "3")),
        (("0", "2"), None, ("-1", "1")),
        (("sqrt(2)", "2"), None, ("sqrt(2)", "1")),
        (("1.01", "2"), None, ("0.01", "1")),
    ],
)
def test_the_coordinate_of_a_law(exponents, root, powers):
    found = coordinate(tuple((a, "1/10") for a in exponents))
    for value, text in zip((found.root, *found.powers), (root, *powers), strict=True):
        wanted = None if text is None else parse_real(text, "w").ball()
        if text is not None and text.startswith("sqrt"):
            wanted = wanted - 1
        assert (value is None) == (text is None) and (text is None or abs(value - wanted) < 1e-12)


@pytest.mark.parametrize(
    ("name", "middle", "half"),
    [("a sum of powers", 0.25, 0.6), ("three weak powers", -1.0, 0.9), ("a sum with an irrational power", -1, 0.5)],
)
def test_the_radii_hold_on_the_ellipse_and_no_less(name, middle, half):
    """|delta_i| at points of the ellipse, in complex doubles: the largest is the radius."""
    c = coordinate(WORLDS[name].pairs)
    bound = c.bounds(arb(middle), arb(half))
    angles = np.linspace(0, 2 * np.pi, 721)
    z = middle + half * np.cos(angles) + 1j * 0.8 * half * np.sin(angles)
    for radius, e, k in zip(bound.radii, c.epsilons, c.powers, strict=True):
        sizes = abs(float(e) * (np.exp(float(k) * z) if c.root is None else z ** float(k)))
        assert max(sizes) <= float(radius) * (1 + 1e-12) and float(radius) <= max(sizes) * (1 + 1e-9)


def test_a_disc_below_zero_is_no_polydisc():
    """|z| <= c + a holds for c >= 0 only: about a negative centre the far end is the other one."""
    z = coordinate((("2", "1/10"),))
    assert z.bounds(arb(-1), arb("0.5")) is None
    found = z.bounds(arb(1), arb("0.5"))
    assert found is not None and arb("0.15") <= found.radii[0] * arb("1.000001") and found.radii[0] < arb("0.151")
