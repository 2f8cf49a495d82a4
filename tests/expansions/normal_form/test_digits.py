"""Certified decimals: closed forms at random exponents, exact cases, zeros by theorem, two routes to every series."""

from fractions import Fraction
from itertools import combinations_with_replacement

import pytest
from flint import arb, ctx, fmpq

from asymptotics.errors import InputError, UndecidedError
from asymptotics.expansions.half_swings import certified_zeros
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.certified_zeros import certified_half_swing, without
from asymptotics.expansions.half_swings.quarter import half_swing
from asymptotics.expansions.normal_form.digits import certified_digits, expansions
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.series import Series

TINY = 2.0**-100


def exponents(*texts: str) -> list[ExactReal]:
    return [parse_real(t, "--alpha") for t in texts]


def moment(p: arb) -> arb:
    """M_p = Γ((p+1)/2)/(√π Γ(p/2+1)) (theory page ``closed_forms``)."""
    return ((p + 1) / 2).gamma() / (arb.pi().sqrt() * (p / 2 + 1).gamma())


def agree(a: object, b: object) -> bool:
    difference = arb(a) - arb(b)
    return bool(difference.contains(0) and difference.rad() < TINY)


@pytest.mark.parametrize("text", ["1/2", "3/4", "13/7", "5/3", "sqrt(2)", "2", "19/5", "7", "0", "1"])
def test_closed_forms_for_one_law(text: str) -> None:
    """Theory page ``closed_forms``: U_1, U_3 and W_2 in moments; at α = 2, W_2 = (2/3)² M_4 = 1/6."""
    with ctx.workprec(160):
        a, s = exponents(text)[0].ball(), expansions(exponents(text), 4)
        assert agree(s["U"][1], -moment(a + 1))
        third = -a * (3 * a + 1) / (6 * (a + 1) ** 2) * moment(3 * a + 1)
        assert agree(s["U"][3], third)
        assert agree(s["W"][2], (a / (a + 1)) ** 2 * moment(2 * a))
        assert third == 0 or not agree(s["U"][3], third * (1 + arb(10) ** -20))  # near miss
        assert agree(s["p"][1], moment(a + 1)) and agree(s["Omega"][2], -s["W"][2])
        assert text != "2" or agree(s["W"][2], arb(fmpq(1, 6)))


def test_second_order_for_two_laws() -> None:
    """W = 1 + Σ_ij α_i α_j/((α_i+1)(α_j+1)) M_(α_i+α_j) δ_i δ_j (derivation ``second-order-sums``)."""
    for texts in combinations_with_replacement(["1/2", "1", "5/3", "sqrt(2)"], 2):
        if texts[0] != texts[1]:
            with ctx.workprec(160):
                a, b = (e.ball() for e in exponents(*texts))
                W = expansions(exponents(*texts), 2)["W"]
                assert agree(W[1, 1], 2 * a * b / ((a + 1) * (b + 1)) * moment(a + b))


def test_dry_and_linear_friction_together() -> None:
    """U = −μ(1 + δ_0 coth(πμ/2)), W = 1/√(1−ε²/4), μ = (ε/2) W; with x = πμ/2, x coth x = Σ B_2k (2x)^2k/(2k)!."""
    order = 7
    with ctx.workprec(160):
        s = expansions(exponents("0", "1"), order)
        root = {(0, 0): arb(1)}
        for k in range(1, order // 2 + 1):
            root[(0, 2 * k)] = root[(0, 2 * k - 2)] * (2 * k - 1) / (8 * k)
        W = Series(root, 2, order)
        mu = Series({(0, k + 1): c / 2 for (_, k), c in root.items()}, 2, order)
        square = mu * mu * arb.pi() ** 2
        coth, power, factorial = Series.constant(arb(1), 2, order), Series.constant(arb(1), 2, order), 1
        for k, bernoulli in enumerate([fmpq(1, 6), fmpq(-1, 30), fmpq(1, 42)], 1):
            power, factorial = power * square, factorial * (2 * k - 1) * (2 * k)
            coth = coth + power * (arb(bernoulli) / factorial)
        U = -mu - (coth * (2 / arb.pi())).shift(0).truncate(order)
        for n in {*s["U"].coefficients, *U.coefficients, *s["W"].coefficients, *W.coefficients}:
            assert agree(s["U"][n], U[n]) and agree(s["W"][n], W[n])


@pytest.mark.parametrize("texts", [("0", "3/2"), ("1", "0"), ("2", "0", "sqrt(2)"), ("0",), ("1/2", "5/2")])
def test_theorems_against_the_direct_series(texts: tuple[str, ...]) -> None:
    """The shifted centre gives what the series of the whole law gives; what it omits is a ball around zero there."""
    with ctx.workprec(160):
        direct = half_swing(quarter_swing(exponents(*texts), 5))
        theorem = certified_half_swing(exponents(*texts), 5)
        pairs = [(direct.L, theorem.L), (direct.T, theorem.T), *zip(direct.F, theorem.F, strict=True)]
        for a, b in pairs:
            for n in {*a.coefficients, *b.coefficients}:
                assert agree(a[n], b[n]), (texts, n)


@pytest.mark.parametrize("texts", [("5/3",), ("7",), ("0",), ("1/2", "5/2"), ("0", "3")])
def test_flow_reproduces_the_half_swing(texts: tuple[str, ...]) -> None:
    """L = Σ π^(k+1)/(k+1)! V^k U and T likewise from W: the time-π flow of V is F, an independent way back."""
    order = 7 if len(texts) == 1 else 5
    with ctx.workprec(160):
        half, s = certified_half_swing(exponents(*texts), order), expansions(exponents(*texts), order)
        for generator, expected in ((s["U"], half.L), (s["W"], half.T)):
            total, term = Series({}, len(texts), order), generator
            for k in range(order + 1):
                term = (
                    term * (arb.pi() / (k + 1))
                    if k == 0
                    else half.grading.weighted(term) * s["U"] * (arb.pi() / (k + 1))
                )
                total = total + term
            for n in {*total.coefficients, *expected.coefficients}:
                assert agree(total[n], expected[n]), (texts, n)


@pytest.mark.parametrize(
    ("texts", "name", "zeros"),
    [
        (("0",), "W", [(1,), (2,), (6,)]),
        (("0",), "U", [(2,), (3,), (5,)]),
        (("1",), "L", [(2,), (4,)]),
        (("1",), "p", [(3,), (5,)]),
        (("1",), "F_0", [(2,), (6,)]),
        (("5/3",), "T", [(1,)]),
        (("0", "2"), "U", [(4, 1)]),
        (("0", "3"), "W", [(1, 3)]),
        (("0", "5/2"), "W", [(4, 2)]),
        (("1/2", "3/2"), "L", [(1, 1), (2, 2)]),
        (("1/2", "5/2"), "L", [(3, 1)]),
        (("1/2", "5/2"), "F_0", [(2, 1)]),
    ],
)
def test_zeros_by_theorem_are_zero(texts: tuple[str, ...], name: str, zeros: list[tuple[int, ...]]) -> None:
    row = certified_digits(exponents(*texts), 6, 11)[name]
    assert [row[n] for n in zeros] == ["0"] * len(zeros)
    assert any(text != "0" for text in row.values())


def test_a_zero_that_is_none_is_refused() -> None:
    """The rules are checked against the balls: a wrong rule cannot drop a coefficient."""
    with pytest.raises(ArithmeticError, match="not zero"):
        without(Series({(1,): arb(1)}, 1, 1), lambda n: True)


def test_decimals_are_prefixes_and_known() -> None:
    """30 digits are the rounding of 50; M_(5/2) and the Coulomb values −2^n/n are known in closed form."""
    short, long = (certified_digits(exponents("3/2"), 8, digits) for digits in (30, 50))
    for name, row in short.items():
        for n, text in row.items():
            assert abs(Fraction(text) - Fraction(long[name][n])) <= abs(Fraction(text)) * Fraction(1, 10**29)
    assert certified_digits(exponents("0"), 4, 6)["L"] == {
        (1,): "-2.00000",
        (2,): "-2.00000",
        (3,): "-2.66667",
        (4,): "-4.00000",
    }


def test_an_exact_tie_is_undecided_and_named() -> None:
    """α = 3: U_3 = −(3·10/(6·16)) M_10 = −(5/16)(63/256) = −315/4096 = −0.076904296875 ends in 5 at the 11th digit."""
    with pytest.raises(UndecidedError, match=r"U\(3,\)"):
        certified_digits(exponents("3"), 3, 10)
    assert certified_digits(exponents("3"), 3, 11)["U"][3,] == "-0.076904296875"


def test_equal_exponents_are_refused() -> None:
    with pytest.raises(InputError, match="equal exponents"):
        certified_zeros.certified_half_swing(exponents("2", "4/2"), 3)


@pytest.mark.slow
@pytest.mark.parametrize("text", ["2", "3/2", "sqrt(2)", "7"])
def test_order_forty_at_forty_digits(text: str) -> None:
    digits = certified_digits(exponents(text), 40, 40)
    assert len(digits["p"]) == 20 and all(value != "0" for value in digits["p"].values())
