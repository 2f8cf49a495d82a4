"""The two derivations give what the package gives, and a corrupted step stops them."""

from importlib import import_module
from pathlib import Path

import pytest
from sympy import gammasimp, simplify

from asymptotics.multiscale.symbolic import multiple_scales
from asymptotics.multiscale.turning_orders import turning_scales
from asymptotics.normal_form.symbolic import alpha, omega_2

CORRUPTIONS = [
    ("cubic", "right = rest - one_two - two_one", "right = rest - 2 * two_one"),
    ("cubic", "- 3 * V[0] ** 2 * V[1]\n", "- 2 * V[0] ** 2 * V[1]\n"),
    ("cubic", "R(9, 256) * a**4)", "R(27, 256) * a**4)"),
    ("general", "rest = 2 * M - 4 * p * q", "rest = M - 4 * p * q"),
    ("general", "weight = (alpha + beta + 1)", "weight = (alpha + beta + 2)"),
    ("general", "(D_0 * D_1 + D_1 * D_0) * X_1", "2 * D_0 * D_1 * X_1"),
    ("general", "Solution(2 * slope + 2 * p", "Solution(2 * slope - 2 * p"),
    ("general", "drag(V_a + eps * V_b)", "drag(V_a - eps * V_b)"),
    ("general", "chi = p + turn", "chi = p - turn"),
    (
        "springs",
        "fall, turn = (n - alpha) / (n + alpha + 2), -(n - p)",
        "fall, turn = (n - alpha) / (n + alpha + 2), (n - p)",
    ),
    ("turning", "+ alpha * (a * s) ** (alpha - 1) * V_1\n", "- alpha * (a * s) ** (alpha - 1) * V_1\n"),
    ("turning", "f_1 = -p * a**alpha", "f_1 = p * a**alpha"),
    ("springs", "+ (alpha + 1) * S * unit", "+ (alpha - 1) * S * unit"),
    ("springs", "observed = closed + P", "observed = closed - P"),
]


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


@pytest.mark.parametrize(("name", "right", "wrong"), CORRUPTIONS)
def test_a_corrupted_step_raises(name, right, wrong):
    module = derivation(name)
    source = Path(module.__file__).read_text(encoding="utf-8")
    assert source.count(right) == 1
    with pytest.raises(AssertionError, match="step"):
        exec(compile(source.replace(right, wrong), module.__file__, "exec"), {"__name__": "corrupted"})
