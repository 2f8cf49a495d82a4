"""Coefficients as text: exact against certified, closed forms against both, parity, sums, limits."""

import pytest
import sympy
from flint import ctx
from sympy import Float

import asymptotics as asy
from asymptotics.errors import InputError, LimitError
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.half_swings.symbolic import alpha as symbolic_alpha
from asymptotics.expansions.moments.symbolic import moment
from asymptotics.expansions.normal_form.closed_forms import symbolic_coefficients, symbolic_with_spring
from asymptotics.expansions.normal_form.coefficients import (
    _is_quick,
    expansion_coefficients,
    half_swing_coefficients,
)
from asymptotics.expansions.normal_form.digits import certified_digits
from asymptotics.expansions.normal_form.in_moments import closed_forms
from asymptotics.gauges import AVERAGING, NO_FIRST_HARMONIC, TURNING_POINT
from asymptotics.numbers.bridge import closed_form_ball
from asymptotics.numbers.decimals import decimal_of_ball
from asymptotics.numbers.exact import parse_real
from asymptotics.numbers.gamma_sums import GammaSum
from asymptotics.running.budget import budget
from asymptotics.terms import Term

GAUGES = (TURNING_POINT, AVERAGING, NO_FIRST_HARMONIC)
DIGITS = 25


def reals(*texts):
    return [parse_real(t, "--alpha") for t in texts]


@pytest.mark.parametrize("text", ["0", "1", "2", "3", "4", "5", "7"])
def test_exact_and_certified_print_the_same_digits_to_order_12(text):
    # 33 digits: no coefficient of alpha = 3 lies half way between two decimals there
    exact = expansion_coefficients(reals(text), 12, 33)
    balls = certified_digits(reals(text), 12, 33)
    assert exact.arithmetic == "exact"
    for row, name in ((exact.amplitude, "p"), (exact.frequency, "Omega")):
        assert {key: c.value for key, c in row.items()} == {str(k[0]): v for k, v in balls[name].items()}


@pytest.mark.parametrize("gauge", GAUGES)
@pytest.mark.parametrize("text", ["1/2", "3/2", "5/3", "sqrt(2)"])
def test_closed_forms_round_to_the_certified_digits(text, gauge):
    found = expansion_coefficients(reals(text), 4, DIGITS, gauge)
    with ctx.workprec(200):
        for row in (found.amplitude, found.frequency):
            for c in row.values():
                if c.expression is not None:
                    assert decimal_of_ball(closed_form_ball(c.expression), DIGITS) == c.value
                    near_miss = c.expression + sympy.Rational(1, 10**9)
                    assert decimal_of_ball(closed_form_ball(near_miss), DIGITS) != c.value
    assert found.frequency["2"].expression is not None


def test_the_gauges_of_cubic_damping():
    # Other software: averaging (complex) -567/8192 and -27/256; no first harmonic in X: -351/8192 and +9/256.
    found = {g: expansion_coefficients(reals("3"), 3, 10, g, exact_only=True) for g in GAUGES}
    assert [found[g].frequency["2"].exact for g in GAUGES] == ["-45/256", "-27/256", "9/256"]
    assert [found[g].amplitude["3"].exact for g in GAUGES] == ["45/4096", "567/8192", "351/8192"]


def test_linear_and_dry_friction_are_exact():
    linear = expansion_coefficients(reals("1"), 6, 10)
    # U/W = -eps/2 exactly; 1/W = sqrt(1 - eps^2/4) = 1 - eps^2/8 - eps^4/128 - eps^6/1024
    assert [linear.amplitude[k].exact for k in "135"] == ["1/2", "0", "0"]
    assert [linear.frequency[k].exact for k in "246"] == ["-1/8", "-1/128", "-1/1024"]
    dry = half_swing_coefficients(reals("0"), 4, 10)
    # L = log(1 - 2 delta), T = pi, V = (2/pi) delta^2, W = 1
    assert [dry.log_ratio[k].exact for k in "1234"] == ["-2", "-2", "-8/3", "-4"]
    assert {k: c.exact for k, c in dry.duration.items()} == {"0": "pi"}
    assert {k: c.exact for k, c in dry.V[0].items()} == {"2": "2/pi"}


def test_dry_and_linear_friction_together():
    # U = -mu (1 + d0 coth(pi mu/2)) = -mu - (2/pi) d0 (1 + (pi mu)^2/12 - ...), mu = (eps/2) W, 1/W = 1 - eps^2/8:
    # p = -U/W, so p_(1,0) = 2/pi and p_(1,2) = (2/pi)(pi^2/48 - 1/8) = pi/24 - 1/(4 pi).
    found = expansion_coefficients(reals("0", "1"), 3, 15)
    assert found.amplitude["1,0"].exact == "2/pi"
    assert sympy.simplify(found.amplitude["1,2"].expression - sympy.pi / 24 + 1 / (4 * sympy.pi)) == 0
    assert found.frequency["0,2"].exact == "-1/8"
    assert found.frequency["2,0"].exact == found.frequency["1,1"].exact == "0"


def test_sums_with_fractional_exponents_have_their_cross_term():
    # Omega_11 = -2 a b/((a+1)(b+1)) M_(a+b) for a = 1, b = 3/2: -(3/5) M_(5/2)
    found = expansion_coefficients(reals("1", "3/2"), 2, DIGITS)
    expected = sympy.Rational(-3, 5) * moment(sympy.Rational(5, 2))
    with ctx.workprec(200):
        assert found.frequency["1,1"].value == decimal_of_ball(closed_form_ball(expected), DIGITS)
    assert closed_forms(reals("1", "3/2"), 2, AVERAGING)["Omega"] == {}


def test_symbolic_alpha_agrees_with_numbers():
    symbolic = symbolic_coefficients(2, NO_FIRST_HARMONIC, 10)
    at_three = symbolic.frequency["2"].expression.subs(sympy.Symbol("alpha", nonnegative=True), 3)
    assert at_three == sympy.Rational(9, 256)
    fourth = symbolic_coefficients(4, TURNING_POINT, 15)
    assert "I_4" in fourth.integrals
    assert "I_4(alpha)" in fourth.frequency["4"].exact
    assert fourth.amplitude["1"].value is None


@pytest.mark.parametrize(("order", "gauge"), [(5, TURNING_POINT), (3, AVERAGING), (0, TURNING_POINT)])
def test_symbolic_orders_have_an_end(order, gauge):
    with pytest.raises(InputError, match="order"):
        symbolic_coefficients(order, gauge, 10)


def test_refusals():
    with pytest.raises(InputError, match="exact"):
        expansion_coefficients(reals("3/2"), 3, 10, exact_only=True)
    with pytest.raises(InputError, match="gauge"):
        expansion_coefficients(reals("3"), 3, 10, "energy")
    with pytest.raises(LimitError, match="would take about"):
        expansion_coefficients(reals("3/2"), 150, 10, max_seconds=2)
    with pytest.raises(LimitError, match="would take about"):
        expansion_coefficients(reals("2"), 190, 10, exact_only=True)


def test_a_result_shows_itself():
    found = expansion_coefficients(reals("2"), 3, 8)
    assert found.amplitude["1"].to_dict() == {"value": "0.42441318", "exact": "4/(3*pi)"}
    data = half_swing_coefficients(reals("1", "2"), 2, 5).to_dict()
    assert isinstance(data["map"], list)
    assert isinstance(half_swing_coefficients(reals("2"), 2, 5).to_dict()["map"], dict)


@pytest.mark.parametrize("gauge", GAUGES)
def test_integer_laws_in_a_mixed_sum_keep_their_exact_coefficients(gauge):
    # Balls cannot decide zeros (p_3 of linear damping) and ties (3/8 at two digits): the exact sub-sum does.
    mixed = expansion_coefficients(reals("1", "3/2"), 3, 10, gauge)
    linear = expansion_coefficients(reals("1"), 3, 10, gauge)
    for key in ("1", "3"):
        assert mixed.amplitude[f"{key},0"] == linear.amplitude[key]
    assert mixed.frequency["2,0"] == linear.frequency["2"]
    assert expansion_coefficients(reals("3", "1/2"), 1, 2, gauge).amplitude["1,0"].value == "0.38"


@pytest.mark.parametrize("texts", [("3/2", 0, 3), ("1/2", 2, 5), ("sqrt(2)", 1, 2)])
def test_closed_forms_of_a_loss_with_a_spring(texts):
    alpha, m, p = texts
    terms = [Term(1, alpha, m), Term(1, 0, p, "position")]
    found, known = expansion_coefficients(terms, 2, 12), closed_forms(terms, 2, TURNING_POINT)
    for row, name in ((found.amplitude, "p"), (found.frequency, "Omega")):
        for key, form in known[name].items():
            expression = form.to_sympy() if isinstance(form, GammaSum) else form
            assert abs(expression.evalf(20) - Float(row[",".join(map(str, key))].value)) < 1e-11
    assert set(known["p"]) == {(1, 0), (1, 1)}


@pytest.mark.parametrize(("text", "p"), [("3/2", 3), ("1/2", 5), ("2", 2)])
def test_a_symbolic_exponent_beside_a_spring(text, p):
    found = symbolic_with_spring(p, 2)
    numbers = expansion_coefficients([Term(1, text), Term(1, 0, p, "position")], 2, 15)
    for row, other in ((found.amplitude, numbers.amplitude), (found.frequency, numbers.frequency)):
        assert set(row) == set(other)
        for key, c in row.items():
            value = c.expression.subs(symbolic_alpha, sympy.Rational(text)).evalf(20)
            assert abs(value - Float(other[key].value)) < 1e-13
    with pytest.raises(InputError, match="order"):
        symbolic_with_spring(p, 3)


def test_the_half_swing_of_a_mixed_sum_knows_its_integer_part_exactly():
    """(1, 3/2): what involves linear friction alone is L = -pi/2 delta, F = delta exactly; the rest is in balls."""
    found = half_swing_coefficients(reals("1", "3/2"), 2, 12)
    assert found.arithmetic == "certified"
    assert found.log_ratio["1,0"].expression == -sympy.pi / 2
    assert found.log_ratio["0,1"].value == "-1.43776828168"
    assert found.duration["2,0"].expression == sympy.pi / 8
    assert (found.map[0]["1,0"].value, found.map[0]["2,0"].value) == ("1.00000000000", "0")
    assert found.map[1]["0,1"].value == "1.00000000000"
    assert (len(found.map), len(found.V)) == (2, 2)
    assert found.W["2,0"].expression == sympy.Rational(1, 8)


def test_the_exact_engine_leaves_time_for_the_other_one():
    forces = Forces.read((2,), 6)
    with budget(0.03):  # estimates: 0.002 s in the turning-point gauge, 0.04 s in the others
        assert _is_quick(forces, 6, TURNING_POINT)
        assert not _is_quick(forces, 6, AVERAGING)
    assert _is_quick(forces, 6, AVERAGING)


def test_latex_names_every_strength_of_a_sum():
    found = asy.expand(["1", "2"], order=2).latex(5)
    assert r"\delta_{1} \delta_{2}" in found
    assert r"\delta_{2}^{2}" in found
