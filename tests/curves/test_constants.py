"""S and T by name, at points of a motion made by the integrator: constant along a half-swing, and not beyond."""

import json
from fractions import Fraction

import mpmath
import pytest
from flint import arb

import asymptotics as asy
from asymptotics.errors import LimitError
from asymptotics.shell.main import main

U0 = "1/3"


@pytest.fixture(scope="module")
def orbit():
    """(tau, u, w) of the motion that starts at rest at u = 1/3, by the reference motion."""
    motion = asy.reference({2: U0})
    points = [motion.at(tau, digits=25) for tau in ("7/10", "2", "4")]
    return [("7/10", *_scaled(points[0])), ("2", *_scaled(points[1])), ("4", *_scaled(points[2]))]


def _scaled(point):
    return tuple(str(Fraction(text) / 3) for text in (point.x, point.v))


def near(a, b):
    return abs(float(arb(a) - arb(b)))


def test_they_are_the_same_all_along_a_half_swing_and_not_beyond(orbit):
    (t1, *one), (t2, *two), (t3, *three) = orbit  # the third is past the next turning point
    start = asy.S(U0, 0, digits=20).value
    assert near(asy.S(*one, digits=20).value, start) < 1e-17 and near(asy.S(*two, digits=20).value, start) < 1e-17
    assert near(asy.S(*three, digits=20).value, start) > 1e-3
    for tau, *point in ((t1, *one), (t2, *two)):
        assert near(asy.T(*point, tau, digits=10).value, 0) < 1e-9
        assert near(asy.T(*point, digits=10).value, str(-float(Fraction(tau)))) < 1e-9
    next_point = asy.turning_points({2: U0}, 2, digits=15, times=True).points[1]
    assert near(asy.T(*three, t3, digits=12).value, next_point.tau) < 1e-10
    assert near(asy.T(*three, t3, digits=12).value, "3.1") > 1e-2


def test_a_turning_point_belongs_to_the_half_swing_that_it_starts():
    right, left = asy.turning_points({2: U0}, 2, digits=20).points
    u = str(Fraction(left.x) / 3)
    assert asy.S(U0, 0) == asy.S("-1/3", 0) != asy.S(u, 0)
    assert asy.T(u, 0, "7/2", digits=5).value == "3.5000"
    with pytest.raises(asy.InputError, match="S >= 0"):
        asy.T(0, 1)


def test_exact_values_and_a_tie():
    assert asy.S(0, "sqrt(1/2)").value == "0"
    assert asy.S(0, "1/2", digits=2).value == "-0.12"  # -1/8, and ties go to the even digit
    assert asy.S(0, "1/2", digits=3).value == "-0.125"


def test_a_level_next_to_that_of_no_turning_point_is_told_by_more_bits(capsys):
    u = "0.249999999999"
    assert main(["smith", "t", "--u", u, "--w", "1/2", "--digits", "1"]) == 0
    shown = capsys.readouterr().out
    with mpmath.workdps(50):  # the mirrored point, from the turning point c down, where w^2 = r + 1/2 + 2 S e^(2 r)
        low = -mpmath.mpf(u)
        level = mpmath.exp(-2 * low) * (mpmath.mpf(1) / 2 - 2 * low - 1)  # 4 S = -2e-12 e^(1/2)
        top = (-1 - mpmath.lambertw(level / mpmath.e, -1).real) / 2
        time = mpmath.quad(lambda r: 1 / mpmath.sqrt(r + 0.5 + level * mpmath.exp(2 * r) / 2), [low, top - 5, top])
    assert shown.split()[:2] == ["T", str(-round(float(time)))]


def test_the_command_line_has_the_same(capsys):
    for line, value in (
        ("s --u 1/4 --w -1/4", asy.S("1/4", "-1/4").value),
        ("t --u 1/4 --w -1/4 --tau 3", asy.T("1/4", "-1/4", 3).value),
    ):
        assert main(["smith", *line.split(), "--json"]) == 0
        assert json.loads(capsys.readouterr().out)["value"] == value
    assert main(["smith", "r", "--w", "1/2", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert (found["R"], found["rho"]) == tuple(c.value for c in asy.radii("1/2"))
    assert main(["smith", "s", "--u", "1", "--w", "0", "--tau", "3"]) == 2
    assert "--tau: smith s does not use it" in capsys.readouterr().err


def test_what_next_to_a_turning_point_takes_too_long_is_refused_before_it_begins():
    assert asy.T("-1/4", "1e-60", digits=10).value == "-4.000000000e-60"
    for w, digits, argument in ((5e-324, 10, "w"), ("-1/4", 1000, "digits")):
        with pytest.raises(LimitError, match=f"argument {argument}: .* would take about"):
            asy.T("-1/4", w, digits=digits)
