"""Exact numbers are rounded as what they are: zeros and ties between two decimals, which no ball can tell."""

import re
from fractions import Fraction
from random import Random

import pytest
from mpmath import mpf
from numpy import cos, pi, sin, sqrt
from numpy.polynomial.legendre import leggauss

import asymptotics as asy
from asymptotics.ask.questions.turning_points import turning_points
from asymptotics.envelopes.first_order import exact_kappa
from asymptotics.errors import UndecidedError
from asymptotics.flow.wells.rational_stops import rational_stops
from asymptotics.law import Law, Oscillator
from asymptotics.motions.coulomb import coulomb_motion, coulomb_stop, exact_turning_points
from asymptotics.motions.reference import reference_motion
from asymptotics.numbers.decimals import certified_decimal, rational_decimal
from asymptotics.numbers.exact import ExactReal, parse_real
from tests.each import each

TIE = "0.0125"  # to two digits: 0.012, to the even digit


def test_a_tie_is_told_as_an_exact_number_only():
    exact = ExactReal(Fraction(TIE))
    assert certified_decimal(lambda: exact, 2) == "0.012" and certified_decimal(lambda: ExactReal(0), 5) == "0"
    with pytest.raises(UndecidedError):
        certified_decimal(exact.ball, 2, max_bits=4000)


@each("law", [{"0": "1/800"}, {"1": "1/10"}, {"2": "1/10"}, {"3/2": "1"}, {"0": "1/900", "2": "1"}])
@each("spring", [None, {3: 1}])
def test_every_start_is_rounded(law, spring):
    mass = Oscillator(law, x0=TIE, spring=spring)
    assert reference_motion(mass, 0, 2).x == "0.012"
    assert turning_points(mass, 1, digits=2).points[0].x == "0.012"
    if spring is None:
        assert asy.envelope(mass).amplitude(0, digits=2) == "0.012"


@each("seed", range(40))
def test_dry_friction_in_metres_is_decided_in_rationals(seed):
    """x_n = s (-1)^n (|x0| - 2 n b/k) as fractions, ties and zeros among them, to two digits."""
    rng = Random(seed)
    b, k, m = (Fraction(rng.randint(1, 20), rng.choice([1, 2, 4, 5, 8])) for _ in range(3))
    x0 = rng.choice([1, -1]) * rng.randint(1, 30) * b / k / 2
    mass = Oscillator(Law({0: b}), mass=m, stiffness=k, x0=x0)
    found = turning_points(mass, 40, digits=2)
    side, c, n, wanted = (1 if x0 > 0 else -1), b / k, 0, []
    while True:
        here = abs(x0) - 2 * n * c
        wanted.append(rational_decimal(side * (-1) ** n * here, 2))
        if here <= c:
            break
        n += 1
    assert [p.x for p in found.points] == wanted and found.ended == {"n": n, "reason": "sticks"}
    stop = coulomb_stop(mass, 2)
    assert (stop.x, stop.half_swings) == (wanted[-1], n)
    assert coulomb_motion(mass, "1e6", 2).x == wanted[-1]
    place = exact_turning_points(mass)
    assert place is not None and place(n).rational == side * (-1) ** n * here


def test_roots_are_places_too():
    mass = Oscillator(Law({0: 1}), stiffness=2, x0="sqrt(2)")
    assert [p.x for p in turning_points(mass, 2, digits=3).points] == ["1.41", "-0.414"]
    held = Oscillator(Law({0: parse_real("sqrt(2)", "b")}), stiffness=4, x0="sqrt(2)")
    assert [p.x for p in turning_points(held, 9, digits=3).points] == ["1.41", "-0.707", "0"]


@pytest.mark.parametrize("alpha", [0, 1])
@pytest.mark.parametrize("v0", ["1e-300", "1e-120"])
def test_a_start_that_hardly_moves(alpha, v0):
    found = asy.Oscillator({alpha: "1/10"}, v0=v0)
    table = turning_points(found, 2, digits=12, times=True)
    at_rest = turning_points(asy.Oscillator({alpha: "1/10"}), 2, digits=12)
    assert table.certified and [p.x for p in table.points] == [p.x for p in at_rest.points]


@each("near", ["1.00001", "0.99999", "1.0000001", "0.9999999", "1.00000000000000000001"])
@each("other", [None, "2", "1", "1/2"])
def test_no_formula_is_multiplied_out(near, other):
    """Every closed form near alpha = 1 can be written down, without a number of thousands of digits."""
    found = asy.envelope({near: "1/10"} | ({} if other is None else {other: "1/10"}))
    names = ("formula", "phase_formula", "total_lag", "long_time_formula", "extinction_formula", "time_formula")
    for text in (str(getattr(found, name)) for name in names):
        assert max(map(len, re.findall(r"\d+", text)), default=0) < 200


@pytest.mark.parametrize(("law", "kappa"), [({1: "1/4"}, "0.12"), ({3: "1/10"}, "0.038"), ({"1": "0.123"}, "0.062")])
def test_a_rate_that_is_rational_is_told_at_a_tie(law, kappa):
    """kappa = epsilon/2 or 3 epsilon/8: 0.125 and 0.0375 and 0.0615, which ran out of bits before."""
    assert asy.envelope(law).kappas(digits=2) == (kappa,)


def test_a_rate_beside_a_spring_is_told_at_a_tie():
    assert asy.envelope(Law({(1, 2): 1}, spring={3: 1})).kappas(digits=2) == ("0.12",)


@pytest.mark.parametrize(("spring", "dry"), [({3: 1}, "3/4"), ({2: "3/2", 3: 4}, "2"), ({2: "-1/4"}, "5/12")])
def test_a_stop_in_the_middle_beside_a_spring_is_0(spring, dry):
    """V(1) = eps_0: the mass stops where the spring is at rest."""
    found = turning_points(Law({0: dry}, spring=spring), 3)
    assert [Fraction(p.x) for p in found.points] == [1, 0] and found.ended == {"n": 1, "reason": "sticks"}


@each("seed", range(12))
def test_dry_friction_beside_a_spring_has_the_places_that_were_chosen(seed):
    """eps_0 (a + q) = V(a) - V(q) for rational a, q, on either side of the centre; the next place is irrational."""
    rng = Random(seed)
    c, p = Fraction(rng.randint(1, 8), 4), rng.choice([2, 3, 5])
    a, share = Fraction(rng.randint(8, 16), 8), Fraction(rng.randint(-6, 15), 16)
    q = a * share

    def well(x):
        return x * x / 2 + c * abs(x) ** (p + 1) / (p + 1)

    dry = (well(a) - well(q)) / (a + q)
    law = Law({0: dry}, spring={p: c})
    places = [place for place, _ in rational_stops(law.terms, ExactReal(a))]
    assert places[1] == -q
    assert [Fraction(x.x) for x in turning_points(Oscillator(law, x0=a), 2, digits=40).points] == places[:2]


def test_what_is_no_rational_rate_and_what_sticks_at_once_is_told():
    laws = [{"3/2": 1}, {(1, 1): 1}, {2: 1}, {"sqrt(2)": 1}]
    assert [exact_kappa(Law(law).terms[0]) for law in laws] == [None] * 4
    assert rational_stops(Law({0: "3/8"}, spring={5: "-3/4"}).terms, ExactReal(1)) == ((1, True),)


def test_the_lag_is_finite_above_1_only():
    assert asy.envelope({1: "1/4"}).total_lag is None and asy.envelope({3: "1/4"}).total_lag is not None


STOPS = [
    ({0: 3}, {3: 2}, 2, -1),  # V'(1) = 3 holds it just so
    ({0: "3/4"}, {3: 1}, 1, 0),
    ({0: "10/27"}, {3: 1}, "1/3", None),  # held from the start
]


@pytest.mark.parametrize(("law", "spring", "x0", "stop"), STOPS)
def test_a_stop_beside_a_spring_that_is_a_tie_has_its_time_and_the_motion_rests_there(law, spring, x0, stop):
    """tau = int dx/sqrt(2 (V(x0) - V(x) - eps (x0 - x))), by quadrature; 60 s or 1,100 bits did not do before."""
    dry = Oscillator(Law(law, spring=spring), x0=x0)
    found = turning_points(dry, 3, digits=20, times=True)
    last, late = found.points[-1], reference_motion(dry, 5, 15)
    assert found.ended == {"n": 0 if stop is None else 1, "reason": "sticks"} and found.certified
    assert late.v == "0" and Fraction(late.x) == pytest.approx(Fraction(last.x), rel=1e-14)
    if stop is not None:
        a, eps, (p, c) = float(x0), float(Fraction(str(law[0]))), next(iter(spring.items()))
        angle, weight = (pi / 2 * values for values in leggauss(60))
        x = (a + stop) / 2 + (a - stop) / 2 * sin(angle)
        well = [y * y / 2 + c * abs(y) ** (p + 1) / (p + 1) for y in (a, x)]
        tau = sum(weight * (a - stop) / 2 * cos(angle) / sqrt(2 * (well[0] - well[1] - eps * (a - x))))
        assert Fraction(last.x) == stop and tau == pytest.approx(float(last.t), rel=1e-6)


def test_a_stop_in_si_is_decided_as_without_units():
    """L = 1/4 m, k = 12 N/m: b_0 = 3 k L and c = 2 k/L^2."""
    heavy = Oscillator({0: 9}, mass=3, stiffness=12, x0="-1/2", spring={3: 384})
    found = turning_points(heavy, 3, digits=20, times=True)
    alone = turning_points(Oscillator(Law({0: 3}, spring={3: 2}), x0=2), 3, digits=20, times=True)
    assert found.ended == alone.ended == {"n": 1, "reason": "sticks"}
    assert Fraction(found.points[1].x) == Fraction(1, 4)
    assert abs(2 * mpf(found.points[1].t) - mpf(alone.points[1].t)) < 1e-18
