from fractions import Fraction

import pytest
from flint import arb, fmpq

from asymptotics.errors import InputError
from asymptotics.law import Law, Oscillator


def test_equal_exponents_are_merged_and_the_law_says_so():
    law = Law.of([("1/10", "2"), ("sqrt(2)", "1"), ("0.2", "4/2"), ("sqrt(2)", "1")])
    assert [(str(t.b), str(t.alpha)) for t in law.terms] == [("3/10", "2"), ("2*sqrt(2)", "1")]
    assert law.notes == ("equal exponents merged: alpha = 2", "equal exponents merged: alpha = 1")
    assert Law.of([("1", "2"), ("1", "3")]).notes == ()


@pytest.mark.parametrize(
    ("pairs", "argument"),
    [
        ([], "law"),
        ([("1", "-1")], "alpha"),
        ([("1", "-sqrt(2)")], "alpha"),
        ([("1", 1.5)], "alpha"),
        ([(0.1, "2")], "b"),
        ([("1", "nan")], "alpha"),
        ([("1", "inf")], "alpha"),
        ([("1", "1j")], "alpha"),
        ([("1", True)], "alpha"),
        ([("1", "2"), ("sqrt(2)", "2")], "b"),
    ],
)
def test_bad_laws_are_refused_by_name(pairs, argument):
    with pytest.raises(InputError) as caught:
        Law.of(pairs)
    assert caught.value.argument == argument


def test_negative_strength_is_formal_only():
    law = Law.of([("-1/10", "2"), ("1", "0")])
    assert not law.is_dissipative
    with pytest.raises(InputError, match="-1/10 is negative"):
        law.require_dissipative("sequence of turning points")
    Law.of([("0", "2")]).require_dissipative("anything")


def test_units_against_hand_values():
    # m = 1/2, k = 8: omega_0 = 4. b = 3, alpha = 2, x0 = -1/6: epsilon = 3*16*(1/6)/8 = 1; delta(1/2) = 1/2.
    oscillator = Oscillator.of(Law.of([("3", "2")]), mass="1/2", stiffness="8", x0="-1/6")
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
        (kappa,) = Oscillator.of(Law.of([("1/3", alpha)])).kappas()
        assert kappa.overlaps(2 * arb(2) ** a * beta / (3 * arb.pi()))
        assert not kappa.overlaps(arb(2) ** a * beta / (3 * arb.pi()))


def test_start_with_velocity_uses_the_radius():
    oscillator = Oscillator.of(Law.of([("1", "0")]), mass=4, stiffness=1, x0=3, v0=2)  # v0/omega_0 = 4
    assert oscillator.length().overlaps(arb(5))


@pytest.mark.parametrize("bad", [{"mass": 0}, {"stiffness": "-1"}, {"x0": 0}, {"mass": 1.0}])
def test_bad_oscillators_are_refused(bad):
    with pytest.raises(InputError) as caught:
        Oscillator.of(Law.of([("1", "1")]), **bad)
    assert caught.value.argument == next(iter(bad))


def test_printing_and_json():
    law = Law.of([("1/2", "0"), ("2", "1"), ("1", "3/2"), ("-1", "3")])
    assert str(law) == "1/2 sign(x') + 2 x' + 1 x'|x'|^(3/2 - 1) + -1 x'^3"
    assert law.to_dict()["terms"][2] == {"b": "1", "alpha": "3/2"}
    assert r"\operatorname{sgn}" in law._repr_latex_()
    assert r"\ddot x" in Oscillator.of(law)._repr_latex_()
    assert law.integer_alphas is None and Law.of([("1", "2")]).integer_alphas == (2,)
    assert Oscillator.of(law).to_dict()["mass"] == "1"
