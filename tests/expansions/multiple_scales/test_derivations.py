"""The derivations of the hierarchy give what the package gives."""

from importlib import import_module

import pytest
from sympy import gammasimp, simplify

from asymptotics.expansions.multiple_scales.symbolic import multiple_scales
from asymptotics.expansions.multiple_scales.turning_orders import turning_scales
from asymptotics.expansions.normal_form.symbolic import alpha, omega_2


def derivation(name):
    """Imported when it is needed: a derivation computes on import, and every worker collects this file."""
    return import_module(f"derivations.multiple_scales_{name}")


def test_third_order_of_the_package():
    cubic, package = derivation("cubic"), multiple_scales((3,), 3)
    assert [simplify(x - y) for x, y in zip(cubic.rates[3], package.rates[3])] == [0, 0]
    assert [simplify(x - order.solution.rhs) for x, order in zip(cubic.X, package.orders)] == [0, 0, 0, 0]


def test_second_order_of_the_engine():
    general = derivation("general")
    found = general.Omega_2.subs(general.alpha, alpha)
    assert simplify(gammasimp(found - omega_2("no-first-harmonic"))) == 0


@pytest.mark.slow
def test_air_to_fourth_order_is_the_packages():
    air, package = derivation("quadratic"), turning_scales((2,), 4)
    assert [simplify(x - y) for n in range(1, 5) for x, y in zip(air.rates[n], package.rates[n])] == [0] * 8
    assert [simplify(x - order.solution.rhs) for x, order in zip(air.X, package.orders)] == [0] * 5
