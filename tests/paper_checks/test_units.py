"""Forms that are right in m = k = x_0 = omega_0 = 1 alone are refuted: two systems of units, drawn once."""

import pytest
import sympy

from paper_checks.lancaster2020.model import numeric
from paper_checks.lelas2024.model import PAPER, C, b, dimensionless, mu
from paper_checks.mutants import mutants
from paper_checks.registry import load
from paper_checks.units import SYSTEMS, UnitsError
from paper_checks.verdict import Outcome

ENTRIES = load()
t, w0, x0, m, k, g = sympy.symbols("t omega_0 x_0 m k g", positive=True)


def tampered(form):
    """The expression with factors that are 1 in the units m = k = x_0 = 1, and with cos(t), sin(t)."""
    yield form * w0**2 * x0**2
    yield form * x0**4
    yield form * k / m
    if form.has(sympy.cos(w0 * t), sympy.sin(w0 * t)):
        yield form.subs(w0 * t, t)


@pytest.mark.parametrize(
    "key",
    [*(f"{PAPER}:{number}" for number in (8, 9, 12, 13, 47, 48, 51, 52)), "lancaster2020:3"],
)  # fmt: skip
def test_a_dimensionally_false_form_is_refuted(key):
    entry = ENTRIES[key]
    expression = entry.printed[0] if isinstance(entry.printed, tuple) else entry.printed
    for false in tampered(expression):
        form = (false, *entry.printed[1:]) if isinstance(entry.printed, tuple) else false
        assert entry.check(form) == Outcome.REFUTED, form


def test_both_curves_of_a_figure_are_tampered_with():
    entry = ENTRIES["lancaster2020:fig3"]
    for false in tampered(entry.printed[0]):
        assert entry.check((false, entry.printed[1])) == Outcome.REFUTED
    for false in tampered(entry.printed[1]):
        assert entry.check((entry.printed[0], false)) == Outcome.REFUTED


def test_the_systems_have_no_unit_in_common():
    for first, second in zip(*SYSTEMS):
        assert len({first, second, 1}) == 3


@pytest.mark.parametrize("law", [b, mu, C])
def test_a_value_in_two_systems(law):
    value = dimensionless(x0 * sympy.cos(w0 * t), law)
    assert abs(value(0.1, 1.0) - sympy.cos(1.0)) < 1e-12
    with pytest.raises(UnitsError, match="depends on the units"):
        dimensionless(x0 * sympy.cos(t), law)(0.1, 1.0)


def test_an_amplitude_in_two_systems():
    with pytest.raises(UnitsError):
        numeric(x0**2, sympy.Integer(1))(0.1, 1.0)
    assert numeric(x0, sympy.Integer(1))(0.1, 1.0) == 1


def test_every_symbol_is_dropped_doubled_and_squared_where_it_stands():
    found = {str(mutant) for _, mutant in mutants(x0 * sympy.cos(w0 * t))}
    for place in ("cos(omega_0*t)", "x_0*cos(t)", "x_0*cos(omega_0)", "x_0**2*cos(omega_0*t)", "x_0*cos(omega_0**2*t)"):
        assert place in found
