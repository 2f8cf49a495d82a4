"""A coefficient handed out: intervals of half a unit, exact forms, and what each refuses."""

from fractions import Fraction

import mpmath
import pytest
import sympy
from flint import arb

from asymptotics.errors import InputError
from asymptotics.numbers.decimal_context import workdps
from asymptotics.numbers.value import Coefficient, coefficient_columns, rounded


@pytest.mark.parametrize(
    ("text", "middle", "half"),
    [
        ("0.125", Fraction(1, 8), Fraction(1, 2000)),
        ("-1.25e-3", Fraction(-5, 4000), Fraction(1, 200000)),
        ("1.2e5", Fraction(120000), Fraction(5000)),
        ("7", Fraction(7), Fraction(1, 2)),
        ("0", Fraction(0), Fraction(0)),
    ],
)
def test_the_interval_is_half_a_unit_to_either_side(text: str, middle: Fraction, half: Fraction):
    precision = mpmath.iv.prec
    found = Coefficient(text, None).interval()
    assert mpmath.iv.prec == precision
    with mpmath.workprec(300):
        for end, exact in ((found.a, middle - half), (found.b, middle + half)):
            error = abs(mpmath.mpf(end) - mpmath.mpf(exact.numerator) / exact.denominator)
            assert error <= mpmath.mpf(2) ** -40 * abs(mpmath.mpf(exact.numerator) / exact.denominator)
        low, high = (Fraction(*map(int, (mpmath.mpf(e).man, 1))) * Fraction(2) ** int(mpmath.mpf(e).exp)
                     * (-1 if mpmath.mpf(e) < 0 else 1) for e in (found.a, found.b))  # fmt: skip
    assert low <= middle - half and middle + half <= high


def test_the_exact_form_and_the_digits():
    third = Coefficient("0.333333", sympy.Rational(1, 3), ("a note",))
    assert third.fraction() == Fraction(1, 3) and third.sympy() == sympy.Rational(1, 3) and third.exact == "1/3"
    assert third == Coefficient("0.333333", sympy.Rational(1, 3)) and third._repr_latex_() == r"$\frac{1}{3}$"
    assert third.to_dict() == {"value": "0.333333", "exact": "1/3"} and str(third) == "0.333333"
    measured = Coefficient("-0.00123456789012345678901", None)
    assert measured.exact is None and measured._repr_latex_() == "$-0.00123456789012345678901$"
    assert str(measured.sympy()) == "-0.00123456789012345678901"
    assert mpmath.nstr(measured.mpf(), 21) == "-0.00123456789012345678901"
    for inexact in (measured, Coefficient(None, sympy.sqrt(2))):
        with pytest.raises(InputError, match="is not rational"):
            inexact.fraction()


def test_a_symbolic_coefficient_has_no_digits():
    alpha = sympy.Symbol("alpha")
    symbolic = Coefficient(None, alpha / 2)
    assert str(symbolic) == "alpha/2" and symbolic.sympy() == alpha / 2
    assert symbolic._repr_latex_() == r"$\frac{\alpha}{2}$ where $\alpha$: exponent of the damping"
    for refused in (symbolic.text, symbolic.mpf, symbolic.interval, symbolic.__float__):
        with pytest.raises(InputError, match="depends on the exponent"):
            refused()


def test_powers_and_sizes_contain_the_truth():
    found = Coefficient("-0.3333", None)
    for n in (0, 1, 2, 3, -1, -2):
        power = found**n
        assert power.a <= mpmath.mpf(-1) ** n / 3**n <= power.b and power.delta <= mpmath.mpf("0.01")
    assert abs(found).a <= mpmath.mpf(1) / 3 <= abs(found).b and abs(found).a > 0
    for base, n in ((found, 0.5), (found, 10**9), (Coefficient("0", None), -1)):
        with pytest.raises(InputError):
            base**n


def test_zero_is_zero_by_theorem_only():
    zeros = [Coefficient("0", None), Coefficient(None, sympy.Integer(0)), Coefficient("0", sympy.Integer(0))]
    others = [Coefficient("0.0", None), Coefficient(None, sympy.Symbol("alpha")), Coefficient("1", sympy.Integer(1))]
    assert [c.is_zero for c in zeros + others] == [True] * 3 + [False] * 3


def test_a_text_is_cut_down_only_when_it_is_longer():
    assert rounded("0.125", 3) == "0.125" and rounded("12345", 3) == "12345" and rounded("123456", 3) == "1.23e5"
    assert rounded("1234.5678", 4) == "1235"
    assert rounded("1.00049999999999999999999999", 4) == "1.000" and rounded("2.00050000000000000000001", 4) == "2.001"


def test_five_thousand_digits_are_handed_out_in_every_form():
    third = Coefficient("0." + 5000 * "3", None)
    width = third.interval().delta
    assert 0 < width < mpmath.mpf("1.01e-5000") and third.ball().contains(arb(1) / 3)
    with workdps(5010):
        assert abs(3 * third.mpf() - 1) < mpmath.mpf("1.01e-5000") and abs(3 * third.sympy() - 1) < sympy.Float(
            "1e-4990"
        )
    assert coefficient_columns([third])["value"] == [1 / 3]


def test_arithmetic_of_coefficients_encloses():
    quarter, third = Coefficient("0.25000", None), Coefficient("0.33333", None)
    q, t = Fraction(1, 4), Fraction(1, 3)
    for found, true in (
        (quarter + third, q + t), (quarter - third, q - t), (quarter * third, q * t), (quarter / third, q / t),
        (1 - third, 1 - t), (2 / third, 2 / t), (-third, -t), (third * "3/2", t * Fraction(3, 2)),
        (third + 0.1, t + q * 2 / 5),
    ):  # fmt: skip
        low, high = (mpmath.mpf(end) for end in found._mpi_)
        with mpmath.workdps(40):
            value = mpmath.mpf(true.numerator) / true.denominator
            assert low < value < high and high - low < 1e-3
            assert not low < value + mpmath.mpf("1e-2") < high  # near miss
    for bad in (lambda: third / 0, lambda: third * 1j, lambda: third + None, lambda: 1 / Coefficient("0", None)):
        with pytest.raises(InputError):
            bad()
