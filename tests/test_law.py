from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import sympy
from flint import arb, ctx, fmpq

from asymptotics.errors import InputError
from asymptotics.law import Law, Oscillator
from asymptotics.terms import Term
from tests.each import each


def test_equal_exponents_are_merged_and_the_law_says_so():
    law = Law({"2": "1/10", "1": "sqrt(2)", "4/2": "0.2", "2/2": "sqrt(8)"})
    assert [(str(t.strength), str(t.velocity)) for t in law.terms] == [("3/10", "2"), ("3*sqrt(2)", "1")]
    assert law.notes == ("equal exponents merged: alpha = 2", "equal exponents merged: alpha = 1")
    assert Law({"2": "1", "3": "1"}).notes == ()


BAD = [float("nan"), float("inf"), True, 1j, None, "x", [], "nan", "1j", Decimal("NaN"), Decimal("1e9999"), sympy.pi,
       sympy.nan, sympy.oo, sympy.Float("0.5"), sympy.Symbol("a"), "__import__('os')"]  # fmt: skip


@each("bad", BAD)
def test_what_is_not_an_exact_number_is_refused_by_name(bad):
    for argument, make in (("alpha", lambda: Law.from_terms([Term(1, bad)])), ("strength", lambda: Law({2: bad}))):
        with pytest.raises(InputError) as caught:
            make()
        assert caught.value.argument == argument
    with pytest.raises(InputError, match="mass"):
        Oscillator({2: 1}, mass=bad)


@each(
    ("mapping", "spring", "argument"),
    [
        ({}, None, "law"),
        ([("1", "2")], None, "law"),
        (None, None, "law"),
        ({"-1": "1"}, None, "alpha"),
        ({"-sqrt(2)": "1"}, None, "alpha"),
        ({(1, "1/2"): 1}, None, "position"),
        ({(1, -2): 1}, None, "position"),
        ({"2": "1", "4/2": "sqrt(2) "}, None, "strength"),
        ({"2": "sqrt(3)", "4/2": "sqrt(2)"}, None, "strength"),
        ({2: 1}, {"1/2": 1}, "spring"),
        ({2: 1}, {0: 1}, "spring"),
        ({2: 1}, {(3, -1): 1}, "spring"),
        ({2: 1}, {3: None}, "strength"),
        ({2: 1}, "clock", "spring"),
        ({2: 1}, 3, "spring"),
    ],
)
def test_bad_laws_are_refused_by_name(mapping, spring, argument):
    if mapping == {"2": "1", "4/2": "sqrt(2) "}:  # 1 + sqrt(2) is one exact number
        assert str(Law(mapping).terms[0].strength) == "sqrt(2) + 1"
        return
    with pytest.raises(InputError) as caught:
        Law(mapping, spring=spring)
    assert caught.value.argument == argument


@pytest.mark.parametrize("alpha", ["3/2", Fraction(3, 2), Decimal("1.5"), 1.5, np.float32(1.5), sympy.Rational(3, 2)])
def test_every_kind_of_number_makes_the_same_law(alpha):
    law = Law({alpha: np.int64(2)}, spring={3: sympy.sqrt(2)})
    assert law.terms == Law({"3/2": "2"}, spring={3: "sqrt(2)"}).terms
    assert law.notes == (("alpha: the float 1.5 was read as 3/2",) if isinstance(alpha, float | np.floating) else ())


def test_strengths_in_si_and_epsilons_are_different_things():
    oscillator = Oscillator(Law({"3/2": "1/10"}), mass="3/2", stiffness=30, x0="1/5")
    with pytest.raises(InputError, match="epsilon is meant"):
        Law.read(oscillator.law)
    assert Law.read(oscillator.dimensionless) is not None
    with pytest.raises(InputError, match="another oscillator"):
        Oscillator(oscillator.dimensionless)
    assert Law({2: 1}) != Oscillator({2: 1}).law


def test_a_dimensionless_strength_is_exact_where_it_can_be():
    # epsilon = b omega_0^alpha x0^(alpha-1)/k
    exact = Oscillator({2: 3, 1: "1/2"}, mass="1/2", stiffness=8, x0="-1/6").dimensionless
    assert [str(t.strength) for t in exact.terms] == ["1", "1/4"]
    (term,) = Oscillator({"3/2": "1/10"}, mass="3/2", stiffness=30, x0="1/5").dimensionless.terms
    with ctx.workprec(300):
        truth = arb(fmpq(1, 10)) * arb(20) ** fmpq(3, 4) / arb(5).sqrt() / 30
    with ctx.workprec(60):  # the ball at low precision holds the value at high precision, and is narrow
        assert term.strength.ball().contains(truth) and term.strength.ball().rad() < 1e-15
        assert not (term.strength.ball() * (1 + arb(2) ** -40)).contains(truth)
    assert term.strength.sign == 1 and not term.strength.is_zero
    assert str(term.strength) == "(1/10)*20**(3/4)*(1/5)**(1/2)/30"


def test_springs_scale_by_their_degree():
    # X = x/x0: c x^3 -> c x0^2/k X^3; c x v^2 -> c omega_0^2 x0^2/k X V^2; a pendulum counts x0^2
    osc = Oscillator({1: 1}, stiffness=4, x0=3, spring={3: 2, (1, 2): 1})
    assert [str(t.strength) for t in osc.dimensionless.springs] == ["9/2", "9"]
    pendulum = Oscillator({2: "1/10"}, stiffness=7, x0="1/2", spring="pendulum").dimensionless
    assert str(pendulum.springs[0].strength) == "1/4" and str(pendulum.springs[0].weight) == "2"
    assert [t.sign for t in pendulum.terms] == [-1, 1]
    assert "7 x + 1/10 x'|x'| + 7 (sin x - x)" in str(Oscillator({2: "1/10"}, stiffness=7, spring="pendulum"))
    with pytest.raises(InputError, match="sin x - x"):
        _ = pendulum.alphas
    position = Law({(1, 2): -1, 1: 1})
    assert [str(t.degree) for t in position.terms] == ["3", "1"]
    with pytest.raises(InputError, match="x\\^2 x'"):
        _ = position.alphas


def test_negative_strength_is_formal_only():
    law = Law({"2": "-1/10", "0": "1"})
    assert not law.is_dissipative
    with pytest.raises(InputError, match="-1/10 is negative"):
        law.require_dissipative("sequence of turning points")
    Law({"2": "0"}).require_dissipative("anything")


def test_units_against_hand_values():
    # m = 1/2, k = 8: omega_0 = 4. b = 3, alpha = 2, x0 = -1/6: epsilon = 3*16*(1/6)/8 = 1; delta(1/2) = 1/2.
    oscillator = Oscillator(Law({"2": "3"}), mass="1/2", stiffness="8", x0="-1/6")
    (epsilon,), (delta,) = oscillator.epsilons(), oscillator.deltas(arb(fmpq(1, 2)))
    with pytest.raises(InputError, match="amplitude"):
        oscillator.deltas(arb(0))
    assert epsilon.overlaps(arb(1)) and delta.overlaps(arb(fmpq(1, 2))) and epsilon.rad() < 1e-12
    assert oscillator.kappas()[0].overlaps(4 / (3 * arb.pi()))
    x, t = oscillator.to_si(arb(1), arb(2))
    assert x.overlaps(arb(fmpq(1, 6))) and t.overlaps(arb(fmpq(1, 2)))


def test_kappa_is_lancasters_beta_form():
    # kappa = 2 b (2 omega_0)^alpha B(alpha/2+1, alpha/2+1)/(pi k x0^(1-alpha)), here with m = k = x0 = 1
    for alpha in (Fraction(0), Fraction(3, 2), Fraction(5)):
        a = arb(fmpq(alpha.numerator, alpha.denominator))
        beta = (a / 2 + 1).gamma() ** 2 / (a + 2).gamma()
        (kappa,) = Oscillator(Law({alpha: "1/3"})).kappas()
        assert kappa.overlaps(2 * arb(2) ** a * beta / (3 * arb.pi()))
        assert not kappa.overlaps(arb(2) ** a * beta / (3 * arb.pi()))


def test_start_with_velocity_uses_the_radius():
    oscillator = Oscillator(Law({"0": "1"}), mass=4, stiffness=1, x0=3, v0=2)  # v0/omega_0 = 4
    assert oscillator.length().overlaps(arb(5))


@pytest.mark.parametrize("bad", [{"mass": 0}, {"stiffness": "-1"}, {"x0": 0}, {"v0": "x"}, {"mass": "1/0"}])
def test_bad_oscillators_are_refused(bad):
    with pytest.raises(InputError) as caught:
        Oscillator(Law({"1": "1"}), **bad)
    assert caught.value.argument == next(iter(bad))


def test_printing_and_json():
    law = Law({"0": "1/2", "1": "2", "3/2": "1", "3": "-1"})
    assert str(law) == "1/2 sign(x') + 2 x' + x'|x'|^(1/2) - x'^3"
    assert law.to_dict()["terms"][2] == {
        "kind": "loss", "velocity": "3/2", "position": 0, "strength": "1", "weight": "1/2",
    }  # fmt: skip
    assert r"\operatorname{sgn}" in law._repr_latex_()
    assert Oscillator({2: "-1/6"}, stiffness=4)._formula() == r"\ddot x + 4\,x - \frac{1}{6}\,\dot x|\dot x| = 0"
    assert str(Law({(1, 2): 1, ("1/2", 1): 2}, spring={3: -1, 2: 1, (1, 2): 1, (3, "1/2"): 1})) == (
        "x^2 x' + 2 |x| x'|x'|^(-1/2) - x^3 + x|x| + x x'^2 + x^3 |x'|^(1/2)"
    )
    assert r"x|x|" in Law({(1, 1): 1}, spring={2: 1})._repr_latex_()
    assert law.integer_alphas is None and Law({"2": "1"}).integer_alphas == (2,)
    assert Oscillator(law).to_dict()["mass"] == "1"
