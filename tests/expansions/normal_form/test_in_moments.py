"""Closed forms in sums of Gamma quotients against the same formulas in SymPy and in a symbolic exponent."""

from fractions import Fraction

import pytest
import sympy
from flint import arb, ctx

from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.half_swings.symbolic import alpha
from asymptotics.expansions.moments import exact, symbolic
from asymptotics.expansions.normal_form import in_moments
from asymptotics.expansions.normal_form.expansion import exact_expansion
from asymptotics.expansions.normal_form.in_moments import closed_forms
from asymptotics.expansions.normal_form.spring_terms import first_order
from asymptotics.expansions.normal_form.symbolic import omega_2, symbolic_expansion
from asymptotics.gauges import GAUGES, TURNING_POINT
from asymptotics.numbers.bridge import closed_form_ball, to_sympy
from asymptotics.numbers.exact import ExactReal
from asymptotics.terms import Term

EXPONENTS = sorted({Fraction(p, q) for q in (1, 2, 3, 4, 7) for p in range(0, 13 * q, max(1, q - 1))})
PENDULUM = Term(1, 0, 3, "position", "pendulum")
SUMS = [
    *[[Term(1, a) for a in alphas] for alphas in (("1", "3/2"), ("1/3", "2/3"), ("0", "1", "5/2"), ("1/2", "1/2"))],
    *[[Term(1, a, m), Term(1, 0, p, "position")] for a in ("1/2", "7/3", "2") for m in (0, 1, 2) for p in (2, 3, 5)],
    [Term(1, "3/2"), Term(1, "4/3", 2), Term(1, 0, 3, "position"), Term(1, "3/2", 2, "position")],
    [Term(1, "3/2"), PENDULUM],
]


def in_sympy(monkeypatch, given, gauge):
    """The same formulas in SymPy's arithmetic."""
    with monkeypatch.context() as patched:
        patched.setattr(in_moments, "moments_of", lambda _: symbolic)
        return closed_forms(given, 4, gauge)


@pytest.mark.parametrize("gauge", GAUGES)
def test_forms_of_one_law_are_those_of_the_symbol_at_the_exponent(gauge, monkeypatch):
    p_3 = symbolic_expansion()["p"][3]
    for a in EXPONENTS:
        found, x = closed_forms([ExactReal(a)], 4, gauge), to_sympy(a)
        wanted = {"p": {(1,): symbolic.moment(x + 1)}, "Omega": {(2,): omega_2(gauge).subs(alpha, x)}}
        if gauge == TURNING_POINT:
            wanted["p"][3,] = p_3.subs(alpha, x)
        compare(found, wanted)
        compare(found, in_sympy(monkeypatch, [ExactReal(a)], gauge))
    assert str(closed_forms([ExactReal(Fraction(3, 2))], 4, gauge)) != str(closed_forms([ExactReal(2)], 4, gauge))


@pytest.mark.parametrize("terms", SUMS, ids=lambda terms: " ".join(t.shape() for t in terms))
def test_forms_of_sums_and_springs_are_those_of_sympy(terms, monkeypatch):
    for gauge in GAUGES:
        compare(closed_forms(terms, 4, gauge), in_sympy(monkeypatch, terms, gauge))
    forces = Forces.of(terms, 4)
    for found, wanted in zip(first_order(forces, exact), first_order(forces, symbolic)):
        compare({"": found}, {"": wanted})


def compare(found, wanted):
    """Expression, text, LaTeX and ball; what is wrong by a millionth of a millionth is seen."""
    assert {name: row.keys() for name, row in found.items()} == {name: row.keys() for name, row in wanted.items()}
    for name, row in found.items():
        for key, form in row.items():
            expression = wanted[name][key]
            assert form.to_sympy() == expression
            assert (str(form), form.latex()) == (str(expression), sympy.latex(expression))
            with ctx.workprec(200):
                assert form.ball().overlaps(closed_form_ball(expression))
                assert not form.ball().overlaps(closed_form_ball(expression) + arb(10) ** -12)


@pytest.mark.parametrize("gauge", GAUGES)
@pytest.mark.parametrize("alphas", [*((n,) for n in range(13)), (0, 1), (1, 2), (0, 3), (1, 2, 3)])
def test_numbers_with_pi_are_written_as_sympy_writes_them(alphas, gauge):
    order = (12 if alphas[0] < 4 else 6) if len(alphas) == 1 else 4
    expansion = exact_expansion(alphas, order, gauge)
    numbers = {n for series in (expansion.p, expansion.Omega, *expansion.half.F, expansion.half.T) for n in of(series)}
    for number in numbers:
        expression = sympy.Add(*(to_sympy(c) * sympy.pi**n for n, c in number.terms.items()))
        assert number.to_sympy() == expression
        assert (str(number), number.closed().latex()) == (str(expression), sympy.latex(expression))
        assert str(-number) != str(number)
    assert len(numbers) > order / 2


def of(series):
    """The coefficients that are numbers of the ring and not 0."""
    return [c for part in series.parts for _, c in part if hasattr(c, "closed") and c != 0]
